"""The types of what ``__init__.py`` imports late."""

from phonemeanalyser.desktop.calibrate.dialogs import CalibrationDialogs as CalibrationDialogs
from phonemeanalyser.desktop.calibrate.model import CalibrationModel as CalibrationModel
from phonemeanalyser.desktop.calibrate.page import CalibrationPage as CalibrationPage
