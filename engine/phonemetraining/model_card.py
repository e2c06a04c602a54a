"""The model card: what a model was trained on, how, and how well it does on strangers."""

from collections.abc import Iterable, Sequence
from dataclasses import fields

import numpy as np

from phonemeengine.calibration.scores.scoring import Scores
from phonemeengine.dsp.mel import N_BANDS
from phonemeengine.encoder.graph import BACK
from phonemeengine.encoder.head import CONTEXT
from phonemeengine.encoder.whisper import LAYER, WHISPER_LICENCE
from phonemeengine.recognition.model import Model
from phonemeengine.settings import ModelKind
from phonemetraining.pipeline import HESITATION, RESERVED, WARPS, LabelSource, TrainingResult, Validation
from phonemetraining.teacher import COMPONENTS, GROUPS, HIDDEN
from phonemetraining.validation import LEAST_READ, MOST_JUDGED, MOST_READ, SAMPLED, SETTINGS

KINDS = {"human": "people", "synthetic-formant": "formant synthesis"}

HEADINGS = {
    "macro_f1": "macro F1 of ten classes",
    "viseme_accuracy": "mouth shapes right",
    "fine_viseme_accuracy": "right of fifteen visemes",
    "vowel_accuracy": "clear vowels right",
    "silence_recall": "silence recall",
    "false_silence": "false silence",
    "changes_per_s": "changes a second",
    "label_changes_per_s": "changes of the labels",
}


def model_card(name: str, result: TrainingResult, n_variations: int) -> str:
    """Return the card of the models, as Markdown."""
    minutes, config = sum(source.minutes for source in result.sources), result.config
    parts = [
        f"# {name}\n",
        f"Two convolutional networks over time, on the logarithms of the power in {N_BANDS} mel bands up to 8 kHz, "
        "of the middle 23 ms of each 46 ms frame, every 10 ms. Both answer with eleven phonemes and fifteen visemes, "
        f"listen with {len(WARPS)} vocal tracts (frequencies warped by {', '.join(f'{warp:g}' for warp in WARPS)}) "
        "and trust those with which they are sure.\n",
        f"- For live sound: {_architecture(result.live)}; looks back, and 0 to 50 ms ahead by choice.\n"
        f"- For files: {_architecture(result.files)}; looks as far ahead as back.\n",
        _encoder(result),
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


def _encoder(result: TrainingResult) -> str:
    if result.encoder is None:
        return ""
    config = result.config
    return (
        f"The real-time model is the lower {config.n_layers} layers of the encoder of {WHISPER_LICENCE}, trained "
        f"further: {config.n_encoder_epochs} epochs, batches of {config.encoder_batch} stretches of "
        f"{config.n_encoder_frames / 100:g} s, learning rate {config.encoder_rate:g}. It looks {BACK / 50:g} s back "
        "and 20 or 40 ms ahead, and is mixed with the small network. It taught the small networks too.\n"
    )


def _architecture(model: Model) -> str:
    arrays = [a for layer in model.layers for a in (layer.weights, layer.bias)]
    arrays += [a for head in (*model.heads, *model.viseme_heads) for a in (head.weights, head.bias)]
    return (
        f"{len(model.layers[0].bias)} channels, dilations "
        f"{', '.join(str(layer.dilation) for layer in model.layers)}, "
        f"{sum(array.size for array in arrays):,} numbers, kept as float16"
    )


def _teacher(result: TrainingResult) -> str:
    if result.head is None:
        return ""
    return (
        f"The teacher is layer {LAYER}, counted from 0, of the encoder of {WHISPER_LICENCE}, with a head of one "
        f"hidden layer ({HIDDEN} units) on {len(CONTEXT)} of its states, projected onto {COMPONENTS} components. "
        f"Each recording was recognised by a head that was trained without its group of speakers ({GROUPS} groups); "
        "labels and what that head says count alike.\n"
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
        "The phone times of people were moved to where a head that did not learn from them finds that the sounds "
        "change. Macro F1 is that of people, by heads that learned from the labels of others before and after, on "
        "frames of which both say the same.\n\n"
    )
    return lead + _table(rows)


def _validation(result: TrainingResult) -> str:
    if not result.validations:
        return "Not measured in this training.\n"
    kinds = {source.name: source.kind for source in result.sources}
    rows = [["", "minutes", *HEADINGS.values()]]
    for kind, found in result.validations.items():
        rows += [[f"**{kind}, {group}**", *_figures(scores)] for group, scores in found.together.items()]
    best = result.validations.get(ModelKind.ENCODER, result.validations[ModelKind.REAL_TIME])
    rows += [[f"{name} ({kinds.get(name, '')})", *_figures(scores)] for name, scores in best.by_speaker.items()]
    lead = (
        f"{len(result.groups.everybody)} speakers were left out of a first training of all networks, and of the "
        "teacher's heads, and recognised by it as the preset does: live sound looking "
        f"{SETTINGS.look_ahead * 1000:.0f} ms ahead (the real-time model 40 ms), each phoneme held "
        f"{SETTINGS.minimum_hold * 1000:.0f} ms. Settings were chosen by {len(result.groups.validation)} of them; "
        f"the {len(result.groups.reserved)} who are {RESERVED} took part in no choice. The definitions are those of "
        "`phonemeanalyser score`. Single speakers are recognised by the real-time model, or by the live network "
        "where there is none.\n\n"
    )
    further = (_by_look_ahead(result), _one_voice(result), _confidence(result.validations[ModelKind.REAL_TIME]))
    return lead + _table(rows) + "".join(further)


def _by_look_ahead(result: TrainingResult) -> str:
    rows = [["", "look-ahead", HEADINGS["macro_f1"], HEADINGS["viseme_accuracy"]]]
    rows += [
        [kind, f"{1000 * seconds:.0f} ms", *(f"{figure:.3f}" for figure in pair)]
        for kind, found in result.by_look_ahead.items()
        for seconds, pair in found.items()
    ]
    return f"\nBy the look-ahead, on every {SAMPLED}th of the recordings:\n\n{_table(rows)}"


def _one_voice(result: TrainingResult) -> str:
    rows = [["", "minutes", *HEADINGS.values()]]
    for kind, groups in result.adapted.items():
        for group, gained in groups.items():
            both = zip(("before", "after"), gained, strict=True)
            rows += [[f"{kind}, {group}, {when}", *_figures(scores)] for when, scores in both]
    if len(rows) == 1:
        return ""
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


def _by_kind(sources: Sequence[LabelSource]) -> list[list[str]]:
    rows = [["kind of speech", "speakers", "minutes", "counts"]]
    for kind, has_labels in sorted({(source.kind, source.n_labelled > 0) for source in sources}):
        same = [source for source in sources if (source.kind, source.n_labelled > 0) == (kind, has_labels)]
        minutes = f"{sum(source.minutes for source in same):.0f}"
        words = KINDS.get(kind, kind) + ("" if has_labels else ", without labels")
        rows.append([words, str(len(same)), minutes, f"{same[0].weight:g} x"])
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
