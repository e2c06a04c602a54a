"""Whatever happens to the disk, one sentence says it, and what was recorded stays playable."""

import os
import shutil
import subprocess
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from phonemeengine.audio.journal import interrupted_recordings
from phonemeengine.audio.wav import HEADER
from phonemeengine.errors import RecordingError
from tests.fakes.recorders import begun, check_kept, check_sentence, samples_of_16_bits
from tests.waiting import wait_for

SUFFIXES = [".wav", ".flac"]
RATE = 16_000


# -- a full disk --------------------------------------------------------------------------------------------------


@pytest.fixture
def mounted(tmp_path: Path) -> Iterator[Callable[..., Path]]:
    """Mounts a disk of its own, which most systems allow only to root."""
    places: list[Path] = []

    def mount(name: str, *options: str) -> Path:
        place = tmp_path / name
        place.mkdir()
        command = ["mount", "-t", "tmpfs", "-o", ",".join(options), "tmpfs", str(place)]
        try:
            subprocess.run(command, check=True, capture_output=True)
        except (OSError, subprocess.CalledProcessError):
            pytest.skip("this user may not mount a disk")
        places.append(place)
        return place

    yield mount
    for place in places:
        subprocess.run(["umount", "-l", str(place)], check=True)


@pytest.mark.parametrize("suffix", SUFFIXES)
@pytest.mark.parametrize("n_channels", [1, pytest.param(2, marks=pytest.mark.long)])
def test_a_full_disk_stops_the_recording_with_one_sentence(
    suffix: str, n_channels: int, mounted: Callable[..., Path], tmp_path: Path
) -> None:
    disk = mounted("disk", "size=256k")
    recording = begun(disk / f"take{suffix}", RATE, n_channels, journal=tmp_path / "journal")
    n_given = 0
    while recording.failure is None and n_given < 100 * RATE:
        recording.write(samples_of_16_bits(n_given, 1600, n_channels))
        n_given += 1600
        wait_for(lambda: recording.failure or recording.n_samples >= n_given - RATE)  # noqa: B023 - it is over at once
    wait_for(lambda: recording.failure)
    recording.close()
    sentence = check_sentence(recording, f"take{suffix}")
    assert sentence == (
        f"take{suffix}: the disk is full, so the recording stopped after {int(recording.seconds * 10) / 10:.1f} s, "
        f"which are kept in {disk}; free some space or record to another disk"
    )
    assert recording.n_samples * n_channels > 60_000
    check_kept(recording.path, recording.n_samples, n_channels)
    assert interrupted_recordings(tmp_path / "journal") == []


@pytest.fixture
def limited() -> Iterator[None]:
    """Files of this process may have 300,003 bytes; one more is an error, since Python ignores the signal."""
    resource = pytest.importorskip("resource", reason="Windows has no limit for the size of a process's files")
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (300_003, before[1]))
    yield
    resource.setrlimit(resource.RLIMIT_FSIZE, before)


@pytest.mark.usefixtures("limited")
@pytest.mark.parametrize("suffix", SUFFIXES)
def test_a_file_that_may_not_grow_stops_the_recording_and_is_full_to_the_last_frame(
    suffix: str, tmp_path: Path
) -> None:
    path = tmp_path / f"take{suffix}"
    recording, n_given = begun(path, RATE), 0
    while recording.failure is None and n_given < 200 * RATE:
        recording.write(samples_of_16_bits(n_given, 1600))
        n_given += 1600
        wait_for(lambda: recording.failure or recording.n_samples >= n_given - RATE)  # noqa: B023 - it is over at once
    recording.close()
    sentence = str(recording.failure)
    assert sentence.startswith(f"take{suffix}: the disk takes no larger file, so the recording stopped after ")
    assert f"which are kept in {tmp_path}; " in sentence
    check_kept(path, recording.n_samples)
    if suffix == ".wav":
        assert recording.n_samples == (300_003 - HEADER) // 3
        assert path.stat().st_size == 300_002  # a byte that fills up to an even length, and no third of a sample
    else:
        assert 290_000 < path.stat().st_size < 300_003  # no part of a frame


def test_no_room_for_a_beginning_is_refused(mounted: Callable[..., Path], tmp_path: Path) -> None:
    disk = mounted("disk", "size=4k")
    (disk / "other").write_bytes(bytes(4096))
    with pytest.raises(
        RecordingError, match=r"^take\.wav: the disk is full, so nothing can be recorded; free some space"
    ):
        begun(disk / "take.wav", journal=tmp_path / "journal")
    assert not (disk / "take.wav").exists()


def test_a_full_disk_from_the_first_sample_leaves_no_empty_file(mounted: Callable[..., Path], tmp_path: Path) -> None:
    disk = mounted("disk", "size=4k")
    (disk / "other").write_bytes(bytes(4096))
    recording = begun(disk / "take.flac", journal=tmp_path / "journal")
    recording.write(samples_of_16_bits(0, RATE))
    wait_for(lambda: recording.failure)
    recording.close()
    sentence = check_sentence(recording, "take.flac")
    assert (
        sentence == "take.flac: the disk is full, so nothing was recorded; free some space or record to another disk"
    )
    assert not (disk / "take.flac").exists()


# -- a folder that may not be written -----------------------------------------------------------------------------


def test_a_read_only_disk_is_refused(mounted: Callable[..., Path]) -> None:
    disk = mounted("disk", "ro")
    with pytest.raises(RecordingError, match=r"^take\.wav: it cannot be made in .*[Rr]ead-only.*; choose another"):
        begun(disk / "take.wav")


# -- what vanishes ------------------------------------------------------------------------------------------------


def delete_folder(folder: Path) -> None:
    shutil.rmtree(folder)


def delete_file(folder: Path) -> None:
    next(folder.glob("take.*")).unlink()


def rename_folder(folder: Path) -> None:
    folder.rename(folder.with_name("elsewhere"))


def put_another_in_its_place(folder: Path) -> None:
    (path,) = folder.glob("take.*")
    path.unlink()
    path.write_text("another")


@pytest.mark.skipif(os.name == "nt", reason="Windows keeps the folder of an open file")
@pytest.mark.parametrize("suffix", SUFFIXES)
@pytest.mark.parametrize("vanish", [delete_folder, delete_file, rename_folder, put_another_in_its_place])
def test_what_was_recorded_is_saved_when_its_place_vanishes(
    vanish: Callable[[Path], None], suffix: str, tmp_path: Path
) -> None:
    folder, rescue = tmp_path / "folder", tmp_path / "safe" / "rescue"
    folder.mkdir()
    recording = begun(folder / f"take{suffix}", RATE, journal=tmp_path / "journal", rescue=rescue)
    recording.write(samples_of_16_bits(0, RATE))
    wait_for(lambda: recording.n_samples)
    vanish(folder)
    recording.write(samples_of_16_bits(RATE, RATE // 2))
    wait_for(lambda: recording.failure)
    recording.write(samples_of_16_bits(0, RATE))  # too late
    recording.close()
    assert recording.path == rescue / f"take{suffix}"
    assert recording.n_samples >= RATE
    check_kept(recording.path, recording.n_samples)
    seconds = f"{int(recording.seconds * 10) / 10:.1f}"
    assert check_sentence(recording, f"take{suffix}") == (
        f"take{suffix}: its folder or the file itself has gone, so the recording stopped after {seconds} s, "
        f"which are kept in {rescue}; record to another folder"
    )
    if vanish is put_another_in_its_place:
        assert (folder / f"take{suffix}").read_text() == "another"
    assert list((tmp_path / "journal").iterdir()) == []


@pytest.mark.skipif(os.name == "nt", reason="Windows keeps the folder of an open file")
def test_a_folder_that_vanishes_just_before_the_end_loses_nothing(tmp_path: Path) -> None:
    (tmp_path / "folder").mkdir()
    (tmp_path / "rescue").mkdir()
    (tmp_path / "rescue" / "take.wav").write_text("another")
    recording = begun(tmp_path / "folder" / "take.wav", RATE, rescue=tmp_path / "rescue")
    recording.write(samples_of_16_bits(0, 3 * RATE))
    shutil.rmtree(tmp_path / "folder")
    recording.close()
    assert recording.path == tmp_path / "rescue" / "take (2).wav"
    check_sentence(recording, "take.wav")
    check_kept(recording.path, 3 * RATE)


@pytest.mark.skipif(os.name == "nt", reason="Windows keeps the folder of an open file")
@pytest.mark.parametrize("suffix", SUFFIXES)
def test_a_folder_that_vanishes_before_the_first_sample_leaves_nothing_to_save(suffix: str, tmp_path: Path) -> None:
    (tmp_path / "folder").mkdir()
    recording = begun(tmp_path / "folder" / f"take{suffix}", RATE, rescue=tmp_path / "rescue")
    shutil.rmtree(tmp_path / "folder")
    wait_for(lambda: recording.failure)
    recording.close()
    assert check_sentence(recording, f"take{suffix}") == (
        f"take{suffix}: its folder or the file itself has gone, so nothing was recorded; record to another folder"
    )
    assert not (tmp_path / "rescue").exists()


@pytest.mark.skipif(os.name == "nt", reason="Windows keeps the folder of an open file")
def test_what_cannot_be_saved_is_said_to_be_lost(mounted: Callable[..., Path], tmp_path: Path) -> None:
    (tmp_path / "folder").mkdir()
    rescue = mounted("rescue", "size=16k")
    recording = begun(tmp_path / "folder" / "take.wav", RATE, journal=tmp_path / "journal", rescue=rescue)
    recording.write(samples_of_16_bits(0, RATE))
    wait_for(lambda: recording.n_samples)
    shutil.rmtree(tmp_path / "folder")
    wait_for(lambda: recording.failure)
    recording.close()
    sentence = check_sentence(recording, "take.wav")
    assert "saving it elsewhere failed (No space left" in sentence
    assert "which are lost" in sentence
    assert list(rescue.iterdir()) == []
