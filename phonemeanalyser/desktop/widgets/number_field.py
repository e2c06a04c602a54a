"""The field for a number that all views use."""

from PySide6.QtGui import QValidator
from PySide6.QtWidgets import QDoubleSpinBox


class NumberField(QDoubleSpinBox):
    """Shows a decimal point, and takes a comma for one; whole numbers, unless decimals are asked for."""

    def __init__(self) -> None:
        super().__init__()
        self.setDecimals(0)

    def validate(self, text: str, place: int) -> tuple[QValidator.State, str, int]:
        """Judge what was typed, with a point for a comma; gives state, text and place of the cursor."""
        return super().validate(text.replace(",", "."), place)
