"""What the window needs of this page, and the module of each."""

from .dialogs import CalibrationDialogs as CalibrationDialogs
from .model import CalibrationModel as CalibrationModel
from .page import CalibrationPage as CalibrationPage
