"""`python -m phonemeanalyser` and the `phonemeanalyser` command."""

import multiprocessing
import sys

try:
    from phonemeanalyser.cli.main import main
except KeyboardInterrupt:  # while modules are loaded, which takes half a second
    sys.stderr.write("phonemeanalyser: stopped\n")
    sys.exit(130)

if __name__ == "__main__":
    multiprocessing.freeze_support()  # a program that is bundled starts itself again for each core
    sys.exit(main())
