"""What the window makes of sounds: conversions, clips and reports, one file after the other while it goes on."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from enum import StrEnum
from pathlib import Path
from tempfile import TemporaryDirectory
from threading import Lock
from typing import Any

from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.tasks import CLOSE_TIMEOUT, TaskQueue
from phonemeanalyser.rendering.clip_options import USUAL_CLIP, ClipOptions
from phonemeanalyser.reports.page import write_batch_report
from phonemeengine.audio.files import SoundReader, sounds_under
from phonemeengine.batch.runner import BatchOptions, BatchProgress, run_batch
from phonemeengine.batch.runner import in_the_way as jobs_in_the_way
from phonemeengine.batch.work import Act, Job, JobState, Made, Outcome, Say, Work, fingerprint_of, say_nothing
from phonemeengine.calibration.scores.corpus import read_recordings
from phonemeengine.calibration.scores.evaluation import score
from phonemeengine.conversion.driving import USUAL_DRIVER, DriverChoice
from phonemeengine.conversion.options import FACIAL, WEIGHTED
from phonemeengine.conversion.speech_files import SpeechFiles
from phonemeengine.conversion.spoken_texts import BESIDE, NO_TEXTS, SpokenTexts, edited_keys
from phonemeengine.conversion.work import CONVERSIONS, Conversion, ConversionWork
from phonemeengine.execution import Progress, report_progress
from phonemeengine.inspection.measurement import save_stretch
from phonemeengine.labels.files import LABEL_SUFFIXES
from phonemeengine.labels.utterance import Utterance
from phonemeengine.mouth.exports.exporter import Exporter, ExportOptions
from phonemeengine.mouth.files.io import FaceFiles
from phonemeengine.mouth.key_layer import KeyLayer
from phonemeengine.mouth.table import USUAL_TABLE
from phonemeengine.performance.choice import Given
from phonemeengine.presets.model_choice import for_files
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import Channel
from phonemeengine.speech.voice import SpokenSentence
from phonemeengine.storage.replacing import Guard, write_guarded


@dataclass(frozen=True)
class TextToSay:
    """A text that a voice says.

    Attributes
    ----------
    text, language : what is said.
    speak : has the voice say it, sentence by sentence.
    given : tells of what the sound is made, where recordings speak; see `PerformanceOptions`.
    """

    text: str
    language: str
    speak: Callable[[], Iterator[SpokenSentence]] = field(compare=False, repr=False)
    given: Given | None = field(default=None, compare=False, repr=False)


@dataclass(frozen=True)
class FaceInUse:
    """What the Talk page holds, so that files are made as the head is seen.

    Attributes
    ----------
    table : the name of the mouth table.
    options : how mouth and face move, by that table.
    movestates : those of the mesh of the options, where they are in a file of their own.
    driver : what moves the face where the words are known.
    words : what is said, by the sound's file, as far as it is known.
    speech : the current text, where it is no sound.
    keys : an animator's edits, by the sound's file.
    texts : the texts of `words`, by the sound's file.
    """

    table: str = USUAL_TABLE
    options: ExportOptions = field(default_factory=ExportOptions)
    movestates: Path | tuple[Path, ...] | None = None
    driver: DriverChoice = USUAL_DRIVER
    words: Mapping[Path, Utterance] = field(default_factory=dict)
    speech: TextToSay | None = None
    keys: Mapping[Path, KeyLayer] = field(default_factory=dict)
    texts: Mapping[Path, str] = field(default_factory=dict)


@dataclass(frozen=True)
class ExportOrder:
    """What sounds are turned into.

    Attributes
    ----------
    kind : one of `EXPORT_KINDS`.
    preset : what is recognised with.
    options : how mouths move.
    channel : what is recognised of files of several channels.
    texts : what is said in the sounds; None where that lies beside each of them.
    driver : what moves a face.
    movestates : those of the mesh of the options, where they are in a file of their own.
    speech : the text that is turned into a file in place of sounds.
    keys : an animator's edits by the sound's file, which go before those beside the sounds; None for no edits at all.
    overwrite : whether to replace whatever is there, not only what the same order made.
    look : of clips; their rate is that of the options.
    """

    kind: str
    preset: Preset
    options: ExportOptions
    channel: Channel = Channel.MIX
    texts: SpokenTexts | None = NO_TEXTS
    driver: DriverChoice = USUAL_DRIVER
    movestates: Path | tuple[Path, ...] | None = None
    speech: TextToSay | None = None
    keys: Mapping[Path, KeyLayer] | None = None
    overwrite: bool = False
    look: ClipOptions = USUAL_CLIP


def with_texts(order: ExportOrder, sounds: Sequence[Path]) -> ExportOrder:
    """Return an order that knows what is said in some sounds and how it was edited, also where that lies beside them.

    Raises
    ------
    EngineError : a file beside a sound cannot be read.
    """
    texts = order.texts
    if not EXPORT_KINDS[order.kind].has_words or order.speech is not None:
        texts = NO_TEXTS
    elif texts is None:
        texts = NO_TEXTS.of_script(BESIDE, sounds, say_nothing)
    keys = order.keys
    if keys is not None:
        keys = edited_keys(BESIDE, [sound for sound in sounds if sound not in keys]) | {**keys}
    return replace(order, texts=texts, keys=keys)


def work_of(order: ExportOrder) -> Work:
    """Return what makes the files of an order.

    Raises
    ------
    EngineError : a format or a table cannot do what the options say.
    """
    kind = EXPORT_KINDS[order.kind]
    if order.speech is not None:
        return SpeechWork(order, order.speech)
    texts = order.texts if order.texts is not None and kind.has_words else NO_TEXTS
    keys, overwrite = order.keys or {}, order.overwrite
    if order.kind in CONVERSIONS:
        return ConversionWork(
            order.kind,
            order.preset,
            order.options,
            order.channel,
            texts,
            order.driver,
            keys=keys,
            overwrite=overwrite,
        )
    if not kind.moves_mouth:
        return ReportWork(order)
    from phonemeanalyser.rendering.clip import ClipWork, check_clip  # noqa: PLC0415 - no window waits for it

    options, look = order.options, replace(order.look, rate=order.options.rate or USUAL_CLIP.rate)
    check_clip(Path("clip" + kind.ending), look)
    face = FaceFiles(None if options.mesh is None else Path(options.mesh), order.movestates)
    return ClipWork(
        options, order.preset, order.channel, texts, order.driver, face, look, keys=keys, overwrite=overwrite
    )


@dataclass(frozen=True)
class SpeechWork:
    """Has a voice say the text of an order, and writes how a face says it, as the command `speak` does."""

    order: ExportOrder
    speech: TextToSay

    def __post_init__(self) -> None:
        Exporter(self.order.kind, self.order.options)

    def fingerprint(self) -> str:
        """Return what tells it from other work."""
        return fingerprint_of("speech", self.order.kind, self.order.options, self.speech)

    def known_of(self, _job: Job) -> str:
        """Return an empty text: nothing is known of a text besides."""
        return ""

    @contextmanager
    def opened(self) -> Iterator[Act]:
        """Open what moves the face, and give what writes the file."""
        with self.order.driver.opened(self.speech.language) as opened:
            driving = replace(opened, options=replace(opened.options, given=self.speech.given))

            def act(job: Job, say: Say, progress: Progress) -> Made:
                exporter = Exporter(self.order.kind, self.order.options)
                order = self.order
                files = SpeechFiles(None, None, job.target, None, exporter, driving, say, order.overwrite)
                lengths: list[float] = []
                files.write_spoken(self._spoken(progress, lengths), self.speech.language, self.speech.text)
                return Made(sum(lengths), self.speech.language)

            yield act

    def _spoken(self, progress: Progress, lengths: list[float]) -> Iterator[SpokenSentence]:
        """Return sentences as they come, note their lengths, and tell how much of the text they are."""
        n = 0
        for sentence in self.speech.speak():
            n += len(sentence.text)
            lengths.append(sentence.duration)
            report_progress(progress, min(1.0, n / max(1, len(self.speech.text))))
            yield sentence


@dataclass(frozen=True)
class ReportWork:
    """Scores the preset of an order on the labels beside sounds, as the command `score` does."""

    order: ExportOrder

    def fingerprint(self) -> str:
        """Return what tells it from other work."""
        return fingerprint_of("report", for_files(self.order.preset), self.order.channel)

    def known_of(self, job: Job) -> str:
        """Return what the files beside a sound hold by which a report scores it."""
        return fingerprint_of(*(job.source.with_suffix(suffix) for suffix in LABEL_SUFFIXES))

    @contextmanager
    def opened(self) -> Iterator[Act]:
        """Give what writes one report."""
        yield self._write

    def _write(self, job: Job, _say: Say, progress: Progress) -> Made:
        with SoundReader(job.source, self.order.channel) as reader:
            duration = reader.duration
        from phonemeanalyser.reports.page import page_of  # noqa: PLC0415 - only reports need pages, the start does not
        from phonemeanalyser.reports.report import Report, ScoredPreset  # noqa: PLC0415 - as above

        utterances = read_recordings(job.source, channel=self.order.channel)
        progress(0.1)
        found = score(for_files(self.order.preset), utterances)
        page = page_of(Report(job.source.parent, (ScoredPreset(self.order.preset.name, found),)))
        progress(1.0)
        write_guarded(job.target, [page.encode()], Guard(None, self.order.overwrite, job.earlier))
        return Made(duration)


CLIP_OPTIONS = frozenset({"table", "fps", "anticipation", "mesh", *WEIGHTED, *FACIAL})
PICTURES = "clip-png"
CLIPS = {"clip-mp4", "clip-gif", PICTURES}
EXPORT_KINDS: dict[str, Conversion] = CONVERSIONS | {
    kind.name: kind
    for kind in (
        Conversion("clip-mp4", tr_noop("video of the head with its sound"), ".mp4", None, CLIP_OPTIONS),
        Conversion("clip-gif", tr_noop("animated GIF of the head"), ".gif", None, CLIP_OPTIONS),
        Conversion(PICTURES, tr_noop("folder of PNG pictures of the head"), "-pictures", None, CLIP_OPTIONS),
        Conversion(
            "report-html",
            tr_noop("accuracy report by the labels beside the file"),
            ".report.html",
            None,
            has_words=False,
        ),
    )
}
"""All kinds, by name."""


MOST_PREVIEWED = 4000
"""Characters of a file that are shown before it is written."""
SECONDS_PREVIEWED = 30.0
"""Of a longer sound, what its beginning becomes is shown."""


class ExportState(StrEnum):
    """What became of a file."""

    WAITING = tr_noop("waiting")
    WORKING = tr_noop("running")
    DONE = tr_noop("done")
    SKIPPED = tr_noop("already done")
    FAILED = tr_noop("failed")
    CANCELLED = tr_noop("cancelled")


@dataclass(frozen=True)
class ExportJob:
    """A sound file and what it becomes.

    Attributes
    ----------
    source, target : the files.
    state : what became of it.
    duration : of the sound, seconds; 0 where it cannot be read.
    words : what went wrong, for people.
    notes : what is odd, for people.
    """

    source: Path
    target: Path
    state: ExportState = ExportState.WAITING
    duration: float = 0.0
    words: str = ""
    notes: tuple[str, ...] = ()


class ExportQueue(QObject):
    """Works through a list of files, many of them on all cores; what fails is said, and the others go on.

    Signals
    -------
    changed : something became of a file.
    finished : all is done, or cancelled.
    previewed : the beginning of what a sound would become, or why it cannot.

    Attributes
    ----------
    jobs : the list.
    progress : how much of the whole list is done, 0..1.
    """

    changed = Signal()
    finished = Signal()
    previewed = Signal(str)

    def __init__(self) -> None:
        super().__init__()
        self.jobs: list[ExportJob] = []
        self.progress = 0.0
        self._numbers: dict[Job, int] = {}
        self._lock, self._is_cancelled = Lock(), False
        self._work = TaskQueue(self._refuse)
        self._preview = TaskQueue(self.previewed.emit)
        self._work.changed.connect(self.changed)
        self._work.idle.connect(self._end)

    @property
    def busy(self) -> bool:
        """Whether files are still to be made."""
        return self._work.busy

    def start(self, targets: dict[Path, Path], order: ExportOrder, folder: Path | None = None) -> None:
        """Turn sounds into the files that they are to become.

        Parameters
        ----------
        targets : the files, by sound.
        order : what they are turned into.
        folder : where all of them go, in which it is noted what was done, so that it is not done twice; None where
            they go beside their sounds.
        """
        self.jobs = [ExportJob(source, target) for source, target in targets.items()]
        self.progress, self._is_cancelled = 0.0, False
        jobs = [Job(source, target) for source, target in targets.items()]
        self._numbers = {job: k for k, job in enumerate(jobs)}
        self._work.submit(lambda progress: self._run(jobs, order, folder, progress))
        self.changed.emit()

    def cancel(self) -> None:
        """End all work; files that are complete stay, and none is left half."""
        self._work.cancel()
        with self._lock:
            self._is_cancelled = True
            for k, job in enumerate(self.jobs):
                if job.state in {ExportState.WAITING, ExportState.WORKING}:
                    self.jobs[k] = replace(job, state=ExportState.CANCELLED)
        self.finished.emit()

    def preview(self, source: Path, order: ExportOrder) -> None:
        """Find what a sound would become, and tell its beginning."""
        self._preview.replace(lambda progress: _beginning_of(source, order, progress), self.previewed.emit)

    def close(self) -> None:
        """End all work."""
        self._work.close(CLOSE_TIMEOUT)
        self._preview.close(CLOSE_TIMEOUT)

    def _refuse(self, sentence: str) -> None:
        """Say of all files that were left why nothing becomes of them."""
        for k, job in enumerate(self.jobs):
            if job.state in {ExportState.WAITING, ExportState.WORKING}:
                self.jobs[k] = replace(job, state=ExportState.FAILED, words=sentence)
        self.finished.emit()

    def _end(self) -> None:
        """Say of files that are left, as after an error of the program, that nothing became of them."""
        self._refuse(tr("stopped by an unexpected error"))

    def _run(self, jobs: list[Job], order: ExportOrder, folder: Path | None, progress: Progress) -> None:
        """Work in a thread of its own."""

        def show(found: BatchProgress) -> bool:
            self.progress = found.share
            for job in found.at_hand:
                self._put(job, state=ExportState.WORKING)
            return progress(found.share)

        if order.speech is not None or order.kind == PICTURES:
            folder = None  # neither a text nor a folder of pictures is a file of which it could be noted
        options = BatchOptions(folder=folder)
        known = with_texts(order, [job.source for job in jobs])
        if order.texts is None and known.texts is not None:
            for job in jobs:
                if not known.texts.knows(job.source):
                    self._put(job, notes=(tr("no text or TextGrid beside the file"),))
        outcomes = run_batch(jobs, work_of(known), options, on_outcome=self._take, on_progress=show)
        if folder is not None:
            write_batch_report(outcomes, folder)

    def _take(self, outcome: Outcome) -> None:
        state, duration = _STATES[outcome.state], outcome.made.duration
        notes = (*self.jobs[self._numbers[outcome.job]].notes, *(note for _, note in outcome.notes))
        self._put(outcome.job, state=state, duration=duration, words=outcome.words, notes=notes)

    def _put(self, job: Job, **known: Any) -> None:
        number = self._numbers[job]
        with self._lock:
            if self._is_cancelled and known.get("state") is ExportState.WORKING:
                return
            self.jobs[number] = replace(self.jobs[number], **known)
        self.changed.emit()


_STATES = {
    JobState.DONE: ExportState.DONE,
    JobState.SKIPPED: ExportState.SKIPPED,
    JobState.FAILED: ExportState.FAILED,
}


def in_the_way(targets: dict[Path, Path], order: ExportOrder, folder: Path | None) -> list[Path]:
    """Return the sounds whose files are there already, and are not known to be what the same order made.

    Of pictures, those whose folder is not empty.

    Parameters
    ----------
    targets, order, folder : as in `ExportQueue.start`.
    """
    if order.kind == PICTURES:
        return [source for source, folder in targets.items() if folder.is_dir() and any(folder.iterdir())]
    jobs = [Job(source, target) for source, target in targets.items() if target.is_file()]
    work = work_of(with_texts(order, [job.source for job in jobs]))
    return [job.source for job in jobs_in_the_way(jobs, work, folder)]


def _beginning_of(source: Path, order: ExportOrder, progress: Progress) -> str:
    if order.kind.startswith("clip-"):
        return tr("Clips have no preview. The Talk page shows the same head.")
    with TemporaryDirectory() as folder:
        order, is_long = with_texts(order, [source]), False
        if order.speech is None:
            with SoundReader(source) as reader:
                is_long = reader.duration > SECONDS_PREVIEWED
        has_words = order.texts is not None and order.texts.knows(source)
        if is_cut := is_long and order.kind in CONVERSIONS and not has_words:
            beginning = Path(folder) / f"{source.stem}.wav"
            save_stretch(source, 0.0, SECONDS_PREVIEWED, beginning, channel=order.channel)
            source, order = beginning, replace(order, channel=Channel.MIX)
        target = Path(folder) / f"{source.stem}{EXPORT_KINDS[order.kind].ending}"
        with work_of(order).opened() as act:
            act(Job(source, target), say_nothing, progress)
        content = target.read_bytes()
    try:
        text = content.decode()
    except UnicodeDecodeError:
        return tr("{target}: {n} bytes of binary data").format(
            target=target.name, n=f"{len(content):,}".replace(",", " ")
        )
    return text[:MOST_PREVIEWED] + ("\n…" if is_cut or len(text) > MOST_PREVIEWED else "")


def sounds_in(paths: Sequence[Path]) -> list[Path]:
    """Return sound files, and those in folders however deep, in order and each once."""
    found: dict[Path, None] = {}
    for path in paths:
        found |= dict.fromkeys(sounds_under(path) if path.is_dir() else [path] if path.is_file() else [])
    return list(found)
