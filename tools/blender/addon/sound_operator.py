# SPDX-License-Identifier: MIT
"""Speaking a sound: `phonemeanalyser export` tells how the face moves with it."""

import shutil
import subprocess
import tempfile
from pathlib import Path
from typing import Any

import bpy
from bpy.props import StringProperty
from bpy_extras.io_utils import ImportHelper

from phonemeengine.errors import ExportError
from phonemeengine.storage.files import printable_name

from .curves_operator import MovingOperator
from .mouth_tables import checked_toml
from .refusal import chosen_face, chosen_path
from .table_properties import table_of_face
from .tracks import SpokenTrack, read_track

PROGRAM = "phonemeanalyser"
NO_WINDOW = getattr(subprocess, "CREATE_NO_WINDOW", 0)
"""Has Windows open no console for it."""
ENDING = ".curves.json"
"""Of the files that `phonemeanalyser export --format curves-json` writes."""


class LipSyncPreferences(bpy.types.AddonPreferences):
    """Where the program is."""

    bl_idname = __package__

    program: StringProperty(
        name="Program", description="The program phonemeanalyser: its name, or its path", default=PROGRAM
    )

    def draw(self, _context: bpy.types.Context) -> None:
        """Draw the settings."""
        self.layout.prop(self, "program")


class SpeakSound(MovingOperator, bpy.types.Operator, ImportHelper):
    """Have the chosen face speak a sound, and play it: by phonemeanalyser, else by curves JSON beside the sound"""

    bl_idname = "lip_sync.speak_sound"
    bl_label = "Speak This Sound"
    bl_options = {"REGISTER", "UNDO"}

    filter_glob: StringProperty(default="*.wav;*.flac;*.ogg;*.mp3;*.aif;*.aiff", options={"HIDDEN"})

    def act(self, context: bpy.types.Context) -> str:
        """Speak it."""
        sound, face = chosen_path(self), chosen_face(context)
        program = shutil.which(context.preferences.addons[__package__].preferences.program)
        done = self.move(context, _track_of(sound, face, program), printable_name(sound))
        return done + _play(context.scene, sound, self.first)


def _track_of(sound: Path, face: bpy.types.Object, program: str | None) -> SpokenTrack:
    """Return how a face moves with a sound: as the program says, else as the file beside it does."""
    beside = sound.with_suffix(ENDING)
    if program is None:
        if not beside.exists():
            raise ExportError(
                f"{PROGRAM} is not installed, and there is no {printable_name(beside)} beside the sound; name the "
                "program's path in the add-on's preferences, or export that file elsewhere"
            )
        return read_track(beside)
    with tempfile.TemporaryDirectory() as folder:
        written = Path(folder) / beside.name
        command = [program, "export", str(sound), "--format", "curves-json", "-o", str(written)]
        if face.data.lip_sync.shapes:
            table = Path(folder) / "table.toml"
            table.write_text(checked_toml(table_of_face(face)), encoding="utf-8")
            command += ["--table", str(table)]
        _run(command)
        return read_track(written)


def _run(command: list[str]) -> None:
    try:
        ended = subprocess.run(
            command, capture_output=True, text=True, errors="replace", check=False, creationflags=NO_WINDOW
        )
    except OSError as error:
        raise ExportError(f"{command[0]} cannot be run ({error.strerror}); correct its path") from error
    if ended.returncode:
        lines = ended.stderr.strip().splitlines() or ["it says nothing"]
        raise ExportError(f"{PROGRAM}: {lines[-1]}")


def _play(scene: bpy.types.Scene, sound: Path, first: int) -> str:
    """Put a sound into the sequencer, unless it is there; return what there is to say about that."""
    editor = scene.sequence_editor_create()
    strips = editor.strips if hasattr(editor, "strips") else editor.sequences  # the latter before Blender 4.4
    if any(strip.type == "SOUND" and _path_of(strip) == sound and strip.frame_start == first for strip in strips):
        return ""
    channel = max((strip.channel for strip in strips), default=0) + 1
    try:
        strips.new_sound(printable_name(sound), str(sound), channel, first)
    except RuntimeError as error:  # this Blender was built without sound, or cannot read the file
        return f", and the sound cannot be played ({error!s:.80})"
    return ""


def _path_of(strip: Any) -> Path:
    return Path(bpy.path.abspath(strip.sound.filepath))


CLASSES = (LipSyncPreferences, SpeakSound)
