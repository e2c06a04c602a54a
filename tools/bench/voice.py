"""How soon a text plays in a running program, and the memory that a text of one megabyte without a mark takes."""

import json
import shutil
import statistics
import time

from phonemeengine.live.player import Player
from phonemeengine.presets.files import DEFAULT_PRESET, load_preset
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import SAMPLE_RATE
from phonemeengine.speech.spooled import SpooledSpeech
from phonemeengine.speech.voice import Voice
from tests.fakes.virtual_sound import VirtualSound
from tools.bench.figures import Absolute, Figure, answer_of
from tools.bench.memory import resident_megabytes

VOICE = Voice("en-us")
TEXT = "Good evening, ladies and gentlemen, and welcome to the show. Here is what we have prepared for you."
LONG = "one word after the other without any mark at all " * 20_500
"""A megabyte."""
N_TIMES = 10
LIMIT = 0.3
"""Seconds from a text to its first sound."""
SOONER, LATER = 60, 20 * 60
"""Seconds of speech after which memory is measured."""
MOST_MB = 8
"""Growth between the two that is still none."""


def figures() -> list[Figure]:
    """Measure in a process of its own, on a virtual sound card."""
    if shutil.which("pulseaudio") is None:
        print("  left out: it needs a sound server of its own, PulseAudio")
        return []
    with VirtualSound() as card:
        answer = answer_of("voice", card.environment)
    median, growth = statistics.median(answer["seconds"]), answer["growth"]
    return [
        Figure(
            f"text to first sound, median of {N_TIMES}",
            f"{1000 * median:.0f} ms",
            f"{1000 * LIMIT:g} ms",
            median / LIMIT,
            limit=1.0,
            absolute=Absolute.TIME,
        ),
        Figure(
            f"1 MB of text, memory from {SOONER / 60:g} to {LATER / 60:g} min of it",
            f"{growth:.1f} MB",
            f"{MOST_MB} MB",
            growth / MOST_MB,
            limit=1.0,
        ),
    ]


def main() -> None:
    """Measure, and print both as JSON; the first text is not counted, since the program is not running yet."""
    preset = load_preset(DEFAULT_PRESET)
    seconds = [_first_sound(preset) for _ in range(N_TIMES + 1)][1:]
    print(json.dumps({"seconds": seconds, "growth": _growth()}))


def _first_sound(preset: Preset) -> float:
    """Return how long it took from a text until its first sample played."""
    began = time.monotonic()
    player = Player(SpooledSpeech(VOICE.speak(TEXT)), preset)
    player.play()
    while player.position == 0:
        time.sleep(0.001)
    took = time.monotonic() - began
    player.close()
    return took


def _growth() -> float:
    """Return by how many MB the process grows while a long text is spoken and read."""
    with SpooledSpeech(VOICE.speak(LONG)) as speech:
        seen = []
        for end in (SOONER, LATER):
            while speech.position < end * SAMPLE_RATE:
                speech.read(SAMPLE_RATE)
            seen.append(resident_megabytes())
    return seen[1] - seen[0]


if __name__ == "__main__":
    main()
