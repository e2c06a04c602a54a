"""The style in which the face speaks: a list, amounts as sliders, all numbers and poses as tables, and files."""

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import Field, fields
from functools import partial
from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QTableWidget, QTableWidgetItem, QWidget

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.talk.expression.style_model import StyleModel
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets import builders
from phonemeanalyser.desktop.widgets.fields import PercentSlider
from phonemeengine.mouth.blendshape_names import both_sides
from phonemeengine.mouth.expression.streams import shipped_channels
from phonemeengine.mouth.style import limits_of
from phonemeengine.mouth.table import STRONGEST

AMOUNT_WORDS = {
    "mumbling": (tr_noop("Mumbling"), tr_noop("Opens the mouth less and later, and closes it for a shorter time")),
    "theatrical": (tr_noop("Theatrical"), tr_noop("Opens the mouth wider and faster, and moves the head more")),
    "asymmetry": (tr_noop("Asymmetry"), tr_noop("The right half of the face stays behind the left one")),
}
TABLES = {
    "closures": tr_noop("Poses of the lips"),
    "tongue": tr_noop("Poses of the tongue"),
    "movement": tr_noop("Movement of the mouth"),
    "poses": tr_noop("Poses over recorded faces"),
    "filters": tr_noop("Smoothing of recorded faces"),
    "gestures": tr_noop("Gestures of the head"),
    "inhibition": tr_noop("Onset and release of speech"),
    "reductions": tr_noop("Reduction of expressions by speech"),
}
"""The tables of a style, by their names in its file."""
SHIPPED = {"neutral": tr_noop("Neutral"), "mumbling": tr_noop("Mumbling"), "theatrical": tr_noop("Theatrical")}
HEAD_TIPS = {
    tr_noop("Priority"): tr_noop("Where poses overlap, the one with the higher priority comes first"),
    tr_noop("Width"): tr_noop("Factor of the time for which the pose holds, comes and goes"),
    tr_noop("Firm"): tr_noop("Lips, teeth and tongue meet in time and fully, however quiet the speech is"),
    tr_noop("Shape (%)"): tr_noop("Blend shapes on which the pose decides, with their weights in percent"),
    tr_noop("Reduction"): tr_noop("Share of the expression that speech takes away: 0 nothing, 1 everything"),
}
"""What the columns of poses and reductions say, by their titles."""
ROW_HEIGHT, TABLE_HEIGHT = 22, 200


class StylePanel(QWidget):
    """Shows the styles of both sides, and edits one of them.

    Signals
    -------
    target_asked : the user wants to save the style under another name.
    name_asked : the user wants to rename it.
    fit_asked : the user wants it fitted to the recorded faces in use.

    Attributes
    ----------
    lists : the styles of the sides A and B.
    edits : buttons that choose the side that is edited.
    blend : the slider from A to B.
    sliders : of the amounts, by name.
    part, table : which numbers or poses are shown, and these.
    fit, save, save_as, rename, revert : buttons.
    """

    target_asked = Signal()
    name_asked = Signal()
    fit_asked = Signal()

    def __init__(self, styles: StyleModel, theme: Theme) -> None:
        super().__init__()
        self._model = styles
        tip = tr("Style in which the face speaks: a built-in one, or one of your own from the styles folder")
        self.lists = {side: builders.choice((), tr("Style {side}").format(side=side), tip) for side in styles.names}
        self.edits = {
            side: builders.toggle_button(side, tr("Edit the style of side {side} below").format(side=side))
            for side in styles.names
        }
        self.blend = PercentSlider(
            tr("Blend of styles"), tr("From the style of side A to that of side B"), styles.set_blend
        )
        self.sliders = {
            name: PercentSlider(tr(words), tr(tip), partial(styles.set_amount, name))
            for name, (words, tip) in AMOUNT_WORDS.items()
        }
        self.part = builders.choice(
            ((tr(words), name) for name, words in TABLES.items()),
            tr("Table of the style"),
            tr(
                "Which poses or numbers of the style the table below shows; double-click one to edit it. Shape, "
                "width and firmness act on rules, too, priorities on recorded faces, where poses overlap"
            ),
        )
        self.table = builders.named(QTableWidget(), tr("Poses and numbers of the style"))
        self.table.setFixedHeight(TABLE_HEIGHT)
        self.fit = builders.spoken_button(
            tr("Fit to Recorded Faces"),
            tr("Set reach, speed, closures and asymmetry so that rules move most like the recorded faces in use"),
            self.fit_asked.emit,
        )
        self.save = builders.spoken_button(tr("Save"), tr("Save the style to its file"))
        self.save_as = builders.spoken_button(
            tr("Save As…"), tr("Save the style under another name"), self.target_asked.emit
        )
        self.rename = builders.spoken_button(
            tr("Rename…"), tr("Give your own style and its file another name"), self.name_asked.emit
        )
        self.revert = builders.spoken_button(
            tr("Revert"), tr("Undo all changes to the style since it was saved"), styles.revert
        )
        self._lay_out(theme)
        self._connect()
        self._show_state()

    def _lay_out(self, theme: Theme) -> None:
        sides = builders.grid(across=5, down=3)
        builders.fill_rows(sides, [(self.edits[side], self.lists[side]) for side in self.lists])
        amounts = builders.grid(across=5, down=3)
        blended = builders.label(tr("A to B"))
        blended.setToolTip(self.blend.toolTip())
        rows = [
            (builders.label(tr(words)), self.sliders[name], self.sliders[name].percent)
            for name, (words, _) in AMOUNT_WORDS.items()
        ]
        builders.fill_rows(amounts, [(blended, self.blend, self.blend.percent), *rows])
        shown = builders.label(tr("Table"), theme.faint)
        builders.column(
            builders.row(
                (builders.heading(tr("Style")), 1), self.save, self.save_as, self.rename, self.revert, spacing=4
            ),
            sides,
            amounts,
            builders.row(self.fit, 1),
            builders.row(shown, (self.part, 1), spacing=6),
            self.table,
            on=self,
            spacing=4,
        )

    def _connect(self) -> None:
        model = self._model
        for side, box in self.lists.items():
            box.activated.connect(lambda k, side=side, box=box: model.choose(side, box.itemData(k)))
            self.edits[side].clicked.connect(lambda _checked, side=side: self._edit_side(side))
        for slider in self.sliders.values():
            slider.sliderPressed.connect(model.begin_drag)
        self.part.currentIndexChanged.connect(lambda _k: self._show_table())
        self.table.itemChanged.connect(self._take)
        self.save.clicked.connect(lambda _checked: model.save() if model.is_own else self.target_asked.emit())
        model.changed.connect(self._show_state)

    def _edit_side(self, side: str) -> None:
        self._model.edit_side(side)
        self._show_state()

    def _show_state(self) -> None:
        model = self._model
        known = model.known  # read from a folder
        known += tuple(sorted({*filter(None, model.names.values())} - {*known}))
        for side, box in self.lists.items():
            none = [(tr("No style"), "")] if side == "B" else []
            with builders.silent(box):
                builders.offer(box, [*none, *((self._named(name), name) for name in known)], model.names[side])
            self.edits[side].setChecked(model.side == side)
        self.edits["B"].setEnabled(bool(model.names["B"]))
        self.blend.setEnabled(bool(model.names["B"]))
        self.blend.show_share(model.amount)
        for name, slider in self.sliders.items():
            slider.show_share(getattr(model.edited, name))
        edited = model.is_edited(model.names[model.side])
        self.save.setEnabled(edited)
        self.revert.setEnabled(edited)
        self.rename.setEnabled(model.is_own)
        self._show_table()

    def _named(self, name: str) -> str:
        words = tr(SHIPPED[name]) if name in SHIPPED else Path(name).stem
        return f"{words} *" if self._model.is_edited(name) else words

    # -- the table ----------------------------------------------------------------------------------------

    def _show_table(self) -> None:
        part, style = self.part.currentData(), self._model.edited
        with builders.silent(self.table):
            if part in {"closures", "tongue"}:
                self._fill(
                    (tr("Sound"), tr("Priority"), tr("Width"), tr("Firm"), tr("Shape (%)")),
                    [
                        (
                            phone,
                            f"{pose.priority:g}",
                            f"{pose.width:g}",
                            pose.firm,
                            _written(getattr(style, part).shapes[pose.shape]),
                        )
                        for phone, pose in getattr(style, part).phones.items()
                    ],
                    (86, 62, 48, 40, 0),
                )
            elif part == "reductions":
                usual = zip(shipped_channels().names, shipped_channels().reductions.tolist(), strict=True)
                rows = [(name, f"{style.reductions.get(name, share):.3g}") for name, share in usual]
                self._fill((tr("Blend shape"), tr("Reduction")), rows, (0, 90))
            else:
                numbers = getattr(style, part)
                found = [(each.name, f"{getattr(numbers, each.name):g}", _limits(each)) for each in fields(numbers)]
                self._fill((tr("Number"), tr("Value"), tr("Range")), found, (0, 70, 90))

    def _fill(self, titles: tuple[str, ...], rows: Sequence[tuple[str | bool, ...]], widths: tuple[int, ...]) -> None:
        table, place = self.table, self.table.verticalScrollBar().value()
        table.setColumnCount(len(titles))
        table.setRowCount(len(rows))
        table.setHorizontalHeaderLabels(list(titles))
        tips = {tr(title): tr(tip) for title, tip in HEAD_TIPS.items()}
        for k, title in enumerate(titles):
            table.model().setHeaderData(k, Qt.Orientation.Horizontal, tips.get(title), Qt.ItemDataRole.ToolTipRole)
        builders.style_list(table, ROW_HEIGHT, widths)
        table.setEditTriggers(QTableWidget.EditTrigger.DoubleClicked | QTableWidget.EditTrigger.EditKeyPressed)
        for k, values in enumerate(rows):
            for column_, value in enumerate(values):
                item = QTableWidgetItem("" if isinstance(value, bool) else value)
                fixed = column_ == 0 or titles[column_] == tr("Range")
                flags = Qt.ItemFlag.ItemIsEnabled | Qt.ItemFlag.ItemIsSelectable
                if isinstance(value, bool):
                    flags |= Qt.ItemFlag.ItemIsUserCheckable
                    item.setCheckState(Qt.CheckState.Checked if value else Qt.CheckState.Unchecked)
                elif not fixed:
                    flags |= Qt.ItemFlag.ItemIsEditable
                    item.setToolTip(value)
                item.setFlags(flags)
                table.setItem(k, column_, item)
        table.verticalScrollBar().setValue(place)

    def _take(self, item: QTableWidgetItem) -> None:
        """Take what was written into the table; what is no number changes nothing."""
        part, name = self.part.currentData(), self.table.model().index(item.row(), 0).data()
        act = self._act_of(part, name, item)
        try:
            act()
        except ValueError:
            sentence = tr("{words}: write a number such as 0.5, or a shape such as jawOpen 5, mouthPress 30.")
            self._model.error.emit(sentence.format(words=item.text()[:40]))
            self._show_table()

    def _act_of(self, part: str, name: str, item: QTableWidgetItem) -> Callable[[], object]:
        model, words = self._model, item.text().replace(",", ".")
        if part in {"closures", "tongue"}:
            if item.column() == 3:
                return lambda: model.set_pose(part, name, firm=item.checkState() is Qt.CheckState.Checked)
            if item.column() == 4:
                return lambda: model.set_shape(part, name, _read(item.text(), getattr(model.edited, part).movestates))
            return lambda: model.set_pose(part, name, **{("priority", "width")[item.column() - 1]: float(words)})
        if part == "reductions":
            return lambda: model.set_reduction(name, float(words))
        return lambda: model.set_number(part, name, float(words))


def _limits(entry: Field[float]) -> str:
    low, high, unit = limits_of(entry)
    return f"{low:g}..{high:g} {unit}".strip()


def _written(shape: Mapping[str, float]) -> str:
    """Return percentages as words, such as ``jawOpen 5, mouthPress 34``; a name without a side stands for both."""
    words: dict[str, str] = {}
    for name, percent in shape.items():
        both = name.removesuffix("Left").removesuffix("Right")
        alike = both != name and len({shape.get(f"{both}{side}") for side in ("Left", "Right")}) == 1
        words.setdefault(both if alike else name, f"{percent:g}")
    return ", ".join(f"{name} {percent}" for name, percent in words.items())


def _read(words: str, movestates: Collection[str]) -> dict[str, float]:
    """Return the percentages that such words say; ValueError where they say something else."""
    shape: dict[str, float] = {}
    for entry in filter(None, map(str.strip, words.split(","))):
        name, _, percent = entry.partition(" ")
        sides = [side for side in (name, *both_sides(name)) if side in movestates]
        if not sides or not abs(float(percent)) <= STRONGEST:
            raise ValueError(entry)
        shape |= dict.fromkeys(sides, float(percent))
    return shape
