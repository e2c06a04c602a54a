"""All texts of the window go through the translations, which are complete and fit to their sources."""

import ast
import re
from collections.abc import Iterable, Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import QTranslator

from phonemeanalyser.desktop.language import CONTEXT, LANGUAGES, TRANSLATIONS, WRITTEN_IN
from tools.translations.__main__ import compile_translations
from tools.translations.errors import ENGINE, LIST, RENDERING, WITHOUT_WINDOW, errors_in, refused_in
from tools.translations.sources import WINDOW, sources_in, texts_of
from tools.translations.ts_file import read_translations, write_translations
from tools.trees import nodes_of

FILES = [TRANSLATIONS / f"phonemeanalyser_{language}.ts" for language in LANGUAGES if language != WRITTEN_IN]
MODULES = sorted(WINDOW.rglob("*.py"))
SHOWING = {
    "Command",
    "FiguresTable",
    "NumberField",
    "PercentSlider",
    "QAction",
    "QCheckBox",
    "QGroupBox",
    "QLabel",
    "QMenu",
    "QPushButton",
    "QRadioButton",
    "QTableWidgetItem",
    "QToolBar",
    "SegmentList",
    "SpectrumView",
    "_slider",
    "_try",
    "about",
    "addAction",
    "addButton",
    "addItem",
    "addItems",
    "addMenu",
    "addPlot",
    "addRow",
    "addSection",
    "addTab",
    "choice",
    "critical",
    "drawText",
    "draw_text",
    "edit",
    "emit",
    "getExistingDirectory",
    "getItem",
    "getMultiLineText",
    "getOpenFileName",
    "getOpenFileNames",
    "getSaveFileName",
    "getText",
    "heading",
    "information",
    "label",
    "named",
    "offer",
    "question",
    "setAccessibleDescription",
    "setAccessibleName",
    "setHorizontalHeaderLabels",
    "setLabel",
    "setPlaceholderText",
    "setPlainText",
    "setPrefix",
    "setSpecialValueText",
    "setStatusTip",
    "setSuffix",
    "setTabText",
    "setText",
    "setToolTip",
    "setVerticalHeaderLabels",
    "setWhatsThis",
    "setWindowTitle",
    "show_error",
    "show_info",
    "spoken_button",
    "toggle_button",
    "tool_button",
    "warning",
}
"""What is called with something that people read."""
TRANSLATING = {"tr", "tr_noop", "tr_amid", "tr_count", "tr_engine"}
SAME = re.compile(
    r"PhonemeAnalyser|PhonemeData|HOST:PORT|dB|WAV|Praat|TextGrid|mono|stereo|^(Ctrl|Shift|Alt)\+.*|"
    r"^(Space|Escape|Home|End|Delete)$|^(left|bottom)$"
)
"""Names, formats, keys and sides of plots are the same in all languages."""
PLACE = re.compile(r"\{[^}]*\}")
MARKUP = re.compile(r"<[^>]*>|&\w+;|\*?\.\w+")


def untranslated_in(nodes: Iterable[ast.AST]) -> list[str]:
    """Return the literal texts with words that code shows without having them translated, each with its line."""
    found = []
    for node in nodes:
        if isinstance(node, ast.Call) and _shows(_name_of(node.func)):
            for argument in (*node.args, *(keyword.value for keyword in node.keywords)):
                found += [f"{node.lineno}: {text}" for text in _shown_in(argument) if _has_words(text)]
    return found


def walk(code: str) -> list[ast.AST]:
    return [*ast.walk(ast.parse(code))]


def _shows(name: str) -> bool:
    return name in SHOWING or (name.endswith("Error") and name not in {"AttributeError", "KeyError"})


def _shown_in(node: ast.expr) -> Iterator[str]:
    """Yield the literals of an argument that are shown as they are."""
    if isinstance(node, ast.Constant):
        yield from (node.value,) if isinstance(node.value, str) else ()
    elif isinstance(node, ast.JoinedStr):
        yield "".join(str(part.value) if isinstance(part, ast.Constant) else "{}" for part in node.values)
        values = [part.value for part in node.values if isinstance(part, ast.FormattedValue)]
        yield from (text for value in values for text in _shown_in(value))
    elif isinstance(node, ast.IfExp):
        yield from (*_shown_in(node.body), *_shown_in(node.orelse))
    elif isinstance(node, ast.BinOp | ast.BoolOp):
        sides = node.values if isinstance(node, ast.BoolOp) else (node.left, node.right)
        yield from (text for side in sides for text in _shown_in(side))
    elif isinstance(node, ast.List | ast.Tuple | ast.Set):
        yield from (text for element in node.elts for text in _shown_in(element))


def _has_words(text: str) -> bool:
    bare = SAME.sub("", MARKUP.sub("", text))
    return re.search(r"[A-Za-z]{3}", bare) is not None


def _name_of(function: ast.expr) -> str:
    return function.attr if isinstance(function, ast.Attribute) else getattr(function, "id", "")


def test_every_text_that_the_window_shows_is_translated() -> None:
    found = {path.name: untranslated_in(nodes_of(path)) for path in MODULES}
    assert {name: texts for name, texts in found.items() if texts} == {}


def test_what_is_translated_is_a_whole_text_and_its_places_are_named() -> None:
    calls = [node for path in MODULES for node in nodes_of(path) if isinstance(node, ast.Call)]
    translated = [argument for call in calls if _name_of(call.func) in TRANSLATING for argument in call.args]
    assert len(translated) > 1000
    assert [ast.unparse(node) for node in translated if isinstance(node, ast.JoinedStr | ast.BinOp)] == []
    texts = [source.text for source in sources_in().values() if source.file.startswith("phonemeanalyser/desktop")]
    places = [place for text in texts for place in PLACE.findall(text)]
    assert [place for place in places if not re.match(r"\{[a-z]\w*[:}]", place)] == []


def test_a_text_that_is_not_translated_is_found() -> None:
    code = "label.setText('Hello')\nQLabel(f'{n} of them')\nbox.addItem('on' if x else 'off and on', 1)\n"
    assert untranslated_in(walk(code)) == ["1: Hello", "2: {} of them", "3: off and on"]
    assert untranslated_in(walk("label.setText(tr('Hello'))\nbox.setSuffix(' ms')\nprint('Hello')")) == []


def test_texts_are_found_by_the_calls_that_translate_them() -> None:
    code = (
        "A = tr_noop('one')\n"
        "def f(x): return tr('two' if x else 'three'), tr('four', 'a comment'), tr_count('1', 'n', x)\n"
    )
    assert set(texts_of(walk(code))) == {
        ("one", ""),
        ("two", ""),
        ("three", ""),
        ("four", "a comment"),
        ("1", ""),
        ("n", ""),
    }


def test_the_errors_that_the_window_translates_are_those_of_the_engine() -> None:
    assert LIST.read_text("utf-8").splitlines() == [*errors_in()], "run make translations"
    assert len(errors_in()) > 500
    left_out = [RENDERING.parent / name for name in WITHOUT_WINDOW if name.startswith("rendering/")]
    left_out += [ENGINE / name for name in WITHOUT_WINDOW if not name.startswith("rendering/")]
    assert [path for path in left_out if not path.is_file()] == []


def test_an_error_is_found_with_the_words_that_are_put_into_it() -> None:
    code = (
        "fault = 'too short' if x else f'too long by {seconds:.1f} s'\n"
        "raise AudioError(f'{self._name}: it is {fault}, {reason_of(error)}; cut {fault}' + remedy(y))\n"
        "_log.error('not an error of the engine')\n"
        "raise self._error(f'{path.name}: {error}')\n"
        "raise refusal(key, 'a list of words', value)\n"
    )
    assert {*refused_in(walk(code))} == {
        "too short",
        "too long by {seconds} s",
        "{name}: it is {fault}, {error}; cut {fault_2}{y}",
        "{name}: {error}",
        "a list of words",
    }


def test_a_file_of_translations_is_read_as_it_was_written(tmp_path: Path) -> None:
    sources = sources_in()
    known = {key: f"«{source.text}»" for key, source in list(sources.items())[:50]}
    write_translations(tmp_path / "x.ts", "de", sources, known)
    assert read_translations(tmp_path / "x.ts") == {key: known.get(key, "") for key in sources}


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_every_text_has_a_translation_and_no_translation_is_left_over(path: Path) -> None:
    translations = read_translations(path)
    assert set(translations) ^ set(sources_in()) == set()
    assert [text for text, translated in translations.items() if not translated] == []


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_translations_have_the_places_markup_and_ends_of_their_sources(path: Path) -> None:
    for (text, _), translated in read_translations(path).items():
        assert set(PLACE.findall(translated)) == set(PLACE.findall(text)), text
        assert re.findall(r"<[^>]*>", translated) == re.findall(r"<[^>]*>", text), text
        assert translated.count("&") == text.count("&"), text
        for end in ("…", ".", "?", " ", ":"):
            assert translated.endswith(end) == text.endswith(end), (text, translated)
        assert translated[:1].isspace() == text[:1].isspace(), text


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_what_qt_reads_is_as_new_as_its_source(path: Path, tmp_path: Path) -> None:
    shipped, translations = QTranslator(), read_translations(path)
    assert shipped.load(str(path.with_suffix(".qm")))
    assert {key: shipped.translate(CONTEXT, key[0], key[1] or None) for key in translations} == translations
    copy = tmp_path / path.name
    copy.write_bytes(path.read_bytes())
    compile_translations(copy)
    fresh = QTranslator()
    assert fresh.load(str(copy.with_suffix(".qm")))
    assert copy.with_suffix(".qm").stat().st_size == path.with_suffix(".qm").stat().st_size
