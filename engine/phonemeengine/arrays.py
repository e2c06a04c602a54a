"""The array types of the engine: NumPy arrays by the type of their entries, whatever their shape."""

import numpy as np
from numpy.typing import NDArray

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
