"""Lists the devices while it listens, as often as it reads a line; says also how much it has heard."""

import json
import sys

from phonemeengine.audio.input import CardInput
from phonemeengine.audio.stream import InputChoice, devices

microphone = CardInput(InputChoice())
n_heard = 0
for _ in sys.stdin:
    names = [device.name for device in devices()]
    n_heard += len(microphone.read(60))
    print(json.dumps({"names": names, "heard": n_heard, "lost": microphone.lost}), flush=True)
microphone.close()
