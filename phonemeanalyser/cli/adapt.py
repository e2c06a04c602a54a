"""``phonemeanalyser adapt``: calibrate a preset to one voice and to the background noise."""

import argparse
from dataclasses import replace
from pathlib import Path

import phonemeengine
from phonemeanalyser.cli.arguments import SAID, add_map, add_options, given, refuse_unused
from phonemeanalyser.cli.jobs import say_cut_off, say_note, sounds_in
from phonemeanalyser.cli.parser import file_place
from phonemeengine.arrays import Float32Array
from phonemeengine.calibration.calibrate import CalibrationResult
from phonemeengine.calibration.scores.corpus import is_labelled
from phonemeengine.calibration.takes.room_noise import measure_room
from phonemeengine.calibration.takes.sentences import LANGUAGES, labels_of, read_sentence, sentences_in
from phonemeengine.conversion.spoken_texts import NO_TEXTS, SpokenTexts
from phonemeengine.settings import SAMPLE_RATE
from phonemeengine.storage.replacing import Guard, nothing_is_own

MOST_ROOM = 60
"""Seconds of background noise that are read."""

EXAMPLES = (
    "phonemeanalyser adapt my-takes -o my-voice.toml",
    "phonemeanalyser adapt speech.wav --script speech.txt --language en-us -o my-reading.toml",
    "phonemeanalyser adapt --background-noise silence.wav -o my-microphone.toml",
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what is learned from, and what is made of it."""
    parser.epilog = (
        "Adapts the networks of the learned recogniser, the thresholds of rules, or the templates. Refuses a change "
        "that costs more than 0.01 (mouth shapes, silence) on held-out recordings."
    )
    words = "takes or labelled recordings; with --line, --text or --script, recordings of a speaker who reads it"
    parser.add_argument("folders", type=Path, nargs="*", metavar="FOLDER", help=words)
    parser.add_argument("-o", "--out", type=file_place, required=True, metavar="PRESET", help="the new preset, .toml")
    parser.add_argument(
        "--held-out",
        type=Path,
        nargs="+",
        default=[],
        metavar="FILE",
        help="labelled recordings of the voice that are only scored (default: each quarter of the others in turn)",
    )
    parser.add_argument(
        "--background-noise",
        type=Path,
        metavar="SOUND",
        help="a few seconds of background noise without speech (default: that of the takes)",
    )
    parser.add_argument(
        "--line",
        choices=[language.lower() for language in LANGUAGES],
        help="language of the line that the window shows, which the speaker reads: "
        + sentences_in(LANGUAGES[0])[0].text
        + " (english)",
    )
    add_options(parser, "preset", *SAID, "channel", "overwrite")
    add_map(parser)


def run(options: argparse.Namespace) -> int:
    """Calibrate; returns the exit code."""
    if options.out.suffix.lower() != ".toml":
        raise phonemeengine.PresetError(f"{options.out}: an adapted preset's file ends in .toml; name it so")
    if not options.folders:
        if options.background_noise is None:
            options.parser.error(
                "there is nothing to calibrate to; give a FOLDER of takes, or --background-noise SOUND"
            )
        refuse_unused(options, (*SAID, "line", "map", "held-out"), "goes with recordings; give a FOLDER of them")
    Guard(nothing_is_own, options.overwrite).check(options.out)
    preset = phonemeengine.load_preset(options.preset)
    room = _sound_of(options.background_noise, options.channel) if options.background_noise else None
    if options.folders:
        found = _calibrated(preset, room, options)
    else:
        assert room is not None
        found = _with_silence(preset, room, options)
    phonemeengine.save_preset(replace(found, name=options.out.stem), options.out)
    return 0


def _calibrated(
    preset: phonemeengine.Preset, room: Float32Array | None, options: argparse.Namespace
) -> phonemeengine.Preset:
    mapping = phonemeengine.load_phoneme_map(options.map) if options.map else phonemeengine.PhonemeMap()
    held_out = _read(options.held_out, mapping, options.channel)
    takes = _read_aloud(options) or _read_labelled(options.folders, mapping, options.channel)
    say_cut_off([*takes, *held_out])
    result = phonemeengine.calibrate(preset, takes, held_out=held_out, room=room)
    seconds = sum(utterance.labels[-1].end for utterance in takes if utterance.labels)
    several = "s" if len(takes) != 1 else ""
    print(f"{options.out}: {len(takes)} recording{several}, {seconds:.0f} s; {_gain_in_words(result)}")
    accuracy = f"{result.silence_accuracy}." if result.silence_accuracy else ""
    for sentence in (result.refusal, result.warning, accuracy):
        if sentence:
            print(sentence)
    return result.preset


def _with_silence(
    preset: phonemeengine.Preset, room: Float32Array, options: argparse.Namespace
) -> phonemeengine.Preset:
    measured = measure_room(room, preset)
    if measured.notes:
        raise phonemeengine.TakeError(f"{options.background_noise.name}: {measured.notes[0]}")
    found = measured.set_silence(preset)
    print(f"{options.out}: background noise of {measured}; {measured.silence_accuracy(found)}.")
    return found


def _gain_in_words(result: CalibrationResult) -> str:
    """Return what was gained, and on what that was measured."""
    one, other = result.before, result.after
    where = "each quarter held out in turn" if result.cross_validated else "held-out recordings"
    on = f"on {where}, {result.seconds:.0f} s"
    if not result.gains:
        return f"nothing better was found {on} (macro F1 {one.macro_f1:.1%}); unchanged"
    clear = "" if result.is_clear else "; no clear change: so much may be chance"
    return (
        f"{on}: macro F1 {one.macro_f1:.1%} -> {other.macro_f1:.1%}, mouth shapes {one.viseme_accuracy:.1%} -> "
        f"{other.viseme_accuracy:.1%}, silence recall {one.silence_recall:.1%} -> {other.silence_recall:.1%}, "
        f"false silence {one.false_silence:.1%} -> {other.false_silence:.1%}{clear}"
    )


def _read_aloud(options: argparse.Namespace) -> list[phonemeengine.LabelledUtterance]:
    """Label the sounds of a speaker who reads by what is read; none where the command line does not say it."""
    is_told = any(given is not None for given in (options.line, options.text, options.script))
    sounds = sounds_in(options.folders) if is_told else options.folders
    texts = SpokenTexts.of(given(options), sounds, say_note)
    if options.line is not None:
        if options.text is not None or options.script is not None:
            options.parser.error("--line is itself the text; leave --text and --script out")
        return [read_sentence(sound, sentences_in(options.line)[0], options.channel) for sound in sounds]
    if texts is NO_TEXTS:
        return []
    found = [utterance for sound in sounds if (utterance := _labelled(sound, texts, options.channel))]
    if not found:
        raise phonemeengine.TakeError("no text is known for these recordings; name them in the script")
    return found


def _labelled(
    sound: Path, texts: SpokenTexts, channel: phonemeengine.Channel
) -> phonemeengine.LabelledUtterance | None:
    """Label a sound by what is read in it; None where nothing says it."""
    with phonemeengine.SoundReader(sound, channel) as reader:
        said = texts.script_of(sound, reader.duration, say_note)
    if said is None:
        return None
    if isinstance(said, phonemeengine.Utterance):
        return phonemeengine.LabelledUtterance(sound, labels_of(said), sound.stem, "read", channel)
    return read_sentence(sound, said, channel)


def _read_labelled(
    sources: list[Path], mapping: phonemeengine.PhonemeMap, channel: phonemeengine.Channel
) -> list[phonemeengine.LabelledUtterance]:
    bare = next((source for source in sources if source.is_file() and not is_labelled(source)), None)
    if bare is not None:
        raise phonemeengine.CorpusError(
            f"{bare.name}: there is no label file beside this sound; say what is read with --line or --text, or put "
            "a .TextGrid, .csv or .txt file of the same name beside it"
        )
    return _read(sources, mapping, channel)


def _read(
    sources: list[Path], mapping: phonemeengine.PhonemeMap, channel: phonemeengine.Channel
) -> list[phonemeengine.LabelledUtterance]:
    return [
        utterance
        for source in sources
        for utterance in phonemeengine.read_recordings(source, mapping, channel=channel)
    ]


def _sound_of(path: Path, channel: phonemeengine.Channel) -> Float32Array:
    with phonemeengine.SoundReader(path, channel, as_it_is=True) as reader:
        return reader.read_mono(MOST_ROOM * SAMPLE_RATE)
