"""What the program is, in a few words."""

from PySide6.QtWidgets import QMessageBox, QWidget


def show_about(window: QWidget) -> None:
    """Say what this is."""
    QMessageBox.about(
        window, "PhonemeAnalyser",
        "<b>PhonemeAnalyser</b><p>Calibrates real-time phoneme recognition for lip sync, and shows why a phoneme "
        "was recognised.<p>MIT licence. The demo is a synthetic voice of the Festival project (CMU slt). "
        "The head is in the public domain (CC0).",
    )  # fmt: skip
