"""A sentence whose text is known is labelled where its sounds are: held against labels that nobody aligned."""

from pathlib import Path

import numpy as np
import pytest
import soundfile

from phonemeengine.calibration.scores.corpus import frame_labels_of, read_recordings
from phonemeengine.calibration.takes.project import TakeProject
from phonemeengine.calibration.takes.sentences import (
    LANGUAGES,
    SENTENCES,
    Sentence,
    aligned,
    keep_sentence,
    quiet_at_end,
    read_sentence,
    sentences_in,
)
from phonemeengine.calibration.takes.take import TRIMMED
from phonemeengine.errors import CorpusError, TakeError
from phonemeengine.labels.phone_sets import ipa_phoneme
from phonemeengine.labels.table import format_table
from phonemeengine.labels.utterance import Label
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import SAMPLE_RATE
from tests.reading import english_read
from tests.sounds import Sound, noise, silence, tone

ENGLISH = SENTENCES[0]


@pytest.fixture(scope="module")
def read() -> tuple[Sound, tuple[Label, ...]]:
    return english_read()


def counted(labels: tuple[Label, ...], n: int) -> np.ndarray:
    times = (np.arange(n) + 0.5) / 100
    kept = np.zeros(n, bool)
    for label in labels:
        kept[(times >= label.start) & (times < label.end)] = label.certainty != TRIMMED
    return kept


def test_the_labels_lie_where_the_sounds_are(read: tuple[Sound, tuple[Label, ...]]):
    sound, truth = read
    labels = aligned(sound, ENGLISH)
    found, known = frame_labels_of(labels).phonemes, frame_labels_of(truth).phonemes
    n = min(len(found), len(known))
    kept = counted(labels, n)
    assert 0.5 < kept.mean() < 0.95
    assert np.mean(found[:n][kept] == known[:n][kept]) > 0.85


def test_another_sentence_is_not_taken_for_it(read: tuple[Sound, tuple[Label, ...]]):
    sound, _ = read
    with pytest.raises(TakeError, match="does not match this sentence; read it again"):
        aligned(sound, SENTENCES[2])
    with pytest.raises(TakeError, match="does not match this sentence"):
        aligned(noise(6.0, 0.05), ENGLISH)
    with pytest.raises(TakeError, match="too short for this sentence"):
        aligned(sound[:SAMPLE_RATE], ENGLISH)


@pytest.mark.parametrize("sentence", SENTENCES, ids=lambda sentence: f"{sentence.language} {sentence.text[:8]}")
def test_every_sentence_holds_all_vowels_m_p_s_and_sh_where_there_is_one(sentence: Sentence):
    missing = {Phoneme.SILENCE, Phoneme.SCH} if sentence.language == "Spanish" else {Phoneme.SILENCE}
    assert {ipa_phoneme(sound) for sound in sentence.sounds} == set(Phoneme) - missing


@pytest.mark.parametrize("language", LANGUAGES)
def test_each_language_has_one_to_learn_from_and_a_shorter_one_to_judge_by(language: str):
    learned, judged = sentences_in(language.upper())
    assert learned.language == judged.language == language
    assert 50 <= len(learned.sounds) <= 80  # five to ten seconds
    assert len(judged.sounds) < len(learned.sounds)


def test_a_language_without_sentences_is_refused():
    with pytest.raises(CorpusError, match="no sentence in 'Latin'; choose one of English, German, "):
        sentences_in("Latin")


def test_a_file_is_labelled_by_the_sentence_or_by_any_text(read: tuple[Sound, tuple[Label, ...]], tmp_path: Path):
    sound, _ = read
    soundfile.write(tmp_path / "me.wav", sound, SAMPLE_RATE)
    utterance = read_sentence(tmp_path / "me.wav", ENGLISH)
    assert utterance.labels == read_sentence(tmp_path / "me.wav", ENGLISH.words).labels
    assert utterance.path == tmp_path / "me.wav"
    assert {label.phoneme for label in utterance.labels} == set(Phoneme)
    with pytest.raises(TakeError, match=r"^me\.wav: the recording does not match this sentence; read it again"):
        read_sentence(tmp_path / "me.wav", SENTENCES[2])


def test_a_sound_that_nobody_knows_is_refused():
    with pytest.raises(CorpusError, match="'3' is no sound of the phonetic alphabet"):
        Sentence("None", "?", "m a 3")


def test_what_was_read_lies_beside_the_takes_and_is_none_of_them(
    read: tuple[Sound, tuple[Label, ...]], tmp_path: Path
):
    sound, _ = read
    with TakeProject(tmp_path) as project:
        project.add(tone(300, 1.0, 0.2), "Ann", Phoneme.A)
        kept = [
            keep_sentence(tmp_path, sound[:, np.newaxis], SAMPLE_RATE, sound, ENGLISH, "Ann", teaches=teaches)
            for teaches in (False, False, True)
        ]
    assert [str(k.path.relative_to(tmp_path).as_posix()) for k in kept] == [
        "held-out/Ann/english-1.flac",
        "held-out/Ann/english-1 (2).flac",
        "read/Ann/english-1.flac",
    ]
    (again,) = read_recordings(kept[0].path)
    assert format_table(again.labels) == format_table(kept[0].labels)
    assert [u.path.name for u in read_recordings(tmp_path)] == ["a-1.flac"]


def test_quiet_is_counted_from_the_last_sound():
    sound = np.concatenate((silence(0.3), tone(300, 0.5, 0.2), silence(0.7)))
    assert quiet_at_end(sound, SAMPLE_RATE, 0.004) == pytest.approx(0.7, abs=0.011)
    assert quiet_at_end(silence(0.4), SAMPLE_RATE, 0.004) == pytest.approx(0.4)
