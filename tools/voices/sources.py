"""Real sentences and words of many languages, out of unpacked Debian packages."""

import gettext
import gzip
import html
import re
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

SKIPPED_FORTUNES = {"ethnic", "sex", "flirt", "men-women", "drugs"}  # coarse


class Sources(NamedTuple):
    """Where the texts of a language come from: patterns of files below the unpacked packages."""

    letters: str  # a regular expression's set, lower case
    prose: tuple[str, ...] = ()
    words: tuple[str, ...] = ()
    rare: str = ""  # a regular expression of letters whose sounds come seldom: words with them are drawn more often


def _catalogues(language: str, *names: str) -> tuple[str, ...]:
    """Patterns of the message catalogues of a language in these packages."""
    return tuple(f"{name}/usr/share/locale/{language}/LC_MESSAGES/*.mo" for name in names)


FORTUNES, GUIDE = "usr/share/games/fortunes", "installation-guide-amd64/usr/share/doc/installation-guide-amd64"
OFFICE = "usr/lib/libreoffice/program/resource/*/LC_MESSAGES/*.mo"
HUNSPELL, DICTIONARY = "usr/share/hunspell", "usr/share/dict"
SOURCES = {
    "en": Sources(
        "a-z", (f"fortunes/{FORTUNES}/*",), (f"wamerican/{DICTIONARY}/american-english",), "sh|ch|oo|p|b|m|u|zh"
    ),
    "ru": Sources(
        "а-яё",
        (f"fortunes-ru/{FORTUNES}/ru/*", f"{GUIDE}/ru/*.html"),
        (f"hunspell-ru/{HUNSPELL}/ru_RU.dic",),
        "ш|ж|ч|щ|у|ю|п|б|м|о",
    ),
    "uk": Sources(
        "а-щьюяіїєґ'",
        (f"libreoffice-l10n-uk/{OFFICE}",),
        (f"hunspell-uk/{HUNSPELL}/uk_UA.dic",),
        "ш|ж|ч|щ|у|ю|п|б|м|о",
    ),
    "pt": Sources(
        "a-zàáâãçéêíóôõúü",
        (f"libreoffice-l10n-pt-br/{OFFICE}", f"{GUIDE}/pt/*.html"),
        (f"wbrazilian/{DICTIONARY}/brazilian",),
        "ch|j|x|u|p|b|m|z",
    ),
    "eo": Sources(
        "a-zĉĝĥĵŝŭ", (f"libreoffice-l10n-eo/{OFFICE}",), (f"wesperanto/{DICTIONARY}/esperanto",), "ŝ|ĵ|ĉ|ĝ|u|p|b|m|o"
    ),
    "ky": Sources(
        "а-яёңөү",
        (
            *_catalogues("ky", "libgtk-3-common", "gimp-data", "gnome-control-center-data", "gnome-panel-data"),
            *_catalogues("ky", "nautilus-data", "iso-codes"),
        ),
        (),
        "ш|ж|ч|у|п|б|м|з",
    ),
    "hi": Sources(
        "\u0900-\u0963", (f"libreoffice-l10n-hi/{OFFICE}",), (f"hunspell-hi/{HUNSPELL}/hi_IN.dic",), "श|ष|ज़|ू|ु|ो|म|ब|प"
    ),
    "mr": Sources("\u0900-\u0963", (f"libreoffice-l10n-mr/{OFFICE}",), (), "श|ष|ू|ु|ो|म|ब|प"),
    "te": Sources(
        "\u0c00-\u0c63",
        (f"libreoffice-l10n-te/{OFFICE}",),
        (f"hunspell-te/{HUNSPELL}/te_IN.dic",),
        "శ|ష|జ|ూ|ు|ొ|మ|బ|ప",
    ),
    "ja": Sources(
        "\u3041-\u3096\u30a1-\u30fa\u30fc\u4e00-\u9fff々", (f"libreoffice-l10n-ja/{OFFICE}", f"{GUIDE}/ja/*.html")
    ),
}
TEXT_PACKAGES = tuple(sorted({p.split("/")[0] for s in SOURCES.values() for p in (*s.prose, *s.words)}))


def blocks(patterns: tuple[str, ...], packages: Path) -> Iterator[str]:
    """Sections of raw text from the files of these patterns, in a fixed order."""
    for pattern in patterns:
        for path in sorted(packages.glob(pattern)):
            if path.is_file():
                yield from _blocks_of(path)


def _blocks_of(path: Path) -> Iterator[str]:
    if path.suffix == ".mo":
        yield from _translations(path)
    elif path.suffix == ".html":
        for paragraph in re.findall(r"<p>(.*?)</p>", _text_of(path), flags=re.DOTALL):
            if not re.search(r"<(code|a|kbd|tt|pre)", paragraph):
                yield html.unescape(re.sub(r"<[^>]+>", "", paragraph))
    elif path.suffix not in (".dat", ".u8") and path.name not in SKIPPED_FORTUNES:
        for cookie in re.split(r"^%.*$", _text_of(path), flags=re.MULTILINE):
            yield re.split(r"\n\s*(?:--|—)", cookie)[0]


def _text_of(path: Path) -> str:
    opened = gzip.open if path.suffix == ".gz" else open
    with opened(path, "rt", encoding="utf-8", errors="replace") as file:
        return file.read()


def _translations(path: Path) -> Iterator[str]:
    """The translated lines of a message catalogue, without marks of shortcuts."""
    with path.open("rb") as file:
        catalogue = gettext.GNUTranslations(file)
    for source, line in sorted(catalogue._catalog.items(), key=str):
        if source and isinstance(line, str):
            yield re.sub(r"\(_\w\)|[_~]", "", line)


def word_lines(patterns: tuple[str, ...], packages: Path) -> Iterator[str]:
    """Words of dictionaries, without the flags that a spelling checker writes behind them."""
    for pattern in patterns:
        for line in _text_of(packages / pattern).splitlines():
            yield line.split("/")[0].strip()
