"""What the window makes of sounds: all that the engine converts them to, clips of a head, and reports."""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path

from phonemeanalyser.desktop.language import tr_noop
from phonemeanalyser.rendering.clip_options import USUAL_CLIP, ClipOptions
from phonemeanalyser.reports.page import page_of
from phonemeanalyser.reports.report import Report, ScoredPreset
from phonemeengine.audio.files import SoundReader
from phonemeengine.batch.fingerprint import fingerprint_of
from phonemeengine.batch.work import Act, Job, Made, Say, Work
from phonemeengine.calibration.scores.corpus import read_recordings
from phonemeengine.calibration.scores.evaluation import score
from phonemeengine.conversion.spoken_texts import BESIDE, NO_TEXTS, SpokenTexts
from phonemeengine.conversion.work import CONVERSIONS, ConversionWork
from phonemeengine.execution import Progress
from phonemeengine.labels.files import LABEL_SUFFIXES
from phonemeengine.mouth.exports.exporter import ExportOptions
from phonemeengine.presets.ears import for_files
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import Channel
from phonemeengine.storage.replacing import Guard, write_guarded


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
    overwrite : whether to replace whatever is there, not only what the same order made.
    """

    kind: str
    preset: Preset
    options: ExportOptions
    channel: Channel = Channel.MIX
    texts: SpokenTexts | None = NO_TEXTS
    overwrite: bool = False


@dataclass(frozen=True)
class ExportKind:
    """A kind of file that a sound can be turned into.

    Attributes
    ----------
    words : what it is, for people.
    ending : of its files.
    moves_mouth : whether the order's options say how it is made.
    is_text : whether its beginning tells what it will be.
    has_cues : whether it holds mouth cues, of which one may be too short.
    has_words : whether it may be made of words that are known.
    """

    words: str
    ending: str
    moves_mouth: bool
    is_text: bool = True
    has_cues: bool = False
    has_words: bool = True


def with_texts(order: ExportOrder, sounds: Sequence[Path]) -> ExportOrder:
    """Return an order that knows what is said in some sounds, also where that lies beside them.

    Raises
    ------
    EngineError : a file beside a sound cannot be read.
    """
    texts = order.texts
    if not EXPORT_KINDS[order.kind].has_words:
        texts = NO_TEXTS
    elif texts is None:
        texts = NO_TEXTS.of_script(BESIDE, sounds, lambda _name, _note: None)
    return replace(order, texts=texts)


def work_of(order: ExportOrder) -> Work:
    """Return what makes the files of an order.

    Raises
    ------
    EngineError : a format or a table cannot do what the options say.
    """
    texts = order.texts if order.texts is not None and EXPORT_KINDS[order.kind].has_words else NO_TEXTS
    if order.kind in CONVERSIONS:
        return ConversionWork(
            order.kind, order.preset, order.options, order.channel, texts, overwrite=order.overwrite
        )  # fmt: skip
    if not EXPORT_KINDS[order.kind].moves_mouth:
        return ReportWork(order)
    from phonemeanalyser.rendering.clip import ClipWork, check_clip  # noqa: PLC0415 - no window waits 150 ms for it

    look = USUAL_CLIP if order.options.rate is None else ClipOptions(rate=order.options.rate)
    check_clip(Path("clip" + EXPORT_KINDS[order.kind].ending), look.size)
    return ClipWork(order.options, order.preset, order.channel, texts, look=look, overwrite=order.overwrite)


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
        utterances = read_recordings(job.source, channel=self.order.channel)
        progress(0.1)
        found = score(for_files(self.order.preset), utterances)
        page = page_of(Report(job.source.parent, (ScoredPreset(self.order.preset.name, found),)))
        progress(1.0)
        write_guarded(job.target, [page.encode()], Guard(None, self.order.overwrite, job.earlier))
        return Made(duration)


EXPORT_KINDS: dict[str, ExportKind] = {
    **{
        name: ExportKind(c.words, c.ending, c.moves_mouth, True, c.has_cues, not name.startswith("frames-"))
        for name, c in CONVERSIONS.items()
    },
    "clip-mp4": ExportKind(tr_noop("a clip of the head with its sound"), ".mp4", True, is_text=False),
    "clip-gif": ExportKind(tr_noop("a clip of the head"), ".gif", True, is_text=False),
    "report-html": ExportKind(
        tr_noop("how right it is, by the labels beside it"), ".report.html", False, has_words=False
    ),
}
"""All kinds, by name."""
