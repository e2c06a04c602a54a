"""Write mouth cues for a folder: Rhubarb's JSON beside every sound in it, however deep.

python examples/rhubarb_folder.py FOLDER
"""

import sys
from pathlib import Path

from phonemeengine import EngineError, export, load_preset, sounds_under


def main(folder: str) -> None:
    """Write NAME.json for each sound NAME; `FORMATS` lists what else can be written."""
    preset = load_preset("learned")
    for sound in sounds_under(Path(folder)):
        export(sound, sound.with_suffix(".json"), "rhubarb-json", preset)
        print(sound.with_suffix(".json"))


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except EngineError as error:
        sys.exit(str(error))
