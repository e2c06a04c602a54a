"""Templates from labelled recordings or takes.

Of each segment with a certain label the middle third counts, so that neither the transition from the sound before
nor that to the next one blurs the template; each speaker counts alike.
"""

from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.audio.files import SoundReader
from phonemeengine.calibration.scores.corpus import Label, LabelledUtterance
from phonemeengine.dsp.framing import Framer
from phonemeengine.dsp.mel import cepstra_of, log_mels
from phonemeengine.errors import CorpusError
from phonemeengine.execution import Progress, report_progress
from phonemeengine.labels.utterance import CORE
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.templates import UNTEMPLATED, Templates, levels_of, rounded_templates
from phonemeengine.settings import FRAME_PERIOD

BLOCK = 1 << 16
LEAST_FRAMES = 3
"""Frames that a template of a speaker is made from at the least."""


@dataclass(frozen=True)
class LogMelsByPhoneme:
    """The middles of a speaker's sounds.

    Attributes
    ----------
    cepstra : for each phoneme float32, shape (n_frames, 12).
    silences, sounds : levels of frames labelled as silence and as anything else, dB.
    """

    cepstra: Mapping[Phoneme, Float32Array]
    silences: Float32Array
    sounds: Float32Array


def templates_of(utterances: Iterable[LabelledUtterance], base: Templates | None = None) -> Templates:
    """Make templates; those of phonemes that are not spoken are taken from `base`.

    Raises
    ------
    CorpusError : there is not enough of any phoneme.
    AudioError : a sound cannot be read.
    """
    return templates_from(log_mels_by_phoneme(utterances), base)


def adapt_to_takes(
    preset: Preset, takes: Sequence[LabelledUtterance], set_silence: Callable[[Preset], Preset], progress: Progress
) -> tuple[Preset, ...]:
    """Let takes of one voice be a preset's templates: quite, half, or not at all; only the room sets the silence.

    It is an `Adapt` of `phonemeengine.calibration.calibrate`.
    """
    report_progress(progress, 0.0)
    start = set_silence(preset)
    assert start.templates is not None
    found = replace(templates_of(takes, start.templates), silence_below=start.templates.silence_below)
    return replace(start, templates=found), replace(start, templates=_between(start.templates, found)), start


def _between(old: Templates, new: Templates) -> Templates:
    rows = {p: (old.means.get(p, row), row) for p, row in new.means.items()}
    means = {p: np.array(pair, np.float32).mean(axis=0) for p, pair in rows.items()}
    return rounded_templates(means, np.array(new.spread, np.float32), new.silence_below)


def log_mels_by_phoneme(utterances: Iterable[LabelledUtterance]) -> dict[str, LogMelsByPhoneme]:
    """Listen to labelled recordings, by speaker."""
    parts: defaultdict[str, defaultdict[Phoneme, list[Float32Array]]] = defaultdict(lambda: defaultdict(list))
    levels: defaultdict[tuple[str, bool], list[Float32Array]] = defaultdict(list)
    for utterance in utterances:
        speaker = utterance.voice
        log_mels = _log_mels_of(utterance.path)
        cepstra, loudness = cepstra_of(log_mels), levels_of(log_mels)
        for label, frames in _middles(utterance.labels):
            parts[speaker][label.phoneme].append(cepstra[frames])
            levels[speaker, label.phoneme is Phoneme.SILENCE].append(loudness[frames])
    nothing = [np.zeros(0, np.float32)]
    return {
        speaker: LogMelsByPhoneme(
            {p: np.concatenate(found) for p, found in sorted(theirs.items()) if p not in UNTEMPLATED},
            np.concatenate(levels.get((speaker, True), nothing)),
            np.concatenate(levels.get((speaker, False), nothing)),
        )
        for speaker, theirs in parts.items()
    }


def templates_from(voices: Mapping[str, LogMelsByPhoneme], base: Templates | None = None) -> Templates:
    """Make templates from the spectra of each speaker, all of whom count alike."""
    means: dict[Phoneme, Float32Array] = {}
    spreads = []
    for phoneme in (p for p in Phoneme if p not in UNTEMPLATED):
        theirs = [v.cepstra[phoneme] for v in voices.values() if len(v.cepstra.get(phoneme, ())) >= LEAST_FRAMES]
        if theirs:
            means[phoneme] = np.mean([frames.mean(axis=0) for frames in theirs], axis=0)
            spreads.append(np.mean([((frames - means[phoneme]) ** 2).mean(axis=0) for frames in theirs], axis=0))
        elif base is not None and phoneme in base.means:
            means[phoneme] = np.array(base.means[phoneme], np.float32)
    if not spreads:
        raise CorpusError("no phoneme has enough speech for a template; record takes of 1 s each")
    spread = np.sqrt(np.mean(spreads, axis=0)) if base is None else np.array(base.spread)
    return rounded_templates(means, spread, _silence_below(voices, -50.0 if base is None else base.silence_below))


def _log_mels_of(path: Path) -> Float32Array:
    framer = Framer()
    with SoundReader(path) as reader:
        parts = [log_mels(framer.cut_frames(block)) for block in reader.blocks(BLOCK)]
    return np.concatenate([*parts, log_mels(framer.finish())])


def _middles(labels: Iterable[Label]) -> Iterator[tuple[Label, slice]]:
    """Return each certain label with the frames in its middle third, at least one."""
    for label in labels:
        if label.certainty == CORE and label.phoneme is not Phoneme.UNIDENTIFIED:
            third = (label.end - label.start) / 3
            first = round((label.start + third) / FRAME_PERIOD)
            yield label, slice(first, max(first + 1, round((label.end - third) / FRAME_PERIOD)))


def _silence_below(voices: Mapping[str, LogMelsByPhoneme], otherwise: float) -> float:
    """Find the level that tells silence from sound best, the mean of both shares over all speakers."""
    both = [v for v in voices.values() if len(v.silences) and len(v.sounds)]
    if not both:
        return otherwise
    levels = np.arange(-90.0, -10.0, 0.5)
    right = [np.mean(v.silences < level) + np.mean(v.sounds >= level) for v in both for level in levels]
    return float(levels[np.array(right).reshape(len(both), -1).mean(axis=0).argmax()])
