"""What rules are grown from: candidate variables, measured on labelled speech, at other levels and in noise."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from phonemeengine.analyser import Analyser
from phonemeengine.arrays import Float32Array, Float64Array, UInt8Array
from phonemeengine.calibration.fits.rule_finding import FRONT_END, frame_weights
from phonemeengine.calibration.scores.added_noise import AddedNoise, NoiseAdder, NoiseKind
from phonemeengine.calibration.scores.corpus import FrameLabels, LabelledUtterance, frame_labels_of, read_corpus
from phonemeengine.features.measure import Features
from phonemeengine.features.variables import Variable
from phonemeengine.presets.preset import Preset

GAINS = (-6.0, 6.0)
FLOORS = (-75.0, -60.0)
"""Level of the noise floor, dB below full scale."""
SNRS = (8.0, 22.0)
NOISES = tuple(NoiseKind)

COPIES = (1.0, 1.0, 0.5)
"""How much each copy of a recording counts: as it is, with another level and a noise floor, in noise."""
IMPORTANCE = (("human", 3.0), ("festival", 2.0), ("espeak", 0.4))
"""How much a speaker counts, by the beginning of the corpus's name; 1 where it begins otherwise."""

BLOCK = 1 << 16
STRIDE = 5
"""Of the frames of further speech each fifth is kept."""
MOST_RECORDINGS = {"espeak": 8}
MOST = 40
"""Recordings of a speaker of further speech that are used, by the beginning of the corpus's name."""


@dataclass(frozen=True)
class RuleFeatures:
    """An utterance with its copies.

    Attributes
    ----------
    utterance : whose it is.
    labels : of all frames.
    copies : what was measured on each copy, on every frame or on each so many-th.
    stride : how many frames lie from one that was kept to the next.
    """

    utterance: LabelledUtterance
    labels: FrameLabels
    copies: tuple[Features, ...]
    stride: int = 1

    @property
    def truth(self) -> UInt8Array:
        """The labels of the frames that were kept: codes of `Phoneme`, shape (n_kept,)."""
        return self.labels.phonemes[:: self.stride]

    @property
    def certainty(self) -> Float64Array:
        """How much each frame that was kept counts: less beside a boundary, whose place is seldom sure."""
        return frame_weights(self.labels)[:: self.stride]


def voice_of(utterance: LabelledUtterance) -> str:
    """Return the name of the voice: formant synthesizers speak all languages with the same ones."""
    if not utterance.corpus.startswith("espeak"):
        return utterance.speaker
    voice = utterance.speaker.rsplit("_", 1)[-1]
    return voice.rstrip("0123456789") if voice.startswith("klatt") else voice


def importance_of(utterance: LabelledUtterance) -> float:
    """Return how much a speaker counts, however much there is of that voice."""
    return next((value for kind, value in IMPORTANCE if utterance.corpus.startswith(kind)), 1.0)


def rule_features_of(folder: Path, variables: Sequence[Variable], seed: int) -> Iterator[RuleFeatures]:
    """Measure a whole corpus."""
    utterances = read_corpus(folder)
    return _measured(utterances, utterances, variables, seed, 1)


def augmented_rule_features_of(folder: Path, variables: Sequence[Variable], seed: int) -> Iterator[RuleFeatures]:
    """Measure some recordings of each speaker of a corpus, and some frames of them."""
    utterances = read_corpus(folder)
    generator = np.random.default_rng(seed)
    taken: dict[str, int] = {}
    chosen = []
    for k in generator.permutation(len(utterances)):
        speaker = utterances[k].voice
        taken[speaker] = taken.get(speaker, 0) + 1
        most = next((n for kind, n in MOST_RECORDINGS.items() if speaker.startswith(kind)), MOST)
        if taken[speaker] <= most:
            chosen.append(utterances[k])
    return _measured(chosen, utterances, variables, seed, STRIDE)


def _measured(
    chosen: Sequence[LabelledUtterance],
    everyone: Sequence[LabelledUtterance],
    variables: Sequence[Variable],
    seed: int,
    stride: int,
) -> Iterator[RuleFeatures]:
    generator = np.random.default_rng(seed)
    preset = Preset(settings=FRONT_END, variables=tuple(variables))
    adders = [NoiseAdder(AddedNoise(kind, 0.0, seed), everyone) for kind in NOISES]
    for k, utterance in enumerate(chosen):
        labels = frame_labels_of(utterance.labels)
        sounds = _sounds_of(utterance, adders[k % len(adders)], generator)
        n = len(labels.phonemes)
        yield RuleFeatures(
            utterance, labels, tuple(_features_of(sound, preset, n, stride) for sound in sounds), stride
        )


def _sounds_of(
    utterance: LabelledUtterance, adder: NoiseAdder, generator: np.random.Generator
) -> Iterator[Float32Array]:
    with utterance.opened() as reader:
        sound = reader.read_mono()
    yield sound
    floor = _gain_of(generator.uniform(*FLOORS)) * generator.standard_normal(len(sound), np.float32)
    yield _gain_of(generator.uniform(*GAINS)) * sound + floor
    loudest = np.concatenate([np.zeros(0, np.float32), *adder.blocks(utterance, BLOCK)])
    noise = _gain_of(-generator.uniform(*SNRS)) * (loudest - sound)
    yield _gain_of(generator.uniform(*GAINS)) * (sound + noise)


def _gain_of(level: float) -> np.float32:
    return np.float32(10 ** (level / 20))


def _features_of(sound: Float32Array, preset: Preset, n_frames: int, stride: int) -> Features:
    analyser = Analyser(preset)
    parts = [analyser.push(sound).features, analyser.finish().features]
    values = np.concatenate([part.values for part in parts])[:n_frames]
    silent = np.zeros((n_frames - len(values), values.shape[1]), np.float32)
    return Features(parts[0].names, np.concatenate([values, silent])[::stride])
