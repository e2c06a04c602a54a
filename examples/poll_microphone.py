"""Poll the microphone: what is said now, twenty times a second.

python examples/poll_microphone.py [SECONDS]
"""

import sys
import time

from phonemeengine import EngineError, Listener, devices, load_preset


def main(seconds: float = 10.0) -> None:
    """Print a line for each look at the microphone; none of them waits for sound."""
    devices()  # tells at once where there is no sound system; a microphone that is missing is waited for
    with Listener(load_preset("learned")) as voice:
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            time.sleep(0.05)
            phoneme, intensity, confidence = voice.poll()
            print(f"{phoneme.label:<12} {confidence:4.0%} {'#' * round(40 * intensity)}", flush=True)
        print(f"{voice.status.words}; {voice.lost_seconds:.2f} s were lost")


if __name__ == "__main__":
    try:
        main(*map(float, sys.argv[1:]))
    except EngineError as error:
        sys.exit(str(error))
