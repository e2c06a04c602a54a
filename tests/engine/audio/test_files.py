"""A sound read from a file is the sound that was written, whatever the file's rate, depth, channels and format."""

import tracemalloc
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import soundfile
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from phonemeengine.audio.files import SUFFIXES, SoundReader, mono_of
from phonemeengine.settings import SAMPLE_RATE, Channel

RATES = [1000, 11_025, 44_099, 44_100, 48_000, 768_000]


def tone_at(rate: int, frequency: float = 440.0, seconds: float = 1.0, amplitude: float = 0.5) -> np.ndarray:
    time = np.arange(round(seconds * rate)) / rate
    return (amplitude * np.sin(2 * np.pi * frequency * time)).astype(np.float32)


def melody_at(rate: int, seconds: float) -> np.ndarray:
    """A gliding tone, which is different everywhere."""
    time = np.arange(round(seconds * rate)) / rate
    top = 0.3 * min(rate, SAMPLE_RATE)
    return (0.5 * np.sin(2 * np.pi * (100 + (top - 100) * time / seconds / 2) * time)).astype(np.float32)


def read_whole(path: Path, channel: Channel = Channel.MIX) -> np.ndarray:
    with SoundReader(path, channel) as reader:
        return np.concatenate(list(reader.blocks(10_000)))


def frequency_and_amplitude_of(sound: np.ndarray) -> tuple[float, float]:
    """Fit the sine that is left when the ends are dropped: its peak, refined by the phase's advance."""
    middle = sound[4410:-4410].astype(float)
    half = len(middle) // 2
    window = np.hanning(half)
    spectra = [np.fft.rfft(part * window) for part in (middle[:half], middle[half : 2 * half])]
    peak = int(np.abs(spectra[0]).argmax())
    advance = np.angle(spectra[1][peak] / spectra[0][peak]) / (2 * np.pi)
    cycles = peak + (advance + 0.5) % 1 - 0.5
    return cycles * SAMPLE_RATE / half, float(np.sqrt(2 * np.mean(middle**2)))


@pytest.mark.parametrize("rate", RATES)
def test_a_tone_is_the_same_at_every_rate(rate: int, tmp_path: Path) -> None:
    soundfile.write(tmp_path / "tone.wav", tone_at(rate, 300.0), rate, subtype="FLOAT")
    sound, expected = read_whole(tmp_path / "tone.wav"), tone_at(SAMPLE_RATE, 300.0)
    np.testing.assert_allclose(sound[4410:-4410], expected[4410:-4410], atol=0.002)


@pytest.mark.parametrize("rate", RATES)
def test_a_click_stays_where_it_was(rate: int, tmp_path: Path) -> None:
    samples = np.zeros(rate, np.float32)
    samples[rate // 2] = 1.0
    soundfile.write(tmp_path / "click.wav", samples, rate)
    assert int(np.abs(read_whole(tmp_path / "click.wav")).argmax()) == pytest.approx(
        rate // 2 * SAMPLE_RATE / rate, abs=1
    )


@settings(max_examples=40, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(rate=st.sampled_from(RATES), n=st.integers(1, 20_000))
def test_a_sound_lasts_as_long_as_in_the_file(tmp_path: Path, rate: int, n: int) -> None:
    soundfile.write(tmp_path / "sound.wav", np.full(n, 0.1), rate)
    with SoundReader(tmp_path / "sound.wav") as reader:
        assert reader.duration == n / rate
        assert reader.n_samples == max(1, round(n * SAMPLE_RATE / rate))
        assert sum(len(block) for block in reader.blocks(1234)) == reader.n_samples
        assert reader.read(10).shape == (0, 1)
        assert reader.position == reader.n_samples


FORMATS: list[tuple[str, dict[str, Any], float]] = [
    ("8.wav", {"subtype": "PCM_U8"}, 0.01),
    ("16.wav", {"subtype": "PCM_16"}, 1e-4),
    ("24.wav", {"subtype": "PCM_24"}, 1e-6),
    ("32.wav", {"subtype": "PCM_32"}, 1e-6),
    ("float.wav", {"subtype": "FLOAT"}, 0),
    ("double.wav", {"subtype": "DOUBLE"}, 1e-7),
    ("mulaw.wav", {"subtype": "ULAW"}, 0.03),
    ("adpcm.wav", {"subtype": "MS_ADPCM"}, 0.05),
    ("extensible.wav", {"format": "WAVEX", "subtype": "PCM_24"}, 1e-6),
    ("big.wav", {"format": "WAV", "subtype": "PCM_16", "endian": "BIG"}, 1e-4),
    ("64.rf64", {"format": "RF64"}, 1e-4),
    ("64.w64", {}, 1e-4),
    ("8.aiff", {"subtype": "PCM_S8"}, 0.01),
    ("16.aiff", {"subtype": "PCM_16"}, 1e-4),
    ("float.aifc", {"format": "AIFF", "subtype": "FLOAT"}, 1e-7),
    ("16.flac", {"subtype": "PCM_16"}, 1e-4),
    ("24.flac", {"subtype": "PCM_24"}, 1e-6),
    ("vorbis.ogg", {}, 0.05),
    ("layer3.mp3", {}, 0.05),
    ("variable.mp3", {"bitrate_mode": "VARIABLE", "compression_level": 0.5}, 0.05),
    ("16.caf", {}, 1e-4),
    ("alac.caf", {"subtype": "ALAC_16"}, 1e-4),
    ("16.au", {}, 1e-4),
]


@pytest.mark.parametrize(("name", "options", "error"), FORMATS, ids=[name for name, *_ in FORMATS])
def test_every_format_gives_back_the_sound(name: str, options: dict[str, Any], error: float, tmp_path: Path) -> None:
    written = np.repeat(tone_at(SAMPLE_RATE)[:, np.newaxis], 2, axis=1)
    soundfile.write(tmp_path / name, written, SAMPLE_RATE, **options)
    with SoundReader(tmp_path / name) as reader:
        found = reader.read(reader.n_samples)
    assert found.dtype == np.float32
    assert found.flags.c_contiguous
    assert found.shape[1] == 2
    np.testing.assert_allclose(found[2000:40_000], written[2000:40_000], atol=error, rtol=0)


def test_opus_gives_back_the_sound(tmp_path: Path) -> None:
    soundfile.write(tmp_path / "sound.opus", tone_at(48_000), 48_000, format="OGG", subtype="OPUS")
    frequency, amplitude = frequency_and_amplitude_of(read_whole(tmp_path / "sound.opus"))
    assert frequency == pytest.approx(440, rel=1e-3)
    assert amplitude == pytest.approx(0.5, rel=0.05)


def test_the_ending_of_a_name_does_not_decide_what_a_file_is(tmp_path: Path) -> None:
    soundfile.write(tmp_path / "sound.raw", tone_at(SAMPLE_RATE), SAMPLE_RATE, format="FLAC")
    assert len(read_whole(tmp_path / "sound.raw")) == SAMPLE_RATE


@pytest.mark.parametrize(
    ("channel", "levels"), [(Channel.LEFT, (1, 0)), (Channel.RIGHT, (0, 1)), (Channel.MIX, (1, 1))]
)
@pytest.mark.parametrize("n_more", [0, 1])
def test_the_chosen_channel_is_what_is_heard(
    channel: Channel, levels: tuple[int, int], n_more: int, tmp_path: Path
) -> None:
    rate = 48_000
    tones = [tone_at(rate, 1000.0), tone_at(rate, 3000.0), *[np.zeros(rate, np.float32)] * n_more]
    soundfile.write(tmp_path / "two.wav", np.stack(tones, axis=1), rate, subtype="FLOAT")
    sound = read_whole(tmp_path / "two.wav", channel)[4410:-4410]
    amplitudes = np.abs(np.fft.rfft(sound)) / (len(sound) / 2)
    share = 1 / 2 if channel is Channel.MIX else 1  # a channel in which nothing sounds is left out
    for frequency, level in zip((1000, 3000), levels, strict=True):
        assert amplitudes[frequency * len(sound) // SAMPLE_RATE] == pytest.approx(0.5 * level * share, abs=0.005)


@pytest.mark.parametrize(("channel", "expected"), [(Channel.LEFT, 1), (Channel.RIGHT, 3), (Channel.MIX, 2)])
def test_a_block_is_reduced_to_left_right_or_the_mean(channel: Channel, expected: float) -> None:
    block = np.array([[1, 3], [1, 3]], np.float32)
    mono = mono_of(block, channel)
    assert mono.dtype == np.float32
    np.testing.assert_array_equal(mono, [expected, expected])
    np.testing.assert_array_equal(mono_of(block[:, :1], channel), [1, 1])


def writer_of(name: str, rate: int, **options: Any) -> Callable[[Path], Path]:
    def write(folder: Path) -> Path:
        sound = np.stack([melody_at(rate, 1.5), melody_at(rate, 1.5)[::-1]], axis=1)
        soundfile.write(folder / name, sound, rate, **options)
        return folder / name

    return write


STREAMS = {
    "wav 44100": writer_of("a.wav", 44_100),
    "wav 11025": writer_of("c.wav", 11_025),
    "wav 48000": writer_of("e.wav", 48_000),
    "flac 192000": writer_of("f.flac", 192_000),
    "ogg 16000": writer_of("l.ogg", 16_000),
    "opus 48000": writer_of("m.opus", 48_000, format="OGG", subtype="OPUS"),
    "mp3 variable 48000": writer_of("i.mp3", 48_000, bitrate_mode="VARIABLE", compression_level=0.9),
    "mp3 8000": writer_of("j.mp3", 8000),
    "adpcm 16000": writer_of("k.wav", 16_000, subtype="IMA_ADPCM"),
}


@pytest.fixture(scope="module", params=STREAMS)
def stream(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, np.ndarray]:
    """A file, and all of its samples as they come in one reading."""
    path = STREAMS[request.param](tmp_path_factory.mktemp("streams"))
    with SoundReader(path) as reader:
        return path, reader.read(reader.n_samples)


@settings(max_examples=5, deadline=None)
@given(cuts=st.lists(st.integers(1, 9000), min_size=1, max_size=6))
def test_a_sound_does_not_depend_on_how_its_reading_was_cut(stream: tuple[Path, np.ndarray], cuts: list[int]) -> None:
    path, whole = stream
    parts = []
    with SoundReader(path) as reader:
        while not parts or len(parts[-1]):
            parts.append(reader.read(cuts[len(parts) % len(cuts)]))
            assert len(parts[-1]) <= max(cuts)
    np.testing.assert_allclose(np.concatenate(parts), whole, atol=1e-6)


@settings(max_examples=10, deadline=None)
@given(place=st.floats(0, 1), before=st.integers(0, 50_000))
def test_from_any_place_follows_what_follows_in_one_reading(
    stream: tuple[Path, np.ndarray], place: float, before: int
) -> None:
    path, whole = stream
    sample = round(place * len(whole))
    with SoundReader(path) as reader:
        reader.read(before)
        reader.seek(sample)
        assert reader.position == sample
        found = reader.read(8000)
        np.testing.assert_allclose(found, whole[sample : sample + 8000], atol=1e-3)
        reader.read(reader.n_samples)
        assert reader.position == reader.n_samples == len(whole)


def test_beyond_the_ends_means_the_ends(tmp_path: Path) -> None:
    soundfile.write(tmp_path / "sound.wav", tone_at(48_000), 48_000)
    with SoundReader(tmp_path / "sound.wav") as reader:
        reader.seek(10**9)
        assert reader.position == reader.n_samples
        assert len(reader.read(100)) == 0
        reader.seek(-5)
        assert reader.position == 0
        assert len(reader.read(100)) == 100


def test_an_mp3_file_without_a_count_of_its_frames_is_as_long_as_it_sounds(tmp_path: Path) -> None:
    fading = np.linspace(0, 1, 20 * SAMPLE_RATE) ** 3 * np.random.default_rng(0).standard_normal(20 * SAMPLE_RATE)
    path = tmp_path / "guess.mp3"
    soundfile.write(path, 0.1 * fading, SAMPLE_RATE, bitrate_mode="VARIABLE", compression_level=0.5)
    content = path.read_bytes()
    path.write_bytes(content[content.index(content[:2], 4) :])  # without the frame that counts the others
    assert soundfile.info(path).frames > 25 * SAMPLE_RATE
    with SoundReader(path) as reader:
        assert reader.duration == pytest.approx(20, abs=0.1)
        assert sum(len(block) for block in reader.blocks(44_100)) == reader.n_samples


def test_an_mp3_file_may_lack_a_frame_at_its_end(tmp_path: Path) -> None:
    path = tmp_path / "short.mp3"
    soundfile.write(path, tone_at(SAMPLE_RATE, seconds=2.0), SAMPLE_RATE)
    content = path.read_bytes()
    path.write_bytes(content[: content.rindex(content[:2])])
    with SoundReader(path) as reader:
        assert reader.n_samples == 2 * SAMPLE_RATE
        assert len(reader.read(reader.n_samples)) == 2 * SAMPLE_RATE


@pytest.mark.parametrize(("rate", "n_channels"), [(8000, 1), pytest.param(44_100, 2, marks=pytest.mark.long)])
def test_two_minutes_take_no_more_memory_than_one(rate: int, n_channels: int, tmp_path: Path) -> None:
    path = tmp_path / "long.wav"
    with soundfile.SoundFile(path, "w", rate, n_channels) as file:
        for _ in range(120):
            file.write(np.zeros((rate, n_channels), np.float32))
    tracemalloc.start()
    try:
        with SoundReader(path) as reader:
            assert sum(len(block) for block in reader.blocks(22_050)) == 120 * SAMPLE_RATE  # 21 MB
            reader.seek(60 * SAMPLE_RATE)
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert peak < 3e6


def test_a_file_is_let_go_of_when_it_is_closed(tmp_path: Path) -> None:
    path = tmp_path / "sound.wav"
    soundfile.write(path, tone_at(SAMPLE_RATE), SAMPLE_RATE)
    reader = SoundReader(path)
    reader.close()
    reader.close()
    path.unlink()
    assert not path.exists()


def test_a_walk_through_a_folder_takes_the_endings_of_sounds() -> None:
    assert {".wav", ".aiff", ".flac", ".ogg", ".mp3"} <= SUFFIXES
    assert all(suffix == suffix.lower() and suffix.startswith(".") for suffix in SUFFIXES)
    assert not {".txt", ".csv", ".png", ".raw"} & SUFFIXES
