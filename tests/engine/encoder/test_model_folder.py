"""Where the speech encoder's model comes from: a folder, two packages, the network."""

import os
import shutil
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

from phonemeengine.encoder.model_folder import (
    FOLDER_VARIABLE,
    PACKAGES,
    REPOSITORY,
    choose_whisper,
    fetch_whisper,
    find_whisper,
    has_whisper,
    open_whisper,
)
from phonemeengine.errors import ModelError
from phonemeengine.storage.paths import data_folder


@pytest.fixture(autouse=True)
def data(home: Path) -> Path:
    """The folder in which the program keeps what is the user's."""
    return data_folder()


@pytest.fixture
def packages(tmp_path: Path, whisper_folder: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The two packages with the halves of a model, and where they are."""
    content = (whisper_folder / "model.bin").read_bytes()
    site = tmp_path / "site"
    for k, (name, part) in enumerate(zip(PACKAGES, (content[:5_000_000], content[5_000_000:]), strict=True), 1):
        (site / name / "data").mkdir(parents=True)
        (site / name / "__init__.py").touch()
        (site / name / "data" / f"model.bin.part{k}").write_bytes(part)
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.syspath_prepend(site)
    return site


def hub(monkeypatch: pytest.MonkeyPatch, fetch: object) -> None:
    monkeypatch.setitem(sys.modules, "huggingface_hub", SimpleNamespace(snapshot_download=fetch))


def no_network(*_: object, **__: object) -> None:
    raise OSError("no route to host\nand more")


def test_without_a_model_one_sentence_says_how_to_get_one():
    assert not has_whisper()
    with pytest.raises(ModelError, match=r"there is no Whisper model; phonemeanalyser whisper --fetch gets it"):
        find_whisper()


def test_the_variable_goes_first_then_what_was_chosen(whisper_folder, tmp_path, monkeypatch):
    choose_whisper(whisper_folder)
    assert (find_whisper().path, find_whisper().origin) == (whisper_folder, "chosen")
    monkeypatch.setenv(FOLDER_VARIABLE, str(tmp_path / "other"))
    assert find_whisper().path == tmp_path / "other"
    monkeypatch.delenv(FOLDER_VARIABLE)
    assert has_whisper()
    choose_whisper(None)
    assert not has_whisper()


def test_a_folder_without_a_model_is_not_chosen(tmp_path):
    with pytest.raises(ModelError, match=r"there is no Whisper model, model\.bin is missing; choose its folder"):
        choose_whisper(tmp_path)
    assert not has_whisper()


def test_the_halves_of_two_packages_are_one_model_and_copied_nowhere(packages, whisper_folder, data):
    assert has_whisper()
    found = find_whisper()
    assert found.origin == "from two packages"
    assert b"".join(path.read_bytes() for path in found.files) == (whisper_folder / "model.bin").read_bytes()
    open_whisper()
    assert [path.name for path in data.iterdir()] == ["whisper-base-layer-4.onnx"]


@pytest.mark.usefixtures("packages")
def test_what_was_fetched_or_left_by_an_earlier_version_goes_before_packages(whisper_folder, data):
    left = data / "whisper-base"
    left.mkdir(parents=True)
    shutil.copy(whisper_folder / "model.bin", left)
    assert (find_whisper().path, find_whisper().origin) == (left, "in the data of the program")
    open_whisper()


def test_programs_that_cut_it_at_once_all_have_it(packages, data):
    program = "from phonemeengine import find_whisper; from phonemeengine.encoder.model_folder import open_whisper; "
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join([str(packages), *sys.path])}
    words = [sys.executable, "-c", program + "open_whisper(); print(find_whisper().path)"]
    started = [subprocess.Popen(words, env=environment, stdout=subprocess.PIPE, text=True) for _ in range(2)]
    found = [program.communicate()[0].strip() for program in started]
    assert found == [str(packages / PACKAGES[0] / "data")] * 2
    assert [path.name for path in data.iterdir()] == ["whisper-base-layer-4.onnx"]


def test_turned_off_there_is_none_whatever_lies_there(whisper_folder, monkeypatch):
    choose_whisper(whisper_folder)
    monkeypatch.setenv(FOLDER_VARIABLE, "off")
    assert not has_whisper()
    with pytest.raises(ModelError, match="PHONEMEANALYSER_WHISPER is 'off', so files are recognised without Whisper"):
        find_whisper()


def test_it_is_fetched_by_its_usual_name(whisper_folder, data, monkeypatch):
    def fetch(name: str, local_dir: Path, allow_patterns: list[str]) -> None:
        assert name == REPOSITORY
        local_dir.mkdir(parents=True)
        for wanted in allow_patterns:
            shutil.copy(whisper_folder / wanted, local_dir)

    hub(monkeypatch, fetch)
    assert fetch_whisper() == data / "whisper-base"
    assert find_whisper().path == data / "whisper-base"


@pytest.mark.parametrize(
    ("fetch", "words"),
    [
        (no_network, r"\(no route to host\); see to the network"),
        (lambda *_, **__: None, "what was fetched is no Whisper model"),
    ],
)
def test_what_cannot_be_fetched_is_said_in_one_sentence(monkeypatch, fetch, words):
    hub(monkeypatch, fetch)
    with pytest.raises(ModelError, match=words):
        fetch_whisper()


def test_without_the_library_that_fetches_that_is_said(monkeypatch):
    monkeypatch.setitem(sys.modules, "huggingface_hub", None)
    with pytest.raises(ModelError, match="fetching needs the package huggingface_hub"):
        fetch_whisper()
