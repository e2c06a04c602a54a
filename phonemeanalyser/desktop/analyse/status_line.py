"""The line at the bottom, with the current sound and its output; and chips: the latency on the screen."""

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QFontMetrics
from PySide6.QtWidgets import QLabel, QSizePolicy, QToolButton, QWidget

from phonemeanalyser.desktop.engine_words import recogniser_title, tr_engine
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.session.sources import SourceKind
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.builders import ElidedLabel, named, row, tool_button
from phonemeengine.live.listener import Latency
from phonemeengine.presets.model_choice import model_in_words

PADDING = 8
"""Pixels at either side of a chip's text."""


class StateChips(QWidget):
    """Chips that are there while there is something to say; two of them can be clicked.

    Signals
    -------
    go_on_asked : the views are to go on.
    open_again_asked : the current file is to be opened again.

    Attributes
    ----------
    frozen, changed, unseen, lost, late : the chips.
    """

    go_on_asked = Signal()
    open_again_asked = Signal()

    def __init__(self, theme: Theme) -> None:
        super().__init__()
        self._theme = theme
        self.frozen = tool_button(
            tr("Frozen"),
            tr("The views are frozen while playback or the microphone goes on; click or press F to resume"),
            tr("Views are frozen"),
            self.go_on_asked.emit,
        )
        self.changed = tool_button("", tr("What happened to the file on disk"), act=self.open_again_asked.emit)
        self.unseen = named(
            QLabel(),
            tip=tr("Frames analysed but never drawn since playback or listening began: the computer is overloaded"),
        )
        self.lost = named(QLabel(), tip=tr("Signal lost between microphone and program since listening began"))
        self.late = QLabel()
        self.late.setAlignment(Qt.AlignmentFlag.AlignCenter)
        chips = row(on=self, margins=(0, 0, 6, 0), spacing=4)
        for chip in self._chips:
            chip.hide()
            chips.addWidget(chip, 0, Qt.AlignmentFlag.AlignVCenter)
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Preferred)
        self._dress(self.frozen, theme.accent)
        for chip in (self.changed, self.unseen, self.lost):
            self._dress(chip, theme.bad)

    def show_frozen(self, on: bool) -> None:
        """Say that the views stand still, or that they do not."""
        self.frozen.setVisible(on)

    def show_changed(self, words: str, tip: str) -> None:
        """Say that the current file is another one by now, or none; an empty text for neither."""
        if tip:
            self.changed.setToolTip(tip)
        _say(self.changed, words)

    def show_unseen(self, n_frames: int) -> None:
        """Say how many frames were never drawn; 0 for none."""
        _say(self.unseen, tr("{n} frames not drawn").format(n=n_frames) if n_frames else "")

    def show_lost(self, seconds: float) -> None:
        """Say how much sound never came; 0 for none."""
        _say(self.lost, tr("{seconds:.2f} s lost").format(seconds=seconds) if seconds >= 0.005 else "")

    def keep_room_for_late(self, widest: str) -> None:
        """Give the chip of lateness the width of a text, so that the tool bar stands still while the text changes."""
        font = self.late.font()
        font.setBold(True)
        self.late.setMinimumWidth(QFontMetrics(font).horizontalAdvance(widest) + 2 * PADDING)

    def show_late(self, words: str, colour: str = "", tip: str = "") -> None:
        """Show the latency of phonemes on the screen; an empty text for nothing."""
        if words and colour:
            self._dress(self.late, colour)
        self.late.setToolTip(tip)
        _say(self.late, words)

    def words(self) -> str:
        """Return what the chips say."""
        return "   ".join(chip.text() for chip in self._chips if not chip.isHidden())

    @property
    def _chips(self) -> tuple[QToolButton | QLabel, ...]:
        return self.frozen, self.changed, self.unseen, self.lost, self.late

    def _dress(self, chip: QWidget, colour: str) -> None:
        sheet = (
            f"* {{ background: {colour}; color: {self._theme.on_colour}; border: 0; border-radius: 8px;"
            f" padding: 1px {PADDING}px; font-weight: bold }} QToolTip {{ font-weight: normal }}"
        )
        if sheet != chip.styleSheet():
            chip.setStyleSheet(sheet)


def _say(chip: QLabel | QToolButton, words: str) -> None:
    if words != chip.text():
        chip.setText(words)
    chip.setVisible(bool(words))


UNNOTICED, ACCEPTED = 0.045, 0.090
"""Seconds by which a picture may lag behind its sound before it is noticed, and before it is not accepted any more
(ITU-R BT.1359)."""
STEADINESS = 0.02
"""Share of a new measurement in what is shown."""


class StatusLine:
    """Two labels for a status bar, and chips for a tool bar.

    Attributes
    ----------
    left, right : the labels.
    chips : what is the matter, while something is.
    latency_ms : the latency of a microphone's phonemes on the screen; None while no microphone is in use.
    without_look_ahead : seconds of that, without the recogniser's look-ahead, as measured last; None before.
    """

    def __init__(self, session: Session, preset: PresetModel, theme: Theme) -> None:
        self.left, self.right = ElidedLabel(), QLabel()
        self.chips = StateChips(theme)
        self.latency_ms: float | None = None
        self.without_look_ahead: float | None = None
        self._display = 0.0
        self._session = session
        self._preset = preset
        self._theme = theme
        judgements = (self.judged(seconds)[0] for seconds in (UNNOTICED, ACCEPTED, 2 * ACCEPTED))
        self.chips.keep_room_for_late(_late(0.888, max(judgements, key=len)))

    def note_display(self, seconds: float) -> None:
        """Take note of how long a phoneme took from being known to being painted."""
        self._display += STEADINESS * (seconds - self._display) if self._display else seconds

    def refresh(self, *, frozen: bool) -> None:
        """Show how it goes."""
        session = self._session
        changed = f" ({tr('changed')})" if self._preset.has_unsaved_changes else ""
        preset = tr("Preset: {preset}{changed}").format(preset=self._preset.title, changed=changed)
        model = tr("Model: {model}").format(model=tr_engine(recogniser_title(model_in_words(session.source.preset))))
        _write(
            self.left, f" {session.source.name}: {tr_engine(session.source.description)}   ·   {model}   ·   {preset}"
        )
        self.left.setToolTip(self.left.text().strip())
        self.chips.show_frozen(frozen)
        player, listens = session.source.player, session.source.kind is SourceKind.MICROPHONE
        self.chips.show_unseen((player or session.microphone.listener).n_dropped)
        microphone = session.microphone
        self.chips.show_lost(microphone.listener.lost_seconds if listens and microphone.active else 0.0)
        self._show_latency(microphone.latency if listens else None)
        if listens and self.latency_ms is None:
            self.chips.show_late(
                "…", self._theme.faint, tr("Latency from a sound to its phoneme on the screen: being measured")
            )
        output = "" if player is None else f"♪ {player.output_name}" if player.has_card else tr(player.output_name)
        _write(self.right, f"{output} ")

    def _show_latency(self, latency: Latency | None) -> None:
        if latency is None:
            self.latency_ms = None
            self.chips.show_late("")
            return
        total = latency.total + self._display
        self.latency_ms = 1000 * total
        self.without_look_ahead = total - latency.look_ahead
        words = {
            tr("capture"): latency.capture,
            tr("window"): latency.window,
            tr("hop"): latency.hop,
            **({tr("look-ahead"): latency.look_ahead} if latency.look_ahead else {}),
            tr("analysis"): latency.analysis,
            tr("display"): self._display,
        }
        shares = " + ".join(f"{name} {1000 * seconds:.0f}" for name, seconds in words.items())
        judgement, colour = self.judged(total)
        tip = tr(
            "Mean latency from a sound to its phoneme on the screen, as measured now: {shares} ms. Viewers notice "
            "a picture that lags its sound by more than 45 ms, and find it unacceptable from 90 ms on (ITU-R "
            "BT.1359)."
        ).format(shares=shares)
        self.chips.show_late(_late(total, judgement), colour, tip)

    def judged(self, seconds: float) -> tuple[str, str]:
        """Return how noticeable a latency in seconds is, and the colour that shows it."""
        if seconds <= UNNOTICED:
            return tr("not noticeable"), self._theme.good
        if seconds <= ACCEPTED:
            return tr("noticeable"), self._theme.faint
        return tr("too high"), self._theme.bad


def _late(seconds: float, judgement: str) -> str:
    return tr("Latency {ms:.0f} ms ({judgement})").format(ms=1000 * seconds, judgement=judgement)


def _write(label: QLabel, text: str) -> None:
    if text != label.text():
        label.setText(text)
