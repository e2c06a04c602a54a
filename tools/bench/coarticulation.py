"""Mouths that move by labelled phones: when vowels are widest, the lip leaves the teeth, and which lips are shut.

The corpus of the tests is cut into two halves by speaker, each with German and English. The mouth tables and
`phonemeengine.mouth.cues` were tuned on `TUNED_ON` alone; the figures are of `HELD_OUT`, with the recorded man among
them. Labels bear no stress, so all full vowels count, of which the stressed ones are most.
"""

import csv
from collections import defaultdict
from collections.abc import Iterator, Sequence

import numpy as np

from phonemeengine import Animation, ExportOptions, IdleMotion, SoundReader, Transcript
from phonemeengine.analyser import analyse_file
from phonemeengine.labels.phone_sets import ARTICULATIONS, ipa_of, letters_of, marks_silence, phone_classes_in
from phonemeengine.labels.table import raw_labels_of
from phonemeengine.labels.utterance import Phone, Syllable, Utterance, Word
from phonemeengine.mouth.blendshape_names import ARKIT
from phonemeengine.mouth.exports.exporter import Exporter
from phonemeengine.mouth.transcript import scripted_transcript_of
from phonemeengine.presets.files import DEFAULT_PRESET, load_preset
from tools.bench.figures import ROOT, Figure
from tools.bench.performance import SHUT, Lips

CORPUS = ROOT / "tests" / "data" / "corpus"
TUNED_ON = frozenset({"de", "de_klatt", "kal", "nsh"})
HELD_OUT = frozenset({"de_f1", "de_m3", "slt", "cards"})
REDUCED = frozenset("əɐɜɨᵻʉɚ")
LABIODENTALS, ROUNDED, BILABIALS = frozenset("fv"), frozenset("uʊw"), frozenset("pbm")
FINE, PICTURES, SMOOTH = 200.0, 30.0, 60.0
"""Pictures per second: where times are measured, where lips are shut, and where the jerk is measured."""
EARLY, LEAVES = 0.6, 0.06
"""Share of a vowel within which it is widest; seconds after f or v in which the lip leaves the teeth."""
ROLLED, LEFT, PUCKERED, PLATEAU = 0.6, 0.1, 0.4, 2e-3
WIDEST_EARLY = 0.95
JERK, JERK_OF_FILMS = 3.983e-3, 18.236e-3
"""Mean third differences of all 52 weights at `SMOOTH` and `PICTURES` before mouths were ahead of consonants."""

RUSSIAN = {
    "a": "ə",
    "ae": "ə",
    "ay": "ə",
    "aa": "a",
    "e": "ɨ",
    "ee": "ɛ",
    "i": "ɨ",
    "ii": "i",
    "oo": "o",
    "u": "ʉ",
    "uu": "u",
    "ur": "ʉ",
    "y": "ɨ",
    "yy": "ɨ",
    "ch": "tɕ",
    "c": "ts",
    "sch": "ɕ",
    "h": "x",
    "sh": "ʂ",
    "zh": "ʐ",
}
"""Names of the Russian voice; double letters are stressed vowels, or soft consonants."""
Spoken = tuple[Sequence[Phone], Transcript]
Found = dict[str, list[bool | float]]


def figures() -> list[Figure]:
    """Measure on the held-out speakers."""
    found = measured(HELD_OUT)
    rows: tuple[tuple[str, str, float], ...] = (
        ("full vowels that are widest in their first 60 %", "widest", WIDEST_EARLY),
        ("f and v with the lip at the teeth", "rolled", 1.0),
        ("lip off the teeth 60 ms after f and v", "left", 1.0),
        ("u and w with round lips", "puckered", 1.0),
        (f"p, b, m shut at {PICTURES:g} pictures a second", "shut", 1.0),
    )
    shares = [
        Figure(name, f"{np.mean(found[key]):.1%}", f"{least:.0%}", least / float(np.mean(found[key])), limit=1.0)
        for name, key, least in rows
    ]
    jerks = [
        Figure(
            f"jerk of mouths at {rate:g} pictures a second",
            f"{np.mean(found[key]):.2e}",
            f"before, {most:.2e}",
            float(np.mean(found[key])) / most,
            limit=1.0,
        )
        for rate, key, most in ((SMOOTH, "jerk", JERK), (PICTURES, "film_jerk", JERK_OF_FILMS))
    ]
    return [*shares, *jerks]


def measured(speakers: frozenset[str]) -> Found:
    """Give what was found of every phone, and the jerk of every utterance, by name."""
    found, lips = defaultdict(list), Lips.of_head()
    for phones, speech in _spoken_by(speakers):
        fine = _animation(speech, FINE)
        for k, phone in enumerate(phones):
            _look_at(found, fine, phone, phones[k + 1 :])
        film = _animation(speech, PICTURES)
        apart = lips.apart(film)
        for phone in phones:
            if letters_of(phone.ipa)[0] in BILABIALS:
                found["shut"].append(apart[_within(film, phone.start, phone.end)].min(initial=1.0) <= SHUT)
        found["film_jerk"].append(_jerk(film))
        found["jerk"].append(_jerk(_animation(speech, SMOOTH)))
    return found


def _look_at(found: Found, film: Animation, phone: Phone, after: Sequence[Phone]) -> None:
    jaw, roll, pucker = (film.weights[:, ARKIT.index(name)] for name in ("jawOpen", "mouthRollLower", "mouthPucker"))
    letter, there = letters_of(phone.ipa)[0], _within(film, phone.start, phone.end)
    if letter in ARTICULATIONS["vowel"] - REDUCED:
        widest = film.times[there][np.argmax(jaw[there] >= jaw[there].max() - PLATEAU)]
        found["widest"].append(widest - phone.start <= EARLY * (phone.end - phone.start))
    if letter in LABIODENTALS:
        found["rolled"].append(roll[there].max() > ROLLED)
        soon = (letters_of(other.ipa)[0] for other in after if other.start < phone.end + LEAVES)
        if not (LABIODENTALS | BILABIALS) & {*soon}:
            found["left"].append(roll[_within(film, phone.end, phone.end + LEAVES)].min() < LEFT)
    if letter in ROUNDED:
        found["puckered"].append(pucker[there].max() > PUCKERED)


def _within(film: Animation, start: float, end: float) -> slice:
    return slice(*np.searchsorted(film.times, [start - 1e-9, end + 1e-9]).tolist())


def _jerk(film: Animation) -> float:
    """Give the mean third difference of all weights."""
    return float(np.abs(np.diff(film.weights, 3, axis=0)).mean())


def _animation(speech: Transcript, rate: float) -> Animation:
    still = IdleMotion(blinks=False, head=False)
    return Exporter("curves-json", ExportOptions(rate=rate, idle=still)).export_of(speech).animation


def _spoken_by(speakers: frozenset[str]) -> Iterator[Spoken]:
    preset = load_preset(DEFAULT_PRESET)
    with (CORPUS / "manifest.csv").open(encoding="utf-8") as file:
        rows = [row for row in csv.DictReader(file) if row["speaker"] in speakers]
    for row in rows:
        text = (CORPUS / row["labels"]).read_text(encoding="utf-8")
        labels = ((raw.start, raw.end, raw.phone or raw.name) for raw in raw_labels_of(text, row["labels"]))
        named = (
            (start, end, "".join(_symbols(name, row["phoneset"])))
            for start, end, name in labels
            if not marks_silence(name.lower()) and name != "??"
        )
        classes = ((start, end, ipa, phone_classes_in(ipa)[1]) for start, end, ipa in named)
        phones = [Phone(start, end, ipa, known.phoneme) for start, end, ipa, known in classes if known]
        with SoundReader(CORPUS / row["wav"]) as reader:
            utterance = Utterance((Word(row["text"], (Syllable(tuple(phones)),)),), reader.duration)
            said = scripted_transcript_of(analyse_file(reader, preset), utterance, row["wav"], reader.duration)[1]
        yield phones, said


def _symbols(name: str, phoneset: str) -> tuple[str, ...]:
    """Give the symbols of the IPA of a name in one of the corpus's sets."""
    whole, mark, half = name.partition("_")
    if phoneset == "radio":
        return ipa_of(whole.upper() + mark + half)
    if phoneset == "russian":
        single = whole[0] if len(whole) == 2 and whole[0] == whole[1] else whole
        return ipa_of(RUSSIAN.get(whole, single) + mark + half)
    return ipa_of(name)
