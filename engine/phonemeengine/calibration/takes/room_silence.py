"""What makes a room silence for recognisers by scores: a sensitivity of the learned one, a level of templates.

Both only rise: a room that is silence already changes nothing. Where there is speech, they rise no further than it
bears.
"""

from dataclasses import replace

import numpy as np

from phonemeengine.analyser import Analyser
from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.dsp.framing import Framer
from phonemeengine.dsp.log_mel import log_mels
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.scores import MOST_LOG_ODDS, scores_in
from phonemeengine.recognition.templates import levels_of

SHARE = 0.99
"""Share of the room's frames that shall be silence, and of the speech's that shall not."""
MARGIN_LOG_ODDS = 1.1
"""By how much silence is likelier in the room than anything else: three to one, in nats."""
MARGIN_LEVEL = 3.0
"""By how much the level of silence lies above the room, and below speech, dB."""
HIGHEST_LEVEL = -10.0
"""No room is so loud that what reaches this level is silence, dB."""
LEAST_LIKELY = 1e-7


def sensitivity_for(room: Float32Array, preset: Preset, speech: Float32Array | None = None) -> float:
    """Return the sensitivity for silence, nats, with which the learned recogniser takes a room for silence.

    Parameters
    ----------
    room : float32, shape (n,), 44.1 kHz.
    preset : of the learned recogniser; the sensitivity that it has is the least.
    speech : without pauses, in the same form.
    """
    now = preset.sensitivities.get(Phoneme.SILENCE, 0.0)
    found = MARGIN_LOG_ODDS - float(np.quantile(_log_odds_of(room, preset), 1 - SHARE))
    if speech is not None and len(speech):
        found = min(found, -float(np.quantile(_log_odds_of(speech, preset), SHARE)))
    return round(min(max(now, found), MOST_LOG_ODDS), 2)


def silence_level_for(room: Float32Array, now: float, speech: Float32Array | None = None) -> float:
    """Return the level below which templates take a frame for silence, dB; at least what it is `now`."""
    found = float(np.quantile(_levels_in(room), SHARE)) + MARGIN_LEVEL
    if speech is not None and len(speech):
        found = min(found, float(np.quantile(_levels_in(speech), 1 - SHARE)) - MARGIN_LEVEL)
    return round(min(max(now, found), HIGHEST_LEVEL), 1)


def _log_odds_of(sound: Float32Array, preset: Preset) -> Float64Array:
    """Return how much likelier silence is than the likeliest other phoneme, nats, without its own sensitivity."""
    others = {**preset.sensitivities, Phoneme.SILENCE: 0.0}
    analyser = Analyser(replace(preset, sensitivities=others), phonemes_only=True)
    parts = [scores_in(a.features) for a in (analyser.push(sound), analyser.finish())]
    scores = np.log(np.maximum(np.concatenate([p for p in parts if p is not None]), LEAST_LIKELY), dtype=np.float64)
    silence = scores[:, Phoneme.SILENCE].copy()
    scores[:, Phoneme.SILENCE] = -np.inf
    return np.asarray(silence - scores.max(axis=1))


def _levels_in(sound: Float32Array) -> Float32Array:
    return levels_of(log_mels(Framer().cut_frames(sound)))
