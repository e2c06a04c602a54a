"""The field for a number that all views use."""

from PySide6.QtCore import QLocale
from PySide6.QtGui import QValidator
from PySide6.QtWidgets import QDoubleSpinBox
from typing_extensions import override

from phonemeanalyser.desktop.widgets.key_filters import NumberFieldKeys


class NumberField(QDoubleSpinBox):
    """Shows a decimal point, and takes a comma for one; keys that write no number stay the window's.

    Parameters
    ----------
    low, high : the range.
    decimals : digits behind the point.
    step : how far an arrow key goes.
    unit : what stands behind the number.
    waits : tell a number once it is typed, and not with each digit.
    """

    def __init__(
        self,
        low: float = 0.0,
        high: float = 99.99,
        *,
        decimals: int = 0,
        step: float = 1.0,
        unit: str = "",
        waits: bool = False,
    ) -> None:
        super().__init__()
        self.setLocale(QLocale.c())
        self.setDecimals(decimals)
        self.setRange(low, high)
        self.setSingleStep(step)
        self.setSuffix(unit)
        self.setKeyboardTracking(not waits)
        self.installEventFilter(NumberFieldKeys(self))

    @override
    def validate(self, text: str, place: int) -> tuple[QValidator.State, str, int]:
        """Judge what was typed, with a point for a comma; gives state, text and place of the cursor."""
        return super().validate(text.replace(",", "."), place)
