"""What a bundled program begins with."""

import multiprocessing
import sys

from phonemeanalyser.cli.main import main

if __name__ == "__main__":
    multiprocessing.freeze_support()
    if sys.argv[1:2] == ["-c"]:  # as Python does: the engine asks another process for the devices, which is this one
        code, sys.argv = sys.argv[2], ["-c", *sys.argv[3:]]
        exec(code, {"__name__": "__main__"})
        sys.exit()
    sys.exit(main())
