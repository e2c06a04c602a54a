from pathlib import Path

import numpy as np
import pytest
import soundfile

from phonemeengine import AudioError, CorpusError
from phonemeengine.labels.textgrid import format_tiers
from phonemeengine.mouth.exports.livelink import lines_of
from phonemeengine.performance.corpus import RATE, find_recordings, read_performance
from phonemeengine.performance.recording import LEAST_SILENCE, SILENCE, Performance
from tests.engine.performance.corpora import PHONES, TONE, tone, write_recording, write_sound
from tests.engine.performance.faces import ramp


def _read(folder: Path) -> tuple[Performance, tuple[str, ...]]:
    (recording,) = find_recordings(folder).recordings
    return read_performance(recording)


@pytest.mark.parametrize("syllables", [True, False])
def test_a_recording_is_a_face_over_what_is_said(tmp_path: Path, syllables: bool) -> None:
    write_recording(tmp_path, syllables=syllables)
    performance, notes = _read(tmp_path)
    assert (performance.name, performance.words, performance.rate, notes) == ("mami", ("mami",), RATE, ())
    assert [phone.name for phone in performance.phones] == [SILENCE, "m", "a", "m", "i", SILENCE]
    assert [phone.syllable for phone in performance.phones] == [-1, 0, 0, 1, 1, -1]
    assert [phone.word for phone in performance.phones] == [-1, 0, 0, 0, 0, -1]
    assert [phone.stress for phone in performance.phones] == [0, *([1, 1] if syllables else [0, 0]), 0, 0, 0]
    jaw = performance.weights[:, performance.channels.index("jawOpen")]
    assert jaw == pytest.approx(np.linspace(0, 1, 61), abs=1e-5)
    assert performance.weights[-1, performance.channels.index("headYaw")] == pytest.approx(30, abs=0.01)


def test_a_phone_is_as_loud_and_as_high_as_its_sound(tmp_path: Path) -> None:
    write_recording(tmp_path)
    phones = {phone.start: phone for phone in _read(tmp_path)[0].phones}
    assert phones[0.3].pitch == pytest.approx(TONE, rel=0.01)
    assert phones[0.3].energy == pytest.approx(20 * np.log10(0.5 / np.sqrt(2)), abs=0.1)
    assert (phones[0.0].pitch, phones[0.0].energy) == (0, -100)


def test_the_names_of_arpabet_become_ipa_with_their_stress(tmp_path: Path) -> None:
    write_recording(tmp_path)
    phones = [(0.2, 0.3, "B"), (0.3, 0.5, "AH0"), (0.5, 0.6, "JH"), (0.6, 0.8, "AY1")]
    tiers = {"words": [(0.2, 0.8, "budge I")], "phones": phones}
    (tmp_path / "mami.TextGrid").write_text(format_tiers(tiers, 1.0), encoding="utf-8")
    performance, _ = _read(tmp_path)
    assert [phone.name for phone in performance.phones[1:-1]] == ["b", "ə", "d", "ʒ", "aɪ"]
    assert [(phone.syllable, phone.stress) for phone in performance.phones[1:-1]] == [(0, 0), (0, 0), *[(1, 1)] * 3]


def test_who_speaks_from_the_first_moment_to_the_last_is_silent_for_a_hundredth_of_a_second(tmp_path: Path) -> None:
    write_recording(tmp_path)
    stretched = [(0.0 if k == 0 else a, 1.0 if k == 3 else b, name) for k, (a, b, name) in enumerate(PHONES)]
    (tmp_path / "mami.TextGrid").write_text(format_tiers({"phones": stretched}, 1.0), encoding="utf-8")
    phones = _read(tmp_path)[0].phones
    assert (phones[0].name, phones[0].end) == (SILENCE, LEAST_SILENCE)
    assert (phones[-1].name, phones[-1].start) == (SILENCE, pytest.approx(1 - LEAST_SILENCE))


def test_a_face_that_began_later_than_its_sound_is_shifted(tmp_path: Path) -> None:
    write_recording(tmp_path)
    (tmp_path / "offsets.csv").write_text("name,seconds\nmami,0.05\nnobody,1\n", encoding="utf-8")
    corpus = find_recordings(tmp_path)
    assert corpus.notes == ("offsets.csv: there is no recording 'nobody'",)
    performance, _ = read_performance(corpus.recordings[0])
    jaw = performance.weights[:, performance.channels.index("jawOpen")]
    assert jaw[:3] == pytest.approx(0)
    assert jaw[33] == pytest.approx(0.5)


@pytest.mark.parametrize("ending", [".glb", ".osc"])
def test_of_several_faces_that_of_live_link_counts(tmp_path: Path, ending: str) -> None:
    write_recording(tmp_path)
    (tmp_path / f"mami{ending}").write_bytes(b"no face")
    (recording,) = find_recordings(tmp_path).recordings
    assert recording.face.suffix == ".csv"
    (tmp_path / "mami.csv").unlink()
    (recording,) = find_recordings(tmp_path).recordings
    assert recording.face.suffix == ending
    with pytest.raises(CorpusError, match="mami"):
        read_performance(recording)


def test_what_lacks_a_file_is_left_out_and_said(tmp_path: Path) -> None:
    write_recording(tmp_path)
    write_recording(tmp_path, "faceless")
    (tmp_path / "faceless.csv").unlink()
    write_sound(tmp_path / "unlabelled.wav", tone())
    corpus = find_recordings(tmp_path)
    assert [recording.name for recording in corpus.recordings] == ["mami"]
    assert corpus.notes == (
        "faceless.wav: it is left out, as there is no face beside it",
        "unlabelled.wav: it is left out, as there is no face beside it",
    )


def test_a_recording_that_is_there_in_two_formats_counts_once(tmp_path: Path) -> None:
    write_recording(tmp_path)
    samples, rate = soundfile.read(tmp_path / "mami.wav")
    soundfile.write(tmp_path / "mami.flac", samples, rate)
    corpus = find_recordings(tmp_path)
    assert [recording.sound.name for recording in corpus.recordings] == ["mami.wav"]
    assert corpus.notes == ("mami.flac: it is left out, as mami.wav is the same",)


def test_a_folder_tells_what_it_is_called_and_whether_a_model_moved(tmp_path: Path) -> None:
    write_recording(tmp_path)
    corpus = find_recordings(tmp_path)
    assert (corpus.name, corpus.synthetic) == (tmp_path.name, False)
    (tmp_path / "corpus.toml").write_text('format = "phonemeanalyser corpus 1"\nname = "Ann"\nsynthetic = true\n')
    corpus = find_recordings(tmp_path)
    assert (corpus.name, corpus.synthetic) == ("Ann", True)


@pytest.mark.parametrize(
    ("file", "text", "sentence"),
    [
        ("corpus.toml", "synthetic = true", "corpus.toml: such a file begins with format"),
        ("corpus.toml", 'format = "phonemeanalyser corpus 1"\nsynthetic = 1', "corpus.toml: synthetic must be true"),
        ("offsets.csv", "name,seconds\nmami,soon\n", "offsets.csv, line 2: seconds must be a number"),
        ("offsets.csv", "name\nmami\n", "offsets.csv: it lacks the column seconds"),
    ],
)
def test_what_says_something_impossible_of_a_folder_is_refused(
    tmp_path: Path, file: str, text: str, sentence: str
) -> None:
    write_recording(tmp_path)
    (tmp_path / file).write_text(text, encoding="utf-8")
    with pytest.raises(CorpusError, match=sentence):
        find_recordings(tmp_path)


def test_a_folder_without_a_recording_is_refused(tmp_path: Path) -> None:
    with pytest.raises(CorpusError, match="a recording is NAME"):
        find_recordings(tmp_path)
    with pytest.raises(CorpusError, match="cannot be read"):
        find_recordings(tmp_path / "none")


@pytest.mark.parametrize(
    ("n_frames", "sentence"),
    [
        (40, "the face moves from 0.00 to 0.65 s of its sound, which lasts 1.00 s"),
        (181, "the face moves from 0.00 to 3.00 s of its sound, which lasts 1.00 s"),
    ],
)
def test_a_face_that_does_not_fit_its_sound_is_refused(tmp_path: Path, n_frames: int, sentence: str) -> None:
    write_recording(tmp_path)
    (tmp_path / "mami.csv").write_text("".join(lines_of(ramp(n_frames))), encoding="utf-8")
    with pytest.raises(CorpusError, match=sentence):
        _read(tmp_path)


@pytest.mark.parametrize(
    ("phones", "sentence"),
    [
        ([(0.2, 0.5, "m"), (0.4, 0.8, "a")], "labels must not overlap"),
        ([(0.2, 0.5, "m"), (0.5, 1.8, "a")], "lies beyond the end of the sound"),
        ([(0.2, 0.5, "sil")], "its labels hold no speech"),
        ([(0.2, 0.5, "blorp")], "unknown what stands for a phoneme"),
    ],
)
def test_labels_that_do_not_fit_their_sound_are_refused(
    tmp_path: Path, phones: list[tuple[float, float, str]], sentence: str
) -> None:
    write_recording(tmp_path)
    lines = [f'{a}\n{b}\n"{name}"\n' for a, b, name in phones]
    empty = format_tiers({"phones": []}, 1.0, short=True).removesuffix('1\n0\n1\n""\n')
    (tmp_path / "mami.TextGrid").write_text(f"{empty}{len(phones)}\n" + "".join(lines), encoding="utf-8")
    with pytest.raises(CorpusError, match=sentence):
        _read(tmp_path)


def test_a_sound_that_is_none_is_refused(tmp_path: Path) -> None:
    write_recording(tmp_path)
    (tmp_path / "mami.wav").write_bytes(b"RIFF")
    with pytest.raises(AudioError, match="mami"):
        _read(tmp_path)
