"""Projects of Papagayo and Papagayo-NG, version 1: voice, phrases, words and phonemes on the frames of a film.

A phrase stands for the speech between two silences. Its words are those of the script; without one it is one word
that spells our phonemes. Frames count from 0, and Papagayo shows the mouth at rest wherever there is no phrase. The
sound is named with all its folders: any other name is looked for in the folder of the project.
"""

from collections import deque
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import groupby, pairwise

from phonemeengine.labels.utterance import Word
from phonemeengine.mouth.cues import Cue
from phonemeengine.mouth.exports.export import Export, drawings_on_frames, frame_of, one_token
from phonemeengine.mouth.transcript import Transcript
from phonemeengine.phonemes import Phoneme

Drawing = tuple[int, int, Cue]


@dataclass(frozen=True)
class _DrawnWord:
    """A word of a phrase: its text without spaces, and its drawings, at least one."""

    text: str
    drawings: list[Drawing]

    @property
    def first(self) -> int:
        """Its first frame."""
        return self.drawings[0][0]

    @property
    def last(self) -> int:
        """Its last frame."""
        return self.drawings[-1][1] - 1


def write(export: Export) -> Iterator[str]:
    """Return a project with one voice, in parts."""
    waiting = deque(export.speech.words)
    phrases = [_words_in(phrase, waiting) for phrase in _phrases(export)]
    text = "|".join(_text_of(phrase) for phrase in phrases)
    yield f"lipsync version 1\n{_sound_of(export.speech)}\n{export.rate:.0f}\n"
    yield f"{max(frame_of(export.speech.duration, export.rate), 1)}\n1\n"
    yield f"\tVoice 1\n\t{text}\n\t{len(phrases)}\n"
    for phrase in phrases:
        yield f"\t\t{_text_of(phrase)}\n\t\t{phrase[0].first}\n\t\t{phrase[-1].last}\n\t\t{len(phrase)}\n"
        for word in phrase:
            yield f"\t\t\t{word.text} {word.first} {word.last} {len(word.drawings)}\n"
            for frame, _, cue in word.drawings:
                yield f"\t\t\t\t{frame} {cue.shape}\n"


def _sound_of(speech: Transcript) -> str:
    """Return where the sound is; its name alone where that is unknown, or would break the line."""
    place = str(speech.path.resolve()) if speech.path else ""
    return place if place and place.isprintable() else speech.name


def _phrases(export: Export) -> Iterator[list[Drawing]]:
    """Return the drawings between two silences."""
    phrase: list[Drawing] = []
    for drawing in drawings_on_frames(export):
        if drawing[2].phoneme != Phoneme.SILENCE:
            phrase.append(drawing)
        elif phrase:
            yield phrase
            phrase = []
    if phrase:
        yield phrase


def _words_in(phrase: list[Drawing], waiting: deque[Word]) -> list[_DrawnWord]:
    """Return the words of a phrase, each with the drawings that lie in it for the longest time.

    Words without a drawing of their own are joined to their neighbour. Drawings that lie in no word are one that
    spells its phonemes. The words are taken from `waiting`.
    """
    start, end = phrase[0][2].start, phrase[-1][2].end
    while waiting and waiting[0].end <= start:
        waiting.popleft()
    said = []
    while waiting and (waiting[0].start + waiting[0].end) / 2 < end:
        said.append(waiting.popleft())
    groups = [(owner, list(part)) for owner, part in groupby(phrase, lambda drawing: _owner_of(drawing[2], said))]
    named = [owner for owner, _ in groups if owner is not None]
    texts = iter([_joined(said[first:last]) for first, last in pairwise([0, *named[1:], len(said)])])
    return [_DrawnWord(_spelt(part) if owner is None else next(texts), part) for owner, part in groups]


def _joined(words: Sequence[Word]) -> str:
    return "-".join(one_token(word.text) for word in words)


def _owner_of(cue: Cue, words: Sequence[Word]) -> int | None:
    shared = [min(cue.end, word.end) - max(cue.start, word.start) for word in words]
    most = max(shared, default=0.0)
    return shared.index(most) if most > 0 else None


def _text_of(phrase: Sequence[_DrawnWord]) -> str:
    return " ".join(word.text for word in phrase)


def _spelt(drawings: Sequence[Drawing]) -> str:
    return "-".join(cue.phoneme.label for _, _, cue in drawings)
