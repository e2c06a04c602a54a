"""Fits the factory templates: ``python -m tools.fit.templates CORPUS -o presets/``."""

import argparse
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np

from phonemeengine.analyser import analyse_file
from phonemeengine.arrays import UInt8Array
from phonemeengine.audio.files import SoundReader
from phonemeengine.calibration.fits.templates import LogMelsByPhoneme, log_mels_by_phoneme, templates_from
from phonemeengine.calibration.scores.corpus import LabelledUtterance, frame_labels_of, read_corpus
from phonemeengine.calibration.scores.scoring import Scores, scores_of
from phonemeengine.errors import EngineError
from phonemeengine.presets.files import save_preset
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.spec import TEMPLATES
from phonemeengine.recognition.templates import Templates
from phonemeengine.settings import AnalysisSettings

STEM, NAME = "templates", "Templates"
MINIMUM_HOLD, HYSTERESIS = 0.0, 0.25


def preset_of(templates: Templates, notes: str = "") -> Preset:
    """Return a preset that recognises by templates."""
    settings = AnalysisSettings(minimum_hold=MINIMUM_HOLD, hysteresis=HYSTERESIS)
    return Preset(NAME, settings, recogniser=TEMPLATES.name, templates=templates, notes=notes)


def unseen_scores(utterances: Sequence[LabelledUtterance], voices: Mapping[str, LogMelsByPhoneme]) -> Scores:
    """Score the recordings of each speaker with templates of all others."""
    others = {s: templates_from({who: v for who, v in voices.items() if who != s} or voices) for s in voices}
    presets = {speaker: preset_of(templates) for speaker, templates in others.items()}
    return scores_of((frame_labels_of(u.labels), _recognised(u.path, presets[u.voice])) for u in utterances)


def _recognised(path: Path, preset: Preset) -> UInt8Array:
    with SoundReader(path) as reader:
        return np.concatenate([a.phonemes for a in analyse_file(reader, preset)])


NOTES = """\
The nearest of nine mean spectra, as in uLipSync: mouth shapes {mouth:.0f} % on left-out speakers.
Mean cepstra of {n} speakers, human and synthetic, each counting alike, made by
fit_templates from the middle thirds of all sounds with a certain label.
Silence is told by its level alone.
Each speaker left out in turn: macro F1 {s.macro_f1:.3f}, vowels {s.vowel_accuracy:.3f},
mouth accuracy {s.viseme_accuracy:.3f},
silence found {s.silence_recall:.3f}, false silence {s.false_silence:.3f}, {s.changes_per_s:.1f} changes a second
(labels: {s.label_changes_per_s:.1f}).
"""


def main(argv: Sequence[str] | None = None) -> int:
    """Make the templates of a corpus from the command line."""
    parser = argparse.ArgumentParser(prog="python -m tools.fit.templates", description=__doc__)
    parser.add_argument("corpus", type=Path, metavar="CORPUS", help="folder with manifest.csv")
    parser.add_argument("-o", "--out", type=Path, required=True, help="folder for the preset")
    args = parser.parse_args(argv)
    try:
        utterances = read_corpus(args.corpus)
        args.out.mkdir(parents=True, exist_ok=True)
        voices = log_mels_by_phoneme(utterances)
        scores = unseen_scores(utterances, voices)
        notes = NOTES.format(n=len(voices), s=scores, mouth=100 * scores.viseme_accuracy)
        save_preset(preset_of(templates_from(voices), notes), args.out / f"{STEM}.toml")
    except EngineError as error:
        print(error, file=sys.stderr)
        return 1
    print(notes)
    return 0


if __name__ == "__main__":
    sys.exit(main())
