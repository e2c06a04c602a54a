"""A home of the tests' own: what the user has set, kept and recorded is neither read nor written by them.

Programs that tests start inherit the environment, and with it this home.
"""

import os
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
OF_XDG = ("DATA_HOME", "CONFIG_HOME", "CACHE_HOME", "STATE_HOME", "MUSIC_DIR", "DOCUMENTS_DIR")
OF_WINDOWS = {"APPDATA": "Roaming", "LOCAL_APPDATA": "Local", "PERSONAL": "Documents", "MYMUSIC": "Music"}
OF_TOOLS = {"PIP_CONFIG_FILE": (".config/pip/pip.conf", ".pip/pip.conf"), "NPM_CONFIG_USERCONFIG": (".npmrc",)}
"""Where pip and npm look for packages is the machine's matter, and stays."""


def environment_of(home: Path) -> dict[str, str]:
    """Return the variables that have the program keep everything in a home, on Linux, macOS and Windows.

    Those of XDG are empty, which means: as the home has it.
    """
    homes = dict.fromkeys(("HOME", "USERPROFILE", "CFFIXED_USER_HOME"), str(home))
    folders = {f"WIN_PD_OVERRIDE_{name}": str(home / folder) for name, folder in OF_WINDOWS.items()}
    known = {"APPDATA": folders["WIN_PD_OVERRIDE_APPDATA"], "LOCALAPPDATA": folders["WIN_PD_OVERRIDE_LOCAL_APPDATA"]}
    return homes | folders | known | {f"XDG_{name}": "" for name in OF_XDG} | {"PHONEMEANALYSER_WHISPER": "off"}


def home_of_this_run() -> dict[str, str]:
    """Return the variables of a new home, or none in a worker of a run, which has that of the run."""
    if "PYTEST_XDIST_WORKER" in os.environ:
        return {}
    real = Path.home()
    kept = {
        variable: str(real / name)
        for variable, names in OF_TOOLS.items()
        for name in names
        if variable not in os.environ and (real / name).is_file()
    }
    kept.setdefault("ZIG_GLOBAL_CACHE_DIR", os.environ.get("ZIG_GLOBAL_CACHE_DIR", str(ROOT / "build" / "zig")))
    home = Path(tempfile.mkdtemp(prefix="phonemeanalyser-home-"))
    shaders = {"MESA_SHADER_CACHE_DIR": str(home / "shaders")}  # Mesa keeps none where XDG_CACHE_HOME is empty
    return kept | shaders | environment_of(home)
