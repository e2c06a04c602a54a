"""Every format, by name: how its file ends, who reads it, and what it asks for."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass

from phonemeengine.mouth.blendshape_names import ARKIT, OCULUS
from phonemeengine.mouth.cues import MOST_ANTICIPATION
from phonemeengine.mouth.exports import (
    annosoft,
    audacity,
    curves,
    gltf,
    livelink,
    moho,
    oculus,
    openface,
    papagayo,
    rhubarb,
    textgrid,
    viseme_events,
)
from phonemeengine.mouth.exports.export import Export
from phonemeengine.storage.files import Owns

DRAWINGS_AHEAD = 0.04
"""Seconds by which drawings, which change at once, are ahead of the sound: a frame of film."""


@dataclass(frozen=True)
class Format:
    """A kind of file.

    Attributes
    ----------
    ending : of its files, such as ``.tsv``.
    write : gives the file, in parts of text or as bytes.
    table : the mouth table that it is written with, unless told otherwise.
    words : what it is, for people.
    rate : frames per second, unless told otherwise; 0 where it counts none.
    whole_rate : whether that must be a whole number.
    steps : times that a second has, where they are rounded; 0 where they are not.
    anticipation : by how much the mouth is ahead of the sound, seconds, unless told otherwise.
    shapes : the mouth shapes that it knows; empty where it takes any.
    movestates : the columns that it has; empty where it takes any.
    separated : whether names of shapes may hold no spaces.
    has_cues : whether it holds cues; else the movement of a face alone, in which no sound is too short.
    moves_head : whether it holds the pose of the head.
    moves_mesh : whether it holds a face that it moves.
    mark : stands before the ending of files that are named by the program, where several formats end alike.
    owns : says which files the format wrote; None where those of another program look alike.
    """

    ending: str
    write: Callable[[Export], Iterator[str] | bytes]
    table: str
    words: str
    rate: float = 0.0
    whole_rate: bool = False
    steps: int = 0
    anticipation: float = 0.0
    shapes: frozenset[str] = frozenset()
    movestates: tuple[str, ...] = ()
    separated: bool = False
    has_cues: bool = True
    moves_head: bool = False
    moves_mesh: bool = False
    mark: str = ""
    owns: Owns | None = None

    @property
    def full_ending(self) -> str:
        """The ending of files that the program names, such as ``.livelink.csv``."""
        return f"{self.mark}{self.ending}"


def formats_for(name: str) -> list[str]:
    """Return the formats whose files end as a name does, such as ``x.livelink.csv`` or ``x.csv``."""
    name = name.lower()
    whole = [kind for kind, form in FORMATS.items() if form.mark and name.endswith(form.full_ending.lower())]
    return whole or [kind for kind, form in FORMATS.items() if name.endswith(form.ending.lower())]


def _letters(ending: str, write: Callable[[Export], Iterator[str]], owns: Owns | None = None) -> Format:
    return Format(
        ending,
        write,
        "rhubarb",
        "Rhubarb Lip Sync",
        anticipation=DRAWINGS_AHEAD,
        shapes=rhubarb.SHAPES,
        mark=".rhubarb",
        owns=owns,
        steps=rhubarb.STEPS,
    )


FORMATS: dict[str, Format] = {
    "rhubarb-tsv": _letters(".tsv", rhubarb.write_tsv),
    "rhubarb-xml": _letters(".xml", rhubarb.write_xml, rhubarb.owns_xml),
    "rhubarb-json": _letters(".json", rhubarb.write_json, rhubarb.owns_json),
    "moho-dat": Format(
        ".dat",
        moho.write,
        "preston-blair",
        "Moho, OpenToonz",
        rate=24,
        anticipation=DRAWINGS_AHEAD,
        separated=True,
        mark=".moho",
    ),
    "papagayo-pgo": Format(
        ".pgo",
        papagayo.write,
        "preston-blair",
        "Papagayo, Papagayo-NG",
        rate=24,
        whole_rate=True,
        anticipation=DRAWINGS_AHEAD,
        separated=True,
    ),
    "anno": Format(".anno", annosoft.write, "annosoft", "Annosoft", separated=True, steps=annosoft.STEPS),
    "azure-json": Format(
        ".json", viseme_events.write_azure, "azure", "Azure Speech", shapes=viseme_events.AZURE_VISEMES, mark=".azure"
    ),
    "polly-marks": Format(
        ".marks",
        viseme_events.write_polly,
        "polly",
        "Amazon Polly",
        steps=viseme_events.MILLISECONDS,
        shapes=viseme_events.POLLY_VISEMES,
    ),
    "textgrid": Format(".TextGrid", textgrid.write, "eleven", "Praat", mark=".mouth", owns=textgrid.owns),
    "audacity": Format(".txt", audacity.write, "eleven", "Audacity label track", mark=".mouth"),
    "livelink-csv": Format(
        ".csv",
        livelink.write,
        "arkit",
        "Live Link Face, ARKit 52",
        rate=60,
        anticipation=MOST_ANTICIPATION,
        movestates=ARKIT,
        has_cues=False,
        moves_head=True,
        mark=".livelink",
        owns=livelink.owns,
    ),
    "oculus-csv": Format(
        ".csv",
        oculus.write,
        "oculus",
        "weights of 15 visemes",
        rate=60,
        anticipation=MOST_ANTICIPATION,
        movestates=OCULUS,
        has_cues=False,
        mark=".oculus",
        owns=oculus.owns,
    ),
    "openface-csv": Format(
        ".csv",
        openface.write,
        "arkit",
        "action units (FACS), as OpenFace has them",
        rate=60,
        anticipation=MOST_ANTICIPATION,
        movestates=ARKIT,
        has_cues=False,
        moves_head=True,
        mark=".openface",
        owns=openface.owns,
    ),
    "gltf": Format(
        ".glb",
        gltf.write,
        "arkit",
        "the default head or a custom face",
        rate=30,
        anticipation=MOST_ANTICIPATION,
        has_cues=False,
        moves_head=True,
        moves_mesh=True,
        owns=gltf.owns,
    ),
    "curves-json": Format(
        ".json",
        curves.write,
        "arkit",
        "curves for Unity, Godot and web pages",
        rate=60,
        anticipation=MOST_ANTICIPATION,
        moves_head=True,
        mark=".curves",
        owns=curves.owns,
    ),
}
"""What can be written."""
