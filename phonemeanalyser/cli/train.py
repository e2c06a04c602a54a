"""``phonemeanalyser train``: from labelled speech to a preset, its model and its card."""

import argparse
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from shutil import rmtree
from typing import Any

from tqdm import tqdm

from phonemeanalyser.cli.arguments import add_options, refuse_unused
from phonemeanalyser.cli.parser import file_place, whole_in
from phonemeengine import ModelError, ModelKind, Preset, load_preset, save_preset
from phonemeengine.presets.files import DEFAULT_PRESET
from phonemeengine.storage.replacing import guarded_text
from phonemetraining.config import TrainingConfig

EXAMPLES = (
    "phonemeanalyser train corpus -o voices.npz",
    "phonemeanalyser train corpus more-recordings -o voices.npz --groups groups.toml",
    "phonemeanalyser train corpus -o voices.npz --teacher whisper-base --no-validation",
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what is learned from, and how long."""
    parser.epilog = (
        "Writes the real-time and the offline model, with a teacher the encoder too, a preset that uses them (the "
        "same name, .toml), and a model card (.md). A folder beside them (.training) keeps the state: an interrupted "
        "training continues there, on this machine or another. Needs PyTorch (extra train), and uses a GPU if there "
        "is one."
    )
    parser.add_argument(
        "corpora", type=Path, nargs="+", metavar="CORPUS", help="folder of labelled recordings with manifest.csv"
    )
    parser.add_argument(
        "-o", "--out", type=file_place, required=True, metavar="MODEL", help="file of the model, .npz"
    )
    for name, least, usual, words in (
        ("seed", 0, 1, "seed of the random generator"),
        ("epochs", 1, TrainingConfig.n_epochs, "epochs"),
        ("width", 4, TrainingConfig.width, "channels of the network"),
        ("variations", 0, 6, "augmented variations of each recording"),
        ("encoder-epochs", 1, TrainingConfig.n_encoder_epochs, "epochs of the encoder"),
    ):
        parser.add_argument(
            f"--{name}", type=whole_in(least), default=usual, metavar="N", help=f"{words} (default: {usual})"
        )
    parser.add_argument(
        "--groups",
        type=Path,
        metavar="FILE",
        help="TOML with the held-out speakers that score a first training: lists validation and reserved (default: "
        "those of the shipped models, or a third)",
    )
    parser.add_argument(
        "--no-validation", action="store_true", help="skip the first training and its scores, which halves the time"
    )
    parser.add_argument(
        "--teacher",
        type=Path,
        metavar="FOLDER",
        help="folder of a Whisper model whose encoder is the teacher, and becomes the encoder of the preset",
    )
    add_options(parser, "channel")


def run(options: argparse.Namespace) -> int:
    """Train; returns the exit code."""
    if options.out.suffix != ".npz":
        raise ModelError(f"{options.out}: a model's file ends in .npz; name it so")
    if options.no_validation:
        refuse_unused(options, ("groups",), "goes without --no-validation: networks are judged by these speakers")
    try:
        from phonemetraining.model_card import model_card  # noqa: PLC0415 - PyTorch is an extra
        from phonemetraining.pipeline import train_and_validate  # noqa: PLC0415
    except ImportError as error:
        raise ModelError(
            'training needs PyTorch, which is not installed; pip install "phonemeanalyser[train]"'
        ) from error
    result = _trained(options, train_and_validate)
    preset, card = options.out.with_suffix(".toml"), options.out.with_suffix(".md")
    notes = f"Trained by phonemeanalyser train; {card.name} tells on what, and how well it does."
    save_preset(replace(_preset_of(result, options.out.stem), notes=notes), preset)
    text = model_card(options.out.stem, result, options.variations)
    with guarded_text(card) as file:
        file.write(text)
    rmtree(_work_of(options.out))
    print(f"{options.out}: {options.out.stat().st_size / 1000:.0f} kB; {card}; {preset} uses it")
    for kind, found in result.validations.items():
        for group, e in found.together.items():
            print(
                f"{kind}, {group} left out: macro F1 {e.macro_f1:.3f}, mouth shapes {e.viseme_accuracy:.3f}, "
                f"vowels {e.vowel_accuracy:.3f}, visemes {e.fine_viseme_accuracy:.3f}"
            )
    return 0


def _work_of(out: Path) -> Path:
    """Return the folder for what is done so far."""
    return out.with_suffix(".training")


def _trained(options: argparse.Namespace, train_and_validate: Callable[..., Any]) -> Any:
    """Return the result of the training, whose progress is shown."""
    config = TrainingConfig(
        seed=options.seed, n_epochs=options.epochs, width=options.width, n_encoder_epochs=options.encoder_epochs
    )
    with tqdm(
        total=100, unit="%", file=sys.stderr, disable=None, bar_format="{desc}: {n:.0f} %|{bar}| {elapsed}"
    ) as bar:

        def told(what: str, share: float) -> None:
            bar.set_description(what)
            bar.update(100 * share - bar.n)

        return train_and_validate(
            options.corpora,
            config,
            options.variations,
            _work_of(options.out),
            told,
            groups=options.groups,
            validates=not options.no_validation,
            channel=options.channel,
            whisper=options.teacher,
        )


def _preset_of(result: Any, name: str) -> Preset:
    """Return the shipped preset with the models of a training."""
    live, files = (
        replace(network, about=_about(name, result, kind))
        for network, kind in ((result.live, ModelKind.REAL_TIME), (result.files, ModelKind.OFFLINE))
    )
    return replace(
        load_preset(DEFAULT_PRESET),
        name=name,
        model=live,
        offline_model=files,
        live_encoder=result.encoder,
        sensitivities={},
        encoder_head=None if result.head is None else result.head.rounded(),
        confidences={kind: found.confidence for kind, found in result.validations.items()},
    )


def _about(name: str, result: Any, kind: ModelKind) -> dict[str, object]:
    config, found = result.config, result.validations.get(kind)
    about: dict[str, object] = {"name": name, "seed": config.seed, "epochs": config.n_epochs}
    about["speakers"] = len(result.sources)
    if found is not None:
        about["macro_f1"] = {group: round(scores.macro_f1, 3) for group, scores in found.together.items()}
    about.update(result.about(kind))
    return about
