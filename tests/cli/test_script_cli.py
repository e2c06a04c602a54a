"""`analyse`, `export` and `preview` with what is said: words where they are, and a sentence for what does not fit."""

import json
import shutil
from itertools import pairwise
from pathlib import Path

import pytest

from phonemeanalyser.cli.main import main
from phonemeengine.labels.textgrid import format_tiers
from phonemeengine.labels.timed_words import read_timed_words
from phonemeengine.labels.utterance import Phone, Syllable, Utterance, Word
from phonemeengine.labels.utterance_files import format_utterance, read_utterance
from phonemeengine.phonemes import Phoneme
from tests.conftest import CORPUS
from tests.tables import Capsys, refused, rows_of

SAID = CORPUS / "espeak_de" / "de" / "de_01.flac"
TEXT = "Es regnet, aber der See ist eben und leer."
WORDS = TEXT.replace(",", "").replace(".", "").split()
OTHER = "Der Onkel trinkt Kaffee mit Zucker und singt laut dazu."


def run(*words: object) -> None:
    assert main([str(word) for word in words]) == 0


def test_phones_and_words_stand_in_the_table(capsys: Capsys) -> None:
    run("analyse", SAID, "--text", TEXT, "--language", "de")
    rows = rows_of(capsys.readouterr().out)
    assert list(dict.fromkeys(row["word"] for row in rows if row["word"])) == WORDS
    assert all(one["end_s"] == other["start_s"] for one, other in pairwise(rows))
    assert {row["phone"] for row in rows if row["phoneme"] == "sz"} == {"s", "z"}
    assert all(float(row["score"]) >= 0 for row in rows if row["phone"])


def test_a_textgrid_holds_words_phones_and_phonemes_and_is_read_again(tmp_path: Path) -> None:
    grid = tmp_path / "said.TextGrid"
    run("analyse", SAID, "--text", TEXT, "--language", "de", "-o", grid)
    run("analyse", SAID, "--text", TEXT, "--language", "de", "-o", grid)  # its own file is replaced
    assert [word.text for word in read_timed_words(grid, 3.0)] == WORDS
    again = read_utterance(grid, 3.0)
    assert [word.text for word in again.words] == WORDS
    run("analyse", SAID, "--script", grid, "-o", tmp_path / "again.TextGrid")
    assert (tmp_path / "again.TextGrid").read_text("utf-8") == grid.read_text("utf-8")


def test_words_with_times_from_another_program_keep_them_and_get_phones(tmp_path: Path, capsys: Capsys) -> None:
    run("analyse", SAID, "--text", TEXT, "--language", "de", "--format", "json")
    words = [(word["word"], word["start_s"], word["end_s"]) for word in json.loads(capsys.readouterr().out)["words"]]
    moved = [(word, round(start + 0.01, 3), round(end + 0.01, 3)) for word, start, end in words]
    whisper = tmp_path / "words.json"
    entries = [{"word": f" {word}", "start": start, "end": end, "speaker": "A"} for word, start, end in moved]
    other = {"word": " Nein", "start": 0.0, "end": 0.2, "speaker": "B"}
    whisper.write_text(json.dumps({"segments": [{"words": [other, *entries]}]}), encoding="utf-8")
    grid, out = tmp_path / "words.TextGrid", tmp_path / "out.TextGrid"
    grid.write_text(
        format_tiers({"words": [(start, end, word) for word, start, end in moved]}, 3.0), encoding="utf-8"
    )
    for script in ((whisper, "--speaker", "A"), (grid,)):
        run("export", SAID, "--script", *script, "--language", "de", "--format", "textgrid", "-o", out, "--overwrite")
        said = read_utterance(out, 3.0)
        assert [word.text for word in said.words] == WORDS
        times = [time for word in said.words for time in (word.start, word.end)]
        assert times == pytest.approx([time for _, start, end in moved for time in (start, end)], abs=1e-6)
        assert [phone.ipa for phone in said.words[0].phones] == ["ɛ", "s"]


def test_what_words_with_times_lack_is_said(tmp_path: Path, capsys: Capsys) -> None:
    words = [
        {"word": "Es", "start": 0.1, "end": 0.4, "speaker": "A"},
        {"word": "so", "start": 1, "end": 2, "speaker": "B"},
    ]
    (tmp_path / "w.json").write_text(json.dumps({"words": words}), encoding="utf-8")
    assert main(["analyse", str(SAID), "--script", str(tmp_path / "w.json"), "--language", "de"]) == 1
    assert "w.json: it tells 2 speakers apart, 'A', 'B'; choose one as the speaker" in capsys.readouterr().err
    assert main(["analyse", str(SAID), "--script", str(tmp_path / "w.json"), "--speaker", "A"]) == 1
    assert "w.json: it has words without phones; name their language" in capsys.readouterr().err


def test_a_word_that_nobody_says_is_named(capsys: Capsys) -> None:
    run("analyse", SAID, "--text", TEXT.replace("See", "kleine See"), "--language", "de", "--format", "json")
    said = capsys.readouterr()
    assert said.err == "phonemeanalyser: de_01.flac: note: these words are not spoken: kleine\n"
    found = json.loads(said.out)
    assert found["skipped"] == ["kleine"]
    assert [word["word"] for word in found["words"]] == WORDS


def test_another_text_is_said_to_be_one_and_the_sound_is_recognised_without_it(capsys: Capsys) -> None:
    run("analyse", SAID)
    without = rows_of(capsys.readouterr().out)
    run("analyse", SAID, "--text", OTHER, "--language", "de")
    said = capsys.readouterr()
    assert "another text seems to be said in it, so it is recognised without the text; check the text" in said.err
    assert [(r["start_s"], r["phoneme"]) for r in rows_of(said.out)] == [
        (r["start_s"], r["phoneme"]) for r in without
    ]


def test_a_text_that_somebody_knows_to_be_right_is_aligned_anyway(capsys: Capsys) -> None:
    run("analyse", SAID, "--text", OTHER, "--language", "de", "--accept-text", "--format", "json")
    said = capsys.readouterr()
    assert "another text" not in said.err
    words = [word["word"] for word in json.loads(said.out)["words"]]
    assert len(words) >= len(OTHER.split()) - 2
    assert set(words) & set(OTHER.replace(".", "").split())


def test_the_notation_of_a_script_is_not_looked_for_unless_it_is_literal(capsys: Capsys) -> None:
    script = "Anna: [lacht] " + TEXT.replace("See", "*See* &nbsp; <i></i>")
    run("analyse", SAID, "--text", script, "--language", "de")
    told = capsys.readouterr().err
    assert "names and directions of the script are not spoken: Anna, [lacht]" in told
    assert "these words" not in told
    run("analyse", SAID, "--text", script, "--language", "de", "--literal")
    told = capsys.readouterr().err
    assert "names and directions" not in told
    assert "these words are not spoken: Anna" in told


def test_the_text_beside_a_sound_is_found(tmp_path: Path, capsys: Capsys) -> None:
    for name in ("a.flac", "b.flac"):
        shutil.copy(SAID, tmp_path / name)
    (tmp_path / "a.txt").write_text(TEXT, encoding="utf-8")
    run("analyse", tmp_path, "--script", "auto", "--language", "de", "-o", tmp_path / "out")
    assert (
        "b.flac: note: there is no b.TextGrid with words or b.txt beside it, so it is recognised without text"
        in capsys.readouterr().err
    )
    heads = [(tmp_path / "out" / f"{name}.csv").read_text("utf-8").splitlines()[0] for name in "ab"]
    assert heads == [
        "start_s,end_s,phoneme,intensity,confidence,phone,word,score",
        "start_s,end_s,phoneme,intensity,confidence",
    ]


def test_the_words_that_the_window_saved_beside_a_sound_go_before_a_text(tmp_path: Path) -> None:
    shutil.copy(SAID, tmp_path / "a.flac")
    (tmp_path / "a.txt").write_text("Ganz etwas anderes.", encoding="utf-8")
    words = (Word("Es", (Syllable((Phone(0.5, 0.75, "ɛ", Phoneme.E), Phone(0.75, 1.0, "s", Phoneme.SZ)), 0),)),)
    (tmp_path / "a.TextGrid").write_text(format_utterance(Utterance(words, 2.0, "de")), encoding="utf-8")
    run("analyse", tmp_path / "a.flac", "--script", "auto", "-o", tmp_path / "auto.csv")
    run("analyse", tmp_path / "a.flac", "--script", tmp_path / "a.TextGrid", "-o", tmp_path / "named.csv")
    found = (tmp_path / "auto.csv").read_text("utf-8")
    assert "\n0.5,0.75,e," in found
    assert found == (tmp_path / "named.csv").read_text("utf-8")


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (["--text", TEXT], "the language of a text is not guessed; name it with --language"),
        (["--text", TEXT, "--language", "klingon"], "no voice speaks the language 'klingon'"),
        (["--text", "", "--language", "de"], "there is no word to speak in an empty text"),
        (["--script", "nowhere.txt", "--language", "de"], "nowhere.txt: there is no such file; check its name"),
    ],
)
def test_what_cannot_be_said_is_refused_in_a_sentence(words: list[str], sentence: str, capsys: Capsys) -> None:
    assert sentence in refused(capsys, "analyse", SAID, *words)


def test_a_language_alone_is_no_text(capsys: Capsys) -> None:
    with pytest.raises(SystemExit, match="2"):
        main(["analyse", str(SAID), "--language", "de"])
    assert "goes with --text or --script" in capsys.readouterr().err
