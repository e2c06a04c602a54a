"""``phonemeanalyser performance``, as a person types it."""

from pathlib import Path

import av
import numpy as np
import pytest
from PIL import Image

from phonemeanalyser.cli.main import main
from phonemeengine.arrays import UInt8Array
from phonemeengine.performance.corpus import build_table
from phonemeengine.settings import SAMPLE_RATE
from tests.engine.performance.corpora import write_recording
from tests.graphics import context_or_skip
from tests.tables import Capsys, refused


@pytest.fixture
def recorded(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with the recording "mami", and a table of it."""
    monkeypatch.chdir(tmp_path)
    write_recording(tmp_path)
    build_table(tmp_path, tmp_path / "ann.sqlite", name="Ann")
    return tmp_path


def test_a_table_of_a_synthetic_performer_says_so(tmp_path: Path, capsys: Capsys) -> None:
    folder, table = tmp_path / "corpus", tmp_path / "ann.sqlite"
    text = tmp_path / "sentences.txt"
    text.write_text("Good evening, all of you.\n\nThe baker moved the piano.\n", encoding="utf-8")
    assert main(["performance", "make", str(folder), "--minutes", "0.5", "--sentences", str(text)]) == 0
    assert "2 synthetic recordings, 0.1 minutes" in capsys.readouterr().out
    assert main(["performance", "build", str(folder), "-o", str(table), "--name", "Ann"]) == 0
    assert "ann.sqlite: 'Ann', synthetic, 2 recordings, 0.1 minutes" in capsys.readouterr().out
    assert main(["performance", "info", str(table)]) == 0
    said = capsys.readouterr().out.splitlines()
    assert said[1:3] == ["en-us", "61 channels at 60 frames a second"]
    assert [line.split()[0] for line in said[3:5]] == ["word", "syllable"]


def test_what_is_left_out_is_said_and_the_table_is_built(tmp_path: Path, capsys: Capsys) -> None:
    for name in ("good", "bad"):
        write_recording(tmp_path, name)
    (tmp_path / "bad.csv").write_text("nothing", encoding="utf-8")
    assert main(["performance", "build", str(tmp_path), "-o", str(tmp_path / "t.sqlite")]) == 0
    out, err = capsys.readouterr()
    assert "1 recordings" in out
    assert "a recording is left out: bad.csv: this is no recording of Live Link Face" in err


def test_a_table_takes_the_place_of_another_file_only_where_that_is_wanted(tmp_path: Path, capsys: Capsys) -> None:
    write_recording(tmp_path)
    table = tmp_path / "t.sqlite"
    build = ["performance", "build", str(tmp_path), "-o", str(table)]
    table.write_text("my notes", encoding="utf-8")
    assert main(build) == 1
    assert "is left alone" in capsys.readouterr().err
    assert table.read_text(encoding="utf-8") == "my notes"
    assert main([*build, "--overwrite"]) == 0
    built = table.read_bytes()
    assert main(build) == 1
    assert table.read_bytes() == built


def shown(table: Path, out: Path, *words: str) -> UInt8Array:
    show = ["performance", "show", str(table), "mami", "-o", str(out), "--size", "96x96", "--fps", "5", *words]
    assert main(show) == 0
    if out.suffix:
        with av.open(out) as film:
            return np.concatenate([frame.to_ndarray()[0] for frame in film.decode(audio=0)])
    return np.stack([np.asarray(Image.open(path)) for path in sorted(out.iterdir())])


def test_a_recording_is_shown_as_it_was_tracked_and_a_part_of_it_is_that_part(recorded: Path) -> None:
    context_or_skip().release()
    whole = shown(recorded / "ann.sqlite", recorded / "whole")
    assert whole.shape == (6, 96, 96, 3)
    moving = np.abs(np.diff(whole[:, :88].astype(int), axis=0)).max(axis=(1, 2, 3))
    assert moving.min() > 20, "the jaw opens and the head turns from frame to frame"
    assert (whole[:, 88:] == whole[0, 88:]).all()
    assert whole[0, 88:].min() < 128, "a caption stands below"
    part = shown(recorded / "ann.sqlite", recorded / "part", "--from", "0.4", "--to", "0.8")
    assert np.array_equal(part, whole[2:5])


def test_a_film_of_a_recording_has_its_sound_where_that_is_found(recorded: Path, capsys: Capsys) -> None:
    context_or_skip().release()
    table = recorded / "ann.sqlite"
    heard = shown(table, recorded / "tone.mp4", "--from", "0.3", "--to", "0.5")
    assert len(heard) == pytest.approx(0.2 * SAMPLE_RATE, abs=2048)
    assert np.square(heard).mean() == pytest.approx(0.5**2 / 2, rel=0.1)
    assert np.abs(shown(table, recorded / "silence.mp4", "--from", "0.6")).max() < 0.01
    assert capsys.readouterr().err == ""
    (recorded / "mami.wav").unlink()
    still = ["performance", "show", str(table), "mami", "-o", str(recorded / "still.mp4"), "--size", "96x96"]
    assert main([*still, "--fps", "2"]) == 0
    assert "Ann: note: the sound of mami is not where it was" in capsys.readouterr().err
    with av.open(recorded / "still.mp4") as film:
        assert [stream.type for stream in film.streams] == ["video"]


SHOW = ["performance", "show", "ann.sqlite", "mami", "-o", "out"]


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (["performance", "show", "ann.sqlite", "momi", "-o", "out"], "Ann: there is no recording 'momi' in this"),
        (["performance", "show", "mami.wav", "mami", "-o", "out"], "mami.wav: this is no table of performances"),
        ([*SHOW, "--from", "0.5", "--to", "0.4"], "mami: --from and --to must lie in 0..1.000 s, the second behind"),
        ([*SHOW, "--to", "1.1"], "mami: --from and --to must lie in 0..1.000 s"),
        ([*SHOW, "--fps", "500"], "the frame rate must lie in 1..240 frames per second, got 500; choose another"),
        ([*SHOW[:-1], "out.avi"], "out.avi: a preview is an .mp4, a .gif or a folder"),
    ],
)
def test_a_recording_that_cannot_be_shown_is_refused_in_a_sentence(
    recorded: Path, words: list[str], sentence: str, capsys: Capsys
) -> None:
    assert refused(capsys, *words).startswith(sentence)
    assert not [path for path in recorded.iterdir() if path.name.startswith("out")]


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (["info", "none.sqlite"], "none.sqlite: it cannot be read"),
        (["build", "none", "-o", "t.sqlite"], "none: this folder cannot be read"),
        (["make", ".", "--minutes", "1"], "there are files in this folder already"),
        (["make", "new", "--language", "xx"], "xx"),
    ],
)
def test_what_cannot_be_done_is_said_in_a_sentence(
    words: list[str], sentence: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Capsys
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "file").touch()
    assert main(["performance", *words]) == 1
    err = capsys.readouterr().err
    assert sentence in err
    assert err.count("\n") == 1
