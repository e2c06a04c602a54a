"""The line at the bottom, what is in hand and what it is heard on; and chips: how late the picture of a voice is."""

from PySide6.QtWidgets import QLabel

from phonemeanalyser.desktop.analyse.state_chips import StateChips
from phonemeanalyser.desktop.engine_words import tr_engine
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.session.sources import SourceKind
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.elided_label import ElidedLabel
from phonemeengine.live.microphone_analyser import Latency
from phonemeengine.presets.ears import ear_in_words

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
    latency_ms : how late a microphone's phonemes are on the screen; None while none is heard.
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
        preset = tr("preset {preset}{changed}").format(preset=self._preset.preset.name, changed=changed)
        ear = tr("heard with: {ear}").format(ear=tr_engine(ear_in_words(session.source.preset)))
        _write(
            self.left, f" {session.source.name}: {tr_engine(session.source.description)}   ·   {ear}   ·   {preset}"
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
                "…", self._theme.faint, tr("How late phonemes are on the screen: it is being measured")
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
        words = {tr("capture"): latency.capture, tr("window"): latency.window, tr("hop"): latency.hop,
                 **({tr("look-ahead"): latency.look_ahead} if latency.look_ahead else {}),
                 tr("analysis"): latency.analysis, tr("display"): self._display}  # fmt: skip
        shares = " + ".join(f"{name} {1000 * seconds:.0f}" for name, seconds in words.items())
        judgement, colour = self.judged(total)
        tip = tr(
            "From a sound to its phoneme on the screen, on the average, as measured now: {shares} ms. People notice "
            "a picture that is late by more than 45 ms, and stop accepting it at 90 ms (ITU-R BT.1359)."
        ).format(shares=shares)
        self.chips.show_late(_late(total, judgement), colour, tip)

    def judged(self, seconds: float) -> tuple[str, str]:
        """Return how people take a picture that is late by so much, and in which colour to say it."""
        if seconds <= UNNOTICED:
            return tr("nobody notices"), self._theme.good
        if seconds <= ACCEPTED:
            return tr("noticeable"), self._theme.faint
        return tr("too late"), self._theme.bad


def _late(seconds: float, judgement: str) -> str:
    return tr("{ms:.0f} ms late, {judgement}").format(ms=1000 * seconds, judgement=judgement)


def _write(label: QLabel, text: str) -> None:
    if text != label.text():
        label.setText(text)
