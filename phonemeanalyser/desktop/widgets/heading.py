"""What stands above a part of the page of the head."""

from PySide6.QtWidgets import QLabel


def heading(text: str) -> QLabel:
    """Make a heading."""
    label = QLabel(f"<b>{text}</b>")
    label.setContentsMargins(0, 0, 0, 0)
    return label
