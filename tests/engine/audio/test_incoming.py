"""A sound that comes in pieces is the whole sound, however its bytes are cut; what is no sound is refused."""

import io
from collections.abc import Iterator, Sequence
from contextlib import suppress
from itertools import pairwise

import numpy as np
import pytest
import soundfile
from hypothesis import given
from hypothesis import strategies as st

from phonemeengine.audio.incoming import PIECE, Encoding, IncomingSound, StreamFormat
from phonemeengine.audio.resampling import resample_whole
from phonemeengine.errors import AudioError
from tests.conftest import SPEECH
from tests.sounds import Sound

MONO = np.asarray(SPEECH, np.float32)
F32, S16, OPUS = Encoding.F32, Encoding.S16, Encoding.OPUS


def cut(data: bytes, places: Sequence[int]) -> Iterator[bytes]:
    borders = [0, *sorted(place % (len(data) + 1) for place in places), len(data)]
    yield from (data[a:b] for a, b in pairwise(borders))


def taken(form: StreamFormat, parts: Iterator[bytes] | Sequence[bytes]) -> Sound:
    sound = IncomingSound(form)
    pieces = [piece for part in parts for piece in sound.pieces(part)]
    assert max(map(len, pieces), default=0) <= PIECE * 44_100 + 1000
    return np.concatenate([*pieces, sound.finish()])


def opus_of(sound: Sound, rate: int = 48_000) -> bytes:
    file = io.BytesIO()
    soundfile.write(file, sound, rate, format="OGG", subtype="OPUS")
    return file.getvalue()


def at_48_khz(data: bytes) -> Sound:
    """The samples of Ogg Opus as libsndfile reads them, mixed."""
    return np.asarray(soundfile.read(io.BytesIO(data), dtype="float32", always_2d=True)[0].mean(axis=1), np.float32)


@given(st.lists(st.integers(0, 200_000), max_size=6))
def test_floats_are_the_samples_however_they_are_cut(places: list[int]) -> None:
    assert np.array_equal(taken(StreamFormat(F32), cut(MONO.tobytes(), places)), MONO)


def test_integers_are_parts_of_full_scale() -> None:
    numbers = np.array([-32_768, -1, 0, 16_384], "<i2")
    assert taken(StreamFormat(S16), [numbers.tobytes()]).tolist() == [-1.0, -1 / 32_768, 0.0, 0.5]


def test_channels_are_mixed() -> None:
    both = np.stack([MONO, np.zeros_like(MONO)], axis=1)
    assert np.allclose(taken(StreamFormat(F32, 44_100, 2), [both.tobytes()]), MONO / 2)


@pytest.mark.parametrize("rate", [1000, 8000, 22_050, 48_000, 768_000])
def test_other_rates_keep_the_length_and_the_sound(rate: int) -> None:
    there = np.sin(2 * np.pi * 100 / rate * np.arange(rate // 2)).astype(np.float32)
    back = taken(StreamFormat(F32, rate), cut(there.tobytes(), [1000, 3333]))
    assert len(back) == 22_050
    expected = np.sin(2 * np.pi * 100 / 44_100 * np.arange(22_050))
    assert np.abs(back - expected)[2000:-2000].max() < 0.03  # two samples at 44.1 kHz


@pytest.mark.parametrize("n_channels", [1, 2])
def test_opus_is_what_libsndfile_reads(n_channels: int) -> None:
    sound = resample_whole(MONO, 44_100, 48_000)
    data = opus_of(np.repeat(sound[:, np.newaxis], n_channels, axis=1))
    whole = IncomingSound(StreamFormat(F32, 48_000))
    expected = np.concatenate([*whole.pieces(at_48_khz(data).tobytes()), whole.finish()])
    for places in ([], [1, 27, 28, 500, 501]):
        found = taken(StreamFormat(OPUS), cut(data, places))
        assert len(found) == len(expected)
        assert np.abs(found - expected).mean() < (1e-6 if n_channels == 1 else 1e-3)  # decoders differ in stereo


def test_opus_streams_may_follow_each_other() -> None:
    one, other = opus_of(resample_whole(MONO, 44_100, 48_000)), opus_of(resample_whole(MONO[::-1], 44_100, 48_000))
    found = taken(StreamFormat(OPUS), [one + other])
    both = np.concatenate([at_48_khz(one), at_48_khz(other)])
    expected = taken(StreamFormat(F32, 48_000), [both.tobytes()])
    assert len(found) == len(expected)
    assert np.abs(found - expected).max() < 1e-4


@given(st.data())
def test_damaged_opus_is_refused_or_heard_and_nothing_else(data: st.DataObject) -> None:
    content = bytearray(OPUS_BYTES)
    for _ in range(data.draw(st.integers(1, 8))):
        content[data.draw(st.integers(0, len(content) - 1))] = data.draw(st.integers(0, 255))
    with suppress(AudioError):
        assert np.isfinite(taken(StreamFormat(OPUS), [bytes(content)])).all()


OPUS_BYTES = opus_of(resample_whole(MONO, 44_100, 48_000))


@pytest.mark.parametrize(
    ("form", "data", "words"),
    [
        (StreamFormat(F32), np.array([1e30], np.float32).tobytes(), "check the format"),
        (StreamFormat(S16), b"123", "cut off after 0.000 s"),
        (StreamFormat(OPUS), b"OggX", "this is not Ogg Opus"),
        (StreamFormat(OPUS), OPUS_BYTES[:-10], "cut off"),
        (StreamFormat(OPUS), OPUS_BYTES.replace(b"OpusHead\1\1", b"OpusHead\1\6"), "has 6 channels"),
        (StreamFormat(OPUS), OPUS_BYTES.replace(b"OpusTags", b"VorbTags"), "damaged"),
    ],
)
def test_what_is_no_sound_is_refused(form: StreamFormat, data: bytes, words: str) -> None:
    with pytest.raises(AudioError, match=words):
        taken(form, [data])


def test_what_is_not_finite_is_silence_and_counted() -> None:
    broken = MONO[:9000].copy()
    broken[[0, 17, 8999]] = np.nan, np.inf, -np.inf
    sound = IncomingSound(StreamFormat(F32))
    found = np.concatenate([*sound.pieces(broken.tobytes()), sound.finish()])
    np.testing.assert_array_equal(found, np.where(np.isfinite(broken), broken, 0))
    assert sound.n_silenced == 3


@pytest.mark.parametrize(("rate", "n_channels"), [(0, 1), (999, 1), (768_001, 1), (44_100, 0), (44_100, 9), (-1, 1)])
def test_impossible_formats_are_refused(rate: int, n_channels: int) -> None:
    with pytest.raises(AudioError, match=r"\.\."):
        StreamFormat(F32, rate, n_channels)


def test_pages_of_other_streams_are_passed_over() -> None:
    page = b"OggS\0\2" + bytes(8) + b"\7\0\0\0" + bytes(8) + b"\1\4abcd"
    first = OPUS_BYTES.index(b"OggS", 4)
    found = taken(StreamFormat(OPUS), [OPUS_BYTES[:first] + 5000 * page + OPUS_BYTES[first:]])
    assert np.array_equal(found, taken(StreamFormat(OPUS), [OPUS_BYTES]))
