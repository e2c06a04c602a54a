"""Opens networks for ONNX Runtime, on the processor: the only module that imports onnxruntime."""

from importlib.util import find_spec
from pathlib import Path
from typing import Any

from phonemeengine.errors import ModelError

LIBRARY = "onnxruntime"
ERRORS_ALONE = 3
"""The library's own level of what it writes to the standard error output."""


def has_runtime() -> bool:
    """Return whether the library is installed, without opening it."""
    return find_spec(LIBRARY) is not None


def open_session(model: Path | bytes, n_threads: int) -> Any:
    """Return an ``onnxruntime.InferenceSession``.

    Parameters
    ----------
    model : a file, or its content.
    n_threads : that work on a run.

    Raises
    ------
    ModelError : onnxruntime is not installed, or it cannot open the model; why, in its words.
    """
    try:
        import onnxruntime  # noqa: PLC0415 - it is an extra
    except ImportError as error:
        raise ModelError(
            "the speech encoder needs onnxruntime, which is not installed; install phonemeanalyser[encoder]"
        ) from error
    onnxruntime.disable_telemetry_events()  # of Windows; nothing about a sound leaves the program
    options = onnxruntime.SessionOptions()
    options.intra_op_num_threads = n_threads
    options.log_severity_level = ERRORS_ALONE
    # threads that wait for the next operator sleep, instead of taking a core from other programs
    options.add_session_config_entry("session.intra_op.allow_spinning", "0")
    source = model if isinstance(model, bytes) else str(model)
    try:
        return onnxruntime.InferenceSession(source, options, providers=["CPUExecutionProvider"])
    except Exception as error:  # the library raises its own, which have nothing but Exception in common
        raise ModelError(f"the network cannot be opened ({first_line(error)}); get it anew") from error


def first_line(error: Exception) -> str:
    """Return the first sentence of what a library says went wrong, for a place in ours."""
    words = (str(error).strip() or type(error).__name__).splitlines()[0]
    return words.removeprefix("Got: ").split(". ")[0][:160]
