"""Which speakers are left out of one of the two trainings."""

import tomllib
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from pathlib import Path

from phonemeengine.errors import CorpusError
from phonemeengine.storage.files import read_text_file

SHIPPED = Path(__file__).with_name("groups.toml")
"""The groups of the speakers whom the shipped models were trained on."""
LARGEST_FILE = 1 << 20
_DEALT = 3
"""Where no group is known, one of this many speakers is left out."""


@dataclass(frozen=True)
class Groups:
    """Speakers who are left out of one of the two trainings.

    Attributes
    ----------
    validation : those by whom settings are chosen.
    reserved : those who are recognised once, when nothing is chosen any more.
    """

    validation: frozenset[str] = frozenset()
    reserved: frozenset[str] = frozenset()

    @property
    def everybody(self) -> frozenset[str]:
        """All who are left out."""
        return self.validation | self.reserved

    @classmethod
    def of(cls, names: Collection[str], file: Path | None = None) -> "Groups":
        """Return the groups that a file names, of these speakers.

        Parameters
        ----------
        names : of all speakers, as corpus/speaker.
        file : TOML with lists of names, ``validation`` and ``reserved``; None for the shipped one, and where that
            names none of them a third of the speakers for the validation.

        Raises
        ------
        CorpusError : the file cannot be read, or names none of them.
        """
        path = SHIPPED if file is None else file
        try:
            told = tomllib.loads(read_text_file(path, LARGEST_FILE, "groups of speakers", CorpusError))
            validation, reserved = (frozenset(told.get(name, ())) & set(names) for name in ("validation", "reserved"))
        except (tomllib.TOMLDecodeError, TypeError) as error:
            raise CorpusError(
                f"{path.name}: groups are two lists of names in TOML, validation and reserved ({error}); correct it"
            ) from error
        if validation:
            return cls(validation, reserved - validation)
        if file is not None:
            raise CorpusError(
                f"{path.name}: none of its validation speakers is in the folders; name them corpus/speaker"
            )
        return cls(frozenset(folds_of(list(names), _DEALT)[0]))


def folds_of(names: Sequence[str], n_folds: int) -> list[set[str]]:
    """Deal the speakers into groups, the kinds evenly: names that begin alike lie in different ones."""
    ordered = sorted(names)
    return [set(ordered[k::n_folds]) for k in range(n_folds)]
