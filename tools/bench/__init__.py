"""The figures that a change may not make worse; `python -m tools.bench` prints them.

They are timings, so they are no tests. Each is a ratio to a reference that is measured in the same run, or to a limit
that is scaled by how fast the machine is.
"""

import os
import sys

PINS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")
"""What keeps the arithmetic on one core; read when NumPy is first imported, so they stand here."""

FOREIGN = ("OPENBLAS_CORETYPE", "OPENBLAS_L2_SIZE", "PYTHONDONTWRITEBYTECODE")
"""What machines for tests have set and users' have not: arithmetic for another processor, and modules that are
compiled anew at each start."""

os.environ.update(dict.fromkeys(PINS, "1"))
if sys.argv[0] == "-m":  # begun as a program; who imports it for a test keeps what it has
    for name in FOREIGN:
        os.environ.pop(name, None)
