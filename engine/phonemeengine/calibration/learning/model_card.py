"""The model card: what a model was trained on, how, and how well it does on strangers."""

from collections.abc import Iterable
from dataclasses import fields

from phonemeengine.calibration.learning.pipeline import HESITATION, WARPS, TrainingResult
from phonemeengine.calibration.learning.provenance import LabelSource
from phonemeengine.calibration.learning.training import TrainingConfig
from phonemeengine.calibration.learning.validation import SETTINGS
from phonemeengine.calibration.scores.scoring import Scores

KINDS = {"human": "people", "synthetic-formant": "formant synthesis"}

HEADINGS = {
    "macro_f1": "macro F1 of ten classes",
    "viseme_accuracy": "mouth shapes right",
    "fine_viseme_accuracy": "right of fifteen visemes",
    "vowel_accuracy": "clear vowels right",
    "silence_recall": "silence found",
    "false_silence": "speech called silence",
    "changes_per_s": "changes a second",
    "label_changes_per_s": "changes of the labels",
}


def model_card(name: str, result: TrainingResult, config: TrainingConfig, n_variations: int) -> str:
    """Write the card of a model, as Markdown."""
    minutes = sum(source.minutes for source in result.sources)
    parts = [
        f"# {name}\n",
        f"A causal convolutional network over time, {config.width} channels, dilations "
        f"{', '.join(map(str, (1, *config.dilations)))}; {_n_numbers(result):,} numbers, kept as float16. Input: "
        "logarithms of the power in 40 mel bands up to 8 kHz, of the middle 23 ms of each 46 ms frame, every 10 ms. "
        f"Output: eleven classes, with a look-ahead of 0 to 50 ms by choice. It listens with "
        f"{len(WARPS)} vocal tracts (frequencies warped by {', '.join(f'{warp:g}' for warp in WARPS)}) and trusts "
        "those with which it is sure.\n",
        "## Training\n",
        f"Seed {config.seed}, {config.n_epochs} epochs, batches of {config.batch_size} stretches of "
        f"{config.n_frames / 100:g} s, learning rate {config.rate:g}, dropout {config.dropout:g}. Each recording as "
        f"it is and in {n_variations} variations of tempo, pitch, vocal tract and room; in every batch other levels, "
        "colours, noises, band limits and noise floors. Unidentified sounds must be the likeliest by "
        f"{HESITATION:g} (natural logarithm).\n",
        f"{minutes:.0f} minutes of {len(result.sources)} speakers:\n",
        _table(_by_kind(result.sources)),
        "## How well it does on speakers that it was not trained on\n",
        _validation(result),
        "## Speech\n",
        _table(_speakers(result.sources)),
    ]
    return "\n".join(parts)


def _validation(result: TrainingResult) -> str:
    if result.everyone is None:
        return "Not measured in this training.\n"
    kinds = {source.name: source.kind for source in result.sources}
    rows = [["", "minutes", *HEADINGS.values()], ["all", *_figures(result.everyone)]]
    for name, scores in result.held_out.items():
        rows.append([f"{name} ({kinds.get(name, '')})", *_figures(scores)])
    lead = (
        f"Each speaker was left out of one training, and recognised by it, as the preset does: looking "
        f"{SETTINGS.look_ahead * 1000:.0f} ms ahead, each phoneme held {SETTINGS.minimum_hold * 1000:.0f} ms. The "
        "definitions are those of `phonemeanalyser score`.\n\n"
    )
    return lead + _table(rows)


def _figures(scores: Scores) -> list[str]:
    values = {field.name: getattr(scores, field.name) for field in fields(scores)}
    return [f"{values['minutes']:.1f}", *(f"{values[name]:.3f}" for name in HEADINGS)]


def _by_kind(sources: Iterable[LabelSource]) -> list[list[str]]:
    rows = [["kind of speech", "speakers", "minutes", "counts"]]
    for kind in sorted({source.kind for source in sources}):
        same = [source for source in sources if source.kind == kind]
        minutes = f"{sum(source.minutes for source in same):.0f}"
        rows.append([KINDS.get(kind, kind), str(len(same)), minutes, f"{same[0].weight:g} x"])
    return rows


def _speakers(sources: Iterable[LabelSource]) -> list[list[str]]:
    rows = [["speaker", "language", "minutes", "licence", "source"]]
    rows += [[s.name, s.language, f"{s.minutes:.1f}", s.licence, s.package] for s in sources]
    return rows


def _table(rows: list[list[str]]) -> str:
    head, *body = rows
    lines = ["| " + " | ".join(head) + " |", "|" + " --- |" * len(head)]
    lines += ["| " + " | ".join(row) + " |" for row in body]
    return "\n".join(lines) + "\n"


def _n_numbers(result: TrainingResult) -> int:
    arrays = [a for layer in result.model.layers for a in (layer.weights, layer.bias)]
    arrays += [a for head in result.model.heads for a in (head.weights, head.bias)]
    return sum(array.size for array in arrays)
