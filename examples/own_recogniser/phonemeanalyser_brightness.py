"""Silence, a dark sound or a bright one: a recogniser that does all that those of the program do.

It looks ahead, says how likely each phoneme is, can be fitted to recordings, and learns a voice.
"""

from dataclasses import replace

import numpy as np

from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.scores import SCORES, Recognition, ScoredRecogniser, Sensitivity
from phonemeengine.recognition.spec import RecogniserSpec, Tuning
from phonemeengine.settings import FRAME_PERIOD

STEEPNESS = 4.0  # how quickly what is twice the limit becomes sure


class Brightness(ScoredRecogniser):
    """Names s where the band of s and sch is strong, a where it is weak, and silence where the sound is faint.

    Its scores are one probability for each phoneme, so the window can show and weigh them, and the base says by how
    much each phoneme falls short, and why one is named.
    """

    used_thresholds = frozenset({"silence_max_energy", "szsch_szsch1"})

    def __init__(self, config):
        self.look_ahead = int(config.look_ahead / FRAME_PERIOD + 1e-6)  # in frames
        self.faintest = config.thresholds.silence_max_energy  # of the amplitude (RMS)
        self.brightest = config.thresholds.szsch_szsch1  # of the mean of that band
        self.sensitivity = Sensitivity(config.sensitivities)
        self.waiting = np.zeros((0, 2), np.float32)  # frames for which not enough has come yet

    def recognise(self, windows, features):
        """Take the next frames, and answer for those after which `look_ahead` others have come."""
        amplitudes = np.sqrt(np.mean(windows**2, axis=1))
        measured = np.stack((amplitudes, features["m_szsch1"]), axis=1)
        waiting = np.concatenate((self.waiting, measured))
        n = max(0, len(waiting) - self.look_ahead)
        self.waiting = waiting[n:]
        if n == 0:
            return Recognition(np.zeros(0, np.uint8), np.zeros((0, len(SCORES)), np.float32))
        means = np.lib.stride_tricks.sliding_window_view(waiting, self.look_ahead + 1, axis=0).mean(axis=2)
        loud, bright = sure(means[:, 0], self.faintest), sure(means[:, 1], self.brightest)
        scores = np.zeros((n, len(Phoneme)), np.float32)
        scores[:, Phoneme.SILENCE] = 1 - loud
        scores[:, Phoneme.SZ] = loud * bright
        scores[:, Phoneme.A] = loud * (1 - bright)
        scores = self.sensitivity.apply(scores)
        return Recognition(scores.argmax(axis=1).astype(np.uint8), scores)


def sure(values, limit):
    """How sure it is that values lie above a limit: 0..1, one half at the limit."""
    return 1 / (1 + np.clip(values / limit, 0.01, 100) ** -STEEPNESS)


def fit(preset, task, progress):
    """Put the limit between a and s where it lies in recordings; what is given: `calibration.fits.fitting.Fit`."""
    progress(0.0)
    return with_limit(preset, task.features["m_szsch1"], task.phonemes)


def adapt(preset, takes, set_silence, progress):
    """Learn a voice from its takes, wholly or only the room; what is given: `calibration.calibrate.Adapt`."""
    from phonemeengine.calibration.workbench.labelled_features import LabelledFeatures  # only here: it takes a while

    quiet = set_silence(preset)
    workbench = LabelledFeatures(takes, quiet, progress=progress)
    strengths = workbench.features()["m_szsch1"]
    return with_limit(quiet, strengths, workbench.labels.phonemes), quiet


def with_limit(preset, strengths, phonemes):
    """Return the preset whose limit lies between the middles of a and s, where both are known."""
    middles = [np.median(strengths[phonemes == p]) for p in (Phoneme.A, Phoneme.SZ) if (phonemes == p).any()]
    if len(middles) < 2:
        return preset
    limit = float(np.sqrt(middles[0] * middles[1]))
    return replace(preset, thresholds=replace(preset.thresholds, szsch_szsch1=limit))


SPEC = RecogniserSpec(
    name="brightness",
    make=Brightness,
    tuned_by=frozenset({Tuning.THRESHOLDS, Tuning.SENSITIVITIES}),
    uses_own_variables=False,
    looks_ahead=True,
    has_deficits=True,
    fit="phonemeanalyser_brightness:fit",
    adapt="phonemeanalyser_brightness:adapt",
)
