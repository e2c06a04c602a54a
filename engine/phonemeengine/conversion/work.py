"""The one way from sounds to files: one or very many, with what is said in them and what moves a face by it."""

import math
import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path

from phonemeengine.analyser import analyse_file
from phonemeengine.batch.runner import BatchOptions, run_batch
from phonemeengine.batch.work import Act, Job, JobState, Made, Say, fingerprint_of, say_nothing
from phonemeengine.conversion.driving import USUAL_DRIVER, DriverChoice, Driving
from phonemeengine.conversion.options import FACIAL, WEIGHTED, ConversionOptions
from phonemeengine.conversion.spoken_texts import NO_TEXTS, SpokenTexts, edited_keys, made_of, open_sound
from phonemeengine.errors import ExportError, remedy
from phonemeengine.execution import Progress, no_progress
from phonemeengine.inspection.analysis_tables import TABLES
from phonemeengine.mouth.exports.exporter import Exporter, ExportOptions
from phonemeengine.mouth.exports.formats import FORMATS, Format
from phonemeengine.mouth.key_layer import NO_KEYS, KeyLayer
from phonemeengine.mouth.transcript import Script
from phonemeengine.performance.face_network import sound_of
from phonemeengine.presets.model_choice import for_files
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import Channel
from phonemeengine.storage.files import Owns, printable_name
from phonemeengine.storage.replacing import Guard, guarded_text, write_guarded


@dataclass(frozen=True)
class Conversion:
    """A kind of file that a sound can be turned into.

    Attributes
    ----------
    name : what it is called, such as ``rhubarb-json`` or ``frames-csv``.
    words : what it is, for people.
    ending : of its files.
    owns : says which files are of this kind and ours; None where those of other programs look alike.
    options : the names of the options that say how it is written; a face moves only where there are some.
    has_words : whether it is another file where the words are known.
    """

    name: str
    words: str
    ending: str
    owns: Owns | None
    options: frozenset[str] = frozenset()
    has_words: bool = True

    @property
    def moves_mouth(self) -> bool:
        """Whether `ExportOptions` say how it is written."""
        return bool(self.options)


def _conversions() -> dict[str, Conversion]:
    tables = [
        Conversion(f"phonemes-{kind}", f"phonemes as {words}", TABLES[kind].ending, TABLES[kind].owns)
        for kind, words in _TABLE_WORDS.items()
    ]
    frames = [
        Conversion(
            f"frames-{kind}", f"all variables every 10 ms, {kind.upper()}", form.ending, form.owns, has_words=False
        )
        for kind, form in TABLES.items()
        if form.write_frames is not None
    ]
    mouths = [Conversion(name, f.words, f.full_ending, f.owns, _options_of(f)) for name, f in FORMATS.items()]
    return {c.name: c for c in (*tables, *frames, *mouths)}


def _options_of(form: Format) -> frozenset[str]:
    """Return the names of the options that say how a format is written."""
    return frozenset(
        {
            "table",
            "anticipation",
            *(("fps",) if form.rate else ()),
            *(("minimum",) if form.has_cues else ()),
            *(WEIGHTED if form.moves_head or form.movestates else ()),
            *(FACIAL if form.moves_head else ()),
            *(("mesh",) if form.moves_mesh else ()),
        }
    )


_TABLE_WORDS = {"csv": "a table", "json": "JSON", "textgrid": "a Praat TextGrid", "audacity": "Audacity labels"}

CONVERSIONS = _conversions()
"""All kinds, by name."""


def check_options(kind: str, options: ExportOptions | None) -> None:
    """Refuse what cannot be done, before any sound is analysed.

    Raises
    ------
    ExportError : there is no such kind, or it cannot do what the options say.
    MouthError : the table cannot be used.
    """
    if kind not in CONVERSIONS:
        raise ExportError(f"there is no kind of file {kind!r}; {remedy(kind, CONVERSIONS)}")
    if CONVERSIONS[kind].moves_mouth:
        Exporter(kind, options)


def targets_of(sounds: list[Path], folder: Path | None, ending: str) -> dict[Path, Path]:
    """Return where the file of each sound goes: into a folder, or beside it; a number tells equal names apart."""
    taken, found = set[Path](), {}
    for sound in sounds:
        target, k = (folder or sound.parent) / f"{sound.stem}{ending}", 2
        while target in taken:
            target, k = (folder or sound.parent) / f"{sound.stem}-{k}{ending}", k + 1
        taken.add(target)
        found[sound] = target
    return found


@dataclass(frozen=True)
class ConversionWork:
    """Turns sounds into files of a kind; work for `run_batch`.

    Attributes
    ----------
    kind : see `CONVERSIONS`.
    preset : what is recognised with, by the best model that it has for files.
    options : how mouth cues are written.
    channel : what is recognised of files of several channels.
    texts : what is said in the sounds.
    driver : what moves a face.
    longest : seconds that a sound may last.
    keys : an animator's edits of the movement, by the sound's file.
    overwrite : whether to replace whatever is there; files that the same work made, as noted, are replaced anyway.

    Raises
    ------
    ExportError, MouthError : there is no such kind, or it cannot do what the options say.
    """

    kind: str
    preset: Preset
    options: ExportOptions | None = None
    channel: Channel = Channel.MIX
    texts: SpokenTexts = NO_TEXTS
    driver: DriverChoice = USUAL_DRIVER
    longest: float = math.inf
    keys: Mapping[Path, KeyLayer] = field(default_factory=dict)
    overwrite: bool = False

    def __post_init__(self) -> None:
        check_options(self.kind, self.options)
        if not CONVERSIONS[self.kind].has_words and self.texts != NO_TEXTS:
            raise ExportError("a table of frames has no place for words; leave the text out, or choose phonemes")
        if self.keys and "keys" not in CONVERSIONS[self.kind].options:
            raise ExportError(f"{self.kind} holds no edited keys; leave them out, or choose livelink-csv or gltf")

    @classmethod
    def of(
        cls,
        options: ConversionOptions,
        kind: str,
        preset: Preset,
        sounds: Sequence[Path] = (),
        say: Say = say_nothing,
    ) -> "ConversionWork":
        """Return the work that options ask for.

        Parameters
        ----------
        kind : see `CONVERSIONS`.
        preset : that of the options, loaded.
        sounds : that are turned into files.
        say : told what a script does not say of them.

        Raises
        ------
        EngineError : there is no such kind, it cannot do what the options say, or a file of theirs cannot be used.
        """
        written, driver = options.written(), DriverChoice.of(options)
        texts = SpokenTexts.of(options, sounds, say)
        keys, longest = edited_keys(options.keys, sounds), options.longest
        return cls(kind, preset, written, options.channel, texts, driver, longest, keys, options.overwrite)

    def fingerprint(self) -> str:
        """Return what tells it from other work."""
        options, moved = self.options or ExportOptions(), CONVERSIONS[self.kind].moves_mouth
        table = options.mouth_table(FORMATS[self.kind].table) if moved else None
        mesh = None if options.mesh is None else Path(options.mesh)
        written = replace(options, table=None, mesh=mesh) if moved else None
        driver = self.driver if moved else None
        return fingerprint_of("convert", self.kind, table, written, for_files(self.preset), self.channel, driver)

    def known_of(self, job: Job) -> str:
        """Return what is said in a sound, and how its movement was edited."""
        return fingerprint_of(self.texts.known_of(job.sound), self.keys.get(job.sound))

    @contextmanager
    def opened(self) -> Iterator[Act]:
        """Open what moves a face, and give what converts one file."""
        if not CONVERSIONS[self.kind].moves_mouth:
            yield self._write_table
            return
        exporter = Exporter(self.kind, self.options)
        with self.driver.opened(self.texts.language) as driving:
            yield partial(self._export, exporter, driving)

    def _write_table(self, job: Job, say: Say, progress: Progress) -> Made:
        about, _, kind = self.kind.partition("-")
        table, guard = TABLES[kind], self._guard_of(job)
        with (
            open_sound(job.source, self.channel, say, self.longest) as reader,
            guarded_text(job.target, guard) as file,
        ):
            if about == "frames" and table.write_frames is not None:
                analyses = analyse_file(reader, self.preset, pitch=True, progress=progress)
                table.write_frames(file, analyses, reader, self.preset)
                return made_of(reader, None)
            analyses = analyse_file(reader, self.preset, progress=progress)
            found = self.texts.aligned(reader, job.sound, analyses, say)
            if found is None:
                table.write_runs(file, analyses, reader, self.preset)
                return made_of(reader, None)
            table.write_words(file, *found, self.preset)
            return made_of(reader, found[0], self.texts.language)

    def _export(self, exporter: Exporter, driving: Driving, job: Job, say: Say, progress: Progress) -> Made:
        guard = self._guard_of(job)
        driving.say_notes(say)
        with open_sound(job.source, self.channel, say, self.longest) as reader:
            pitch = driving.recorded is not None or (exporter.format.moves_head and exporter.idle.head)
            analyses = analyse_file(reader, self.preset, pitch=pitch, progress=progress)
            felt = exporter.idle.feels
            utterance, speech = self.texts.said(reader, job.sound, analyses, say, felt=felt)
            exporter = exporter.felt(*self.texts.text_of(job.sound, utterance))
            driver = driving.chosen(utterance, printable_name(job.source), exporter.takes)
            track = driving.track(driver, utterance, speech, say, sound=sound_of(reader))
            movement = driving.movement(track, speech, exporter, say)
            made = made_of(reader, utterance, self.texts.language)
        parts = exporter.chunks_of(speech, movement, self.keys.get(job.sound, NO_KEYS))
        write_guarded(job.target, parts, guard, is_text=not exporter.format.moves_mesh)
        return made

    def _guard_of(self, job: Job) -> Guard:
        """Return what keeps files of others, after looking whether one is there."""
        guard = Guard(CONVERSIONS[self.kind].owns, self.overwrite, job.earlier, ExportError)
        guard.check(job.target)
        return guard


def convert(
    sound: str | os.PathLike[str],
    target: str | os.PathLike[str],
    kind: str,
    preset: Preset,
    options: ExportOptions | None = None,
    *,
    channel: Channel = Channel.MIX,
    script: Script | None = None,
    driver: DriverChoice = USUAL_DRIVER,
    overwrite: bool = False,
    progress: Progress = no_progress,
) -> None:
    """Turn a sound file into another file; one with other content that is there stays, unless told otherwise.

    Parameters
    ----------
    sound : the file.
    target : the new file; its folder is made if need be, and what was there stays until the new one is complete.
    kind : see `CONVERSIONS`.
    preset : what is recognised with, by the best model that it has for files.
    options : how mouth cues are written.
    channel : what is recognised of a file of several channels.
    script : what is said in it, where that is known; see `transcribe`.
    driver : what moves a face.
    overwrite : whether to replace whatever is there.
    progress : called with the share that is done, 0..1.

    Raises
    ------
    AudioError : the sound cannot be read.
    ExportError, MouthError : there is no such kind, or it cannot do what the options say; or another file is there,
        or it cannot be written.
    CorpusError : there is no word in the script.
    Cancelled : `progress` did not want to go on; what was there stays.
    """
    source = Path(sound)
    texts = NO_TEXTS if script is None else SpokenTexts(scripts={source: script})
    work = ConversionWork(kind, preset, options, channel, texts, driver, overwrite=overwrite)
    with work.opened() as act:
        act(Job(source, Path(target)), say_nothing, progress)


def export(
    sound: str | os.PathLike[str],
    target: str | os.PathLike[str],
    form: str,
    preset: Preset,
    options: ExportOptions | None = None,
    *,
    channel: Channel = Channel.MIX,
    script: Script | None = None,
    overwrite: bool = False,
    progress: Progress = no_progress,
) -> None:
    """Write what a sound file says, as mouth cues or the movement of a face for another program; see `convert`.

    Parameters
    ----------
    form : name of the format, such as ``rhubarb-json``, ``textgrid``, ``livelink`` or ``gltf``; see `FORMATS`.
    """
    Exporter(form, options)  # refuses what is another kind of file
    convert(
        sound, target, form, preset, options, channel=channel, script=script, overwrite=overwrite, progress=progress
    )


def convert_all(
    sounds: Iterable[str | os.PathLike[str]],
    folder: str | os.PathLike[str],
    kind: str,
    preset: Preset,
    options: ExportOptions | None = None,
    *,
    channel: Channel = Channel.MIX,
    overwrite: bool = False,
    processes: int | None = None,
    cluster: str | None = None,
    progress: Progress = no_progress,
) -> dict[Path, str]:
    """Turn sound files into files in a folder; return what was wrong with those that failed, a sentence each.

    What fails stops nothing, and what was done before and is unchanged is not done again. A script that has several
    processes work begins below ``if __name__ == "__main__":``, as `multiprocessing` wants it.

    Parameters
    ----------
    sounds : the files; a number tells the outputs of equal names apart.
    folder : where the new files go, and what was done is noted.
    kind, preset, options, channel, overwrite : as in `convert`.
    processes : files at a time; None for as many as there are cores, where that is worth it.
    cluster : the address of a Dask cluster's scheduler, which works in place of this machine.
    progress : called with the share that is done, 0..1.

    Raises
    ------
    ExportError, MouthError : there is no such kind, or it cannot do what the options say.
    BatchError : another batch is at work in the folder, the disk is full, or the cluster cannot be used.
    Cancelled : `progress` did not want to go on; what is complete stays.
    """
    work, folder = ConversionWork(kind, preset, options, channel, overwrite=overwrite), Path(folder)
    targets = targets_of([*map(Path, sounds)], folder, CONVERSIONS[kind].ending)
    jobs = [Job(source, target) for source, target in targets.items()]
    how = BatchOptions(processes, folder, cluster)
    outcomes = run_batch(jobs, work, how, on_progress=lambda found: progress(found.share))
    return {outcome.job.source: outcome.words for outcome in outcomes if outcome.state is JobState.FAILED}
