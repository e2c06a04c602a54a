"""`python -m phonemeanalyser` and the `phonemeanalyser` command."""

import multiprocessing
import sys

from phonemeanalyser.cli.main import main

if __name__ == "__main__":
    multiprocessing.freeze_support()  # a program that is bundled starts itself again for each core
    sys.exit(main())
