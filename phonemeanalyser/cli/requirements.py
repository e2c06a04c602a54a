"""What commands need that may be missing: packages that most do without, and a display for a window."""

import ctypes
import importlib
import socket
import sys
from collections.abc import Mapping
from pathlib import Path
from types import ModuleType

from phonemeengine import EngineError


def module_that_draws(name: str) -> ModuleType:
    """Import a module of this package that needs those of previews.

    Raises
    ------
    EngineError : they are not installed.
    """
    return _imported(f"phonemeanalyser.cli.{name}", "previews need", "preview")


def module_that_serves() -> ModuleType:
    """Import the server.

    Raises
    ------
    EngineError : the packages that it needs are not installed.
    """
    return _imported("phonemeanalyser.server.service", "a server needs", "server")


def _imported(name: str, needing: str, extra: str) -> ModuleType:
    try:
        return importlib.import_module(name)
    except ImportError as error:
        raise EngineError(
            f"{needing} packages that cannot be loaded ({error}); install them with: pip install "
            f"'phonemeanalyser[{extra}]'"
        ) from error


XCB_LIBRARIES = {
    "libxcb-cursor.so.0": "libxcb-cursor0",
    "libxcb-icccm.so.4": "libxcb-icccm4",
    "libxcb-image.so.0": "libxcb-image0",
    "libxcb-keysyms.so.1": "libxcb-keysyms1",
    "libxcb-randr.so.0": "libxcb-randr0",
    "libxcb-render-util.so.0": "libxcb-render-util0",
    "libxcb-shape.so.0": "libxcb-shape0",
    "libxcb-xinerama.so.0": "libxcb-xinerama0",
    "libxcb-xkb.so.1": "libxcb-xkb1",
    "libxkbcommon-x11.so.0": "libxkbcommon-x11-0",
    "libX11-xcb.so.1": "libx11-xcb1",
}
"""What Qt needs for a window under X11, and the Debian package of each."""
HINT = "to see it as a picture, use: phonemeanalyser screenshot FILE -o PNG"


def why_no_window(environment: Mapping[str, str]) -> str:
    """Return in a sentence why no window can be opened and what to do; an empty text if one can."""
    platform = environment.get("QT_QPA_PLATFORM") or "wayland;xcb"
    wayland, x11 = "wayland" in platform, "xcb" in platform
    if not sys.platform.startswith("linux") or not (wayland or x11):
        return ""  # such as offscreen, which needs no display
    if wayland and _wayland_answers(environment):
        return ""
    if not (x11 and environment.get("DISPLAY")):
        return f"there is no display to open a window on; run it on a desktop, or {HINT}"
    missing = [package for library, package in XCB_LIBRARIES.items() if not _loads(library)]
    if missing:
        return f"the window needs system libraries; install them with: apt-get install {' '.join(missing)}"
    if not _x_answers():
        return f"the display {environment['DISPLAY']} does not answer; check DISPLAY, or {HINT}"
    return ""


def load_desktop() -> ModuleType:
    """Import the desktop, which needs Qt; analysing files does not.

    Raises
    ------
    EngineError : Qt, or what it needs, is not there.
    """
    try:
        return importlib.import_module("phonemeanalyser.desktop.app")
    except ImportError as error:
        raise EngineError(why_no_qt(error)) from error


def why_no_qt(error: ImportError) -> str:
    """Return in a sentence what an import of Qt lacks and what to do."""
    text = str(error)
    if ".so" in text:
        library = text.split(":", maxsplit=1)[0]
        return (
            f"the window needs the system library {library}; install it, on Debian with: apt-get install "
            "libgl1 libegl1 libfontconfig1 libglib2.0-0 libdbus-1-3 libxkbcommon0"
        )
    return f"the window needs the desktop parts ({text}); install them with: pip install 'phonemeanalyser[desktop]'"


def _wayland_answers(environment: Mapping[str, str]) -> bool:
    name = environment.get("WAYLAND_DISPLAY")
    if not name:
        return False
    path = Path(environment.get("XDG_RUNTIME_DIR", "/")) / name
    try:
        with socket.socket(socket.AF_UNIX) as connection:
            return connection.connect_ex(str(path)) == 0
    except OSError:  # a path too long for a socket
        return False


def _loads(library: str) -> bool:
    try:
        ctypes.CDLL(library)
    except OSError:
        return False
    return True


def _x_answers() -> bool:
    """Ask the X server as Qt will; a broken connection is an error, not an abort."""
    xcb = ctypes.CDLL("libxcb.so.1")
    xcb.xcb_connect.restype = ctypes.c_void_p
    connection = ctypes.c_void_p(xcb.xcb_connect(None, None))
    answers: bool = xcb.xcb_connection_has_error(connection) == 0
    xcb.xcb_disconnect(connection)
    return answers
