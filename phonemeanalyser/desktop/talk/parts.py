"""What a window has of the Talk page beside the page itself: its dialogs, its heads and its menu."""

from functools import partial
from pathlib import Path

from PySide6.QtCore import QSettings
from PySide6.QtGui import QActionGroup
from PySide6.QtWidgets import QMainWindow, QMenu, QWidget

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.menus import Command, Commands, Menus
from phonemeanalyser.desktop.talk.dialogs import TalkDialogs
from phonemeanalyser.desktop.talk.drivers.comparison import ComparisonMenu
from phonemeanalyser.desktop.talk.head.head_view import LIGHT_STEP, HeadView
from phonemeanalyser.desktop.talk.model import TalkModel
from phonemeanalyser.desktop.talk.page import Heads, TalkPage
from phonemeanalyser.desktop.talk.pictures import PICTURE_RATES
from phonemeanalyser.desktop.talk.words.spoken_lanes import spoken_lanes
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.file_asker import FileAsker
from phonemeanalyser.desktop.widgets.lanes import Lane
from phonemeengine.mouth.files.io import FaceFiles
from phonemeengine.mouth.morph_mesh import Framing, Head


def talk_commands(talking: TalkModel, dialogs: TalkDialogs) -> Commands:
    """Return what belongs to the head: its text, its pictures, its face and what is saved of it."""
    texts = talking.text
    return (
        Command(tr_noop("Align Text with Recording"), "Ctrl+Shift+Return", texts.align),
        Command(tr_noop("Align Even If the Text Seems Different"), "", texts.align_anyway),
        Command(tr_noop("Speak Text"), "Ctrl+Return", texts.say),
        None,
        Command(tr_noop("Open Script…"), "", dialogs.ask_script),
        Command(tr_noop("Load Lexicon…"), "", dialogs.ask_lexicon),
        Command(tr_noop("Remove Lexicon"), "", partial(texts.set_lexicon, None)),
        Command(tr_noop("Read Notation Literally"), "", texts.set_literal, checkable=True),
        None,
        Command(tr_noop("Next Picture (Right)"), "", partial(talking.pictures.step, 1)),
        Command(tr_noop("Previous Picture (Left)"), "", partial(talking.pictures.step, -1)),
        None,
        Command(tr_noop("Rename Word or Phone (F2)"), "", texts.edits.ask_rename),
        Command(tr_noop("Insert Word (Ins)"), "", texts.edits.ask_insert),
        Command(tr_noop("Split Word or Phone at Cursor (Enter)"), "", texts.edits.split),
        Command(tr_noop("Delete Word or Phone (Del)"), "", texts.edits.delete),
        Command(tr_noop("Realign This Word"), "", texts.edits.realign),
        None,
        Command(tr_noop("Next Poor Match"), "", partial(texts.edits.show_poor, 1)),
        Command(tr_noop("Previous Poor Match"), "", partial(texts.edits.show_poor, -1)),
        Command(tr_noop("Edit Keys"), "", talking.keys.set_open, checkable=True),
        Command(tr_noop("Save Keys"), "", talking.keys.save),
        None,
        Command(tr_noop("Save Text…"), "", dialogs.ask_save_text),
        Command(tr_noop("Save Words and Phones…"), "", dialogs.ask_save_words),
        Command(tr_noop("Save Spoken Text as Audio File…"), "", dialogs.ask_save_speech),
    )


def face_commands(talking: TalkModel, dialogs: TalkDialogs) -> Commands:
    """Return what chooses a face, what moves it, and how much of it is seen."""
    heads = {Head.WOMAN: tr_noop("Show Woman"), Head.MAN: tr_noop("Show Man")}
    framings = {
        Framing.MOUTH: tr_noop("Look at Mouth"),
        Framing.FACE: tr_noop("Look at Face"),
        Framing.BUST: tr_noop("Look at Bust"),
    }
    return (
        *(Command(words, "", partial(talking.face.load, FaceFiles(Path(head)))) for head, words in heads.items()),
        Command(tr_noop("Load Face…"), "", dialogs.ask_mesh),
        Command(tr_noop("Map Shapes…"), "", dialogs.ask_mapping),
        None,
        Command(tr_noop("Load Mouth Table…"), "", dialogs.ask_table),
        Command(tr_noop("Load Face Capture…"), "", dialogs.ask_expression),
        Command(tr_noop("Open Recorded Faces…"), "", dialogs.ask_performance),
        Command(tr_noop("Open Face Network…"), "", dialogs.ask_network),
        None,
        *(
            Command(words, "", partial(dialogs.look, partial(HeadView.go_home, framing=framing)))
            for framing, words in framings.items()
        ),
        Command(
            tr_noop("Wireframe (W)"),
            "",
            lambda on: dialogs.look(partial(HeadView.look, wireframe=on)),
            checkable=True,
        ),
        Command(
            tr_noop("Move Light Left (,)"), "", partial(dialogs.look, partial(HeadView.move_light, angle=-LIGHT_STEP))
        ),
        Command(
            tr_noop("Move Light Right (.)"), "", partial(dialogs.look, partial(HeadView.move_light, angle=LIGHT_STEP))
        ),
    )


def fill_talk_menu(menus: Menus, menu: QMenu, talking: TalkModel, dialogs: TalkDialogs, window: QWidget) -> None:
    """Fill the menu of the head."""
    menus.fill(menu, *talk_commands(talking, dialogs), menus.actions["Export…"], None)
    menus.add(tr("Face"), *face_commands(talking, dialogs), within=menu)
    rates = QActionGroup(window)
    for rate in PICTURE_RATES:
        action = rates.addAction(tr("{rate}/s").format(rate=rate))
        action.setCheckable(True)
        action.setData(rate)
    rates.triggered.connect(lambda action: talking.pictures.set_rate(action.data()))
    menus.add(tr("Pictures per Second"), *rates.actions(), within=menu)

    def show_looks() -> None:
        menus.show_checked("Wireframe (W)", dialogs.wireframe)
        for action in rates.actions():
            action.setChecked(action.data() == talking.pictures.rate)

    menu.aboutToShow.connect(partial(show_talk, menus, talking))
    menu.aboutToShow.connect(show_looks)
    menu.addMenu(ComparisonMenu(talking.text.drivers, talking.comparison, window))


def show_talk(menus: Menus, talking: TalkModel) -> None:
    """Allow what can be done with the text now, and show what is switched on."""
    texts = talking.text
    menus.show_checked("Edit Keys", talking.keys.open)
    menus.show_checked("Read Notation Literally", texts.literal)
    menus.actions["Remove Lexicon"].setEnabled(texts.lexicon_path is not None)
    menus.actions["Save Words and Phones…"].setEnabled(texts.edits.possible)
    menus.actions["Save Keys"].setEnabled(talking.keys.has_unsaved_changes)
    for text in ("Next Poor Match", "Previous Poor Match"):
        menus.actions[text].setEnabled(bool(texts.edits.poor))


class TalkParts:
    """The dialogs, the heads and the menu; the menu is filled.

    Attributes
    ----------
    model : what they show.
    dialogs : ask what the page needs.
    heads : move all that are seen.
    """

    def __init__(
        self, window: QMainWindow, model: TalkModel, theme: Theme, settings: QSettings, files: FileAsker,
        menus: Menus, menu: QMenu,
    ) -> None:  # fmt: skip
        self.model, self._theme, self._menus = model, theme, menus
        self.dialogs = TalkDialogs(window, model, settings, files)
        self.heads = Heads(model)
        fill_talk_menu(menus, menu, model, self.dialogs, window)

    def add_head(self, name: str) -> HeadView:
        """Return a head that moves where it is seen; it is called so in every window."""
        return self.heads.add(name, HeadView(self.model.head, self._theme))

    def make_page(self) -> TalkPage:
        """Return the page, whose head moves where it is seen."""
        page = TalkPage(self.model, self._theme)
        self.dialogs.join(page)
        self.heads.add("page", page.head, page)
        return page

    def show(self) -> list[Lane]:
        """Show in the menu what can be done with the text now; return the lanes of what is said."""
        show_talk(self._menus, self.model)
        return spoken_lanes(self.model.text)
