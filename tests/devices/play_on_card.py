"""Plays a sound file on the default sound card and prints what was seen."""

import json
import sys
import time
from pathlib import Path

from phonemeengine.audio.files import SoundReader
from phonemeengine.live.player import Player
from phonemeengine.presets.files import DEFAULT_PRESET, load_preset
from tests.waiting import let_pass

player = Player(SoundReader(Path(sys.argv[1])), load_preset(DEFAULT_PRESET))
seen: list[tuple[float, float]] = []
frames: list[int] = []
cards: list[tuple[float, bool]] = []
early = 0
late: list[float] = []
player.play()
print("playing", flush=True)
started = time.monotonic()
while not player.finished and time.monotonic() - started < 120:
    position = player.position
    seen.append((time.monotonic(), position))
    if not cards or cards[-1][1] != player.has_card:
        cards.append((time.monotonic(), player.has_card))
        print("with a card" if player.has_card else "without a card", flush=True)
    for block in player.take_analyses():
        last = block.start + len(block) - 1
        frames += range(block.start, last + 1)
        late.append(player.position - (last + 0.5) * 0.01)
        early += (last + 0.5) * 0.01 > player.position + 0.001
    let_pass(0.005)
print(
    json.dumps(
        {
            "card": player.has_card,
            "name": player.output_name,
            "seen": seen,
            "frames": frames,
            "early": early,
            "late": late,
            "dropped": player.n_dropped,
            "finished": player.finished,
            "cards": cards,
        }
    )
)
player.close()
