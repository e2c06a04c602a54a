"""What the user sees while he is led through what is to be said."""

import math
from functools import partial
from typing import Any

from PySide6.QtCore import QRectF, Qt, Signal
from PySide6.QtGui import QColor, QKeySequence, QPainter, QPen, QShortcut
from PySide6.QtWidgets import QSizePolicy, QToolButton, QWidget
from typing_extensions import override

from phonemeanalyser.desktop.calibrate.guide.guide_model import SOUNDS, Phase
from phonemeanalyser.desktop.calibrate.model import CalibrationModel
from phonemeanalyser.desktop.calibrate.workbench.figures_table import FiguresTable
from phonemeanalyser.desktop.engine_words import tr_engine
from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.theme import CENTRED, PHONEME_COLOURS, Theme, draw_text, size_that_fills
from phonemeanalyser.desktop.widgets.builders import choice, column, label, row, silent, spoken_button, tab_buttons
from phonemeanalyser.desktop.widgets.level_meter import LevelMeterView
from phonemeengine.calibration.calibrate import CalibrationResult
from phonemeengine.calibration.takes.sentences import LANGUAGES
from phonemeengine.phonemes import Phoneme

UNCLEAR = tr_noop(
    "Such a small gain on so little speech may be due to chance. Listen to both presets before you decide."
)
LINES_AHEAD = tr_noop(
    "Keep quiet for two seconds, then read two sentences aloud. Nothing is recorded until you press Start."
)
SOUNDS_AHEAD = tr_noop(
    "Keep quiet for two seconds, then say nine sounds and read a sentence aloud. Nothing is recorded until "
    "you press Start."
)
"""What will be asked for."""
RING = 15
"""Width of the ring in pixels."""
SIZES = (12, 64)
"""Least and largest of the letters in it, pixels."""


class CountdownRing(QWidget):
    """A ring that fills while the sound is recorded, around what is to be said."""

    def __init__(self, calibration: CalibrationModel, theme: Theme) -> None:
        super().__init__()
        self._guide = calibration.guide
        self._theme = theme
        self.setMinimumSize(180, 170)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)

    @override
    def paintEvent(self, _event: Any) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        side = min(self.width(), self.height()) - RING - 8
        box = QRectF((self.width() - side) / 2, (self.height() - side) / 2, side, side)
        guide = self._guide
        learning = guide.phase in {Phase.LEARNING, Phase.DONE}
        colour = QColor(self._theme.accent if learning or guide.reading else PHONEME_COLOURS[guide.step.phoneme])
        if guide.phase is Phase.SHOWING:
            colour = QColor(self._theme.bad if guide.advice else self._theme.good)
        painter.setPen(QPen(QColor(self._theme.line), RING, Qt.PenStyle.SolidLine, Qt.PenCapStyle.FlatCap))
        painter.drawEllipse(box)
        painter.setPen(QPen(colour, RING, Qt.PenStyle.SolidLine, Qt.PenCapStyle.FlatCap))
        share = 1.0 if guide.phase is Phase.DONE else guide.share
        painter.drawArc(box, 90 * 16, -round(360 * 16 * share))
        words = self._words()
        size = size_that_fills(painter, words, side - 3 * RING, *SIZES)
        draw_text(painter, box, words, self._theme.text, size, CENTRED)

    def _words(self) -> str:
        guide = self._guide
        words = {
            Phase.READY: tr("Ready?"),
            Phase.COUNTING: str(max(1, math.ceil(guide.seconds_left))),
            Phase.CHECKING: "…",
            Phase.SHOWING: tr("Try Again") if guide.advice else "✓",
            Phase.LEARNING: tr("Calibrating"),
            Phase.DONE: tr("Done"),
        }
        return words.get(guide.phase) or tr(guide.step.say)


class StepsLine(QWidget):
    """All that is asked for in a row: done, at hand, and to come."""

    def __init__(self, calibration: CalibrationModel, theme: Theme) -> None:
        super().__init__()
        self._guide = calibration.guide
        self._theme = theme
        self.setFixedHeight(40)

    @override
    def paintEvent(self, _event: Any) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        guide = self._guide
        cell = self.width() / len(guide.steps)
        for k, step in enumerate(guide.steps):
            box = QRectF(k * cell + 2, 2, cell - 4, self.height() - 4)
            done, here = k in guide.numbers or k in guide.sentences, k == guide.index
            painter.setPen(QPen(QColor(self._theme.accent if here else self._theme.line), 2 if here else 1))
            painter.setBrush(QColor(self._theme.raised))
            painter.drawRoundedRect(box, 4, 4)
            line = PHONEME_COLOURS[step.phoneme] if step.sentence is None else self._theme.accent
            painter.fillRect(QRectF(box.left() + 4, box.bottom() - 5, box.width() - 8, 3), QColor(line))
            colour = self._theme.text if here or done else self._theme.faint
            words = f"✓ {step.name}" if done else step.name
            draw_text(painter, box.adjusted(0, 0, 0, -5), words, colour, 12, CENTRED)


class GuideView(QWidget):
    """Leads through what is to be said; shows at the end what was learned: in figures, and by a head that says it.

    Parameters
    ----------
    head : says what is recognised.

    Signals
    -------
    save_asked : the new preset is in use, and is to be saved under a name of its own.
    accepted : the new preset is in use, and not saved.
    """

    save_asked = Signal()
    accepted = Signal()

    def __init__(self, calibration: CalibrationModel, head: QWidget, theme: Theme) -> None:
        super().__init__()
        self._calibration = calibration
        self._theme = theme
        self.title, self.hint = label(wraps=True), label(wraps=True)
        self.advice, self.room = label(wraps=True), label(colour=theme.faint, wraps=True)
        self.steps = StepsLine(calibration, theme)
        self.ring = CountdownRing(calibration, theme)
        self.meter = LevelMeterView(calibration.session.microphone.read_level, theme)
        self.figures = FiguresTable((tr("Before"), tr("After"), tr("Difference")), theme)
        self.head = head
        self.head.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Ignored)  # buttons come before it
        self._make_controls()
        self._lay_out()
        self._connect()
        self._show()

    def _make_controls(self) -> None:
        guide = self._calibration.guide
        self.language = choice(
            ((tr(name), name) for name in LANGUAGES), tr("Sentence language"), tr("Language of the sentences to read")
        )
        self.sounds = spoken_button(
            tr("Single Sounds"),
            tr("Calibrate with nine single sounds instead of a sentence"),
            lambda: guide.choose(guide.language, by_sounds=not guide.by_sounds),
        )
        self.play_old = spoken_button(
            tr("▶ Old preset"),
            tr("Play the sentence; the head shows the mouth shapes of the old preset"),
            partial(self._play, new=False),
        )
        self.play_new = spoken_button(
            tr("▶ New preset"),
            tr("Play the sentence; the head shows the mouth shapes of the new preset"),
            partial(self._play, new=True),
        )
        self.save = spoken_button(
            tr("Use and Save As…"), tr("Use the new preset and save it under a new name"), self._save
        )
        self.start = spoken_button(
            tr("Start"), tr("Start recording after a two-second countdown (Return)"), guide.start
        )
        self.back = spoken_button(tr("◀ Back"), tr("Repeat the previous step (Backspace)"), guide.back)
        self.again = spoken_button(tr("Repeat"), tr("Repeat this step (R)"), guide.again)
        self.skip = spoken_button(tr("Skip ▶"), tr("Skip this step (Right arrow)"), guide.skip)
        self.cancel = spoken_button(
            tr("Cancel"),
            tr("Cancel the calibration and delete its takes; Ctrl+Z restores them (Escape)"),
            guide.cancel,
        )
        self.refuse = spoken_button(
            tr("Keep Old Preset"), tr("Leave the preset unchanged; the takes are kept (Escape)"), guide.cancel
        )
        self.accept = spoken_button(
            tr("Use New Preset"), tr("Use the new preset; Ctrl+Z restores the old one (Return)"), self._accept
        )

    def refresh(self) -> None:
        """Show how far it is, and whether the microphone gives sound."""
        self._show_hint()
        self.ring.update()
        self.meter.update()

    def _lay_out(self) -> None:
        for told in (self.title, self.hint, self.advice, self.room):
            told.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.advice.setMinimumHeight(34)
        self.advice.setStyleSheet(f"color: {self._theme.bad}; font-weight: bold")
        for button in (self.accept, self.start):
            button.setStyleSheet(
                f"QToolButton {{ color: {self._theme.on_colour}; background: {self._theme.accent}; border: 0;"
                " border-radius: 4px; padding: 2px 12px; font-weight: bold }"
            )
        for button in (self.sounds, self.play_old, self.play_new):
            button.setCheckable(True)
        self.language.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        heads = column((self.head, 1), row(*tab_buttons(self.play_old, self.play_new, height=28)))
        learned = (self.refuse, self.save, self.accept)
        buttons = tab_buttons(
            self.sounds, self.back, self.again, self.skip, self.cancel, *learned, self.start, height=28
        )
        column(
            self.title,
            self.steps,
            (self.ring, 3),
            self.hint,
            (row((self.figures, 3), (heads, 2)), 3),
            self.advice,
            self.meter,
            self.room,
            row(1, self.language, *buttons, 1),
            on=self,
            margins=(24, 12, 24, 12),
            spacing=8,
        )

    def _connect(self) -> None:
        guide = self._calibration.guide
        self.language.activated.connect(lambda k: guide.choose(LANGUAGES[k], by_sounds=guide.by_sounds))
        for key, buttons in (
            ("Backspace", (self.back,)),
            ("R", (self.again,)),
            ("Right", (self.skip,)),
            ("Return", (self.start, self.accept)),
            ("Escape", (self.cancel, self.refuse)),
        ):
            shortcut = QShortcut(QKeySequence(key), self)
            shortcut.setAutoRepeat(False)
            shortcut.activated.connect(lambda buttons=buttons: _click(*buttons))
        guide.changed.connect(self._show)

    def _play(self, *, new: bool) -> None:
        """Play the sentence; the button of what is playing stays down."""
        self._calibration.play_sentence(new=new)
        self.play_old.setChecked(not new)
        self.play_new.setChecked(new)

    def _accept(self) -> None:
        self._calibration.guide.accept()
        self.accepted.emit()

    def _save(self) -> None:
        self._calibration.guide.accept()
        self.save_asked.emit()

    def _show(self) -> None:
        guide, done = self._calibration.guide, self._calibration.guide.phase is Phase.DONE
        asking, ready = guide.asking, guide.phase is Phase.READY
        self.title.setText(f"<h2>{self._title()}</h2>")
        self._show_hint()
        self.advice.setText(self._advice())
        room = guide.room
        said = (
            tr("Background noise {decibels:.0f} dBFS").format(decibels=_decibels(room.level))
            if room is not None
            else tr("Background noise not measured yet")
        )
        self.room.setText(
            said + "   ·   " + tr("Speaker: {speaker}").format(speaker=self._calibration.takes.speaker or tr("me"))
        )
        for button in (self.skip, self.again):
            button.setVisible(asking)
        for shown in (self.meter, self.room):
            shown.setVisible(asking or ready or guide.phase is Phase.COUNTING)
        self.start.setVisible(ready)
        with silent(self.language):
            self.language.setCurrentIndex(self.language.findData(guide.language))
        self.back.setVisible(asking or done)
        self.language.setVisible(asking or ready)
        self.sounds.setVisible(asking or ready)
        self.sounds.setChecked(guide.by_sounds)
        gains = done and guide.outcome is not None and guide.outcome.gains
        self.cancel.setVisible(not done)
        self.refuse.setVisible(done)
        self.refuse.setText(tr("Keep Old Preset") if gains else tr("Close"))
        self.accept.setVisible(gains)
        self.save.setVisible(gains)
        self.figures.setVisible(done and guide.outcome is not None)
        self.ring.setVisible(not self.figures.isVisibleTo(self))
        for seen in (self.head, self.play_old, self.play_new):
            seen.setVisible(gains and guide.spoken is not None)
        for button in (self.play_old, self.play_new):
            button.setChecked(False)
        if done and guide.outcome is not None:
            self._show_figures(guide.outcome)
        self.steps.update()
        self.ring.update()

    def _show_figures(self, outcome: CalibrationResult) -> None:
        """Show what both presets reach and the difference, or what the old one reaches where nothing was gained."""
        if outcome.gains:
            self.figures.set_columns((tr("Before"), tr("After"), tr("Difference")))
            self.figures.show_scores((outcome.before, outcome.after), outcome.gained)
        else:
            self.figures.set_columns((tr("Old preset"),))
            self.figures.show_scores((outcome.before,))

    def _show_hint(self) -> None:
        guide = self._calibration.guide
        size = 24 if guide.reading else 14 if guide.phase is Phase.DONE else 16
        text = f"<span style='font-size: {size}px'>{self._hint()}</span>"
        if text != self.hint.text():
            self.hint.setText(text)

    def _title(self) -> str:
        guide = self._calibration.guide
        if guide.phase is Phase.LEARNING:
            return tr("Calibrating to your voice")
        if guide.phase is Phase.DONE:
            if guide.outcome is None or not guide.outcome.gains:
                return tr("No improvement found")
            return tr("Your voice is now recognised better") if guide.outcome.is_clear else tr("No clear change")
        if guide.phase in {Phase.READY, Phase.COUNTING}:
            return tr("Guided calibration")
        if guide.step.sentence is None:
            return (
                tr("Measure background noise")
                if guide.step.phoneme is Phoneme.SILENCE
                else tr("Sound {index} of {n}").format(index=guide.index, n=len(SOUNDS))
            )
        return tr("Read aloud in your normal voice") if guide.step.teaches else tr("Now read this test sentence")

    def _hint(self) -> str:
        guide = self._calibration.guide
        if guide.phase is Phase.LEARNING:
            return tr("This takes a few seconds")
        if guide.phase is Phase.DONE:
            return self._found()
        if not self._calibration.session.microphone.listening:
            words = tr_engine(self._calibration.session.microphone.words)
            return f"{words[:1].upper()}{words[1:]}…"
        if guide.phase is Phase.READY:
            return tr(SOUNDS_AHEAD if guide.by_sounds else LINES_AHEAD)
        return tr(guide.step.hint)

    def _found(self) -> str:
        """Return what was learned from, what is measured, and how well background noise is recognised."""
        guide = self._calibration.guide
        if guide.outcome is None:
            return ""
        sure = (
            f"<br>{tr_engine(str(guide.outcome.silence_accuracy))}."
            if guide.outcome.silence_accuracy is not None
            else ""
        )
        unclear = tr(UNCLEAR) + "<br>" if guide.outcome.gains and not guide.outcome.is_clear else ""
        unsaved = f"<br><b>{tr('The new preset is not saved yet.')}</b>" if guide.outcome.gains else ""
        return f"{unclear}{guide.learned_from} {guide.measured_on}{sure}{unsaved}"

    def _advice(self) -> str:
        guide = self._calibration.guide
        if guide.phase is not Phase.DONE or guide.outcome is None:
            return tr_engine(guide.advice)
        return " ".join(tr_engine(said) for said in (guide.outcome.refusal, guide.outcome.warning) if said)


def _click(*buttons: QToolButton) -> None:
    """Click the first one that is seen."""
    for button in buttons:
        if button.isVisible():
            button.click()
            return


def _decibels(amplitude: float) -> float:
    return 20 * math.log10(max(amplitude, 1e-6))
