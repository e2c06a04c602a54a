"""How a face follows the feeling in a voice, as far as is asked for, and that in a text, when it is spoken."""

from bisect import bisect_left
from collections import deque
from collections.abc import Sequence
from dataclasses import astuple, dataclass, fields

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.errors import MouthError, remedy
from phonemeengine.features.feeling import Feeling
from phonemeengine.labels.utterance import Utterance
from phonemeengine.mouth.blendshape_names import ARKIT
from phonemeengine.mouth.expression.streams import RecordedExpression, columns_of, held_expression
from phonemeengine.mouth.idle_motion import HeadPose
from phonemeengine.mouth.morpher import LowPass
from phonemeengine.text.feelings import FeelingLexicon, FeltPassage, passages_of

FOLLOWING = 0.35
"""Time constant with which a face follows a feeling, seconds."""
LIVELIER, RAISED = 0.8, 4.0
"""Share by which a head moves more at full activation, and degrees by which it is raised."""


@dataclass(frozen=True)
class FeelingAmounts:
    """How far a face follows the feeling in the voice, each 0..1.

    Attributes
    ----------
    brows : rise with activation, and are lowered where it is unpleasant.
    lids : widen with activation, and sink with relaxed.
    smile : the corners of the mouth rise and fall with pleasantness.
    head : moves more with activation, and is raised.

    Raises
    ------
    MouthError : an amount is out of range.
    """

    brows: float = 1.0
    lids: float = 1.0
    smile: float = 1.0
    head: float = 1.0

    def __post_init__(self) -> None:
        for part in fields(self):
            if not 0 <= getattr(self, part.name) <= 1:
                amount = getattr(self, part.name)
                raise MouthError(f"the {part.name} follow a feeling by 0..1, found {amount:g}; correct it")

    @classmethod
    def of(cls, words: str) -> "FeelingAmounts":
        """Read one number for all, such as ``0.6``, or ``brows=0.5,smile=1``: what is not named stays still.

        Raises
        ------
        MouthError : there is no such part, or no number in 0..1.
        """
        parts = dict.fromkeys((part.name for part in fields(cls)), 0.0)
        entries = words.split(",") if "=" in words else [f"{name}={words}" for name in parts]
        for entry in entries:
            name, _, amount = (word.strip() for word in entry.partition("="))
            if name not in parts:
                raise MouthError(f"no part of a face called {name[:20]!r} follows a feeling; {remedy(name, parts)}")
            try:
                parts[name] = float(amount)
            except ValueError:
                raise MouthError(f"{words[:60]!r} holds no number for {name}; write such as {name}=0.5") from None
        return cls(**parts)

    def __bool__(self) -> bool:
        return any(astuple(self))


# What moves at full activation, full relaxed, and full pleasantness and unpleasantness, by the part that follows.
_EXCITED = (("brows", "browInnerUp", 0.5), ("brows", "browOuterUp", 0.6), ("lids", "eyeWide", 0.6))
_RELAXED = (("lids", "eyeBlink", 0.3), ("brows", "browInnerUp", 0.05))
_PLEASANT = (("smile", "mouthSmile", 0.7), ("smile", "cheekSquint", 0.35), ("lids", "eyeSquint", 0.2))
_UNPLEASANT = (("smile", "mouthFrown", 0.6), ("brows", "browDown", 0.6), ("lids", "eyeSquint", 0.25))
_UNIT = (_EXCITED, _RELAXED, _PLEASANT, _UNPLEASANT)


class FeltFace:
    """An expression that follows a feeling; times never go back.

    Parameters
    ----------
    amounts : how far each part of the face follows.
    """

    def __init__(self, amounts: FeelingAmounts) -> None:
        self._head = amounts.head
        self._coming: deque[tuple[float, Feeling]] = deque()
        self._activation, self._pleasantness = LowPass(FOLLOWING), LowPass(FOLLOWING)
        self._shapes = np.zeros((len(_UNIT), len(ARKIT)), np.float32)
        for shape, entries in zip(self._shapes, _UNIT, strict=True):
            for part, channel, share in entries:
                shape[columns_of(channel)] += np.float32(share * getattr(amounts, part))

    def add(self, time: float, feeling: Feeling) -> None:
        """Take the feeling from a time on, seconds."""
        self._coming.append((time, feeling))

    def weights(self, time: float) -> Float32Array:
        """Return the weights of `ARKIT` at a time, float32, shape (52,), 0..1."""
        self._advance(time)
        activation, pleasantness = self._activation.at(time), self._pleasantness.at(time)
        shares = np.maximum((activation, -activation, pleasantness, -pleasantness), 0).astype(np.float32)
        moved: Float32Array = np.minimum(shares @ self._shapes, np.float32(1))
        return moved

    def turned(self, pose: HeadPose, time: float) -> HeadPose:
        """Return the pose of a head that follows, from one that does not."""
        self._advance(time)
        lively = self._activation.at(time) * self._head
        share = 1 + LIVELIER * lively
        moved = HeadPose(*(share * angle for angle in pose))
        return moved._replace(pitch=moved.pitch + RAISED * lively)

    def _advance(self, time: float) -> None:
        while self._coming and self._coming[0][0] <= time:
            begin, feeling = self._coming.popleft()
            self._activation.set_target(begin, feeling.activation)
            self._pleasantness.set_target(begin, feeling.pleasantness)


FADE = 0.3
"""Seconds in which one feeling gives way to the next; half of them before the word where that begins."""

TimedFeeling = tuple[float, FeltPassage]
"""From when on, seconds, and what is felt."""


def timed_feelings(text: str, utterance: Utterance, lexicon: FeelingLexicon | None = None) -> list[TimedFeeling]:
    """Return what a text says of feeling, each from when its next word is spoken; see `passages_of`.

    Raises
    ------
    TextError : a direction cannot be followed.
    """
    offsets, at, folded = [], 0, text.casefold() if len(text.casefold()) == len(text) else text
    for word in utterance.words:
        found = folded.find(word.text.casefold(), at)
        offsets.append(at if found < 0 else found)
        at = offsets[-1] + (len(word.text) if found >= 0 else 0)
    starts = [*(word.start for word in utterance.words), utterance.duration]
    passages = passages_of(text, utterance.language, lexicon)
    return [(starts[bisect_left(offsets, passage.offset)], passage) for passage in passages]


def text_expression(timed: Sequence[TimedFeeling], amount: float = 1.0) -> RecordedExpression:
    """Return the expression of feelings in a text.

    Parameters
    ----------
    timed : see `timed_feelings`.
    amount : how far it is shown, 0..1.
    """
    times, frames = [-FADE], [np.zeros(len(ARKIT), np.float32)]
    for start, passage in timed:
        begin = max(start - FADE / 2, times[-1] + 1e-3)
        shown = held_expression({name: share * amount for name, share in passage.shares.items()}).weights(0.0)
        times += [begin, begin + FADE]
        frames += [frames[-1], shown]
    return RecordedExpression(np.array(times), np.array(frames))
