"""The sound of M4A, MP4, AAC, WebM and their kin is read as that of any other file."""

import sys
from pathlib import Path

import numpy as np
import pytest

from phonemeengine.audio.files import SoundReader, sounds_under
from phonemeengine.errors import AudioError
from phonemeengine.settings import SAMPLE_RATE
from tests.containers import contained
from tests.sounds import noise, tone

SOUND = np.concatenate([tone(200 + 40 * k, 0.25, 0.4) for k in range(12)])
"""Three seconds of which each quarter has another pitch."""
KINDS = {
    "a.m4a": ("ipod", "aac", {}),
    "a.mp4": ("mp4", "aac", {"pictures": True}),
    "a.mov": ("mov", "pcm_s16le", {"pictures": True}),
    "lossless.m4a": ("ipod", "alac", {}),
    "a.aac": ("adts", "aac", {}),
    "a.mkv": ("matroska", "aac", {"pictures": True}),
    "flac.mkv": ("matroska", "flac", {}),
    "a.webm": ("webm", "libopus", {"rate": 48_000}),
    "a.wma": ("asf", "wmav2", {}),
}
DELAY = 1024
"""Samples that encoders of AAC put in front, of which these containers say nothing."""


def written(folder: Path, name: str, sound: np.ndarray = SOUND) -> Path:
    form, codec, options = KINDS[name]
    path = folder / name
    path.write_bytes(contained(sound, form, codec, **options))
    return path


@pytest.mark.parametrize(
    "name", [name for name in KINDS if name != "a.wma"]
)  # whose blocks blur what they begin with
def test_the_sound_of_a_container_is_where_it_was_put(name: str, tmp_path: Path) -> None:
    with SoundReader(written(tmp_path, name)) as reader:
        read = reader.read_mono()
        assert len(read) == reader.n_samples
        assert reader.notes == ()
    assert abs(len(read) - len(SOUND)) < 4096
    delays = (0, DELAY) if name in {"a.aac", "a.mkv"} else (0,)
    alike = [np.corrcoef(read[k + 2000 : k + 120_000], SOUND[2000:120_000])[0, 1] for k in delays]
    assert max(alike) > 0.99


@pytest.mark.parametrize("name", KINDS)
@pytest.mark.parametrize(
    "place", [0, 100_001, *(pytest.param(place, marks=pytest.mark.long) for place in (1, 50_000, 131_000))]
)
def test_any_place_is_gone_to_and_any_cutting_gives_the_same(name: str, place: int, tmp_path: Path) -> None:
    with SoundReader(written(tmp_path, name)) as reader:
        whole = reader.read_mono()
        reader.seek(0)
        cut = np.concatenate(list(reader.blocks(777)))
        np.testing.assert_array_equal(cut, whole)
        reader.seek(place)
        np.testing.assert_allclose(reader.read_mono(1000), whole[place : place + 1000], atol=1e-3)


def test_both_channels_of_a_film_stay_apart(tmp_path: Path) -> None:
    stereo = np.stack([SOUND, 0.5 * SOUND[::-1]], axis=1)
    with SoundReader(written(tmp_path, "a.mov", stereo)) as reader:
        np.testing.assert_allclose(reader.read(50_000), stereo[:50_000], atol=1e-4)


def test_of_several_tracks_one_is_read_and_it_is_said(tmp_path: Path) -> None:
    path = tmp_path / "two.mkv"
    path.write_bytes(contained(SOUND, "matroska", "flac", n_tracks=2))
    with SoundReader(path) as reader:
        assert reader.notes == ("it has 2 sound tracks, of which the main one is used",)
        np.testing.assert_allclose(reader.read_mono(), SOUND, atol=1e-4)


def test_the_content_of_a_file_counts_and_not_its_ending(tmp_path: Path) -> None:
    path = written(tmp_path, "lossless.m4a").rename(tmp_path / "a.wav")
    with SoundReader(path) as reader:
        np.testing.assert_allclose(reader.read_mono(), SOUND, atol=1e-4)


def test_a_film_without_sound_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "silent.mp4"
    path.write_bytes(contained(SOUND, "mp4", "aac", pictures=True, n_tracks=0))
    with pytest.raises(AudioError, match=r"^silent.mp4: .*there is no sound in it"):
        SoundReader(path)


@pytest.mark.parametrize("name", KINDS)
@pytest.mark.parametrize("share", [0.02, 0.7])
def test_a_container_that_is_cut_off_is_read_or_refused_in_a_sentence(
    name: str, share: float, tmp_path: Path
) -> None:
    path = written(tmp_path, name)
    path.write_bytes(path.read_bytes()[: int(share * path.stat().st_size)])
    refusal = ""
    try:
        with SoundReader(path) as reader:
            assert len(reader.read_mono()) == reader.n_samples <= len(SOUND) + 3000
    except AudioError as error:
        refusal = str(error)
    assert not refusal or refusal.startswith(f"{name}: ")
    assert refusal.isprintable()


def test_where_ffmpeg_is_missing_it_is_said_what_brings_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "av", None)
    with pytest.raises(AudioError, match=r"^a.m4a: this kind of file needs the package av.*phonemeanalyser\[media\]"):
        SoundReader(written_before(tmp_path))


def written_before(folder: Path) -> Path:
    path = folder / "a.m4a"
    path.write_bytes(b"\0\0\0\x20ftypM4A " + bytes(100))
    return path


@pytest.mark.parametrize("n_parts", [1, 3])
def test_an_mp3_of_any_bit_rates_without_a_count_is_read_to_its_end(n_parts: int, tmp_path: Path) -> None:
    options = {"write_xing": "0", "id3v2_version": "0"}
    content = contained(noise(1.0, 0.3), "mp3", "libmp3lame", options=options) + slow_frames(4.0)
    path = tmp_path / "vbr.mp3"
    path.write_bytes(content * n_parts)
    with SoundReader(path) as reader:
        assert reader.duration == pytest.approx(5.0 * n_parts, abs=0.12 * n_parts)
        assert len(reader.read_mono()) == reader.n_samples


def slow_frames(seconds: float) -> bytes:
    """Empty frames of MP3 at the lowest bit rate, 32 kbit/s; they hold silence."""
    frame = bytes([0xFF, 0xFB, 0x10, 0xC4]).ljust(104, b"\0")
    return frame * round(seconds * SAMPLE_RATE / 1152)


def test_mp3_files_that_were_joined_are_read_to_the_end_of_the_last(tmp_path: Path) -> None:
    one = contained(SOUND, "mp3", "libmp3lame")
    path = tmp_path / "joined.mp3"
    path.write_bytes(one + one)
    with SoundReader(path) as reader:
        assert reader.duration == pytest.approx(2 * len(SOUND) / SAMPLE_RATE, abs=0.2)
        read = reader.read_mono()
    assert len(read) == reader.n_samples
    assert np.abs(read[-SAMPLE_RATE:]).max() > 0.3


def test_folders_hold_the_sounds_that_a_mac_packed_and_not_what_it_laid_beside(tmp_path: Path) -> None:
    for name in ("a.wav", "b.m4a", "c.MP4", "deep/d.webm", "deep/e.aac"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_bytes(b"")
    for name in ("._a.wav", "__MACOSX/a.wav", "deep/._d.webm", ".DS_Store", "readme.txt"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_bytes(b"")
    found = [path.relative_to(tmp_path).as_posix() for path in sounds_under(tmp_path)]
    assert found == ["a.wav", "b.m4a", "c.MP4", "deep/d.webm", "deep/e.aac"]
