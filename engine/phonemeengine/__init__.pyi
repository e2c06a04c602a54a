"""The types of the page in ``__init__.py``, for type checkers and editors."""

from phonemeengine.alignment.align import align
from phonemeengine.alignment.growing import GrownWords
from phonemeengine.analyser import Analyser, Analysis, Reading, analyse_blocks, push_together, recognise_window
from phonemeengine.audio.devices import Device, InputChoice
from phonemeengine.audio.files import SUFFIXES as SOUND_SUFFIXES
from phonemeengine.audio.files import SoundReader, sounds_under
from phonemeengine.audio.incoming import Encoding, StreamFormat
from phonemeengine.audio.level import Level
from phonemeengine.audio.mixing import Mix
from phonemeengine.audio.stream import devices
from phonemeengine.averaged_spectrum import AveragedSpectrum
from phonemeengine.batch.conversion_work import convert_all
from phonemeengine.calibration.alignment import aligned, read_sentence
from phonemeengine.calibration.calibrate import CalibrationResult, calibrate
from phonemeengine.calibration.scores.added_noise import AddedNoise, NoiseAdder, NoiseKind
from phonemeengine.calibration.scores.corpus import FrameLabels, LabelledUtterance, read_recordings
from phonemeengine.calibration.scores.evaluation import CorpusScores, GroupScores, Predictions, score
from phonemeengine.calibration.scores.scoring import Scores
from phonemeengine.calibration.sentences import SENTENCES, Sentence, sentences_in
from phonemeengine.calibration.takes.room_noise import ConfidenceInterval, SilenceAccuracy
from phonemeengine.conversion import CONVERSIONS, Conversion, convert
from phonemeengine.dsp.filters import denoise, high_pass_gains, low_pass_gains, normalise
from phonemeengine.encoder.head import EncoderHead
from phonemeengine.encoder.model_folder import (
    ModelFolder,
    choose_whisper,
    fetch_whisper,
    find_whisper,
    whisper_in_words,
)
from phonemeengine.encoder.whisper import WHISPER_LICENCE
from phonemeengine.errors import (
    AudioError,
    BatchError,
    CorpusError,
    CurveError,
    DeviceError,
    EngineError,
    ExportError,
    MeshError,
    ModelError,
    MouthError,
    PerformanceError,
    PresetError,
    RecogniserError,
    RecordingError,
    SettingsError,
    TakeError,
    TextError,
    UnknownPhonemeError,
    VoiceError,
)
from phonemeengine.features.front_end import FrameBlock
from phonemeengine.features.measure import Features
from phonemeengine.features.variables import Kind, Spectrum, Variable
from phonemeengine.labels.label import Label
from phonemeengine.labels.phone_sets import PhoneClass
from phonemeengine.labels.phoneme_map import PhonemeMap, load_phoneme_map
from phonemeengine.labels.utterance import Phone, Syllable, Utterance, Word
from phonemeengine.labels.utterance_files import format_utterance, read_utterance
from phonemeengine.live.incoming_speech import HeardPiece, IncomingSpeech
from phonemeengine.live.listener import Listener
from phonemeengine.live.microphone_analyser import Latency
from phonemeengine.live.recorder import Recorder
from phonemeengine.live.sound import Sound
from phonemeengine.live.status import Status
from phonemeengine.measurement import Statistics, StretchMeasurement, average_spectrum, measure, save_stretch
from phonemeengine.mouth.animation import Animation, animation_of
from phonemeengine.mouth.blinks import Blinker
from phonemeengine.mouth.cues import Cue, cues_of
from phonemeengine.mouth.curves_file import ExportedCurves, read_curves
from phonemeengine.mouth.exports.exporter import ExportOptions
from phonemeengine.mouth.exports.formats import FORMATS
from phonemeengine.mouth.expression.channels import ExpressionChannels, load_channels
from phonemeengine.mouth.expression.composer import Expression
from phonemeengine.mouth.expression.inhibition import InhibitionTimes
from phonemeengine.mouth.expression.streams import (
    ExpressionStream,
    expression_presets,
    held_expression,
    recorded_expression,
)
from phonemeengine.mouth.face_driver import FaceDriver, usual_driver
from phonemeengine.mouth.files.io import load_morph_mesh, load_morph_targets, save_morph_targets
from phonemeengine.mouth.head import load_head
from phonemeengine.mouth.head_motion import HeadMotion, HeadPose
from phonemeengine.mouth.lip_sync import cues, export, export_transcript, transcribe
from phonemeengine.mouth.mesh import Material, Mesh, mesh_of
from phonemeengine.mouth.morph_mesh import MorphMesh, MorphTargets, matched, morph_targets_of
from phonemeengine.mouth.morpher import Detail, Morpher
from phonemeengine.mouth.motion_settings import MotionSettings, TransitionTimes
from phonemeengine.mouth.movestate import Movestate, movestate_at, movestate_of
from phonemeengine.mouth.movestate_set import MovestateSet
from phonemeengine.mouth.osc import OscAddress, OscMouth
from phonemeengine.mouth.osc_expression import OscExpression
from phonemeengine.mouth.percentages import Mode
from phonemeengine.mouth.performer import FaceState, IdleMotion, MouthTrack, Performer, TimedFrame, timed_frames
from phonemeengine.mouth.table import MouthTable, load_table
from phonemeengine.mouth.table_writing import table_to_toml
from phonemeengine.mouth.transcript import Transcript, transcript_of_utterance
from phonemeengine.mouth.viseme_override import VisemeOverride
from phonemeengine.performance.building import BuiltTable, build_table
from phonemeengine.performance.choice import ExampleChoice
from phonemeengine.performance.driver import PerformanceDriver, PerformanceOptions, PerformancePart, UsedUnit
from phonemeengine.performance.expression_file import read_expression
from phonemeengine.performance.head_driver import HeadDriver
from phonemeengine.performance.keywords import Gesture, Keywords, load_keywords
from phonemeengine.performance.making import MadeCorpus, make_corpus
from phonemeengine.performance.original import RecordedFace, original_sound
from phonemeengine.performance.phrases import Phrase, PhraseIndex, PhraseMatch, PhraseMatchKind, phrases_of
from phonemeengine.performance.poses import Pose, PoseTable, load_poses
from phonemeengine.performance.recording import Performance, PerformedPhone, phones_of
from phonemeengine.performance.spoken_face import SpokenFace
from phonemeengine.performance.table_file import Example, PerformanceTable, TableAbout, write_table
from phonemeengine.performance.track import PerformanceTrack, PerformedMouth, face_table, format_units
from phonemeengine.performance.units import Unit, UnitKind, units_of
from phonemeengine.phonemes import MOUTH_SHAPES, MouthShape, Phoneme
from phonemeengine.preset_difference import DifferentStretch, PresetDifference, difference
from phonemeengine.presets.ears import ear_in_words, for_files
from phonemeengine.presets.files import load_preset, save_preset
from phonemeengine.presets.preset import Preset
from phonemeengine.progress import Cancelled, Progress
from phonemeengine.recognition.confidence import ConfidenceCurve
from phonemeengine.recognition.model import LookAheadFigures, Model, OutputHead
from phonemeengine.recognition.network import Layer
from phonemeengine.recognition.phoneme_data import PhonemeData, Thresholds
from phonemeengine.recognition.recognition import Recognition
from phonemeengine.recognition.rules import Condition, Rule
from phonemeengine.recognition.segments import Segment
from phonemeengine.recognition.spec import Recogniser, RecogniserConfig, RecogniserSpec, Tuning
from phonemeengine.recognition.templates import Templates
from phonemeengine.recognition.trace import RuleComparison, Trace
from phonemeengine.settings import (
    BIN_WIDTH,
    FRAME_PERIOD,
    HOP,
    SAMPLE_RATE,
    WINDOW,
    AnalysisSettings,
    Channel,
    Decimation,
    Ear,
    Filter,
    WindowFunction,
)
from phonemeengine.shipping.folder import format_ear, ship
from phonemeengine.speech.pinyin.driver import PinyinMouth
from phonemeengine.speech.pinyin.plan import Plan, PlanKind, PlanRow, format_plan
from phonemeengine.speech.pinyin.spring import Spring
from phonemeengine.speech.pinyin.table import PinyinTable, load_pinyin_table
from phonemeengine.speech.pinyin.timing import SaidPart, has_pinyin
from phonemeengine.speech.pinyin.track import PinyinTrack, pinyin_track
from phonemeengine.speech.program import speak_by_program
from phonemeengine.speech.silent import SilentSpeech, SilentText
from phonemeengine.speech.spoken_text import SpokenText, spoken_text
from phonemeengine.speech.voice import SpokenSentence, Voice, speak
from phonemeengine.text.espeak import Language, languages, voices
from phonemeengine.text.lexicon import Lexicon, load_lexicon
from phonemeengine.text.pronunciation import Pronunciation, ScriptWord, notes_on, words_of
from phonemeengine.text.script import timed_script
from phonemeengine.text.syllables import SpokenSyllable
from phonemeengine.visemes import NO_VISEME, Viseme, viseme_of

__all__ = [
    "BIN_WIDTH",
    "CONVERSIONS",
    "FORMATS",
    "FRAME_PERIOD",
    "HOP",
    "MOUTH_SHAPES",
    "NO_VISEME",
    "SAMPLE_RATE",
    "SENTENCES",
    "SOUND_SUFFIXES",
    "WHISPER_LICENCE",
    "WINDOW",
    "AddedNoise",
    "Analyser",
    "Analysis",
    "AnalysisSettings",
    "Animation",
    "AudioError",
    "AveragedSpectrum",
    "BatchError",
    "Blinker",
    "BuiltTable",
    "CalibrationResult",
    "Cancelled",
    "Channel",
    "Condition",
    "ConfidenceCurve",
    "ConfidenceInterval",
    "Conversion",
    "CorpusError",
    "CorpusScores",
    "Cue",
    "CurveError",
    "Decimation",
    "Detail",
    "Device",
    "DeviceError",
    "DifferentStretch",
    "Ear",
    "EncoderHead",
    "Encoding",
    "EngineError",
    "Example",
    "ExampleChoice",
    "ExportError",
    "ExportOptions",
    "ExportedCurves",
    "Expression",
    "ExpressionChannels",
    "ExpressionStream",
    "FaceDriver",
    "FaceState",
    "Features",
    "Filter",
    "FrameBlock",
    "FrameLabels",
    "Gesture",
    "GroupScores",
    "GrownWords",
    "HeadDriver",
    "HeadMotion",
    "HeadPose",
    "HeardPiece",
    "IdleMotion",
    "IncomingSpeech",
    "InhibitionTimes",
    "InputChoice",
    "Keywords",
    "Kind",
    "Label",
    "LabelledUtterance",
    "Language",
    "Latency",
    "Layer",
    "Level",
    "Lexicon",
    "Listener",
    "LookAheadFigures",
    "MadeCorpus",
    "Material",
    "Mesh",
    "MeshError",
    "Mix",
    "Mode",
    "Model",
    "ModelError",
    "ModelFolder",
    "MorphMesh",
    "MorphTargets",
    "Morpher",
    "MotionSettings",
    "MouthError",
    "MouthShape",
    "MouthTable",
    "MouthTrack",
    "Movestate",
    "MovestateSet",
    "NoiseAdder",
    "NoiseKind",
    "OscAddress",
    "OscExpression",
    "OscMouth",
    "OutputHead",
    "Performance",
    "PerformanceDriver",
    "PerformanceError",
    "PerformanceOptions",
    "PerformancePart",
    "PerformanceTable",
    "PerformanceTrack",
    "PerformedMouth",
    "PerformedPhone",
    "Performer",
    "Phone",
    "PhoneClass",
    "Phoneme",
    "PhonemeData",
    "PhonemeMap",
    "Phrase",
    "PhraseIndex",
    "PhraseMatch",
    "PhraseMatchKind",
    "PinyinMouth",
    "PinyinTable",
    "PinyinTrack",
    "Plan",
    "PlanKind",
    "PlanRow",
    "Pose",
    "PoseTable",
    "Predictions",
    "Preset",
    "PresetDifference",
    "PresetError",
    "Progress",
    "Pronunciation",
    "Reading",
    "Recogniser",
    "RecogniserConfig",
    "RecogniserError",
    "RecogniserSpec",
    "Recognition",
    "RecordedFace",
    "Recorder",
    "RecordingError",
    "Rule",
    "RuleComparison",
    "SaidPart",
    "Scores",
    "ScriptWord",
    "Segment",
    "Sentence",
    "SettingsError",
    "SilenceAccuracy",
    "SilentSpeech",
    "SilentText",
    "Sound",
    "SoundReader",
    "Spectrum",
    "SpokenFace",
    "SpokenSentence",
    "SpokenSyllable",
    "SpokenText",
    "Spring",
    "Statistics",
    "Status",
    "StreamFormat",
    "StretchMeasurement",
    "Syllable",
    "TableAbout",
    "TakeError",
    "Templates",
    "TextError",
    "Thresholds",
    "TimedFrame",
    "Trace",
    "Transcript",
    "TransitionTimes",
    "Tuning",
    "Unit",
    "UnitKind",
    "UnknownPhonemeError",
    "UsedUnit",
    "Utterance",
    "Variable",
    "Viseme",
    "VisemeOverride",
    "Voice",
    "VoiceError",
    "WindowFunction",
    "Word",
    "align",
    "aligned",
    "analyse_blocks",
    "animation_of",
    "average_spectrum",
    "build_table",
    "calibrate",
    "choose_whisper",
    "convert",
    "convert_all",
    "cues",
    "cues_of",
    "denoise",
    "devices",
    "difference",
    "ear_in_words",
    "export",
    "export_transcript",
    "expression_presets",
    "face_table",
    "fetch_whisper",
    "find_whisper",
    "for_files",
    "format_ear",
    "format_plan",
    "format_units",
    "format_utterance",
    "has_pinyin",
    "held_expression",
    "high_pass_gains",
    "languages",
    "load_channels",
    "load_head",
    "load_keywords",
    "load_lexicon",
    "load_morph_mesh",
    "load_morph_targets",
    "load_phoneme_map",
    "load_pinyin_table",
    "load_poses",
    "load_preset",
    "load_table",
    "low_pass_gains",
    "make_corpus",
    "matched",
    "measure",
    "mesh_of",
    "morph_targets_of",
    "movestate_at",
    "movestate_of",
    "normalise",
    "notes_on",
    "original_sound",
    "phones_of",
    "phrases_of",
    "pinyin_track",
    "push_together",
    "read_curves",
    "read_expression",
    "read_recordings",
    "read_sentence",
    "read_utterance",
    "recognise_window",
    "recorded_expression",
    "save_morph_targets",
    "save_preset",
    "save_stretch",
    "score",
    "sentences_in",
    "ship",
    "sounds_under",
    "speak",
    "speak_by_program",
    "spoken_text",
    "table_to_toml",
    "timed_frames",
    "timed_script",
    "transcribe",
    "transcript_of_utterance",
    "units_of",
    "usual_driver",
    "viseme_of",
    "voices",
    "whisper_in_words",
    "words_of",
    "write_table",
]

__version__: str
