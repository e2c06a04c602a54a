"""A recording that its process did not survive is found again; takes have names and folders."""

import json
import threading
from datetime import datetime
from pathlib import Path

import numpy as np
import pytest
import soundfile

from phonemeengine.audio.journal import RecordingMarker, interrupted_recordings
from phonemeengine.errors import RecordingError
from phonemeengine.settings import SAMPLE_RATE
from phonemeengine.storage.paths import journal_folder, new_recording_path, recordings_folder
from tests.fakes.recorders import begun, samples_of_16_bits


def test_a_running_recording_is_noted_but_not_offered(tmp_path: Path) -> None:
    recording = begun(tmp_path / "take.wav")
    recording.write(samples_of_16_bits(0, SAMPLE_RATE))
    (note,) = (tmp_path / "journal").glob("*.json")
    assert json.loads(note.read_text())["path"] == str(tmp_path / "take.wav")
    for _ in range(3):
        assert interrupted_recordings(tmp_path / "journal") == []
    assert note.exists()
    recording.close()
    assert list((tmp_path / "journal").iterdir()) == []
    assert interrupted_recordings(tmp_path / "journal") == []


def left_behind(folder: Path, path: Path, begun_at: str = "2026-11-21T10:31:05+01:00") -> Path:
    """A note as a dead process leaves it."""
    folder.mkdir(exist_ok=True)
    note = folder / f"{path.stem}.json"
    note.write_text(json.dumps({"path": str(path), "begun": begun_at}))
    note.with_suffix(".lock").touch()
    return note


def test_what_a_dead_process_left_is_offered_until_it_is_forgotten(tmp_path: Path) -> None:
    journal = tmp_path / "journal"
    for name, begun_at in (("new", "2026-11-21T10:31:05+01:00"), ("old", "2026-11-20T10:31:05+01:00")):
        soundfile.write(tmp_path / f"{name}.wav", np.zeros(16_000), 16_000)
        left_behind(journal, tmp_path / f"{name}.wav", begun_at)
    old, new = interrupted_recordings(journal)
    assert interrupted_recordings(journal) == [old, new]
    assert (old.path, old.seconds) == (tmp_path / "old.wav", 1.0)
    assert new.begun == datetime.fromisoformat("2026-11-21T09:31:05+00:00")
    old.forget()
    old.forget()
    assert interrupted_recordings(journal) == [new]
    new.forget()
    assert (tmp_path / "new.wav").exists()
    assert list(journal.iterdir()) == []


def test_a_recording_that_begins_or_ends_right_now_does_not_look_dead(tmp_path: Path) -> None:
    soundfile.write(tmp_path / "take.wav", np.zeros(16_000), 16_000)

    def begin_and_end() -> None:
        for _ in range(300):
            RecordingMarker(tmp_path / "journal", tmp_path / "take.wav").remove()

    others = [threading.Thread(target=begin_and_end) for _ in range(2)]
    for other in others:
        other.start()
    n_looks = 0
    while any(other.is_alive() for other in others):
        assert interrupted_recordings(tmp_path / "journal") == []
        n_looks += 1
    assert n_looks > 3
    assert list((tmp_path / "journal").iterdir()) == []


def test_what_has_gone_or_is_empty_is_forgotten_in_silence(tmp_path: Path) -> None:
    journal = tmp_path / "journal"
    left_behind(journal, tmp_path / "gone.wav")
    (tmp_path / "empty.wav").touch()
    left_behind(journal, tmp_path / "empty.wav")
    left_behind(journal, tmp_path / "torn.wav").write_text('{"path": "/x')
    left_behind(journal, tmp_path / "other.wav").write_text("[1]")
    assert interrupted_recordings(journal) == []
    assert list(journal.iterdir()) == []
    assert interrupted_recordings(tmp_path / "nowhere") == []


def test_a_recording_that_cannot_be_noted_is_made_all_the_same(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    recording = begun(tmp_path / "take.wav", journal=tmp_path / "file" / "journal")
    recording.write(samples_of_16_bits(0, 1000))
    recording.close()
    assert recording.n_samples == 1000
    (note,) = recording.notes
    assert note.startswith("take.wav: if the program ends in mid-recording, this file will not be offered")


def test_a_take_is_named_after_its_time_and_never_like_another(tmp_path: Path) -> None:
    first = new_recording_path(tmp_path / "new" / "folder", ".wav")
    assert datetime.strptime(first.stem, "%Y-%m-%d %H-%M-%S").astimezone() <= datetime.now().astimezone()
    names = set()
    for _ in range(5):
        path = new_recording_path(tmp_path, ".flac")
        path.touch()
        names.add(path.name)
    assert len(names) == 5
    assert all(name.endswith(".flac") for name in names)


def test_a_folder_that_cannot_be_made_is_refused(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    with pytest.raises(RecordingError, match=r"^takes: this folder for recordings cannot be made \(.+\); choose"):
        new_recording_path(tmp_path / "file" / "takes", ".wav")


def test_recordings_and_their_journal_have_folders_of_the_user() -> None:
    assert recordings_folder().is_absolute()
    assert recordings_folder().name == "PhonemeAnalyser"
    assert journal_folder().parts[-2:] == ("PhonemeAnalyser", "unfinished")
