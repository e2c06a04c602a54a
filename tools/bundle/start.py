"""What a bundled program begins with."""

import multiprocessing
import sys

from phonemeanalyser.cli.main import main

if __name__ == "__main__":
    multiprocessing.freeze_support()
    if sys.argv[1:2] == [
        "-c"
    ]:  # as the engine asks another process of Python for the devices, which here is this program
        exec(sys.argv[2])
        sys.exit()
    sys.exit(main())
