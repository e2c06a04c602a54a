"""Takes a picture of the page of the head: run by screenshots.py."""

import sys
from pathlib import Path

from tools.bench.desktop import live_for
from tools.screenshots.desktops import DEMO, TALK, shown_desktop


def main(out: Path, theme: str, width: int, height: int, at: float, language: str) -> None:
    """Align the demo's text, have the head say it up to a time, and save what the page shows then."""
    with shown_desktop((width, height), theme, language) as (desktop, _):
        desktop.session.open(DEMO)
        desktop.window.show_page(TALK)
        desktop.talking.set_blinks(False)
        while desktop.talking.face.states is None:
            live_for(0.1)
        text = desktop.talking.text
        text.align()
        while text.utterance is None or text.busy:
            live_for(0.1)
        desktop.session.analyse_until(at)
        live_for(0.3)
        desktop.window.redraw.refresh_all()
        desktop.window.redraw.timer.stop()  # for a picture without jagged edges
        live_for(1.0)
        desktop.talking.set_blinks(True)
        desktop.window.grab().save(str(out), "PNG")


if __name__ == "__main__":
    main(Path(sys.argv[1]), sys.argv[2], int(sys.argv[3]), int(sys.argv[4]), float(sys.argv[5]), sys.argv[6])
