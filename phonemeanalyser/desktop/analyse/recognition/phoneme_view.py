"""The recognised phoneme in large letters, its intensity, why it was recognised, and the plain measures."""

from collections import Counter, deque
from html import escape
from typing import Any

from PySide6.QtCore import QEvent, QPoint, QRectF
from PySide6.QtGui import QColor, QHelpEvent, QPainter
from PySide6.QtWidgets import QSizePolicy, QToolTip, QWidget
from typing_extensions import override

from phonemeanalyser.desktop.engine_words import sound_name, tr_engine
from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.session.preset import pitch_set_in_words, pitch_set_name
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.theme import AT_RIGHT, CENTRED, PHONEME_COLOURS, Theme, draw_text, set_size
from phonemeanalyser.desktop.widgets.plot import PlotMenu, table_of
from phonemeengine.analyser import latest_reading
from phonemeengine.features.variables import readable_name
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.scores import RuleComparison, Trace
from phonemeengine.settings import FRAME_PERIOD

ROW = 15
"""Height of a line of the trace in pixels."""
MARGIN_WIDTH = 50
"""Room that the margin at a line's right end takes in pixels."""
MARK_WIDTH, NAME_WIDTH, GAP = 16, 40, 8
"""Of a line of the trace, in pixels: the mark, the least room for the name, and what lies between name and words."""
N_ROWS = 10
FLICKER_SECONDS = 3.0
"""Over how long the changes of the phoneme are counted."""
FLICKERS = 12.0
"""Changes a second from which the trace names the comparison that turns most: speech has about 9."""
METERS = (
    ("zc", "zero_crossings", "{:.0f}", tr_noop("Zero crossings in the current window of 46.4 ms")),
    ("vol", "volume", "{:.3f}", tr_noop("Volume: peak level in the current window of 46.4 ms, full scale 1")),
    ("e", "energy", "{:.3f}", tr_noop("Energy: sum of the amplitudes of the spectrum before denoise and normalise")),
    ("f(g)", "f0", "{:.0f} Hz", tr_noop("Fundamental frequency of a voice, 60 to 500 Hz; a higher tone has none")),
)
"""What is measured: name, variable, form and tip."""
PHONEME_TIP = tr_noop("Phoneme recognised in the current frame")
INTENSITY_TIP = tr_noop("Intensity of the current frame: 0 to 1 between the two levels of the filter Intensity")
CONFIDENCE_TIP = tr_noop(
    "Estimated probability that the phoneme is right, fitted on labelled speech: of 100 answers with 80 %, 80 are "
    "right"
)
CHANGES_TIP = tr_noop(
    "Phoneme changes per second, over the last 3 seconds; speech has about 9. A preset with more smoothing, such as "
    "thesis-calm, changes less often"
)
TRACE_TIP = tr_noop(
    "What each rule compared in the current frame, down to the one that fired: value, limit, and the margin by which "
    "the comparison held (✓) or failed (✗)"
)


class PhonemeView(QWidget):
    """Paints everything about the newest frame at once, since it changes many times a second."""

    def __init__(self, session: Session, theme: Theme) -> None:
        super().__init__()
        self._session = session
        self._theme = theme
        self.trace: Trace | None = None
        self._turned: deque[tuple[int, RuleComparison]] = deque()  # with the number of the frame
        self.phoneme = self.recognised = Phoneme.SILENCE
        self.intensity = 0.0
        self.confidence: float | None = None
        self.changes: float | None = None
        self.input_silent = False
        self.pitch_set = self.about_set = ""
        self.meters: dict[str, str] = {}
        self.menu = PlotMenu(self, "phoneme", lambda _at: self._values())
        self.setMinimumSize(250, 128 + (N_ROWS + 1) * ROW)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Fixed)

    @override
    def event(self, event: QEvent) -> bool:
        if event.type() == QEvent.Type.ToolTip and isinstance(event, QHelpEvent):
            QToolTip.showText(event.globalPos(), f"<p>{self.tip_at(event.pos())}</p>", self)
            return True
        return super().event(event)

    def tip_at(self, at: QPoint) -> str:
        """Return what the value at a place is, and of what."""
        phoneme, intensity, meters, line = self._boxes()
        if at.y() < phoneme.bottom():
            return f"{tr(PHONEME_TIP)}</p><p>{self.about_set}" if self.about_set else tr(PHONEME_TIP)
        if at.y() < intensity.bottom() + 2:
            third = int(3 * (at.x() - intensity.left()) / intensity.width())
            return tr((INTENSITY_TIP, CONFIDENCE_TIP, CHANGES_TIP)[min(max(third, 0), 2)])
        if at.y() < meters.bottom():
            cell = int(len(METERS) * (at.x() - meters.left()) / meters.width())
            return tr(METERS[min(max(cell, 0), len(METERS) - 1)][3])
        rows = [] if self.trace is None else rows_of(self.trace, self._n_rows)
        row = int((at.y() - line.top()) / ROW)
        if not 0 <= row < len(rows):
            return tr(TRACE_TIP)
        comparison, rule, _ = rows[row]
        variable = comparison.variable
        named = dict.fromkeys((self._readable(variable), variable))
        told = f"{' · '.join(named)}: {_short(comparison.value)} {comparison.sign} {_short(comparison.limit)}"
        return f"{escape(f'{tr_engine(rule)}: {told} ({_signed(comparison.margin)})')}</p><p>{tr(TRACE_TIP)}"

    def _boxes(self) -> tuple[QRectF, QRectF, QRectF, QRectF]:
        """Return where phoneme, intensity, measures and the trace's first line are."""
        width = self.width() - 16
        return QRectF(8, 4, width, 58), QRectF(8, 66, width, 14), QRectF(8, 84, width, 32), QRectF(8, 122, width, ROW)

    def _values(self) -> str:
        """Return what is shown as a table, with every comparison of the rules."""
        named: list[tuple[str, object]] = [("phoneme", self.phoneme.label), ("recognised", self.recognised.label)]
        named += [("intensity (0..1)", self.intensity), *self.meters.items()]
        compared = () if self.trace is None else self.trace.comparisons
        rows: list[tuple[object, ...]] = [(*pair, "", "", "") for pair in named]
        rows += [(f"{c.rule}: {c.variable}", c.value, c.sign, c.limit, c.margin) for c in compared]
        return table_of(dict(zip(("what", "value", "sign", "limit", "margin"), zip(*rows, strict=True), strict=True)))

    @property
    def is_outdated(self) -> bool:
        """Whether another phoneme is recognised than the one that is shown."""
        newest = self._session.history.newest
        return newest is not None and int(newest.phonemes[-1]) != self.phoneme

    def refresh(self) -> None:
        """Show the newest frame."""
        self.input_silent = self._session.microphone.silent
        newest = None if self.input_silent else self._session.history.newest
        if newest is None:
            self.phoneme = self.recognised = Phoneme.SILENCE
            self.intensity, self.confidence, self.meters = 0.0, None, {}
            self.pitch_set = self.about_set = ""
        else:
            values = newest.features.frame(len(newest) - 1)
            self.phoneme, self.recognised = Phoneme(int(newest.phonemes[-1])), Phoneme(int(newest.recognised[-1]))
            _, self.intensity, self.confidence = latest_reading(newest)
            preset = self._session.preset.in_force
            self.pitch_set, self.about_set = pitch_set_name(preset, values), pitch_set_in_words(preset, values)
            self.meters = {name: form.format(values[variable]) for name, variable, form, _ in METERS}
            if values["f0"] == 0:
                self.meters["f(g)"] = "–"
        self.changes = None if self.input_silent else self._session.history.changes_per_s(FLICKER_SECONDS)
        before, self.trace = self.trace, None if self.input_silent else self._session.results.explain()
        self._note_turn(before)
        self.setAccessibleName(tr("No signal") if self.input_silent else sound_name(self.phoneme))
        self.update()

    def _note_turn(self, before: Trace | None) -> None:
        """Remember which comparison turned where another phoneme is recognised than before."""
        now = self._session.history.n
        if before is None or self.trace is None:
            self._turned.clear()
        elif before.phoneme != self.trace.phoneme and (turned := self.trace.turned_since(before)):
            self._turned.append((now, turned))
        while self._turned and not now - FLICKER_SECONDS / FRAME_PERIOD < self._turned[0][0] <= now:
            self._turned.popleft()

    @property
    def flicker(self) -> str:
        """Which comparison turned most, where the phoneme changes more often than speech does; empty where not."""
        if self.changes is None or self.changes < FLICKERS or not self._turned:
            return ""
        counted = Counter((c.variable, c.threshold) for _, c in self._turned)
        (most, n), *_ = counted.most_common(1)
        last = next(c for _, c in reversed(self._turned) if (c.variable, c.threshold) == most)
        words = tr("Changes often: {variable} crossed {limit} in {n} of {all} changes seen")
        named = self._readable(last.variable)
        return words.format(variable=named, limit=_short(last.limit), n=n, all=len(self._turned))

    @property
    def _n_rows(self) -> int:
        """How many comparisons there is room for; what is said of flicker takes a row."""
        return N_ROWS - bool(self.flicker)

    @override
    def paintEvent(self, _event: Any) -> None:
        painter = QPainter(self)
        phoneme, intensity, meters, line = self._boxes()
        self._paint_phoneme(painter, phoneme)
        self._paint_intensity(painter, intensity)
        self._paint_meters(painter, meters)
        if self.trace is not None:
            self._paint_trace(painter, self.trace, line)

    def _paint_phoneme(self, painter: QPainter, box: QRectF) -> None:
        colour = QColor(PHONEME_COLOURS[self.phoneme])
        painter.fillRect(box, QColor(colour.red(), colour.green(), colour.blue(), 50))
        painter.fillRect(QRectF(box.left(), box.top(), 5, box.height()), colour)
        name = tr("No signal") if self.input_silent else sound_name(self.phoneme)
        draw_text(painter, box, name, self._theme.text, 42 if len(name) < 4 else 30, CENTRED)
        draw_text(painter, box.adjusted(11, 40, 0, 0), self.pitch_set, self._theme.faint, 10)

    def _paint_intensity(self, painter: QPainter, box: QRectF) -> None:
        painter.fillRect(box, QColor(self._theme.raised))
        bar = QRectF(box.left(), box.top(), box.width() * self.intensity, box.height())
        accent = QColor(self._theme.accent)
        painter.fillRect(bar, QColor(accent.red(), accent.green(), accent.blue(), 110))
        inner = box.adjusted(5, 0, -5, 0)
        draw_text(
            painter, inner, tr("Intensity {intensity:.2f}").format(intensity=self.intensity), self._theme.text, 10
        )
        if self.confidence is not None:
            draw_text(
                painter,
                inner,
                tr("Confidence {percent:.0f} %").format(percent=100 * self.confidence),
                self._theme.text,
                10,
                CENTRED,
            )
        if self.changes is not None:
            draw_text(
                painter,
                inner,
                tr("{changes:.1f} changes/s").format(changes=self.changes),
                self._theme.text,
                10,
                AT_RIGHT,
            )

    def _paint_meters(self, painter: QPainter, box: QRectF) -> None:
        cell = box.width() / len(METERS)
        for k, (name, *_) in enumerate(METERS):
            place = QRectF(box.left() + k * cell, box.top(), cell, box.height())
            draw_text(painter, place.adjusted(0, 0, 0, -16), name, self._theme.faint, 10)
            draw_text(painter, place.adjusted(0, 14, 0, 0), self.meters.get(name, "–"), self._theme.text, 14)

    def _paint_trace(self, painter: QPainter, trace: Trace, line: QRectF) -> None:
        rows = [(comparison, tr_engine(rule), fired) for comparison, rule, fired in rows_of(trace, self._n_rows)]
        set_size(painter, 11)
        widths = [painter.fontMetrics().horizontalAdvance(asked) for _, asked, _ in rows]
        indent = MARK_WIDTH + max([NAME_WIDTH, *widths]) + GAP
        for comparison, asked, fired in rows:
            colour = self._theme.text if fired else self._theme.faint
            mark = self._theme.good if comparison.margin > 0 else self._theme.bad
            draw_text(painter, line, "✓" if comparison.margin > 0 else "✗", mark, 11)
            words = QRectF(line.left() + indent, line.top(), line.width() - indent - MARGIN_WIDTH, ROW)
            told = self._words_in(painter, comparison, words.width())
            draw_text(
                painter, QRectF(line.left() + MARK_WIDTH, line.top(), indent - MARK_WIDTH, ROW), asked, colour, 11
            )
            draw_text(painter, words, told, colour, 11)
            draw_text(painter, line, _signed(comparison.margin), mark, 11, AT_RIGHT)
            line = line.translated(0, ROW)
        if not trace.comparisons:
            draw_text(painter, line.adjusted(MARK_WIDTH, 0, 0, 0), tr_engine(trace.rule), self._theme.text, 11)
            line = line.translated(0, ROW)
        if flicker := self.flicker:
            draw_text(painter, line, flicker, self._theme.bad, 11)
            line = line.translated(0, ROW)
        if self.recognised is not self.phoneme:
            calmed = tr("Smoothing: {recognised} → {phoneme}").format(
                recognised=sound_name(self.recognised), phoneme=sound_name(self.phoneme)
            )
            draw_text(painter, line.adjusted(MARK_WIDTH, 0, 0, 0), calmed, self._theme.accent, 11)

    def _words_in(self, painter: QPainter, comparison: RuleComparison, width: float) -> str:
        """Return what was compared, with what the variable measures where there is room, else with its short name."""
        told = _words(comparison, self._readable(comparison.variable))
        set_size(painter, 11)
        has_room = painter.fontMetrics().horizontalAdvance(told) <= width
        return told if has_room else _words(comparison, comparison.variable.removesuffix(f"_{comparison.rule}"))

    def _readable(self, variable: str) -> str:
        return tr_engine(readable_name(variable, self._session.preset.preset.variables))


def rows_of(trace: Trace, n_rows: int = N_ROWS) -> list[tuple[RuleComparison, str, bool]]:
    """Return a line for each rule that failed (its first failed comparison) and all of the one that fired.

    Where these are more than fit, only those rules are listed that failed by the least share of a limit,
    each with the comparison that failed by the most.
    """
    failed: dict[str, list[RuleComparison]] = {}
    for comparison in trace.comparisons:
        if comparison.rule != trace.rule and comparison.margin <= 0:
            failed.setdefault(comparison.rule, []).append(comparison)
    room = max(0, n_rows - sum(c.rule == trace.rule for c in trace.comparisons))
    told = {rule: reasons[0] for rule, reasons in failed.items()}
    if len(told) > room:
        worst = {rule: min(reasons, key=_share) for rule, reasons in failed.items()}
        nearest = sorted(worst, key=lambda rule: _share(worst[rule]), reverse=True)
        told = {rule: worst[rule] for rule in nearest[:room]}
    rows = [(c, c.rule, c.rule == trace.rule) for c in trace.comparisons]
    return [(c, rule, fired) for c, rule, fired in rows if fired or told.get(rule) is c][:n_rows]


def _share(comparison: RuleComparison) -> float:
    return comparison.margin / max(abs(comparison.limit), 1e-9)


def _words(comparison: RuleComparison, variable: str) -> str:
    """Return what was compared, with a name of the variable."""
    return f"{variable} {_short(comparison.value)} {comparison.sign} {_short(comparison.limit)}"


def _short(value: float) -> str:
    return f"{value:.0f}" if abs(value) >= 1000 else f"{value:.3g}"


def _signed(margin: float) -> str:
    return f"{margin:+.0f}" if abs(margin) >= 1000 else f"{margin:+.3g}"
