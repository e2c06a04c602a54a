"""``phonemeanalyser adapt``: the learned recogniser learns one voice."""

import argparse
from dataclasses import replace
from pathlib import Path

from engine.calibration.adaptation import adapt as adapted
from engine.calibration.labels.names import Mapping, load_mapping
from engine.calibration.learning.lessons import lesson_of_recording
from engine.calibration.scores.corpus import Utterance, read_recordings
from engine.errors import PresetError
from engine.presets.files import DEFAULT_PRESET, load_preset, save_preset
from phonemeanalyser.arguments import add_channel
from phonemeanalyser.jobs import say_cut_off


def adapt(words: list[str]) -> int:
    """Run the command; returns its exit code."""
    options = _options(words)
    preset = load_preset(options.preset)
    if preset.model is None:
        raise PresetError(
            f"{options.preset.name}: it has no learned model, so there is nothing to adapt; name a preset with one"
        )
    mapping = load_mapping(options.map) if options.map else Mapping()
    found: list[Utterance] = []
    for folder in options.folders:
        found += read_recordings(folder, mapping, channel=options.channel)
    say_cut_off(found)
    outcome = adapted(preset.model, [lesson_of_recording(utterance) for utterance in found])
    save_preset(replace(preset, name=options.out.stem, model=outcome.model), options.out)
    seconds = sum(utterance.labels[-1].end for utterance in found if utterance.labels)
    figures = f"what was held back is recognised with a certainty of {outcome.after:.0%}, {outcome.before:.0%} before"
    told = (
        figures
        if outcome.gains
        else f"nothing helped on what was held back ({outcome.before:.0%} certain); unchanged"
    )
    print(f"{options.out}: {len(found)} recordings, {seconds:.0f} s; {told}")
    return 0


def _options(words: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="phonemeanalyser adapt",
        description="Adapt the learned recogniser to the takes or labelled recordings of one voice.",
    )
    parser.add_argument("folders", type=Path, nargs="+", metavar="FOLDER", help="takes, or labelled recordings")
    parser.add_argument("-o", "--out", type=Path, required=True, metavar="PRESET", help="the adapted preset, .toml")
    parser.add_argument("--preset", type=Path, default=DEFAULT_PRESET, help="preset to begin with (default: learned)")
    parser.add_argument("--map", type=Path, metavar="FILE", help="what unknown names in the labels stand for")
    add_channel(parser)
    options = parser.parse_args(words)
    if options.out.suffix.lower() != ".toml":
        raise PresetError(f"{options.out}: an adapted preset's file ends in .toml; name it so")
    return options
