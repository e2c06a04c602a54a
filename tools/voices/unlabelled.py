"""People's recordings whose words no aligner trusted, without labels: a teacher knows what is said there.

``python -m tools.voices.unlabelled OUT_DIR --builder DIR --cache DIR --labelled CORPUS`` reads which recordings the
corpus builder in DIR knows of each speaker, and writes those that CORPUS, which it made, lacks.
"""

import argparse
import csv
import sys
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path
from typing import Any

import av
import numpy as np

from tools.voices.recordings import PEOPLE, is_speech
from tools.voices.writing import Speaker, Utterance, UtteranceWriter, replace_speaker


def main() -> None:
    """Write the recordings, and say how much there is of each speaker."""
    parser = argparse.ArgumentParser(prog="python -m tools.voices.unlabelled", description=__doc__)
    parser.add_argument("out", type=Path, metavar="OUT_DIR", help="folder for the corpus")
    parser.add_argument("--builder", type=Path, required=True, help="folder of the corpus builder's scripts")
    parser.add_argument("--cache", type=Path, required=True, help="its cache of packages")
    parser.add_argument("--labelled", type=Path, required=True, help="the corpus that it made")
    arguments = parser.parse_args()
    known = _stems_in(arguments.labelled)
    for speaker in _speakers_of(arguments.builder, arguments.cache):
        place = f"{speaker.corpus}/{speaker.name}"
        about = Speaker(
            speaker.corpus, speaker.name, speaker.language, speaker.sex, PEOPLE, speaker.licence, speaker.package, ""
        )
        writer = UtteranceWriter(arguments.out, about, {})
        for item in speaker.items:
            if f"{place}/{speaker.name}_{item.name}" not in known and f"{place}/{item.name}" not in known:
                sound, rate = _read(Path(item.path))
                if is_speech(sound, rate):
                    writer.write(Utterance(sound, rate, [], item.text))
        replace_speaker(arguments.out, about, writer.rows)
        print(f"{place}: {len(writer.rows)} recordings, {writer.seconds / 60:.1f} min", flush=True)


def _stems_in(corpus: Path) -> set[str]:
    """Return the names of a corpus's recordings: corpus/speaker/file, without the file's ending."""
    with (corpus / "manifest.csv").open(newline="", encoding="utf-8") as file:
        return {Path(row["wav"]).with_suffix("").as_posix() for row in csv.DictReader(file)}


def _speakers_of(builder: Path, cache: Path) -> Iterator[Any]:
    """Return what the corpus builder knows of people: tuples with the name and the items of each."""
    sys.path.insert(0, str(builder))
    import_module("packages").use_cache(str(cache))
    yield from import_module("human_recordings").speakers()


def _read(path: Path) -> tuple[np.ndarray, int]:
    """Return the samples of a recording, mono, -1..1, and their rate in hertz."""
    with av.open(str(path), format="g722" if path.suffix == ".g722" else None) as container:
        resampler = av.AudioResampler("flt", "mono")
        frames = [f for frame in container.decode(audio=0) for f in resampler.resample(frame)]
    if not frames:
        return np.zeros(0), 1
    return np.concatenate([frame.to_ndarray()[0] for frame in frames]).astype(float), frames[0].sample_rate


if __name__ == "__main__":
    main()
