"""Measures a loopback on the default devices and prints it: run by test_loopback.py."""

import json
from dataclasses import asdict

from phonemeengine.audio.stream import InputChoice
from phonemeengine.errors import EngineError
from phonemeengine.live.loopback import measure_loopback

try:
    print(json.dumps(asdict(measure_loopback(InputChoice()))))
except EngineError as error:
    print(json.dumps(str(error)))
