"""Finds the sentences with which the engine refuses something, so that the window can show them in its language.

They are read from the engine's sources: what is given to an error, or to one of the methods that make one.
"""

import ast
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path

from tools.trees import nodes_of

ROOT = Path(__file__).resolve().parents[2]
ENGINE = ROOT / "engine" / "phonemeengine"
RENDERING = ROOT / "phonemeanalyser" / "rendering"
LIST = ROOT / "phonemeanalyser" / "desktop" / "engine_errors.txt"
"""The sentences with named places, one a line, which the window reads."""
WITHOUT_WINDOW = {
    "alignment/growing.py",
    "audio/incoming.py",
    "audio/wav.py",
    "batch/cluster.py",
    "batch/remote.py",
    "calibration/scores/added_noise.py",
    "calibration/scores/comparison.py",
    "conversion/option.py",
    "conversion/options.py",
    "encoder/graph.py",
    "performance/corpus.py",
    "performance/face_track.py",
    "performance/gltf_face.py",
    "performance/making.py",
    "recognition/plug_ins.py",
    "rendering/clip.py",
    "rendering/video.py",
    "speech/pinyin/spring.py",
}
"""Modules whose errors only users of the command line, the API or the server meet."""
MAKERS = {"__init__", "_damage", "_error", "_refusal", "_refuse", "check_range", "error", "refusal"}
"""What makes an error of its texts, beside the errors themselves."""
NO_SENTENCE = {"FileNotFoundError", "KeyError"}
_PLACE = re.compile(r"\{\w+\}")
_FORMAT = re.compile(r"phonemeanalyser [\w ]+")
"""With what files of the program begin."""


@cache
def errors_in(folders: tuple[Path, ...] = (ENGINE, RENDERING)) -> dict[str, Path]:
    """Return all sentences, and the parts that are put into them, each with the module where it is found first.

    Those with more letters of their own come first: a text is matched with them in this order.
    """
    found: dict[str, tuple[str, Path]] = {}
    for folder in folders:
        for path in sorted(folder.rglob("*.py")):
            if path.relative_to(folder.parent).as_posix().removeprefix("phonemeengine/") not in WITHOUT_WINDOW:
                for text in refused_in(nodes_of(path)):
                    found.setdefault(_PLACE.sub("{}", text), (text, path))  # places may be called otherwise
    return dict(sorted(found.values(), key=lambda entry: (-len(_PLACE.sub("", entry[0])), entry[0])))


def refused_in(nodes: list[ast.AST]) -> Iterator[str]:
    """Yield the texts of the errors of a module, then the parts that its variables and functions put into them."""
    put_in = {"failure"}
    for node in nodes:
        if isinstance(node, ast.Call) and _makes_error(node):
            for argument in (*node.args, *(keyword.value for keyword in node.keywords)):
                yield from filter(_is_sentence, _texts(argument))
                put_in |= {*_names_in(argument)}
    for node in nodes:
        if isinstance(node, ast.Assign | ast.NamedExpr) and put_in & {*_names_set(node)}:
            yield from filter(_is_sentence, _texts(node.value))
        elif isinstance(node, ast.FunctionDef) and node.name in put_in:
            returned = (part.value for part in ast.walk(node) if isinstance(part, ast.Return) and part.value)
            yield from (text for value in returned for text in filter(_is_sentence, _texts(value)))


def _makes_error(node: ast.Call) -> bool:
    name = node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "")
    of_logs = isinstance(node.func, ast.Attribute) and getattr(node.func.value, "id", "").lower().endswith("log")
    return (name in MAKERS or (name.endswith("Error") and name not in NO_SENTENCE)) and not of_logs


def _names_in(node: ast.expr) -> Iterator[str]:
    for part in ast.walk(node):
        if isinstance(part, ast.Name | ast.Attribute):
            yield part.id if isinstance(part, ast.Name) else part.attr


def _names_set(node: ast.Assign | ast.NamedExpr) -> Iterator[str]:
    for target in node.targets if isinstance(node, ast.Assign) else [node.target]:
        yield from _names_in(target)


def _is_sentence(text: str) -> bool:
    """Whether a text has words of its own, or is a name before what another one says."""
    words = _PLACE.sub("", text)
    if text != text.strip() or text[:1] in ",;." or "\n" in text or _FORMAT.fullmatch(text):
        return False
    is_prefix = re.fullmatch(r"\{\w+\}: \{\w+\}", text) is not None
    return is_prefix or (" " in words.strip() and re.search("[A-Za-z]{3}", words) is not None)


def _texts(node: ast.expr) -> list[str]:
    """Return what an expression can be as text, with named places: several where it chooses, or lists them."""
    match node:
        case ast.Constant(value=str(text)):
            return [text]
        case ast.JoinedStr():
            values = [part.value for part in node.values if isinstance(part, ast.FormattedValue)]
            return [_with_places(node), *(text for value in values for text in _texts(value))]
        case ast.BinOp(op=ast.Add()):
            return [left + right for left in _part_of(node.left) for right in _part_of(node.right)]
    among = {ast.IfExp: ("body", "orelse"), ast.BoolOp: ("values",), ast.Tuple: ("elts",), ast.List: ("elts",)}
    among |= {ast.Set: ("elts",), ast.Dict: ("values",)}
    found = [getattr(node, field) for field in among.get(type(node), ())]
    return [text for one in found for value in (one if isinstance(one, list) else [one]) for text in _texts(value)]


def _part_of(node: ast.expr) -> list[str]:
    """Return what a part of a sum can be: a place, where it is no text."""
    return _texts(node) or ["{" + _place_name(node) + "}"]


def _with_places(node: ast.JoinedStr) -> str:
    taken: list[str] = []
    words = ""
    for part in node.values:
        if isinstance(part, ast.FormattedValue):
            name = _place_name(part.value)
            taken.append(name)
            words += "{" + (name if taken.count(name) == 1 else f"{name}_{taken.count(name)}") + "}"
        elif isinstance(part, ast.Constant):
            words += str(part.value)
    return words


def _place_name(node: ast.expr) -> str:
    """Return how a translator sees a value that is put in: by the last name in it."""
    names = [*_names_in(node)]
    name = names[0] if names and not isinstance(node, ast.Call) else names[-1] if names else "value"
    return name.strip("_").lower()
