"""``phonemeanalyser whisper`` chooses a model of the speech encoder, and says which one is used."""

import sys
from types import SimpleNamespace

import pytest

from phonemeanalyser.cli.main import main
from phonemeengine import find_whisper

pytestmark = pytest.mark.usefixtures("home")


def test_a_chosen_folder_is_used_until_it_is_not(whisper_folder, capsys):
    for words in (["--folder", str(whisper_folder)], []):
        assert main(["whisper", *words]) == 0
        said = capsys.readouterr().out
        assert said == f"Whisper base, multilingual, by OpenAI, MIT licence; chosen: {whisper_folder}\n"
    assert find_whisper().path == whisper_folder
    assert main(["whisper", "--no-folder"]) == 0
    assert capsys.readouterr().out == "The chosen folder is used no longer.\n"
    assert main(["whisper"]) == 1
    assert capsys.readouterr().err.startswith("phonemeanalyser: there is no Whisper model; ")


def test_what_is_no_model_is_refused(tmp_path, capsys):
    (tmp_path / "model.bin").write_bytes(b"nonsense")
    assert main(["whisper", "--folder", str(tmp_path)]) == 1
    said = capsys.readouterr().err
    assert said == (
        f"phonemeanalyser: {tmp_path}: the Whisper model cannot be opened (it ends too early); get it anew, or "
        "choose another folder\n"
    )


def test_fetching_is_asked_for_and_its_failure_is_said(monkeypatch, capsys):
    def refuse(*_arguments, **_options):
        raise OSError("no network")

    monkeypatch.setitem(sys.modules, "huggingface_hub", SimpleNamespace(snapshot_download=refuse))
    assert main(["whisper", "--fetch"]) == 1
    assert "cannot be fetched (no network)" in capsys.readouterr().err
