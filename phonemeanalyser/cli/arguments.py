"""Arguments that several commands have."""

import argparse
from collections.abc import Iterable, Mapping
from dataclasses import fields
from pathlib import Path
from typing import Any

from phonemeanalyser.cli.parser import MOST_JOBS, add_declared, place, whole_in
from phonemeengine import FORMATS
from phonemeengine.conversion.options import EXPRESSED, OPTIONS, PICTURED, WEIGHTED, ConversionOptions
from phonemeengine.errors import OptionError
from phonemeengine.mouth.exports.formats import formats_for

HEARD = ("preset", "model", "decoder", "channel")
SAID = ("text", "script", "speaker", "language", "lexicon", "literal", "accept-text")
MOVED = ("anticipation", *WEIGHTED, "no-blinks", "no-head", *EXPRESSED)
"""Options of conversions that commands share: of recognition, the text, a face's movement, and its driver."""


def add_options(parser: argparse.ArgumentParser, *names: str, **defaults: Any) -> None:
    """Let the user give options of conversions; see `phonemeanalyser.cli.parser.add_declared`."""
    add_declared(parser, OPTIONS, *names, **defaults)


def given(options: argparse.Namespace, **values: Any) -> ConversionOptions:
    """Return the options of conversions that a command line gives.

    Parameters
    ----------
    values : of those that it names otherwise.

    Raises
    ------
    OptionError : one goes with another one that is not there.
    """
    found = {each.name: getattr(options, each.name) for each in fields(ConversionOptions) if each.name in options}
    several = {name: tuple(found[name] or ()) for name, option in OPTIONS.items() if option.several and name in found}
    return ConversionOptions(**found | several | values)


def refuse_unused(options: argparse.Namespace, names: Iterable[str], why: str) -> None:
    """Refuse options that were given, and that nothing uses.

    Parameters
    ----------
    names : of the options.
    why : the end of a sentence that begins with the option.

    Raises
    ------
    OptionError : one was given.
    """
    for name in names:
        key = name.replace("-", "_")
        if getattr(options, key) != options.parser.get_default(key):
            raise OptionError(f"--{name} {why}")


def add_sounds(parser: argparse.ArgumentParser) -> None:
    """Have the user name sound files, and where to write what comes of them."""
    parser.add_argument("inputs", type=place, nargs="+", metavar="INPUT", help="audio files, or folders of them")
    parser.add_argument(
        "-o", "--out", type=place, metavar="OUT", help="folder, or file for one audio file (default: print)"
    )


def add_batch(parser: argparse.ArgumentParser) -> None:
    """Let the user say who works through many files."""
    words = "files at a time (default: one for each core, if that is faster)"
    parser.add_argument("--jobs", type=whole_in(1, MOST_JOBS), metavar="N", help=words)
    dask = "use an existing Dask cluster, such as tcp://host:8786"
    parser.add_argument("--dask", metavar="ADDRESS", help=dask)


def add_map(parser: argparse.ArgumentParser) -> None:
    """Let the user say what names in labels stand for."""
    parser.add_argument("--map", type=Path, metavar="FILE", help="phonemes for unknown names in the labels (TOML)")


def add_clip(parser: argparse.ArgumentParser) -> None:
    """Let the user say what clip is made."""
    out = "video (.mp4), .gif, or a folder for .png"
    parser.add_argument("-o", "--out", type=Path, required=True, metavar="OUT", help=out)
    add_options(parser, "fps", *PICTURED)


def add_examples(kinds: Any, examples: Mapping[str, tuple[str, ...]]) -> None:
    """End the help of each thing that a command does with its examples."""
    for name, parser in kinds.choices.items():
        parser.examples = examples[name]


def format_of(options: argparse.Namespace, out: Path | None) -> str:
    """Return the format of an export that was named by no --format, as its file ends.

    Parameters
    ----------
    out : the file; None where there is none, or a folder.
    """
    found = [] if out is None else formats_for(out.name)
    if len(found) != 1:
        several = f"several formats end as {out.name!r} does" if out is not None and found else "--format is missing"
        options.parser.error(f"{several}; choose one of {', '.join(found or FORMATS)}")
    return found[0]
