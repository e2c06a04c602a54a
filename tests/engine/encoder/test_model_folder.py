"""Where the speech encoder's model comes from: a folder, two packages, the network."""

import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

from phonemeengine.encoder import model_folder
from phonemeengine.encoder.model_folder import choose_whisper, fetch_whisper, find_whisper, has_whisper
from phonemeengine.errors import ModelError


@pytest.fixture(autouse=True)
def data(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The folder in which the program keeps what is the user's."""
    monkeypatch.setattr(model_folder, "data_folder", lambda: tmp_path / "data")
    return tmp_path / "data"


@pytest.fixture
def packages(tmp_path: Path, whisper_folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Two packages with the halves of a model."""
    content = (whisper_folder / "model.bin").read_bytes()
    names = ("half_of_it_1", "half_of_it_2")
    for k, (name, part) in enumerate(zip(names, (content[:5_000_000], content[5_000_000:]), strict=True), 1):
        (tmp_path / "site" / name / "data").mkdir(parents=True)
        (tmp_path / "site" / name / "__init__.py").touch()
        (tmp_path / "site" / name / "data" / f"model.bin.part{k}").write_bytes(part)
    config = tmp_path / "site" / names[0] / "data" / "config.json"
    config.write_bytes((whisper_folder / "config.json").read_bytes())
    monkeypatch.syspath_prepend(tmp_path / "site")
    monkeypatch.setattr(model_folder, "PACKAGES", names)


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
    monkeypatch.setenv(model_folder.FOLDER_VARIABLE, str(tmp_path / "other"))
    assert find_whisper().path == tmp_path / "other"
    monkeypatch.delenv(model_folder.FOLDER_VARIABLE)
    assert has_whisper()
    choose_whisper(None)
    assert not has_whisper()


def test_a_folder_without_a_model_is_not_chosen(tmp_path):
    with pytest.raises(ModelError, match=r"there is no Whisper model, config\.json is missing; choose its folder"):
        choose_whisper(tmp_path)
    assert not has_whisper()


@pytest.mark.usefixtures("packages")
def test_the_halves_of_two_packages_are_put_together_once(whisper_folder, data, monkeypatch):
    assert has_whisper()
    found = find_whisper()
    assert found.path == data / "whisper-base"
    assert (found.path / "model.bin").read_bytes() == (whisper_folder / "model.bin").read_bytes()
    monkeypatch.setattr(model_folder, "PACKAGES", ("gone_1", "gone_2"))
    assert find_whisper().path == found.path


@pytest.mark.usefixtures("packages")
def test_where_the_halves_cannot_be_put_together_that_is_said(data):
    data.write_text("a file, where a folder should be")
    with pytest.raises(ModelError, match="Whisper's model cannot be put together here"):
        find_whisper()


def test_it_is_fetched_by_its_usual_name(whisper_folder, data, monkeypatch):
    def fetch(name: str, local_dir: Path, allow_patterns: list[str]) -> None:
        assert name == model_folder.REPOSITORY
        local_dir.mkdir(parents=True)
        for wanted in allow_patterns:
            (local_dir / wanted).write_bytes((whisper_folder / wanted).read_bytes())

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
    with pytest.raises(ModelError, match="fetching needs huggingface_hub"):
        fetch_whisper()
