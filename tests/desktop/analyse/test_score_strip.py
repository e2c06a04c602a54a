"""The score at the bottom of the page: of what is seen, of the file, of everything loaded, while one tunes."""

import re
import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import Qt

from phonemeanalyser.desktop.session.time_view import Scope, TimeSpan
from phonemeengine.calibration.scores.corpus import read_recordings
from phonemeengine.calibration.scores.evaluation import score
from phonemeengine.calibration.scores.scoring import Agreement
from phonemeengine.labels.textgrid import Tier
from phonemeengine.labels.tiers import write_tiers
from phonemeengine.labels.utterance import RawLabel
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import load_preset, preset_path
from phonemeengine.presets.preset import Preset
from tests.desktop.calibrate.calibrating import corpus
from tests.desktop.hands import CARDS, click, press, shown


@pytest.fixture
def window(desktop, qtbot):
    window = shown(desktop, qtbot)
    settled(desktop, qtbot)
    return window


@pytest.fixture
def strip(window):
    return window.analysis.score


def settled(desktop, qtbot):
    session = desktop.session
    models = (session.whole, session.second.whole, session.score)
    qtbot.waitUntil(lambda: not any(model.busy for model in models))


def choose(desktop, qtbot, scope: Scope):
    strip = desktop.window.analysis.score
    strip.scope.setCurrentIndex(strip.scope.findData(scope.value))
    settled(desktop, qtbot)


def loaded(desktop, qtbot, folder: Path):
    model = desktop.calibration
    model.recordings.load([corpus(folder)])
    qtbot.waitUntil(lambda: len(model.workbench.answered) == 2 and not model.workbench.measuring.busy)
    settled(desktop, qtbot)


def scored(preset: Preset, path: Path) -> Agreement:
    """What the command `score` counts."""
    (answers,) = score(preset, read_recordings(path)).predictions
    counts = score(preset, read_recordings(path)).overall
    assert len(answers.phonemes) == counts.confusion.sum()
    return Agreement(counts.confusion, counts.changes, counts.label_changes)


def figures(strip, letter: str = "A") -> list[str]:
    """What is written, without its colours."""
    names = ("macro_f1", "accuracy", "viseme_accuracy", "silence_recall")
    return [re.sub("<[^>]*>", "", strip.values[letter, name].text()).split(" ")[0] for name in names]


def expected(agreement: Agreement) -> list[str]:
    shares = (agreement.macro_f1, agreement.accuracy, agreement.viseme_accuracy, agreement.silence_recall)
    return [f"{share:.1%}" for share in shares]


def test_a_labelled_file_has_the_figures_that_score_gives_and_what_is_seen_its_own(desktop, window, strip, qtbot):
    whole = scored(desktop.preset.preset, CARDS)
    np.testing.assert_array_equal(desktop.session.score.agreement.counts, whole.counts)
    assert figures(strip) == expected(whole)
    changes = f"{whole.changes_per_s:.1f} ({whole.label_changes_per_s:.1f})"
    assert changes in strip.values["A", "changes_per_s"].text()
    assert strip.of_what.text() == f"{whole.seconds:.1f} s labelled: cards.flac"
    assert "Preset: Thesis" in strip.values["A", "macro_f1"].toolTip()
    assert not strip.ways.isVisible()
    assert not strip.values["B", "macro_f1"].isVisible()
    desktop.session.view.show(TimeSpan(1.0, 2.0))
    choose(desktop, qtbot, Scope.SEEN)
    agreement = desktop.session.score.agreement
    assert agreement.seconds == pytest.approx(1.0)
    said, codes = desktop.session.labels.said_frames(), desktop.session.whole.tracks.phonemes
    known = said.phonemes[100:200] != Phoneme.UNIDENTIFIED
    assert agreement.accuracy == (codes[100:200] == said.phonemes[100:200])[known].mean()
    assert strip.of_what.text() == "1.0 s labelled: cards.flac, 1.0–2.0 s"
    desktop.session.view.show_all()
    settled(desktop, qtbot)
    assert figures(strip) == expected(whole)
    click(window.filters.switches["normalise"])  # the file is analysed anew
    settled(desktop, qtbot)
    assert figures(strip) == expected(scored(desktop.preset.in_force, CARDS)) != expected(whole)


def test_a_drag_tells_what_it_gained_and_lost_since_it_began(desktop, strip, qtbot):
    preset, before = desktop.preset, desktop.session.score.agreement
    for limit in (0.3, 0.5, 0.6):
        preset.tune("ae_ae1", limit)
        settled(desktop, qtbot)
    after = scored(preset.preset, CARDS)
    np.testing.assert_array_equal(desktop.session.score.before.counts, before.counts)
    np.testing.assert_array_equal(desktop.session.score.agreement.counts, after.counts)
    gains = after.gains_over(before)
    lost = min(gains, key=gains.get)
    assert strip.lost.text().startswith(f"Lost: {lost.label} −{-100 * gains[lost]:.1f}")
    difference = f"{100 * (after.macro_f1 - before.macro_f1):+.1f}".replace("-", "−")
    assert f">{difference}<" in strip.values["A", "macro_f1"].text()
    assert f"it was {before.macro_f1:.1%}" in strip.values["A", "macro_f1"].toolTip()
    preset.end_edit()
    preset.tune("o_o1", 0.1)
    settled(desktop, qtbot)
    np.testing.assert_array_equal(desktop.session.score.before.counts, after.counts)  # another drag begins there
    preset.load(preset_path("extended"))
    settled(desktop, qtbot)
    assert desktop.session.score.before is None


def test_a_confusion_is_a_button_that_goes_to_an_example_and_then_to_others(desktop, window, strip, qtbot):
    (truth, answer, n), _ = desktop.session.score.agreement.worst_confusions(2)
    assert f"{n / 100:.1f} s" in strip.confusions[0].text()
    said, codes = desktop.session.labels.said_frames(), desktop.session.whole.tracks.phonemes
    places = set()
    for _ in range(3):
        click(strip.confusions[0])
        span = desktop.session.view.selection
        frames = slice(round(100 * span.start), round(100 * span.end))
        assert (said.phonemes[frames] == truth).all()
        assert (codes[frames] == answer).all()
        assert desktop.session.source.position == pytest.approx(span.start)
        places.add(span)
    assert len(places) > 1


def test_everything_loaded_counts_recordings_and_the_open_file(desktop, window, strip, qtbot, tmp_path):
    loaded(desktop, qtbot, tmp_path / "corpus")
    choose(desktop, qtbot, Scope.LOADED)
    of_both = desktop.calibration.workbench.confusion.agreement + scored(desktop.preset.preset, CARDS)
    assert figures(strip) == expected(of_both)
    assert strip.of_what.text().endswith(" s labelled: 2 recordings of 2 speakers and the open file")
    desktop.session.leave_sound()
    settled(desktop, qtbot)
    agreement = desktop.calibration.workbench.confusion.agreement
    assert figures(strip) == expected(agreement)
    click(strip.confusions[0])
    assert desktop.session.path.name in {"ann.wav", "bob.wav"}
    assert desktop.session.view.selection is not None
    settled(desktop, qtbot)
    assert desktop.session.score.agreement.seconds == agreement.seconds  # an opened recording does not count twice


@pytest.mark.parametrize("scope", [pytest.param(Scope.WHOLE, marks=pytest.mark.long), Scope.LOADED])
def test_a_and_b_stand_side_by_side_and_change_places(desktop, window, strip, qtbot, tmp_path, scope):
    loaded(desktop, qtbot, tmp_path / "corpus")
    choose(desktop, qtbot, scope)
    of_a = figures(strip)
    window.dialogs.presets.set_other(replace(desktop.preset.document, preset=load_preset("extended")))
    settled(desktop, qtbot)
    of_b = figures(strip, "B")
    assert figures(strip) == of_a
    assert "<b>" in strip.values["A", "macro_f1"].text()
    if scope is Scope.WHOLE:
        assert of_b == expected(scored(load_preset("extended"), CARDS))
    a, b = desktop.session.score.agreement, desktop.session.score.other
    assert f"{100 * (b.macro_f1 - a.macro_f1):+.1f}" in strip.values["-", "macro_f1"].text()
    press(window, Qt.Key.Key_X)
    settled(desktop, qtbot)
    assert (figures(strip), figures(strip, "B")) == (of_a, of_b)
    assert "<b>" in strip.values["B", "macro_f1"].text()
    press(window, Qt.Key.Key_X)
    desktop.preset.clear_second()
    settled(desktop, qtbot)
    assert not strip.values["B", "macro_f1"].isVisible()


def test_without_labels_it_says_how_to_get_them_and_leads_to_takes_and_script(
    desktop, window, strip, qtbot, tmp_path
):
    bare = Path(shutil.copy(CARDS, tmp_path / "bare.flac"))
    desktop.session.open(bare)
    settled(desktop, qtbot)
    assert strip.why_not.text() == "No labels yet."
    assert strip.ways.isVisible()
    assert not strip.figures.isVisible()
    assert not any(button.isVisible() for button in strip.confusions)
    takes, _, script = strip.ways.findChildren(type(strip.confusions[0]))
    for button, page in ((takes, 1), (script, 2)):
        click(button)
        assert window.pages.currentIndex() == page
        window.show_page(0)
    write_tiers([Tier("phones", (RawLabel(0.0, 0.5, "a", ""),))], bare.with_suffix(".TextGrid"), duration=3.5)
    desktop.session.labels.load(bare.with_suffix(".TextGrid"))
    settled(desktop, qtbot)
    assert desktop.session.score.agreement.classes == (Phoneme.A,)
    shares = [label.text() for label in strip.values.values()]
    assert "nan" not in "".join(shares)
    assert "macro F1 is of these: a." in strip.values["A", "macro_f1"].toolTip()
    desktop.session.view.show(TimeSpan(1.0, 2.0))
    choose(desktop, qtbot, Scope.SEEN)
    assert strip.why_not.text() == "Nothing in view is labelled."
    press(window, Qt.Key.Key_2, Qt.KeyboardModifier.ControlModifier)
    desktop.session.leave_sound()
    settled(desktop, qtbot)
    assert strip.why_not.text() == "No file is open."
    choose(desktop, qtbot, Scope.LOADED)
    assert strip.why_not.text() == "No labelled sound is loaded."


def test_labels_of_another_sound_and_words_are_refused_in_one_sentence(desktop, window, strip, qtbot, tmp_path):
    sound = Path(shutil.copy(CARDS, tmp_path / "short.flac"))
    words = Tier("words", (RawLabel(0.0, 0.5, "eight", ""),))
    write_tiers([words], sound.with_suffix(".TextGrid"), duration=3.5)
    desktop.session.open(sound)
    settled(desktop, qtbot)
    assert strip.why_not.text().startswith("No tier of the labels names phonemes only.")
    other = Path(shutil.copy(CARDS, tmp_path / "other.flac"))
    longer = Tier("phones", (RawLabel(0.0, 99.0, "a", ""),))
    write_tiers([longer], other.with_suffix(".TextGrid"), duration=99.0)
    told = []
    desktop.session.labels.error.connect(told.append)
    desktop.session.open(other)
    settled(desktop, qtbot)
    assert [sentence.split("; ")[1] for sentence in told] == ["check whether the labels belong to this sound"]
    assert strip.why_not.text() == "No labels yet."


@pytest.mark.long
def test_the_scope_and_whether_it_is_shown_outlive_the_window(desktop, window, strip):
    strip.scope.setCurrentIndex(strip.scope.findData(Scope.LOADED.value))
    strip.shown.setChecked(False)
    assert not strip.isVisible()
    desktop.set_theme("light")
    again = desktop.window.analysis.score
    assert again is not strip
    assert again.scope.currentData() == Scope.LOADED.value
    assert not again.shown.isChecked()
