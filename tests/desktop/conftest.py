"""What the tests of the desktop share: no display, no sound card, and settings of their own."""

import gc
import os
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path

import pyqtgraph as pg
import pytest

from phonemeengine.settings import SAMPLE_RATE

os.environ |= {"LC_ALL": "C.UTF-8", "LANGUAGE": "en"}  # of the programs that tests start, wherever these run

from PySide6.QtCore import QEvent, QSettings
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from phonemeanalyser.desktop.app import Desktop, WindowThreadCollector
from phonemeanalyser.desktop.session.microphone import Microphone
from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeanalyser.desktop.session.session import Session
from phonemeengine.audio.output import ClockOutput
from phonemeengine.features.variables import Variable
from phonemeengine.live import player
from phonemeengine.presets.files import THESIS_PRESET, save_preset
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import WINDOW
from tests.desktop.hands import DialogHand, shown
from tests.desktop.lent_window import WindowLender, close_popups
from tests.desktop.studio import DESK, Booth, Studio
from tests.fakes.microphones import HandDrivenMicrophone
from tests.fakes.outputs import Outputs
from tests.fakes.players import PRESET

pg.setConfigOptions(mouseRateLimit=-1)  # each move of the mouse counts, however fast they follow
PATIENCE_MS = 300_000
STEP = 700
AHEAD = STEP + WINDOW // 2 + player.STEP  # half a window and a block beyond what is heard next


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Have Qt's warnings fail the tests of this folder; the engine's tests know nothing of Qt."""
    for item in items:
        if item.path.is_relative_to(Path(__file__).parent):
            item.add_marker(pytest.mark.qt_log_level_fail("WARNING"))
            item.add_marker(pytest.mark.qt_log_ignore("This plugin does not support"))


@pytest.hookimpl(wrapper=True)
def pytest_runtest_call(item: pytest.Item) -> Iterator[None]:
    """Draw the window that is lent while the test itself runs, and not at each step of its fixtures."""
    lender: WindowLender = item.funcargs["lender"]  # type: ignore[attr-defined]
    lender.draw(True)
    return (yield)


@pytest.hookimpl(wrapper=True)
def pytest_runtest_teardown(item: pytest.Item) -> Iterator[None]:
    """Draw no longer what fixtures take away."""
    if "lender" in item.funcargs:  # type: ignore[attr-defined]
        item.funcargs["lender"].draw(False)  # type: ignore[attr-defined]
    return (yield)


@pytest.fixture
def qtbot(qtbot: QtBot) -> QtBot:
    """A hand that waits for an event as long as the program does not hang, however busy the machine is."""
    for name in ("waitUntil", "waitSignal", "waitSignals", "waitActive", "waitExposed"):
        setattr(qtbot, name, partial(getattr(qtbot, name), timeout=PATIENCE_MS))
    return qtbot


def settings_in(folder: Path) -> QSettings:
    """Where a program keeps its choices; its window speaks English, whatever the system does."""
    settings = QSettings(str(folder / "settings" / "phonemeanalyser.ini"), QSettings.Format.IniFormat)
    settings.setValue("language", "en")
    return settings


@pytest.fixture
def settings(request: pytest.FixtureRequest, tmp_path: Path) -> QSettings:
    """Where the program keeps its choices, for one test only, or for as long as its window is lent."""
    return request.getfixturevalue("lender").settings if lends(request) else settings_in(tmp_path)


def lends(request: pytest.FixtureRequest) -> bool:
    """Say whether a test uses the window that is lent."""
    names = {*request.fixturenames}
    return bool(names & {"desktop", "open_booth"}) and not names & {"own_desktop", "open_own_booth"}


@pytest.fixture
def model(qapp: QApplication) -> PresetModel:
    """A model on the factory preset of the thesis."""
    return PresetModel(THESIS_PRESET)


@pytest.fixture
def mine(qapp: QApplication, tmp_path: Path) -> PresetModel:
    """A model on a user's own file."""
    save_preset(Preset(name="mine", variables=(Variable("own", 50, 90),)), tmp_path / "mine.toml")
    return PresetModel(tmp_path / "mine.toml")


@pytest.fixture(scope="package")
def collector(qapp: QApplication) -> Iterator[WindowThreadCollector]:
    """Keeps the collecting of windows to the thread of the tests, as the program does."""
    collector = WindowThreadCollector()
    yield collector
    collector.close()
    gc.freeze()  # again what no later collection need look through


@pytest.fixture(autouse=True)
def collected(
    request: pytest.FixtureRequest, collector: WindowThreadCollector, lender: WindowLender
) -> Iterator[None]:
    """Collects after each test what is due, since no event loop runs between tests; hides a window that rests."""
    close_popups()
    if not lends(request):
        lender.rest()
    yield
    collector.collect()


@pytest.fixture
def outputs() -> Outputs:
    """The outputs on which a session plays."""
    return Outputs()


@pytest.fixture
def no_microphone(qapp: QApplication, tmp_path: Path) -> Microphone:
    """A microphone that is not there, with folders of its own: tests neither listen nor record by accident."""
    return Studio(tmp_path).model


@pytest.fixture
def session(model: PresetModel, outputs: Outputs, no_microphone: Microphone) -> Iterator[Session]:
    """A session on outputs that the test moves."""
    session = Session(model, outputs, no_microphone)
    yield session
    session.close()


@pytest.fixture
def play(session: Session, outputs: Outputs, qtbot: QtBot) -> Callable[[float], None]:
    """Plays from where the session stands for some seconds, at most to the end."""

    def play(seconds: float) -> None:
        until = session.source.position + seconds
        session.play()
        while session.source.playing and session.source.position < until - 1e-9:
            qtbot.waitUntil(lambda: outputs.last.n_written - outputs.last.heard >= AHEAD or ended(session))
            outputs.last.move(min(STEP, (until - session.source.position) * SAMPLE_RATE))
            session.poll()

    return play


def ended(session: Session) -> bool:
    return session.source.player is not None and session.source.player.all_written


def begin(app: QApplication, settings: QSettings, microphone: Microphone) -> Desktop:
    """Begin the program, without a sound card and with the rules of the thesis."""
    desktop = Desktop(app, settings, lambda _n: ClockOutput(), microphone, PresetModel(THESIS_PRESET))
    _ = desktop.talking  # which the program makes after the first picture
    return desktop


def forget_windows(app: QApplication) -> None:
    """Free what closed windows held, some megabytes each; `collected` would come to it after a hundred tests only."""
    app.sendPostedEvents(None, QEvent.Type.DeferredDelete)  # processEvents leaves these
    gc.collect()


@pytest.fixture(scope="package")
def lenders(qapp: QApplication, tmp_path_factory: pytest.TempPathFactory) -> Iterator[dict[bool, WindowLender]]:
    """Lends one program with all its pages, and one with the page that it begins with."""
    made = {}
    for whole in (False, True):
        folder = tmp_path_factory.mktemp("lent")
        made[whole] = WindowLender(partial(begin, qapp), settings_in(folder), folder, whole=whole)
    yield made
    for lender in made.values():
        lender.close()


@pytest.fixture(scope="module")
def lender(request: pytest.FixtureRequest, lenders: dict[bool, WindowLender]) -> Iterator[WindowLender]:
    """Lends one program to all tests; those that begin or end it ask for `own_desktop`."""
    lender = lenders[request.path.parent.name in {"calibrate", "talk"}]
    yield lender
    lender.rest()


@pytest.fixture
def desktop(request: pytest.FixtureRequest, lender: WindowLender) -> Desktop:
    """The program with its window, without a sound card; it begins with the rules of the thesis.

    It is the one that is lent, unless the test uses `own_desktop`: since it ends it, or dresses it anew.
    """
    return request.getfixturevalue("own_desktop") if "own_desktop" in request.fixturenames else lender.lend()


@pytest.fixture
def own_desktop(qapp: QApplication, settings: QSettings, no_microphone: Microphone) -> Iterator[Desktop]:
    """The same, for one test only."""
    desktop = begin(qapp, settings, no_microphone)
    yield desktop
    desktop.close()
    del desktop
    forget_windows(qapp)


@pytest.fixture
def hand(qapp: QApplication) -> Iterator[DialogHand]:
    """Answers the dialogs that come."""
    hand = DialogHand()
    yield hand
    hand.rest()


@pytest.fixture
def mic() -> HandDrivenMicrophone:
    """The first microphone that is opened."""
    return HandDrivenMicrophone(name=DESK.label)


@pytest.fixture
def open_studio(qapp: QApplication, tmp_path: Path) -> Iterator[Callable[..., Studio]]:
    """Makes studios of microphones that are opened in turn."""
    studios: list[Studio] = []

    def make(*microphones: HandDrivenMicrophone | None) -> Studio:
        studios.append(Studio(tmp_path, *microphones))
        return studios[-1]

    yield make
    for studio in studios:
        studio.openers.may_answer.set()
        studio.model.close()


@pytest.fixture
def studio(open_studio: Callable[..., Studio], mic: HandDrivenMicrophone) -> Studio:
    """A studio that listens to one microphone, without a window."""
    studio = open_studio(mic)
    studio.model.listen(PRESET)
    return studio


@pytest.fixture
def open_booth(request: pytest.FixtureRequest, lender: WindowLender, qtbot: QtBot) -> Callable[..., Booth]:
    """Has the window listen to microphones that are opened in turn; a file is open.

    The window is the one that is lent, unless the test uses `open_own_booth`.
    """
    if "open_own_booth" in request.fixturenames:
        own: Callable[..., Booth] = request.getfixturevalue("open_own_booth")
        return own

    def make(*microphones: HandDrivenMicrophone | None) -> Booth:
        desktop = lender.lend()
        lender.studio.tidy(*microphones)
        booth = Booth(desktop, lender.settings, lender.studio, qtbot)
        shown(desktop, qtbot)
        return booth

    return make


@pytest.fixture
def open_own_booth(
    qapp: QApplication, settings: QSettings, qtbot: QtBot, open_studio: Callable[..., Studio]
) -> Iterator[Callable[..., Booth]]:
    """The same with a window for one test only."""
    booths: list[Booth] = []

    def make(*microphones: HandDrivenMicrophone | None) -> Booth:
        studio = open_studio(*microphones)
        booths.append(Booth(begin(qapp, settings, studio.model), settings, studio, qtbot))
        shown(booths[-1].desktop, qtbot)
        return booths[-1]

    yield make
    for booth in booths:
        booth.studio.openers.may_answer.set()
        booth.desktop.close()
    booths.clear()
    forget_windows(qapp)


@pytest.fixture
def booth(open_booth: Callable[..., Booth], mic: HandDrivenMicrophone) -> Booth:
    """A window that listens to one microphone."""
    booth = open_booth(mic)
    booth.listen()
    return booth
