"""The lanes of keys with the bar above them: which blend shapes are seen, and what becomes of the keys."""

from functools import partial

from PySide6.QtGui import QHideEvent, QShowEvent
from PySide6.QtWidgets import QMenu, QWidget
from typing_extensions import override

from phonemeanalyser.desktop.language import tr, tr_count
from phonemeanalyser.desktop.talk.keys.key_lanes import KeyLanes
from phonemeanalyser.desktop.talk.keys.key_model import MOST_SHAPES
from phonemeanalyser.desktop.talk.model import TalkModel
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.builders import ElidedLabel, column, open_without_arrow, row, spoken_button


class KeyPanel(QWidget):
    """The keys of the current sound.

    Attributes
    ----------
    lanes : the curves.
    shapes : lists the blend shapes, those first that move most; checked ones are seen.
    save, clear : write the keys beside the sound, and delete all of them.
    """

    def __init__(self, talking: TalkModel, theme: Theme) -> None:
        super().__init__()
        self._talking, self._keys = talking, talking.keys
        self.lanes = KeyLanes(talking.keys, talking.text, theme)
        self.summary = ElidedLabel()
        self.shapes = spoken_button(tr("Blend shapes ▾"), tr("Choose the blend shapes whose curves are shown"))
        self._menu = QMenu(self)
        open_without_arrow(self.shapes, self._menu)
        self.save = spoken_button(
            tr("Save Keys"), tr("Save the keys beside the recording, as NAME.keys.toml; exports use them"), self._save
        )
        self.clear = spoken_button(tr("Delete All"), tr("Delete all keys; Ctrl+Z restores them"), self._keys.clear)
        bar = row(self.shapes, (self.summary, 1), self.save, self.clear, spacing=4)
        bar.setContentsMargins(8, 0, 8, 0)
        column(bar, (self.lanes, 1), on=self, margins=(0, 2, 0, 0), spacing=2)
        self._menu.aboutToShow.connect(self._fill_menu)
        self.lanes.sought.connect(self._seek)
        self._keys.changed.connect(self._show_state)
        talking.session.view.moved.connect(self.lanes.update)
        self._show_state()

    def refresh(self) -> None:
        """Go along with what is playing."""
        self.lanes.refresh(self._talking.session.source.position)

    @override
    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._keys.watch(True)

    @override
    def hideEvent(self, event: QHideEvent) -> None:
        super().hideEvent(event)
        self._keys.watch(False)

    def _seek(self, seconds: float) -> None:
        session = self._talking.session
        session.seek(min(max(seconds, 0.0), session.source.duration))

    def _save(self) -> None:
        self._keys.save()

    def _show_state(self) -> None:
        curves = self._keys.layer.curves
        n = sum(len(curve.times) for curve in curves.values())
        said = tr_count("{n} key", "{n} keys", n) if n else ""
        names = ", ".join(curves)
        changed = tr("not saved") if self._keys.has_unsaved_changes else ""
        self.summary.setText("  ·  ".join(part for part in (said, names, changed) if part))
        self.save.setEnabled(self._keys.has_unsaved_changes)
        self.clear.setEnabled(bool(curves))

    def _fill_menu(self) -> None:
        self._menu.clear()
        shown = self._keys.shapes
        for name in self._keys.names():
            action = self._menu.addAction(name, partial(self._toggle, name))
            action.setCheckable(True)
            action.setChecked(name in shown)
            action.setEnabled(name in shown or len(shown) < MOST_SHAPES)

    def _toggle(self, name: str) -> None:
        shown = self._keys.shapes
        self._keys.show_shapes([other for other in shown if other != name] if name in shown else [*shown, name])
