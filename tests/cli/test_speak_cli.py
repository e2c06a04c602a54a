import json
import re
import shlex
import sys
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

from phonemeanalyser.cli.main import main
from phonemeanalyser.cli.speak import play_aloud
from phonemeengine import DeviceError, Phoneme, SoundReader, Word
from phonemeengine.labels.textgrid import tiers_of
from phonemeengine.labels.utterance import Phone, Syllable
from phonemeengine.labels.utterance_files import read_utterance
from phonemeengine.speech.voice import SpokenSentence
from tests.conftest import CORPUS
from tests.fakes.outputs import Cards, SelfMovingOutput
from tests.tables import Capsys

SAID = CORPUS / "espeak_de" / "de" / "de_01.flac"
TEXT = "Es regnet, aber der See ist eben und leer."

HELLO = ["speak", "Hello there. How are you?", "--language", "en-us"]


def test_a_text_becomes_a_sound_labels_and_a_mouth(tmp_path: Path) -> None:
    sound, labels, mouth = (tmp_path / name for name in ("h.wav", "h.TextGrid", "h.json"))
    assert (
        main([*HELLO, "-o", str(sound), "--labels", str(labels), "--export", str(mouth), "--format", "rhubarb-json"])
        == 0
    )
    with SoundReader(sound) as reader:
        assert reader.file_rate == 44100
        duration = reader.duration
    tiers = {tier.name: tier.raw_labels for tier in tiers_of(labels.read_text("utf-8"), "h")}
    assert list(tiers) == ["words", "syllables", "phones", "phonemes"]
    assert [raw.name for raw in tiers["words"] if raw.name != "sil"] == ["Hello", "there", "How", "are", "you"]
    for raw_labels in tiers.values():
        assert raw_labels[0].start == 0
        assert raw_labels[-1].end == pytest.approx(duration, abs=1e-4)
        assert all(a.end == b.start for a, b in pairwise(raw_labels))
    assert '"value"' in mouth.read_text()


def test_a_text_may_be_read_from_a_file(tmp_path: Path) -> None:
    (tmp_path / "t.txt").write_text("Guten Tag.", "utf-8")
    out = tmp_path / "t.TextGrid"
    assert main(["speak", "--file", str(tmp_path / "t.txt"), "--language", "de", "--labels", str(out)]) == 0
    assert '"Guten"' in out.read_text("utf-8")


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (["Hallo", "--language", "de", "--voice", "xx"], "no voice 'xx'"),
        (["Hallo", "--language", "de", "--rate", "99"], "the rate must lie in"),
        (["Hallo", "--program", "nothing"], "where the sound goes"),
    ],
)
def test_what_cannot_be_spoken_is_refused_in_a_sentence_and_nothing_is_written(
    words: list[str], sentence: str, tmp_path: Path, capsys: Capsys
) -> None:
    assert main(["speak", *words, "-o", str(tmp_path / "o.wav")]) == 1
    said = capsys.readouterr().err
    assert sentence in said
    assert len(said.splitlines()) == 1
    assert list(tmp_path.iterdir()) == []


def test_the_words_of_a_program_are_found_by_its_text(tmp_path: Path, capsys: Capsys) -> None:
    player = tmp_path / "player.py"
    player.write_text(f"import shutil, sys\nshutil.copy({str(SAID)!r}, sys.argv[1])\n", encoding="utf-8")
    program = ["--program", shlex.join([Path(sys.executable).as_posix(), player.as_posix(), "{output}"])]
    labels, mouth = tmp_path / "o.TextGrid", tmp_path / "o.json"
    written = ["--labels", str(labels), "--export", str(mouth), "--format", "rhubarb-json", "--overwrite"]
    assert main(["speak", TEXT, *program, *written]) == 1
    assert "the language of a text is not guessed; name it with --language" in capsys.readouterr().err
    assert not labels.exists()
    assert main(["speak", TEXT, *program, *written, "--language", "de"]) == 0
    words = [word.text for word in read_utterance(labels, 3.0).words]
    assert words == TEXT.replace(",", "").replace(".", "").split()
    assert len({cue["value"] for cue in json.loads(mouth.read_text("utf-8"))["mouthCues"]}) > 4
    assert capsys.readouterr().err == ""
    assert main(["speak", TEXT + " Und Schnee.", *program, *written, "--language", "de"]) == 0
    assert re.search("note: these words are not spoken: (Und )?Schnee", capsys.readouterr().err)


def test_a_lexicon_tells_the_voice_and_what_it_cannot_say_is_told(tmp_path: Path, capsys: Capsys) -> None:
    lexicon, labels = tmp_path / "l.csv", tmp_path / "o.TextGrid"
    lexicon.write_text("word,ipa\nZug,ˈθɪŋ\nTor,ˈnæ.sə\n", encoding="utf-8")
    text = ["Das Tor, der Zug, das Tor. Ein Tor.", "--language", "de", "--lexicon", str(lexicon)]
    assert main(["speak", *text, "--labels", str(labels)]) == 0
    said = {word.text: [phone.ipa for phone in word.phones] for word in read_utterance(labels, 10.0).words}
    assert said["Zug"] == ["θ", "ɪ", "ŋ"]
    assert said["Tor"] != ["n", "æ", "s", "ə"]
    assert capsys.readouterr().err == (
        "phonemeanalyser: the lexicon: note: the voice of de reads as usual, for want of their sounds: Tor\n"
    )


def sentences() -> Iterator[SpokenSentence]:
    word = Word("hi", (Syllable((Phone(0.0, 0.5, "a", Phoneme.A),)),))
    return (SpokenSentence(np.full(22_050, 0.1, np.float32), (word,), text) for text in ("Hi.", "Ho."))


def test_without_a_file_the_text_is_played_and_printed(capsys: Capsys) -> None:
    card = SelfMovingOutput()
    play_aloud(sentences(), Cards(card))
    said = capsys.readouterr()
    assert (said.out.splitlines(), said.err) == (["Hi.", "Ho."], "")
    assert card.n_written == 44_100


def test_a_card_that_goes_in_the_midst_of_a_text_is_told_and_the_rest_is_heard(capsys: Capsys) -> None:
    first, second = SelfMovingOutput(lost_after=10_000), SelfMovingOutput()
    play_aloud(sentences(), Cards(first, second))
    assert "the sound card: note: it takes no sound any more" in capsys.readouterr().err
    assert 10_000 <= first.n_written < 44_100
    assert second.n_written >= 44_100 - first.n_written


def test_a_text_that_nobody_can_hear_is_refused_in_one_sentence(capsys: Capsys) -> None:
    with pytest.raises(DeviceError, match=r"^the sound card is not there; to write .* name it with -o$"):
        play_aloud(sentences(), Cards())
    assert capsys.readouterr().out == ""
