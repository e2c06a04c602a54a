"""`python -m phonemeanalyser` and the `phonemeanalyser` command."""

import sys

from phonemeanalyser.cli.main import main

if __name__ == "__main__":
    sys.exit(main())
