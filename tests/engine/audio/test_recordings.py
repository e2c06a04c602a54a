"""Labelled recordings, wherever they lie: with a manifest, side by side in folders, or a single one."""

from pathlib import Path

import numpy as np
import pytest
import soundfile

from phonemeengine.calibration.scores.corpus import read_corpus, read_recordings
from phonemeengine.errors import AudioError, CorpusError, UnknownPhonemeError
from phonemeengine.labels.files import write_labels
from phonemeengine.labels.phone_sets import PhonemeMap
from phonemeengine.labels.utterance import Label
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import SAMPLE_RATE
from tests.sounds import noise

LABELS = (Label(0.1, 0.3, "a", Phoneme.A), Label(0.3, 0.5, "m", Phoneme.M))


def put_sound(path: Path, seconds: float = 0.5) -> Path:
    path.parent.mkdir(parents=True, exist_ok=True)
    soundfile.write(path, noise(seconds), SAMPLE_RATE)
    return path


def put_recording(path: Path, suffix: str) -> Path:
    put_sound(path)
    write_labels(LABELS, path.with_suffix(suffix), duration=0.5)
    return path


def phonemes_of(utterance):
    return [label.phoneme for label in utterance.labels]


def test_sounds_beside_label_files_are_found_however_deep(tmp_path):
    put_recording(tmp_path / "ada" / "one.wav", ".TextGrid")
    put_recording(tmp_path / "more" / "bob" / "two.flac", ".txt")
    put_recording(tmp_path / "three.wav", ".csv")
    put_sound(tmp_path / "ada" / "unlabelled.wav")
    put_recording(tmp_path / ".hidden" / "four.wav", ".txt")
    found = read_recordings(tmp_path)
    assert [(u.path.name, u.speaker) for u in found] == [
        ("three.wav", tmp_path.name),
        ("one.wav", "ada"),
        ("two.flac", "bob"),
    ]
    assert {u.corpus for u in found} == {tmp_path.name}
    assert all(phonemes_of(u) == [Phoneme.A, Phoneme.M] for u in found)
    assert {u.speaker for u in read_recordings(tmp_path, speaker="eve")} == {"eve"}


def test_a_single_sound_is_read_with_its_label_file(tmp_path):
    sound = put_recording(tmp_path / "ada" / "one.wav", ".TEXTGRID")
    put_recording(tmp_path / "ada" / "two.wav", ".txt")
    (found,) = read_recordings(sound)
    assert (found.path, found.speaker) == (sound, "ada")


def test_a_textgrid_counts_before_a_table_and_a_table_before_a_text(tmp_path):
    sound = put_recording(tmp_path / "one.wav", ".csv")
    sound.with_suffix(".txt").write_text("what was said, in words\n")
    assert phonemes_of(read_recordings(sound)[0]) == [Phoneme.A, Phoneme.M]
    write_labels(LABELS[:1], sound.with_suffix(".TextGrid"))
    assert phonemes_of(read_recordings(sound)[0]) == [Phoneme.A]


def test_a_manifest_says_who_speaks(tmp_path):
    put_recording(tmp_path / "x" / "one.wav", ".TextGrid")
    (tmp_path / "manifest.csv").write_text("corpus,speaker,wav,labels\nmine,eve,x/one.wav,x/one.TextGrid\n")
    (found,) = read_recordings(tmp_path)
    assert (found.speaker, found.corpus, found.path) == ("eve", "mine", tmp_path / "x" / "one.wav")
    assert read_corpus(tmp_path) == (found,)


def test_the_unknown_names_of_all_files_are_told_at_once(tmp_path):
    for speaker, name in (("ada", "blub"), ("bob", "xyz"), ("eve", "blub")):
        sound = put_sound(tmp_path / speaker / "one.wav")
        sound.with_suffix(".txt").write_text(f"0\t0.2\t{name}\n0.2\t0.5\ta\n")
    with pytest.raises(UnknownPhonemeError) as caught:
        read_recordings(tmp_path)
    assert caught.value.counts == {"blub": 2, "xyz": 1}
    found = read_recordings(tmp_path, PhonemeMap({"blub": Phoneme.U, "xyz": Phoneme.P}))
    assert [phonemes_of(u)[0] for u in found] == [Phoneme.U, Phoneme.P, Phoneme.U]


def test_one_alphabet_holds_for_all_files_of_a_folder(tmp_path):
    for stem, name in (("one", "S"), ("two", "AA1")):
        put_sound(tmp_path / f"{stem}.wav").with_suffix(".txt").write_text(f"0\t0.2\t{name}\n")
    assert [phonemes_of(u) for u in read_recordings(tmp_path)] == [[Phoneme.SZ], [Phoneme.A]]


def test_labels_of_another_sound_are_refused(tmp_path):
    sound = put_recording(tmp_path / "one.wav", ".csv")
    put_sound(sound, 0.4)
    with pytest.raises(CorpusError, match=r"one\.csv, line 3: .* 0\.3\.\.0\.5 s lies beyond .* lasts 0\.400 s"):
        read_recordings(tmp_path)


def test_a_little_overhang_is_cut_to_the_sound(tmp_path):
    sound = put_recording(tmp_path / "one.wav", ".csv")
    put_sound(sound, 0.46)
    assert read_recordings(sound)[0].labels[-1].end == pytest.approx(0.46)


def test_a_sound_that_cannot_be_read_is_named(tmp_path):
    put_recording(tmp_path / "one.wav", ".csv").write_bytes(b"no sound")
    with pytest.raises(AudioError, match=r"one\.wav"):
        read_recordings(tmp_path)


def test_where_nothing_is_labelled_it_says_what_to_do(tmp_path):
    sound = put_sound(tmp_path / "one.wav")
    with pytest.raises(CorpusError, match=r"no labelled sound was found here; put a \.TextGrid"):
        read_recordings(tmp_path)
    with pytest.raises(CorpusError, match=r"one\.wav: there is no label file beside this sound"):
        read_recordings(sound)


def test_the_whole_corpus_lies_within_its_sounds(corpus):
    found = read_recordings(corpus)
    assert len(found) == 91
    assert np.unique([u.speaker for u in found]).size == 8
