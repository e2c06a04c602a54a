"""Which of several tables of recorded faces is used: by its name, who speaks, and the language of what is said."""

from collections.abc import Iterable, Sequence

from phonemeengine.errors import PerformanceError
from phonemeengine.performance.table_file import TableAbout
from phonemeengine.storage.files import printable
from phonemeengine.text.mandarin import TAGS


def chosen_table(tables: Sequence[TableAbout], use: str | None, person: str | None, language: str = "") -> int:
    """Return the place of the one table that is asked for.

    Where several have the name and the person, those of the language count, the nearest of its dialects first; where
    none is of the language, those of no language do.

    Parameters
    ----------
    tables : at least one.
    use : its name; None for any.
    person : who speaks; None for anybody.
    language : of what is said; empty where that is not known.

    Raises
    ------
    PerformanceError : there is none of the name or person, or several are left.
    """
    _check_named(tables, use, person)
    found = [k for k, about in enumerate(tables) if use in {None, about.name} and person in {None, about.person}]
    for near in (str.lower, _tongue):
        spoken = [k for k in found if language and near(tables[k].language) == near(language)]
        if spoken:
            found = spoken
            break
    else:
        found = [k for k in found if not tables[k].language] or found
    if len(found) > 1:
        names = _listed(tables[k].name for k in found)
        raise PerformanceError(
            f"one table moves a face, and there are {names}; name one of them with --use, or a person with --person "
            "and the language of the text with --language"
        )
    return found[0]


def _check_named(tables: Sequence[TableAbout], use: str | None, person: str | None) -> None:
    """Refuse a person or a name that none of the tables has."""
    persons = dict.fromkeys(about.person for about in tables if about.person)
    if person is not None and person not in persons:
        asked = printable(person[:40])
        if not persons:
            raise PerformanceError(
                f"there is no table of {asked!r}, as none says who speaks in it; leave --person out"
            )
        raise PerformanceError(
            f"there is no table of {asked!r}, but of {_listed(persons)}; choose another one with --person"
        )
    names = [about.name for about in tables if person in {None, about.person}]
    if use is not None and use not in names:
        raise PerformanceError(
            f"there is no such table {printable(use[:40])!r}, but {_listed(names)}; choose another one with --use"
        )


def _listed(names: Iterable[str]) -> str:
    return ", ".join(repr(printable(name[:40])) for name in names)


def _tongue(tag: str) -> str:
    """Return a language without its dialect."""
    return "cmn" if tag.lower() in TAGS else tag.lower().partition("-")[0]
