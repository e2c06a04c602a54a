"""The ear of PhonemeAnalyser: sound in, phonemes and intensities out, every 10 ms.

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
    PresetError,
    RecogniserError,
    RecordingError,
    SettingsError,
)
from engine.live.heard import Heard
from engine.live.listener import Listener
from engine.live.sound import Sound
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
    "Channel",
    "CurveError",
    "Device",
    "DeviceError",
    "EngineError",
    "Heard",
    "InputChoice",
    "Listener",
    "MouthShape",
    "Phoneme",
    "Preset",
    "PresetError",
    "RecogniserError",
    "Recording",
    "RecordingError",
    "SettingsError",
    "Sound",
    "SoundReader",
    "analyses_of",
    "denoise",
    "devices",
    "high_pass_gains",
    "load_preset",
    "low_pass_gains",
    "normalise",
    "save_preset",
]
