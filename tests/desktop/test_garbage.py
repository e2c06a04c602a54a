"""Garbage is collected in the thread of the window, whichever thread makes it: Qt's objects die where they live."""

import gc
import threading
import weakref

from PySide6.QtCore import QSettings
from PySide6.QtWidgets import QApplication

from phonemeanalyser.desktop.app import Desktop, WindowThreadCollector
from phonemeanalyser.desktop.session.microphone import Microphone
from phonemeengine.audio.output import ClockOutput
from tests.desktop.hands import shown


class Ring:
    """Refers to itself, so that only the collector can end it."""

    def __init__(self, ended: list[int]) -> None:
        self.me = self
        weakref.finalize(self, lambda: ended.append(threading.get_ident()))


def litter(n: int, ended: list[int]) -> None:
    """Make garbage in another thread, more than any threshold."""
    thread = threading.Thread(target=lambda: [Ring(ended) for _ in range(n)] and None)
    thread.start()
    thread.join()


def test_what_another_thread_leaves_is_collected_in_the_thread_of_the_window(
    qtbot, collector: WindowThreadCollector
) -> None:
    ended: list[int] = []
    litter(20 * gc.get_threshold()[0], ended)
    assert ended == []
    qtbot.waitUntil(lambda: len(ended) == 20 * gc.get_threshold()[0])
    assert set(ended) == {threading.get_ident()}


def test_python_collects_again_when_the_program_has_ended(collector: WindowThreadCollector) -> None:
    another = WindowThreadCollector()
    assert not gc.isenabled()
    another.close()
    assert gc.isenabled()
    gc.disable()  # the one of the tests goes on


def test_a_program_that_was_closed_and_a_window_that_another_replaced_are_forgotten(
    qapp: QApplication, settings: QSettings, no_microphone: Microphone, qtbot
) -> None:
    desktop = Desktop(qapp, settings, lambda _n: ClockOutput(), no_microphone)
    for page in range(shown(desktop, qtbot).pages.count()):
        desktop.window.show_page(page)
    known: list[weakref.ref[object]] = [weakref.ref(desktop.window)]
    desktop.set_theme("dark")
    desktop.close()
    known += [weakref.ref(desktop.window), weakref.ref(desktop.session), weakref.ref(desktop.talking)]
    del desktop

    def forgotten() -> bool:
        gc.collect()
        return all(each() is None for each in known)

    qtbot.waitUntil(forgotten)  # what works in the background knows them for a moment
