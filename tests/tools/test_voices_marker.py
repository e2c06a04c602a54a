"""The marker voice: a twin of an HTS voice that tells its phones."""

import re
import struct

import numpy as np
import pytest

from tools.voices.marker import RHVOICE, code_of, marker_file, pulses, segments_marked

PHONES = ["aa", "b", "pau", "s", "m"]
VOICE = (
    b"[GLOBAL]\nNUM_STATES:5\n[STREAM]\nVECTOR_LENGTH[MCP]:31\nVECTOR_LENGTH[LF0]:1\nVECTOR_LENGTH[BAP]:7\n"
    b"NUM_WINDOWS[MCP]:3\nNUM_WINDOWS[LF0]:3\nNUM_WINDOWS[BAP]:3\nUSE_GV[MCP]:1\n"
    b"[POSITION]\nDURATION_PDF:0-3\nDURATION_TREE:4-8\nSTREAM_PDF[MCP]:9-12\n[DATA]\nDDDDTTTTTMMMM"
)


def parts_of(file: bytes) -> dict[str, bytes]:
    head, data = file.split(b"[DATA]\n", 1)
    places = re.findall(r"^(\S+):(\d+)-(\d+)$", head.decode(), re.MULTILINE)
    return {name: data[int(first) : int(last) + 1] for name, first, last in places}


def test_a_marker_keeps_the_durations_of_its_voice() -> None:
    parts = parts_of(marker_file(VOICE, PHONES))
    assert parts["DURATION_PDF"] == b"DDDD"
    assert parts["DURATION_TREE"] == b"TTTTT"
    assert parts["STREAM_PDF[MCP]"] != b"MMMM"


def test_a_marker_has_one_sound_for_each_phone_and_one_for_none() -> None:
    sounds = parts_of(marker_file(VOICE, PHONES))["STREAM_PDF[MCP]"]
    assert struct.unpack("<5i", sounds[:20]) == (len(PHONES) + 1,) * 5
    assert len(sounds) == 20 + 5 * (len(PHONES) + 1) * 2 * 31 * 4


def test_a_marker_neither_smooths_nor_varies() -> None:
    head = marker_file(VOICE, PHONES).split(b"[POSITION]")[0]
    assert head.count(b"]:1\n") == 4  # one window for each of three streams, and LF0 has one value
    assert b"USE_GV[MCP]:0" in head


def test_phones_and_their_times_are_read_off_a_marked_sound() -> None:
    spoken = [("pau", 6), ("s", 7), ("aa", 12), ("m", 5), ("pau", 9)]
    frames = [pulses(*code_of(PHONES.index(name)), RHVOICE) for name, count in spoken for _ in range(count)]
    segments = segments_marked(0.37 * np.concatenate(frames), PHONES)
    assert [(segment.phone, round((segment.end - segment.start) / 0.005)) for segment in segments] == spoken


def test_a_marked_sound_is_read_though_each_phone_glides_in_for_a_frame() -> None:
    one, other = (pulses(*code_of(PHONES.index(name)), RHVOICE) for name in ("pau", "m"))
    glide = (one + other) / 2
    segments = segments_marked(np.concatenate([*[one] * 6, glide, *[other] * 5]), PHONES)
    assert [(segment.phone, segment.start, segment.end) for segment in segments] == [
        ("pau", 0.0, 0.03),
        ("m", 0.03, 0.06),
    ]


def test_a_sound_without_marks_is_refused() -> None:
    marks = [pulses(*code_of(2), RHVOICE)] * 6
    noise = np.random.default_rng(1).normal(0, 1, 6 * 120)
    with pytest.raises(ValueError, match="fit no phone"):
        segments_marked(np.concatenate([*marks, noise, *marks]), PHONES)


def test_there_is_a_code_for_every_phone_of_the_largest_language() -> None:
    assert len({code_of(index) for index in range(56)}) == 56
    with pytest.raises(ValueError, match="room for 56"):
        code_of(56)
