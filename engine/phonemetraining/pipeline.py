"""From folders of labelled speech, whose manifests tell where it comes from, to models and what their card tells."""

import csv
import json
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.calibration.scores.corpus import LabelledUtterance, read_corpus
from phonemeengine.calibration.scores.evaluation import Predictions, confidence_of
from phonemeengine.calibration.scores.scoring import Answers, Scores, scores_of
from phonemeengine.encoder.head import HALVES, EncoderHead, load_head, save_head
from phonemeengine.encoder.live import EncoderMix, LiveEncoder, build_live_encoder
from phonemeengine.encoder.weights import read_weights
from phonemeengine.encoder.whisper import MODEL_FILE
from phonemeengine.errors import CorpusError
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.model import Model, load_model, save_model
from phonemeengine.recognition.scores import ConfidenceCurve
from phonemeengine.settings import Channel, ModelKind
from phonemeengine.storage.files import atomic_write
from phonemetraining.config import TrainingConfig
from phonemetraining.examples import (
    HEAD,
    INDEX,
    SOFT_LABELS,
    Examples,
    key_of,
    load_soft_labels,
    save_soft_labels,
    write_examples,
)
from phonemetraining.networks import TrainableEncoder
from phonemetraining.realignment import Round
from phonemetraining.teacher import Groups, encode_all, teach
from phonemetraining.training import device_of_choice, train_encoder, train_small
from phonemetraining.validation import (
    Adapted,
    adapted_to_each,
    preset_of,
    recognise_all,
    recognise_by_look_ahead,
    with_head,
)

UNKNOWN = "not told"

HUMAN = "human"
PEOPLE_WEIGHT, UNLABELLED_WEIGHT = 3.0, 0.5
"""How often the speech of people is gone through in an epoch: with labels it is rare and matters most, without it is
taught by soft labels alone. All other kinds count once."""


@dataclass(frozen=True)
class LabelSource:
    """A speaker.

    Attributes
    ----------
    name : corpus/speaker.
    language, kind, licence, package : as the manifest says.
    minutes : of speech.
    n_recordings, n_labelled : how many, and how many of them have labels.
    """

    name: str
    language: str
    kind: str
    licence: str
    package: str
    minutes: float
    n_recordings: int
    n_labelled: int

    @property
    def weight(self) -> float:
        """How often its speech is gone through in an epoch."""
        if not self.n_labelled:
            return UNLABELLED_WEIGHT
        return PEOPLE_WEIGHT if self.kind == HUMAN else 1.0


def sources_of(corpora: Iterable[Path]) -> list[LabelSource]:
    """Return the speakers of all corpora, sorted by name; a speaker, or a recording, of several corpora is one."""
    rows: dict[str, dict[str, dict[str, str]]] = {}
    for corpus in corpora:
        with (corpus / "manifest.csv").open(newline="", encoding="utf-8-sig") as file:
            for row in csv.DictReader(file):
                recordings = rows.setdefault(f"{row['corpus']}/{row['speaker']}", {})
                recordings.setdefault(Path(row["wav"]).stem, row)
    return [
        LabelSource(
            name,
            language=entries[0].get("language") or UNKNOWN,
            kind=entries[0].get("kind") or UNKNOWN,
            licence=entries[0].get("licence") or UNKNOWN,
            package=entries[0].get("source_package") or UNKNOWN,
            minutes=sum(float(row.get("duration_s") or 0) for row in entries) / 60,
            n_recordings=len(entries),
            n_labelled=sum(bool(row.get("labels")) for row in entries),
        )
        for name, entries in sorted((name, list(recordings.values())) for name, recordings in rows.items())
    ]


OnProgress = Callable[[str, float], object]
"""Called with what is done now, and the share of it that is done, 0..1."""


PEOPLE, RESERVED = "people", "reserved"


@dataclass(frozen=True)
class Validation:
    """How well speakers were recognised who were left out of the training.

    Attributes
    ----------
    by_speaker : the figures of each.
    together : those of ``all`` speakers of the validation, of ``people`` alone, and of those who are ``reserved``, as
        far as there are any.
    confidence : how often answers with some score were right, of the validation.
    """

    by_speaker: dict[str, Scores]
    together: dict[str, Scores]
    confidence: ConfidenceCurve


@dataclass(frozen=True)
class TrainingResult:
    """The outcome of a training.

    Attributes
    ----------
    sources : the speakers.
    groups : those who were left out of a first training of all networks, by which these are judged.
    config : how the network for live sound was trained.
    live, files : the small networks, for live sound and for files, trained on all speakers.
    encoder : the real-time model, trained on all speakers; None without a teacher.
    head : on the teacher, trained on all speakers; None without a teacher.
    rounds : in which the labels of people were moved.
    validations : how well the networks that did not learn from the groups did, by what recognises.
    by_look_ahead : macro F1 and the share of right mouth shapes of each model for live sound by its look-ahead,
        seconds, on some recordings of the validation.
    adapted : by what recognises live sound, for ``all`` speakers and ``people``, the figures on some of their
        recordings before and after a few seconds of their voice were learned.
    """

    sources: tuple[LabelSource, ...]
    groups: Groups
    config: TrainingConfig
    live: Model
    files: Model
    encoder: LiveEncoder | None = None
    head: EncoderHead | None = None
    rounds: tuple[Round, ...] = ()
    validations: dict[ModelKind, Validation] = field(default_factory=dict)
    by_look_ahead: dict[ModelKind, dict[float, tuple[float, float]]] = field(default_factory=dict)
    adapted: dict[ModelKind, dict[str, tuple[Scores, Scores]]] = field(default_factory=dict)

    def about(self, kind: ModelKind) -> dict[str, Any]:
        """Return what the file of a model for live sound tells of its figures."""
        found = self.by_look_ahead.get(kind, {})
        told = {f"{1000 * seconds:.0f}": [round(figure, 3) for figure in pair] for seconds, pair in found.items()}
        return {"by_look_ahead_ms": told} if told else {}


def train_and_validate(
    corpora: Sequence[Path],
    config: TrainingConfig,
    n_variations: int,
    work: Path,
    on_progress: OnProgress,
    *,
    groups: Path | None = None,
    validates: bool = True,
    channel: Channel = Channel.MIX,
    whisper: Path | None = None,
) -> TrainingResult:
    """Train all networks, and judge others of their kind by speakers from whom those did not learn.

    Parameters
    ----------
    corpora : folders in the corpus format.
    config : how to train.
    n_variations : of each recording, besides the recording itself.
    work : a folder for what is done so far: states, soft labels, examples and models. A training that was interrupted
        goes on from there, on this machine or on another to which the folder is copied.
    on_progress : called with the progress.
    groups : see `Groups.of`.
    validates : whether networks are judged, which takes as long again.
    channel : what is used of sounds that have several.
    whisper : the folder of Whisper's model; None for no teacher and no real-time model.

    Raises
    ------
    CorpusError : a folder is none, there is too little speech for a batch, or `work` holds another training.
    EngineError : a sound cannot be read.
    ModelError : the teacher cannot be used.
    """
    utterances = _recordings_of(corpora, channel, unlabelled=whisper is not None)
    sources = tuple(sources_of(corpora))
    _check_enough(sources, config)
    _begin(work, repr((config, n_variations, groups, validates, channel, sources, whisper is not None)))
    weights = {source.name: source.weight for source in sources}
    people = frozenset(source.name for source in sources if source.kind == HUMAN)
    left_out = Groups.of(list(weights), groups) if validates else Groups()
    if not (work / INDEX).is_file():
        _prepare(utterances, weights, people, left_out, n_variations, config.seed, work, whisper, on_progress)
    encoder_weights = (
        None if whisper is None else read_weights((whisper / MODEL_FILE).read_bytes(), config.n_layers - 1)
    )
    trainings = {ALL: frozenset[str](), **({LEFT_OUT: left_out.everybody} if validates else {})}
    for k, (name, strange) in enumerate(trainings.items()):
        told = partial(_tell, on_progress, k, len(trainings))
        train_networks(work, weights, strange, config, encoder_weights, name, told)
    result = _result_in(work, sources, left_out, config, with_head=whisper is not None)
    # Scored by the labels as they came, not by those that this training moved.
    scored = [u for u in utterances if u.labels and u.voice in left_out.everybody]
    judged = _judged(scored, left_out, people, work, result.head, on_progress) if validates else {}
    result = replace(result, **judged)
    if result.head is None:
        return result
    trained = load_weights(work / f"encoder-{ALL}.npz")
    return replace(result, encoder=real_time_model(trained, result.head, result.about(ModelKind.ENCODER)))


def _result_in(
    work: Path, sources: tuple[LabelSource, ...], groups: Groups, config: TrainingConfig, *, with_head: bool
) -> TrainingResult:
    """Return what lies in the folder of a training that is done, but for the real-time model."""
    return TrainingResult(
        sources,
        groups,
        config,
        load_model(work / f"live-{ALL}.npz"),
        load_model(work / f"files-{ALL}.npz"),
        head=load_head(work / HEAD) if with_head else None,
        rounds=load_rounds(work / ROUNDS),
    )


def _tell(on_progress: OnProgress, k: int, n: int, share: float) -> None:
    on_progress("training", (k + share) / n)


ROUNDS = "rounds.json"


def load_rounds(path: Path) -> tuple[Round, ...]:
    """Read in which rounds labels were moved; none where there is no file."""
    if not path.is_file():
        return ()
    return tuple(Round(np.array(r["moves"]), tuple(r["macro_f1"])) for r in json.loads(path.read_text("utf-8")))


def _prepare(
    utterances: Sequence[LabelledUtterance],
    weights: dict[str, float],
    people: frozenset[str],
    groups: Groups,
    n_variations: int,
    seed: int,
    work: Path,
    whisper: Path | None,
    on_progress: OnProgress,
) -> None:
    """Have the teacher recognise all recordings, move the labels of people, and write the examples."""
    soft_labels = None
    if whisper is not None:
        encoded = encode_all(utterances, work / "encoder", whisper, partial(on_progress, "encoding"))
        taught = teach(utterances, encoded, weights, people, groups.everybody, seed, partial(on_progress, "teaching"))
        utterances, soft_labels = taught.utterances, taught.soft_labels
        save_soft_labels(soft_labels, work / SOFT_LABELS)
        save_head(taught.head, work / HEAD)
        told = [{"moves": r.moves.tolist(), "macro_f1": r.macro_f1} for r in taught.rounds]
        (work / ROUNDS).write_text(json.dumps(told), "utf-8")
    n_done = 0

    def count(n: int) -> None:
        nonlocal n_done
        n_done += n
        on_progress("measuring", n_done / len(utterances))

    write_examples(work, utterances, n_variations, seed, soft_labels, count)


def real_time_model(
    weights: Mapping[str, Float32Array], head: EncoderHead, about: Mapping[str, Any] | None = None
) -> LiveEncoder:
    """Return the real-time model with the weights and anchors of a causal encoder, and the priors of the head."""
    bias = weights["head/bias"].reshape(HALVES, -1).copy()
    bias[:, Phoneme.UNIDENTIFIED] -= ENCODER_HESITATION
    bias[:, Phoneme.SILENCE] += ENCODER_SILENCE
    mix = EncoderMix(priors=tuple(map(float, head.priors)))
    return build_live_encoder({**weights, "head/bias": bias.ravel()}, mix, about=about, anchors=weights.get(ANCHORS))


def _judged(
    scored: Sequence[LabelledUtterance],
    groups: Groups,
    people: frozenset[str],
    work: Path,
    head: EncoderHead | None,
    on_progress: OnProgress,
) -> dict[str, Any]:
    """Return what a result tells of networks that did not learn from the speakers of these recordings."""
    live, files = (load_model(work / f"{kind}-{LEFT_OUT}.npz") for kind in ("live", "files"))
    small, offline = preset_of(live), preset_of(files)
    in_use = {ModelKind.REAL_TIME: small}
    told = partial(on_progress, "judging")
    found = {
        ModelKind.REAL_TIME: recognise_all(scored, live, told),
        ModelKind.OFFLINE: recognise_all(scored, files, told),
    }
    if head is not None:
        encoder = real_time_model(load_weights(work / f"encoder-{LEFT_OUT}.npz"), head)
        found[ModelKind.ENCODER] = recognise_all(scored, live, told, encoder)
        in_use[ModelKind.ENCODER] = preset_of(live, encoder)
        soft_labels = load_soft_labels(work / SOFT_LABELS)
        found[ModelKind.WHISPER] = [with_head(u, offline, soft_labels[key_of(u)], head.priors) for u in scored]
    chosen = [u for u in scored if u.voice in groups.validation]
    return {
        "validations": {kind: _validated(predictions, groups, people) for kind, predictions in found.items()},
        "by_look_ahead": {kind: recognise_by_look_ahead(chosen, preset) for kind, preset in in_use.items()},
        "adapted": {kind: _gained(adapted_to_each(preset, chosen), people) for kind, preset in in_use.items()},
    }


def _gained(adapted: Iterable[Adapted], people: frozenset[str]) -> dict[str, tuple[Scores, Scores]]:
    """Return the figures before and after some seconds of each speaker were learned."""
    everybody = list(adapted)
    groups = {"all": everybody, PEOPLE: [a for a in everybody if a.voice in people]}
    return {
        name: (scores_of(a.before for a in some), scores_of(a.after for a in some))
        for name, some in groups.items()
        if some
    }


def _validated(predictions: Sequence[Predictions], groups: Groups, people: frozenset[str]) -> Validation:
    by_name: dict[str, list[Answers]] = {}
    for prediction in predictions:
        by_name.setdefault(prediction.utterance.voice, []).append(prediction.answers)
    chosen = {
        "all": groups.validation,
        PEOPLE: groups.validation & people,
        RESERVED: groups.reserved,
        f"{RESERVED} {PEOPLE}": groups.reserved & people,
    }
    answers = {name: [a for voice in sorted(some) for a in by_name.get(voice, ())] for name, some in chosen.items()}
    return Validation(
        {name: scores_of(found) for name, found in by_name.items()},
        {name: scores_of(found) for name, found in answers.items() if found},
        confidence_of(p for p in predictions if p.utterance.voice in groups.validation),
    )


ALL, LEFT_OUT = "all", "left-out"
"""Names of the trainings: on all speakers, and on all but the groups."""
ANCHORS = "anchors"
"""The name of an encoder's anchors among its weights."""


def train_networks(
    work: Path,
    weights: Mapping[str, float],
    left_out: Collection[str],
    config: TrainingConfig,
    whisper: Mapping[str, Float32Array] | None,
    name: str,
    on_progress: Callable[[float], object],
) -> None:
    """Train the encoder, which teaches the small network, that one, and the network for files.

    Their files are written into the folder; those that are there are not trained again.

    Parameters
    ----------
    work : the folder with the examples.
    weights : how often the speech of each speaker is gone through.
    left_out : speakers who do not take part.
    config : how; of the network for live sound.
    whisper : the weights of Whisper's encoder by their names; None for no encoder and no teacher.
    name : `ALL` or `LEFT_OUT`.
    on_progress : called with the share that is done.
    """
    examples = Examples(work, weights, left_out, device_of_choice())
    encoder = None
    if whisper is not None:
        encoder = _encoder(work, examples, config, whisper, name, lambda share: on_progress(0.6 * share))
    for k, (kind, how) in enumerate({"live": config, "files": config.for_files()}.items()):
        path = work / f"{kind}-{name}.npz"
        if path.is_file():
            continue

        def told(share: float, k: int = k) -> None:
            on_progress(0.6 + 0.2 * (k + share))

        network = train_small(examples, how, encoder, path.with_suffix(".state"), told)
        model = _hesitant(network.cpu().finished())
        anchors = examples.anchors("log_powers", N_ANCHORS, N_FRAMES, config.seed)
        save_model(replace(model, warps=WARPS, anchors=anchors), path)
        path.with_suffix(".state").unlink(missing_ok=True)


def _encoder(
    work: Path,
    examples: Examples,
    config: TrainingConfig,
    whisper: Mapping[str, Float32Array],
    name: str,
    on_progress: Callable[[float], object],
) -> TrainableEncoder:
    """Return the causal encoder that its file holds, or train it and write that."""
    path = work / f"encoder-{name}.npz"
    if not path.is_file():
        trained = train_encoder(examples, config, whisper, path.with_suffix(".state"), on_progress)
        anchors = examples.anchors("mels", N_ENCODER_ANCHORS, N_FRAMES, config.seed)
        kept = {k: v.astype(np.float16) for k, v in (trained.finished() | {ANCHORS: anchors}).items()}
        with atomic_write(path) as file:
            np.savez(file, allow_pickle=False, **kept)
        path.with_suffix(".state").unlink(missing_ok=True)
    encoder = TrainableEncoder(whisper, config.n_layers)
    encoder.become_causal(load_weights(path))
    return encoder.to(examples.device).eval()


def load_weights(path: Path) -> dict[str, Float32Array]:
    """Read the weights of an encoder, and its anchors, from an ``.npz`` that this training wrote."""
    with np.load(path, allow_pickle=False) as file:
        return {name: file[name].astype(np.float32) for name in file.files}


HESITATION = 0.2
"""How much more an unidentified sound must be the likeliest, in units of the logarithm of its probability: its frames
are many and of all sorts, and a mouth that stands still during speech is noticed."""
ENCODER_HESITATION, ENCODER_SILENCE = 0.6, 0.25
"""The same for the real-time model, and how much likelier it finds silence. Chosen by the people of the validation,
for whom macro F1 rose by 0.01 and silence was found more often, for 0.002 of the mouth shapes."""
WARPS = (0.8, 1.0, 1.2)
"""Vocal tracts that a model listens with, see `phonemeengine.recognition.learned`; adult voices span about that."""
N_ANCHORS, N_ENCODER_ANCHORS, N_FRAMES = 32, 12, 150
"""Anchors of the small networks and of the real-time model, and frames of each."""


def _hesitant(model: Model) -> Model:
    less = np.zeros(len(Phoneme), np.float32)
    less[Phoneme.UNIDENTIFIED] = HESITATION
    return replace(model, heads=tuple(replace(head, bias=head.bias - less) for head in model.heads))


def _check_enough(sources: Iterable[LabelSource], config: TrainingConfig) -> None:
    if sum(source.minutes for source in sources) * 60 < config.batch_size * config.n_frames * 0.02:
        raise CorpusError(
            "there is too little speech to train with; give at least ten minutes of it, of many speakers"
        )


def _recordings_of(corpora: Sequence[Path], channel: Channel, *, unlabelled: bool) -> list[LabelledUtterance]:
    """Read all folders; a recording that several of them have counts once."""
    known: dict[str, LabelledUtterance] = {}
    for corpus in corpora:
        for utterance in read_corpus(corpus, channel=channel, unlabelled=unlabelled):
            known.setdefault(key_of(utterance), utterance)
    return list(known.values())


def _begin(work: Path, plan: str) -> None:
    """Take a folder for a training; one that holds the same training is gone on with."""
    work.mkdir(parents=True, exist_ok=True)
    told = work / "plan.txt"
    if told.is_file() and told.read_text(encoding="utf-8") != plan:
        raise CorpusError(f"{work}: another training was begun here; remove the folder, or name another output")
    told.write_text(plan, encoding="utf-8")
