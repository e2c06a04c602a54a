"""The window speaks the language of the system, or the one that is chosen, wholly."""

import ast
import re
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QLocale, QSettings
from PySide6.QtGui import QAction, QKeySequence
from PySide6.QtWidgets import QApplication, QDialogButtonBox, QDoubleSpinBox, QSpinBox
from pytestqt.qtbot import QtBot

from phonemeanalyser.desktop.analyse.lanes.label_dialogs import TiersDialog
from phonemeanalyser.desktop.analyse.recognition.preset_choice import EncoderDialog
from phonemeanalyser.desktop.analyse.recognition.variable_panel import VariableDialog
from phonemeanalyser.desktop.app import Desktop
from phonemeanalyser.desktop.calibrate.page import MappingDialog
from phonemeanalyser.desktop.engine_errors import ERRORS
from phonemeanalyser.desktop.engine_words import SENTENCES, SPOKEN, sound_name, tr_engine, tr_sentence
from phonemeanalyser.desktop.language import LANGUAGES as LANGUAGES_OF_WINDOW
from phonemeanalyser.desktop.language import TRANSLATIONS, language_of, tr, tr_amid, tr_count, use_language
from phonemeanalyser.desktop.session.sources import SourceKind
from phonemeanalyser.desktop.talk.words.text_panel import short_name
from phonemeanalyser.desktop.talk.words.voice_model import installed
from phonemeengine.audio.files import SoundReader
from phonemeengine.audio.output import ClockOutput
from phonemeengine.audio.tone import ToneKind
from phonemeengine.calibration.takes.project import TakeProject
from phonemeengine.calibration.takes.quality import Fault, check_take
from phonemeengine.calibration.takes.sentences import LANGUAGES
from phonemeengine.conversion.work import CONVERSIONS
from phonemeengine.dsp.sonagram import FrequencyAxis
from phonemeengine.errors import EngineError
from phonemeengine.features.variables import BUILT_IN_NAMES, Kind, Spectrum, Variable, unit_of
from phonemeengine.inspection.averaged_spectrum import load_averaged_spectrum
from phonemeengine.labels.files import read_labels
from phonemeengine.labels.utterance import LabelUnit
from phonemeengine.mouth.animation import FaceDriver
from phonemeengine.mouth.expression.streams import expression_presets, load_expressions
from phonemeengine.mouth.files.io import load_morph_mesh, load_morph_targets
from phonemeengine.mouth.osc import OscAddress
from phonemeengine.mouth.table import load_table, shipped_tables
from phonemeengine.performance.table_file import PerformanceTable
from phonemeengine.performance.units import UnitKind
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.controls import controls_of
from phonemeengine.presets.files import FACTORY_PRESETS, load_preset, preset_entries
from phonemeengine.recognition.spec import recogniser_names, recogniser_of
from phonemeengine.settings import STAGES
from phonemeengine.text.lexicon import load_lexicon
from tests.conftest import ROOT
from tests.desktop.hands import shown
from tests.desktop.studio import DESK, Studio
from tests.desktop.texts import texts_of
from tests.fakes.microphones import HandDrivenMicrophone
from tests.sounds import silence, vowel
from tools.translations.ts_file import read_translations

ENGINE = ROOT / "engine" / "phonemeengine"
PROGRAM = ROOT / "phonemeanalyser"
NO_TIERS = 'File type = "ooTextFile"\nObject class = "TextGrid"\n\n0\n1\n<exists>\n0\n'
"""A TextGrid without tiers."""
GERMAN = read_translations(TRANSLATIONS / "phonemeanalyser_de.ts")
SAME = {
    "Transparent (GIF, PNG)",
    "Decoder",
    "bilabial",
    "dental",
    "labiodental",
    "labiovelar",
    "lateral",
    "neutral",
    "Amplitude",
    "Analyse",
    "Attack",
    "Auto",
    "Detail",
    "Esc",
    "Export",
    "Format",
    "Gain",
    "Live",
    "Median",
    "Mel",
    "Minimum",
    "Mix",
    "Mono",
    "Name",
    "Neutral",
    "Pause",
    "PhonemeData",
    "Preset",
    "Presets",
    "Encoder",
    "Offline",
    "Rate",
    "Release",
    "Return",
    "Start",
    "Status",
    "Takes",
    "Text - Learned[*] - PhonemeAnalyser",
    "Text",
    "Variable",
    "Variable:",
    "linear",
    "max",
    "mel",
    "min",
    "dBFS",
}
"""Words that are the same in both languages."""
NAMES = re.compile(
    r"Amazon Polly|Annosoft|ARKit|Azure Speech|Live Link|Moho|Oculus 15|Papagayo|"
    r"Praat( \(|$)|Preston Blair|Rhubarb|VRM|Whisper|HOST:PORT|my-voice|Bartlett|"
    r"Hann|Hamming|Blackman|viridis|inferno|magma|plasma|cividis|[A-Z]+$|F\d+$|speech\.|.*[/\\]|"
    r"[a-zA-Z]+ \d+(, [a-zA-Z]+ \d+)*$"
)
"""Programs, inventors, colour maps and files have the same names everywhere."""
ENGLISH = re.compile(r"\b(the|of|and|with|is|are|not|from|this|that|what|which)\b")
"""Words that no German text has."""


@pytest.fixture
def open_window(qapp: QApplication, settings: QSettings, tmp_path: Path) -> Iterator[Callable[[str], Desktop]]:
    """Opens windows in a language, without a microphone."""
    opened: list[Desktop] = []
    microphones = [HandDrivenMicrophone(name=DESK.label)]

    def open_window(language: str) -> Desktop:
        settings.setValue("language", language)
        opened.append(Desktop(qapp, settings, lambda _n: ClockOutput(), Studio(tmp_path, *microphones).model))
        return opened[-1]

    yield open_window
    for desktop in opened:
        desktop.close()
    use_language(qapp, "en")


def texts_in(desktop: Desktop, sound: Path, qtbot: QtBot) -> set[str]:
    """Return the texts of all pages, sources and dialogs."""
    window, session = desktop.window, desktop.session
    shown(desktop, qtbot)
    session.open(sound)
    found: set[str] = set()
    for page in range(3):
        window.show_page(page)
        window.redraw.refresh_all()
        found |= texts_of(window)
    for source in SourceKind:
        session.set_source(source)
        window.redraw.refresh_all()
        found |= texts_of(window)
    desktop.calibration.guide.choose("english", by_sounds=True)
    window.show_shortcuts()
    window.show_manual()
    window.dialogs.show_export([sound])
    others = (
        VariableDialog(100, 200, lambda _variable: None, window),
        TiersDialog(session.labels, window),
        MappingDialog({"aa": 3}, window),
        EncoderDialog(window.files, window),
    )
    found |= texts_of(window)
    for dialog in others:
        dialog.done(0)
    return found


def names_of_others() -> set[str]:
    """Return the names that are the same in all languages, since they stand in files."""
    named = {*BUILT_IN_NAMES, *recogniser_names(), *shipped_tables()}
    for path in FACTORY_PRESETS:
        preset = load_preset(path)
        named |= {path.stem, preset.name, f"{preset.name} ▾", f"A: {preset.name}"}
        for group in controls_of(preset, recogniser_of(preset.recogniser, preset.config)):
            named |= {group.title} if group.title in BUILT_IN_NAMES else set()
            named |= {name for control in group.controls for name in (control.name, control.label)}
    return (
        named
        | set(installed().voices)
        | {short_name(language.name) for language in installed().languages} - set(SPOKEN)
    )


@pytest.fixture
def spoken(qapp: QApplication) -> Iterator[Callable[[str], None]]:
    """Chooses a language without a window."""
    yield lambda language: use_language(qapp, language)
    use_language(qapp, "en")


def test_no_text_of_the_german_window_is_english(
    open_window: Callable[[str], Desktop], sound: Path, qtbot: QtBot
) -> None:
    found = {language: texts_in(open_window(language), sound, qtbot) for language in ("en", "de")}
    both = {text for text in found["en"] & found["de"] if re.search(r"[A-Za-z]{3}", text)}
    assert len(found["de"]) > 900
    assert {text for text in both - SAME - names_of_others() if not NAMES.match(text)} == set()
    told = {text.replace(str(sound.parent), "") for text in found["de"]}
    assert {text for text in told if ENGLISH.search(text)} == set()


def test_the_menu_changes_the_language_at_once_and_for_the_next_start_and_what_was_chosen_stays(
    open_window: Callable[[str], Desktop], settings: QSettings, qtbot: QtBot
) -> None:
    desktop = open_window("en")
    shown(desktop, qtbot)
    desktop.window.show_page(1)
    language_entry(desktop, "Language: Deutsch").trigger()
    assert titles_of(desktop)[0] == "&Datei"
    assert [button.text() for button in desktop.window.switch.buttons] == ["Analysieren", "Kalibrieren", "Sprechen"]
    assert desktop.window.pages.currentIndex() == 1
    assert language_entry(desktop, "Sprache: Deutsch").isChecked()
    assert settings.value("language") == "de"
    sonagram = desktop.window.analysis.sonagram
    sonagram.axis.setCurrentIndex(sonagram.axis.findText("logarithmisch"))
    sonagram.colours.setCurrentIndex(sonagram.colours.findText("grau"))
    language_entry(desktop, "Sprache: English").trigger()
    assert titles_of(desktop)[0] == "&File"
    sonagram = desktop.window.analysis.sonagram
    assert (sonagram.axis.currentText(), sonagram.colours.currentText()) == ("logarithmic", "grey")


def titles_of(desktop: Desktop) -> list[str]:
    return [action.text() for action in desktop.window.menuBar().actions()]


def language_entry(desktop: Desktop, text: str) -> QAction:
    return next(action for action in desktop.window.findChildren(QAction) if action.text() == text)


@pytest.mark.parametrize(
    ("system", "language"), [("de_DE", "de"), ("de_CH", "de"), ("en_GB", "en"), ("fr_FR", "en"), ("C", "en")]
)
def test_the_language_is_the_systems_unless_another_is_chosen(system: str, language: str) -> None:
    assert language_of("system", QLocale(system)) == language
    assert language_of("de", QLocale(system)) == "de"
    assert language_of("en", QLocale(system)) == "en"
    assert language_of("klingon", QLocale(system)) == language


def test_each_file_of_translations_is_a_language_by_its_own_name() -> None:
    codes = {path.stem.partition("_")[2] for path in TRANSLATIONS.glob("*.ts")}
    assert set(LANGUAGES_OF_WINDOW) == {"en", *codes}
    assert LANGUAGES_OF_WINDOW["de"] == "Deutsch"


@pytest.mark.parametrize("language", [pytest.param("en", marks=pytest.mark.long), "de"])  # whose words are longer
def test_in_every_language_numbers_have_a_point_menus_letters_of_their_own_and_small_screens_suffice(
    open_window: Callable[[str], Desktop], language: str, qtbot: QtBot
) -> None:
    desktop = open_window(language)
    titles = titles_of(desktop)
    assert len({title[title.index("&") + 1].lower() for title in titles}) == len(titles) == 10
    shown(desktop, qtbot)
    desktop.window.resize(1024, 700)
    for page in range(3):
        desktop.window.show_page(page)
        QApplication.processEvents()
        assert (desktop.window.width(), desktop.window.height()) == (1024, 700)
        assert desktop.window.minimumSizeHint().width() <= 1024
    desktop.window.dialogs.show_export()
    boxes = [box for box in desktop.window.findChildren(QDoubleSpinBox) if box.decimals()]
    assert len(boxes) > 10
    assert all(box.textFromValue(1234.5) == f"{1234.5:.{box.decimals()}f}" for box in boxes)
    assert all(box.textFromValue(12345) == "12345" for box in desktop.window.findChildren(QSpinBox))


def test_qts_own_buttons_and_keys_speak_german_too(spoken: Callable[[str], None], qtbot: QtBot) -> None:
    spoken("de")
    buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close | QDialogButtonBox.StandardButton.Cancel)
    qtbot.addWidget(buttons)
    assert {button.text().replace("&", "") for button in buttons.buttons()} == {"Schließen", "Abbrechen"}
    assert QKeySequence("Ctrl+Space").toString(QKeySequence.SequenceFormat.NativeText) == "Strg+Leertaste"


def test_one_thing_and_several_have_words_of_their_own(spoken: Callable[[str], None]) -> None:
    assert [tr_count("{n} word", "{n} words", n) for n in (0, 1, 2)] == ["0 words", "1 word", "2 words"]
    spoken("de")
    assert [tr_count("{n} word", "{n} words", n) for n in (0, 1, 2)] == ["0 Wörter", "1 Wort", "2 Wörter"]


def test_german_nouns_keep_their_capitals_amid_a_sentence(spoken: Callable[[str], None]) -> None:
    assert tr_amid("High-pass") == "high-pass"
    spoken("de")
    assert tr_amid("High-pass") == "Hochpass"


def test_what_nobody_has_translated_stays_english(spoken: Callable[[str], None]) -> None:
    spoken("de")
    assert tr("Nobody has said this before.") == tr_engine("Nobody has said this before.")
    assert tr_engine("Nobody has said this before.") == "Nobody has said this before."


def test_what_the_engine_says_with_numbers_is_translated_around_them(spoken: Callable[[str], None]) -> None:
    faults = check_take(silence(0.5), 0.0, Phoneme.A).faults
    (sentence,) = faults.values()
    assert tr_engine(sentence) == sentence
    spoken("de")
    assert tr_engine(sentence).startswith("Es wurde kein Laut aufgenommen: Die lauteste Stelle liegt bei -")
    assert tr_engine("offline, ±0.51 s of context") == "Offline, ±0.51 s Kontext"
    assert tr_engine("learned, look-ahead 40 ms") == "Learned, Vorausschau 40 ms"


def test_phonemes_are_called_as_people_write_them_and_files_keep_their_labels(spoken: Callable[[str], None]) -> None:
    vowels = ["m", "p", "i", "a", "e", "u", "o"]
    assert [sound_name(p) for p in Phoneme] == ["silence", "unidentified", "s", "sh", *vowels]
    assert [tr_engine(label) for label in ("sz, sch…", "sch 2", "sz_s1")] == ["s, sh…", "sh 2", "sz_s1"]
    for needs in ("a fit needs", "rules need"):
        refused = f"{needs} labels of at least two sounds, and the recordings have only {{}}; load some with others"
        assert tr_engine(refused.format("sz")) == refused.format("s")
        assert tr_sentence(refused.format("sz")) == refused.format("s").capitalize()
    assert tr_sentence(unnamed := "talk.wav: cannot be read (gone)") == unnamed  # files keep their letters
    assert tr_engine("Limit for m_s1; 2 conditions: < sz, sch…; > a") == "Limit for m_s1; 2 conditions: < s, sh…; > a"
    spoken("de")
    assert [sound_name(p) for p in Phoneme] == ["Stille", "unbekannt", "s", "sch", *vowels]
    assert tr_engine("energy 230–440 Hz / 440–700 Hz") == "Energie 230–440 Hz / 440–700 Hz"
    assert tr_engine("energy 230–440 Hz / all, raw") == "Energie 230–440 Hz / alles, roh"
    assert tr_engine("probability of sch") == "Wahrscheinlichkeit von sch"
    assert (sound_name("schwa"), sound_name("jawOpen")) == ("Schwa", "jawOpen")
    assert [p.label for p in Phoneme][:4] == ["silence", "unidentified", "sz", "sch"]


def test_every_sentence_that_is_translated_is_one_of_the_engines() -> None:
    paths = (
        *ENGINE.rglob("*.py"),
        *PROGRAM.glob("cli/*.py"),
        *PROGRAM.glob("server/*.py"),
        PROGRAM / "desktop/session/serving.py",
    )
    said = "\n".join(literal for path in paths for literal in literals_in(path.read_text("utf-8")))
    said += "\n".join(entry.summary for entry in preset_entries(FACTORY_PRESETS))
    alike = [sentence for sentence in SENTENCES if not re.search("(rises|falls) from|a server needs", sentence)]
    assert len(alike) > 50
    assert [sentence for sentence in alike if share_found(sentence, said) < 0.6] == []


def share_found(sentence: str, said: str) -> float:
    """Give the share of a sentence's letters that stand in what is said: some are put together from parts."""
    parts = [part for words in re.split(r"\{\w+\}|[;:,(]", sentence) if len(part := words.strip()) > 6]
    return sum(len(part) for part in parts if part in said) / sum(map(len, parts)) if parts else 1.0


def literals_in(code: str) -> Iterator[str]:
    """Yield the texts of code, with a gap where a value is put in."""
    for node in ast.walk(ast.parse(code)):
        if isinstance(node, ast.JoinedStr):
            yield "".join(str(v.value) if isinstance(v, ast.Constant) else "\0" for v in node.values)
        elif isinstance(node, ast.Constant) and isinstance(node.value, str):
            yield node.value


def test_every_error_is_told_in_german_whatever_stands_in_its_places(spoken: Callable[[str], None]) -> None:
    spoken("de")
    for sentence in ERRORS:
        places = sorted(set(re.findall(r"\{\w+\}", sentence)))
        filled, told = sentence, GERMAN[sentence, ""]
        for number, place in enumerate(places, 100):
            filled, told = filled.replace(place, str(number)), told.replace(place, str(number))
        assert tr_engine(filled) == told


BAD_FILES: tuple[tuple[Callable[[Path], object], str, bytes, str], ...] = (
    (SoundReader, "empty.wav", b"", "empty.wav: Die Datei ist leer"),
    (SoundReader, "film.m4a", b"\0\0\0\x18ftypM4A text", "film.m4a: Keine lesbare Audiodatei (lässt sich nicht"),
    (load_preset, "own.toml", b"x", "own.toml: Keine TOML-Datei ('=' nach dem Schlüssel erwartet am Ende der Datei)"),
    (load_preset, "old.toml", b"format = 'x'", "old.toml: Erwartet wird ein Preset, beginnend mit format"),
    (load_preset, "old.txt", b"1 2 3", "old.txt: Eine PhonemeData-Datei enthält 21 Zahlen, gefunden 3; nach Zeile 1"),
    (load_morph_mesh, "face.glb", b"glTF\2\0\0\0", "face.glb: Sie endet mitten in den Kopfdaten"),
    (load_morph_mesh, "face.gltf", b"{", "face.gltf: Kein glTF: Das JSON ist nicht lesbar"),
    (load_morph_mesh, "face.obj", b"v a b c", "face.obj: Zeile 1 enthält 'v a b c', keine Zahl eines Meshs"),
    (load_morph_targets, "face.3dma", b"text", "face.3dma: Eine .3dma-Datei beginnt mit einer Zeile '3dma01'"),
    (
        read_labels,
        "none.TextGrid",
        NO_TIERS.encode(),
        "none.TextGrid: Keine Intervallspur mit Beschriftungen, gefunden",
    ),
    (read_labels, "cut.TextGrid", NO_TIERS[:53].encode(), "cut.TextGrid, Zeile 4: das Ende muss eine Zahl sein"),
    (
        read_labels,
        "table.csv",
        b"a,b\n1,2",
        "table.csv: Die Spalte start_s fehlt; mit den Spalten start_s, end_s, phone",
    ),
    (load_lexicon, "own.csv", b"word,ipa\nhello,QQ\n", "own.csv, Zeile 2: 'hello' ist nicht in IPA geschrieben"),
    (load_averaged_spectrum, "own.curve", b"text", "own.curve: Eine Kurve beginnt mit der Zeile '# phonemeanalyser"),
    (load_table, "mouth.toml", b"format = 'x'", "mouth.toml: Erwartet wird eine Mundtabelle, beginnend mit format"),
    (PerformanceTable.open, "face.faces", b"text", "face.faces: Keine Tabelle von Gesichtsaufnahmen oder beschädigt"),
    (load_expressions, "smiles.toml", b"format = 'x'", "smiles.toml: Erwartet wird eine Datei mit Ausdrücken"),
    (TakeProject, "taken", b"a file", "taken: Dieser Ordner lässt sich nicht anlegen"),
)


@pytest.mark.parametrize(("load", "name", "content", "told"), BAD_FILES, ids=[name for _, name, _, _ in BAD_FILES])
def test_what_is_wrong_with_a_file_is_told_in_german(
    spoken: Callable[[str], None],
    tmp_path: Path,
    load: Callable[[Path], object],
    name: str,
    content: bytes,
    told: str,
) -> None:
    (tmp_path / name).write_bytes(content)
    with pytest.raises(EngineError) as refused:
        load(tmp_path / name)
    spoken("de")
    assert tr_engine(str(refused.value)).startswith(told)


def test_names_in_an_error_stay_and_what_it_proposes_is_told_in_german(
    spoken: Callable[[str], None], tmp_path: Path
) -> None:
    refusals = []
    for act in (
        lambda: load_table("arkitt"),
        lambda: read_labels(tmp_path / "labels.doc"),
        lambda: Variable("Own Name", 1, 2),
        lambda: OscAddress.of("phone"),
    ):
        with pytest.raises(EngineError) as refused:
            act()
        refusals.append(str(refused.value))
    spoken("de")
    told = [tr_engine(refusal) for refusal in refusals]
    assert told[0].endswith("; ist arkit gemeint?")
    assert "'phone'" in told[3]
    assert [sentence for sentence, refusal in zip(told, refusals, strict=True) if sentence == refusal] == []
    assert tr_engine("A label needs a name; write the sound, or delete the label.").startswith("Eine Beschriftung")


def test_every_fault_of_a_take_is_told_in_german(spoken: Callable[[str], None]) -> None:
    loud = np.concatenate((silence(0.2), 4 * vowel((700, 1200, 2500), 0.6), silence(0.2))).clip(-1, 1)
    soft = np.concatenate((silence(0.2), 0.002 * vowel((700, 1200, 2500), 0.6), silence(0.2)))
    takes = [
        (loud, 0.0, Phoneme.A),
        (loud[:12_000], 0.0, Phoneme.A),
        (soft, 0.0, Phoneme.A),
        (loud, 0.5, Phoneme.A),
        (soft, 0.001, Phoneme.A),
        (loud, 0.0, Phoneme.SILENCE),
        (silence(0.05), 0.0, Phoneme.SILENCE),
    ]
    sentences = {told for take in takes for told in check_take(*take).faults.values()}
    spoken("de")
    assert len(sentences) >= 6
    assert [told for told in sentences if tr_engine(told) == told] == []


def test_all_words_of_the_engines_tables_are_translated() -> None:
    shown_words = {
        *(axis.value for axis in FrequencyAxis),
        *(kind.value for kind in Kind),
        *(c.words for c in CONVERSIONS.values()),
        *(driver.caption for driver in FaceDriver),
        *(kind.value for kind in UnitKind),
        *(unit.value for unit in LabelUnit),
        *(fault.value for fault in Fault),
        *(kind.value.replace("_", " ") for kind in ToneKind),
        *LANGUAGES,
        *expression_presets(),
        *(words for stage in STAGES.values() for words in (stage.label, stage.hint, *stage.hints)),
        *(words for stage in STAGES.values() for of in stage.parameters for words in (of.label, of.part) if words),
        *(re.sub(r"\d+ %", "{percent} %", entry.summary) for entry in preset_entries(FACTORY_PRESETS)),
        *(load_table(name).name for name in shipped_tables() if "mouth shapes" in load_table(name).name),
        *({source.value for source in Spectrum} - {"mel"}),
        *({unit_of(name) for name in BUILT_IN_NAMES} - {"Hz"}),
    }
    known = {text for text, _ in GERMAN}
    assert {words for words in shown_words - known if not NAMES.match(words) and words not in SAME} == set()
