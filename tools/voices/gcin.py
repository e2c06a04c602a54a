"""A speaker of Mandarin, the recordings 3.ogg of gcin-voice: a syllable each, whose zhuyin is its folder's name.

The recordings 5.ogg are another speaker's, by which recognisers are judged: they are not unpacked.
"""

from collections.abc import Iterator
from pathlib import Path

from tools.voices.aligner import PAUSE, aligned
from tools.voices.labels import Segment
from tools.voices.mandarin_phones import MANDARIN, phones_of
from tools.voices.packages import RECORDINGS
from tools.voices.recordings import PEOPLE, decoded, is_speech
from tools.voices.voice import Voice
from tools.voices.writing import Speaker, Utterance

FOLDER, FILE = "usr/share/gcin-voice/ogg", "3.ogg"
LICENCE = "GPL-3 or LGPL-3 (Edward Der-Hua Liu)"
STOPS = ("p", "pʰ", "t", "tʰ", "k", "kʰ", "tɕ", "tɕʰ", "ʈʂ", "ʈʂʰ", "ts", "tsʰ")
CLOSURE = 0.03  # s for which the mouth is closed at the least before a stop bursts, after a pause without a sound
BURST = 0.02  # s of a pʰ
BREATH = "h"


def voices(cache: Path) -> list[Voice]:
    """The speaker of the recordings 3.ogg."""
    speaker = Speaker("gcin", "3", "zh-TW", "", PEOPLE, LICENCE, RECORDINGS["gcin"], "mandarin")
    return [Voice(speaker, MANDARIN, lambda: _utterances(cache))]


def _utterances(cache: Path) -> Iterator[Utterance]:
    """Syllables with the times of their phones; without any where the name does not tell what is said."""
    paths = sorted((cache / "packages" / RECORDINGS["gcin"] / FOLDER).glob(f"*/{FILE}"))
    read = {path.parent.name: decoded(path) for path in paths}
    known = {name: phones for name in read if (phones := phones_of(name.rstrip("12345"))) and is_speech(*read[name])}
    (sample_rate,) = {read[name][1] for name in known}
    found = aligned([read[name][0] for name in known], sample_rate, [*known.values()])
    segments = dict(zip(known, found, strict=True))
    for name, (sound, its_rate) in read.items():
        if is_speech(sound, its_rate):
            yield Utterance(sound, its_rate, with_closures(segments.get(name, [])), name)


def with_closures(segments: list[Segment]) -> list[Segment]:
    """The segments, with a stop after a pause beginning before its burst; after that of pʰ the lips are open."""
    found = [*segments]
    if len(found) > 1 and found[0].phone == PAUSE and found[1].phone in STOPS:
        start = max(0.0, found[0].end - CLOSURE)
        found[:2] = [found[0]._replace(end=start), found[1]._replace(start=start)]
    for k, (start, end, phone) in enumerate(segments):
        if phone == "pʰ" and end - start > BURST:
            found[k : k + 1] = [Segment(found[k].start, start + BURST, phone), Segment(start + BURST, end, BREATH)]
    return found
