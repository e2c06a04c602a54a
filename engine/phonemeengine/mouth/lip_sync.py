"""Sound files as mouths, in one call: what is said, and cues; and what is known of sounds, for other programs."""

import os
from pathlib import Path

from phonemeengine.analyser import analyse_file
from phonemeengine.audio.files import SoundReader
from phonemeengine.errors import ExportError
from phonemeengine.execution import Progress, no_progress
from phonemeengine.mouth.animation import Animation
from phonemeengine.mouth.cues import MINIMUM, Cue, cues_of
from phonemeengine.mouth.exports.exporter import Exporter, ExportOptions
from phonemeengine.mouth.table import USUAL_TABLE, MouthTable, load_table
from phonemeengine.mouth.transcript import Script, Transcript, scripted_transcript_of, transcript_of
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import Channel
from phonemeengine.storage.files import printable_name
from phonemeengine.storage.replacing import Guard, write_guarded


def transcribe(
    sound: str | os.PathLike[str],
    preset: Preset,
    *,
    channel: Channel = Channel.MIX,
    pitch: bool = False,
    script: Script | None = None,
    felt: bool = False,
    progress: Progress = no_progress,
) -> Transcript:
    """Return what a sound file says: its segments of equal phonemes, and how loud it is.

    Parameters
    ----------
    sound : the file.
    preset : what to recognise with.
    channel : what is recognised of a file of several channels.
    pitch : measure the fundamental frequency too, by which a head moves.
    script : what is said in it, where that is known: its words (see `words_of`), or an `Utterance`, such as
        `align` gives; far more accurate than recognition alone.
    felt : estimate the feeling in the voice too, by which an expression moves; see `FeelingAmounts`.
    progress : called with the share that is done, 0..1.

    Raises
    ------
    AudioError : the file cannot be read.
    CorpusError : there is no word in the script.
    Cancelled : `progress` did not want to go on.
    """
    with SoundReader(sound, channel) as reader:
        analyses = analyse_file(reader, preset, pitch=pitch, progress=progress)
        name, duration = printable_name(reader.path), reader.duration
        if script is None:
            return transcript_of(analyses, name, duration, reader.path, felt=felt)
        return scripted_transcript_of(analyses, script, name, duration, reader.path, felt=felt)[1]


def cues(
    sound: str | os.PathLike[str],
    preset: Preset,
    table: MouthTable | str | os.PathLike[str] = USUAL_TABLE,
    *,
    minimum: float = MINIMUM,
    anticipation: float = 0.0,
    channel: Channel = Channel.MIX,
    script: Script | None = None,
) -> tuple[Cue, ...]:
    """Return which shape the mouth has from when to when while a sound file plays, without gaps.

    Parameters
    ----------
    sound, preset, channel, script : as in `transcribe`.
    table : the mouth shapes: a table, its file, or the name of one that ships, such as ``rhubarb``.
    minimum : least duration of a cue, seconds.
    anticipation : by how much the mouth is ahead of the sound, 0..0.12 s.

    Raises
    ------
    AudioError : the file cannot be read.
    MouthError : the table cannot be used, or a time lies outside its range.
    """
    table = table if isinstance(table, MouthTable) else load_table(table)
    said = transcribe(sound, preset, channel=channel, script=script)
    return cues_of(said.runs, table, minimum=minimum, anticipation=anticipation)


def export_transcript(
    speech: Transcript,
    target: str | os.PathLike[str],
    form: str,
    options: ExportOptions | None = None,
    *,
    movement: Animation | None = None,
    overwrite: bool = False,
) -> None:
    """Write what is known of a sound, such as a voice's, as mouth cues or the movement of a face; see `export`.

    Parameters
    ----------
    speech : what is said, such as `SpokenText.transcript`.
    target, form, options, overwrite : as in `export`.
    movement : how the face moves, at the format's rate, where the cues do not say that; such as
        `PinyinTrack.animation`.

    Raises
    ------
    MouthError : its table cannot be used.
    ExportError : there is no such format, it cannot do what is asked for, another file is there, or it cannot be
        written.
    """
    exporter = Exporter(form, options)
    guard = Guard(exporter.format.owns, overwrite, error=ExportError)
    guard.check(Path(target))
    write_guarded(Path(target), exporter.chunks_of(speech, movement), guard)
