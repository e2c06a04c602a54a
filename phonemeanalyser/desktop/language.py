"""The language of the window: English, in which its texts are written, or another one by Qt's translations."""

from pathlib import Path

from PySide6.QtCore import QCoreApplication, QLibraryInfo, QLocale, QTranslator

SYSTEM = "system"
"""What stands in the settings where the system's language is to be followed."""
WRITTEN_IN = "en"
CONTEXT = "PhonemeAnalyser"
"""Under which Qt finds all texts of the window."""
IN_USE = "language"
"""The property of Qt's application that says which language is in use."""


def _own_name(code: str) -> str:
    """Return what a language calls itself, such as ``Deutsch`` for ``de``."""
    name = QLocale(code).nativeLanguageName()
    return name[:1].upper() + name[1:]


TRANSLATIONS = Path(__file__).parent / "translations"
_CODES = sorted(path.stem.removeprefix("phonemeanalyser_") for path in TRANSLATIONS.glob("phonemeanalyser_*.ts"))
LANGUAGES = {WRITTEN_IN: "English", **{code: _own_name(code) for code in _CODES}}
"""What each language calls itself, by its code: the one in which texts are written, and each that has a file."""


def tr(text: str, comment: str = "") -> str:
    """Return a text in the language of the window.

    Parameters
    ----------
    text : in English; named places such as ``{n}`` stay, and are filled by the caller.
    comment : tells two texts apart that are one in English only.
    """
    return QCoreApplication.translate(CONTEXT, text, comment or None)


def tr_noop(text: str) -> str:
    """Return a text as it is, which `tr` is given later: for tables that are made before the language is known."""
    return text


def tr_count(one: str, many: str, n: int) -> str:
    """Return the text for one or for any other number of things, with its place ``{n}`` filled."""
    return tr(one if n == 1 else many).format(n=n)


def tr_amid(text: str) -> str:
    """Return a title as it stands amid a sentence: small in English, while other languages keep their capitals."""
    found = tr(text)
    return found.lower() if language_in_use() == WRITTEN_IN else found


def language_of(choice: str, system: QLocale | None = None) -> str:
    """Return the language that a choice of the user means: itself, or the first one of the system that there is."""
    if choice in LANGUAGES:
        return choice
    asked = (system or QLocale.system()).uiLanguages()
    names = (known for name in asked for known in (name.replace("-", "_"), name.partition("-")[0]))
    return next((name for name in names if name in LANGUAGES), WRITTEN_IN)


def language_in_use() -> str:
    """Return the language in which the window is, one of `LANGUAGES`."""
    app = QCoreApplication.instance()
    return str((app.property(IN_USE) if app is not None else None) or WRITTEN_IN)


def use_language(app: QCoreApplication, language: str) -> None:
    """Have all texts that are made from now on be in a language, those of Qt's own dialogs, too."""
    app.setProperty(IN_USE, language)
    for translator in app.findChildren(QTranslator):
        app.removeTranslator(translator)
        translator.setParent(None)
    if language == WRITTEN_IN:
        return
    of_qt = Path(QLibraryInfo.path(QLibraryInfo.LibraryPath.TranslationsPath))
    for folder, name in ((of_qt, "qtbase"), (TRANSLATIONS, "phonemeanalyser")):
        translator = QTranslator(app)
        if translator.load(f"{name}_{language}", str(folder)):
            app.installTranslator(translator)
