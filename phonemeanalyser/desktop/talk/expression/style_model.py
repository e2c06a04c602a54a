"""The styles in which the face speaks: two sides, A and B, with a blend between them, each edited and saved."""

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QUndoStack

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.session.undo import UndoableEdit
from phonemeanalyser.desktop.tasks import tried
from phonemeengine.errors import EngineError
from phonemeengine.mouth.expression.streams import shipped_channels
from phonemeengine.mouth.poses import Pose
from phonemeengine.mouth.style import (
    NEUTRAL,
    Style,
    blend,
    load_style,
    own_styles,
    save_style,
    shipped_styles,
    style_of,
    style_to_toml,
)
from phonemeengine.storage.files import is_portable
from phonemeengine.storage.paths import styles_folder


class StyleModel(QObject):
    """Holds the styles of both sides; what is edited is the side that was chosen, and edits can be undone.

    A style is known by its name where it ships, and else by its path. One that was edited keeps its edits until it
    is saved or reverted, also while others are in use.

    Parameters
    ----------
    undo_stack : takes the edits; one of its own, where it is None.

    Signals
    -------
    changed : the face speaks in another style, or another side is edited.
    error : a sentence for the user.

    Attributes
    ----------
    names : which style each side has; side B may have none.
    side : the side that is edited, ``A`` or ``B``.
    amount : how much of B the style in use has, 0..1, where there is a B.
    style : the style in use.
    """

    changed = Signal()
    error = Signal(str)

    def __init__(self, undo_stack: QUndoStack | None = None) -> None:
        super().__init__()
        self._undo_stack = undo_stack or QUndoStack(self)
        self._run = 0
        self.names = {"A": NEUTRAL, "B": ""}
        self.side, self.amount = "A", 0.0
        self._saved: dict[str, Style] = {}
        self._edited: dict[str, Style] = {}
        self.style = self.of_side("A")

    @property
    def known(self) -> tuple[str, ...]:
        """All styles that can be chosen: those that ship, and the user's own."""
        return (*shipped_styles(), *map(str, own_styles()))

    def of_side(self, side: str) -> Style:
        """Return the style of a side, as it is edited; for B without a style, that of A."""
        name = self.names[side] or self.names["A"]
        if name not in self._saved:
            self._saved[name] = load_style(name)
        return self._edited.get(name, self._saved[name])

    @property
    def edited(self) -> Style:
        """The style of the side that is edited."""
        return self.of_side(self.side)

    def is_edited(self, name: str) -> bool:
        """Return whether a style has edits that are not saved."""
        return name in self._edited

    @property
    def is_own(self) -> bool:
        """Return whether the style that is edited is a file of the user's."""
        return self.names[self.side] not in shipped_styles()

    # -- what is chosen -----------------------------------------------------------------------------------

    def choose(self, side: str, name: str) -> None:
        """Put a style on a side; an empty name leaves B without one. One that cannot be read changes nothing."""
        if name and name not in self._saved and not tried(lambda: self._load(name), self._tell):
            return
        self.names[side] = name
        self.side = side if name else "A"
        self._use()

    def edit_side(self, side: str) -> None:
        """Edit the style of this side from now on."""
        if self.names.get(side):
            self.side = side
            self.changed.emit()

    def set_blend(self, amount: float) -> None:
        """Speak with so much of B, 0..1."""
        if (amount := min(max(amount, 0.0), 1.0)) != self.amount:
            self.amount = amount
            self._use()

    # -- what is edited -----------------------------------------------------------------------------------

    def begin_drag(self) -> None:
        """Make the next amounts an edit of their own, which is undone at once."""
        self._run += 1

    def set_amount(self, name: str, value: float) -> None:
        """Set an amount of the style that is edited, 0..1; until another drag begins, that is one edit."""
        amount: dict[str, Any] = {name: value}
        self._edit(lambda style: replace(style, **amount), (name, self._run))

    def set_number(self, group: str, name: str, value: float) -> None:
        """Set a number of a table; one beyond its limits is refused."""
        self._edit(lambda style: replace(style, **{group: replace(getattr(style, group), **{name: value})}))

    def set_reduction(self, channel: str, value: float) -> None:
        """Set the share by which speech reduces a channel of ARKit, 0..1."""
        usual = float(shipped_channels().reductions[shipped_channels().names.index(channel)])
        others = {name: share for name, share in self.edited.reductions.items() if name != channel}
        own = {} if abs(value - usual) < 1e-6 else {channel: value}
        self._edit(lambda style: replace(style, reductions=others | own))

    def set_pose(self, group: str, phone: str, **values: Any) -> None:
        """Set priority, width or firmness of a pose in ``closures`` or ``tongue``."""
        table = getattr(self.edited, group)
        pose: Pose = replace(table.phones[phone], **values)
        self._edit(lambda style: replace(style, **{group: replace(table, phones={**table.phones, phone: pose})}))

    def set_shape(self, group: str, phone: str, percentages: dict[str, float]) -> None:
        """Set the percentages of the movestates on which the pose of a phone decides."""
        table, own = getattr(self.edited, group), f"of {phone}"
        pose: Pose = replace(table.phones[phone], shape=own)
        table = replace(table, phones={**table.phones, phone: pose}, shapes={**table.shapes, own: percentages})
        self._edit(lambda style: replace(style, **{group: table}))

    def take(self, style: Style) -> None:
        """Have the style that is edited speak as another one."""
        self._edit(lambda own: replace(style, name=own.name, notes=own.notes))

    def revert(self) -> None:
        """Take back all edits of the style that is edited since it was saved; that can be undone, too."""
        self._edit(lambda _style: self._saved[self.names[self.side]])

    def put(self, name: str, style: Style) -> None:
        """Have this content of a style that is on a side; that cannot be undone."""
        self._edited[name] = style
        if style == self._saved[name]:
            del self._edited[name]
        self._use()

    # -- files --------------------------------------------------------------------------------------------

    def save(self, path: Path | None = None) -> bool:
        """Save the style that is edited, to its own file or to another one, which the side has then."""
        name = self.names[self.side]
        path = path or Path(name)
        style = replace(self.edited, name=path.stem)
        if not tried(lambda: _written(style, path), self._tell):
            return False
        self._edited.pop(name, None)
        self._saved[str(path)] = style
        self.names[self.side] = str(path)
        self._use()
        return True

    def rename(self, name: str) -> bool:
        """Give the user's own style that is edited another name, and its file."""
        old = Path(self.names[self.side])
        path = old.with_name(f"{name.strip()}.toml")
        if not is_portable(path.name) or path.exists():
            sentence = tr("{name}: a file of this name is there, or can't be; choose another name.")
            self._tell(sentence.format(name=path.name))
            return False
        if not self.save(path):
            return False
        old.unlink(missing_ok=True)
        self._saved.pop(str(old), None)
        for side, chosen in self.names.items():
            if chosen == str(old):
                self.names[side] = str(path)
        self._use()
        return True

    def folder(self) -> Path:
        """Return the folder of the user's own styles, made if need be where that goes."""
        folder = styles_folder()
        tried(lambda: folder.mkdir(parents=True, exist_ok=True), self._tell)
        return folder

    # -- what stays for the next start --------------------------------------------------------------------

    @property
    def kept(self) -> dict[str, Any]:
        """Sides, blend and edits that are not saved."""
        edits = {name: style_to_toml(style) for name, style in self._edited.items()}
        return {"names": self.names, "amount": self.amount, "edits": edits}

    def restore(self, kept: dict[str, Any]) -> None:
        """Take up what was kept; a style that is not there any more is left out."""
        before = self.side, self.amount, {**self.names}, {**self._edited}
        for name, text in dict(kept.get("edits", {})).items():
            tried(partial(self._take_edit, str(name), str(text)), self._tell)
        self.amount = min(max(float(kept.get("amount", 0.0)), 0.0), 1.0)
        for side, name in dict(kept.get("names", {})).items():
            is_another = side in self.names and name != self.names[side]
            if is_another and (not name or Path(name).is_file() or str(name) in {*self._saved, *self.known}):
                self.choose(side, str(name))
        if before != ("A", self.amount, self.names, self._edited):
            self.edit_side("A")

    def _take_edit(self, name: str, text: str) -> None:
        self._load(name)
        self._edited[name] = style_of(text)

    def _load(self, name: str) -> None:
        self._saved[name] = load_style(name)

    def _edit(self, change: Callable[[Style], Style], run: object = None) -> None:
        """Push an edit; one of no run continues none."""
        try:
            style = change(self.edited)
        except EngineError as error:
            self._tell(str(error))
            self.changed.emit()
            return
        if style != self.edited:
            name, what = self.names[self.side], tr("change of the style {name}").format(name=style.name)
            edit = UndoableEdit(
                what,
                partial(self.put, name),
                self.edited,
                style,
                lambda: name in self.names.values(),  # a style that is on no side cannot be edited
                None if run is None else (name, run),
            )
            self._undo_stack.push(edit)

    def _use(self) -> None:
        self.style = blend(self.of_side("A"), self.of_side("B"), self.amount if self.names["B"] else 0.0)
        self.changed.emit()

    def _tell(self, sentence: str) -> None:
        if sentence:
            self.error.emit(sentence)


def _written(style: Style, path: Path) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    save_style(style, path)
