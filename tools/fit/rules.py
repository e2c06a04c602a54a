"""Fit the extended rules to labelled speech.

``python -m tools.fit.rules CORPUS -o presets/``

The rules are the leaves of a decision tree over bands of the spectrum, and over bands divided by one another; the
tree chooses which. With ``--more FOLDER`` further speech helps. The figures that the preset states come from leaving
out one speaker after the other, and out of the further speech whatever has the same voice. Candidate variables are
measured at other levels and in noise, too.
"""

import argparse
import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from phonemeengine.analyser import Analyser
from phonemeengine.arrays import BoolArray, Float32Array, Float64Array, UInt8Array
from phonemeengine.calibration.fits.fitting import cross_validate, groups_of
from phonemeengine.calibration.fits.rule_finding import FRONT_END, HYSTERESES, UNASKED, candidates, frame_weights
from phonemeengine.calibration.fits.rule_search import MOST_CONDITIONS, RuleSearch
from phonemeengine.calibration.scores.added_noise import AddedNoise, NoiseAdder, NoiseKind
from phonemeengine.calibration.scores.corpus import FrameLabels, LabelledUtterance, frame_labels_of, read_corpus
from phonemeengine.calibration.scores.scoring import Scores, scores_of
from phonemeengine.errors import EngineError
from phonemeengine.features.variables import Features, Variable
from phonemeengine.presets.files import save_preset
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.rules import Rule, RuleRecogniser, Thresholds
from phonemeengine.recognition.segments import SUCCESSORS, PhonemeSmoother
from phonemeengine.recognition.spec import OWN_RULES

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


MOST_CHANGES = 1.45
"""The least hysteresis is chosen by which the phonemes change at most this many times as often as the labels."""
STEM, NAME = "extended", "Extended rules"
MOST_RULES = 80

Rules = tuple[Rule, ...]


@dataclass(frozen=True)
class TrainingFrames:
    """Frames to grow rules from.

    Attributes
    ----------
    features, truth, weights : of each frame.
    voices : the voice of each frame, a number.
    """

    features: Features
    truth: UInt8Array
    weights: Float64Array
    voices: NDArray[np.int16]


class RuleFitter:
    """Fits the rules.

    Parameters
    ----------
    corpus : the speakers by which the rules are judged.
    further : more speech.
    variables : to choose from.
    """

    def __init__(
        self, corpus: Sequence[RuleFeatures], further: Sequence[RuleFeatures], variables: Sequence[Variable]
    ) -> None:
        self._corpus = corpus
        self._voices = list(dict.fromkeys(voice_of(m.utterance) for m in (*corpus, *further)))
        self._examples = self._examples_of([*corpus, *further])
        self._variables = variables
        self._names = [name for name in self._examples.features.names if name not in UNASKED]

    def fit(self) -> Preset:
        """Grow the rules from everyone, and measure how well rules do on speakers that they did not learn from."""
        voices = [voice_of(m.utterance) for m in self._corpus]
        unseen = cross_validate(
            voices, groups_of(voices, len(voices)), lambda chosen: self._rules_without(voices, chosen)
        )
        hysteresis = self._calm(unseen)
        rules = self._grow(np.ones(len(self._examples.truth), bool))
        used = {c.variable for rule in rules for c in rule.conditions}
        used |= {v.per for v in self._variables if v.name in used}
        variables = tuple(v for v in self._variables if v.name in used)
        settings = replace(FRONT_END, minimum_hold=0.0, hysteresis=hysteresis)
        notes = self._notes(rules, variables, unseen, hysteresis)
        return Preset(NAME, settings, variables=variables, recogniser=OWN_RULES.name, rules=rules, notes=notes)

    def _rules_without(self, voices: Sequence[str], chosen: BoolArray) -> Rules:
        left_out = [self._voices.index(voice) for voice in {v for v, c in zip(voices, chosen, strict=True) if not c}]
        return self._grow(~np.isin(self._examples.voices, left_out))

    def _grow(self, frames: BoolArray) -> Rules:
        examples = self._examples
        features = Features(examples.features.names, examples.features.values[frames])
        search = RuleSearch(features, examples.truth[frames], examples.weights[frames], self._names)
        rules = search.rules_of(search.grow(MOST_RULES))
        print(f"  {len(rules)} rules", flush=True)
        return rules

    def _examples_of(self, material: Sequence[RuleFeatures]) -> TrainingFrames:
        """Put the copies of all recordings one after the other; each speaker counts by its importance."""
        spoken: dict[tuple[str, str], int] = {}
        for m in material:
            speaker = m.utterance.corpus, m.utterance.speaker
            spoken[speaker] = spoken.get(speaker, 0) + len(m.truth)
        values, truth, weights, voices = [], [], [], []
        for m in material:
            each = importance_of(m.utterance) / spoken[m.utterance.corpus, m.utterance.speaker]
            for copy, counts in zip(m.copies, COPIES, strict=True):
                values.append(copy.values)
                truth.append(m.truth)
                weights.append(m.certainty * each * counts)
                voices.append(np.full(len(m.truth), self._voices.index(voice_of(m.utterance)), np.int16))
        features = Features(material[0].copies[0].names, np.concatenate(values))
        return TrainingFrames(features, np.concatenate(truth), np.concatenate(weights), np.concatenate(voices))

    def _calm(self, unseen: Sequence[Rules]) -> float:
        for hysteresis in HYSTERESES:
            scores = self._scores(unseen, 0, hysteresis)
            if scores.changes_per_s <= MOST_CHANGES * scores.label_changes_per_s:
                return hysteresis
        return HYSTERESES[-1]

    def _scores(self, rules: Sequence[Rules], copy: int, hysteresis: float, kind: str = "") -> Scores:
        """Score one copy of the recordings whose corpus has this kind of name."""
        measured = [(m, r) for m, r in zip(self._corpus, rules, strict=True) if m.utterance.corpus.startswith(kind)]
        return scores_of((m.labels, _recognised(m.copies[copy], r, hysteresis)) for m, r in measured)

    def _notes(self, rules: Rules, variables: Sequence[Variable], unseen: Sequence[Rules], hysteresis: float) -> str:
        kinds = dict.fromkeys(m.utterance.corpus.split("_")[0] for m in self._corpus)
        everyone = [rules] * len(self._corpus)
        scores = self._scores(unseen, 0, hysteresis)
        return NOTES.format(
            n_rules=len(rules),
            n_variables=len(variables),
            conditions=MOST_CONDITIONS,
            n_voices=len(self._voices),
            n_speakers=len({m.utterance.speaker for m in self._corpus}),
            changes=MOST_CHANGES,
            low=SNRS[0],
            high=SNRS[1],
            mouth=100 * scores.viseme_accuracy,
            unseen=_in_words(scores),
            kinds="; ".join(f"{kind} {self._scores(unseen, 0, hysteresis, kind).macro_f1:.3f}" for kind in kinds),
            faint=_in_words(self._scores(unseen, 1, hysteresis)),
            noisy=_in_words(self._scores(unseen, 2, hysteresis)),
            seen=_in_words(self._scores(everyone, 0, hysteresis)),
        )


NOTES = """\
Rules over frequency bands whose limits can all be dragged: mouth shapes {mouth:.0f} % on left-out speakers.
{n_rules} rules over {n_variables} variables, fitted by fit_rules to {n_voices} voices, human
and synthetic. The first rule whose comparisons all hold names the phoneme; no rule has more than {conditions}
comparisons.
A variable that begins with b is the sum over a band of the mel scale, its bounds in hertz; one that begins with r
(two bands of 24) or w (four) is a band divided by another, each given by its lower bound.
The rules are the leaves of a decision tree; the phonemes of all leaves were chosen together for the best macro F1.
Each recording counts three times: as it is; with another level and a noise floor of -75..-60 dB; and, half as much,
in white, pink or babble noise. The hysteresis is the least by which the phonemes change at most {changes:g} times as
often as the labels.
Each of {n_speakers} speakers left out of the fit in turn, and the same voice in other speech too: {unseen}.
Macro F1 by kind of voice: {kinds}.
With another level and a noise floor: {faint}.
In noise, {low:g}..{high:g} dB: {noisy}.
On the speakers that the preset was fitted to: {seen}.
"""


def _in_words(scores: Scores) -> str:
    return (
        f"macro F1 {scores.macro_f1:.3f}, accuracy {scores.accuracy:.3f}, vowels {scores.vowel_accuracy:.3f}, "
        f"mouth accuracy {scores.viseme_accuracy:.3f}, silence found {scores.silence_recall:.3f}, "
        f"false silence {scores.false_silence:.3f}, {scores.changes_per_s:.1f} changes a second "
        f"(labels: {scores.label_changes_per_s:.1f})"
    )


def _recognised(features: Features, rules: Rules, hysteresis: float) -> UInt8Array:
    recogniser = RuleRecogniser(rules, Thresholds())
    codes = recogniser.phonemes_of(features)
    return PhonemeSmoother(0.0, SUCCESSORS, hysteresis).smooth(codes, recogniser.deficits(features))


def main(argv: Sequence[str] | None = None) -> int:
    """Run the fit from the command line."""
    parser = argparse.ArgumentParser(prog="python -m tools.fit.rules", description=__doc__)
    parser.add_argument("corpus", type=Path, metavar="CORPUS", help="folder with manifest.csv")
    parser.add_argument("-o", "--out", type=Path, required=True, help="folder for the preset")
    parser.add_argument("--more", type=Path, metavar="FOLDER", help="further speech in the same format")
    parser.add_argument("--seed", type=int, default=1, help="of every random choice (default 1)")
    args = parser.parse_args(argv)
    try:
        variables = candidates()
        corpus = tuple(rule_features_of(args.corpus, variables, args.seed))
        further = tuple(augmented_rule_features_of(args.more, variables, args.seed)) if args.more else ()
        args.out.mkdir(parents=True, exist_ok=True)
        preset = RuleFitter(corpus, further, variables).fit()
        save_preset(preset, args.out / f"{STEM}.toml")
    except EngineError as error:
        print(error, file=sys.stderr)
        return 1
    print(preset.notes)
    return 0


if __name__ == "__main__":
    sys.exit(main())
