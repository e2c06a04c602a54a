"""Which shapes of a face stand for which of ours: a line for each, with a slider that shows it on the face."""

from collections.abc import Sequence
from functools import partial

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QCloseEvent
from PySide6.QtWidgets import QComboBox, QDialog, QDialogButtonBox, QSlider, QTableWidget, QTableWidgetItem, QWidget
from typing_extensions import override

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.talk.head.face_model import FaceModel
from phonemeanalyser.desktop.widgets import builders
from phonemeengine.mouth.face_mapping import ENOUGH, FaceMapping, guess_mapping

SIZE = 480, 560
"""Of the dialog at first, pixels."""
ROW = 28
COLUMNS = tr_noop("Blend shape"), tr_noop("In this face"), tr_noop("Try")
WIDTHS = 150, 0, 110
NONE = "–"
BASES = {"arkit": "ARKit", "oculus": "Oculus", "vrm": "VRM"}


class ShapeBox(QComboBox):
    """Chooses a shape of the face; lists them when it is opened, since there may be a thousand.

    Signals
    -------
    shape_chosen : the name of a shape; empty for none.
    """

    shape_chosen = Signal(str)

    def __init__(self, names: Sequence[str]) -> None:
        super().__init__()
        self._names = names
        self.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.setMinimumContentsLength(8)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.activated.connect(self._choose)

    def show_shapes(self, shapes: Sequence[str]) -> None:
        """Show which shapes are chosen."""
        self.clear()
        self.addItem(", ".join(shapes) or NONE, None)
        self.setToolTip(", ".join(shapes))

    def fill(self) -> None:
        """List all shapes of the face."""
        if self.count() == 1:
            self.addItem(NONE, "")
            for name in self._names:
                self.addItem(name, name)

    @override
    def showPopup(self) -> None:
        self.fill()
        super().showPopup()

    def _choose(self, place: int) -> None:
        name = self.itemData(place)
        if name is not None:
            self.shape_chosen.emit(name)


class FaceMappingDialog(QDialog):
    """Shows a guess, and lets the user change it; the face shows what the sliders say while it is open.

    Parameters
    ----------
    face : whose shapes are mapped.

    Signals
    -------
    chosen : the mapping, once it is to be saved.

    Attributes
    ----------
    mapping : what is shown.
    table : a line for each of ours; the boxes and sliders are `boxes` and `sliders`, by name.
    """

    chosen = Signal(object)

    def __init__(self, face: FaceModel, parent: QWidget) -> None:
        super().__init__(parent)
        assert face.states is not None
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle(tr("Map Blend Shapes of {face}").format(face=face.name))
        self.resize(*SIZE)
        around = parent.window().frameGeometry()
        self.move(around.right() - SIZE[0], around.center().y() - SIZE[1] // 2)  # so that the head stays in view
        self._face, self._names = face, face.states.names
        self.mapping: FaceMapping = guess_mapping(self._names)
        self.boxes: dict[str, ShapeBox] = {}
        self.sliders: dict[str, QSlider] = {}
        self.found, self.left = builders.label(wraps=True), builders.ElidedLabel()
        self.basis = builders.choice(
            ((BASES[name], name) for name in ENOUGH),
            tr("Blend shapes"),
            tr("Set of blend shapes that the speech moves"),
        )
        self.table = builders.named(QTableWidget(0, len(COLUMNS)), tr("Blend shapes, and those of this face"))
        self.table.setHorizontalHeaderLabels([tr(name) for name in COLUMNS])
        builders.style_list(self.table, ROW, WIDTHS)
        self.table.setSelectionMode(QTableWidget.SelectionMode.NoSelection)
        self.buttons: QDialogButtonBox = builders.dialog_buttons(
            self, QDialogButtonBox.StandardButton.Cancel, verb=tr("Save Mouth Table…")
        )
        top = builders.row((self.found, 1), builders.label(tr("Blend shapes")), self.basis, spacing=8)
        self.setLayout(
            builders.column(top, (self.table, 1), self.left, self.buttons, margins=(12, 12, 12, 12), spacing=8)
        )
        self.basis.activated.connect(self._choose_basis)
        face.changed.connect(self.reject)
        self._fill()

    @override
    def accept(self) -> None:
        self._let_go()
        super().accept()
        self.chosen.emit(self.mapping)

    @override
    def reject(self) -> None:
        self._let_go()
        super().reject()

    @override
    def closeEvent(self, event: QCloseEvent) -> None:
        self._let_go()
        super().closeEvent(event)

    def try_out(self, ours: str, percent: int) -> None:
        """Show on the face how far the sliders are."""
        del ours, percent
        held: dict[str, float] = {}
        for name, slider in self.sliders.items():
            for shape, share in self.mapping.targets.get(name, {}).items():
                held[shape] = held.get(shape, 0.0) + share * slider.value() / 100
        self._face.held = held if any(held.values()) else None

    def choose(self, ours: str, shape: str) -> None:
        """Have one of ours stand for another shape of the face; for none, where it is empty."""
        self.mapping = self.mapping.with_target(ours, shape)
        self._show()
        self.try_out(ours, 0)

    def _choose_basis(self, place: int) -> None:
        self.mapping = guess_mapping(self._names, self.basis.itemData(place))
        self._fill()

    def _fill(self) -> None:
        """Make a line for each of ours."""
        self._let_go()
        self.boxes.clear()
        self.sliders.clear()
        self.table.setRowCount(0)
        self.table.setRowCount(len(self.mapping.ours))
        for place, ours in enumerate(self.mapping.ours):
            words = tr("Blend shape of this face for {name}").format(name=ours)
            box = self.boxes[ours] = builders.named(ShapeBox(self._names), words)
            slider = self.sliders[ours] = QSlider(Qt.Orientation.Horizontal)
            builders.named(slider, tr("Try {name}").format(name=ours), tr("Show it on the face"))
            slider.setRange(0, 100)
            box.shape_chosen.connect(partial(self.choose, ours))
            slider.valueChanged.connect(partial(self.try_out, ours))
            self.table.setItem(place, 0, QTableWidgetItem(ours))
            self.table.setCellWidget(place, 1, box)
            self.table.setCellWidget(place, 2, slider)
        builders.leave_wheel(self.table)
        self._show()

    def _show(self) -> None:
        mapping = self.mapping
        with builders.silent(self.basis):
            self.basis.setCurrentIndex(self.basis.findData(mapping.basis))
        for ours, box in self.boxes.items():
            box.show_shapes([*mapping.targets.get(ours, ())])
            self.sliders[ours].setEnabled(ours in mapping.targets)
        self.found.setText(
            tr("{n} of {all} blend shapes are mapped.").format(n=len(mapping.targets), all=len(mapping.ours))
        )
        names = ", ".join(mapping.left_over)
        words = tr("Left over: {names}") if names else tr("No blend shape is left over.")
        self.left.setText(words.format(names=names))
        self.left.setToolTip(names)
        for button in self.buttons.buttons():
            if self.buttons.buttonRole(button) == QDialogButtonBox.ButtonRole.AcceptRole:
                button.setEnabled(bool(mapping.targets))

    def _let_go(self) -> None:
        """Have the face move again by what is said."""
        self._face.held = None
