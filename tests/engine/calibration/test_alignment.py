"""A sentence whose text is known is labelled where its sounds are: held against labels that nobody aligned."""

from pathlib import Path

import numpy as np
import pytest

from phonemeengine.audio.files import SoundReader
from phonemeengine.calibration.alignment import aligned
from phonemeengine.calibration.scores.corpus import frame_labels_of, read_labels, read_recordings
from phonemeengine.calibration.sentences import SENTENCES, Sentence
from phonemeengine.calibration.takes.onset import quiet_at_end
from phonemeengine.calibration.takes.project import TakeProject
from phonemeengine.calibration.takes.spoken import keep_sentence
from phonemeengine.calibration.takes.take import TRIMMED
from phonemeengine.errors import CorpusError, TakeError
from phonemeengine.labels.label import Label
from phonemeengine.labels.phone_sets import ipa_phoneme
from phonemeengine.labels.table import format_table
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import SAMPLE_RATE
from tests.sounds import Sound, noise, silence, tone

DEMO = Path(__file__).parents[3] / "phonemeanalyser" / "demo" / "demo.flac"
ENGLISH = SENTENCES[0]


@pytest.fixture(scope="module")
def read() -> tuple[Sound, tuple[Label, ...]]:
    """The demo's voice reads the English sentence: its second one, and the beginning of its first."""
    with SoundReader(DEMO) as reader:
        sound = np.concatenate(list(reader.blocks(1 << 16)))
    labels = read_labels(DEMO.with_suffix(".csv"))
    names = [label.phone for label in labels]
    begins = next(k for k in range(len(names)) if names[k : k + 4] == ["p", "aa", "p", "ax"])
    ends = next(k for k in range(begins, len(names)) if names[k] == "pau" and names[k - 1] == "z") + 1
    shells = next(k for k in range(len(names)) if names[k] == "pau" and k > 1)
    chosen = [*labels[begins - 1 : ends], *labels[1:shells], labels[shells]]
    parts, moved, at = [], [], 0.0
    for label in chosen:
        part = sound[round(label.start * SAMPLE_RATE) : round(label.end * SAMPLE_RATE)]
        parts.append(part)
        moved.append(Label(at, at + label.end - label.start, label.phone, label.phoneme, label.certainty))
        at = moved[-1].end
    return np.concatenate(parts), tuple(moved)


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
    with pytest.raises(TakeError, match="is not this sentence; read it again"):
        aligned(sound, SENTENCES[1])
    with pytest.raises(TakeError, match="is not this sentence"):
        aligned(noise(6.0, 0.05), ENGLISH)
    with pytest.raises(TakeError, match="too short for this sentence"):
        aligned(sound[:SAMPLE_RATE], ENGLISH)


@pytest.mark.parametrize("sentence", SENTENCES, ids=lambda sentence: sentence.language)
def test_every_sentence_holds_all_vowels_m_p_s_and_sh(sentence: Sentence):
    assert {ipa_phoneme(sound) for sound in sentence.sounds} == set(Phoneme) - {Phoneme.SILENCE}


def test_a_sound_that_nobody_knows_is_refused():
    with pytest.raises(CorpusError, match="'3' is no sound of the phonetic alphabet"):
        Sentence("None", "?", "m a 3")


def test_what_was_read_lies_beside_the_takes_and_teaches_nothing(
    read: tuple[Sound, tuple[Label, ...]], tmp_path: Path
):
    sound, _ = read
    with TakeProject(tmp_path) as project:
        project.add(tone(300, 1.0, 0.2), "Ann", Phoneme.A)
        kept = [keep_sentence(tmp_path, sound[:, np.newaxis], SAMPLE_RATE, sound, ENGLISH, "Ann") for _ in range(2)]
    assert kept[0].path != kept[1].path
    (again,) = read_recordings(kept[0].path)
    assert format_table(again.labels) == format_table(kept[0].labels)
    assert [u.path.name for u in read_recordings(tmp_path)] == ["a-1.flac"]


def test_quiet_is_counted_from_the_last_sound():
    sound = np.concatenate((silence(0.3), tone(300, 0.5, 0.2), silence(0.7)))
    assert quiet_at_end(sound, SAMPLE_RATE, 0.004) == pytest.approx(0.7, abs=0.011)
    assert quiet_at_end(silence(0.4), SAMPLE_RATE, 0.004) == pytest.approx(0.4)
