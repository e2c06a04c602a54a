"""A recording that cannot begin is refused at once, with one sentence that says what to do."""

import errno
import os
from pathlib import Path

import pytest

from phonemeengine.audio.recording import describe_os_error
from phonemeengine.errors import AudioError, RecordingError
from tests.fakes.recorders import begun


def refusal_of(path: Path, rate: int = 44_100, n_channels: int = 1) -> str:
    with pytest.raises(RecordingError) as refusal:
        begun(path, rate, n_channels)
    message = str(refusal.value)
    assert isinstance(refusal.value, AudioError)
    assert message.startswith(f"{path.name}: ".replace("\0", "?"))
    assert message.isprintable()
    assert ". " not in message
    assert not message.endswith(".")
    return message


def test_a_recording_never_overwrites(tmp_path: Path) -> None:
    (tmp_path / "take.wav").write_text("precious")
    assert "does not overwrite" in refusal_of(tmp_path / "take.wav")
    assert (tmp_path / "take.wav").read_text() == "precious"
    (tmp_path / "link.wav").symlink_to(tmp_path / "nowhere.wav")
    assert "does not overwrite" in refusal_of(tmp_path / "link.wav")


def test_a_recording_needs_a_folder_and_a_name_of_a_known_kind(tmp_path: Path) -> None:
    (tmp_path / "folder.wav").mkdir()
    (tmp_path / "file").touch()
    assert "this is a folder" in refusal_of(tmp_path / "folder.wav")
    assert "there is no folder" in refusal_of(tmp_path / "missing" / "take.wav")
    assert "there is no folder" in refusal_of(tmp_path / "file" / "take.wav")
    for name in ("take.mp3", "take", "take.wav.txt"):
        assert "a .wav or a .flac file" in refusal_of(tmp_path / name)
    refusal_of(tmp_path / ("x" * 300 + ".wav"))
    refusal_of(tmp_path / "nul\0l.wav")


@pytest.mark.parametrize(("rate", "n_channels"), [(44_100, 9), (2000, 1), (768_000, 1)])
def test_what_flac_cannot_hold_is_refused_with_its_limits(rate: int, n_channels: int, tmp_path: Path) -> None:
    assert refusal_of(tmp_path / "take.flac", rate, n_channels) == (
        f"take.flac: FLAC takes 4000..655350 Hz and at most 8 channels, got {rate} Hz and {n_channels}; "
        "record to a .wav file"
    )
    assert list(tmp_path.iterdir()) == []


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="root may write everywhere")
def test_a_read_only_folder_is_refused(tmp_path: Path) -> None:
    tmp_path.chmod(0o500)
    with pytest.raises(RecordingError, match=r"^take\.wav: writing to .* is not permitted; change its permissions"):
        begun(tmp_path / "take.wav")


@pytest.mark.skipif(not Path("/sys/kernel").is_dir(), reason="only Linux has a folder that refuses even root")
def test_a_folder_that_refuses_everybody_is_refused() -> None:
    with pytest.raises(RecordingError, match=r"^take\.wav: .*; .*choose another"):
        begun(Path("/sys/kernel/take.wav"))


def test_every_refusal_of_a_disk_has_words_and_advice() -> None:
    told = {name: describe_os_error(OSError(code, os.strerror(code))) for code, name in errno.errorcode.items()}
    assert {name: what for name, (what, _) in told.items() if not what.isprintable() or len(what) <= 10} == {}
    assert {name: todo for name, (_, todo) in told.items() if "record" not in todo and "go on" not in todo} == {}
