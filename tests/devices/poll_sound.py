"""Plays a sound as a game does, asking every 10 ms; prints how long each answer took, and what it was."""

import json
import sys
import time
from pathlib import Path

from phonemeengine.live.sound import Sound
from phonemeengine.presets.files import DEFAULT_PRESET, load_preset
from tests.waiting import let_pass

SECONDS = 4.0

waits: list[float] = []
phonemes: list[int] = []
with Sound(Path(sys.argv[1]), load_preset(DEFAULT_PRESET)) as sound:
    sound.play(loop=True)
    while sound.position < SECONDS:
        let_pass(0.01)
        asked = time.perf_counter()
        heard = sound.poll()
        waits.append(time.perf_counter() - asked)
        phonemes.append(int(heard.phoneme))
    print(json.dumps({"waits": waits, "phonemes": phonemes, "position": sound.position}), flush=True)
