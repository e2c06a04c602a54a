"""The ear and the mouth of PhonemeAnalyser: sound in, phonemes, intensities and mouth shapes out, every 10 ms.

A game plays a file, or listens to a microphone, and asks whenever it likes; no call waits for sound::

    from engine import Listener, Sound, load_preset

    preset = load_preset(path)
    sound = Sound(speech, preset)           # or Listener(preset) for a microphone
    sound.play()
    phoneme, intensity = sound.poll()       # every 10 or 20 ms

A program with samples of its own pushes them::

    analyser = Analyser(preset)
    analysis = analyser.push(samples)       # float32, mono, 44.1 kHz
    analysis.phonemes, analysis.intensities  # one for each 10 ms that are complete

A face follows what was heard, and may be looked at whenever a picture is drawn::

    morpher = Morpher(load_table("arkit"), seed=character)
    morpher.hear(now, phoneme, intensity)   # seconds, of a clock of yours
    weights = morpher.weights(now)          # 0..1, one for each of morpher.movestates
"""

from engine.analyser import Analyser, Analysis, analyses_of
from engine.audio.devices import Device, InputChoice
from engine.audio.files import SoundReader
from engine.audio.recording import Recording
from engine.audio.stream import devices
from engine.dsp.filters import denoise, high_pass_gains, low_pass_gains, normalise
from engine.errors import (
    AudioError,
    CurveError,
    DeviceError,
    EngineError,
    MouthError,
    PresetError,
    RecogniserError,
    RecordingError,
    SettingsError,
)
from engine.live.heard import Heard
from engine.live.listener import Listener
from engine.live.sound import Sound
from engine.live.tape import Tape
from engine.mouth.blinks import Blinker
from engine.mouth.head_motion import HeadMotion
from engine.mouth.morpher import Detail, Morpher
from engine.mouth.table import MouthTable, load_table
from engine.phonemes import MOUTH_SHAPES, MouthShape, Phoneme
from engine.presets.files import load_preset, save_preset
from engine.presets.preset import Preset
from engine.settings import BIN_WIDTH, Channel

__all__ = [
    "BIN_WIDTH",
    "MOUTH_SHAPES",
    "Analyser",
    "Analysis",
    "AudioError",
    "Blinker",
    "Channel",
    "CurveError",
    "Detail",
    "Device",
    "DeviceError",
    "EngineError",
    "HeadMotion",
    "Heard",
    "InputChoice",
    "Listener",
    "Morpher",
    "MouthError",
    "MouthShape",
    "MouthTable",
    "Phoneme",
    "Preset",
    "PresetError",
    "RecogniserError",
    "Recording",
    "RecordingError",
    "SettingsError",
    "Sound",
    "SoundReader",
    "Tape",
    "analyses_of",
    "denoise",
    "devices",
    "high_pass_gains",
    "load_preset",
    "load_table",
    "low_pass_gains",
    "normalise",
    "save_preset",
]
