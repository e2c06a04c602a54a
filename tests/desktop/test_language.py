"""The window speaks the language of the system, or the one that is chosen, wholly."""

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
from phonemeanalyser.desktop.analyse.recognition.recogniser_choice import EncoderDialog
from phonemeanalyser.desktop.analyse.recognition.variable_dialog import VariableDialog
from phonemeanalyser.desktop.app import Desktop
from phonemeanalyser.desktop.calibrate.dialogs import MappingDialog
from phonemeanalyser.desktop.engine_words import SPOKEN, tr_engine
from phonemeanalyser.desktop.language import LANGUAGES as LANGUAGES_OF_WINDOW
from phonemeanalyser.desktop.language import TRANSLATIONS, language_of, tr, tr_amid, tr_count, use_language
from phonemeanalyser.desktop.session.sources import SourceKind
from phonemeanalyser.desktop.talk.words.text_panel import _short
from phonemeanalyser.desktop.talk.words.voice_model import installed
from phonemeengine.audio.output import ClockOutput
from phonemeengine.audio.tone.settings import ToneKind
from phonemeengine.calibration.sentences import LANGUAGES
from phonemeengine.calibration.takes.quality import Fault, check_take
from phonemeengine.conversion.work import CONVERSIONS
from phonemeengine.dsp.sonagram import FrequencyAxis
from phonemeengine.features.variables import BUILT_IN_NAMES, Kind, Spectrum, unit_of
from phonemeengine.labels.utterance import LabelUnit
from phonemeengine.mouth.expression.streams import expression_presets
from phonemeengine.mouth.face_driver import FaceDriver
from phonemeengine.mouth.table import load_table, shipped_tables
from phonemeengine.performance.units import UnitKind
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.controls import controls_of
from phonemeengine.presets.files import FACTORY_PRESETS, load_preset, preset_entries
from phonemeengine.recognition.spec import recogniser_names, recogniser_of
from phonemeengine.settings import STAGES
from tests.desktop.hands import shown
from tests.desktop.studio import DESK, Studio
from tests.desktop.texts import texts_of
from tests.fakes.microphones import HandDrivenMicrophone
from tests.sounds import silence, vowel
from tools.translations.ts_file import read_translations

GERMAN = read_translations(TRANSLATIONS / "phonemeanalyser_de.ts")
SAME = {
    "Analyse",
    "Auto",
    "Detail",
    "Esc",
    "Export",
    "Live",
    "Median",
    "Mel",
    "Movestates",
    "Name",
    "Neutral",
    "Pause",
    "Preset",
    "Rate",
    "Return",
    "Takes",
    "Text",
    "Variable",
    "Variable:",
    "auto",
    "linear",
    "live",
    "max",
    "mel",
    "min",
    "mono",
}
"""Words that are the same in both languages."""
NAMES = re.compile(
    r"Annosoft|ARKit|Live Link|Moho|Oculus 15|Papagayo|Praat( \(|$)|Preston Blair|Rhubarb|VRM|Whisper|HOST:PORT|"
    r"my-voice|Bartlett|Hann|Hamming|Blackman|viridis|inferno|magma|plasma|cividis|[A-Z]+$|F\d+$|speech\.|.*[/\\]"
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
    named = {*BUILT_IN_NAMES, *recogniser_names(), *(p.label for p in Phoneme), *shipped_tables()}
    for path in FACTORY_PRESETS:
        preset = load_preset(path)
        named |= {path.stem, preset.name}
        for group in controls_of(preset, recogniser_of(preset.recogniser, preset.config)):
            named |= {group.title} if group.title in BUILT_IN_NAMES else set()
            named |= {name for control in group.controls for name in (control.name, control.label)}
    return (
        named | set(installed().voices) | {_short(language.name) for language in installed().languages} - set(SPOKEN)
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


def test_the_menu_changes_the_language_at_once_and_for_the_next_start(
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
    assert titles_of(open_window(str(settings.value("language"))))[0] == "&Datei"
    language_entry(desktop, "Sprache: English").trigger()
    assert titles_of(desktop)[0] == "&File"


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


@pytest.mark.parametrize("language", ["en", "de"])
def test_numbers_have_a_point_and_nothing_between_thousands_in_every_language(
    open_window: Callable[[str], Desktop], language: str, qtbot: QtBot
) -> None:
    desktop = open_window(language)
    shown(desktop, qtbot)
    desktop.window.show_page(2)
    desktop.window.dialogs.show_export()
    boxes = [box for box in desktop.window.findChildren(QDoubleSpinBox) if box.decimals()]
    assert len(boxes) > 10
    assert all(box.textFromValue(1234.5) == f"{1234.5:.{box.decimals()}f}" for box in boxes)
    assert all(box.textFromValue(12345) == "12345" for box in desktop.window.findChildren(QSpinBox))


def test_what_is_chosen_stays_chosen_in_another_language(
    open_window: Callable[[str], Desktop], settings: QSettings, qtbot: QtBot
) -> None:
    desktop = open_window("de")
    shown(desktop, qtbot)
    analysis = desktop.window.analysis
    analysis.file.axis.setCurrentIndex(analysis.file.axis.findText("logarithmisch"))
    analysis.file.colours.setCurrentIndex(analysis.file.colours.findText("grau"))
    analysis.scroll_view.colours.setCurrentIndex(analysis.scroll_view.colours.findText("grau"))
    desktop.set_language("en")
    analysis = desktop.window.analysis
    assert analysis.file.axis.currentText() == "logarithmic"
    assert analysis.file.colours.currentText() == analysis.scroll_view.colours.currentText() == "grey"


def test_qts_own_buttons_and_keys_speak_german_too(spoken: Callable[[str], None], qtbot: QtBot) -> None:
    spoken("de")
    buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close | QDialogButtonBox.StandardButton.Cancel)
    qtbot.addWidget(buttons)
    assert {button.text().replace("&", "") for button in buttons.buttons()} == {"Schließen", "Abbrechen"}
    assert QKeySequence("Ctrl+Space").toString(QKeySequence.SequenceFormat.NativeText) == "Strg+Leertaste"


@pytest.mark.parametrize("language", ["en", "de"])
def test_no_two_menus_have_the_same_letter(open_window: Callable[[str], Desktop], language: str) -> None:
    titles = titles_of(open_window(language))
    letters = [title[title.index("&") + 1].lower() for title in titles]
    assert len(set(letters)) == len(titles) == 9


def test_the_german_window_fits_a_small_screen(open_window: Callable[[str], Desktop], qtbot: QtBot) -> None:
    desktop = open_window("de")
    shown(desktop, qtbot)
    desktop.window.resize(1024, 700)
    for page in range(3):
        desktop.window.show_page(page)
        QApplication.processEvents()
        assert (desktop.window.width(), desktop.window.height()) == (1024, 700)
        assert desktop.window.minimumSizeHint().width() <= 1024


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
    assert tr_engine(sentence).startswith("Es war nichts zu hören (die lauteste Stelle liegt bei -")
    assert tr_engine("twin, 0.51 s each way") == "Zwilling, 0.51 s in beide Richtungen"


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
        *(words for stage in STAGES.values() for words in (stage.label, stage.hint)),
        *(words for stage in STAGES.values() for of in stage.parameters for words in (of.label, of.part) if words),
        *(preset_entries(FACTORY_PRESETS)[k].summary for k in range(len(FACTORY_PRESETS))),
        *(load_table(name).name for name in shipped_tables() if "mouth shapes" in load_table(name).name),
        *({source.value for source in Spectrum} - {"mel"}),
        *({unit_of(name) for name in BUILT_IN_NAMES} - {"Hz"}),
    }
    known = {text for text, _ in GERMAN}
    assert {words for words in shown_words - known if not NAMES.match(words) and words not in SAME} == set()
