"""The ear and the mouth of PhonemeAnalyser: sound in, phonemes, intensities and mouth shapes out, every 10 ms.

This is the whole API. A game plays a file, or listens to a microphone, and asks whenever it likes; no call waits for
sound, and whatever lives is a context manager::

    from phonemeengine import Listener, Sound, load_preset

    preset = load_preset("learned")          # or a file: what a calibration made of it
    with Listener(preset) as voice:          # a microphone; or Sound("line.wav", preset), and .play()
        phoneme, intensity, confidence = voice.poll()    # every 10 or 20 ms

A program with samples of its own pushes them, cut as they come, or asks about a single window::

    analyser = Analyser(preset, rate=48_000, live=True)
    analysis = analyser.push(samples)        # float32 within ±1 or int16; mono, or (n, n_channels)
    analysis.phonemes, analysis.intensities  # one for each 10 ms that are complete
    phoneme, intensity, confidence = recognise_window(samples[:2048], preset)

Bytes of any rate that come over a network are heard within 60 ms, with their text, if it comes along, aligned::

    speech = IncomingSpeech(preset, StreamFormat(Encoding.S16, 24_000))
    for piece in speech.pieces(data):        # bytes, cut as they come
        speech.hear(piece).analysis.phonemes

A face follows what was heard, and may be looked at whenever a picture is drawn::

    morpher = Morpher(load_table("arkit"), seed=1)
    morpher.hear(now, phoneme, intensity)    # seconds, of a clock of yours
    weights = morpher.weights(now)           # 0..1, one for each of morpher.movestates

Who knows more than phonemes tells the phone as well, in the IPA: ``morpher.hear(now, phoneme, intensity, "f")``. Of
whole sounds, `transcript_of_utterance` makes what a mouth needs.

Files become mouth cues, or whatever another program reads::

    cues("line.wav", preset)                 # which shape from when to when
    export("line.wav", "line.json", "rhubarb-json", preset)

A thousand hours of them, on all cores or a cluster, none twice::

    convert_all(sounds, "out", "rhubarb-json", preset)

A Chinese text moves a mouth by pinyin, with a voice's times or by a rate::

    performer = Performer(load_table("arkit"))
    performer.play(pinyin_track("你好。").mouth(), start=now)
    weights = performer.at(now).weights      # as above

Movestates (morph targets) move the vertices of a mesh::

    head = load_head()                       # or load_morph_mesh("face.glb")
    states = MovestateSet(head.mesh, head.states)
    states.set_percentage("jawOpen", 60, Mode.INTERACT)
    positions = states.morphed()             # of all vertices

A text is spoken, and it is known what is said when::

    samples, utterance = speak("Good evening.", Voice("en-gb"))
    [(word.text, word.start, word.end) for word in utterance.words]

Recorded faces become a table, in which units of new sentences are looked up by their phones and duration::

    build_table("recordings", "anna.sqlite")      # NAME.wav, NAME.TextGrid, NAME.csv of Live Link Face
    with PerformanceTable.open("anna.sqlite") as table:
        table.nearest(UnitKind.SYLLABLE, ("m", "a"), 0.21, limit=10)

What is said in a sound, with how loud and high that is, is said by such a face::

        track = PerformanceTrack(utterance, transcript, table)
        animation = track.animation(transcript, rate=60)      # or performer.play(track.mouth(), start=now)

A preset learns a voice from labelled recordings of it, and is told how right it is on others::

    result = calibrate(preset, read_recordings("takes"), held_back=read_recordings("sentence.flac"))
    save_preset(result.preset, "my-voice.toml")
    score(result.preset, read_recordings("corpus")).overall.scores.macro_f1

Whatever is refused is an `EngineError` whose text is one sentence for the person at the screen. What happens to
devices, recordings and files is logged below the logger ``phonemeengine``, silently unless a program listens to it.
"""

import logging
from importlib import import_module
from typing import Any

__version__ = "0.1.0"

# Everything is imported when it is first asked for: who analyses files does not wait for meshes. The same names, with
# their types, are in __init__.pyi, which editors and type checkers read; a test holds the two together.
_PAGE = {
    # A sound, as it is heard
    "live.sound": "Sound",
    "live.listener": "Listener",
    "live.recorder": "Recorder",
    "audio.stream": "devices",
    "audio.devices": "Device InputChoice",
    "audio.files": "SOUND_SUFFIXES SoundReader sounds_under",
    "audio.level": "Level",
    "audio.mixing": "Mix",
    "audio.incoming": "Encoding StreamFormat",
    "live.incoming_speech": "HeardPiece IncomingSpeech",
    "live.status": "Status",
    "live.microphone_analyser": "Latency",
    # What is said in it
    "analyser": "Analyser Analysis Reading analyse_blocks push_together recognise_window",
    "visemes": "NO_VISEME Viseme viseme_of",
    "phonemes": "MOUTH_SHAPES MouthShape Phoneme",
    "features.measure": "Features",
    "features.front_end": "FrameBlock",
    "recognition.segments": "Segment",
    "labels.utterance": "Phone Syllable Utterance Word",
    "labels.utterance_files": "format_utterance read_utterance",
    "preset_difference": "PresetDifference DifferentStretch difference",
    "conversion": "CONVERSIONS Conversion convert",
    "batch.conversion_work": "convert_all",
    "measurement": "StretchMeasurement Statistics average_spectrum measure save_stretch",
    "averaged_spectrum": "AveragedSpectrum",
    "mouth.transcript": "Transcript transcript_of_utterance",
    "mouth.lip_sync": "cues export export_transcript transcribe",
    "mouth.cues": "Cue cues_of",
    "mouth.exports.exporter": "ExportOptions",
    "mouth.exports.formats": "FORMATS",
    "mouth.animation": "Animation animation_of",
    "mouth.curves_file": "ExportedCurves read_curves",
    "shipping.folder": "format_ear ship",
    # A mouth that says it
    "mouth.morpher": "Detail Morpher",
    "mouth.expression.channels": "ExpressionChannels load_channels",
    "mouth.expression.composer": "Expression",
    "mouth.expression.inhibition": "InhibitionTimes",
    "mouth.expression.streams": "ExpressionStream expression_presets held_expression recorded_expression",
    "mouth.performer": "FaceState IdleMotion MouthTrack Performer TimedFrame timed_frames",
    "mouth.viseme_override": "VisemeOverride",
    "mouth.table": "MouthTable load_table",
    "mouth.table_writing": "table_to_toml",
    "mouth.motion_settings": "MotionSettings TransitionTimes",
    "mouth.blinks": "Blinker",
    "mouth.head_motion": "HeadMotion HeadPose",
    "mouth.osc_expression": "OscExpression",
    "mouth.osc": "OscAddress OscMouth",
    # A mouth that says a text
    "speech.pinyin.track": "PinyinTrack pinyin_track",
    "speech.silent": "SilentSpeech SilentText",
    "speech.pinyin.timing": "SaidPart has_pinyin",
    "speech.pinyin.table": "PinyinTable load_pinyin_table",
    "speech.pinyin.driver": "PinyinMouth",
    "speech.pinyin.spring": "Spring",
    "speech.pinyin.plan": "Plan PlanKind PlanRow format_plan",
    # A face that it moves
    "mouth.head": "load_head",
    "mouth.files.io": "load_morph_mesh load_morph_targets save_morph_targets",
    "mouth.mesh": "Material Mesh mesh_of",
    "mouth.morph_mesh": "MorphMesh MorphTargets matched morph_targets_of",
    "mouth.movestate": "Movestate movestate_at movestate_of",
    "mouth.movestate_set": "MovestateSet",
    "mouth.percentages": "Mode",
    # What is recognised with
    "presets.ears": "ear_in_words for_files",
    "presets.files": "load_preset save_preset",
    "presets.preset": "Preset",
    "settings": (
        "BIN_WIDTH FRAME_PERIOD HOP SAMPLE_RATE WINDOW AnalysisSettings Channel Decimation Ear Filter WindowFunction"
    ),
    "features.variables": "Kind Spectrum Variable",
    "recognition.phoneme_data": "PhonemeData Thresholds",
    "recognition.rules": "Condition Rule",
    "recognition.model": "LookAheadFigures Model OutputHead",
    "recognition.network": "Layer",
    "recognition.confidence": "ConfidenceCurve",
    "encoder.head": "EncoderHead",
    "encoder.model_folder": "ModelFolder choose_whisper fetch_whisper find_whisper whisper_in_words",
    "encoder.whisper": "WHISPER_LICENCE",
    "recognition.templates": "Templates",
    "dsp.filters": "denoise high_pass_gains low_pass_gains normalise",
    # A recogniser of one's own
    "recognition.spec": "Recogniser RecogniserConfig RecogniserSpec Tuning",
    "recognition.recognition": "Recognition",
    "recognition.trace": "RuleComparison Trace",
    # What is said in a sound, by its script
    "alignment.align": "align",
    "alignment.growing": "GrownWords",
    "text.lexicon": "Lexicon load_lexicon",
    "text.pronunciation": "Pronunciation ScriptWord notes_on words_of",
    "text.script": "timed_script",
    "text.syllables": "SpokenSyllable",
    # A text, as a voice says it
    "speech.voice": "SpokenSentence Voice speak",
    "speech.program": "speak_by_program",
    "speech.spoken_text": "SpokenText spoken_text",
    "text.espeak": "Language languages voices",
    # Recorded faces
    "performance.recording": "PerformedPhone Performance phones_of",
    "performance.units": "Unit UnitKind units_of",
    "performance.table_file": "Example PerformanceTable TableAbout write_table",
    "performance.building": "BuiltTable build_table",
    "performance.making": "MadeCorpus make_corpus",
    # A sentence that they say
    "performance.track": "PerformanceTrack PerformedMouth face_table format_units",
    "performance.head_driver": "HeadDriver",
    "mouth.face_driver": "FaceDriver usual_driver",
    "performance.expression_file": "read_expression",
    "performance.original": "RecordedFace original_sound",
    "performance.spoken_face": "SpokenFace",
    "performance.driver": "PerformanceDriver PerformanceOptions PerformancePart UsedUnit",
    "performance.choice": "ExampleChoice",
    "performance.poses": "Pose PoseTable load_poses",
    "performance.phrases": "Phrase PhraseIndex PhraseMatch PhraseMatchKind phrases_of",
    "performance.keywords": "Gesture Keywords load_keywords",
    # A voice, and how well it is recognised
    "calibration.scores.corpus": "FrameLabels LabelledUtterance read_recordings",
    "labels.label": "Label",
    "labels.phoneme_map": "PhonemeMap load_phoneme_map",
    "labels.phone_sets": "PhoneClass",
    "calibration.alignment": "aligned read_sentence",
    "calibration.sentences": "SENTENCES Sentence sentences_in",
    "calibration.calibrate": "CalibrationResult calibrate",
    "calibration.takes.room_noise": "ConfidenceInterval SilenceAccuracy",
    "calibration.scores.evaluation": "CorpusScores GroupScores Predictions score",
    "calibration.scores.scoring": "Scores",
    "calibration.scores.added_noise": "AddedNoise NoiseAdder NoiseKind",
    "progress": "Cancelled Progress",
    # What is refused
    "errors": (
        "AudioError BatchError CorpusError CurveError DeviceError EngineError ExportError MeshError ModelError "
        "MouthError PerformanceError PresetError RecogniserError RecordingError SettingsError TakeError TextError "
        "UnknownPhonemeError VoiceError"
    ),
}
_ALIASES = {"SOUND_SUFFIXES": "SUFFIXES"}
_HOMES = {name: module for module, names in _PAGE.items() for name in names.split()}

__all__ = ["__version__", *_HOMES]  # noqa: PLE0604 - all of them are names

logging.getLogger(__name__).addHandler(logging.NullHandler())


def __getattr__(name: str) -> Any:
    """Import what the page offers under a name (PEP 562)."""
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    found = getattr(import_module(f"{__name__}.{_HOMES[name]}"), _ALIASES.get(name, name))
    globals()[name] = found
    return found


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
