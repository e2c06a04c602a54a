"""The desktop tool."""

import logging
import os

# On a busy machine, the threads of OpenBLAS wait for each other ten times as long as they work on small matrices.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

logging.getLogger(__name__).addHandler(logging.NullHandler())  # silent, unless a log is asked for
