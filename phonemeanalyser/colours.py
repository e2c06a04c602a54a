"""The colours of the program, light and dark, as tables: for the window, and for what is written without one."""

from collections.abc import Collection
from colorsys import hls_to_rgb
from dataclasses import dataclass
from itertools import chain, count

from phonemeengine.phonemes import Phoneme


@dataclass(frozen=True)
class Theme:
    """The colours of one look, as #rrggbb."""

    name: str
    window: str
    base: str
    field: str
    raised: str
    text: str
    faint: str
    line: str
    accent: str
    signal: str
    good: str
    bad: str

    @property
    def on_colour(self) -> str:
        """The colour of text that stands on `bad` or `accent`."""
        return "#ffffff" if self.name == "light" else self.base


LIGHT = Theme(
    name="light",
    window="#f3f4f6",
    base="#ffffff",
    field="#ffffff",
    raised="#e6e8ec",
    text="#1c2128",
    faint="#616974",
    line="#c3c8d0",
    accent="#2563c9",
    signal="#1a5fb4",
    good="#1a7742",
    bad="#bd382a",
)
DARK = Theme(
    name="dark",
    window="#1f2228",
    base="#15171c",
    field="#343a45",
    raised="#2c3038",
    text="#e4e7ec",
    faint="#9ba4b1",
    line="#434954",
    accent="#5b9bf5",
    signal="#7cc4ff",
    good="#58c98a",
    bad="#ff7d6d",
)

PHONEME_COLOURS: dict[Phoneme, str] = {
    Phoneme.SILENCE: "#7a828e",
    Phoneme.UNIDENTIFIED: "#4d525b",
    Phoneme.SZ: "#e6c229",
    Phoneme.SCH: "#f0883e",
    Phoneme.M: "#a371f7",
    Phoneme.P: "#db61a2",
    Phoneme.I: "#39c5cf",
    Phoneme.A: "#f85149",
    Phoneme.E: "#3fb950",
    Phoneme.U: "#3f6fd8",
    Phoneme.O: "#58a6ff",
}

CURVE_COLOURS = ("#f0883e", "#3fb950", "#db61a2", "#39c5cf", "#e6c229", "#a371f7", "#f85149")
GOLDEN = 0.618034
"""By which part of a round hues follow each other that are all far apart."""


def free_curve_colour(taken: Collection[str]) -> str:
    """Return a colour, as #rrggbb, that no other curve has."""
    more = (hls_to_rgb(k * GOLDEN % 1, 0.55, 0.6) for k in count())
    written = ("#" + "".join(f"{round(255 * part):02x}" for part in rgb) for rgb in more)
    return next(colour for colour in chain(CURVE_COLOURS, written) if colour not in taken)
