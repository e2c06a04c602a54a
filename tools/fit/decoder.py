"""Count what rules confuse on labelled speech, for the decoder of their preset, and how phonemes follow one another.

``python -m tools.fit.decoder presets/extended.toml CORPUS`` writes the confusions into the preset, and into its notes
what the decoder gains on speakers that were left out of the count. ``--texts FOLDER`` counts the statistics of
languages, from ``cs.txt``, ``de.txt`` and so on, which voices read.
"""

import argparse
import sys
from collections.abc import Iterable, Sequence
from dataclasses import replace
from itertools import groupby, pairwise
from pathlib import Path

import numpy as np
import tomli_w

from phonemeengine import EngineError, Preset, load_preset, save_preset
from phonemeengine.arrays import Float64Array, UInt8Array
from phonemeengine.calibration.scores.corpus import FrameLabels, LabelledUtterance, read_corpus
from phonemeengine.calibration.scores.evaluation import predict
from phonemeengine.calibration.scores.scoring import scores_of
from phonemeengine.labels.phone_sets import ipa_phoneme
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.decoder import BIGRAMS, Confusions, Decoder, SoundsDecoder, lag_of
from phonemeengine.settings import Decoding
from phonemeengine.text.pronunciation import words_of

WEIGHT = 0.7
"""Neighbouring answers are alike, so each counts as less than a whole observation."""
MOST_BIGRAM = 3.0
HEADING = "# How much less a change to each phoneme costs the decoder, nats; counted by tools.fit.decoder."
FEWEST = 20.0
"""Changes of each kind that are taken for seen at least: what is rare in a text may be common in a dialogue."""

NOTES = """\
The decoder goes by what these rules confuse, counted by tools.fit.decoder on the same speakers. Each speaker left out
of that count in turn, though not of the rules:"""

Heard = tuple[LabelledUtterance, FrameLabels, UInt8Array]
"""A recording, its labels, and the answers of the rules."""


def heard_with(preset: Preset, corpus: Path) -> list[Heard]:
    """Return what the rules of a preset say of a corpus, without any smoothing."""
    bare = replace(preset, settings=replace(preset.settings, statistics=False))
    found = []
    for utterance in read_corpus(corpus):
        predicted = predict(utterance, bare)
        found.append((utterance, predicted.labels, predicted.phonemes))
    return found


def confusions_in(heard: Iterable[Heard]) -> Confusions:
    """Return how likely each answer is while each phoneme is spoken, in weighted nats, to two decimals."""
    counts = np.ones((len(Phoneme), len(Phoneme)))
    for _, labels, answers in heard:
        np.add.at(counts, (labels.phonemes, answers), 1)
    rows = WEIGHT * np.log(counts / counts.sum(axis=1, keepdims=True))
    return {p: tuple(np.round(rows[p], 2).tolist()) for p in Phoneme if p is not Phoneme.UNIDENTIFIED}


def decoded(preset: Preset, heard: Sequence[Heard], look_ahead: float) -> list[UInt8Array]:
    """Return what the decoder of a preset says, with confusions of all other speakers for each."""
    said: dict[int, UInt8Array] = {}
    for voice in dict.fromkeys(u.voice for u, _, _ in heard):
        others = confusions_in(h for h in heard if h[0].voice != voice)
        decoder = Decoder(others, preset.settings.change_cost, preset.settings.decoder)
        for k, (utterance, _, answers) in enumerate(heard):
            if utterance.voice == voice:
                edges = np.array([0, len(answers)])
                said[k] = SoundsDecoder(edges).decode(decoder, lag_of(look_ahead), answers)
    return [said[k] for k in range(len(heard))]


def figures(heard: Sequence[Heard], said: Sequence[UInt8Array]) -> str:
    """Return the scores of all voices, and of the recordings of people alone, in words."""
    words = []
    for kind in ("", "human"):
        pairs = [(h[1], s) for h, s in zip(heard, said, strict=True) if h[0].corpus.startswith(kind)]
        scores = scores_of(pairs)
        words.append(
            f"{'people' if kind else 'all'}: macro F1 {scores.macro_f1:.3f}, mouth F1 {scores.viseme_f1:.3f}, "
            f"mouth accuracy {scores.viseme_accuracy:.3f}, {scores.changes_per_s:.1f} changes a second"
        )
    return "; ".join(words)


def bigrams_in(text: str, language: str) -> Float64Array:
    """Return how much likelier than chance each phoneme follows each other in a text, nats, 0 for the same."""
    counts = np.zeros((len(Phoneme), len(Phoneme)))
    for line in filter(str.strip, text.splitlines()):
        try:
            words = words_of(line, language)
        except EngineError:
            continue
        phones = (p for w in words for s in w.pronunciations[0].syllables for p in s.phones)
        codes = [ipa_phoneme(phone) for phone in phones]
        spoken = [Phoneme.SILENCE, *(c for c in codes if c is not Phoneme.UNIDENTIFIED), Phoneme.SILENCE]
        for one, other in pairwise(code for code, _ in groupby(spoken)):
            counts[one, other] += 1
    found = [p for p in Phoneme if p is not Phoneme.UNIDENTIFIED]
    counts = counts[np.ix_(found, found)] + FEWEST * (1 - np.eye(len(found)))
    shares = counts / counts.sum(axis=1, keepdims=True)
    less = np.zeros((len(Phoneme), len(Phoneme)))
    likelier = np.log(np.maximum(shares, 1e-9) * (len(found) - 1))
    less[np.ix_(found, found)] = np.clip(likelier, -MOST_BIGRAM, MOST_BIGRAM)
    np.fill_diagonal(less, 0.0)
    return np.round(less, 2)


def write_bigrams(texts: Path) -> None:
    """Count the statistics of all languages that have a text, and write them where the engine reads them."""
    tables = {}
    for path in sorted(texts.glob("*.txt")):
        less = bigrams_in(path.read_text(encoding="utf-8"), Decoding(path.stem))
        tables[path.stem] = {p.label: less[p].tolist() for p in Phoneme if less[p].any()}
    rows = tomli_w.dumps(tables).replace("\n    ", " ").replace(",\n]", " ]")
    BIGRAMS.write_text(f"{HEADING}\n{rows}")


def main(argv: Sequence[str] | None = None) -> int:
    """Count from the command line."""
    parser = argparse.ArgumentParser(prog="python -m tools.fit.decoder", description=__doc__)
    parser.add_argument("preset", type=Path, nargs="?", metavar="PRESET", help="preset of rules, to be changed")
    parser.add_argument("corpus", type=Path, nargs="?", metavar="CORPUS", help="folder with manifest.csv")
    parser.add_argument("--texts", type=Path, metavar="FOLDER", help="count languages from these texts instead")
    args = parser.parse_args(argv)
    try:
        if args.texts:
            write_bigrams(args.texts)
        if args.preset and args.corpus:
            preset = load_preset(args.preset)
            heard = heard_with(preset, args.corpus)
            notes = preset.notes.partition(f"\n{NOTES}")[0].rstrip() + f"\n{NOTES}\n"
            for look_ahead in (preset.settings.look_ahead, preset.settings.live_look_ahead):
                found = figures(heard, decoded(preset, heard, look_ahead))
                notes += f"Looking {1000 * look_ahead:.0f} ms ahead: {found}.\n"
            print(notes)
            save_preset(replace(preset, confusions=confusions_in(heard), notes=notes), args.preset)
    except EngineError as error:
        print(error, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
