"""``phonemeanalyser measure``: what a stretch of a sound is like; and the stretch as sound or spectrum."""

import argparse
import sys
from pathlib import Path

from tqdm import tqdm

from phonemeanalyser.cli.arguments import add_channel, add_ear, add_overwrite, add_preset, number
from phonemeanalyser.cli.jobs import file_preset
from phonemeanalyser.cli.output_files import Guard, write_whole
from phonemeengine import SoundReader, average_spectrum, measure, save_stretch
from phonemeengine.averaged_spectrum import FORMAT, save_averaged_spectrum
from phonemeengine.dsp.formants import CEILING
from phonemeengine.files import begins_like
from phonemeengine.measurement import MEASUREMENT_COLUMNS, format_measurement

HEADING = ",".join(MEASUREMENT_COLUMNS).encode()


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what is measured, and where that goes."""
    parser.add_argument("sound", type=Path, metavar="SOUND", help="sound file")
    parser.add_argument("--from", type=number, default=0.0, dest="start", metavar="S", help="begin, seconds (0)")
    parser.add_argument("--to", type=number, dest="end", metavar="S", help="end, seconds (default: the sound's)")
    parser.add_argument("-o", "--out", type=Path, help="table, .csv (default: print)")
    parser.add_argument("--sound-out", type=Path, metavar="WAV", help="write the stretch as a sound, too")
    parser.add_argument("--spectrum-out", type=Path, metavar="CSV", help="write its averaged spectrum, too")
    parser.add_argument(
        "--ceiling", type=number, default=CEILING, metavar="HZ", help=f"formants lie below it ({CEILING:g})"
    )
    add_preset(parser)
    add_ear(parser)
    add_channel(parser)
    add_overwrite(parser)


def run(options: argparse.Namespace) -> int:
    """Measure; returns the exit code."""
    preset, table = file_preset(options.preset, options.ear), Guard(begins_like(HEADING), options.overwrite)
    table.check(options.out)
    Guard(begins_like(f"# {FORMAT}".encode()), options.overwrite).check(options.spectrum_out)
    Guard(lambda _content: False, options.overwrite).check(options.sound_out)  # a sound may be anybody's
    with SoundReader(options.sound, options.channel) as reader:
        end = reader.duration if options.end is None else options.end
    stretch = (options.sound, options.start, end)
    with tqdm(total=100, unit="%", file=sys.stderr, disable=None, leave=False, desc=options.sound.name) as bar:
        found = measure(
            *stretch, preset, channel=options.channel, ceiling=options.ceiling,
            progress=lambda share: bool(bar.update(100 * share - bar.n)) or True,
        )  # fmt: skip
    if options.out is None:
        print(format_measurement(found), end="")
    else:
        write_whole(options.out, lambda file: print(format_measurement(found), file=file, end=""), table)
    if options.sound_out is not None:
        save_stretch(*stretch, options.sound_out, channel=options.channel)
    if options.spectrum_out is not None:
        name = options.spectrum_out.stem
        save_averaged_spectrum(
            average_spectrum(*stretch, preset, name, channel=options.channel), options.spectrum_out
        )
    return 0
