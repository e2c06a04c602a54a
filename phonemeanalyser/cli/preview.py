"""``phonemeanalyser preview``: a head says a sound file, as a film, a .gif, or a folder of pictures.

Two heads say it side by side, in step, where drivers are compared.
"""

import argparse
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path

from phonemeanalyser.cli.arguments import (
    add_batch,
    add_channel,
    add_clip,
    add_ear,
    add_mouth,
    add_overwrite,
    add_preset,
    add_script,
)
from phonemeanalyser.cli.clips import clip_options
from phonemeanalyser.cli.driving import DRIVERS, Driving, add_driver, driving, driving_key, driving_options
from phonemeanalyser.cli.expression import add_expression, idle_of
from phonemeanalyser.cli.jobs import (
    file_preset,
    finish_jobs,
    is_batch,
    jobs_of,
    open_sound,
    share_paths,
)
from phonemeanalyser.cli.output_files import STANDARD_OUTPUT, output_path
from phonemeanalyser.cli.scripts import SpokenTexts, made_of, spoken_texts
from phonemeanalyser.rendering.clip import animation_by_rules, check_clip, sound_track, write_clip
from phonemeanalyser.rendering.clip_options import ClipOptions
from phonemeanalyser.rendering.errors import RenderingError
from phonemeanalyser.rendering.surface import subdivided
from phonemeengine import (
    Animation,
    Channel,
    EngineError,
    ExportOptions,
    MorphMesh,
    MouthTable,
    Preset,
    Transcript,
    Utterance,
    load_head,
    load_morph_mesh,
    load_morph_targets,
    load_table,
    matched,
)
from phonemeengine.analyser import analyse_file
from phonemeengine.batch.fingerprint import fingerprint_of
from phonemeengine.batch.pool import n_cores
from phonemeengine.batch.work import Act, Job, Made, Say
from phonemeengine.files import printable_name
from phonemeengine.mouth.face_driver import FaceDriver
from phonemeengine.mouth.table import USUAL_TABLE, shipped_tables
from phonemeengine.mouth.transcript import transcript_of
from phonemeengine.progress import Progress, subrange
from phonemeengine.replacing import Guard

CLIPS = ("mp4", "gif")
"""What the clips of several sounds are."""
ANALYSED = 0.2
"""How much of the work at a clip is done when the sound is analysed."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what is shown, and how."""
    parser.add_argument("inputs", type=Path, nargs="+", metavar="FILE", help="sound files, or folders of them")
    add_clip(parser)
    parser.add_argument("--format", choices=CLIPS, dest="kind", help=f"of several clips (default: {CLIPS[0]})")
    add_script(parser)
    add_preset(parser)
    add_ear(parser)
    parser.add_argument("--table", default=USUAL_TABLE, metavar="T", help=f"a file, or {', '.join(shipped_tables())}")
    add_mouth(parser)
    add_expression(parser)
    add_driver(parser)
    others = [driver for driver in DRIVERS if driver != FaceDriver.AUTO]
    parser.add_argument("--beside", choices=others, help="a second head beside the first, which this driver moves")
    add_channel(parser)
    parser.add_argument("--mesh", type=Path, metavar="M", help="a face of yours: .obj, .glb, .gltf or .x")
    parser.add_argument("--movestates", type=Path, metavar="F", help="its movestates: .3dm or .3dma")
    add_overwrite(parser)
    add_batch(parser)


def run(options: argparse.Namespace) -> int:
    """Make the clips that the command line asks for; 1 where one could not be made."""
    share_paths(options)
    printed = options.out == STANDARD_OUTPUT
    if options.kind is not None and not is_batch(options.inputs) and not printed:
        options.parser.error("--format is of the clips of several sounds; of a single one, the name of OUT says it")
    kind = options.kind or CLIPS[0]
    check_clip(Path(f"clip.{kind}") if is_batch(options.inputs) or printed else options.out, options.size)
    idle, preset = idle_of(options), file_preset(options.preset, options.ear)
    jobs = jobs_of(options.inputs, options.out, f".{kind}") if is_batch(options.inputs) else _single(options)
    texts, table = spoken_texts(options, [job.source for job in jobs]), load_table(options.table)
    if idle.expression is not None:
        idle.expression.check_fits(table.movestates, table.name)
    by_rules = ExportOptions(anticipation=options.anticipation, table=options.table, idle=idle)
    faces = ShownFace(options.mesh, options.movestates)
    faces.morph_mesh()
    with driving(options, _beside(options)):  # says what it has to say, and refuses what it must
        moved = driving_options(options)
        work = PreviewWork(by_rules, preset, options.channel, texts, moved, faces, clip_options(options), f".{kind}")
        cores = n_cores() if is_batch(options.inputs) else 1
        return finish_jobs(jobs, work, options, cores)


def _single(options: argparse.Namespace) -> list[Job]:
    return [Job(options.inputs[0], None if options.out == STANDARD_OUTPUT else options.out)]


def _beside(options: argparse.Namespace) -> FaceDriver | None:
    return FaceDriver(options.beside) if options.beside else None


@dataclass(frozen=True)
class ShownFace:
    """The files of a face; it is the head that ships with the program where there are none.

    Attributes
    ----------
    mesh, movestates : the files.
    """

    mesh: Path | None
    movestates: Path | None

    def morph_mesh(self) -> MorphMesh:
        """Load it.

        Raises
        ------
        EngineError : it cannot be used.
        """
        return _morph_mesh_of(self.mesh, self.movestates)


@dataclass(frozen=True)
class PreviewWork:
    """Makes clips.

    Attributes
    ----------
    by_rules : how mouths move.
    preset, channel : what is recognised with, and of what.
    texts : what is said in the sounds.
    driving : arguments of what moves the faces.
    faces : what is seen.
    look : of the clips.
    ending : of those that are printed.
    """

    by_rules: ExportOptions
    preset: Preset
    channel: Channel
    texts: SpokenTexts
    driving: argparse.Namespace
    faces: ShownFace
    look: ClipOptions
    ending: str = ""

    def fingerprint(self) -> str:
        """Return what tells it from other work."""
        table, options = load_table(self.by_rules.table or USUAL_TABLE), replace(self.by_rules, table=None)
        moved = driving_key(self.driving)
        return fingerprint_of("preview", table, options, self.preset, self.channel, moved, self.faces, self.look)

    def known_of(self, job: Job) -> str:
        """Return what is said in a sound."""
        return self.texts.known_of(job.sound)

    @contextmanager
    def opened(self) -> Iterator[Act]:
        """Load the face, open what moves it, and give what makes one clip."""
        head = subdivided(self.faces.morph_mesh())
        with driving(self.driving, _beside(self.driving), lambda _name, _note: None) as moved:
            yield lambda job, say, progress: self._preview(job, head, moved, say, progress)

    def _preview(self, job: Job, head: MorphMesh, moved: Driving, say: Say, progress: Progress) -> Made:
        guard = Guard(None, self.driving.overwrite, job.earlier)
        guard.check(job.target)
        with open_sound(job.source, self.channel, say) as reader:
            heard, shown = subrange(progress, 0, ANALYSED), subrange(progress, ANALYSED, 1)
            pitch = self.by_rules.idle.head or moved.performer is not None
            analyses = analyse_file(reader, self.preset, pitch=pitch, progress=heard)
            found = self.texts.aligned(reader, job.sound, analyses, say)
            name = printable_name(job.source)
            utterance, speech = found or (None, transcript_of(analyses, name, reader.duration, job.source))
            animations, captions = self._faces_of(utterance, speech, name, moved, say)
            with output_path(job.target or STANDARD_OUTPUT, self.ending) as path:
                write_clip(path, head, animations, self.look, captions, sound_track(reader), shown, guard)
            return made_of(reader, utterance, self.texts.language)

    def _faces_of(
        self, utterance: Utterance | None, speech: Transcript, name: str, moved: Driving, say: Say
    ) -> tuple[list[Animation], list[str]]:
        """Return how each head moves, and their captions where there are two."""
        beside, idle, rate = _beside(self.driving), self.by_rules.idle, self.look.rate
        drivers = _drivers_of(moved, beside, utterance, name, load_table(self.by_rules.table or USUAL_TABLE))
        tracks = [moved.track(driver, utterance, speech, say=say) for driver in drivers]
        animations = [
            track.animation(speech, rate, idle) if track else animation_by_rules(speech, self.by_rules, rate)
            for track in tracks
        ]
        return animations, [moved.caption(driver) for driver in drivers] if beside else []


def _morph_mesh_of(mesh: Path | None, movestates: Path | None) -> MorphMesh:
    """Return the head that ships with the program, or a mesh with its movestates."""
    if mesh is None:
        if movestates is not None:
            raise RenderingError(f"{movestates.name}: movestates move a mesh of their own; name it with --mesh")
        return load_head()
    morph_mesh = load_morph_mesh(mesh)
    if movestates is not None:
        morph_mesh = MorphMesh(morph_mesh.mesh, matched(load_morph_targets(movestates), morph_mesh.mesh).states)
    if not morph_mesh.states:
        raise RenderingError(f"{mesh.name}: there are no morph targets in it; name its movestates with --movestates")
    return morph_mesh


def _drivers_of(
    moved: Driving, beside: FaceDriver | None, utterance: Utterance | None, name: str, table: MouthTable
) -> list[FaceDriver]:
    """Return what moves the first head, and the second one, if there is one."""
    drivers = [moved.chosen(utterance, name, lambda movestates: {*table.movestates} <= {*movestates})]
    if beside is not None:
        drivers.append(moved.chosen(utterance, name, driver=beside))
    if len({*drivers}) < len(drivers):
        raise EngineError(
            f"{name}: --beside {beside} would be what moves the first head, too; choose another one, or another "
            "--text-driver"
        )
    return drivers
