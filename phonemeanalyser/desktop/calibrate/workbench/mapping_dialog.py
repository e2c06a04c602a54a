"""Asks which of our phonemes the unknown names in label files stand for."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QComboBox, QDialog, QGridLayout, QScrollArea, QWidget

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.widgets.builders import CANCEL, OK, choice, column, dialog_buttons, label
from phonemeanalyser.desktop.widgets.wheel import leave_wheel
from phonemeengine.phonemes import Phoneme


class MappingDialog(QDialog):
    """A row for each name; what is left at "unidentified" counts for no figure."""

    def __init__(self, counts: dict[str, int], parent: QWidget) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Names in the labels"))
        self.boxes: dict[str, QComboBox] = {}
        intro = label(
            tr(
                "These names stand for no sound that is known here. Say what each one is; what stays unidentified "
                "counts neither as right nor as wrong."
            ),
            wraps=True,
        )
        body = QWidget()
        grid = QGridLayout(body)
        phonemes = [(phoneme.label, phoneme) for phoneme in Phoneme]
        for row, (name, count) in enumerate(sorted(counts.items(), key=lambda entry: -entry[1])):
            words = label(name)
            words.setTextFormat(Qt.TextFormat.PlainText)
            self.boxes[name] = box = choice(phonemes, tr("sound of {name}").format(name=name))
            box.setCurrentIndex(box.findData(Phoneme.UNIDENTIFIED))
            for k, widget in enumerate((words, label(f"{count} ×"), box)):
                grid.addWidget(widget, row, k)
        grid.setRowStretch(len(counts), 1)
        leave_wheel(body)
        scroll = QScrollArea()
        scroll.setWidget(body)
        scroll.setWidgetResizable(True)
        column(intro, scroll, dialog_buttons(self, OK, CANCEL), on=self, margins=None)
        self.resize(380, 420)

    def mapping(self) -> dict[str, Phoneme]:
        """Return what each name stands for."""
        return {name: Phoneme(box.currentData()) for name, box in self.boxes.items()}
