"""What the window makes of sounds: all that the engine converts them to, clips of a head, and reports."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from pathlib import Path

from phonemeanalyser.desktop.language import tr_noop
from phonemeanalyser.rendering.clip_options import USUAL_CLIP, ClipOptions
from phonemeengine.audio.files import SoundReader
from phonemeengine.batch.work import Act, Job, Made, Say, Work, fingerprint_of, say_nothing
from phonemeengine.calibration.scores.corpus import read_recordings
from phonemeengine.calibration.scores.evaluation import score
from phonemeengine.conversion.driving import USUAL_DRIVER, DriverChoice
from phonemeengine.conversion.options import FACIAL, WEIGHTED
from phonemeengine.conversion.speech_files import SpeechFiles
from phonemeengine.conversion.spoken_texts import BESIDE, NO_TEXTS, SpokenTexts, edited_keys
from phonemeengine.conversion.work import CONVERSIONS, Conversion, ConversionWork
from phonemeengine.execution import Progress, report_progress
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
