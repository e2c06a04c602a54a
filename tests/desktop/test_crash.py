"""A bug in the window is told once in a dialog, and kept in the log beside the settings."""

import os
import subprocess
import sys
from pathlib import Path

from phonemeanalyser.cli.window import DEMO

PROGRAM = """
import sys
from pathlib import Path
from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QMessageBox
from phonemeanalyser.desktop.app import make_application, run

def crash():
    app.quit()
    raise ZeroDivisionError("a bug")

QMessageBox.critical = lambda _parent, _title, text: print(text, flush=True)
app = make_application()
QTimer.singleShot(0, crash)
sys.exit(run(Path(sys.argv[1]), Path(sys.argv[1])))
"""


def test_a_crash_is_shown_and_kept_with_where_it_happened(tmp_path: Path) -> None:
    places = {name: str(tmp_path / name) for name in ("HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME")}
    done = subprocess.run(
        [sys.executable, "-c", PROGRAM, str(DEMO)],
        env=os.environ | places | {"QT_QPA_PLATFORM": "offscreen"},
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    (log,) = tmp_path.rglob("phonemeanalyser.log")
    assert done.returncode == 0, done.stderr
    assert done.stdout == f"Internal error. Details are in {log}; send that file with your report.\n"
    assert "ERROR phonemeanalyser.desktop.app: the program crashed\nTraceback" in log.read_text()
    assert "ZeroDivisionError: a bug" in log.read_text()
