"""Finds words that the term base (docs/terms.toml) says not to use.

``python -m tools.terms [AREA ...]`` lists them, of the areas ``window``, ``german``, ``messages``, ``docs`` and
``code`` (docstrings and comments); without an area all of them. ``python -m tools.terms --glossary`` writes
docs/glossary.md and docs/de/glossary.md from the term base.
"""

import ast
import re
import sys
import tomllib
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from tools.translations.sources import WINDOW, sources_in
from tools.translations.ts_file import read_translations
from tools.trees import nodes_of, tree_of

ROOT = Path(__file__).resolve().parents[1]
TERMS = ROOT / "docs" / "terms.toml"
GLOSSARY = ROOT / "docs" / "glossary.md"
GERMAN_PAGES = ROOT / "docs" / "de"
GLOSSARY_HEAD = """# Glossary

The terms of the window, the command line, the documents and the code, from A to Z. Most are those of signal
processing, machine learning and animation. *In code* gives the name in the source where it differs. *Not* lists words
that are not used for the same thing.

| term | German | in code | meaning | not |
| --- | --- | --- | --- | --- |
"""
GERMAN_GLOSSARY_HEAD = """# Glossar

Die Begriffe des Fensters und dieses Handbuchs von A bis Z, mit den englischen des Fensters, der Befehlszeile und der
Dokumente. *Im Code* nennt den Namen im Quelltext, wo er anders ist. Die Bedeutungen sind englisch.

| Begriff | Englisch | im Code | Bedeutung |
| --- | --- | --- | --- |
"""
OPTIONAL_PARTS = re.compile(r"\([^)]*\)\?|.\?")
"""Of the pattern of a word to avoid: what is left out where the word is shown."""
CODE_SPANS = re.compile(
    r"^```.*?^```|``[^`]+``|`[^`\n]+`|\]\([^)]*\)|<[^>]+>|\{[^}]*\}"
    r"|Phoneme Ear\b|\bear\.(?:c|h|js|wasm|d\.ts)\b|\bear \*",
    re.MULTILINE | re.DOTALL,
)
"""What is a name and no prose: code, addresses of links, tags, placeholders, files and types of the runtime."""
PARAMETER = re.compile(r"^ *\**[a-z_]\w*(?:,\s+\**\w+)* :(?= |$)", re.MULTILINE)
"""The names with which an entry of a docstring begins."""

COMMENT = re.compile(r"(?<![\w\"'])#.*")
"""A comment, or the end of a literal from such a sign on, which is prose as well; to read tokens takes seconds."""
RUNTIME = ROOT / "engine" / "phonemeengine" / "shipping"
C_COMMENT = re.compile(r"/\*.*?\*/|(?<!:)//[^\n]*", re.DOTALL)
COMMENT_OF = dict.fromkeys((".c", ".h", ".cs", ".js", ".ts"), C_COMMENT) | {".gd": re.compile(r"#.*")}
"""The comments of the runtime, by the suffix of a file."""


@dataclass(frozen=True)
class Found:
    """A word that is not used, where it stands, and what to write."""

    file: str
    line: int
    word: str
    write: str
    text: str

    def __str__(self) -> str:
        return f"{self.file}:{self.line}: {self.word!r} (write: {self.write}) in {' '.join(self.text.split())[:90]!r}"


def words_to_avoid(area: str) -> tuple[re.Pattern[str], list[str]]:
    """Return a pattern of the words that are not used in an area, and what to write for each of its groups."""
    base = tomllib.loads(TERMS.read_text("utf-8"))
    if area == "german":
        pairs = [(word, term["german"]) for term in base["term"] for word in term.get("avoid_german", ())]
    else:
        keys = ("avoid", "avoid_in_window") if area == "window" else ("avoid",)
        pairs = [(word, term["english"]) for term in base["term"] for key in keys for word in term.get(key, ())]
        pairs += [(word, group["write"]) for group in base["avoid"] for word in group["words"]]
    # One pattern for all words: the name of the group that matches tells which one it is.
    words = "|".join(f"(?P<word_{k}>{word})" for k, (word, _) in enumerate(pairs))
    return re.compile(rf"(?<![\w.-])(?:{words})(?![\w-])", re.IGNORECASE), [write for _, write in pairs]


def glossary() -> str:
    """Return docs/glossary.md, made from the term base."""
    terms = sorted(tomllib.loads(TERMS.read_text("utf-8"))["term"], key=lambda term: term["english"].casefold())
    return GLOSSARY_HEAD + "".join(_row_of(term) for term in terms)


def german_glossary() -> str:
    """Return docs/de/glossary.md: the terms that have a German one, in its order."""
    terms = [term for term in tomllib.loads(TERMS.read_text("utf-8"))["term"] if "german" in term]
    rows = (
        f"| {term['german']} | {term['english']} | {_code_of(term)} | {term['meaning'].replace('](', '](../')} |\n"
        for term in sorted(terms, key=lambda term: _sorted_by(term["german"]))
    )
    return GERMAN_GLOSSARY_HEAD + "".join(rows)


def _sorted_by(german: str) -> str:
    """Return a term as dictionaries sort it: umlauts as their vowels."""
    return german.casefold().translate(str.maketrans("äöü", "aou"))


def _row_of(term: dict[str, Any]) -> str:
    avoided = ", ".join(OPTIONAL_PARTS.sub("", word) for word in term.get("avoid", ()))
    return f"| {term['english']} | {term.get('german', '')} | {_code_of(term)} | {term['meaning']} | {avoided} |\n"


def _code_of(term: dict[str, Any]) -> str:
    return ", ".join(f"`{name}`" for name in term.get("code", "").split(", ") if name)


def found_in(area: str) -> Iterator[Found]:
    """Yield the words to avoid in the texts of an area."""
    pattern, writes = words_to_avoid(area)
    for file, line, text in AREAS[area]():
        prose = prose_of(text, area)
        for match in pattern.finditer(prose):
            write = writes[int((match.lastgroup or "").removeprefix("word_"))]
            place = line + prose.count("\n", 0, match.start())
            yield Found(file, place, match[0], write, text[max(0, match.start() - 40) : match.end() + 40])


def prose_of(text: str, area: str) -> str:
    """Return a text of the same length in which names in code, links, tags and placeholders are blank."""
    prose = CODE_SPANS.sub(_blank, text)
    return PARAMETER.sub(_blank, prose) if area == "code" else prose


def _blank(match: re.Match[str]) -> str:
    return re.sub(r"[^\n]", " ", match[0])


def window_texts() -> Iterator[tuple[str, int, str]]:
    """Yield the texts of the window."""
    yield from ((source.file, 0, source.text) for source in sources_in().values())


def german_texts() -> Iterator[tuple[str, int, str]]:
    """Yield the German texts of the window, and the German pages of the manual."""
    file = WINDOW / "translations" / "phonemeanalyser_de.ts"
    yield from ((file.name, 0, text) for text in read_translations(file).values())
    yield from _pages(GERMAN_PAGES)


def message_texts() -> Iterator[tuple[str, int, str]]:
    """Yield the literals with more than one word of the program: helps, notes and errors."""
    for path in _modules("phonemeanalyser", "engine/phonemeengine"):
        if path.name == "sentences.py":  # texts to read aloud
            continue
        docstrings = {node.value for node in statements(tree_of(path)) if isinstance(node, ast.Expr)}
        for node in nodes_of(path):
            if not isinstance(node, ast.Constant) or node in docstrings:
                continue
            if isinstance(node.value, str) and " " in node.value:
                yield path.relative_to(ROOT).as_posix(), node.lineno, node.value


def document_texts() -> Iterator[tuple[str, int, str]]:
    """Yield README, CONTRIBUTING and the documentation; not the glossary, which lists the words to avoid."""
    for path in (ROOT / "README.md", ROOT / "CONTRIBUTING.md"):
        yield path.name, 1, path.read_text("utf-8")
    yield from _pages(ROOT / "docs")


def _pages(folder: Path) -> Iterator[tuple[str, int, str]]:
    for path in sorted(folder.glob("*.md")):
        if path.name != GLOSSARY.name:
            yield path.relative_to(ROOT).as_posix(), 1, path.read_text("utf-8")


def code_texts() -> Iterator[tuple[str, int, str]]:
    """Yield docstrings and comments."""
    for path in _modules("engine", "phonemeanalyser", "tools"):
        name = path.relative_to(ROOT).as_posix()
        for line, text in enumerate(path.read_text("utf-8").splitlines(), 1):
            if comment := COMMENT.search(text):
                yield name, line, comment[0]
        # A docstring is any literal that stands as a statement: also those below attributes.
        for node in (node.value for node in statements(tree_of(path)) if isinstance(node, ast.Expr)):
            if isinstance(node, ast.Constant) and isinstance(node.value, str):
                yield name, node.lineno, node.value
    yield from _runtime_comments()


def _runtime_comments() -> Iterator[tuple[str, int, str]]:
    for path in sorted(RUNTIME.rglob("*")):
        if path.suffix in COMMENT_OF:
            source = path.read_text("utf-8")
            for comment in COMMENT_OF[path.suffix].finditer(source):
                yield path.relative_to(ROOT).as_posix(), source.count("\n", 0, comment.start()) + 1, comment[0]


def statements(tree: ast.AST) -> Iterator[ast.stmt]:
    """Yield all statements, of which there are far fewer than nodes."""
    for node in ast.iter_child_nodes(tree):
        if isinstance(node, ast.stmt):
            yield node
        if isinstance(node, ast.stmt | ast.excepthandler | ast.match_case):
            yield from statements(node)


def _modules(*folders: str) -> Iterator[Path]:
    for folder in folders:
        yield from sorted((ROOT / folder).rglob("*.py"))


AREAS: dict[str, Callable[[], Iterator[tuple[str, int, str]]]] = {
    "window": window_texts,
    "german": german_texts,
    "messages": message_texts,
    "docs": document_texts,
    "code": code_texts,
}


def main(areas: list[str]) -> int:
    """List what is found in areas, and return 1 if there is anything; or write the glossaries."""
    if areas == ["--glossary"]:
        GLOSSARY.write_text(glossary(), "utf-8")
        (GERMAN_PAGES / GLOSSARY.name).write_text(german_glossary(), "utf-8")
        return 0
    found = [each for area in areas or AREAS for each in found_in(area)]
    print(*found, f"{len(found)} words to avoid", sep="\n")
    return bool(found)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
