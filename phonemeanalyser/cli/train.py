"""``phonemeanalyser train``: from labelled speech to a preset, its model and its card."""

import argparse
import sys
from dataclasses import replace
from pathlib import Path
from shutil import rmtree

from tqdm import tqdm

from phonemeanalyser.cli.arguments import add_options, file_place, whole_in
from phonemeengine import ModelError, load_preset, save_preset
from phonemeengine.presets.files import DEFAULT_PRESET
from phonemeengine.storage.replacing import guarded_text
from phonemetraining.model_card import model_card, validations_of
from phonemetraining.pipeline import TrainedModel, TrainingResult, train_and_validate
from phonemetraining.training import TrainingConfig


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what is learned from, and how long."""
    parser.epilog = (
        "Writes the model, its twin for files (-files.npz), a preset that uses both (the same name, .toml) and the "
        "card (.md). What is done so far lies in a folder beside them (.training): a training that was interrupted "
        "goes on where it was."
    )
    parser.add_argument("corpora", type=Path, nargs="+", metavar="CORPUS", help="folder with manifest.csv")
    parser.add_argument("-o", "--out", type=file_place, required=True, metavar="MODEL", help="the model's file, .npz")
    for name, least, usual, words in (
        ("seed", 0, 1, "of all chance"),
        ("epochs", 1, TrainingConfig.n_epochs, "times that all is gone through"),
        ("width", 4, TrainingConfig.width, "channels"),
        ("variations", 0, 6, "of each recording"),
        ("folds", 0, 3, "groups of speakers left out in turn; 0: none"),
    ):
        parser.add_argument(f"--{name}", type=whole_in(least), default=usual, help=f"{words} (default {usual})")
    parser.add_argument(
        "--validated",
        type=whole_in(0),
        metavar="N",
        help="of these groups, how many are left out (default all); each that is not saves the time of a training",
    )
    parser.add_argument(
        "--teacher",
        type=Path,
        metavar="FOLDER",
        help="folder of a Whisper model whose encoder teaches too (extra train)",
    )
    add_options(parser, "channel")


def run(options: argparse.Namespace) -> int:
    """Train; returns the exit code."""
    if options.out.suffix != ".npz":
        raise ModelError(f"{options.out}: a model's file ends in .npz; name it so")
    config = TrainingConfig(seed=options.seed, n_epochs=options.epochs, width=options.width)
    with tqdm(
        total=100, unit="%", file=sys.stderr, disable=None, bar_format="{desc}: {n:.0f} %|{bar}| {elapsed}"
    ) as bar:

        def told(what: str, share: float) -> None:
            bar.set_description(what)
            bar.update(100 * share - bar.n)

        work = options.out.with_suffix(".training")
        result = train_and_validate(
            options.corpora,
            config,
            options.variations,
            options.folds,
            told,
            work,
            n_validated=options.validated,
            channel=options.channel,
            whisper=options.teacher,
        )
    model, twin = (
        replace(trained.model, about=_about(options.out.stem, result, trained))
        for trained in (result.live, result.files)
    )
    preset, card = options.out.with_suffix(".toml"), options.out.with_suffix(".md")
    notes = f"Trained by phonemeanalyser train; {card.name} tells on what, and how well it does."
    shipped = load_preset(DEFAULT_PRESET)
    named = replace(
        shipped,
        name=preset.stem,
        model=model,
        file_model=twin,
        notes=notes,
        sensitivities={},
        encoder_head=None if result.head is None else result.head.rounded(),
        confidences={ear: found.confidence for ear, found in validations_of(result).items()},
    )
    save_preset(named, preset)
    text = model_card(options.out.stem, result, options.variations)
    with guarded_text(card) as file:
        file.write(text)
    rmtree(work)
    print(f"{options.out}: {options.out.stat().st_size / 1000:.0f} kB; {card}; {preset} uses it")
    for ear, found in validations_of(result).items():
        for group, e in found.together.items():
            print(
                f"{ear}, {group} left out: macro F1 {e.macro_f1:.3f}, mouth shapes {e.viseme_accuracy:.3f}, "
                f"vowels {e.vowel_accuracy:.3f}, visemes {e.fine_viseme_accuracy:.3f}"
            )
    return 0


def _about(name: str, result: TrainingResult, trained: TrainedModel) -> dict[str, object]:
    config = trained.config
    figures = {group: round(scores.macro_f1, 3) for group, scores in trained.validation.together.items()}
    about = {"name": name, "seed": config.seed, "epochs": config.n_epochs, "speakers": len(result.sources)}
    ahead = {f"{1000 * s:.0f}": [round(f, 3) for f in pair] for s, pair in trained.by_look_ahead.items()}
    return about | ({"macro_f1": figures} if figures else {}) | ({"by_look_ahead_ms": ahead} if ahead else {})
