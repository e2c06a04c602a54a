"""A file that was cut off is read as far as it goes, and whoever opens it is told: by commands and by the window."""

from pathlib import Path

import pytest
import soundfile

from phonemeanalyser.cli.main import main
from phonemeengine.labels.files import write_labels
from phonemeengine.labels.utterance import Label
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import SAMPLE_RATE
from tests.bad_files import CUT_OFF
from tests.desktop.hands import shown
from tests.tables import gapless, rows_of

SENTENCE = "the file is truncated; its header announces 3.000 s, but it contains 1.800 s"


N_SAMPLES = 79_371
"""Whole ones in 60 % of three seconds and a header."""


@pytest.fixture
def cut(tmp_path: Path) -> Path:
    (tmp_path / "cut").mkdir()
    return CUT_OFF["truncated_wav"](tmp_path / "cut")


def test_what_is_there_is_analysed_with_a_note(cut: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["analyse", str(cut)]) == 0
    said = capsys.readouterr()
    assert said.err == f"phonemeanalyser: truncated.wav: note: {SENTENCE}\n"
    gapless(rows_of(said.out), N_SAMPLES / SAMPLE_RATE)


def test_what_is_there_is_exported_with_a_note(cut: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["export", str(cut), "--format", "rhubarb-tsv"]) == 0
    said = capsys.readouterr()
    assert SENTENCE in said.err
    assert said.out.splitlines()[-1] == "1.80\tX"


@pytest.mark.parametrize("words", [["score"], ["adapt", "-o", "out.toml"]])
def test_labelled_recordings_that_are_cut_off_are_said(
    words: list[str], cut: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    write_labels((Label(0.0, 1.0, "s", Phoneme.SZ), Label(1.0, 1.8, "sil", Phoneme.SILENCE)), cut.with_suffix(".csv"))
    monkeypatch.chdir(cut.parent)
    main([words[0], str(cut.parent), *words[1:]])
    assert f"phonemeanalyser: truncated.wav: note: {SENTENCE}" in capsys.readouterr().err.splitlines()


def test_the_window_says_it_and_plays_what_is_there(desktop, qtbot, cut, sound):
    window = shown(desktop, qtbot, sound)
    window.dialogs.open_any(cut)
    assert window.banner.label.text() == f"truncated.wav: {SENTENCE}"
    assert window.banner.isVisible()
    assert desktop.session.source.duration == pytest.approx(1.8, abs=0.001)
    desktop.session.analyse_until(1.8)
    assert desktop.session.history.n == 180
    window.dialogs.open_any(sound)
    assert not window.banner.isVisible()
    assert desktop.session.source.duration == pytest.approx(soundfile.info(sound).duration)
