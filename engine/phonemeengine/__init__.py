"""The ear and the mouth of PhonemeAnalyser: sound in, phonemes, intensities and mouth shapes out, every 10 ms.

A game plays a file, or listens to a microphone, and asks whenever it likes; no call waits for sound::

    from phonemeengine import Listener, Sound, load_preset

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

Movestates (morph targets) move the vertices of a mesh::

    figure = load_morph_mesh(path)             # or load_head()
    face = MovestateSet(figure.mesh, figure.states)
    face.set_percentage("smile", 60, Mode.INTERACT)
    positions = face.morphed()              # of all vertices
"""

from phonemeengine.analyser import Analyser, Analysis, Reading, analyse_blocks
from phonemeengine.audio.devices import Device, InputChoice
from phonemeengine.audio.files import SoundReader
from phonemeengine.audio.recording import Recording
from phonemeengine.audio.stream import devices
from phonemeengine.dsp.filters import denoise, high_pass_gains, low_pass_gains, normalise
from phonemeengine.errors import (
    AudioError,
    CurveError,
    DeviceError,
    EngineError,
    MeshError,
    MouthError,
    PresetError,
    RecogniserError,
    RecordingError,
    SettingsError,
)
from phonemeengine.live.listener import Listener
from phonemeengine.live.recorder import Recorder
from phonemeengine.live.sound import Sound
from phonemeengine.mouth.blinks import Blinker
from phonemeengine.mouth.files.io import load_morph_mesh, load_morph_targets, save_morph_targets
from phonemeengine.mouth.head import load_head
from phonemeengine.mouth.head_motion import HeadMotion
from phonemeengine.mouth.mesh import Mesh, mesh_of
from phonemeengine.mouth.morph_mesh import MorphMesh, MorphTargets, matched, morph_targets_of
from phonemeengine.mouth.morpher import Detail, Morpher
from phonemeengine.mouth.motion_settings import MotionSettings, TransitionTimes
from phonemeengine.mouth.movestate import Movestate, movestate_at, movestate_of
from phonemeengine.mouth.movestate_set import MovestateSet
from phonemeengine.mouth.percentages import Mode
from phonemeengine.mouth.table import MouthTable, load_table
from phonemeengine.phonemes import MOUTH_SHAPES, MouthShape, Phoneme
from phonemeengine.presets.files import load_preset, save_preset
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import BIN_WIDTH, Channel

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
    "InputChoice",
    "Listener",
    "Mesh",
    "MeshError",
    "Mode",
    "MorphMesh",
    "MorphTargets",
    "Morpher",
    "MotionSettings",
    "MouthError",
    "MouthShape",
    "MouthTable",
    "Movestate",
    "MovestateSet",
    "Phoneme",
    "Preset",
    "PresetError",
    "Reading",
    "RecogniserError",
    "Recorder",
    "Recording",
    "RecordingError",
    "SettingsError",
    "Sound",
    "SoundReader",
    "TransitionTimes",
    "analyse_blocks",
    "denoise",
    "devices",
    "high_pass_gains",
    "load_head",
    "load_morph_mesh",
    "load_morph_targets",
    "load_preset",
    "load_table",
    "low_pass_gains",
    "matched",
    "mesh_of",
    "morph_targets_of",
    "movestate_at",
    "movestate_of",
    "normalise",
    "save_morph_targets",
    "save_preset",
]
