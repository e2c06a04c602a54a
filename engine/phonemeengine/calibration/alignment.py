"""Where the sounds of a known sentence are in a recording of it, so that presets can be told by it.

Nobody has labelled the recording by hand. What is said in it is known, though, in order: the most likely way through
that order is found by dynamic programming (Viterbi) over how likely the shipped model finds each sound in each frame.
That model is no part of the presets that are compared, unless one of them is the shipped one itself: that one is
favoured a little where two sounds meet. So what lies within 10 ms of such a place, or 30 ms of a silence, does not
count.
"""

from collections.abc import Iterable, Sequence
from functools import lru_cache

import numpy as np

from phonemeengine.analyser import analyse_blocks
from phonemeengine.arrays import Float32Array, Float64Array, IndexArray
from phonemeengine.calibration.sentences import Sentence, SpokenPhone
from phonemeengine.calibration.takes.take import TRIMMED
from phonemeengine.errors import TakeError
from phonemeengine.labels.label import CORE, Label
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import DEFAULT_PRESET, load_preset
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.scores import scores_in
from phonemeengine.settings import FRAME_PERIOD, HOP

LEAST_FRAMES = 3
"""What a sound lasts at least, 10 ms each."""
LEAST_LIKELY, LEAST_LIKELY_LOOSE = 0.001, 0.03
"""How likely every sound is in every frame at least; one whose class is not certain, or that has none, sounds like
much else."""
AROUND, AROUND_SILENCE = 0.01, 0.03
"""What does not count on each side of a place where two sounds meet, seconds."""
LEAST_FITTING = 0.4
"""Where the frames of clear sounds are found less likely than this, another sentence was read."""


def aligned(samples: Float32Array, sentence: Sentence) -> tuple[Label, ...]:
    """Label a recording of a sentence by its known text.

    Where sounds meet, and around silence, labels have the certainty ``trimmed``: nobody knows the place so well.

    Parameters
    ----------
    samples : float32, shape (n,), 44.1 kHz, ±1.
    sentence : what was read.

    Raises
    ------
    TakeError : it is too short for the sentence, or something else was read.
    """
    found = [scores_in(analysis.features) for analysis in analyse_blocks([samples], _judge())]
    likely = np.concatenate([scores for scores in found if scores is not None])
    return labels_of(likely[: len(samples) // HOP], sentence)


def labels_of(likely: Float32Array, sentence: Sentence) -> tuple[Label, ...]:
    """Label frames of a sentence by how likely each phoneme is in them, shape (n_frames, n_phonemes)."""
    sounds = sentence.sounds
    places = _places_of(likely, sounds)
    if _fitting(likely, sounds, places) < LEAST_FITTING:
        raise TakeError("what was heard is not this sentence; read it again, as it stands there, without haste")
    borders = np.flatnonzero(np.diff(places)) + 1
    runs = zip([0, *borders.tolist()], [*borders.tolist(), len(places)], strict=True)
    segments = [(first * FRAME_PERIOD, end * FRAME_PERIOD, sounds[places[first]]) for first, end in runs]
    return tuple(label for k in range(len(segments)) for label in _labels_at(segments, k))


def _labels_at(segments: Sequence[tuple[float, float, SpokenPhone]], k: int) -> Iterable[Label]:
    """Return the labels of a sound: its middle, and what does not count where it meets another class."""
    start, end, sound = segments[k]
    before, after = (_around(sound, segments[n][2]) if 0 <= n < len(segments) else 0.0 for n in (k - 1, k + 1))
    first = min(start + before, (start + end) / 2)
    last = max(first, end - after)
    name, phoneme = sound.phone or sound.sense.phoneme.label, sound.sense.phoneme
    parts = ((start, first, TRIMMED), (first, last, sound.sense.certainty), (last, end, TRIMMED))
    return [Label(a, b, name, phoneme, certainty) for a, b, certainty in parts if b - a > FRAME_PERIOD / 2]


def _around(one: SpokenPhone, other: SpokenPhone) -> float:
    classes = {one.sense.phoneme, other.sense.phoneme}
    if len(classes) == 1:
        return 0.0
    return AROUND_SILENCE if Phoneme.SILENCE in classes else AROUND


@lru_cache(maxsize=1)
def _judge() -> Preset:
    return load_preset(DEFAULT_PRESET)


def _places_of(likely: Float32Array, sounds: Sequence[SpokenPhone]) -> IndexArray:
    """Return the number of the sound in each frame, by the likeliest way through all that are not optional."""
    owners = np.repeat(np.arange(len(sounds)), LEAST_FRAMES)
    if len(likely) < LEAST_FRAMES * sum(not sound.optional for sound in sounds):
        raise TakeError("what was heard is too short for this sentence; read all of it, without haste")
    fits = _fits(likely, sounds)[:, owners]
    n_frames, n_states = fits.shape
    whence = _ways_into(sounds)
    best = np.full(n_states, -np.inf)
    firsts = [0, LEAST_FRAMES] if sounds[0].optional else [0]
    best[firsts] = fits[0, firsts]
    came = np.zeros((n_frames, n_states), np.intp)
    for k in range(1, n_frames):
        options = np.where(whence >= 0, best[whence], -np.inf)
        chosen = options.argmax(axis=0)
        came[k] = whence[chosen, np.arange(n_states)]
        best = options.max(axis=0) + fits[k]
    lasts = [n_states - 1, n_states - 1 - LEAST_FRAMES] if sounds[-1].optional else [n_states - 1]
    state = max(lasts, key=lambda n: best[n])
    path = np.zeros(n_frames, np.intp)
    for k in range(n_frames - 1, -1, -1):
        path[k], state = state, came[k, state]
    return owners[path]


def _ways_into(sounds: Sequence[SpokenPhone]) -> IndexArray:
    """Return from where each state can be reached, shape (3, n_states), -1 for nowhere.

    Each sound has `LEAST_FRAMES` states; it stays in the last of them, and goes on to the next sound, or past an
    optional one.
    """
    n = LEAST_FRAMES * len(sounds)
    options = np.full((3, n), -1)
    options[0, 1:] = np.arange(n - 1)
    for k in range(len(sounds)):
        first, last = k * LEAST_FRAMES, (k + 1) * LEAST_FRAMES - 1
        options[1, last] = last
        if k > 1 and sounds[k - 1].optional:
            options[2, first] = first - LEAST_FRAMES - 1
    return options


def _fits(likely: Float32Array, sounds: Sequence[SpokenPhone]) -> Float64Array:
    """Return how well each sound fits each frame, a logarithm, shape (n_frames, n_sounds)."""
    codes = [sound.sense.phoneme for sound in sounds]
    least = [LEAST_LIKELY if _is_clear(sound) else LEAST_LIKELY_LOOSE for sound in sounds]
    return np.log(np.maximum(likely[:, codes], least), dtype=np.float64)


def _fitting(likely: Float32Array, sounds: Sequence[SpokenPhone], places: IndexArray) -> float:
    """Return how likely the clear sounds are where they were found, 0..1, the mean of all of them."""
    shares = likely[np.arange(len(places)), [sounds[place].sense.phoneme for place in places]]
    clear = [k for k, s in enumerate(sounds) if _is_clear(s) and not s.optional]
    return float(np.mean([shares[places == k].mean() for k in clear]))


def _is_clear(sound: SpokenPhone) -> bool:
    return sound.sense.certainty == CORE and sound.sense.phoneme is not Phoneme.UNIDENTIFIED
