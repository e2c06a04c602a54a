"""Recognises sounds with hama, as its own environment runs it; see `tools.bench.peers.peer`."""

import json
import sys
import time
from pathlib import Path

import numpy as np
from hama.asr import ASRModel


def main() -> None:
    """Print the phones of each sound as a line of JSON: each lasts until the next one begins."""
    sounds = json.loads(Path(sys.argv[1]).read_text(encoding="utf-8"))
    model = ASRModel()
    for sound in sounds:
        samples = np.fromfile(sound["path"], "<i2")
        began = time.process_time()
        result = model(samples, 16_000)
        seconds = time.process_time() - began
        spans = [(span.start_ms / 1000, span.phoneme) for span in model.phoneme_spans(result)]
        ends = [*(start for start, _ in spans[1:]), len(samples) / 16_000][: len(spans)]
        marks = [(start, end, name) for (start, name), end in zip(spans, ends, strict=True)]
        print(json.dumps({"seconds": seconds, "marks": marks}), flush=True)


main()
