"""Speech of Mei, the Japanese voice that pyopenjtalk brings, with phone times read off a marker voice.

Of its phones, capital vowels are devoiced, and cl is the closure of a long consonant.
"""

import random
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from tools.voices import marker
from tools.voices.classes import AFFRICATE, AMBIGUOUS, CORE, PLAIN, SCH, SIL, SZ, X, table_of
from tools.voices.labels import Segment
from tools.voices.texts import utterances
from tools.voices.voice import Voice
from tools.voices.writing import Speaker, Utterance

JAPANESE = table_of(
    *PLAIN,
    ("", SIL, CORE, "sil"),
    ("z", SZ, CORE, "z"),
    ("ts", SZ, AFFRICATE, "ts"),
    ("ɕ", SCH, AMBIGUOUS, "sh"),
    ("dʑ", SCH, AFFRICATE, "j"),
    ("tɕ", SCH, AFFRICATE, "ch"),
    ("m", "m", CORE, "my"),
    ("n", X, CORE, "ny"),
    ("ɴ", X, AMBIGUOUS, "N"),
    ("p", "p", CORE, "py"),
    ("b", "p", CORE, "by"),
    ("a", "a", CORE, "a"),
    ("e", "e", CORE, "e"),
    ("i", "i", CORE, "i"),
    ("o", "o", CORE, "o"),
    ("ɯ", "u", CORE, "u"),
    ("ḁ", "a", AMBIGUOUS, "A"),
    ("e̥", "e", AMBIGUOUS, "E"),
    ("i̥", "i", AMBIGUOUS, "I"),
    ("o̥", "o", AMBIGUOUS, "O"),
    ("ɯ̥", "u", AMBIGUOUS, "U"),
    ("ʔ", X, CORE, "cl"),
    ("j", X, CORE, "y"),
    ("w", X, CORE, "w"),
    ("ɾ", X, CORE, "r ry"),
    ("h", X, CORE, "h hy"),
    ("ɸ", X, CORE, "f"),
    ("t", X, CORE, "t ty"),
    ("d", X, CORE, "d dy"),
    ("k", X, CORE, "ky kw"),
    ("g", X, CORE, "gy gw"),
    ("v", X, CORE, "v"),
)
# N before m, p and b is said as m: labelled so, but as ambiguous.
JAPANESE |= table_of(("m", "m", AMBIGUOUS, "N_m"))
LABIAL = frozenset({"m", "my", "p", "py", "b", "by"})


SPEEDS = (0.75, 1.3)
HALF_TONES = (-7.0, 2.0)  # her own pitch is above 300 Hz
SHIFT = -0.009  # s, measured: sounds move before the frame that a phone begins with
GEOMETRY = marker.Geometry(sample_rate=48000, frame=240, period=40, warping=0.55)


def voices(cache: Path) -> list[Voice]:
    """The voice Mei."""
    speaker = Speaker(
        "openjtalk",
        "mei",
        "ja-JP",
        "female",
        "synthetic-hts",
        "CC-BY-3.0 (NIT, MMDAgent)",
        "pyopenjtalk-plus",
        "japanese",
    )
    return [Voice(speaker, JAPANESE, lambda: _utterances(cache), SHIFT)]


def _utterances(cache: Path) -> Iterator[Utterance]:
    import pyopenjtalk

    phones = [phone for phone in JAPANESE if phone != "N_m"]
    voice = Path(pyopenjtalk.DEFAULT_HTS_VOICE.decode())
    twin = cache / "marker.htsvoice"
    twin.write_bytes(marker.marker_file(voice.read_bytes(), phones, GEOMETRY))
    speaker, marking = pyopenjtalk.HTSEngine(str(voice).encode()), pyopenjtalk.HTSEngine(str(twin).encode())
    chance = random.Random("mei")
    for text in utterances("ja", "mei", cache):
        labels = pyopenjtalk.extract_fullcontext(text)
        speed = chance.uniform(*SPEEDS)
        sound = _spoken(speaker, labels, speed, chance.uniform(*HALF_TONES))
        marks = _spoken(marking, labels, speed, 0.0)
        if len(sound) == len(marks):
            segments = marker.segments_marked(marks, phones, "sil", GEOMETRY)
            yield Utterance(sound / 32768.0, GEOMETRY.sample_rate, with_labial_nasals(segments), text)


def _spoken(engine, labels: list[str], speed: float, half_tones: float) -> np.ndarray:
    engine.set_speed(speed)
    engine.add_half_tone(half_tones)
    return engine.synthesize(labels)


def with_labial_nasals(segments: list[Segment]) -> list[Segment]:
    """The segments, with N written as N_m before lips close."""
    following = [segment.phone for segment in segments[1:]] + [""]
    return [
        segment._replace(phone="N_m") if segment.phone == "N" and phone in LABIAL else segment
        for segment, phone in zip(segments, following, strict=True)
    ]
