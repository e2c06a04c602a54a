"""The makers of training speech from people's recordings: formats of games' files, syllables of Mandarin."""

import io
import shutil
import subprocess
import zipfile
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
import soundfile

from phonemeengine.calibration.scores.added_noise import desk, music
from phonemeengine.calibration.scores.corpus import read_corpus
from phonemeengine.phonemes import Phoneme
from tools.voices import drascula, gcin, nexuiz, queen, recordings, sky
from tools.voices.aligner import aligned, best_track, sharpened
from tools.voices.build import build
from tools.voices.classes import PLAIN, table_of
from tools.voices.gcin import MANDARIN, phones_of
from tools.voices.labels import Segment
from tools.voices.no_speech import ABOUT, LEVELS, Make, noise, recording_of, tones
from tools.voices.packages import RECORDINGS, missing, unpack
from tools.voices.rnc import unpacked
from tools.voices.writing import UtteranceWriter, replace_speaker

RATE = 16000


def tone(hertz: float, seconds: float, rate: int = RATE) -> np.ndarray:
    return 0.5 * np.sin(2 * np.pi * hertz * np.arange(int(seconds * rate)) / rate)


def sound_file(sound: np.ndarray, rate: int = RATE, kind: str = "OGG") -> bytes:
    file = io.BytesIO()
    soundfile.write(file, sound, rate, format=kind)
    return file.getvalue()


def samples_of_8_bits(seconds: float) -> bytes:
    return (tone(200, seconds, 11025) * 127 + 128).astype(np.uint8).tobytes()


def put(path: Path, content: bytes) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(content)


def archive_of_queen(files: dict[str, bytes]) -> bytes:
    offset, entries = queen.HEAD + queen.ENTRY * len(files), b""
    for name, content in files.items():
        entries += name.encode().ljust(queen.NAME, b"\0") + b"\x01"
        entries += offset.to_bytes(4, "big") + len(content).to_bytes(4, "big")
        offset += len(content)
    return b"QTBLCEM10\0\0\0\1" + len(files).to_bytes(2, "big") + entries + b"".join(files.values())


def disk_of_sky(files: dict[int, bytes]) -> tuple[bytes, bytes]:
    table, disk = len(files).to_bytes(4, "little"), b""
    for number, content in files.items():
        disk = disk.ljust(-(-len(disk) // 16) * 16, b"\0")
        offset = len(disk) // 16 | sky.BY_16
        table += number.to_bytes(2, "little") + offset.to_bytes(3, "little") + len(content).to_bytes(3, "little")
        disk += content
    return table, disk


def packed(bits: str, plain: list[tuple[int, bytes]], size: int) -> bytes:
    """A packed file of one block: its bits in order of time, and bytes that stand before the word of a number."""
    data = b""
    for word in range(-(-len(bits) // 16)):
        data += b"".join(content for before, content in plain if before == word)
        data += int(bits[16 * word : 16 * word + 16].ljust(16, "0")[::-1], 2).to_bytes(2, "little")
    data += b"".join(content for before, content in plain if before == -1)
    return b"RNC\1" + size.to_bytes(4, "big") + len(data).to_bytes(4, "big") + bytes(5) + b"\1" + data


def low_first(number: int, bits: int) -> str:
    return format(number, f"0{bits}b")[::-1]


def table_of_lengths(*lengths: int) -> str:
    return low_first(len(lengths), 5) + "".join(low_first(length, 4) for length in lengths)


def test_a_packed_file_is_unpacked() -> None:
    bits = "00" + table_of_lengths(0, 1, 1) + table_of_lengths(0, 0, 1) + table_of_lengths(0, 0, 0, 1)
    bits += low_first(2, 16)
    bits += "1" + "1"  # 3 plain bytes, abc: 81 bits so far are needed before the next number
    bits += "0" + "0"  # from 3 back
    bits += "0" + "00"  # 4 + 2 of them
    bits += "0"  # 1 plain byte
    assert unpacked(packed(bits, [(5, b"abc"), (-1, b"!")], 10)) == b"abcabcabc!"


def test_a_packed_file_of_the_wrong_size_is_refused() -> None:
    bits = "00" + table_of_lengths(0, 1) + table_of_lengths() + table_of_lengths() + low_first(1, 16) + "0"
    with pytest.raises(ValueError, match="damaged"):
        unpacked(packed(bits, [(-1, b"!")], 2))


def test_lines_of_the_amazon_queen_go_to_the_hero_and_to_each_dialogue(tmp_path: Path) -> None:
    line, other = sound_file(tone(200, 0.5, 11025), 11025, "MP3"), sound_file(tone(300, 0.5, 11025), 11025, "MP3")
    third = sound_file(tone(250, 0.6, 11025), 11025, "MP3")
    files = {"020001P2.SB": line, "020006J1.SB": other, "JOE01121.SB": third, "27SSSSSS.SB": third + b"\0"}
    files |= {"CDINT061.SB": line, "ZOMBIE1.DOG": other + b"\0"}  # the first as before, the last no sound
    put(tmp_path / "packages" / RECORDINGS["queen"] / queen.ARCHIVE, archive_of_queen(files))
    spoken = {voice.speaker.name: [*voice.utterances()] for voice in queen.voices(tmp_path)}
    assert {name: len(utterances) for name, utterances in spoken.items()} == {"02": 1, "hero": 2}
    assert spoken["02"][0].sample_rate == 11025
    assert len(spoken["02"][0].sound) / 11025 == pytest.approx(0.5, abs=0.2)


def test_lines_of_drascula_go_to_the_voice_of_their_prefix(tmp_path: Path) -> None:
    folder = tmp_path / "packages" / RECORDINGS["drascula"] / drascula.FOLDER
    for name in ("12.ALS", "VB3.ALS", "VB4.ALS", "S2.ALS"):
        put(folder / name, samples_of_8_bits(0.5))
    spoken = {voice.speaker.name: [*voice.utterances()] for voice in drascula.voices(tmp_path)}
    assert {name: len(utterances) for name, utterances in spoken.items()} == {"hero": 1, "VB": 2}
    assert np.abs(spoken["hero"][0].sound).max() == pytest.approx(0.5, abs=0.02)


def test_lines_of_a_steel_sky_go_to_their_section(tmp_path: Path) -> None:
    line = bytes(sky.HEAD) + samples_of_8_bits(0.5)
    table, disk = disk_of_sky({50000: line, 50599: line, 51100: line, 60110: line})
    folder = tmp_path / "packages" / RECORDINGS["sky"] / sky.FOLDER
    put(folder / "sky.dnr", table)
    put(folder / "sky.dsk", disk)
    spoken = {voice.speaker.name: [*voice.utterances()] for voice in sky.voices(tmp_path)}
    assert {name: len(utterances) for name, utterances in spoken.items()} == {"section0": 2, "section2": 1}
    assert len(spoken["section0"][0].sound) == len(line) - sky.HEAD


def test_calls_of_nexuiz_go_to_their_actor(tmp_path: Path) -> None:
    path = tmp_path / "packages" / RECORDINGS["nexuiz"] / nexuiz.ARCHIVE
    path.parent.mkdir(parents=True)
    names = ("player/marine/coms/taunt1.ogg", "player/marine/player/pain25.ogg", "announcer/male/airshot.ogg")
    with zipfile.ZipFile(path, "w") as archive:
        for name in (*names, "player/torus/death1.ogg", "announcer/robotic/1.ogg"):
            archive.writestr(f"sound/{name}", sound_file(tone(200, 0.5)))
    spoken = {voice.speaker.name: [*voice.utterances()] for voice in nexuiz.voices(tmp_path)}
    assert {name: len(utterances) for name, utterances in spoken.items()} == {"marine": 1, "announcer": 1}


@pytest.mark.parametrize(
    ("sound", "is_speech"),
    [
        (tone(200, 1), True),
        (tone(200, 0.2), False),
        (tone(200, 31), False),
        (tone(200, 1) * 0.01, False),
        (np.concatenate([np.zeros(RATE), tone(200, 0.1)]), True),
    ],
    ids=["speech", "short", "long", "quiet", "quiet at first"],
)
def test_silence_and_what_is_short_or_long_is_left_out(sound: np.ndarray, is_speech: bool) -> None:
    assert recordings.is_speech(sound, RATE) == is_speech


def test_a_file_without_a_sound_is_no_speech() -> None:
    assert not recordings.is_speech(*recordings.decoded(b"no sound"))


@pytest.mark.parametrize(
    ("zhuyin", "phones"),
    [
        ("ㄅㄚ", "p a"),
        ("ㄓ", "ʈʂ ɨ"),
        ("ㄕㄨㄤ", "ʂ w a ŋ"),
        ("ㄐㄩㄥ", "tɕ j ʊ ŋ"),
        ("ㄌㄩㄝ", "l ɥ ɛ"),
        ("ㄨㄥ", "w ə ŋ"),
        ("ㄧㄡ", "j oʊ"),
        ("ㄦ", "ɚ"),
        ("ㄅ", ""),
        ("ㄧㄞ", ""),
    ],
)
def test_zhuyin_tells_the_phones(zhuyin: str, phones: str) -> None:
    assert phones_of(zhuyin) == tuple(phones.split())
    assert set(phones.split()) <= set(MANDARIN)


def syllable(seed: int, onset: float, vowel: float) -> np.ndarray:
    """A pause, a hiss, and a tone with overtones, in seconds of each; a pause of 0.1 s."""
    chance = np.random.default_rng(seed)
    voiced = sum(tone(220 * k, vowel) / k for k in range(1, 9)) / 2
    parts = [np.zeros(RATE // 10), chance.normal(0, 0.1, int(onset * RATE)), voiced, np.zeros(RATE // 10)]
    return np.concatenate(parts) + chance.normal(0, 1e-4, sum(map(len, parts)))


def test_the_aligner_finds_where_a_hiss_becomes_a_vowel() -> None:
    onsets = np.linspace(0.08, 0.2, 12)
    found = aligned([syllable(k, onset, 0.3 - onset / 2) for k, onset in enumerate(onsets)], RATE, [("s", "a")] * 12)
    for onset, segments in zip(onsets, found, strict=True):
        assert [segment.phone for segment in segments] == ["pau", "s", "a", "pau"]
        assert segments[1].start == pytest.approx(0.1, abs=0.02)
        assert segments[2].start == pytest.approx(0.1 + onset, abs=0.015)
        assert all(before.end == after.start for before, after in pairwise(segments))


def test_a_boundary_moves_to_where_the_sound_changes_most() -> None:
    table = np.zeros((40, 26))
    table[17:] = 1.0
    assert sharpened(np.array([0, 12, 30]), table).tolist() == [0, 17, 22]  # at 22 to 38 nothing changes


def test_the_best_track_goes_from_the_first_place_to_the_last() -> None:
    scores = np.array([[0, 9, 9], [1, 0, 9], [0, 1, 0], [0, 2, 1], [9, 9, 0]])
    assert best_track(scores).tolist() == [0, 0, 1, 1, 2]


def test_a_stop_begins_before_its_burst_and_ends_when_the_lips_open() -> None:
    segments = [Segment(0, 0.1, "pau"), Segment(0.1, 0.2, "pʰ"), Segment(0.2, 0.4, "a")]
    found = [(phone, round(start, 3), round(end, 3)) for start, end, phone in gcin.with_closures(segments)]
    assert found == [("pau", 0, 0.07), ("pʰ", 0.07, 0.12), ("h", 0.12, 0.2), ("a", 0.2, 0.4)]
    vowel = [Segment(0, 0.1, "pau"), Segment(0.1, 0.4, "a")]
    assert gcin.with_closures(vowel) == vowel


def test_people_are_written_whole_and_read_back(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = tmp_path / "cache" / "packages" / RECORDINGS["gcin"] / gcin.FOLDER
    for k, name in enumerate(("ㄙㄚ", "ㄙㄚ2", "ㄙㄚ3", "ㄙㄚ4", "ㄅ")):
        put(folder / name / gcin.FILE, sound_file(syllable(k, 0.12, 0.3)))
    build(tmp_path / "corpus", tmp_path / "cache", ["gcin"], 0.001)
    utterances = read_corpus(tmp_path / "corpus", unlabelled=True)
    assert {utterance.text: len(utterance.labels) > 0 for utterance in utterances} == {
        **dict.fromkeys(("ㄙㄚ", "ㄙㄚ2", "ㄙㄚ3", "ㄙㄚ4"), True),
        "ㄅ": False,
    }
    rates = {utterance.text: soundfile.info(utterance.path).samplerate for utterance in utterances}
    assert rates["ㄅ"] == RATE  # without labels as it was
    assert rates["ㄙㄚ"] == 44100
    pytest.importorskip("tools.voices.check").check(tmp_path / "corpus")
    printed = capsys.readouterr().out.splitlines()[-1].split("\t")
    assert printed[0] == "gcin/3"
    assert abs(int(printed[-1])) <= 10  # ms by which the labels are off


@pytest.mark.skipif(shutil.which("dpkg-deb") is None, reason="packages of Debian are unpacked on Debian")
def test_of_a_package_with_a_reserved_speaker_the_other_one_is_unpacked(tmp_path: Path) -> None:
    whole, folder = tmp_path / "whole", Path(gcin.FOLDER) / "ㄅㄚ"
    put(
        whole / "DEBIAN" / "control",
        b"Package: gcin-voice\nVersion: 1\nArchitecture: all\nMaintainer: a\nDescription: a\n",
    )
    for name in (gcin.FILE, "5.ogg"):
        put(whole / folder / name, b"sound")
    subprocess.run(["dpkg-deb", "--build", str(whole), str(tmp_path / "gcin.deb")], check=True, capture_output=True)
    for name, unpacked_files in ((RECORDINGS["gcin"], ["3.ogg"]), ("others", ["3.ogg", "5.ogg"])):
        unpack(tmp_path / "gcin.deb", tmp_path / name)
        assert sorted(path.name for path in (tmp_path / name / folder).iterdir()) == unpacked_files


def test_a_cache_without_the_recordings_lacks_them(tmp_path: Path) -> None:
    for name in ("venv/bin/python", *(f"packages/{package}/readme" for package in RECORDINGS.values())):
        assert missing(tmp_path)
        put(tmp_path / name, b"")
    assert missing(tmp_path) == []


@pytest.mark.parametrize("make", [music, desk, tones, noise])
def test_a_sound_without_speech_has_one_label_and_a_level(make: Make, tmp_path: Path) -> None:
    utterance = recording_of(make, np.random.default_rng(2))
    level = 10 * np.log10(np.mean(utterance.sound**2))
    assert LEVELS[0] - 0.1 <= level <= LEVELS[1] + 0.1
    writer = UtteranceWriter(tmp_path, ABOUT, table_of(*PLAIN))
    writer.write(utterance)
    replace_speaker(tmp_path, ABOUT, writer.rows)
    (found,) = read_corpus(tmp_path)
    assert [(label.start, label.end, label.phoneme) for label in found.labels] == [(0.0, 8.0, Phoneme.SILENCE)]
