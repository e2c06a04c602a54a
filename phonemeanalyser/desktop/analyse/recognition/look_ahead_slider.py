"""How far a microphone's recogniser looks ahead, against how late its answers are."""

from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QSlider

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeanalyser.desktop.widgets.builders import label, named, silent
from phonemeengine.recognition.spec import spec_of
from phonemeengine.settings import FRAME_PERIOD, PARAMETERS

NAME = "live_look_ahead"
ENDS = (Qt.Key.Key_Home, Qt.Key.Key_End)
FRAME_MS = 1000 * FRAME_PERIOD


class LookAheadSlider(QSlider):
    """Sets the look-ahead of a microphone's recogniser, in frames of 10 ms.

    Attributes
    ----------
    words : a label to stand under it: how late answers are on this machine, and how right they are.
    """

    def __init__(self, preset: PresetModel) -> None:
        super().__init__(Qt.Orientation.Horizontal)
        self._preset = preset
        self._waiting: float | None = None
        self.words = named(
            label(wraps=True),
            tip=tr(
                "Late: from a sound to its phoneme on the screen, as this machine measured it since the start, with "
                "the microphone that was heard last. Macro F1 and right mouth shapes: of speakers whom the model did "
                "not learn from, as its training measured them."
            ),
        )
        self.setRange(0, round(PARAMETERS[NAME].high / FRAME_PERIOD))
        self.setPageStep(1)
        self.setTickPosition(QSlider.TickPosition.TicksBelow)
        self.valueChanged.connect(self._set)
        self.sliderReleased.connect(preset.end_edit)
        preset.changed.connect(self._show)
        self._show()

    def show_latency(self, waiting: float | None) -> None:
        """Take how late an answer is without any look-ahead, seconds; None says that it is not known."""
        if waiting != self._waiting:
            self._waiting = waiting
            self._tell()

    def event(self, event: QEvent) -> bool:
        """Claim the keys to the ends, which are else the window's."""
        if isinstance(event, QKeyEvent) and event.type() == QEvent.Type.ShortcutOverride and event.key() in ENDS:
            event.accept()
            return True
        return super().event(event)

    def _set(self, frames: int) -> None:
        seconds = round(frames * FRAME_PERIOD, 2)
        if seconds != getattr(self._preset.preset.settings, NAME):
            self._preset.set_setting(NAME, seconds)

    def _show(self) -> None:
        with silent(self):
            self.setValue(int(getattr(self._preset.preset.settings, NAME) / FRAME_PERIOD + 1e-6))
        self._tell()

    def _tell(self) -> None:
        preset = self._preset.preset
        waits = spec_of(preset.recogniser).looks_ahead
        frames = self.value() if waits else 0
        if waits and preset.model is not None:
            frames = preset.model.frames_ahead(frames * FRAME_PERIOD)
        ahead = (
            tr("{ms:.0f} ms ahead").format(ms=FRAME_MS * frames)
            if waits
            else tr("{recogniser} never waits").format(recogniser=preset.recogniser)
        )
        late = tr("listen to see how late")
        if self._waiting is not None:
            late = tr("{ms:.0f} ms late here").format(ms=1000 * self._waiting + FRAME_MS * frames)
        lines = [f"{ahead}: {late}"]
        if waits and preset.model is not None:
            figures = preset.model.by_look_ahead.get(frames)
            lines.append(
                tr("unheard speakers: macro F1 {macro_f1:.2f}, right mouth shapes {percent:.0f} %").format(
                    macro_f1=figures.macro_f1, percent=100 * figures.mouth_shapes
                )
                if figures
                else tr("how right it is then was not measured")
            )
        text = "\n".join(lines)
        if text != self.words.text():
            self.words.setText(text)
