"""What a calibrated preset was judged by: figures on speech from which nothing was learned."""

from dataclasses import asdict, dataclass
from datetime import date
from typing import Any

from typing_extensions import override

from phonemeengine.errors import PresetError
from phonemeengine.storage.strict_table import StrictTable


@dataclass(frozen=True)
class Judgement:
    """What a calibration gained on held-out speech.

    Attributes
    ----------
    start : name of the preset that was calibrated.
    day : of the calibration, as in ``2026-11-25``.
    seconds : how much held-out speech was measured.
    cross_validated : whether that was each quarter of the takes in turn, and no speech of its own.
    mouth_shapes : share of frames with the right mouth shape, before and after, 0..1.
    macro_f1 : macro F1 before and after, 0..1.
    changed : whether the preset was changed since, so that the figures are no longer its own.

    Raises
    ------
    PresetError : the day is none.
    """

    start: str
    day: str
    seconds: float
    cross_validated: bool
    mouth_shapes: tuple[float, float]
    macro_f1: tuple[float, float]
    changed: bool = False

    def __post_init__(self) -> None:
        try:
            date.fromisoformat(self.day)
        except ValueError as error:
            raise PresetError(
                f"[judged] day is a date such as 2026-11-25, found {self.day!r:.40}; correct it"
            ) from error

    @override
    def __str__(self) -> str:
        """Return one line for lists of presets."""
        before, after = (f"{100 * share:.0f}" for share in self.mouth_shapes)
        figures = f"mouth shapes {before} to {after} % on held-out speech"
        return f"{self.start}, own voice, {self.day}: {figures}{', changed since' if self.changed else ''}"

    def table(self) -> dict[str, Any]:
        """Return it as a table of a preset file."""
        table = asdict(self)
        if not self.changed:
            del table["changed"]
        return {key: list(value) if isinstance(value, tuple) else value for key, value in table.items()}


def judgement_of(table: StrictTable) -> Judgement:
    """Read it from a table of a preset file; PresetError where it is none."""
    table.check_keys([key for key in Judgement.__dataclass_fields__ if key != "changed"], ["changed"])
    return Judgement(
        table.value("start", str),
        table.value("day", str),
        table.value("seconds", float),
        table.value("cross_validated", bool),
        _pair(table, "mouth_shapes"),
        _pair(table, "macro_f1"),
        table.value("changed", bool, False),
    )


def _pair(table: StrictTable, key: str) -> tuple[float, float]:
    shares = table.numbers(key)
    if len(shares) != 2 or not all(0.0 <= share <= 1.0 for share in shares):
        raise table.refusal(key, "two shares 0..1, before and after", list(shares))
    return shares[0], shares[1]
