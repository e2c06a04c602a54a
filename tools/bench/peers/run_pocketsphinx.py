"""Recognises sounds with PocketSphinx, as its own environment runs it; see `tools.bench.peers.peer`."""

import json
import sys
import time
from pathlib import Path

from pocketsphinx import Decoder, get_model_path

SETTINGS = {"allphone": get_model_path("en-us/en-us-phone.lm.bin"), "lw": 2.0, "beam": 1e-20, "pbeam": 1e-20}


def main() -> None:
    """Print the phones of each sound as a line of JSON."""
    sounds = json.loads(Path(sys.argv[1]).read_text(encoding="utf-8"))
    decoder = Decoder(samprate=16_000, loglevel="FATAL", **SETTINGS)
    for sound in sounds:
        samples = Path(sound["path"]).read_bytes()
        began = time.process_time()
        decoder.start_utt()
        decoder.process_raw(samples, full_utt=True)
        decoder.end_utt()
        seconds = time.process_time() - began
        marks = [(s.start_frame / 100, (s.end_frame + 1) / 100, s.word) for s in decoder.seg() or ()]
        print(json.dumps({"seconds": seconds, "marks": marks}), flush=True)


main()
