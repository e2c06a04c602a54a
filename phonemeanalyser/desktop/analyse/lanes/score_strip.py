"""The strip at the bottom of the page: how right what is recognised is, and what a change gained and lost."""

import math
from functools import partial

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QGridLayout, QWidget

from phonemeanalyser.desktop.engine_words import sound_name
from phonemeanalyser.desktop.language import tr, tr_count, tr_noop
from phonemeanalyser.desktop.session.preset import A, B
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.session.time_view import SCOPES, Scope, TimeSpan
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets import builders, figures
from phonemeengine.calibration.scores.scoring import Agreement
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import FRAME_PERIOD

OFFERED = (Scope.SEEN, Scope.WHOLE, Scope.LOADED)
SHOWN = tuple(figure for figure in figures.FIGURES if figure[1] != "vowel_accuracy")
"""The figures that follow from counts alone, and so are there while a threshold is dragged."""
N_CONFUSIONS = 2
"""Confusions that are offered as buttons."""
MOST_PHONEMES = 3
"""Phonemes that are named of those that gained, and of those that lost."""
VALUE_WIDTH = 44
"""Pixels of a figure at least; longer ones ask for more."""
HEADING_SIZE = 10
"""Pixels of the letters above the figures."""
LEAST_WIDTH, MOST_WIDTH = 240, 560
"""Pixels of all figures: where the window is narrow, and where each has room for its difference."""
PARENTHESES = tr_noop("How often the recognised phoneme changes, and in parentheses how often the labels do")


class ScoreStrip(QWidget):
    """Shows the figures of the preset in use, beside those of the other one of A and B.

    Signals
    -------
    takes_asked, labels_asked, script_asked : the user wants labels: by takes, from a file, or from what is said.

    Attributes
    ----------
    scope : the choice of what the figures are of.
    values : the labels of the figures, by letter of the preset (the one in use is "" where it is alone) and name.
    confusions : the buttons of the worst confusions.
    shown : the switch that shows the strip, and hides it.
    """

    takes_asked = Signal()
    labels_asked = Signal()
    script_asked = Signal()

    def __init__(self, session: Session, theme: Theme) -> None:
        super().__init__()
        self._session, self._score, self._theme = session, session.score, theme
        self.scope = builders.choice(
            ((tr(SCOPES[scope]), scope.value) for scope in OFFERED),
            tr("Score of"),
            tr(
                "What the figures are of: the visible part of the file, the whole file, or all takes and recordings "
                "loaded in Calibrate together with the open file"
            ),
        )
        self.of_what = builders.ElidedLabel()
        self.why_not = builders.ElidedLabel()
        self.ways = QWidget()
        self.figures = QWidget()
        self.values = {
            (letter, name): builders.StillLabel(VALUE_WIDTH) for letter in (A, B, "-") for _, name, _, _ in SHOWN
        }
        self._headings = {letter: builders.label() for letter in (A, B, "-")}
        self.gained, self.lost = builders.ElidedLabel(), builders.ElidedLabel()
        self.gained.setStyleSheet(f"color: {theme.good}")
        self.lost.setStyleSheet(f"color: {theme.bad}")
        tip = tr("Go to an example of this confusion")
        self.confusions = [
            builders.tool_button("", tip, act=partial(self._show_example, k)) for k in range(N_CONFUSIONS)
        ]
        self._worst: list[tuple[Phoneme, Phoneme, int]] = []
        self.shown = QAction(tr("Score"), self, checkable=True, checked=True)
        self.shown.toggled.connect(self.setVisible)
        self._lay_out()
        self.scope.setCurrentIndex(self.scope.findData(self._score.scope.value))
        self.scope.currentIndexChanged.connect(lambda _k: self._score.choose(Scope(self.scope.currentData())))
        self._score.changed.connect(self.refresh)
        self.refresh()

    def _lay_out(self) -> None:
        self.setAccessibleName(tr("Score"))
        self.scope.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        ways = (
            builders.tool_button(
                tr("Record Takes"), tr("Hold a key in Calibrate while you say a sound"), act=self.takes_asked.emit
            ),
            builders.tool_button(
                tr("Load Labels"), tr("Load a TextGrid, or labels of Audacity or CSV"), act=self.labels_asked.emit
            ),
            builders.tool_button(
                tr("Enter Script"),
                tr("Enter in Talk what is said, align it, and save the TextGrid beside the sound"),
                act=self.script_asked.emit,
            ),
        )
        builders.row(*ways, on=self.ways, spacing=6)
        builders.tab_buttons(*ways, *self.confusions)
        figures = builders.grid(self.figures, across=6, down=0)
        self._fill(figures)
        self.figures.setMinimumWidth(LEAST_WIDTH)
        self.figures.setMaximumWidth(MOST_WIDTH)
        above = builders.row(
            self.scope, (self.of_what, 3), (self.gained, 4), (self.lost, 4), (self.why_not, 1), spacing=8
        )
        below = builders.row(
            (self.figures, 1000), self.ways, 1, builders.column(*self.confusions, 1, spacing=2), spacing=8
        )
        builders.column(above, below, on=self, margins=(6, 3, 6, 3), spacing=2)

    def _fill(self, figures: QGridLayout) -> None:
        for at, letter in enumerate((A, B, "-"), 1):
            figures.addWidget(self._headings[letter], at, 0)
        for k, (text, name, _, tip) in enumerate(SHOWN, 1):
            of_heading = tr(PARENTHESES if name == "changes_per_s" else tip)
            heading = builders.named(builders.ElidedLabel(tr(text), asks=True), tip=f"{tr(text)}: {of_heading}")
            heading.setStyleSheet(f"color: {self._theme.faint}; font-size: {HEADING_SIZE}px")
            figures.addWidget(heading, 0, k)
            figures.setColumnStretch(k, 1)
            for at, letter in enumerate((A, B, "-"), 1):
                figures.addWidget(self.values[letter, name], at, k, Qt.AlignmentFlag.AlignLeft)

    # -- what is shown ------------------------------------------------------------------------------------

    def refresh(self) -> None:
        """Show the figures as they are."""
        score, preset = self._score, self._session.preset
        why_not, agreement = score.why_not, score.agreement
        self.why_not.setText(why_not)
        self.of_what.setText(self._of_what())
        self.of_what.setToolTip(self._of_what())
        self.why_not.setToolTip(why_not)
        if not why_not:
            self.ways.hide()  # before what takes its place is shown, and shown after that: both widen the window
        for part, is_shown in (
            (self.why_not, bool(why_not)),
            (self.of_what, not why_not),
            (self.figures, agreement is not None),
        ):
            part.setVisible(is_shown)
        both = preset.other is not None
        letters = {A: preset.letter == A or both, B: preset.letter == B or both, "-": both}
        for letter, is_shown in letters.items():
            self._headings[letter].setVisible(is_shown and both)
            for _, name, _, _ in SHOWN:
                self.values[letter, name].setVisible(is_shown)
        if agreement is None:
            for written in (*self._headings.values(), *self.values.values()):
                written.clear()  # which a screen reader would still find
            for button in self.confusions:
                button.setText("")
        else:
            self._show(agreement)
        self._show_changes(agreement)
        self._show_confusions(agreement)
        self.ways.setVisible(bool(why_not))

    def _show(self, agreement: Agreement) -> None:
        score, preset = self._score, self._session.preset
        sides = {preset.letter: agreement, preset.other_letter: score.other}
        of_what = self._of_what()
        for letter, used in preset.sides.items():
            self._headings[letter].setText(f"<b>{letter}</b>" if letter == preset.letter else letter)
            self._headings[letter].setToolTip(used.name)
        self._headings["-"].setText("B − A")
        for heading, name, more_is_better, tip in SHOWN:
            sign = 1 if more_is_better else -1
            for letter, side in sides.items():
                text = "…" if side is None else _figure(side, name)
                before = score.before if letter == preset.letter else None
                gain = math.nan if before is None or side is None else _gain(name, side, before)
                self._write(letter, name, text, gain, sign, bold=letter == preset.letter)
                self.values[letter, name].setToolTip(self._about(tip, of_what, letter, side, before, name))
                self.values[letter, name].setAccessibleName(f"{tr(heading)} {letter if score.other else ''} {text}")
            one, other = sides[A], sides[B]
            gain = math.nan if one is None or other is None else _gain(name, other, one)
            self._write("-", name, "", gain, sign, bold=False)

    def _write(self, letter: str, name: str, text: str, gain: float, sign: int, *, bold: bool) -> None:
        colour = self._theme.faint if self._score.outdated else ""
        words = f"<b>{text}</b>" if bold else text
        words = f"<span style='color:{colour}'>{words}</span>" if colour else words
        if not math.isnan(gain):
            shown = _signed(gain if name.endswith("per_s") else 100 * gain)
            words += f" <span style='color:{figures.colour_of_gain(sign * gain, self._theme)}'>{shown}</span>"
        self.values[letter, name].setText(words.strip())

    def _about(
        self, tip: str, of_what: str, letter: str, side: Agreement | None, before: Agreement | None, name: str
    ) -> str:
        """Say what a figure means, of what it is, of which preset, and since when its difference counts."""
        parts = [tr(tip), of_what]
        preset = self._session.preset.sides.get(letter)
        parts += [] if preset is None else [tr("Preset: {preset}{changed}").format(preset=preset.name, changed="")]
        parts += [] if side is None or name != "macro_f1" else [figures.classes_in_words(side)]
        if before is not None:
            since = tr("Difference since this change began: it was {before}.")
            parts.append(since.format(before=figures.figure_in_words(name, float(getattr(before, name)))))
        return "".join(f"<p>{part}</p>" for part in parts if part)

    def _of_what(self) -> str:
        """Say of what the figures are: which sound, how much of it is labelled, of whom."""
        score = self._score
        if score.why_not or (score.agreement is None and not score.outdated):
            return ""
        seconds = 0.0 if score.agreement is None else score.agreement.seconds
        length = tr("{minutes:.1f} min labelled").format(minutes=seconds / 60)
        if seconds < 60:
            length = tr("{seconds:.1f} s labelled").format(seconds=seconds)
        name = "" if score.file is None else score.file.name
        n, n_voices = score.voices
        what = {
            Scope.SEEN: tr("{name}, {start:.1f}–{end:.1f} s").format(
                name=name, start=score.span[0], end=score.span[1]
            ),
            Scope.WHOLE: name,
            Scope.LOADED: tr_count("1 recording", "{n} recordings", n)
            + " "
            + tr_count("of 1 speaker", "of {n} speakers", n_voices)
            + (tr(" and the open file") if score.adds_file else ""),
        }[score.scope]
        return f"{length}: {what}" + (f" · {tr('analysing…')}" if score.outdated else "")

    def _show_changes(self, agreement: Agreement | None) -> None:
        before = self._score.before
        gains = {} if before is None or agreement is None else agreement.gains_over(before)
        better = [(p, gain) for p, gain in gains.items() if gain > figures.LEAST_GAIN]
        worse = [(p, gain) for p, gain in reversed(gains.items()) if gain < -figures.LEAST_GAIN]
        for shown, text, found in (
            (self.gained, tr("Gained: {phonemes}"), better),
            (self.lost, tr("Lost: {phonemes}"), worse),
        ):
            shown.setVisible(bool(found))
            shown.setText(text.format(phonemes=_listed(found[:MOST_PHONEMES])))
            tip = tr("F1 of each phoneme since this change began, in percentage points: {phonemes}")
            shown.setToolTip(tip.format(phonemes=_listed(found)))

    def _show_confusions(self, agreement: Agreement | None) -> None:
        self._worst = [] if agreement is None else agreement.worst_confusions(N_CONFUSIONS)
        for k, button in enumerate(self.confusions):
            room = button.sizePolicy()
            room.setRetainSizeWhenHidden(self._score.file is not None)  # its lanes stay when labels come or go
            button.setSizePolicy(room)
            button.setVisible(k < len(self._worst))
            if k < len(self._worst):
                truth, answer, n = self._worst[k]
                said, recognised, seconds = sound_name(truth), sound_name(answer), n * FRAME_PERIOD
                button.setText(f"{said} → {recognised} {seconds:.1f} s")
                words = tr("{said} recognised as {recognised} for {seconds:.1f} s in total: go to an example")
                tip = words.format(said=said, recognised=recognised, seconds=seconds)
                builders.named(button, tip, tip)

    def _show_example(self, k: int) -> None:
        truth, answer, _ = self._worst[k]
        found, session = self._score.next_example(truth, answer), self._session
        if found is not None and (found.path == session.path or session.open(found.path)):
            session.show_segment(TimeSpan(found.start, found.end), found.start)


def _figure(agreement: Agreement, name: str) -> str:
    text = figures.figure_in_words(name, float(getattr(agreement, name)))
    if name != "changes_per_s":
        return text
    return f"{text} ({figures.figure_in_words(name, agreement.label_changes_per_s)})"


def _gain(name: str, after: Agreement, before: Agreement) -> float:
    return float(getattr(after, name)) - float(getattr(before, name))


def _signed(number: float) -> str:
    """Write a difference with its sign, to one digit."""
    return "±0.0" if abs(number) < 0.05 else f"{number:+.1f}".replace("-", "−")


def _listed(gains: list[tuple[Phoneme, float]]) -> str:
    return ", ".join(f"{sound_name(p)} {_signed(100 * gain)}" for p, gain in gains)
