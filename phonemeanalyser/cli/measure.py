"""``phonemeanalyser measure``: the measures of a selection of a sound; and the selection as sound or spectrum."""

import argparse
import math
import sys
from pathlib import Path

from tqdm import tqdm

from phonemeanalyser.cli.arguments import HEARD, add_options
from phonemeanalyser.cli.jobs import file_preset
from phonemeanalyser.cli.parser import number_in
from phonemeengine import SoundReader, measure
from phonemeengine.audio.wav import check_wav_name
from phonemeengine.dsp.formants import CEILING, HIGHEST_CEILING, LOWEST_CEILING
from phonemeengine.inspection.averaged_spectrum import FORMAT, format_averaged_spectrum
from phonemeengine.inspection.measurement import MEASUREMENT_COLUMNS, format_measurement, save_stretch
from phonemeengine.inspection.speaker_spectra import average_spectrum
from phonemeengine.storage.files import begins_like
from phonemeengine.storage.replacing import STANDARD_OUTPUT, Guard, guarded_text, nothing_is_own, output_path

HEADING = ",".join(MEASUREMENT_COLUMNS).encode()

EXAMPLES = (
    "phonemeanalyser measure speech.wav --from 0.48 --to 0.63",
    "phonemeanalyser measure speech.wav -o measured.csv --ceiling 5000",
    "phonemeanalyser measure speech.wav --from 0.48 --to 0.63 --sound-out sh.wav --spectrum-out sh.csv",
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what is measured, and where that goes."""
    parser.add_argument("sound", type=Path, metavar="SOUND", help="audio file")
    parser.add_argument(
        "--from",
        type=number_in(0, math.inf, "s"),
        default=0.0,
        dest="start",
        metavar="S",
        help="start, seconds (default: 0)",
    )
    parser.add_argument(
        "--to",
        type=number_in(0, math.inf, "s"),
        dest="end",
        metavar="S",
        help="end, seconds (default: the end of the file)",
    )
    parser.add_argument("-o", "--out", type=Path, metavar="OUT", help="table, .csv (default: print)")
    parser.add_argument("--sound-out", type=Path, metavar="WAV", help="write this part as an audio file")
    parser.add_argument("--spectrum-out", type=Path, metavar="CSV", help="write its averaged spectrum")
    parser.add_argument(
        "--ceiling",
        type=number_in(LOWEST_CEILING, HIGHEST_CEILING, "Hz"),
        default=CEILING,
        metavar="HZ",
        help=f"highest frequency of formants (default: {CEILING:g})",
    )
    add_options(parser, *HEARD, "overwrite")


def run(options: argparse.Namespace) -> int:
    """Measure; returns the exit code."""
    preset, table = file_preset(options), Guard(begins_like(HEADING), options.overwrite)
    table.check(options.out)
    spectrum = Guard(begins_like(f"# {FORMAT}".encode()), options.overwrite)
    spectrum.check(options.spectrum_out)
    Guard(nothing_is_own, options.overwrite).check(options.sound_out)
    if options.sound_out is not None:
        check_wav_name(options.sound_out)
    with SoundReader(options.sound, options.channel) as reader:
        end = reader.duration if options.end is None else options.end
    stretch = (options.sound, options.start, end)
    with tqdm(total=100, unit="%", file=sys.stderr, disable=None, leave=False, desc=options.sound.name) as bar:
        found = measure(
            *stretch,
            preset,
            channel=options.channel,
            ceiling=options.ceiling,
            progress=lambda share: bool(bar.update(100 * share - bar.n)) or True,
        )
    if options.out is not None or STANDARD_OUTPUT not in (options.sound_out, options.spectrum_out):
        with guarded_text(options.out, table) as file:
            file.write(format_measurement(found))
    if options.sound_out is not None:
        with output_path(options.sound_out) as path:
            save_stretch(*stretch, path, channel=options.channel)
    if options.spectrum_out is not None:
        name = options.spectrum_out.stem
        text = format_averaged_spectrum(average_spectrum(*stretch, preset, name, channel=options.channel))
        with guarded_text(options.spectrum_out, spectrum) as file:
            file.write(text)
    return 0
