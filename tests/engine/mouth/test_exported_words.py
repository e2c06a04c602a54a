"""The words of a script in the files of other programs."""

import json
from pathlib import Path

import pytest
from praatio import textgrid

from phonemeengine.labels.audacity import raw_labels_of
from phonemeengine.labels.utterance import UNKNOWN_WORD
from phonemeengine.labels.utterance_files import read_utterance
from phonemeengine.mouth.curves_file import parse_curves
from phonemeengine.mouth.exports.exporter import Exporter, ExportOptions
from phonemeengine.mouth.exports.formats import FORMATS
from phonemeengine.mouth.transcript import Transcript
from tests.engine.mouth.speaking import words_said

SAID = words_said(
    ("I'm", 0.5, (("a", 0.2), ("m", 0.1))),
    ("my", 0.8, (("m", 0.1), ("a", 0.2))),
    (UNKNOWN_WORD, 1.1, (("s", 0.2),)),
    ("New York", 1.8, (("n", 0.1), ("u", 0.2), ("k", 0.1))),
    duration=2.5,
)
"""Two words that share a closure, a word that the script lacks, a pause, and a word with a space."""
WORDS = [(0.5, 0.8, "I'm"), (0.8, 1.1, "my"), (1.8, 2.2, "New York")]


def written(name: str, said: Transcript = SAID, **options: object) -> str:
    return b"".join(Exporter(name, ExportOptions(**options)).chunks_of(said)).decode("utf-8")


def test_a_textgrid_has_words_phones_and_phonemes_and_the_mouth_shapes_beside_them(tmp_path: Path) -> None:
    path = tmp_path / "a.TextGrid"
    path.write_text(written("textgrid", table="preston-blair"), encoding="utf-8")
    grid = textgrid.openTextgrid(str(path), includeEmptyIntervals=False)
    assert grid.tierNames == ("words", "syllables", "phones", "phonemes", "mouth")
    times = [(entry.start, entry.end, entry.label) for entry in grid.getTier("words").entries]
    assert times == [*WORDS[:2], (1.1, 1.3, UNKNOWN_WORD), WORDS[2]]
    assert [entry.label for entry in grid.getTier("phones").entries] == ["a", "m", "m", "a", "s", "n", "u", "k"]
    assert "MBP" in [entry.label for entry in grid.getTier("mouth").entries]
    said, was = read_utterance(path, SAID.duration), SAID.utterance
    assert was is not None
    assert [(word.text, word.phones) for word in said.words] == [(word.text, word.phones) for word in was.words]


def test_annosoft_has_each_word_before_its_first_phoneme() -> None:
    rows = [line.split() for line in written("anno").splitlines()[1:]]
    words = [(int(row[1]) / 1000, int(row[2]) / 1000, row[3]) for row in rows if row[0] == "word"]
    assert words == [*WORDS[:2], (1.8, 2.2, "New_York")]
    for k, row in enumerate(rows):
        if row[0] == "word":
            following = next(later for later in rows[k:] if later[0] == "phn")
            assert int(following[1]) <= int(row[1]) < int(following[2])


def test_audacity_has_the_words_in_quotes_and_they_are_no_sounds_when_it_is_read_back() -> None:
    text = written("audacity")
    quoted = [line.split("\t") for line in text.splitlines() if line.endswith('"')]
    assert [(float(start), float(end), name) for start, end, name in quoted] == [
        (start, end, f'"{word}"') for start, end, word in WORDS
    ]
    without = written("audacity", Transcript(SAID.name, SAID.duration, SAID.runs, SAID.intensities, SAID.pitches))
    assert [(raw.start, raw.end, raw.name) for raw in raw_labels_of(text, "a.txt")] == [
        (raw.start, raw.end, raw.name) for raw in raw_labels_of(without, "a.txt")
    ]


def test_rhubarb_s_json_has_the_words_in_its_metadata_and_stays_the_program_s_own() -> None:
    text = written("rhubarb-json")
    metadata = json.loads(text)["metadata"]
    assert list(metadata) == ["soundFile", "duration", "words"]
    assert [(word["start"], word["end"], word["word"]) for word in metadata["words"]] == WORDS
    owns = FORMATS["rhubarb-json"].owns
    assert owns is not None
    assert owns(text.encode())


def test_curves_have_the_words_and_are_read_back_with_them() -> None:
    assert list(parse_curves(written("curves-json", rate=10)).words) == WORDS


@pytest.mark.parametrize("rate", [24, 100])
def test_papagayo_has_the_words_of_each_phrase(rate: int) -> None:
    assert papagayo_words(written("papagayo-pgo", rate=rate)) == ["I'm my sz", "New_York"]


def test_a_word_without_a_mouth_shape_of_its_own_is_joined_to_its_neighbour() -> None:
    said = words_said(("am", 0.5, (("a", 0.2), ("m", 0.1))), ("m", 0.8, (("m", 0.1),)), duration=1.5)
    assert papagayo_words(written("papagayo-pgo", said)) == ["am-m"]


def papagayo_words(text: str) -> list[str]:
    """Give the text of each phrase, whose words are those below it."""
    lines = [line.strip() for line in text.splitlines()]
    words = [line.split()[0] for line in lines[7:] if len(line.split()) == 4]
    assert " ".join(words) == lines[6].replace("|", " ")
    return lines[6].split("|")


def test_each_word_of_papagayo_holds_its_own_mouth_shapes() -> None:
    lines = [line.strip().split() for line in written("papagayo-pgo", rate=100).splitlines()[7:]]
    at = [k for k, line in enumerate(lines) if len(line) == 4]
    shapes = {lines[k][0]: [line[1] for line in lines[k + 1 : k + 1 + int(lines[k][3])]] for k in at}
    assert shapes["I'm"] == ["AI", "MBP"]
    assert shapes["my"] == ["AI"]
    assert shapes["sz"] == ["etc"]
