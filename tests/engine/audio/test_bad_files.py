"""What cannot be read is refused at once, with one sentence that says what to do."""

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import soundfile

from phonemeengine.audio.files import SoundReader
from phonemeengine.errors import AudioError
from phonemeengine.settings import SAMPLE_RATE, Channel
from tests.bad_files import (
    BAD_FILES,
    CUT_OFF,
    DAMAGED,
    FMT,
    HOSTILE,
    LYING,
    NEVER_FINISHED,
    ODD_FILES,
    SAMPLES,
    a_sound,
    chunk,
    riff,
)
from tests.disks import locked

READ_ALL = """
import sys
from pathlib import Path
from phonemeengine.audio.files import SoundReader
from phonemeengine.errors import AudioError
try:
    with SoundReader(Path(sys.argv[1])) as reader:
        for _ in reader.blocks(10_000): pass
except AudioError as error:
    print(error)
"""


def refusal_of(path: Path) -> str:
    with pytest.raises(AudioError) as refusal, SoundReader(path) as reader:
        for _ in reader.blocks(10_000):
            pass
    return str(refusal.value)


@pytest.mark.parametrize("name", [n for n in BAD_FILES if n not in HOSTILE])
def test_a_bad_file_is_refused_in_one_sentence_that_begins_with_its_name(name: str, tmp_path: Path) -> None:
    path = BAD_FILES[name](tmp_path)
    message = refusal_of(path)
    assert message.startswith(f"{path.name}: ".replace("\n", "?"))
    assert message.isprintable()
    assert ". " not in message
    assert not message.endswith(".")
    assert len(message) < 250


@pytest.mark.parametrize("name", HOSTILE)
def test_a_hostile_file_is_refused_rather_than_read_for_ever(name: str, tmp_path: Path) -> None:
    path = HOSTILE[name](tmp_path)
    command = [sys.executable, "-c", READ_ALL, str(path)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=240, check=True)
    message = done.stdout.strip()
    assert message.startswith(f"{path.name}: the sizes in its header do not match the file (")
    assert "\n" not in message


@pytest.mark.parametrize("name", LYING)
def test_sizes_that_lie_are_named(name: str, tmp_path: Path) -> None:
    with pytest.raises(AudioError, match=r"the sizes in its header do not match the file .*export it again"):
        SoundReader(LYING[name](tmp_path))


@pytest.mark.parametrize("name", DAMAGED)
def test_damage_in_the_middle_shows_when_it_is_met(name: str, tmp_path: Path) -> None:
    with SoundReader(DAMAGED[name](tmp_path)) as reader:
        assert len(reader.read(4410)) == 4410
        with pytest.raises(AudioError, match=r" \d\.\d{3} s"):
            reader.read(reader.n_samples)


def test_the_place_of_a_number_that_is_none_is_named(tmp_path: Path) -> None:
    assert f"at {30_000 / SAMPLE_RATE:.3f} s" in refusal_of(DAMAGED["not_a_number"](tmp_path))


def test_a_number_too_large_for_a_sample_counts_as_infinite(tmp_path: Path) -> None:
    path = tmp_path / "large.wav"
    soundfile.write(path, np.full(100, 1e300), SAMPLE_RATE, subtype="DOUBLE")
    assert "infinity" in refusal_of(path)


def test_a_rate_too_low_for_speech_is_refused_with_the_limits(tmp_path: Path) -> None:
    assert refusal_of(BAD_FILES["one_hertz"](tmp_path)) == (
        "one_hertz.wav: its sample rate of 1 Hz is too low to hold speech; it must lie in 1000..768000 Hz, "
        "so export it again at 44100 Hz"
    )


@pytest.mark.skipif(not hasattr(os, "geteuid"), reason="Windows keeps permissions elsewhere")
@pytest.mark.parametrize("what", ["file", "folder"])
def test_what_may_not_be_read_or_entered_is_refused(what: str, tmp_path: Path) -> None:
    path = ODD_FILES["one_sample"](tmp_path)
    with locked(path if what == "file" else tmp_path):
        said = refusal_of(path)
    assert said == "one_sample.wav: reading it is not permitted; change its permissions or copy it"


@pytest.mark.parametrize("name", ["x" * 300 + ".wav", "nul\0l.wav"])
def test_a_name_that_no_file_can_have_is_refused(name: str, tmp_path: Path) -> None:
    assert refusal_of(tmp_path / name).isprintable()


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="this system has no pipes with names")
def test_a_pipe_is_refused_without_waiting_for_its_writer(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe.wav")
    assert "not an audio file" in refusal_of(tmp_path / "pipe.wav")


@pytest.mark.parametrize("name", ODD_FILES)
def test_an_unusual_file_is_read_to_its_end(name: str, tmp_path: Path) -> None:
    with SoundReader(ODD_FILES[name](tmp_path)) as reader:
        assert sum(len(block) for block in reader.blocks(1000)) == reader.n_samples


@pytest.mark.parametrize("name", CUT_OFF)
def test_a_file_that_was_cut_off_is_read_as_far_as_it_goes_and_says_so(name: str, tmp_path: Path) -> None:
    with SoundReader(CUT_OFF[name](tmp_path)) as reader:
        assert reader.cut_off in reader.notes
        assert f"contains {reader.duration:.3f} s" in reader.cut_off or "audio, which is complete" in reader.cut_off
        sound = np.concatenate(list(reader.blocks(1000)))
        assert len(sound) == reader.n_samples > 2000
        reader.seek(1500)
        np.testing.assert_array_equal(next(reader.blocks(100)), sound[1500:1600])
        if name.startswith(("truncated", "cut_")) and "behind" not in name and name != "cut_and_tagged":
            assert 1.6 < reader.duration < 1.81
            assert np.corrcoef(sound, a_sound(3.0)[: len(sound)])[0, 1] > 0.9


def test_of_three_seconds_as_many_are_said_to_be_there_as_are_read(tmp_path: Path) -> None:
    with SoundReader(CUT_OFF["truncated_wav"](tmp_path)) as reader:
        assert reader.cut_off == "the file is truncated; its header announces 3.000 s, but it contains 1.800 s"
    with SoundReader(CUT_OFF["streamed_all_ones"](tmp_path)) as reader:
        assert reader.cut_off == "the header gives no duration; the file contains 0.200 s"


@pytest.mark.parametrize("name", NEVER_FINISHED)
def test_a_header_that_was_never_finished_does_not_shorten_the_sound(name: str, tmp_path: Path) -> None:
    path = NEVER_FINISHED[name](tmp_path)
    expected = np.frombuffer(SAMPLES, "<i2") / np.float32(1 << 15)
    if len(path.read_bytes()) > 2 * len(SAMPLES):
        expected = a_sound()
    with SoundReader(path) as reader:
        assert reader.n_samples == len(expected)
        np.testing.assert_allclose(reader.read_mono(), expected, atol=1e-4)
        assert reader.cut_off == f"the header gives no duration; the file contains {reader.duration:.3f} s"


def test_a_flac_that_was_killed_in_a_pipe_is_read_up_to_its_last_whole_frame(tmp_path: Path) -> None:
    path = NEVER_FINISHED["flac_of_unknown_length"](tmp_path)
    path.write_bytes(path.read_bytes()[:-1000])
    with SoundReader(path) as reader:
        assert reader.n_samples % 4096 == 0
        assert 0 < len(a_sound()) - reader.n_samples < 2 * 4096
        np.testing.assert_allclose(reader.read_mono(), a_sound()[: reader.n_samples], atol=1e-4)


def test_a_wav_without_samples_stays_empty_though_other_chunks_follow(tmp_path: Path) -> None:
    path = tmp_path / "none.wav"
    path.write_bytes(riff(chunk(b"fmt ", FMT), chunk(b"data", b""), chunk(b"note", b"nothing here")))
    assert refusal_of(path).endswith("there are no samples in it; record or export it again")


@pytest.mark.parametrize("length", range(0, 300, 13))
def test_wherever_a_wav_is_cut_it_is_read_or_refused(length: int, tmp_path: Path) -> None:
    path = tmp_path / "cut.wav"
    samples = chunk(b"data", SAMPLES[:200])
    whole = riff(chunk(b"fmt ", FMT), samples, chunk(b"LIST", b"INFO" + chunk(b"INAM", b"name")))
    path.write_bytes(whole[:length])
    n = min((length - 44) // 2, 100)
    if n < 1:
        refusal_of(path)
        return
    with SoundReader(path) as reader:
        assert sum(len(block) for block in reader.blocks(100)) == n
        assert ("header announces" in reader.cut_off) == (n < 100)


def test_one_sample_is_a_sound_with_a_remark(tmp_path: Path) -> None:
    with SoundReader(ODD_FILES["one_sample"](tmp_path)) as reader:
        assert reader.n_samples == 1
        assert reader.notes == ("shorter than one window (46 ms), padded with silence",)
        np.testing.assert_allclose(reader.read(10)[:, 0], a_sound()[:1], atol=1e-4)


@pytest.mark.parametrize(
    ("channel", "remark"),
    [
        (Channel.MIX, "200 channels are mixed to one"),
        (Channel.LEFT, "only channel 1 of 200 is used"),
        (Channel("150"), "only channel 150 of 200 is used"),
        (Channel.RIGHT, "only channel 2 of 200 is used"),
    ],
)
def test_two_hundred_channels_become_one_with_a_remark(channel: Channel, remark: str, tmp_path: Path) -> None:
    with SoundReader(ODD_FILES["two_hundred_channels"](tmp_path), channel) as reader:
        assert (reader.n_file_channels, reader.n_channels, reader.notes) == (200, 1, (remark,))
        np.testing.assert_allclose(reader.read(22_050)[:, 0], a_sound(0.5), atol=1e-4)


def test_junk_behind_the_last_chunk_is_no_part_of_the_sound(tmp_path: Path) -> None:
    with SoundReader(ODD_FILES["trailing_junk"](tmp_path)) as reader:
        assert reader.n_samples == a_sound(0.1).nbytes // 2


def n_read() -> int:
    """Give the bytes that this process has read so far."""
    return int(Path("/proc/self/io").read_text().split()[1])


@pytest.mark.skipif(not Path("/proc/self/io").exists(), reason="only Linux counts what a process reads")
def test_large_files_are_checked_by_their_headers_alone(tmp_path: Path) -> None:
    path = tmp_path / "large.rf64"
    soundfile.write(path, a_sound(0.1), SAMPLE_RATE, format="RF64")
    content = bytearray(path.read_bytes())
    data = content.index(b"data")
    n_bytes = 1 << 32  # more than 32 bits can say
    content[20:28] = (data + n_bytes).to_bytes(8, "little")
    content[28:36] = n_bytes.to_bytes(8, "little")
    content[36:44] = (n_bytes // 2).to_bytes(8, "little")
    content[data + 4 : data + 8] = b"\xff" * 4
    path.write_bytes(content)
    with path.open("r+b") as file:
        file.truncate(data + 8 + n_bytes)  # a hole, which takes no room on the disk
    before = n_read()
    with SoundReader(path) as reader:
        assert reader.n_samples == n_bytes // 2
        reader.seek(reader.n_samples - 100)
        assert len(reader.read(1000)) == 100
    assert 0 < n_read() - before < 1 << 20
