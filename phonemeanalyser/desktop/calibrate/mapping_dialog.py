"""Asks which of our phonemes the unknown names in label files stand for."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QGridLayout,
    QLabel,
    QScrollArea,
    QVBoxLayout,
    QWidget,
)

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.widgets.wheel import leave_wheel
from phonemeengine.phonemes import Phoneme


class MappingDialog(QDialog):
    """A row for each name; what is left at "unidentified" counts for no figure."""

    def __init__(self, counts: dict[str, int], parent: QWidget) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Names in the labels"))
        self.boxes: dict[str, QComboBox] = {}
        intro = QLabel(
            tr(
                "These names stand for no sound that is known here. Say what each one is; what stays unidentified "
                "counts neither as right nor as wrong."
            )
        )
        intro.setWordWrap(True)
        body = QWidget()
        grid = QGridLayout(body)
        for row, (name, count) in enumerate(sorted(counts.items(), key=lambda entry: -entry[1])):
            label = QLabel(f"{name}")
            label.setTextFormat(Qt.TextFormat.PlainText)
            self.boxes[name] = box = QComboBox()
            for phoneme in Phoneme:
                box.addItem(phoneme.label, phoneme)
            box.setCurrentIndex(box.findData(Phoneme.UNIDENTIFIED))
            box.setAccessibleName(tr("sound of {name}").format(name=name))
            for column, widget in enumerate((label, QLabel(f"{count} ×"), box)):
                grid.addWidget(widget, row, column)
        grid.setRowStretch(len(counts), 1)
        leave_wheel(body)
        scroll = QScrollArea()
        scroll.setWidget(body)
        scroll.setWidgetResizable(True)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Ok | QDialogButtonBox.StandardButton.Cancel)
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        column_of_all = QVBoxLayout(self)
        for part in (intro, scroll, buttons):
            column_of_all.addWidget(part)
        self.resize(380, 420)

    def mapping(self) -> dict[str, Phoneme]:
        """Return what each name stands for."""
        return {name: Phoneme(box.currentData()) for name, box in self.boxes.items()}
