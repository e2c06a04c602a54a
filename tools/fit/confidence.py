"""Fits the confidence of presets to labelled speech, and writes it into them."""

import argparse
import sys
from dataclasses import replace
from pathlib import Path

from tqdm import tqdm

from phonemeengine import EngineError, load_preset, save_preset
from phonemeengine.calibration.scores.corpus import read_corpus
from phonemeengine.calibration.scores.evaluation import confidence_of, predict
from phonemeengine.recognition.scores import UNFITTED


def main() -> int:
    """Fit the confidence of presets from the command line."""
    parser = argparse.ArgumentParser(prog="python -m tools.fit.confidence", description=__doc__)
    parser.add_argument(
        "corpus", type=Path, metavar="CORPUS", help="folder with manifest.csv: speech that they were not fitted to"
    )
    parser.add_argument("presets", type=Path, nargs="+", metavar="PRESET", help="preset files, which are changed")
    parser.add_argument("--every", type=int, default=1, metavar="N", help="analyse every n-th recording (default 1)")
    args = parser.parse_args()
    try:
        utterances = read_corpus(args.corpus)[:: args.every]
        for path in args.presets:
            preset = load_preset(path)
            others = {kind: curve for kind, curve in preset.confidences.items() if kind is not preset.model_kind}
            bare = replace(preset, confidences={**others, preset.model_kind: UNFITTED})
            curve = confidence_of([predict(u, bare) for u in tqdm(utterances, desc=path.name, unit="recording")])
            save_preset(replace(preset, confidences={**others, preset.model_kind: curve}), path)
            print(f"{path}: {', '.join(f'{share:.2f}' for share in curve.shares)}")
    except EngineError as error:
        print(error, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
