"""Whose face it is, the program's own or a mesh of the user's; and a head that says with it what is playing."""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.tasks import CLOSE_TIMEOUT, TaskQueue
from phonemeengine.arrays import Float32Array
from phonemeengine.errors import MeshError
from phonemeengine.mouth.blendshape_names import EYELIDS
from phonemeengine.mouth.files.io import FaceFiles
from phonemeengine.mouth.idle_motion import EYES, Gaze, HeadPose, gaze_weights
from phonemeengine.mouth.morph_mesh import USUAL_HEAD, Head, MorphMesh
from phonemeengine.mouth.movestate import MOST_PERCENT, MovestateSet
from phonemeengine.mouth.performer import IdleMotion, Performer
from phonemeengine.mouth.table import MouthTable, load_table, shipped_tables

MOST_WEIGHT = MOST_PERCENT / 100
HEADS = {Head.WOMAN: tr_noop("Woman"), Head.MAN: tr_noop("Man")}
"""The heads of the program, as people call them."""


class FaceModel(QObject):
    """Loads faces in the background and moves the one that is there.

    Signals
    -------
    changed : another face is there.
    error : a sentence for the user; the face stays as it was.

    Attributes
    ----------
    files : where the face that is there, or is being loaded, comes from.
    morph_mesh, states : None until the first face is loaded.
    tables : the tables of the program that move anything in this face: what people call them, by name.
    held : percentages of its shapes that it holds whatever is said; None while it moves.
    """

    changed = Signal()
    error = Signal(str)

    def __init__(self) -> None:
        super().__init__()
        self.files = FaceFiles()
        self.morph_mesh: MorphMesh | None = None
        self.states: MovestateSet | None = None
        self.tables: dict[str, str] = {}
        self._work = TaskQueue(self._fail)
        self._shown = self.files
        self._asked = False
        self.held: Mapping[str, float] | None = None
        self._table: MouthTable | None = None
        self._columns: list[tuple[int, str]] = []
        self._spoken: dict[str, float] = {}
        self._lids: dict[str, float] = {}
        self._eyes: dict[str, Mapping[str, float]] = {}

    @property
    def busy(self) -> bool:
        """Whether a face is being loaded."""
        return self._work.busy

    @property
    def name(self) -> str:
        """What the face is called."""
        return self._shown.mesh.name if self._shown.mesh and not self.head else tr(HEADS[self.head or USUAL_HEAD])

    @property
    def head(self) -> Head | None:
        """Which head of the program it is, as it is; None for a face of the user's."""
        return self._shown.head

    def wake(self) -> None:
        """Load the face, now that it is in view."""
        if not self._asked:
            self.load(self.files)

    def load(self, files: FaceFiles) -> None:
        """Load a face instead of the one that is there."""
        self._asked = True
        self.files = files
        self._work.replace(lambda _progress: _loaded(files), lambda morph_mesh: self._take(files, morph_mesh))

    def share(self, other: "FaceModel") -> None:
        """Be the same face as another one, and move by itself."""
        if other.morph_mesh is not None:
            self._asked, self.files = True, other.files
            self._take(other._shown, other.morph_mesh)

    def moved_by(self, table: MouthTable) -> tuple[str, ...]:
        """Name the movestates of this face that a table moves."""
        moved = _moved_by(table)
        if table.targets:
            shapes = {name for ours in moved for name in table.targets.get(ours, ())}
            return tuple(mine for k, mine in self._pairs(table) if table.face_names[k] in shapes)
        return tuple(mine for k, mine in self._pairs(table) if table.movestates[k] in moved)

    def fit_of(self, name: str) -> tuple[float, int]:
        """Return which share of the movestates that one of the program's tables moves this face has, and how many."""
        table = load_table(name)
        there = len(self.moved_by(table))
        return there / max(1, len(_moved_by(table))), there

    def refusal_of(self, name: str) -> str:
        """Return the sentence that refuses a table of this name, which moves nothing of the face."""
        names = ", ".join(self.tables)
        told = (
            tr("{name}: the face has none of the blend shapes of this table; choose one of these tables: {names}.")
            if names
            else tr(
                "{name}: the face has none of the blend shapes of this table; write a mouth table for the face "
                "and load it."
            )
        )
        return told.format(name=name, names=names)

    def set_table(self, table: MouthTable) -> None:
        """Move with the weights of another table."""
        if self.states is None:
            return
        self._table, self._columns = table, self._pairs(table)
        targets = table.targets or {name: {name: 100.0} for name in (*EYELIDS, *EYES)}
        mine = {*self.states.names}
        lids = [(name, percent) for lid in EYELIDS for name, percent in targets.get(lid, {}).items() if name in mine]
        self._lids = {name: sum(share for other, share in lids if other == name) for name, _ in lids}
        self._eyes = {eye: targets[eye] for eye in EYES if eye in targets and {*targets[eye]} <= mine}
        for name in mine:  # brows and eyes are the table's here: only blinks have a life of their own
            self.states.set_interactable(name, name not in self._lids)

    def move(self, weights: Float32Array) -> None:
        """Set the movestates of the table by its weights, and all others to 0; a blink goes on."""
        if self.states is not None and self._table is not None:
            shown = self._table.on_face(weights)
            values = (100 * np.clip(shown, -MOST_WEIGHT, MOST_WEIGHT)).tolist()
            self._spoken = {name: values[column] for column, name in self._columns}
            self.states.reset_all()
            lids = self._lids
            self.states.set_percentages({name: value for name, value in self._spoken.items() if name not in lids})

    def blink(self, closure: float) -> None:
        """Close the lids as far as a blink has closed them, 0..1, where what is said does not close them farther."""
        if self.states is not None:
            for lid, percent in self._lids.items():
                self.states.set_percentage(lid, max(percent * closure, self._spoken.get(lid, 0.0)))

    def look(self, weights: Mapping[str, float]) -> None:
        """Turn the eyes by the weights of their movestates, 0..1, where nothing that is said or felt turns them."""
        turned: dict[str, float] = {}
        for eye, shapes in self._eyes.items():
            for name, percent in shapes.items():
                turned[name] = turned.get(name, 0.0) + weights[eye] * percent
        if self.states is not None and not any(self._spoken.get(name) for name in turned):
            self.states.set_percentages(turned)

    def show_held(self) -> None:
        """Show what is held, and nothing else."""
        if self.states is not None and self.held is not None:
            self.states.reset_all(force=True)
            known = {*self.states.names}
            self.states.set_percentages({name: value for name, value in self.held.items() if name in known})

    def positions(self) -> Float32Array:
        """Return where the vertices are now, shape (n_vertices, 3); the array is used again by the next call."""
        assert self.states is not None
        return self.states.morphed()

    def close(self) -> None:
        """End the work."""
        self._work.close(CLOSE_TIMEOUT)

    def _pairs(self, table: MouthTable) -> list[tuple[int, str]]:
        """Return the places of the table's movestates that the face has, and its own names for them."""
        if self.states is None:
            return []
        mine = {_plain(name): name for name in self.states.names}
        return [(k, mine[_plain(name)]) for k, name in enumerate(table.face_names) if _plain(name) in mine]

    def _take(self, files: FaceFiles, morph_mesh: MorphMesh) -> None:
        self._shown = files
        self.morph_mesh, self.states = morph_mesh, MovestateSet(morph_mesh.mesh, morph_mesh.states)
        self.held = None
        known = [(name, load_table(name)) for name in shipped_tables()]
        self.tables = {name: table.name for name, table in known if self.moved_by(table)}
        self.changed.emit()

    def _fail(self, sentence: str) -> None:
        self.files = self._shown
        self.error.emit(sentence)


def _loaded(files: FaceFiles) -> MorphMesh:
    from phonemeanalyser.rendering.materials import with_pixels  # noqa: PLC0415 - no window waits for it

    face = files.load()
    if not face.states:
        sentence = tr("{mesh}: the mesh has no blend shapes; select its .3dm file together with it")
        raise MeshError(sentence.format(mesh=face.mesh.name))
    return replace(face, mesh=with_pixels(face.mesh))


def _plain(name: str) -> str:
    """Return a name without case and punctuation: jawOpen, JawOpen and jaw_open are one."""
    return "".join(filter(str.isalnum, name)).casefold()


LEAST_WEIGHT, LEAST_ANGLE = 0.002, 0.04
"""What is no change that anybody sees: of a weight, and of the head's pose in degrees."""


class MovingHead:
    """Shows on a face what a performer says.

    Attributes
    ----------
    face : that is moved.
    performer : says what is playing.
    pose : how the head is turned.
    revision : another number whenever it looks different.
    caption : what moves it, in words; empty where that goes without saying.
    notes : what it lacks for what is said, a sentence each.
    """

    def __init__(self, face: FaceModel, table: MouthTable, idle: IdleMotion) -> None:
        self.face = face
        self.performer = Performer(table, idle)
        self.pose = HeadPose()
        self.revision = 0
        self.caption = ""
        self.notes: tuple[str, ...] = ()
        self._seen: Float32Array = np.zeros(0, np.float32)
        self._gaze, self._looks = Gaze(idle.seed), idle.blinks
        self._held: Mapping[str, float] | None = None

    def configure(self, table: MouthTable, idle: IdleMotion) -> None:
        """Go on with another table, or with other motion."""
        self.performer.configure(table, idle)
        self._looks = idle.blinks
        self.face.set_table(table)
        self._seen = np.zeros(0, np.float32)

    def move(self, now: float) -> None:
        """Show the face as it is at a time on the performer's clock."""
        if self.face.states is None or self._holds():
            return
        _, weights, closure, pose = self.performer.at(now)
        eyes = gaze_weights(self._gaze.at(now), pose) if self._looks else {}
        look = np.array([*weights, closure, *eyes.values(), pose.yaw, pose.pitch, pose.roll], np.float32)
        if len(look) == len(self._seen):
            change = np.abs(look - self._seen)
            if change[:-3].max() < LEAST_WEIGHT and change[-3:].max() < LEAST_ANGLE:
                return
        self._seen, self.pose = look, pose
        self.face.move(weights)
        self.face.blink(closure)
        if eyes:
            self.face.look(eyes)
        self.revision += 1

    def _holds(self) -> bool:
        """Show what the face holds; says whether it holds anything."""
        if self.face.held != self._held:
            self._held = self.face.held
            self._seen = np.zeros(0, np.float32)
            if self._held is not None:
                self.face.show_held()
                self.revision += 1
        return self._held is not None


def _moved_by(table: MouthTable) -> set[str]:
    return {name for shape in table.shapes.values() for name, percent in shape.items() if percent}
