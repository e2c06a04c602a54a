"""Opus in Ogg pages, and texts that come along, are heard in streams as in whole sounds."""

import io
from collections.abc import Sequence

import aiohttp
import numpy as np
import pytest
import soundfile

from phonemeengine import align, load_preset
from phonemeengine.audio.incoming import Encoding, IncomingSound, StreamFormat
from phonemeengine.audio.resampling import resample_whole
from tests.server.conftest import RECORDING, TEXT
from tests.server.servers import cut, spoken_to, streamed
from tests.server.test_streams import check, heard
from tests.sounds import Sound

OPUS = {"encoding": "opus"}


@pytest.fixture(scope="session")
def opus(recording: Sound) -> bytes:
    """The recording as Ogg Opus."""
    file = io.BytesIO()
    soundfile.write(file, resample_whole(recording, 44_100, 48_000), 48_000, format="OGG", subtype="OPUS")
    return file.getvalue()


@pytest.mark.parametrize("sizes", [[1 << 20], [4001, 1, 26]], ids=str)
def test_opus_is_heard_as_the_file_is(server: str, opus: bytes, sizes: Sequence[int]) -> None:
    told = streamed(server, OPUS, cut(opus, sizes))
    sound = IncomingSound(StreamFormat(Encoding.OPUS))
    check(told, heard(np.concatenate([*sound.pieces(opus), sound.finish()]), delay=sound.delay))


@pytest.mark.parametrize(
    ("content", "words"),
    [(b"RIFF1234WAVEfmt ", "this is not Ogg Opus"), (b"OggS\0\2" + bytes(20) + b"\1\4abcd", "this is not Ogg Opus")],
)
def test_what_is_not_opus_is_answered_by_a_sentence(server: str, content: bytes, words: str) -> None:
    assert words in streamed(server, OPUS, [content]).error


def test_opus_that_is_cut_off_or_damaged_is_answered_by_a_sentence(server: str, opus: bytes) -> None:
    told = streamed(server, OPUS, cut(opus[: len(opus) // 2], [1000]))
    assert "cut off" in told.error
    assert len(told.column("phonemes")) > 50
    damaged = bytearray(opus)
    damaged[len(opus) // 2 :: 2] = bytes(len(damaged[len(opus) // 2 :: 2]))
    assert "damaged" in streamed(server, OPUS, cut(bytes(damaged), [1000])).error


def test_words_are_found_as_they_are_said_and_settle(server: str, recording: Sound) -> None:
    start = {"encoding": "f32", "rate": 44_100, "language": "de", "text": TEXT}
    told = streamed(server, start, cut(recording.tobytes(), [4 * 882]))
    offline = align(RECORDING, TEXT, load_preset("learned"), language="de")
    words = told.words()
    assert [word["word"] for word in words] == [word.text for word in offline.words]
    starts = np.array([(word["start"], known.start) for word, known in zip(words, offline.words, strict=True)])
    assert np.abs(starts[:, 0] - starts[:, 1]).max() < 0.1
    assert [p["phone"] for p in words[0]["phones"]] == [phone.ipa for phone in offline.words[0].phones]
    early = next(message for message in told.messages if message.get("open"))
    assert early["open"][0]["word"] == "Meine"
    assert "other_text" not in told.messages[-1]


def test_a_text_that_comes_in_pieces_is_the_same_text(server: str, recording: Sound) -> None:
    data = recording.tobytes()
    halves = TEXT.partition("und")

    async def speak(client: aiohttp.ClientWebSocketResponse) -> None:
        await client.send_json({"encoding": "f32", "rate": 44_100, "language": "de", "text": halves[0]})
        for k, block in enumerate(cut(data, [4 * 4410])):
            if k == 8:
                await client.send_json({"text": halves[1] + halves[2]})
            await client.send_bytes(block)
        await client.send_json({"end": True})

    said = [word["word"] for word in spoken_to(server, speak).words()]
    assert said == ["Meine", "Mama", "mag", "Musik", "und", "mein", "Papa", "backt", "am", "Samstag", "Pizza"]


def test_it_is_told_that_another_text_is_said(server: str, recording: Sound) -> None:
    other = "the quick brown fox jumps over the lazy dog while seven wizards box with shapeless jelly"
    start = {"encoding": "f32", "rate": 44_100, "language": "en-us", "text": other}
    assert streamed(server, start, cut(recording.tobytes(), [4 * 882])).messages[-1]["other_text"]


def test_chinese_texts_are_read_as_pinyin(server: str, recording: Sound) -> None:
    start = {"encoding": "f32", "rate": 44_100, "language": "cmn", "text": "你好"}
    assert streamed(server, start, [recording.tobytes()]).code == 1000


def test_a_stream_has_no_more_text_than_allowed(server: str) -> None:
    start = {"encoding": "f32", "rate": 44_100, "language": "de", "text": "wort " * 20_001}
    assert "a text of 100000 characters" in streamed(server, start, []).error
