"""A speech encoder that hears nothing but how loud it is, and says so when the sound is over."""

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.errors import ModelError
from phonemeengine.features.measure import Features
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.learned import LearnedRecogniser
from phonemeengine.recognition.recognition import Recognition
from phonemeengine.recognition.scores import SCORES

STRETCH = 30
"""Frames that are heard at once."""


class StretchRecogniser(LearnedRecogniser):
    """Names loud frames a, others silence, by stretches."""

    def __init__(self, preset: Preset) -> None:
        assert preset.model is not None
        super().__init__(preset.model, 0.0)
        self.look_ahead = 50
        self._held = np.zeros(0, bool)

    def recognise(self, windows: Float32Array, _features: Features) -> Recognition:
        self._held = np.concatenate((self._held, np.abs(windows[:, 1024 - 220 : 1024 + 220]).max(axis=1) > 0.1))
        return self._said(len(self._held) // STRETCH * STRETCH)

    def finish(self) -> Recognition:
        return self._said(len(self._held))

    def _said(self, n: int) -> Recognition:
        loud, self._held = self._held[:n], self._held[n:]
        phonemes = np.where(loud, Phoneme.A, Phoneme.SILENCE).astype(np.uint8)
        return Recognition(phonemes, np.eye(len(SCORES), dtype=np.float32)[phonemes])


def encoder_recogniser(preset: Preset) -> StretchRecogniser:
    return StretchRecogniser(preset)


def damaged(_preset: Preset) -> StretchRecogniser:
    raise ModelError("model.bin: the speech encoder is damaged; get it anew")
