"""What the program is, in a few words, and how well it does."""

from html import escape

from PySide6.QtWidgets import QMessageBox, QWidget


def show_about(window: QWidget, figures: str) -> None:
    """Show what this is; `figures` are the notes of the preset with which it begins, measured figures among them."""
    QMessageBox.about(
        window, "PhonemeAnalyser",
        "<b>PhonemeAnalyser</b><p>Calibrates real-time phoneme recognition for lip sync, and shows why a phoneme "
        "was recognised.<p>MIT licence. The demo is a synthetic voice of the Festival project (CMU slt). "
        "The head is in the public domain (CC0).<p><b>The preset Learned.</b> "
        + escape(figures.strip()).replace("\n", " "),
    )  # fmt: skip
