"""The ear of PhonemeAnalyser: samples in, phonemes and intensities out, every 10 ms.

A program needs little of it::

    from engine import Analyser, load_preset

    analyser = Analyser(load_preset(path))
    analysis = analyser.push(samples)       # float32, mono, 44.1 kHz
    analysis.phonemes, analysis.intensities  # one for each 10 ms that are complete
"""

from engine.analyser import Analyser, Analysis, analyses_of
from engine.audio.files import SoundReader
from engine.errors import AudioError, CurveError, DeviceError, EngineError, PresetError, SettingsError
from engine.phonemes import MOUTH_SHAPES, MouthShape, Phoneme
from engine.presets.preset import Preset, load_preset, save_preset

__all__ = [
    "MOUTH_SHAPES",
    "Analyser",
    "Analysis",
    "AudioError",
    "CurveError",
    "DeviceError",
    "EngineError",
    "MouthShape",
    "Phoneme",
    "Preset",
    "PresetError",
    "SettingsError",
    "SoundReader",
    "analyses_of",
    "load_preset",
    "save_preset",
]
