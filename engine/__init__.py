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

Movestates (morph targets) move the vertices of a mesh::

    figure = load_figure(path)              # or load_head()
    face = MovestateSet(figure.mesh, figure.states)
    face.set_percentage("smile", 60, Mode.INTERACT)
    positions = face.morphed()              # of all vertices
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
    MeshError,
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
from engine.mouth.face import Face, Figure, face_of, fitted
from engine.mouth.files.opening import load_face, load_figure, save_face
from engine.mouth.head import load_head
from engine.mouth.head_motion import HeadMotion
from engine.mouth.manner import Manner, Times
from engine.mouth.mesh import Mesh, mesh_of
from engine.mouth.morpher import Detail, Morpher
from engine.mouth.movestate import Movestate, movestate_at, movestate_of
from engine.mouth.movestate_set import MovestateSet
from engine.mouth.percentages import Mode
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
    "Face",
    "Figure",
    "HeadMotion",
    "Heard",
    "InputChoice",
    "Listener",
    "Manner",
    "Mesh",
    "MeshError",
    "Mode",
    "Morpher",
    "MouthError",
    "MouthShape",
    "MouthTable",
    "Movestate",
    "MovestateSet",
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
    "Times",
    "analyses_of",
    "denoise",
    "devices",
    "face_of",
    "fitted",
    "high_pass_gains",
    "load_face",
    "load_figure",
    "load_head",
    "load_preset",
    "load_table",
    "low_pass_gains",
    "mesh_of",
    "movestate_at",
    "movestate_of",
    "normalise",
    "save_face",
    "save_preset",
]
