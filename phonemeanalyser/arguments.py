"""Arguments that several commands have."""

import argparse


def add_overwrite(parser: argparse.ArgumentParser) -> None:
    """Let the user give up files that are in the way."""
    parser.add_argument("--overwrite", action="store_true", help="replace files that are not this program's, too")
