"""Clips: heads that move, one or several side by side, as a film with sound, a .gif, or a folder of pictures."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw, ImageFont

import phonemeengine
from phonemeanalyser.rendering import RenderingError
from phonemeanalyser.rendering.camera import Camera
from phonemeanalyser.rendering.clip_options import USUAL_CLIP, ClipOptions
from phonemeanalyser.rendering.renderer import OffscreenRenderer, colour_of
from phonemeanalyser.rendering.surface import subdivided
from phonemeanalyser.rendering.video import SoundTrack, why_no_film, why_no_gif, write_film, write_gif, write_pictures
from phonemeengine.analyser import analyse_file
from phonemeengine.arrays import Float32Array, UInt8Array
from phonemeengine.batch.work import Act, Job, Made, Say, fingerprint_of, say_nothing
from phonemeengine.conversion.driving import USUAL_DRIVER, DriverChoice, Driving
from phonemeengine.conversion.options import ConversionOptions
from phonemeengine.conversion.spoken_texts import NO_TEXTS, SpokenTexts, edited_keys, made_of, open_sound
from phonemeengine.execution import Progress, no_progress, report_progress, subrange
from phonemeengine.mouth.animation import FaceDriver, difference_in_words, movement_difference
from phonemeengine.mouth.cues import MOST_ANTICIPATION
from phonemeengine.mouth.files.io import FaceFiles
from phonemeengine.mouth.idle_motion import HeadPose
from phonemeengine.mouth.key_layer import NO_KEYS, KeyLayer
from phonemeengine.mouth.movestate import MovestateSet
from phonemeengine.mouth.table import USUAL_TABLE
from phonemeengine.performance.face_network import sound_of
from phonemeengine.presets.model_choice import for_files
from phonemeengine.settings import SAMPLE_RATE
from phonemeengine.storage.files import printable, printable_name
from phonemeengine.storage.replacing import REPLACING, Guard, guarded_write, output_path

# A mesh that plays an animation, frame by frame.


class AnimationPlayer:
    """Moves a mesh as an animation says; movestates that the mesh lacks are left out.

    Raises
    ------
    RenderingError : the mesh has none of the animation's movestates.
    """

    def __init__(self, morph_mesh: phonemeengine.MorphMesh, animation: phonemeengine.Animation) -> None:
        self._animation = animation
        self._states = MovestateSet(morph_mesh.mesh, morph_mesh.states)
        self._columns = [k for k, name in enumerate(animation.movestates) if name in self._states]
        if not self._columns:
            raise RenderingError(
                f"the mesh has none of the table's movestates {', '.join(animation.movestates[:5])}, ...: it has "
                f"{', '.join(self._states.names[:5]) or 'none at all'}; choose another table, or other movestates"
            )

    def __len__(self) -> int:
        return len(self._animation.weights)

    def scenes(self) -> Iterator[tuple[Float32Array, HeadPose]]:
        """Return the vertices and the pose of each frame; the vertices hold until the next one."""
        names = [self._animation.movestates[k] for k in self._columns]
        percentages = self._animation.weights[:, self._columns] * 100.0
        for row, turn in zip(percentages, self._animation.head.tolist(), strict=True):
            self._states.set_percentages(dict(zip(names, row.tolist(), strict=True)))
            yield self._states.morphed(), HeadPose(*turn)


# Several heads in one picture, side by side, each with a caption below it.

STRIP, LETTERS = 1 / 12, 0.55
"""The height of captions as a share of the picture's, and of their letters as a share of that."""
WIDEST = 0.94
"""The share of a head's width that a caption takes at most; it becomes smaller, and then loses its middle."""
LONGEST, END = 200, 12
"""Characters of a caption, and those that stay of its end, which tells whether a performer is synthetic."""
SMALLEST = 9.0
"""Pixels: smaller letters cannot be read."""
FONTS = (
    "DejaVuSans.ttf",
    "NotoSansCJK-Regular.ttc",
    "wqy-microhei.ttc",
    "DroidSansFallback.ttf",
    "segoeui.ttf",
    "msyh.ttc",
    "Arial Unicode.ttf",
)
"""Of Linux, Windows and macOS, for what the font that Pillow brings lacks: it has the letters of English alone."""
NO_LETTER = "\U0010ffff"

Font = ImageFont.FreeTypeFont | ImageFont.ImageFont


class SideBySide:
    """Puts pictures of heads into one; a head without a caption is the whole picture.

    Parameters
    ----------
    size : width and height of the whole, pixels.
    captions : of the heads, from left to right; none for a single head.
    ink, background : the colours of captions and of what is behind them, as #rrggbb; nothing is behind them where the
        background is None.

    Attributes
    ----------
    head_size : width and height of the picture of each head.
    """

    def __init__(self, size: tuple[int, int], captions: Sequence[str], ink: str, background: str | None) -> None:
        strip = round(size[1] * STRIP) if captions else 0
        self.head_size = (size[0] // max(len(captions), 1), size[1] - strip)
        self._whole = np.array(_sheet(size, background))
        for number, caption in enumerate(captions if strip else ()):
            line = _line_of(caption, (self.head_size[0], strip), ink, background)
            self._whole[-strip:, self._columns(number)] = line

    def picture(self, heads: Sequence[UInt8Array]) -> UInt8Array:
        """Return the whole: uint8, shape (height, width, 3); with a fourth, how opaque it is, without a background.

        Parameters
        ----------
        heads : as many as captions, each of the `head_size`.
        """
        whole = self._whole.copy()
        for number, head in enumerate(heads):
            whole[: self.head_size[1], self._columns(number)] = head
        return whole

    def _columns(self, number: int) -> slice:
        return slice(number * self.head_size[0], (number + 1) * self.head_size[0])


def _sheet(size: tuple[int, int], background: str | None) -> Image.Image:
    return Image.new("RGBA", size) if background is None else Image.new("RGB", size, background)


def _line_of(text: str, size: tuple[int, int], ink: str, background: str | None) -> UInt8Array:
    """Return the picture of a line of text in its middle."""
    image = _sheet(size, background)
    letters, room, middle = max(LETTERS * size[1], 1.0), WIDEST * size[0], (size[0] / 2, size[1] / 2)
    text, name = _with_font(printable(text))
    length = max(_font(name, letters).getlength(text[:LONGEST]), 1.0)
    font = _font(name, max(letters * min(room / length, 1.0), min(letters, SMALLEST)))
    ImageDraw.Draw(image).text(middle, _fitting(text, font, room), ink, font, anchor="mm")
    return np.array(image)


def _with_font(text: str) -> tuple[str, str]:
    """Return a text, and a font of the system that has all its letters; with ? for those that none has."""
    if text.isascii():
        return text, ""
    for name in FONTS:
        with suppress(OSError):
            font = ImageFont.truetype(name, SMALLEST)
            if bytes(font.getmask(NO_LETTER)) not in {bytes(font.getmask(letter)) for letter in {*text}}:
                return text, name
    return text.encode("ascii", "replace").decode(), ""


def _font(name: str, letters: float) -> Font:
    return ImageFont.truetype(name, letters) if name else ImageFont.load_default(letters)


def _fitting(text: str, font: Font, room: float) -> str:
    """Return a text without what is too much of it before its end."""
    if len(text) <= LONGEST and font.getlength(text) <= room:
        return text
    begin, end = text[:LONGEST][:-END], text[-END:]
    while begin and font.getlength(f"{begin}…{end}") > room:
        begin = begin[:-1]
    return f"{begin}…{end}"


ASIDE, ABOVE = 0.22, 0.03
"""Where the camera is, radians: lips that come forwards are seen from a little aside."""
BLOCK = SAMPLE_RATE // 10
"""Samples of the sound that are encoded at a time."""


def check_clip(out: Path, look: ClipOptions) -> None:
    """Refuse a clip that cannot be written, before anything is made of it.

    Raises
    ------
    RenderingError : it has no kind that there is, or another size than films have.
    """
    kind = out.suffix.lower()
    if kind not in {"", ".mp4", ".gif"} and not out.is_dir():
        raise RenderingError(f"{out.name}: a preview is an .mp4, a .gif or a folder; name one of them with -o")
    if kind == ".mp4" and (reason := why_no_film(look.size, transparent=look.transparent)):
        raise RenderingError(reason)


def write_clip(
    out: Path,
    morph_mesh: phonemeengine.MorphMesh,
    animations: Sequence[phonemeengine.Animation],
    options: ClipOptions,
    captions: Sequence[str] = (),
    sound: SoundTrack | None = None,
    progress: Progress = no_progress,
    guard: Guard = REPLACING,
) -> None:
    """Write a clip so that it is there complete, or not at all; a folder of pictures may be left in part.

    Parameters
    ----------
    out : an .mp4, a .gif, or a folder for pictures.
    morph_mesh : whose heads are seen.
    animations : of each head, from left to right; a shorter one stays at its end.
    captions : of each head; none for a single one.
    sound : the sound of a film.
    progress : called with the share that is done, 0..1.
    guard : says whether a film or pictures that are there may be replaced.

    Raises
    ------
    EngineError : the guard keeps what is there.
    RenderingError : the mesh lacks the movestates, it cannot be drawn or written, or a .gif cannot be so long.
    Cancelled : `progress` did not want to go on.
    """
    n_frames = max(len(animation.weights) for animation in animations)
    if out.suffix.lower() == ".gif" and (reason := why_no_gif(n_frames, options.rate)):
        raise RenderingError(reason)
    players = [AnimationPlayer(morph_mesh, animation.held(n_frames)) for animation in animations]
    background = None if options.transparent else options.theme.window
    sheet = SideBySide(options.size, captions, options.theme.text, background)
    with OffscreenRenderer(morph_mesh, sheet.head_size) as offscreen:
        camera = Camera.facing(morph_mesh.mesh, options.framing).orbit(ASIDE, ABOVE)
        fine = out.suffix.lower() != ".mp4" or not offscreen.in_software  # in a film it is hardly seen, and is slow
        heads = _pictures_of(players, partial(offscreen.picture, camera, fine=fine), background, progress)
        _write(out, n_frames, map(sheet.picture, heads), options, sound, guard)


def animation_by_rules(
    speech: phonemeengine.Transcript, options: phonemeengine.ExportOptions, rate: float
) -> phonemeengine.Animation:
    """Return how a face says speech by the shapes of a mouth table, at a rate in frames per second.

    Raises
    ------
    MouthError : the table cannot be used.
    """
    ahead = MOST_ANTICIPATION if options.anticipation is None else options.anticipation
    table = options.style.with_tongue(options.mouth_table(USUAL_TABLE))
    return phonemeengine.animation_of(speech, table, rate, options.idle, anticipation=ahead)


def sound_track(reader: phonemeengine.SoundReader, start: float = 0.0, end: float | None = None) -> SoundTrack:
    """Return the samples of an open sound between two times, seconds; to its end where the second is None."""
    first = round(start * SAMPLE_RATE)
    last = reader.n_samples if end is None else round(end * SAMPLE_RATE)
    return SoundTrack(SAMPLE_RATE, reader.n_channels, _blocks_of(reader, first, last))


def _pictures_of(
    players: Sequence[AnimationPlayer], draw: Callable[..., UInt8Array], background: str | None, progress: Progress
) -> Iterator[list[UInt8Array]]:
    """Take the pictures of all heads, frame by frame."""
    colour = None if background is None else colour_of(background)
    for k, heads in enumerate(zip(*(player.scenes() for player in players), strict=True)):
        report_progress(progress, k / max(1, len(players[0])))
        yield [draw(positions, pose, background=colour, glow=True) for positions, pose in heads]


def _write(
    out: Path,
    n_frames: int,
    pictures: Iterable[UInt8Array],
    options: ClipOptions,
    sound: SoundTrack | None,
    guard: Guard,
) -> None:
    kind = out.suffix.lower()
    if kind not in {".mp4", ".gif"}:
        write_pictures(out, pictures, overwrite=guard.overwrite)
        return
    with guarded_write(out, guard) as file:
        if kind == ".mp4":
            write_film(file, pictures, options.size, options.rate, sound)
        else:
            write_gif(file, pictures, n_frames, options.rate)


def _blocks_of(reader: phonemeengine.SoundReader, first: int, last: int) -> Iterator[Float32Array]:
    reader.seek(first)
    while len(block := reader.read(min(BLOCK, last - reader.position))):
        yield block


# The work of `preview` and of the window: heads that say what is said in sounds.

ANALYSED = 0.2
"""How much of the work at a clip is done when the sound is analysed."""


SHIPPED_FACE = FaceFiles()


def face_of(files: FaceFiles) -> phonemeengine.MorphMesh:
    """Load a face that can be moved.

    Raises
    ------
    EngineError : it cannot be used.
    """
    if files.mesh is None and isinstance(files.movestates, Path):
        raise RenderingError(f"{files.movestates.name}: movestates move a mesh of their own; name it with --mesh")
    face = files.load()
    if files.mesh is not None and not face.states:
        words = "there are no morph targets in it; name its movestates with --movestates"
        raise RenderingError(f"{files.mesh.name}: {words}")
    return face


@dataclass(frozen=True)
class ClipWork:
    """Makes clips; work for `run_batch`.

    Attributes
    ----------
    options : how mouths move by rules, and what else faces do.
    preset : what is recognised with, by the best model that it has for files.
    channel : what is recognised of files of several channels.
    texts : what is said in the sounds.
    driver : what moves the faces.
    faces : what is seen.
    look : of the clips.
    ending : of those that are printed.
    keys : an animator's edits of the movement, by the sound's file; both heads have them.
    overwrite : whether to replace whatever is there; files that the same work made, as noted, are replaced anyway.
    """

    options: phonemeengine.ExportOptions
    preset: phonemeengine.Preset
    channel: phonemeengine.Channel = phonemeengine.Channel.MIX
    texts: SpokenTexts = NO_TEXTS
    driver: DriverChoice = USUAL_DRIVER
    faces: FaceFiles = SHIPPED_FACE
    look: ClipOptions = USUAL_CLIP
    ending: str = ""
    keys: Mapping[Path, KeyLayer] = field(default_factory=dict)
    overwrite: bool = False

    @classmethod
    def of(
        cls,
        options: ConversionOptions,
        preset: phonemeengine.Preset,
        ending: str = "",
        sounds: Sequence[Path] = (),
        say: Say = say_nothing,
    ) -> "ClipWork":
        """Return the work that options ask for.

        Parameters
        ----------
        sounds : that clips are made of.
        say : told what a script does not say of them.

        Raises
        ------
        EngineError : it cannot be done, or a file that the options name cannot be used.
        """
        written = options.written()
        table = written.mouth_table(USUAL_TABLE)
        if written.idle.expression is not None:
            written.idle.expression.check_fits(table.movestates, table.name)
        faces = FaceFiles(options.mesh, options.movestates)
        face_of(faces)
        texts, driver = SpokenTexts.of(options, sounds, say), DriverChoice.of(options)
        by_rules, look = replace(written, mesh=None, rate=None), ClipOptions.of(options)
        keys = edited_keys(options.keys, sounds)
        return cls(by_rules, preset, options.channel, texts, driver, faces, look, ending, keys, options.overwrite)

    def fingerprint(self) -> str:
        """Return what tells it from other work."""
        table, options = self.options.mouth_table(USUAL_TABLE), replace(self.options, table=None)
        recognised = for_files(self.preset), self.channel
        return fingerprint_of("preview", table, options, recognised, self.driver, self.faces, self.look)

    def known_of(self, job: Job) -> str:
        """Return what is said in a sound, and how its movement was edited."""
        return fingerprint_of(self.texts.known_of(job.sound), self.keys.get(job.sound))

    @contextmanager
    def opened(self) -> Iterator[Act]:
        """Load the face, open what moves it, and give what makes one clip."""
        head = subdivided(face_of(self.faces))
        with self.driver.opened(self.texts.language) as driving:
            yield partial(self._make, head, driving)

    def _make(self, head: phonemeengine.MorphMesh, driving: Driving, job: Job, say: Say, progress: Progress) -> Made:
        guard = Guard(None, self.overwrite, job.earlier)
        guard.check(job.target)
        driving.say_notes(say)
        with open_sound(job.source, self.channel, say) as reader:
            analysing, shown = subrange(progress, 0, ANALYSED), subrange(progress, ANALYSED, 1)
            pitch = self.options.idle.head or driving.recorded is not None
            analyses = analyse_file(reader, self.preset, pitch=pitch, progress=analysing)
            utterance, speech = self.texts.said(reader, job.sound, analyses, say, felt=self.options.idle.feels)
            shows = replace(self, options=self.options.felt(*self.texts.text_of(job.sound, utterance)))
            animations, captions = shows._faces_of(utterance, speech, reader, driving, say)
            if self.driver.beside is not None:
                say(
                    printable_name(job.source), difference_in_words(movement_difference(animations[0], animations[1]))
                )
            keys, table = self.keys.get(job.sound, NO_KEYS), self.options.mouth_table(USUAL_TABLE)
            animations = [made.edited(keys).on_face(table) for made in animations]
            with output_path(job.target, self.ending) as path:
                write_clip(path, head, animations, self.look, captions, sound_track(reader), shown, guard)
            return made_of(reader, utterance, self.texts.language)

    def _faces_of(
        self,
        utterance: phonemeengine.Utterance | None,
        speech: phonemeengine.Transcript,
        reader: phonemeengine.SoundReader,
        driving: Driving,
        say: Say,
    ) -> tuple[list[phonemeengine.Animation], list[str]]:
        """Return how each head moves, and their captions where there are two."""
        drivers = self._drivers_of(utterance, printable_name(reader.path), driving)
        tracks = [driving.track(driver, utterance, speech, say, sound=sound_of(reader)) for driver in drivers]
        animations = [
            track.animation(speech, self.look.rate, self.options.idle)
            if track
            else animation_by_rules(speech, self.options, self.look.rate)
            for track in tracks
        ]
        return animations, [driving.caption(driver) for driver in drivers] if self.driver.beside else []

    def _drivers_of(self, utterance: phonemeengine.Utterance | None, name: str, driving: Driving) -> list[FaceDriver]:
        """Return what moves the first head, and the second one, if there is one."""
        shapes, beside = {*self.options.mouth_table(USUAL_TABLE).movestates}, self.driver.beside
        drivers = [driving.chosen(utterance, name, lambda movestates: shapes <= {*movestates})]
        if beside is not None:
            drivers.append(driving.chosen(utterance, name, driver=beside))
        if len({*drivers}) < len(drivers):
            raise phonemeengine.EngineError(
                f"{name}: --beside {beside} would be what moves the first head, too; choose another one, or another "
                "--text-driver"
            )
        return drivers
