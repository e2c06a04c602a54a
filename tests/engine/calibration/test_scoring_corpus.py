"""Scores of a corpus: right answers score one, wrong ones what one counts, and all is as it is defined."""

import math
from dataclasses import asdict, astuple, replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
import soundfile
from hypothesis import given
from hypothesis import strategies as st

from phonemeengine.calibration.scores.corpus import FrameLabels, LabelledUtterance, read_corpus, read_recordings
from phonemeengine.calibration.scores.evaluation import Predictions, group_scores_of, kind_of, score
from phonemeengine.calibration.scores.scoring import scores_of
from phonemeengine.errors import AudioError, CorpusError
from phonemeengine.features.variables import Features
from phonemeengine.labels.files import write_labels
from phonemeengine.labels.utterance import Label
from phonemeengine.labels.visemes import NO_VISEME
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import FACTORY, load_preset
from phonemeengine.recognition.rules import ThesisRules
from phonemeengine.recognition.scores import Recognition
from phonemeengine.recognition.spec import BUILT_IN, RecogniserConfig, RecogniserSpec
from phonemeengine.settings import SAMPLE_RATE
from tests.corpora import put, write_corpus
from tests.sounds import silence, tone

THESIS = load_preset(FACTORY / "thesis.toml")
MOUTHS = {
    "silence": "rest",
    "a": "open",
    "e": "wide",
    "i": "wide",
    "o": "round",
    "u": "round",
    "m": "closed",
    "p": "closed",
}
CLASSES = ["silence", "sz", "sch", "m", "p", "a", "e", "i", "o", "u"]


def answers(
    truth: list[Phoneme], guess: list[Phoneme], core: list[bool] | None = None, corpus: str = "x"
) -> Predictions:
    labels = FrameLabels(
        np.array(truth, np.uint8), np.array(core or [True] * len(truth)), np.full(len(truth), NO_VISEME, np.uint8)
    )
    loud = np.linspace(0, 1, len(truth), dtype=np.float32)
    return Predictions(LabelledUtterance(Path("u.wav"), (), "s", corpus), labels, np.array(guess, np.uint8), loud)


def f1_by_hand(truth: list[str], guess: list[str], names: list[str]) -> float:
    found = []
    for name in names:
        hits = sum(t == g == name for t, g in zip(truth, guess, strict=True))
        if name in truth:
            found.append(2 * hits / (truth.count(name) + guess.count(name)))
    return sum(found) / len(found) if found else math.nan


def share_by_hand(hits: list[bool]) -> float:
    return sum(hits) / len(hits) if hits else math.nan


@given(
    st.lists(st.tuples(st.sampled_from(Phoneme), st.sampled_from(Phoneme), st.booleans()), min_size=1, max_size=60)
)
def test_figures_are_those_of_their_definitions(frames: list[tuple[Phoneme, Phoneme, bool]]) -> None:
    heard = answers(*(list(part) for part in zip(*frames, strict=True)))
    truth, guess = [t.label for t, _, _ in frames], [g.label for _, g, _ in frames]
    both = list(zip(truth, guess, strict=True))
    known = [(t, g) for t, g in both if t in CLASSES]
    mouths = [[MOUTHS.get(name, "slight") for name in names] for names in (truth, guess)]
    seconds = len(frames) / 100
    expected = {
        "accuracy": share_by_hand([t == g for t, g in known]),
        "macro_f1": f1_by_hand([t for t, _ in known], [g for _, g in known], CLASSES),
        "vowel_accuracy": share_by_hand([t == g for t, g, core in frames if core and t.label in "aeiou"]),
        "viseme_accuracy": share_by_hand([t == g for t, g in zip(*mouths, strict=True)]),
        "viseme_f1": f1_by_hand(*mouths, ["rest", "open", "wide", "round", "closed", "slight"]),
        "silence_recall": share_by_hand([g == "silence" for t, g in both if t == "silence"]),
        "false_silence": share_by_hand([g == "silence" for t, g in both if t != "silence"]),
        "changes_per_s": sum(a != b for a, b in pairwise(guess)) / seconds,
        "label_changes_per_s": sum(a != b for a, b in pairwise(truth)) / seconds,
        "minutes": seconds / 60,
        "fine_viseme_accuracy": math.nan,  # nobody knows what is seen of these
    }
    assert asdict(group_scores_of([heard]).scores) == pytest.approx(expected, nan_ok=True)


def test_a_preset_that_made_the_labels_is_right_everywhere(tmp_path: Path) -> None:
    scores = score(THESIS, read_corpus(write_corpus(tmp_path, THESIS)))
    assert len(np.unique(np.concatenate([a.phonemes for a in scores.predictions]))) > 3
    for group in (scores.overall, *scores.by_kind.values(), *scores.by_speaker.values()):
        assert astuple(group.scores)[:7] == (1, 1, 1, 1, 1, 1, 0)
        assert np.count_nonzero(group.confusion - np.diag(group.confusion.diagonal())) == 0
        assert group.changes == group.label_changes > 3
        assert 0 < group.intensity <= 1
        assert {group.f1_of(p) for p in Phoneme if group.confusion[p].any()} == {1.0}


def test_parts_add_up_to_the_whole(tmp_path: Path) -> None:
    scores = score(THESIS, read_corpus(write_corpus(tmp_path, THESIS)))
    assert list(scores.by_kind) == ["human", "machine"]
    assert list(scores.by_speaker) == ["human/ann", "human/bob", "machine/cyd"]
    for parts in (scores.by_kind, scores.by_speaker):
        assert np.array_equal(sum(group.confusion for group in parts.values()), scores.overall.confusion)
        assert sum(group.changes for group in parts.values()) == scores.overall.changes
        assert sum(group.n_recordings for group in parts.values()) == 3


def test_two_classes_that_are_swapped_are_counted_where_they_went() -> None:
    truth = [Phoneme.A] * 3 + [Phoneme.O] * 2 + [Phoneme.SILENCE] * 5
    guess = [Phoneme.O] * 3 + [Phoneme.A] * 2 + [Phoneme.SILENCE] * 5
    group = group_scores_of([answers(truth, guess)])
    assert (group.confusion[Phoneme.A, Phoneme.O], group.confusion[Phoneme.O, Phoneme.A]) == (3, 2)
    assert group.confusion.sum() == 10
    assert (group.f1_of(Phoneme.A), group.f1_of(Phoneme.SILENCE)) == (0, 1)
    assert math.isnan(group.f1_of(Phoneme.M))
    assert group.scores.accuracy == 0.5
    assert (group.changes, group.label_changes) == (2, 2)


def test_the_mean_intensity_is_that_of_speech() -> None:
    heard = answers([Phoneme.SILENCE, Phoneme.A, Phoneme.A], [Phoneme.A] * 3)  # 0, 0.5, 1
    assert group_scores_of([heard]).intensity == pytest.approx(0.75)
    assert math.isnan(group_scores_of([answers([Phoneme.SILENCE], [Phoneme.A])]).intensity)


class Hesitant:
    """The thesis rules, which say everything three frames late, as a recogniser that looks ahead does."""

    look_ahead = 3
    scores: tuple[str, ...] = ()
    used_thresholds: frozenset[str] = frozenset()

    def __init__(self, config: RecogniserConfig) -> None:
        self._rules = ThesisRules(config.thresholds)
        self._held: list[int] | None = None

    def recognise(self, _windows: np.ndarray, features: Features) -> Recognition:
        heard = self._rules.phonemes_of(features).tolist()
        waiting = (self._held or []) + heard
        n = max(0, len(waiting) - self.look_ahead)
        self._held = waiting[n:]
        return Recognition(np.array(waiting[:n], np.uint8))

    def deficits(self, features: Features) -> None:
        return None


def test_what_a_recogniser_looks_ahead_is_no_lag(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(BUILT_IN, "hesitant", RecogniserSpec("hesitant", Hesitant))
    preset = replace(THESIS, recogniser="hesitant", settings=replace(THESIS.settings, statistics=False))
    same = replace(preset, recogniser="thesis")
    scores = score(preset, read_corpus(write_corpus(tmp_path, same)))
    assert (scores.look_ahead, scores.delay, scores.overall.scores.accuracy) == (3, 0.0, 1)


@pytest.mark.parametrize("late", [-3, 2, 7])
def test_answers_that_come_late_are_moved_back_by_the_lag(tmp_path: Path, late: int) -> None:
    def moved(codes: np.ndarray) -> np.ndarray:
        earlier = np.zeros_like(codes)
        if late > 0:
            earlier[:-late] = codes[late:]
        else:
            earlier[-late:] = codes[:late]
        return earlier

    utterances = read_corpus(write_corpus(tmp_path, THESIS, change=moved))
    assert score(THESIS, utterances).overall.scores.accuracy < 1
    assert score(THESIS, utterances, delay=late / 100).overall.scores.accuracy == 1


def test_a_sound_that_ends_before_its_labels_is_silent_there(tmp_path: Path) -> None:
    put(tmp_path, "u", tone(1000, 0.5, 0.3), (Label(0, 0.54, "a", Phoneme.A),))
    utterance = LabelledUtterance(tmp_path / "u.wav", (Label(0, 0.54, "a", Phoneme.A),), "s", "c")
    (heard,) = score(THESIS, [utterance]).predictions
    assert len(heard.phonemes) == 54
    assert set(heard.phonemes[50:].tolist()) == {Phoneme.SILENCE}
    assert Phoneme.SILENCE not in heard.phonemes[5:45]


def test_a_sound_that_cannot_be_read_is_told_and_left_out(tmp_path: Path) -> None:
    utterances = read_corpus(write_corpus(tmp_path, THESIS))
    (tmp_path / "u1.wav").write_bytes(b"no sound")
    with pytest.raises(AudioError, match=r"u1\.wav"):
        score(THESIS, utterances)
    told: list[AudioError] = []
    scores = score(THESIS, utterances, on_skipped=told.append)
    assert [a.utterance.path.name for a in scores.predictions] == ["u0.wav", "u2.wav"]
    assert ["u1.wav" in str(error) for error in told] == [True]
    assert read_corpus(tmp_path, on_skipped=told.append) == (utterances[0], utterances[2])
    assert len(told) == 2
    with pytest.raises(CorpusError, match="no labelled sound that can be scored"):
        score(THESIS, [utterances[1]], on_skipped=told.append)


def test_a_recording_that_is_there_in_two_formats_is_scored_once_unless_it_is_named(tmp_path: Path) -> None:
    (tmp_path / "takes").mkdir()
    for name in ("a.flac", "a.wav", "b.flac"):
        soundfile.write(tmp_path / "takes" / name, silence(1.0), SAMPLE_RATE)
    for name in ("a", "b"):
        write_labels([Label(0.0, 1.0, "", Phoneme.SILENCE)], tmp_path / "takes" / f"{name}.csv")
    assert [x.path.name for x in read_recordings(tmp_path)] == ["a.wav", "b.flac"]
    assert [x.path.name for x in read_recordings(tmp_path / "takes" / "a.flac")] == ["a.flac"]


def test_recordings_without_labels_are_given_only_to_those_who_ask(tmp_path: Path) -> None:
    write_corpus(tmp_path, THESIS)
    with (tmp_path / "manifest.csv").open("a") as manifest:
        manifest.write("human_one,ann,u1.wav,\n")
    labelled = read_corpus(tmp_path)
    assert len(labelled) == 3
    *same, silent = read_corpus(tmp_path, unlabelled=True)
    assert tuple(same) == labelled
    assert (silent.labels, silent.voice) == ((), "human_one/ann")


def test_labels_too_short_for_a_frame_are_nothing_to_score(tmp_path: Path) -> None:
    soundfile.write(tmp_path / "u.wav", silence(1), SAMPLE_RATE)
    utterance = LabelledUtterance(tmp_path / "u.wav", (Label(0, 0.004, "a", Phoneme.A),), "s", "c")
    with pytest.raises(CorpusError, match="can be scored"):
        score(THESIS, [utterance])
    long = LabelledUtterance(tmp_path / "u.wav", (Label(0, 1, "sil", Phoneme.SILENCE),), "t", "c")
    scores = score(THESIS, [utterance, long])
    assert list(scores.by_speaker) == ["c/t"]
    assert asdict(scores.overall.scores) == pytest.approx(
        asdict(scores_of([scores.predictions[1].answers])), nan_ok=True
    )


def test_all_human_parts_of_a_corpus_are_one_kind() -> None:
    assert [kind_of(answers([], [], corpus=name).utterance) for name in ("human_x", "humane", "espeak")] == [
        "human",
        "human",
        "espeak",
    ]
