"""The recognised phoneme in large letters, its intensity, why it was recognised, and the plain measures."""

from typing import Any

from PySide6.QtCore import QRectF
from PySide6.QtGui import QColor, QPainter
from PySide6.QtWidgets import QSizePolicy, QWidget

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.painting import AT_RIGHT, CENTRED, draw_text, set_size
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.theme import PHONEME_COLOURS, Theme
from phonemeanalyser.desktop.widgets.plot_menu import PlotMenu, table_of
from phonemeengine.analyser import latest_reading
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.recognition import RuleComparison, Trace

ROW = 15
"""Height of a line of the trace in pixels."""
MARGIN_WIDTH = 50
"""Room that the margin at a line's right end takes in pixels."""
MARK_WIDTH, NAME_WIDTH, GAP = 16, 40, 8
"""Of a line of the trace, in pixels: the mark, the least room for the name, and what lies between name and words."""
N_ROWS = 10
FLICKER_SECONDS = 3.0
"""Over how long the changes of the phoneme are counted."""
METERS = (
    ("zc", "zero_crossings", "{:.0f}"),
    ("vol", "volume", "{:.3f}"),
    ("e", "energy", "{:.3f}"),
    ("f(g)", "f0", "{:.0f} Hz"),
)


class PhonemeView(QWidget):
    """Paints everything about the newest frame at once, since it changes many times a second."""

    def __init__(self, session: Session, theme: Theme) -> None:
        super().__init__()
        self._session = session
        self._theme = theme
        self.trace: Trace | None = None
        self.phoneme = self.recognised = Phoneme.SILENCE
        self.intensity = 0.0
        self.confidence: float | None = None
        self.changes: float | None = None
        self.input_silent = False
        self.meters: dict[str, str] = {}
        self.menu = PlotMenu(self, "phoneme", lambda _at: self._values())
        self.setMinimumSize(250, 128 + (N_ROWS + 1) * ROW)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Fixed)
        self.setToolTip(
            tr(
                "The phoneme now, its intensity, how sure it is (of a hundred answers that are 80 % sure, eighty are "
                "right), how often the phoneme changed in the last three seconds, the measures of its window of 46 "
                "ms: zc (zero crossings in it), vol (peak level, full scale 1), e (energy: sum of the amplitudes "
                "before denoise and normalise), f(g) (fundamental frequency of a voice, 60 to 500 Hz; a higher tone "
                "has none), and what each rule said, down to the one that fired"
            )
        )

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
        """Whether another phoneme is heard than the one that is shown."""
        newest = self._session.history.newest
        return newest is not None and int(newest.phonemes[-1]) != self.phoneme

    def refresh(self) -> None:
        """Show the newest frame."""
        self.input_silent = self._session.microphone.silent
        newest = None if self.input_silent else self._session.history.newest
        if newest is None:
            self.phoneme = self.recognised = Phoneme.SILENCE
            self.intensity, self.confidence, self.meters = 0.0, None, {}
        else:
            values = newest.features.frame(len(newest) - 1)
            self.phoneme, self.recognised = Phoneme(int(newest.phonemes[-1])), Phoneme(int(newest.recognised[-1]))
            _, self.intensity, self.confidence = latest_reading(newest)
            self.meters = {name: form.format(values[variable]) for name, variable, form in METERS}
            if values["f0"] == 0:
                self.meters["f(g)"] = "–"
        self.changes = None if self.input_silent else self._session.history.changes_per_s(FLICKER_SECONDS)
        self.trace = None if self.input_silent else self._session.results.explain()
        self.setAccessibleName(tr("nothing comes") if self.input_silent else self.phoneme.label)
        self.update()

    def paintEvent(self, _event: Any) -> None:
        """Paint phoneme, intensity, measures and trace from top to bottom."""
        painter = QPainter(self)
        width = self.width() - 16
        self._paint_phoneme(painter, QRectF(8, 4, width, 58))
        self._paint_intensity(painter, QRectF(8, 66, width, 14))
        self._paint_meters(painter, QRectF(8, 84, width, 32))
        if self.trace is not None:
            self._paint_trace(painter, self.trace, QRectF(8, 122, width, ROW))

    def _paint_phoneme(self, painter: QPainter, box: QRectF) -> None:
        colour = QColor(PHONEME_COLOURS[self.phoneme])
        painter.fillRect(box, QColor(colour.red(), colour.green(), colour.blue(), 50))
        painter.fillRect(QRectF(box.left(), box.top(), 5, box.height()), colour)
        name = tr("nothing comes") if self.input_silent else self.phoneme.label
        draw_text(painter, box, name, self._theme.text, 42 if len(name) < 4 else 30, CENTRED)

    def _paint_intensity(self, painter: QPainter, box: QRectF) -> None:
        painter.fillRect(box, QColor(self._theme.raised))
        bar = QRectF(box.left(), box.top(), box.width() * self.intensity, box.height())
        accent = QColor(self._theme.accent)
        painter.fillRect(bar, QColor(accent.red(), accent.green(), accent.blue(), 110))
        inner = box.adjusted(5, 0, -5, 0)
        draw_text(
            painter, inner, tr("intensity {intensity:.2f}").format(intensity=self.intensity), self._theme.text, 10
        )
        if self.confidence is not None:
            draw_text(
                painter,
                inner,
                tr("{percent:.0f} % sure").format(percent=100 * self.confidence),
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
        for k, (name, _, _) in enumerate(METERS):
            place = QRectF(box.left() + k * cell, box.top(), cell, box.height())
            draw_text(painter, place.adjusted(0, 0, 0, -16), name, self._theme.faint, 10)
            draw_text(painter, place.adjusted(0, 14, 0, 0), self.meters.get(name, "–"), self._theme.text, 14)

    def _paint_trace(self, painter: QPainter, trace: Trace, line: QRectF) -> None:
        rows = rows_of(trace)
        set_size(painter, 11)
        widths = [painter.fontMetrics().horizontalAdvance(asked) for _, asked, _ in rows]
        indent = MARK_WIDTH + max([NAME_WIDTH, *widths]) + GAP
        for comparison, asked, fired in rows:
            colour = self._theme.text if fired else self._theme.faint
            mark = self._theme.good if comparison.margin > 0 else self._theme.bad
            draw_text(painter, line, "✓" if comparison.margin > 0 else "✗", mark, 11)
            words = QRectF(line.left() + indent, line.top(), line.width() - indent - MARGIN_WIDTH, ROW)
            draw_text(
                painter, QRectF(line.left() + MARK_WIDTH, line.top(), indent - MARK_WIDTH, ROW), asked, colour, 11
            )
            draw_text(painter, words, _words(comparison), colour, 11)
            draw_text(painter, line, _signed(comparison.margin), mark, 11, AT_RIGHT)
            line = line.translated(0, ROW)
        if not trace.comparisons:
            draw_text(painter, line.adjusted(MARK_WIDTH, 0, 0, 0), trace.rule, self._theme.text, 11)
            line = line.translated(0, ROW)
        if self.recognised is not self.phoneme:
            calmed = tr("statistics: {recognised} → {phoneme}").format(
                recognised=self.recognised.label, phoneme=self.phoneme.label
            )
            draw_text(painter, line.adjusted(MARK_WIDTH, 0, 0, 0), calmed, self._theme.accent, 11)


def rows_of(trace: Trace) -> list[tuple[RuleComparison, str, bool]]:
    """Return a line for each rule that failed (its first failed comparison) and all of the one that fired.

    Where these are more than there is room for, only those rules are told that failed by the least share of a limit,
    each with the comparison that failed by the most.
    """
    failed: dict[str, list[RuleComparison]] = {}
    for comparison in trace.comparisons:
        if comparison.rule != trace.rule and comparison.margin <= 0:
            failed.setdefault(comparison.rule, []).append(comparison)
    room = max(0, N_ROWS - sum(c.rule == trace.rule for c in trace.comparisons))
    told = {rule: reasons[0] for rule, reasons in failed.items()}
    if len(told) > room:
        worst = {rule: min(reasons, key=_share) for rule, reasons in failed.items()}
        nearest = sorted(worst, key=lambda rule: _share(worst[rule]), reverse=True)
        told = {rule: worst[rule] for rule in nearest[:room]}
    rows = [(c, c.rule, c.rule == trace.rule) for c in trace.comparisons]
    return [(c, rule, fired) for c, rule, fired in rows if fired or told.get(rule) is c][:N_ROWS]


def _share(comparison: RuleComparison) -> float:
    return comparison.margin / max(abs(comparison.limit), 1e-9)


def _words(comparison: RuleComparison) -> str:
    """Return what was compared; a variable that ends with its rule's name, such as ``p_silence``, is shortened."""
    variable = comparison.variable.removesuffix(f"_{comparison.rule}")
    return f"{variable} {_short(comparison.value)} {comparison.sign} {_short(comparison.limit)}"


def _short(value: float) -> str:
    return f"{value:.0f}" if abs(value) >= 1000 else f"{value:.3g}"


def _signed(margin: float) -> str:
    return f"{margin:+.0f}" if abs(margin) >= 1000 else f"{margin:+.3g}"
