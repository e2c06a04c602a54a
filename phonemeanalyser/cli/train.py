"""``phonemeanalyser train``: from labelled speech to a preset, its model and its card."""

import argparse
import sys
from dataclasses import replace
from pathlib import Path
from shutil import rmtree
from typing import Any

from tqdm import tqdm

from phonemeanalyser.cli.arguments import add_options, file_place, whole_in
from phonemeengine import Ear, ModelError, load_preset, save_preset
from phonemeengine.presets.files import DEFAULT_PRESET
from phonemeengine.storage.replacing import guarded_text
from phonemetraining.config import TrainingConfig


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what is learned from, and how long."""
    parser.epilog = (
        "Writes the models for live sound and for files, with a teacher the real-time model too, a preset that uses "
        "them (the same name, .toml) and the card (.md). What is done so far lies in a folder beside them "
        "(.training): a training that was interrupted goes on where it was, on this machine or another. PyTorch "
        "trains (extra train), on a GPU where there is one."
    )
    parser.add_argument("corpora", type=Path, nargs="+", metavar="CORPUS", help="folder with manifest.csv")
    parser.add_argument("-o", "--out", type=file_place, required=True, metavar="MODEL", help="the model's file, .npz")
    for name, least, usual, words in (
        ("seed", 0, 1, "of all chance"),
        ("epochs", 1, TrainingConfig.n_epochs, "times that all is gone through"),
        ("width", 4, TrainingConfig.width, "channels"),
        ("variations", 0, 6, "of each recording"),
        ("encoder-epochs", 1, TrainingConfig.n_encoder_epochs, "the same for the real-time model"),
    ):
        parser.add_argument(f"--{name}", type=whole_in(least), default=usual, help=f"{words} (default {usual})")
    parser.add_argument(
        "--groups",
        type=Path,
        metavar="FILE",
        help="TOML with the speakers that are left out of a first training, by which the networks are judged: lists "
        "validation and reserved (default: as the shipped models, or a third of them)",
    )
    parser.add_argument("--no-validation", action="store_true", help="judge nothing, which takes half the time")
    parser.add_argument(
        "--teacher",
        type=Path,
        metavar="FOLDER",
        help="folder of a Whisper model whose encoder teaches, and becomes the real-time model",
    )
    add_options(parser, "channel")


def run(options: argparse.Namespace) -> int:
    """Train; returns the exit code."""
    if options.out.suffix != ".npz":
        raise ModelError(f"{options.out}: a model's file ends in .npz; name it so")
    try:
        from phonemetraining.model_card import model_card  # noqa: PLC0415 - PyTorch is an extra
        from phonemetraining.pipeline import train_and_validate  # noqa: PLC0415
    except ImportError as error:
        raise ModelError(
            'training needs PyTorch, which is not installed; pip install "phonemeanalyser[train]"'
        ) from error
    config = TrainingConfig(
        seed=options.seed, n_epochs=options.epochs, width=options.width, n_encoder_epochs=options.encoder_epochs
    )
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
            work,
            told,
            groups=options.groups,
            validates=not options.no_validation,
            channel=options.channel,
            whisper=options.teacher,
        )
    model, offline = (
        replace(network, about=_about(options.out.stem, result, ear))
        for network, ear in ((result.live, Ear.LIVE), (result.files, Ear.TWIN))
    )
    preset, card = options.out.with_suffix(".toml"), options.out.with_suffix(".md")
    notes = f"Trained by phonemeanalyser train; {card.name} tells on what, and how well it does."
    shipped = load_preset(DEFAULT_PRESET)
    named = replace(
        shipped,
        name=preset.stem,
        model=model,
        file_model=offline,
        live_encoder=result.encoder,
        notes=notes,
        sensitivities={},
        encoder_head=None if result.head is None else result.head.rounded(),
        confidences={ear: found.confidence for ear, found in result.validations.items()},
    )
    save_preset(named, preset)
    text = model_card(options.out.stem, result, options.variations)
    with guarded_text(card) as file:
        file.write(text)
    rmtree(work)
    print(f"{options.out}: {options.out.stat().st_size / 1000:.0f} kB; {card}; {preset} uses it")
    for ear, found in result.validations.items():
        for group, e in found.together.items():
            print(
                f"{ear}, {group} left out: macro F1 {e.macro_f1:.3f}, mouth shapes {e.viseme_accuracy:.3f}, "
                f"vowels {e.vowel_accuracy:.3f}, visemes {e.fine_viseme_accuracy:.3f}"
            )
    return 0


def _about(name: str, result: Any, ear: Ear) -> dict[str, object]:
    config, found = result.config, result.validations.get(ear)
    about: dict[str, object] = {"name": name, "seed": config.seed, "epochs": config.n_epochs}
    about["speakers"] = len(result.sources)
    if found is not None:
        about["macro_f1"] = {group: round(scores.macro_f1, 3) for group, scores in found.together.items()}
    if result.by_look_ahead and ear is Ear.LIVE:
        told = {f"{1000 * s:.0f}": [round(f, 3) for f in pair] for s, pair in result.by_look_ahead.items()}
        about["by_look_ahead_ms"] = told
    return about
