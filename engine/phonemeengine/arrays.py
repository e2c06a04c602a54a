"""The array types of the engine: NumPy arrays by the type of their entries, whatever their shape; and how values that
hold them are shown.
"""

from dataclasses import fields
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from typing_extensions import override

Float32Array = NDArray[np.float32]
Float64Array = NDArray[np.float64]
Int16Array = NDArray[np.int16]
UInt8Array = NDArray[np.uint8]
UInt32Array = NDArray[np.uint32]
Int64Array = NDArray[np.int64]
IndexArray = NDArray[np.intp]
BoolArray = NDArray[np.bool_]

LARGEST_FLOAT32 = 3.4028235e38
"""The largest number that fits, in the digits in which it is written."""

LONGEST_SHOWN = 40
"""Characters of a text that `ShortRepr` shows."""


class ShortRepr:
    """A dataclass with many numbers, whose `repr` is one line: plain values as they are, the rest by its size."""

    @override
    def __repr__(self) -> str:
        shown = (f"{field.name}={_shown(getattr(self, field.name))}" for field in fields(self) if field.repr)  # type: ignore[arg-type]
        return f"{type(self).__name__}({', '.join(shown)})"


def _shown(value: Any) -> str:
    if isinstance(value, str) and len(value) > LONGEST_SHOWN:
        return repr(value[:LONGEST_SHOWN] + "…")
    if value is None or isinstance(value, (str, int, float, Path)):
        return repr(value)
    if isinstance(value, np.ndarray):
        return f"<{value.dtype} {value.shape}>"
    return f"<{len(value)} of {type(value).__name__}>" if hasattr(value, "__len__") else f"<{type(value).__name__}>"
