from pathlib import Path

import pytest

from phonemeengine import TextError
from phonemeengine.text.script import Script, load_script, script_beside


def _written(folder: Path, text: str, name: str = "s.txt") -> Path:
    path = folder / name
    path.write_text(text, encoding="utf-8")
    return path


def test_a_text_file_holds_the_words_of_one_sound(tmp_path: Path) -> None:
    script = load_script(_written(tmp_path, "Good morning,\nall.\n"))
    assert script.texts_of([Path("a.wav")]) == ({Path("a.wav"): "Good morning,\nall.\n"}, ())


def test_the_words_of_one_sound_are_not_those_of_several() -> None:
    with pytest.raises(TextError, match=r"there are 2; write a table"):
        Script("s.txt", "Hello").texts_of([Path("a.wav"), Path("b.wav")])


def test_a_table_finds_sounds_by_path_name_or_stem(tmp_path: Path) -> None:
    script = load_script(_written(tmp_path, "one/a.wav\tfirst\none\\b\tsecond\n\nc.wav\tthird\nd\tfourth\n"))
    sounds = [Path("takes/one/a.wav"), Path("takes/one/b.wav"), Path("takes/c.wav"), Path("d.flac")]
    assert script.texts_of(sounds) == (dict(zip(sounds, ["first", "second", "third", "fourth"], strict=True)), ())


@pytest.mark.parametrize("name", ["./a.wav", ".\\a", "one/../a.wav", "takes/./a.wav", '"a.wav"', "../takes/a.wav"])
def test_a_table_may_lead_to_a_sound_by_any_way(tmp_path: Path, name: str) -> None:
    script = load_script(_written(tmp_path, f"{name}\tfirst\n"))
    sound = Path("../takes/a.wav")
    assert script.texts_of([sound]) == ({sound: "first"}, ())


def test_lines_of_the_same_sound_follow_each_other_in_it(tmp_path: Path) -> None:
    script = load_script(_written(tmp_path, "a\tOne.\na\tTwo.\n"))
    assert script.texts == {"a": "One.\nTwo."}


def test_sounds_without_text_and_texts_without_sound_are_named() -> None:
    script = Script("s.txt", "", {"a": "one", "c": "three"})
    texts, notes = script.texts_of([Path("a.wav"), Path("b.wav")])
    assert texts == {Path("a.wav"): "one"}
    assert [("b.wav" in note, note.split()[:4]) for note in notes] == [
        (True, ["there", "is", "no", "text"]),
        (False, ["there", "is", "no", "sound"]),
    ]


def test_a_table_without_any_of_the_sounds_is_refused() -> None:
    with pytest.raises(TextError, match=r"no text in it for b\.wav"):
        Script("s.txt", "", {"a": "one"}).texts_of([Path("b.wav")])


@pytest.mark.parametrize(
    ("text", "words"), [("", "no word in it"), (" \n\n", "no word in it"), ("a\tone\ntwo\n", "line 2: a table has")]
)
def test_a_script_that_says_nothing_or_half_a_table_is_refused(tmp_path: Path, text: str, words: str) -> None:
    with pytest.raises(TextError, match=words):
        load_script(_written(tmp_path, text))


def test_a_script_beside_a_sound_bears_its_name(tmp_path: Path) -> None:
    _written(tmp_path, "Hello.", "take.txt")
    script = script_beside(tmp_path / "take.wav")
    assert script is not None
    assert script.text == "Hello."
    assert script_beside(tmp_path / "other.wav") is None


def test_labels_of_audacity_beside_a_sound_are_no_script(tmp_path: Path) -> None:
    _written(tmp_path, "0.000000\t0.500000\ta\n", "take.txt")
    assert script_beside(tmp_path / "take.wav") is None
