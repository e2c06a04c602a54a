"""The model card: what a model was trained on, how, and how well it does on strangers."""

from collections.abc import Iterable
from dataclasses import fields

import numpy as np

from phonemeengine.calibration.scores.scoring import Scores
from phonemeengine.dsp.log_mel import N_BANDS
from phonemeengine.encoder.head import CONTEXT
from phonemeengine.encoder.whisper import WHISPER_LICENCE
from phonemeengine.settings import Ear
from phonemetraining.pipeline import LabelSource, TrainedModel, TrainingResult, Validation
from phonemetraining.teacher import COMPONENTS, GROUPS, HIDDEN
from phonemetraining.training import HESITATION, WARPS
from phonemetraining.validation import LEAST_READ, MOST_JUDGED, MOST_READ, SAMPLED, SETTINGS

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


def model_card(name: str, result: TrainingResult, n_variations: int) -> str:
    """Write the card of a model and its twin for files, as Markdown."""
    minutes, config = sum(source.minutes for source in result.sources), result.live.config
    parts = [
        f"# {name}\n",
        f"Two convolutional networks over time, on the logarithms of the power in {N_BANDS} mel bands up to 8 kHz, "
        "of the middle 23 ms of each 46 ms frame, every 10 ms. Both answer with eleven phonemes and fifteen visemes, "
        f"listen with {len(WARPS)} vocal tracts (frequencies warped by {', '.join(f'{warp:g}' for warp in WARPS)}) "
        "and trust those with which they are sure.\n",
        f"- For live sound: {_architecture(result.live)}; looks back, and 0 to 50 ms ahead by choice.\n"
        f"- For files: {_architecture(result.files)}; hears as far ahead as back.\n",
        "## Training\n",
        f"Seed {config.seed}, {config.n_epochs} epochs, batches of {config.batch_size} stretches of "
        f"{config.n_frames / 100:g} s, learning rate {config.rate:g}, dropout {config.dropout:g}. Each recording as "
        f"it is and in {n_variations} variations of tempo, pitch, vocal tract, room, microphone and codec; in every "
        "batch other levels, colours, noises, band limits and floors. Unidentified sounds must be the likeliest "
        f"by {HESITATION:g} (natural logarithm).\n",
        f"{minutes:.0f} minutes of {len(result.sources)} speakers:\n",
        _table(_by_kind(result.sources)),
        _teacher(result),
        _moved_labels(result),
        "## How well it does on speakers that it was not trained on\n",
        _validation(result),
        "## Speech\n",
        _table(_speakers(result.sources)),
    ]
    return "\n".join(parts)


def validations_of(result: TrainingResult) -> dict[Ear, Validation]:
    """Return how well each ear did, of those that there are."""
    found = {
        Ear.LIVE: result.live.validation,
        Ear.TWIN: result.files.validation,
        Ear.WHISPER: result.with_encoder,
    }
    return {ear: validation for ear, validation in found.items() if validation.together}


def _architecture(trained: TrainedModel) -> str:
    model, config = trained.model, trained.config
    arrays = [a for layer in model.layers for a in (layer.weights, layer.bias)]
    arrays += [a for head in (*model.heads, *model.viseme_heads) for a in (head.weights, head.bias)]
    return (
        f"{config.width} channels, dilations {', '.join(map(str, (1, *config.dilations)))}, "
        f"{sum(array.size for array in arrays):,} numbers, kept as float16"
    )


def _teacher(result: TrainingResult) -> str:
    if result.head is None:
        return ""
    return (
        f"The teacher is the encoder of {WHISPER_LICENCE}, with a head of one hidden layer ({HIDDEN} units) on "
        f"{len(CONTEXT)} of its frames, projected onto {COMPONENTS} components. Each recording was heard by a "
        f"head that was trained without its group of speakers ({GROUPS} groups); labels and what that head "
        "heard count alike.\n"
    )


def _moved_labels(result: TrainingResult) -> str:
    if not result.rounds:
        return ""
    rows = [["round", "boundaries", "moved by (median)", "9 of 10 within", "later", "macro F1 before", "after", ""]]
    for k, done in enumerate(result.rounds, 1):
        far = np.abs(done.moves) * 1000
        figures = [f"{figure:.3f}" for figure in done.macro_f1]
        lengths = [f"{value:.0f} ms" for value in (np.median(far), np.quantile(far, 0.9), 1000 * done.moves.mean())]
        rows.append([str(k), f"{len(far):,}", *lengths, *figures, "kept" if done.gains else "not kept"])
    lead = (
        "The phone times of people were moved to where the teacher and a small network that had not heard them hear "
        "the sounds change. Macro F1 is that of people who were left out of small networks which learned from the "
        "labels before and after, on frames of which both say the same.\n\n"
    )
    return lead + _table(rows)


def _validation(result: TrainingResult) -> str:
    if not result.live.validation.together:
        return "Not measured in this training.\n"
    kinds = {source.name: source.kind for source in result.sources}
    rows = [["", "minutes", *HEADINGS.values()]]
    for ear, found in validations_of(result).items():
        rows += [[f"**{ear}, {group}**", *_figures(scores)] for group, scores in found.together.items()]
    rows += [
        [f"{name} ({kinds.get(name, '')})", *_figures(scores)]
        for name, scores in result.live.validation.held_out.items()
    ]
    who = "Each speaker"
    if result.n_validated < result.n_folds:
        who = f"Each speaker of {result.n_validated} of {result.n_folds} groups, into which all were dealt evenly,"
    lead = (
        f"{who} was left out of one training, and recognised by it, as the preset does: live sound looking "
        f"{SETTINGS.look_ahead * 1000:.0f} ms ahead, each phoneme held {SETTINGS.minimum_hold * 1000:.0f} ms. The "
        "definitions are those of `phonemeanalyser score`. The teacher's heads had not heard them either. Single "
        "speakers are heard by the model for live sound.\n\n"
    )
    further = (_by_look_ahead(result.live), _one_voice(result.live), _confidence(result.live.validation))
    return lead + _table(rows) + "".join(further)


def _by_look_ahead(trained: TrainedModel) -> str:
    if not trained.by_look_ahead:
        return ""
    rows = [["look-ahead", HEADINGS["macro_f1"], HEADINGS["viseme_accuracy"]]]
    rows += [
        [f"{1000 * seconds:.0f} ms", *(f"{figure:.3f}" for figure in pair)]
        for seconds, pair in trained.by_look_ahead.items()
    ]
    return f"\nBy the look-ahead, on every {SAMPLED}th of the recordings:\n\n{_table(rows)}"


def _one_voice(trained: TrainedModel) -> str:
    if not trained.adapted:
        return ""
    rows = [["", "minutes", *HEADINGS.values()]]
    for group, gained in trained.adapted.items():
        rows += [[f"{group}, {when}", *_figures(s)] for when, s in zip(("before", "after"), gained, strict=True)]
    return (
        f"\nBefore and after {LEAST_READ:g} to {MOST_READ:g} s of the speaker were learned, one recording or the "
        "first ones that are as long together, as the guided calibration does; on at most "
        f"{MOST_JUDGED} further recordings of each:\n\n{_table(rows)}"
    )


def _confidence(found: Validation) -> str:
    curve = found.confidence
    rows = [["score", *(f"{score:.2f}" for score in curve.scores)], ["right", *(f"{s:.2f}" for s in curve.shares)]]
    return f"\nOf frames that were named with such a probability, such a share was right:\n\n{_table(rows)}"


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
