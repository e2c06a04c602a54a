"""What the window makes of sounds: all that the engine converts them to, clips of a head, and reports."""

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
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
from phonemeengine.conversion.kinds import CONVERSIONS
from phonemeengine.conversion.work import ConversionWork
from phonemeengine.labels.files import LABEL_SUFFIXES
from phonemeengine.mouth.exports.exporter import ExportOptions
from phonemeengine.presets.ears import for_files
from phonemeengine.presets.preset import Preset
from phonemeengine.progress import Progress
from phonemeengine.replacing import Guard, write_guarded
from phonemeengine.settings import Channel


@dataclass(frozen=True)
class ExportOrder:
    """What sounds are turned into.

    Attributes
    ----------
    kind : one of `EXPORT_KINDS`.
    preset : what is recognised with.
    options : how mouths move.
    channel : what is recognised of files of several channels.
    overwrite : whether to replace whatever is there, not only what the same order made.
    """

    kind: str
    preset: Preset
    options: ExportOptions
    channel: Channel = Channel.MIX
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
    """

    words: str
    ending: str
    moves_mouth: bool
    is_text: bool = True
    has_cues: bool = False


def work_of(order: ExportOrder) -> Work:
    """Return what makes the files of an order.

    Raises
    ------
    EngineError : a format or a table cannot do what the options say.
    """
    if order.kind in CONVERSIONS:
        return ConversionWork(order.kind, order.preset, order.options, order.channel, overwrite=order.overwrite)
    if not EXPORT_KINDS[order.kind].moves_mouth:
        return ReportWork(order)
    from phonemeanalyser.rendering.clip import check_clip  # noqa: PLC0415 - 150 ms for which no window should wait
    from phonemeanalyser.rendering.clip_work import ClipWork  # noqa: PLC0415

    look = USUAL_CLIP if order.options.rate is None else ClipOptions(rate=order.options.rate)
    check_clip(Path("clip" + EXPORT_KINDS[order.kind].ending), look.size)
    return ClipWork(order.options, order.preset, order.channel, look=look, overwrite=order.overwrite)


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
    **{name: ExportKind(c.words, c.ending, c.moves_mouth, has_cues=c.has_cues) for name, c in CONVERSIONS.items()},
    "clip-mp4": ExportKind(tr_noop("a clip of the head with its sound"), ".mp4", True, is_text=False),
    "clip-gif": ExportKind(tr_noop("a clip of the head"), ".gif", True, is_text=False),
    "report-html": ExportKind(tr_noop("how right it is, by the labels beside it"), ".report.html", False),
}
"""All kinds, by name."""
