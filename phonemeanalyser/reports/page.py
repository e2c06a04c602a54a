"""A report as a page: one file that holds all it needs, for the screen and for paper."""

import math
from collections.abc import Iterable, Iterator, Sequence

import numpy as np

from phonemeanalyser.reports.charts import difference_map, f1_bars, heat_map
from phonemeanalyser.reports.lanes import drawn_seconds, time_lines
from phonemeanalyser.reports.markup import element, text
from phonemeanalyser.reports.report import CLASSES, FIGURES, Report, flicker_of, look_ahead_of, printable, written
from phonemeanalyser.reports.style import style
from phonemeanalyser.reports.tables import (
    differences_table,
    dot,
    gains_table,
    group_table,
    mistakes_table,
    phoneme_table,
    stretches_table,
)
from phonemeengine.calibration.scores.comparison import PresetComparison
from phonemeengine.calibration.scores.evaluation import GroupScores, Predictions
from phonemeengine.calibration.scores.scoring import SCORED_PHONEMES
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.segments import count_changes
from phonemeengine.settings import FRAME_PERIOD

SPOKEN_FRAMES = 50
"""Frames of the nine sounds that a recording should have to be drawn as an example."""
HEADLINES = ("macro_f1", "viseme_accuracy", "vowel_accuracy", "silence_recall", "false_silence")
"""The figures that the page begins with; the changes follow."""


NINE = tuple(p for p in SCORED_PHONEMES if p is not Phoneme.SILENCE)


def page_of(report: Report) -> str:
    """Write a report as HTML in ASCII that is well-formed XML too, and asks the network for nothing."""
    title = f"{' against '.join(p.title for p in report.presets)} on {report.name}"
    head = element(
        "head",
        element("meta", charset="utf-8"),
        element("meta", name="viewport", content="width=device-width, initial-scale=1"),
        element("title", text(title)),
        element("style", style()),
    )
    body = element("body", _header(report), *_sections(report))
    page = f"<!DOCTYPE html>\n{element('html', head, body, lang='en')}\n"
    return page.encode("ascii", errors="xmlcharrefreplace").decode("ascii")


def _sections(report: Report) -> Iterator[str]:
    groups = [preset.scores.overall for preset in report.presets]
    yield _section("By kind of speech and speaker", "", group_table(report))
    by_phoneme = element("div", f1_bars(groups), phoneme_table(groups), class_="pair")
    yield _section("By phoneme", "F1 of each class, of 1 at best.", by_phoneme)
    yield _section(
        "Confusion",
        "What was said (rows) and what was answered (columns), in percent of the frames of a row.",
        _maps(report),
    )
    if report.comparison is not None:
        yield from _compared(report, report.comparison)
    words = "Strips in red mark frames where an answer is wrong; the grey curve is the intensity"
    words += "." if len(groups) == 1 else " that A gives."
    colours = element("p", *(element("span", dot(p), text(p.label)) for p in CLASSES), class_="keys")
    yield _section("Time lines", words, colours, *_lines(report))
    yield _section("What the figures mean", "", _definitions())


def _header(report: Report) -> str:
    names = [
        element(
            "p",
            _key(k) + element("b", text(preset.title)) + " · " if len(report.presets) > 1 else "",
            text(f"recogniser {preset.scores.preset.recogniser}, look-ahead {look_ahead_of(preset.scores)}"),
            class_="preset",
        )
        for k, preset in enumerate(report.presets)
    ]
    return element(
        "header",
        element("h1", text(f"{' against '.join(p.title for p in report.presets)}")),
        element("p", text(f"{report.name}: {report.conditions}"), class_="faint"),
        *names,
        *(element("p", text(sentence), class_="note") for sentence in report.left_out),
        element("div", *_tiles([preset.scores.overall for preset in report.presets]), class_="tiles"),
    )


def _key(k: int) -> str:
    letter = "AB"[k]
    return element("i", class_="key", style=f"background:var(--{letter.lower()})") + f"{letter} "


def _tiles(groups: Sequence[GroupScores]) -> Iterator[str]:
    titles = {f.field: f.title for f in FIGURES}
    for field in HEADLINES:
        yield _tile(titles[field], [written(getattr(group.scores, field)) for group in groups])
    labels = groups[0].scores.label_changes_per_s
    changes = [f"{written(group.scores.changes_per_s, 1)}" for group in groups]
    times = " and ".join(f"{written(flicker_of(group), 1)} ×" for group in groups)
    yield _tile("Changes per second", changes, f"{times} the labels’ {written(labels, 1)}")


def _tile(name: str, values: Sequence[str], below: str = "") -> str:
    if len(values) == 1:
        shown = [element("div", text(values[0]), class_="value")]
    else:
        shown = [element("div", text(v), class_=f"value {'ab'[k]}") for k, v in enumerate(values)]
    note = element("div", text(below), class_="name") if below else ""
    return element("div", element("div", text(name), class_="name"), *shown, note, class_="tile")


def _maps(report: Report) -> str:
    figures = [
        element(
            "figure",
            element("figcaption", _key(k) if len(report.presets) > 1 else "", element("b", text(preset.title))),
            heat_map(preset.scores.overall.confusion, f"Confusion of {preset.title}", f"f{'ab'[k]}"),
        )
        for k, preset in enumerate(report.presets)
    ]
    if report.comparison is not None:
        words = "A − B, in points of percent: coloured as the preset that answers so more often."
        figures.append(element("figure", element("figcaption", words), difference_map(report.comparison)))
    groups = [preset.scores.overall for preset in report.presets]
    figures.append(element("div", element("b", "The most frequent mistakes"), mistakes_table(groups)))
    return element("div", *figures, class_="pair")


def _compared(report: Report, comparison: PresetComparison) -> Iterator[str]:
    one, other = (preset.title for preset in report.presets)
    tables = element("div", gains_table(comparison), differences_table(report, comparison), class_="pair")
    yield _section(
        "What each gets right that the other misses",
        f"A is {one}, B is {other}; frames of 10 ms, and the recordings with the greatest difference.",
        tables,
    )
    lists = [
        element("div", element("h3", heading), stretches_table(report, stretches, wrong))
        for heading, stretches, wrong in (
            ("Only A is right", comparison.stretches_one, "B"),
            ("Only B is right", comparison.stretches_other, "A"),
        )
    ]
    yield _section("The longest of these", "", element("div", *lists, class_="pair"))


def _lines(report: Report) -> Iterator[str]:
    letters = "AB" if len(report.presets) > 1 else ["answers"]
    for name, k in _chosen(report):
        heard = [preset.scores.predictions[k] for preset in report.presets]
        utterance = heard[0].utterance
        rights = " and ".join(f"{100 * _right(a):.0f} %" for a in heard)
        flickers = " and ".join(f"{_changes(a):.1f}" for a in heard)
        seconds = len(heard[0].phonemes) * FRAME_PERIOD
        cut = f" The first {drawn_seconds():g} s of {seconds:.1f} s." if seconds > drawn_seconds() else ""
        speech = heard[0].intensities[heard[0].labels.phonemes != Phoneme.SILENCE]
        loud = f"; mean intensity of speech {speech.mean():.2f}" if len(speech) else ""
        caption = f"{rights} right; {flickers} changes per second{loud}.{cut}"
        yield element(
            "figure",
            element(
                "figcaption",
                element("b", text(f"{name}: ")),
                text(f"{report.name_of(utterance)}, {printable(utterance.speaker)} · "),
                element("span", text(caption), class_="faint"),
            ),
            time_lines(heard, list(letters)),
        )


def _chosen(report: Report) -> Iterable[tuple[str, int]]:
    """Choose the recordings that are drawn, each once: the first that is asked for names it."""
    rights = np.array([_right(a) for a in report.first.predictions])
    spoken = np.array([np.isin(a.labels.phonemes, NINE).sum() for a in report.first.predictions])
    fit = spoken >= min(SPOKEN_FRAMES, spoken.max())
    ranked = [int(k) for k in np.argsort(-rights, kind="stable") if fit[k] and not math.isnan(rights[k])]
    found: dict[int, str] = {}
    if ranked:
        by = " by A" if report.comparison else ""
        for name, k in (("Best", 0), ("Median", len(ranked) // 2), ("Worst", -1)):
            found.setdefault(ranked[k], f"{name} recognised{by}")
    if report.comparison is not None:
        places = {a.utterance.path: k for k, a in enumerate(report.first.predictions)}
        ahead = sorted(report.comparison.differences, key=lambda d: d.n_other - d.n_one)
        for letter, d in (("A", ahead[0]), ("B", ahead[-1])):
            found.setdefault(places[d.utterance.path], f"{letter} the furthest ahead")
    return ((name, k) for k, name in found.items())


def _right(heard: Predictions) -> float:
    counts = np.isin(heard.labels.phonemes, SCORED_PHONEMES)
    return float(heard.right[counts].mean()) if counts.any() else math.nan


def _changes(heard: Predictions) -> float:
    return count_changes(heard.phonemes) / max(1, len(heard.phonemes)) / FRAME_PERIOD


def _definitions() -> str:
    rows = [
        *((f.title, f.meaning) for f in FIGURES),
        ("Changes", "of the recognised phoneme in a second, and divided by those of the labels: at best 1"),
        ("Mean intensity", "of the frames labelled as speech, 0..1"),
        ("Frames", "every 10 ms, at their middles; only the mouth shapes count where no one of the ten is labelled"),
    ]
    return element("dl", *(element("dt", text(a)) + element("dd", text(b)) for a, b in rows))


def _section(heading: str, words: str, *content: str) -> str:
    intro = element("p", text(words), class_="faint") if words else ""
    return element("section", element("h2", text(heading)), intro, *content)
