"""What the user is asked on the page of the head, and what of it is kept for the next start."""

import json
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Any

from PySide6.QtCore import QByteArray, QObject, QSettings, Signal
from PySide6.QtWidgets import QWidget

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.settings import Kept, keep, read, read_paths
from phonemeanalyser.desktop.talk.drivers.comparison import COMPARISONS
from phonemeanalyser.desktop.talk.drivers.driver_model import OTHER_PRESET
from phonemeanalyser.desktop.talk.head.head_view import HeadView
from phonemeanalyser.desktop.talk.head.mapping_dialog import FaceMappingDialog
from phonemeanalyser.desktop.talk.model import TalkModel
from phonemeanalyser.desktop.talk.mouth_table import FASTEST_PERCENT, SLOWEST_PERCENT
from phonemeanalyser.desktop.talk.page import TalkPage
from phonemeanalyser.desktop.tasks import tried
from phonemeanalyser.desktop.widgets.builders import answer_of, input_dialog
from phonemeanalyser.desktop.widgets.file_asker import FileAsker, ask_to_save
from phonemeengine.errors import MouthError
from phonemeengine.labels.table import write_text
from phonemeengine.mouth.face_mapping import FaceMapping, mapped_table
from phonemeengine.mouth.files.io import MESH_SUFFIXES, TARGET_SUFFIXES, FaceFiles
from phonemeengine.mouth.morph_mesh import Head
from phonemeengine.mouth.table import table_to_toml
from phonemeengine.storage.files import write_file

MESHES = tr_noop("Face meshes and blend shapes ({endings})")
MESH_ENDINGS = " ".join(f"*{kind}" for kind in (*MESH_SUFFIXES, *TARGET_SUFFIXES))
TABLES = tr_noop("Mouth tables (*.toml)")
SCRIPTS = tr_noop("Scripts (*.txt *.docx *.TextGrid *.json);;All files (*)")
LEXICONS = tr_noop("Lexicons (*.toml *.csv)")
PERFORMANCES = tr_noop("Tables of recorded faces (*.sqlite)")
NETWORKS = tr_noop("Face networks (*.face)")
STYLES = tr_noop("Styles of speaking (*.toml)")
EXPRESSIONS = tr_noop("Face captures of Live Link Face or OpenFace (*.csv)")
WORDS = "Praat TextGrid (*.TextGrid)"
TEXT = tr_noop("Texts (*.txt)")
SPEECH = "WAV (*.wav)"


class TalkDialogs(QObject):
    """Asks, passes the answers to the models, and keeps what was chosen.

    Signals
    -------
    page_asked : the page of the head is to be shown, and made if it is not there yet.
    """

    page_asked = Signal()

    def __init__(self, window: QWidget, talking: TalkModel, settings: QSettings, files: FileAsker) -> None:
        super().__init__(window)
        self._window = window
        self._talking = talking
        self._settings, self._files = settings, files
        self._page: TalkPage | None = None

    def join(self, page: TalkPage) -> None:
        """Answer what a page asks, and lay it out as at the last start."""
        self._page = page
        for name, splitter in page.splitters.items():
            if isinstance(state := self._settings.value(name), QByteArray):
                splitter.restoreState(state)
        page.tabs.setCurrentIndex(read(self._settings, "talk/tab", 0))
        kept = read(self._settings, "talk/compared", "")
        compared = next((driver for driver in COMPARISONS if driver == kept), None)
        if compared != OTHER_PRESET or self._talking.comparison.other_preset:
            self._talking.text.drivers.compare(compared)
        page.choices.mesh_asked.connect(self.ask_mesh)
        page.choices.table_asked.connect(self.ask_table)
        page.choices.mapping_asked.connect(self.ask_mapping)
        self._talking.shapes_unknown.connect(self.ask_mapping)
        page.text.script_asked.connect(self.ask_script)
        page.text.lexicon_asked.connect(self.ask_lexicon)
        page.expression.file_asked.connect(self.ask_expression)
        page.style_panel.target_asked.connect(self.ask_save_style)
        page.style_panel.name_asked.connect(self.ask_style_name)
        page.style_panel.fit_asked.connect(self._fit_style)
        page.text.voice.panel.table_asked.connect(self.ask_performance)
        page.text.voice.panel.network_asked.connect(self.ask_network)
        page.words_asked.connect(self.ask_save_words)
        page.speech_asked.connect(self.ask_save_speech)

    def show_tour(self) -> None:
        """Lead through the page of the head; from now on only when the user asks for it."""
        self.page_asked.emit()
        if self._page is not None:
            keep(self._settings, "talk/toured", True)
            self._page.tour.begin()

    def show_first_tour(self) -> None:
        """Lead through the page, unless that was done before."""
        if not read(self._settings, "talk/toured", False):
            self.show_tour()

    def look(self, change: Callable[[HeadView], object]) -> None:
        """Show the head, looked at in another way."""
        self.page_asked.emit()
        if self._page is not None:
            change(self._page.head)

    @property
    def wireframe(self) -> bool:
        """Whether only the edges of the head's mesh are drawn."""
        return self._page is not None and self._page.head.wireframe

    @staticmethod
    def opens(path: Path) -> bool:
        """Return whether a file is a mesh or movestates, by the ending of its name."""
        return path.suffix.lower() in (*MESH_SUFFIXES, *TARGET_SUFFIXES)

    def ask_mesh(self) -> None:
        """Let the user choose a mesh, with its movestates if they are in a file of their own."""
        filters = tr(MESHES).format(endings=MESH_ENDINGS)
        if paths := self._files.ask_files(tr("Load Face"), filters, "mesh"):
            self.open(paths)

    def open(self, paths: list[Path]) -> None:
        """Show a mesh, or other movestates of the mesh that is there, or both; of several meshes one face."""
        meshes = [path for path in paths if path.suffix.lower() not in TARGET_SUFFIXES]
        targets = [path for path in paths if path.suffix.lower() in TARGET_SUFFIXES]
        face = self._talking.face
        if len(meshes) > 1:
            face.load(FaceFiles.of_meshes(meshes))
        elif meshes:
            face.load(FaceFiles(meshes[0], targets[0] if targets else None))
        elif targets:
            face.load(FaceFiles(face.files.mesh, targets[0]))

    def ask_table(self) -> None:
        """Let the user choose a mouth table of his own."""
        if path := self._files.ask_file(tr("Load Mouth Table"), tr(TABLES), "table"):
            self._talking.set_table(str(path))

    def ask_mapping(self) -> None:
        """Let the user say which shapes of the face stand for which of ours; a mouth table keeps that."""
        face = self._talking.face
        if face.states is not None:
            dialog = FaceMappingDialog(face, self._window)
            dialog.chosen.connect(self._save_mapping)
            dialog.show()

    def _save_mapping(self, mapping: FaceMapping) -> None:
        suggested = self._files.folder_of("table") / f"{Path(self._talking.face.name).stem}.toml"
        path = self._files.ask_target(tr("Save Mouth Table"), suggested, tr(TABLES), "table")
        if path is None:
            return
        try:
            text = table_to_toml(mapped_table(mapping, path.stem))
            write_file(path, text.encode(errors="replace"), MouthError)
        except MouthError as error:
            self._talking.error.emit(str(error))
        else:
            self._talking.set_table(str(path))

    def ask_script(self) -> None:
        """Let the user choose the words of the current sound."""
        sound = self._talking.text.words.sound
        place = sound.parent if sound else Path.home()
        if path := self._files.ask_file(tr("Open Script"), tr(SCRIPTS), default=place):
            self._talking.text.open_script(path)

    def ask_lexicon(self) -> None:
        """Let the user choose a lexicon."""
        if path := self._files.ask_file(tr("Load Lexicon"), tr(LEXICONS), "lexicon"):
            self._talking.text.set_lexicon(path)

    def ask_performance(self) -> None:
        """Let the user choose a table of recorded faces."""
        if path := self._files.ask_file(tr("Open Table of Recorded Faces"), tr(PERFORMANCES), "performance"):
            self._talking.text.drivers.performance.open(path)

    def ask_network(self) -> None:
        """Let the user choose a network that moves the face by the sound alone."""
        if path := self._files.ask_file(tr("Open Face Network"), tr(NETWORKS), "network"):
            self._talking.text.drivers.network.open(path)

    def ask_expression(self) -> None:
        """Let the user choose a recorded face that is shown beside the speech."""
        if path := self._files.ask_file(tr("Load Face Capture"), tr(EXPRESSIONS), "expression"):
            self._talking.expression.set_file(path)

    def ask_save_style(self) -> None:
        """Let the user choose a file to save the style to that is edited; in the folder of styles it is listed."""
        styles = self._talking.styles
        suggested = styles.folder() / f"{styles.edited.name}-mine.toml"
        if path := self._files.ask_target(tr("Save Style"), suggested, tr(STYLES), "style"):
            styles.save(path)

    def ask_style_name(self) -> None:
        """Let the user give the style that is edited another name."""
        styles, verb = self._talking.styles, tr("Rename")
        dialog = input_dialog(self._window, tr("Rename Style"), tr("Name of the style:"), verb, styles.edited.name)
        if name := answer_of(dialog):
            styles.rename(name)

    def _fit_style(self) -> None:
        self._talking.text.drivers.performance.fit_style(self._talking.styles.take)

    def ask_save_words(self) -> bool:
        """Let the user choose a TextGrid to save the words to; beside the sound it is found again."""
        sound = self._talking.text.words.sound
        suggested = Path.home() / "text.TextGrid" if sound is None else sound.with_suffix(".TextGrid")
        path = self._files.ask_target(tr("Save Words and Phones"), suggested, WORDS, other_endings=True)
        return path is not None and self._talking.text.edits.save(path)

    def ask_save_speech(self) -> None:
        """Let the user choose a WAV file to have the text spoken to."""
        suggested = self._files.folder_of("speech") / "text.wav"
        if path := self._files.ask_target(tr("Save Spoken Text"), suggested, SPEECH, "speech", other_endings=True):
            self._talking.text.save_speech(path)

    def ask_save_text(self) -> bool:
        """Let the user choose a file to save the text to; beside the sound it is found again."""
        texts, sound = self._talking.text, self._talking.text.words.sound
        suggested = Path.home() / "text.txt" if sound is None else sound.with_suffix(".txt")
        path = self._files.ask_target(tr("Save Text"), suggested, tr(TEXT), other_endings=True)
        if path is None or not tried(lambda: write_text(texts.text, path), texts.error.emit):
            return False
        if path == suggested:
            texts.written.note_saved()
        return True

    def may_leave_words(self) -> bool:
        """Ask what is to become of text, words and keys that were edited and not saved; says whether to go on."""
        texts, words, keys = self._talking.text, self._talking.text.words, self._talking.keys
        if words.sound is not None:
            name = words.sound.name
            if texts.written.has_unsaved_changes:
                question = tr("Save the changes to the text of {sound}?").format(sound=name)
                if not ask_to_save(self._window, tr("Unsaved Text"), question, self.ask_save_text):
                    return False
            if words.has_unsaved_changes:
                question = tr("Save the boundaries that you moved in {sound}?").format(sound=name)
                if not ask_to_save(self._window, tr("Unsaved Boundaries"), question, self.ask_save_words):
                    return False
        if not keys.has_unsaved_changes or keys.sound is None:
            return True
        question = tr("Save the keys that you edited in {sound}?").format(sound=keys.sound.name)
        return ask_to_save(self._window, tr("Unsaved Keys"), question, keys.save)

    def save(self) -> None:
        """Keep what was chosen for the next start."""
        for choice in self._kept():
            choice.save(self._settings)
        if self._page is not None:
            for name, splitter in self._page.splitters.items():
                self._settings.setValue(name, splitter.saveState())
            keep(self._settings, "talk/tab", self._page.tabs.currentIndex())
            keep(self._settings, "talk/compared", self._talking.text.drivers.compared or "")
        written = self._talking.text.written
        written.remember()
        self._settings.setValue("talk/texts", json.dumps(written.remembered))
        self._settings.setValue("talk/languages", json.dumps(written.recent))
        self._settings.setValue("talk/styles", json.dumps(self._talking.styles.kept))
        files, drivers = self._talking.face.files, self._talking.text.drivers
        keep(self._settings, "talk/mesh", files.mesh or "")
        moved = files.movestates if isinstance(files.movestates, tuple) else (files.movestates or "",)
        self._settings.setValue("talk/movestates", list(map(str, moved)))
        for key, opened in (("talk/performance", drivers.performance), ("talk/network", drivers.network)):
            paths, chosen = opened.opened
            self._settings.setValue(f"{key}s", list(map(str, paths)))
            keep(self._settings, key, chosen or "")

    def restore(self) -> None:
        """Take up what was chosen at the last start."""
        mesh = read(self._settings, "talk/mesh", "")
        moved = tuple(path for path in read_paths(self._settings, "talk/movestates") if path.name)
        if (mesh in {*Head} or Path(mesh).is_file() or (moved and not mesh)) and all(map(Path.is_file, moved)):
            several = moved if len(moved) > 1 or {path.suffix.lower() for path in moved} & {*MESH_SUFFIXES} else None
            self._talking.face.files = FaceFiles(Path(mesh) if mesh else None, several or next(iter(moved), None))
        for choice in self._kept():
            choice.restore(self._settings)
        written = self._talking.text.written
        with suppress(ValueError, TypeError, AttributeError):  # the file was edited by hand
            texts = json.loads(str(self._settings.value("talk/texts") or "{}"))
            written.remembered = {path: (str(text), str(tag)) for path, (text, tag) in texts.items()}
            written.recent = [*map(str, json.loads(str(self._settings.value("talk/languages") or "[]")))]
            self._talking.styles.restore(json.loads(str(self._settings.value("talk/styles") or "{}")))
        written.take("", None)
        drivers = self._talking.text.drivers
        for key, opened in (("talk/performance", drivers.performance), ("talk/network", drivers.network)):
            chosen = read(self._settings, key, "")
            opened.keep(read_paths(self._settings, f"{key}s"), Path(chosen) if chosen else None)

    def _kept(self) -> tuple[Kept[Any], ...]:
        talking, text, voice, osc = self._talking, self._talking.text, self._talking.text.voice, self._talking.osc
        drivers, expression = text.drivers, talking.expression
        return (
            Kept("talk/table", lambda: talking.table_name, talking.set_table),
            Kept("talk/detail", lambda: talking.idle.detail, talking.set_detail),
            Kept("talk/mode", lambda: talking.mode, talking.set_mode),
            Kept("talk/blinks", lambda: talking.idle.blinks, talking.set_blinks),
            Kept("talk/head", lambda: talking.idle.head, talking.set_head_motion),
            Kept("talk/pictures", lambda: talking.pictures.rate, talking.pictures.set_rate),
            Kept("talk/text_feeling", lambda: expression.text_feeling, expression.set_text_feeling),
            Kept("talk/keys", lambda: talking.keys.open, talking.keys.set_open),
            Kept("talk/random", lambda: talking.random, talking.set_random),
            _kept_percent(
                "talk/attack_percent",
                lambda: talking.attack_factor,
                lambda factor: talking.set_speed(factor, talking.release_factor),
            ),
            _kept_percent(
                "talk/release_percent",
                lambda: talking.release_factor,
                lambda factor: talking.set_speed(talking.attack_factor, factor),
            ),
            _kept_file("talk/lexicon", lambda: text.lexicon_path, text.set_lexicon),
            Kept("talk/literal", lambda: text.literal, text.set_literal),
            Kept("talk/voice", lambda: voice.choice.name, lambda name: voice.choose(name=name)),
            Kept("talk/voice_rate", lambda: voice.choice.rate, lambda rate: voice.choose(rate=rate)),
            Kept("talk/voice_program", lambda: voice.choice.program, lambda words: voice.choose(program=words)),
            Kept("talk/voice_by_program", lambda: voice.choice.by_program, lambda on: voice.choose(by_program=on)),
            Kept("talk/voice_own_sound", lambda: voice.choice.own_sound, lambda on: voice.choose(own_sound=on)),
            Kept("talk/text_driver", lambda: drivers.chosen, drivers.choose),
            Kept("talk/performance_person", lambda: drivers.performance.person, drivers.performance.choose_person),
            Kept("talk/performance_choice", lambda: drivers.performance.choice, drivers.performance.set_choice),
            _kept_file("talk/expression_file", lambda: expression.path, expression.set_file),
            Kept("talk/expression_address", lambda: expression.input.address, expression.input.set_address),
            Kept("talk/expression_osc", lambda: expression.input.on, expression.input.set_on),
            Kept("talk/osc_address", lambda: osc.address, osc.set_address),
            Kept("talk/osc_table", lambda: osc.table, osc.set_table),
            Kept("talk/osc", lambda: osc.on, osc.set_on),
        )


def _kept_percent(key: str, get: Callable[[], float], put: Callable[[float], object]) -> Kept[int]:
    """Keep a factor as percent; one that the sliders do not have, from a file edited by hand, stays."""

    def put_percent(percent: int) -> None:
        if FASTEST_PERCENT <= percent <= SLOWEST_PERCENT:
            put(percent / 100)

    return Kept(key, lambda: round(100 * get()), put_percent)


def _kept_file(key: str, get: Callable[[], Path | None], put: Callable[[Path], object]) -> Kept[str]:
    """Keep the path of a file, to be used again if it is still there."""
    return Kept(key, lambda: str(get() or ""), lambda name: Path(name).is_file() and put(Path(name)))
