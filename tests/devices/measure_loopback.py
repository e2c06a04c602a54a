"""Measures a loopback on the default devices and prints it: run by test_loopback.py."""

import json
from dataclasses import asdict

from engine.audio.devices import InputChoice
from engine.errors import EngineError
from engine.live.loopback import measure_loopback

try:
    print(json.dumps(asdict(measure_loopback(InputChoice()))))
except EngineError as error:
    print(json.dumps(str(error)))
