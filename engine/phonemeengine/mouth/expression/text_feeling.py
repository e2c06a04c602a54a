"""What a text says of feeling, as an expression in the times in which it is spoken."""

from bisect import bisect_left
from collections.abc import Sequence

import numpy as np

from phonemeengine.labels.utterance import Utterance
from phonemeengine.mouth.blendshape_names import ARKIT
from phonemeengine.mouth.expression.streams import RecordedExpression, held_expression
from phonemeengine.text.feelings import FeelingLexicon, FeltPassage, passages_of

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
