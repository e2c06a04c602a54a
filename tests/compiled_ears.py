"""The shipped ear as a library that Python calls, compiled once for all tests of a version."""

import ctypes
import getpass
import hashlib
import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable, Sequence
from pathlib import Path

import filelock
import numpy as np
import pytest
from numpy.typing import NDArray

from phonemeengine.settings import SAMPLE_RATE
from phonemeengine.shipping import targets
from tests.sounds import Sound

SOURCES = Path(targets.__file__).parent / "c"
COMPILERS = "gcc", "clang"
ZIG = (sys.executable, "-m", "ziglang", "cc")
STRICT = ("-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Werror")
SANITIZED = (
    "-O1",
    "-g",
    "-fsanitize=address,undefined,float-divide-by-zero,float-cast-overflow",
    "-fno-sanitize-recover=all",
)
N_PHONEMES, MOST_VISEMES = 11, 32
LAST_FRAMES = 32
OK, NO_EAR_FILE, NEWER_FILE, DAMAGED_FILE, OUT_OF_MEMORY, TOO_LITTLE_MEMORY, BAD_RATE, TOO_FEW_FRAMES = range(8)
FRAME = np.dtype(
    [
        ("number", np.uint32),
        ("phoneme", np.int32),
        ("viseme", np.int32),
        ("intensity", np.float32),
        ("confidence", np.float32),
        ("scores", np.float32, N_PHONEMES),
        ("viseme_scores", np.float32, MOST_VISEMES),
    ]
)
"""`ear_frame`."""

Frames = NDArray[np.void]


def compiler(*names: str) -> str:
    """Give the first of these C compilers that is there, or any; that none is where one should be is a failure."""
    names = names or (*COMPILERS, "cc")
    found = next((path for name in names if (path := shutil.which(name))), None)
    if found is None and "CI" in os.environ and os.name == "posix":
        pytest.fail(f"there is no C compiler; install {names[0]}")
    if found is None:
        pytest.skip(f"there is no C compiler {names[0]}")
    return found


def compiled(name: str, sources: Sequence[Path], *flags: str, by: str = "") -> Path:
    """Compile C sources, unless that has been done; one process at a time, all others wait for it."""
    command = [
        *(ZIG if by == "zig" else (by or compiler(),)),
        *STRICT,
        *flags,
        "-I",
        str(SOURCES),
        *map(str, sources),
    ]
    digest = hashlib.sha256(repr(command).encode())
    for path in (*sources, *sorted(SOURCES.glob("*.h"))):
        digest.update(path.read_bytes())
    place = Path(tempfile.gettempdir()) / f"phonemeanalyser-ears-{getpass.getuser()}" / digest.hexdigest()[:16]
    place.mkdir(parents=True, exist_ok=True)
    target = place / name
    with filelock.FileLock(place / "lock"):
        if not target.exists():
            part = place / "part"
            done = subprocess.run([*command, "-lm", "-o", str(part)], capture_output=True, text=True, check=False)
            assert done.returncode == 0, done.stderr
            part.replace(target)
    return target


class EarLibrary:
    """The functions of `ear.h`."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self.c = ctypes.CDLL(str(path))
        self.c.ear_error_text.restype = ctypes.c_char_p
        self.c.ear_latency.restype = ctypes.c_double
        self.c.ear_version.restype = ctypes.c_char_p
        names = (
            "ear_table_shape_name",
            "ear_table_movestate",
            "ear_table_name",
            "ear_model_name",
            "ear_model_viseme",
        )
        for name in names:
            getattr(self.c, name).restype = ctypes.c_char_p

    def text(self, code: int) -> str:
        """Give what an error says."""
        return bytes(self.c.ear_error_text(code)).decode()

    def visemes(self, model: "CModel") -> tuple[str, ...]:
        """Give the names of the visemes that a model tells apart."""
        n = self.c.ear_model_visemes(model.handle)
        return tuple(bytes(self.c.ear_model_viseme(model.handle, k)).decode() for k in range(n))

    def model_size(self, content: bytes) -> tuple[int, int]:
        """Give the result of checking a file, and how much memory its model needs."""
        size = ctypes.c_size_t()
        return self.c.ear_model_size(content, ctypes.c_size_t(len(content)), ctypes.byref(size)), size.value


class CModel:
    """An open model; all memory that it is given is Python's."""

    def __init__(self, library: EarLibrary, content: bytes) -> None:
        self.library, self.handle = library, ctypes.c_void_p()
        result, size = library.model_size(content)
        assert result == OK, library.text(result)
        self._memory = ctypes.create_string_buffer(size)
        self.size = size
        result = library.c.ear_model_open(
            content, ctypes.c_size_t(len(content)), self._memory, ctypes.c_size_t(size), ctypes.byref(self.handle)
        )
        assert result == OK, library.text(result)


class CEar:
    """An ear that listens with a model."""

    def __init__(self, model: CModel, rate: int = SAMPLE_RATE) -> None:
        self.model, self.rate, self._c = model, rate, model.library.c
        size, self.handle = ctypes.c_size_t(), ctypes.c_void_p()
        self._ask(self._c.ear_size(model.handle, rate, ctypes.byref(size)))
        self.size, self._memory = size.value, ctypes.create_string_buffer(size.value)
        words = self._memory, size, ctypes.byref(self.handle)
        self._ask(self._c.ear_open_sized(model.handle, rate, ctypes.c_size_t(FRAME.itemsize), *words))
        self.latency = self._c.ear_latency(self.handle)

    def push(self, samples: Sound) -> Frames:
        """Take samples, and give the frames that became known."""
        return self._pushed(self._c.ear_push, np.ascontiguousarray(samples, np.float32))

    def push_channels(self, samples: NDArray[np.float32 | np.int16]) -> Frames:
        """Take samples of several channels, shape (n, n_channels), and give the frames that became known."""
        by = self._c.ear_push_int16 if samples.dtype == np.int16 else self._c.ear_push_channels
        return self._pushed(by, np.ascontiguousarray(samples), samples.shape[1])

    def _pushed(self, by: Callable[..., int], samples: NDArray[np.generic], *channels: int) -> Frames:
        frames = np.zeros(len(samples) * 100 // self.rate + 2, FRAME)
        n = ctypes.c_size_t()
        words = samples.ctypes.data_as(ctypes.c_void_p), ctypes.c_size_t(len(samples)), *channels
        self._ask(by(self.handle, *words, *_room(frames), ctypes.byref(n)))
        return frames[: n.value]

    def finish(self) -> Frames:
        """Give the last frames."""
        frames, n = np.zeros(LAST_FRAMES, FRAME), ctypes.c_size_t()
        self._ask(self._c.ear_finish(self.handle, *_room(frames), ctypes.byref(n)))
        return frames[: n.value]

    def hear(self, sound: Sound, cuts: Sequence[int] = ()) -> Frames:
        """Give the frames of a whole sound, which comes in pieces."""
        return np.concatenate([*map(self.push, np.split(sound, list(cuts))), self.finish()])

    def _ask(self, result: int) -> None:
        assert result == OK, self.model.library.text(result)


class CMouth:
    """A mouth that moves by a table of a model."""

    def __init__(self, model: CModel, table: str, seed: int) -> None:
        self._c, self._model, self.handle = model.library.c, model, ctypes.c_void_p()
        number = self._c.ear_table_find(model.handle, table.encode())
        self._weights = np.zeros(self._c.ear_table_movestates(model.handle, number), np.float32)
        size = ctypes.c_size_t()
        assert self._c.ear_mouth_size(model.handle, number, ctypes.byref(size)) == OK
        self._memory = ctypes.create_string_buffer(size.value)
        opened = self._c.ear_mouth_open(model.handle, number, seed, self._memory, size, ctypes.byref(self.handle))
        assert opened == OK

    def add(self, time: float, phoneme: int, viseme: int, intensity: float) -> None:
        """Take what is heard from a time on."""
        self._c.ear_mouth_hear(self.handle, ctypes.c_double(time), phoneme, viseme, ctypes.c_float(intensity))

    def weights(self, time: float) -> NDArray[np.float32]:
        """Give the weights of the movestates at a time."""
        self._c.ear_mouth_weights(self.handle, ctypes.c_double(time), self._weights.ctypes.data_as(ctypes.c_void_p))
        return self._weights.copy()


def _room(frames: Frames) -> tuple[ctypes.c_void_p, ctypes.c_size_t]:
    return frames.ctypes.data_as(ctypes.c_void_p), ctypes.c_size_t(len(frames))


def ear_library(by: str = "") -> EarLibrary:
    """Compile the ear as a library, and load it."""
    return EarLibrary(compiled("libear.so", [SOURCES / "ear.c"], "-O3", "-shared", "-fPIC", by=by))
