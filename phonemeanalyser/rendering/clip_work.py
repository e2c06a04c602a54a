"""Clips of sounds: heads that say what is said in them; the work of `preview` and of the window."""

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

from phonemeanalyser.rendering import RenderingError
from phonemeanalyser.rendering.clip import animation_by_rules, sound_track, write_clip
from phonemeanalyser.rendering.clip_options import USUAL_CLIP, ClipOptions
from phonemeanalyser.rendering.surface import subdivided
from phonemeengine import (
    Animation,
    Channel,
    EngineError,
    ExportOptions,
    MorphMesh,
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
from phonemeengine.batch.work import Act, Job, Made, Say
from phonemeengine.conversion.driving import USUAL_DRIVER, DriverChoice, Driving
from phonemeengine.conversion.spoken_texts import NO_TEXTS, SpokenTexts, made_of, open_sound
from phonemeengine.files import printable_name
from phonemeengine.mouth.face_driver import FaceDriver
from phonemeengine.mouth.table import USUAL_TABLE
from phonemeengine.presets.ears import for_files
from phonemeengine.progress import Progress, subrange
from phonemeengine.replacing import Guard, output_path

ANALYSED = 0.2
"""How much of the work at a clip is done when the sound is analysed."""


@dataclass(frozen=True)
class ShownFace:
    """The files of a face; it is the head that ships with the program where there are none.

    Attributes
    ----------
    mesh, movestates : the files.
    """

    mesh: Path | None = None
    movestates: Path | None = None

    def morph_mesh(self) -> MorphMesh:
        """Load it.

        Raises
        ------
        EngineError : it cannot be used.
        """
        if self.mesh is None:
            if self.movestates is not None:
                raise RenderingError(
                    f"{self.movestates.name}: movestates move a mesh of their own; name it with --mesh"
                )
            return load_head()
        face = load_morph_mesh(self.mesh)
        if self.movestates is not None:
            face = MorphMesh(face.mesh, matched(load_morph_targets(self.movestates), face.mesh).states)
        if not face.states:
            words = "there are no morph targets in it; name its movestates with --movestates"
            raise RenderingError(f"{self.mesh.name}: {words}")
        return face


SHIPPED_FACE = ShownFace()


@dataclass(frozen=True)
class ClipWork:
    """Makes clips; work for `run_batch`.

    Attributes
    ----------
    options : how mouths move by rules, and what else faces do.
    preset : what is recognised with, by the best ear that it has for files.
    channel : what is recognised of files of several channels.
    texts : what is said in the sounds.
    driver : what moves the faces.
    faces : what is seen.
    look : of the clips.
    ending : of those that are printed.
    overwrite : whether to replace whatever is there; files that the same work made, as noted, are replaced anyway.
    """

    options: ExportOptions
    preset: Preset
    channel: Channel = Channel.MIX
    texts: SpokenTexts = NO_TEXTS
    driver: DriverChoice = USUAL_DRIVER
    faces: ShownFace = SHIPPED_FACE
    look: ClipOptions = USUAL_CLIP
    ending: str = ""
    overwrite: bool = False

    def fingerprint(self) -> str:
        """Return what tells it from other work."""
        table, options = load_table(self.options.table or USUAL_TABLE), replace(self.options, table=None)
        heard = for_files(self.preset), self.channel
        return fingerprint_of("preview", table, options, heard, self.driver, self.faces, self.look)

    def known_of(self, job: Job) -> str:
        """Return what is said in a sound."""
        return self.texts.known_of(job.sound)

    @contextmanager
    def opened(self) -> Iterator[Act]:
        """Load the face, open what moves it, and give what makes one clip."""
        head = subdivided(self.faces.morph_mesh())
        with self.driver.opened() as driving:
            yield partial(self._make, head, driving)

    def _make(self, head: MorphMesh, driving: Driving, job: Job, say: Say, progress: Progress) -> Made:
        guard = Guard(None, self.overwrite, job.earlier)
        guard.check(job.target)
        driving.say_notes(say)
        with open_sound(job.source, self.channel, say) as reader:
            heard, shown = subrange(progress, 0, ANALYSED), subrange(progress, ANALYSED, 1)
            pitch = self.options.idle.head or driving.recorded is not None
            analyses = analyse_file(reader, self.preset, pitch=pitch, progress=heard)
            utterance, speech = self.texts.said(reader, job.sound, analyses, say)
            animations, captions = self._faces_of(utterance, speech, printable_name(job.source), driving, say)
            with output_path(job.target, self.ending) as path:
                write_clip(path, head, animations, self.look, captions, sound_track(reader), shown, guard)
            return made_of(reader, utterance, self.texts.language)

    def _faces_of(
        self, utterance: Utterance | None, speech: Transcript, name: str, driving: Driving, say: Say
    ) -> tuple[list[Animation], list[str]]:
        """Return how each head moves, and their captions where there are two."""
        drivers = self._drivers_of(utterance, name, driving)
        tracks = [driving.track(driver, utterance, speech, say) for driver in drivers]
        animations = [
            track.animation(speech, self.look.rate, self.options.idle)
            if track
            else animation_by_rules(speech, self.options, self.look.rate)
            for track in tracks
        ]
        return animations, [driving.caption(driver) for driver in drivers] if self.driver.beside else []

    def _drivers_of(self, utterance: Utterance | None, name: str, driving: Driving) -> list[FaceDriver]:
        """Return what moves the first head, and the second one, if there is one."""
        shapes, beside = {*load_table(self.options.table or USUAL_TABLE).movestates}, self.driver.beside
        drivers = [driving.chosen(utterance, name, lambda movestates: shapes <= {*movestates})]
        if beside is not None:
            drivers.append(driving.chosen(utterance, name, driver=beside))
        if len({*drivers}) < len(drivers):
            raise EngineError(
                f"{name}: --beside {beside} would be what moves the first head, too; choose another one, or another "
                "--text-driver"
            )
        return drivers
