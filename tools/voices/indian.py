"""Speech of the Festival voices of Hindi, Marathi and Telugu, with the phone times that the synthesizer used."""

import random
import subprocess
import tempfile
from collections.abc import Iterator
from pathlib import Path

import soundfile

from tools.voices.classes import AFFRICATE, AMBIGUOUS, CORE, DIPHTHONG, PLAIN, SCH, X, table_of
from tools.voices.labels import Segment, segments_from_ends
from tools.voices.texts import utterances
from tools.voices.voice import Voice
from tools.voices.writing import Speaker, Utterance

INDIAN = table_of(
    *PLAIN,
    ("ʃ", SCH, CORE, "sh"),
    ("ʒ", SCH, CORE, "zh"),
    ("tʃ", SCH, AFFRICATE, "ch"),
    ("dʒ", SCH, AFFRICATE, "j"),
    ("kʃ", SCH, AFFRICATE, "ksh"),
    ("ʃri", X, AMBIGUOUS, "sri"),
    ("ɳ", X, CORE, "N"),
    ("bʱ", "p", CORE, "bh"),
    ("ə", "a", AMBIGUOUS, "a"),
    ("aː", "a", CORE, "aa"),
    ("aː", "a", AMBIGUOUS, "@"),
    ("e", "e", CORE, "eh ee"),
    ("ai", "a", DIPHTHONG, "ay"),
    ("i", "i", CORE, "ih iy"),
    ("o", "o", CORE, "oh oo"),
    ("au", "a", DIPHTHONG, "aw"),
    ("u", "u", CORE, "uh uw"),
    ("ʊ", "u", AMBIGUOUS, "w"),
    ("j", X, CORE, "y"),
    ("ʋ", X, CORE, "v"),
    ("f", X, CORE, "f"),
    ("h", X, CORE, "h x"),
    ("k", X, CORE, "kh"),
    ("g", X, CORE, "gh"),
    ("ʈ", X, CORE, "T td"),
    ("ɖ", X, CORE, "D"),
    ("t̪", X, CORE, "th tth"),
    ("d̪", X, CORE, "dh ddh"),
    ("l", X, CORE, "l"),
    ("ɭ", X, CORE, "L"),
    ("r", X, CORE, "r R"),
)


LANGUAGES = {"hi": "hindi", "mr": "marathi", "te": "telugu"}
STRETCH = (1.0, 1.7)  # Duration_Stretch; the voices' own is 1.4
PITCHES = (85.0, 150.0)  # Hz
SPREADS = (8.0, 24.0)  # Hz
BATCH = 20
LONGEST_PAUSE = 1.0  # s, before an utterance's end; the Telugu voice adds nearly two


def voices(cache: Path) -> list[Voice]:
    """The three voices, of one speaker."""
    return [_voice(code, cache) for code in LANGUAGES]


def _voice(code: str, cache: Path) -> Voice:
    package = f"festvox-{code}-nsk"
    speaker = Speaker("indian", f"nsk_{code}", f"{code}-IN", "male", "human-diphone", "GPL-2+", package, "indian")
    return Voice(speaker, INDIAN, lambda: _utterances(code, cache))


def _utterances(code: str, cache: Path) -> Iterator[Utterance]:
    chance = random.Random(code)
    texts = utterances(code, "nsk", cache)
    while True:
        batch = [next(texts).replace("।", ".") for _ in range(BATCH)]
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            _synthesize(LANGUAGES[code], batch, folder, chance)
            for index, text in enumerate(batch):
                utterance = _read(folder / str(index), text)
                if utterance is not None:
                    yield utterance


def _synthesize(language: str, batch: list[str], folder: Path, chance: random.Random) -> None:
    script = [f"(voice_{language}_NSK_diphone)"]
    for index, text in enumerate(batch):
        mean, spread = chance.uniform(*PITCHES), chance.uniform(*SPREADS)
        script.append(f"(Parameter.set 'Duration_Stretch {chance.uniform(*STRETCH):.3f})")
        script.append(f"(set! int_simple_params '((f0_mean {mean:.0f}) (f0_std {spread:.0f})))")
        script.append(
            f'(unwind-protect (begin (set! u (utt.synth (Utterance Text "{text}")))'
            f' (utt.save.segs u "{folder}/{index}.lab") (utt.save.wave u "{folder}/{index}.wav" (quote riff))) nil)'
        )
    (folder / "script.scm").write_text("\n".join(script), encoding="utf-8")
    subprocess.run(
        ["festival", "-b", str(folder / "script.scm")],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        check=False,
    )


def _read(base: Path, text: str) -> Utterance | None:
    """What was spoken, or None where the voice failed."""
    if not (base.with_suffix(".lab").exists() and base.with_suffix(".wav").exists()):
        return None
    segments = segments_saved(base.with_suffix(".lab").read_text(encoding="latin-1"))
    sound, sample_rate = soundfile.read(base.with_suffix(".wav"))
    if len(segments) < 4:
        return None
    end = min(len(sound), int((segments[-1].start + LONGEST_PAUSE) * sample_rate))
    return Utterance(sound[:end], sample_rate, segments, text)


def segments_saved(text: str) -> list[Segment]:
    """Segments from a label file of Festival: end in seconds, a number, the phone."""
    fields = [line.split() for line in text.splitlines()]
    return segments_from_ends([(parts[2], float(parts[0])) for parts in fields if len(parts) >= 3])
