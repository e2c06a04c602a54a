"""The models of the desktop live without any window."""

import subprocess
import sys
from pathlib import Path

import phonemeanalyser.desktop

DESKTOP = Path(phonemeanalyser.desktop.__file__).parent


def models() -> list[str]:
    """The modules whose names say that they are models, those of the session, and the queue of tasks."""
    files = [*DESKTOP.glob("*/*model.py"), *DESKTOP.glob("session/*.py"), DESKTOP / "tasks.py"]
    return [
        ".".join(("phonemeanalyser", "desktop", *file.relative_to(DESKTOP).with_suffix("").parts)) for file in files
    ]


def test_models_are_imported_without_widgets_and_plots() -> None:
    program = f"import sys, {', '.join(models())}; print(*sys.modules)"
    loaded = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True
    ).stdout.split()
    assert "PySide6.QtCore" in loaded
    assert not {"PySide6.QtWidgets", "pyqtgraph"} & set(loaded)
