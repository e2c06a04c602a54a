"""What the window makes of sounds: all that the engine converts them to, clips of a head, and reports."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from types import ModuleType

from phonemeanalyser.desktop.language import tr_noop
from phonemeanalyser.rendering.clip_options import ClipOptions
from phonemeanalyser.reports.page import page_of
from phonemeanalyser.reports.report import Report, ScoredPreset
from phonemeengine.analyser import analyse_file
from phonemeengine.audio.files import SoundReader
from phonemeengine.batch.conversion_work import ConversionWork
from phonemeengine.batch.fingerprint import fingerprint_of
from phonemeengine.batch.work import Act, Job, Made, Say
from phonemeengine.calibration.scores.corpus import read_recordings
from phonemeengine.calibration.scores.evaluation import score
from phonemeengine.conversion import CONVERSIONS, check_options, convert
from phonemeengine.files import printable_name
from phonemeengine.labels.files import LABEL_SUFFIXES
from phonemeengine.mouth.exports.exporter import ExportOptions
from phonemeengine.mouth.head import load_head
from phonemeengine.mouth.transcript import transcript_of
from phonemeengine.presets.ears import for_files
from phonemeengine.presets.preset import Preset
from phonemeengine.progress import Progress, subrange
from phonemeengine.replacing import Guard, write_guarded
from phonemeengine.settings import Channel

ANALYSED = 0.2
"""How much of the work at a clip is done when the sound is analysed."""


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
    make : makes it of a sound, as another file.
    is_text : whether its beginning tells what it will be.
    has_cues : whether it holds mouth cues, of which one may be too short.
    """

    words: str
    ending: str
    moves_mouth: bool
    make: Callable[[Path, Path, ExportOrder, Progress], None]
    is_text: bool = True
    has_cues: bool = False


def check_order(order: ExportOrder) -> None:
    """Refuse what cannot be done, before any sound is heard.

    Raises
    ------
    EngineError : a format or a table cannot do what the options say.
    """
    if order.kind in CONVERSIONS:
        check_options(order.kind, order.options)
    elif EXPORT_KINDS[order.kind].moves_mouth:
        _clips().check_clip(Path("clip" + EXPORT_KINDS[order.kind].ending), ClipOptions().size)


@dataclass(frozen=True)
class ExportOrderWork:
    """Makes what an order asks for, in processes and batches; work for `run_batch`.

    Attributes
    ----------
    order : what sounds are turned into.
    """

    order: ExportOrder

    def fingerprint(self) -> str:
        """Return what tells it from other work."""
        order = self.order
        if order.kind in CONVERSIONS:
            return self._conversion().fingerprint()
        return fingerprint_of("window", order.kind, for_files(order.preset), order.options, order.channel)

    def known_of(self, job: Job) -> str:
        """Return what the files beside a sound hold by which a report scores it."""
        if self.order.kind not in CONVERSIONS and not EXPORT_KINDS[self.order.kind].moves_mouth:
            return fingerprint_of(*(job.source.with_suffix(suffix) for suffix in LABEL_SUFFIXES))
        return ""

    @contextmanager
    def opened(self) -> Iterator[Act]:
        """Give what makes one file."""
        if self.order.kind in CONVERSIONS:
            with self._conversion().opened() as act:
                yield act
        else:
            yield self._make

    def _conversion(self) -> ConversionWork:
        order = self.order
        return ConversionWork(order.kind, order.preset, order.options, order.channel, order.overwrite)

    def _make(self, job: Job, _say: Say, progress: Progress) -> Made:
        assert job.target is not None
        with SoundReader(job.source, self.order.channel) as reader:
            duration = reader.duration
        order = replace(self.order, overwrite=self.order.overwrite or bool(job.earlier))
        EXPORT_KINDS[order.kind].make(job.source, job.target, order, progress)
        return Made(duration)


def _convert(source: Path, target: Path, order: ExportOrder, progress: Progress) -> None:
    convert(
        source, target, order.kind, order.preset, order.options, channel=order.channel, overwrite=order.overwrite,
        progress=progress,
    )  # fmt: skip


def _clips() -> ModuleType:
    """Return what makes clips: 150 ms that a window should not wait for."""
    import phonemeanalyser.rendering.clip  # noqa: PLC0415

    return phonemeanalyser.rendering.clip


def _make_clip(source: Path, target: Path, order: ExportOrder, progress: Progress) -> None:
    from phonemeanalyser.rendering.surface import subdivided  # noqa: PLC0415 - as below

    guard = Guard(overwrite=order.overwrite)
    clips = _clips()
    look = ClipOptions() if order.options.rate is None else ClipOptions(rate=order.options.rate)
    preset = for_files(order.preset)
    with SoundReader(source, order.channel) as reader:
        analyses = analyse_file(
            reader, preset, pitch=order.options.idle.head, progress=subrange(progress, 0, ANALYSED)
        )
        speech = transcript_of(analyses, printable_name(source), reader.duration, source)
        animation = clips.animation_by_rules(speech, order.options, look.rate)
        shown = subrange(progress, ANALYSED, 1)
        clips.write_clip(
            target, subdivided(load_head()), [animation], look, (), clips.sound_track(reader), shown, guard
        )  # fmt: skip


def _write_report(source: Path, target: Path, order: ExportOrder, progress: Progress) -> None:
    """Score the preset on the labels beside a sound, as the command `score` does."""
    utterances = read_recordings(source, channel=order.channel)
    progress(0.1)
    found = score(for_files(order.preset), utterances)
    page = page_of(Report(source.parent, (ScoredPreset(order.preset.name, found),)))
    progress(1.0)
    write_guarded(target, [page.encode()], Guard(overwrite=order.overwrite))


EXPORT_KINDS: dict[str, ExportKind] = {
    **{
        name: ExportKind(c.words, c.ending, c.moves_mouth, _convert, has_cues=c.has_cues)
        for name, c in CONVERSIONS.items()
    },
    "clip-mp4": ExportKind(tr_noop("a clip of the head with its sound"), ".mp4", True, _make_clip, is_text=False),
    "clip-gif": ExportKind(tr_noop("a clip of the head"), ".gif", True, _make_clip, is_text=False),
    "report-html": ExportKind(
        tr_noop("how right it is, by the labels beside it"), ".report.html", False, _write_report
    ),
}
"""All kinds, by name."""
