"""Garbage is collected in the thread of the window, whichever thread makes it: Qt's objects die where they live."""

import gc
import threading
import weakref

from phonemeanalyser.desktop.garbage import WindowThreadCollector


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
