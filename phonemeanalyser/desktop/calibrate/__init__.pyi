"""What the window needs of this page, and the module of each."""

from .model import CalibrationModel as CalibrationModel
from .page import CalibrationDialogs as CalibrationDialogs
from .page import CalibrationPage as CalibrationPage
