"""The tests; their matrices have one thread, like those of the program."""

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
