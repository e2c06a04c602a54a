"""What the user is asked on the page of the head, and what of it is kept for the next start."""

import math
from contextlib import suppress
from pathlib import Path

from PySide6.QtCore import QObject, QSettings
from PySide6.QtWidgets import QFileDialog, QMessageBox, QWidget

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.talk.choices_panel import FASTEST_PERCENT, SLOWEST_PERCENT
from phonemeanalyser.desktop.talk.face_model import FaceFiles
from phonemeanalyser.desktop.talk.model import TalkModel
from phonemeengine.files import free_path
from phonemeengine.mouth.face_driver import FaceDriver
from phonemeengine.mouth.files.io import MESH_SUFFIXES, TARGET_SUFFIXES
from phonemeengine.mouth.morpher import Detail
from phonemeengine.mouth.movestate import Mode
from phonemeengine.performance.choice import ExampleChoice

MESHES = tr_noop("Meshes and movestates ({endings})")
MESH_ENDINGS = " ".join(f"*{kind}" for kind in (*MESH_SUFFIXES, *TARGET_SUFFIXES))
TABLES = tr_noop("Mouth tables (*.toml)")
SCRIPTS = tr_noop("Scripts (*.txt *.docx *.TextGrid *.json);;All files (*)")
LEXICONS = tr_noop("Lexicons (*.toml *.csv)")
PERFORMANCES = tr_noop("Tables of recorded faces (*.sqlite)")
EXPRESSIONS = tr_noop("Recorded faces, Live Link Face (*.csv)")
WORDS = "Praat TextGrid (*.TextGrid)"
SPEECH = "WAV (*.wav)"
MOST_KEPT = 10_000
"""Characters of a text that is kept for the next start."""


class TalkDialogs(QObject):
    """Asks, passes the answers to the models, and keeps what was chosen."""

    def __init__(self, window: QWidget, talking: TalkModel, settings: QSettings) -> None:
        super().__init__(window)
        self._window = window
        self._talking = talking
        self._settings = settings

    @staticmethod
    def opens(path: Path) -> bool:
        """Return whether a file is a mesh or movestates, by the ending of its name."""
        return path.suffix.lower() in (*MESH_SUFFIXES, *TARGET_SUFFIXES)

    def ask_mesh(self) -> None:
        """Let the user choose a mesh, with its movestates if they are in a file of their own."""
        folder = str(self._settings.value("folder/mesh", str(Path.home())))
        names, _ = QFileDialog.getOpenFileNames(
            self._window, tr("A mesh, and its movestates"), folder, tr(MESHES).format(endings=MESH_ENDINGS)
        )
        paths = [Path(name) for name in names]
        if paths:
            self._settings.setValue("folder/mesh", str(paths[0].parent))
            self.open(paths)

    def open(self, paths: list[Path]) -> None:
        """Show a mesh, or other movestates of the mesh that is there, or both."""
        meshes = [path for path in paths if path.suffix.lower() not in TARGET_SUFFIXES]
        targets = [path for path in paths if path.suffix.lower() in TARGET_SUFFIXES]
        face = self._talking.face
        if meshes:
            face.load(FaceFiles(meshes[0], targets[0] if targets else None))
        elif targets:
            face.load(FaceFiles(face.files.mesh, targets[0]))

    def ask_table(self) -> None:
        """Let the user choose a mouth table of his own."""
        folder = str(self._settings.value("folder/table", str(Path.home())))
        name, _ = QFileDialog.getOpenFileName(self._window, tr("A mouth table"), folder, tr(TABLES))
        if name:
            self._settings.setValue("folder/table", str(Path(name).parent))
            self._talking.set_table(name)

    def ask_script(self) -> None:
        """Let the user choose the words of the sound in hand."""
        sound = self._talking.text.words.sound
        folder = str(sound.parent if sound else Path.home())
        name, _ = QFileDialog.getOpenFileName(self._window, tr("The words of the sound"), folder, tr(SCRIPTS))
        if name:
            self._talking.text.open_script(Path(name))

    def ask_lexicon(self) -> None:
        """Let the user choose a lexicon."""
        folder = str(self._settings.value("folder/lexicon", str(Path.home())))
        name, _ = QFileDialog.getOpenFileName(self._window, tr("A lexicon"), folder, tr(LEXICONS))
        if name:
            self._settings.setValue("folder/lexicon", str(Path(name).parent))
            self._talking.text.set_lexicon(Path(name))

    def ask_performance(self) -> None:
        """Let the user choose a table of recorded faces."""
        folder = str(self._settings.value("folder/performance", str(Path.home())))
        name, _ = QFileDialog.getOpenFileName(self._window, tr("A table of recorded faces"), folder, tr(PERFORMANCES))
        if name:
            self._settings.setValue("folder/performance", str(Path(name).parent))
            self._talking.text.drivers.performance.open(Path(name))

    def ask_expression(self) -> None:
        """Let the user choose a recorded face that is shown beside the speech."""
        folder = str(self._settings.value("folder/expression", str(Path.home())))
        name, _ = QFileDialog.getOpenFileName(self._window, tr("A recorded expression"), folder, tr(EXPRESSIONS))
        if name:
            self._settings.setValue("folder/expression", str(Path(name).parent))
            self._talking.expression.set_file(Path(name))

    def ask_save_words(self) -> bool:
        """Let the user choose a TextGrid to save the words to; beside the sound it is found again."""
        sound = self._talking.text.words.sound
        suggested = Path.home() / "text.TextGrid" if sound is None else sound.with_suffix(".TextGrid")
        path = self._ask_target(tr("Save the words"), suggested, WORDS)
        return path is not None and self._talking.text.save_words(path)

    def ask_save_speech(self) -> None:
        """Let the user choose a WAV file to have the text spoken to."""
        folder = Path(str(self._settings.value("folder/speech", str(Path.home()))))
        path = self._ask_target(tr("Save the spoken text"), folder / "text.wav", SPEECH)
        if path is not None:
            self._settings.setValue("folder/speech", str(path.parent))
            self._talking.text.save_speech(path)

    def _ask_target(self, title: str, suggested: Path, filters: str) -> Path | None:
        """Let the user choose what to write; a name without an ending gets the suggested one."""
        name, _ = QFileDialog.getSaveFileName(self._window, title, str(suggested), filters)
        path = Path(name)
        if not name or path.suffix:
            return path if name else None
        return free_path(path.with_name(path.name + suggested.suffix))

    def may_leave_words(self) -> bool:
        """Ask what is to become of boundaries that were moved and not saved; says whether to go on."""
        words = self._talking.text.words
        if not words.has_unsaved_changes or words.sound is None:
            return True
        buttons = QMessageBox.StandardButton
        answer = QMessageBox.question(
            self._window, tr("Unsaved words"),
            tr("Save the words of {sound}, whose boundaries you moved?").format(sound=words.sound.name),
            buttons.Save | buttons.Discard | buttons.Cancel, buttons.Save,
        )  # fmt: skip
        return self.ask_save_words() if answer == buttons.Save else answer == buttons.Discard

    def save(self) -> None:
        """Keep what was chosen for the next start."""
        talking, keep = self._talking, self._settings.setValue
        files, osc = talking.face.files, talking.osc
        keep("talk/mesh", str(files.mesh or ""))
        keep("talk/movestates", str(files.movestates or ""))
        keep("talk/table", talking.table_name)
        keep("talk/detail", talking.idle.detail.value)
        keep("talk/mode", talking.mode.value)
        keep("talk/attack_percent", round(100 * talking.attack_factor))
        keep("talk/release_percent", round(100 * talking.release_factor))
        for name, on in (("blinks", talking.idle.blinks), ("head", talking.idle.head), ("random", talking.random)):
            keep(f"talk/{name}", int(on))
        keep("talk/text", talking.text.text if len(talking.text.text) <= MOST_KEPT else "")
        keep("talk/language", talking.text.language)
        keep("talk/lexicon", str(talking.text.lexicon_path or ""))
        keep("talk/literal", int(talking.text.literal))
        self._keep_voice()
        self._keep_drivers()
        self._keep_expression()
        keep("talk/osc_address", osc.address)
        keep("talk/osc_table", osc.table)
        keep("talk/osc", int(osc.on))

    def restore(self) -> None:
        """Take up what was chosen at the last start."""
        talking = self._talking
        files = [Path(text) if (text := self._kept(f"talk/{name}", "")) else None for name in ("mesh", "movestates")]
        if any(files) and all(path is None or path.is_file() for path in files):
            talking.face.files = FaceFiles(files[0], files[1])
        talking.set_table(self._kept("talk/table", talking.table_name))
        detail = self._kept("talk/detail", talking.idle.detail.value)
        talking.set_detail(next((d for d in Detail if d.value == detail), talking.idle.detail))
        mode = self._kept("talk/mode", talking.mode.value)
        talking.set_mode(next((m for m in Mode if m.value == mode), talking.mode))
        talking.set_blinks(self._kept("talk/blinks", "1") == "1")
        talking.set_head_motion(self._kept("talk/head", "1") == "1")
        talking.set_random(self._kept("talk/random", "1") == "1")
        talking.set_speed(self._percent("attack") / 100, self._percent("release") / 100)
        talking.text.set_text(self._kept("talk/text", ""))
        talking.text.set_language(self._kept("talk/language", ""))
        lexicon = Path(self._kept("talk/lexicon", ""))
        if lexicon.is_file():
            talking.text.set_lexicon(lexicon)
        talking.text.set_literal(self._kept("talk/literal", "0") == "1")
        self._restore_voice()
        self._restore_drivers()
        self._restore_expression()
        talking.osc.set_address(self._kept("talk/osc_address", talking.osc.address))
        talking.osc.set_table(self._kept("talk/osc_table", talking.osc.table))
        talking.osc.set_on(self._kept("talk/osc", "0") == "1")

    def _keep_voice(self) -> None:
        choice, keep = self._talking.text.voice.choice, self._settings.setValue
        keep("talk/voice", choice.name)
        keep("talk/voice_rate", f"{choice.rate:g}")
        keep("talk/voice_program", choice.program)
        keep("talk/voice_by_program", int(choice.by_program))

    def _restore_voice(self) -> None:
        voice = self._talking.text.voice
        usual = voice.choice
        rate = usual.rate
        with suppress(ValueError):  # somebody may edit the file
            rate = float(self._kept("talk/voice_rate", f"{rate:g}"))
        voice.choose(
            name=self._kept("talk/voice", usual.name),
            rate=rate if math.isfinite(rate) else usual.rate,
            program=self._kept("talk/voice_program", usual.program),
            by_program=self._kept("talk/voice_by_program", "0") == "1",
        )

    def _keep_expression(self) -> None:
        expression, keep = self._talking.expression, self._settings.setValue
        keep("talk/expression_file", str(expression.path or ""))
        keep("talk/expression_address", expression.input.address)
        keep("talk/expression_osc", int(expression.input.on))

    def _restore_expression(self) -> None:
        expression = self._talking.expression
        path = Path(self._kept("talk/expression_file", ""))
        if path.is_file():
            expression.set_file(path)
        expression.input.set_address(self._kept("talk/expression_address", expression.input.address))
        expression.input.set_on(self._kept("talk/expression_osc", "0") == "1")

    def _keep_drivers(self) -> None:
        drivers, keep = self._talking.text.drivers, self._settings.setValue
        tables, chosen = drivers.performance.opened
        keep("talk/text_driver", drivers.chosen.value)
        keep("talk/performances", [str(path) for path in tables])
        keep("talk/performance", str(chosen or ""))
        keep("talk/performance_choice", drivers.performance.choice.value)

    def _restore_drivers(self) -> None:
        drivers = self._talking.text.drivers
        driver, choice = self._kept("talk/text_driver", ""), self._kept("talk/performance_choice", "")
        drivers.choose(next((known for known in FaceDriver if known.value == driver), drivers.chosen))
        performance = drivers.performance
        performance.set_choice(next((known for known in ExampleChoice if known.value == choice), performance.choice))
        kept = self._settings.value("talk/performances") or []
        tables = [kept] if isinstance(kept, str) else list(kept)  # a list of one comes back as a text
        chosen = self._kept("talk/performance", "")
        performance.keep([Path(str(path)) for path in tables], Path(chosen) if chosen else None)

    def _percent(self, name: str) -> int:
        kept = self._kept(f"talk/{name}_percent", "100")
        usable = kept.isdecimal() and FASTEST_PERCENT <= int(kept) <= SLOWEST_PERCENT  # somebody may edit the file
        return int(kept) if usable else 100

    def _kept(self, name: str, default: str) -> str:
        return str(self._settings.value(name, default))
