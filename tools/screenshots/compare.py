"""Takes a picture of two heads that say the same in step: run by screenshots.py."""

import sys
from pathlib import Path

from phonemeengine import Voice, build_table, make_corpus, speak
from phonemeengine.mouth.animation import FaceDriver
from phonemeengine.performance.making import sentences
from tools.bench.desktop import live_for
from tools.screenshots.desktops import TALK, shown_desktop

MINUTES = 4
LANGUAGE, TEXT = "en-us", "Please bring my blue bowl to the old farmer. Yes, the sheep are happy."


def main(out: Path, theme: str, width: int, height: int, at: float, language: str) -> None:
    """Have a recorded face say a text up to a time, beside the rules, and save what the page shows then."""
    with shown_desktop((width, height), theme, language) as (desktop, folder):
        table = _table_in(folder)
        desktop.window.show_page(TALK)
        texts, drivers = desktop.talking.text, desktop.talking.text.drivers
        desktop.talking.set_blinks(False)
        drivers.performance.open(table)
        while desktop.talking.face.states is None or drivers.performance.table is None:
            live_for(0.1)
        drivers.compare(FaceDriver.RULES)
        texts.set_text(TEXT)
        texts.set_language(LANGUAGE)
        texts.say()
        while desktop.session.source.position < at:
            live_for(0.01)
        desktop.session.pause()
        while desktop.talking.comparison.found is None:
            live_for(0.1)
        live_for(0.5)
        desktop.window.redraw.timer.stop()  # for a picture without jagged edges
        live_for(1.0)
        desktop.window.banner.show_error("")
        desktop.talking.set_blinks(True)
        desktop.window.grab().save(str(out), "PNG")


def _table_in(folder: Path) -> Path:
    """Have a synthetic performer read, and build a table of that."""
    voice = Voice(LANGUAGE)
    make_corpus(folder / "corpus", sentences(1), lambda text: speak(text, voice), seconds=60 * MINUTES)
    build_table(folder / "corpus", folder / "synthia.sqlite", name="Synthia")
    return folder / "synthia.sqlite"


if __name__ == "__main__":
    main(Path(sys.argv[1]), sys.argv[2], int(sys.argv[3]), int(sys.argv[4]), float(sys.argv[5]), sys.argv[6])
