"""From folders of labelled speech, whose manifests tell where it comes from, to a model and what its card tells."""

import csv
from collections.abc import Callable, Collection, Iterable, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path

from phonemeengine.calibration.scores.corpus import LabelledUtterance, read_corpus
from phonemeengine.calibration.scores.evaluation import Predictions, confidence_of
from phonemeengine.calibration.scores.scoring import Answers, Scores, scores_of
from phonemeengine.encoder.head import EncoderHead
from phonemeengine.errors import CorpusError
from phonemeengine.recognition.confidence import UNFITTED, ConfidenceCurve
from phonemeengine.recognition.model import Model
from phonemeengine.settings import Channel
from phonemetraining.examples import INDEX, SoftLabels, key_of, write_examples
from phonemetraining.realignment import Round, realign_people
from phonemetraining.teacher import encode_all, teach
from phonemetraining.training import BOTH_WAYS, TrainingConfig, TrainingPart, train_parts
from phonemetraining.validation import (
    HeldOutGroup,
    figures_by_look_ahead,
    folds_of,
    hear_held_out,
)

UNKNOWN = "not told"

HUMAN = "human"
WEIGHTS = {HUMAN: 3.0}
"""How often the speech of a kind is gone through: recordings of people are rare and matter most. All other kinds
count once."""


@dataclass(frozen=True)
class LabelSource:
    """A speaker.

    Attributes
    ----------
    name : corpus/speaker.
    language, kind, licence, package : as the manifest says.
    minutes : of speech.
    n_recordings : how many.
    """

    name: str
    language: str
    kind: str
    licence: str
    package: str
    minutes: float
    n_recordings: int

    @property
    def weight(self) -> float:
        """How often its speech is gone through in an epoch."""
        return WEIGHTS.get(self.kind, 1.0)


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
        )
        for name, entries in sorted((name, list(recordings.values())) for name, recordings in rows.items())
    ]


OnProgress = Callable[[str, float], object]
"""Is told what goes on, and how much of it is done, 0..1."""


PEOPLE = "people"


@dataclass(frozen=True)
class Validation:
    """How well speakers were recognised that were not heard in the training.

    Attributes
    ----------
    held_out : by speaker, the figures of a model that was trained without it; empty without a validation.
    together : the same for ``all`` speakers, and for ``people`` alone where there are some.
    confidence : how sure the answers are.
    """

    held_out: dict[str, Scores] = field(default_factory=dict)
    together: dict[str, Scores] = field(default_factory=dict)
    confidence: ConfidenceCurve = UNFITTED


@dataclass(frozen=True)
class TrainedModel:
    """A model, and how well others of its kind did on speakers whom they had not heard.

    Attributes
    ----------
    model : trained on all speakers.
    config : how.
    validation : how well others of its kind did.
    by_look_ahead : macro F1 and the share of right mouth shapes by look-ahead, seconds, of some of their recordings.
    adapted : for ``all`` speakers and ``people``, the figures on some of their recordings before and after a few
        seconds of their voice were learned.
    """

    model: Model
    config: TrainingConfig
    validation: Validation
    by_look_ahead: dict[float, tuple[float, float]] = field(default_factory=dict)
    adapted: dict[str, tuple[Scores, Scores]] = field(default_factory=dict)


@dataclass(frozen=True)
class TrainingResult:
    """The outcome of a training.

    Attributes
    ----------
    sources : the speakers.
    live : the model that follows a microphone.
    files : its twin for files, which hears as far ahead as back.
    rounds : in which the labels of people were moved.
    head : on the teacher's encoder, trained on all speakers; None without a teacher.
    with_encoder : how well the model for files and the encoder do together.
    n_folds, n_validated : groups of speakers, and how many of these were left out of a training.
    """

    sources: tuple[LabelSource, ...]
    live: TrainedModel
    files: TrainedModel
    rounds: tuple[Round, ...] = ()
    head: EncoderHead | None = None
    with_encoder: Validation = field(default_factory=Validation)
    n_folds: int = 0
    n_validated: int = 0


def train_and_validate(
    corpora: Sequence[Path],
    config: TrainingConfig,
    n_variations: int,
    n_folds: int,
    on_progress: OnProgress,
    work: Path,
    *,
    n_validated: int | None = None,
    channel: Channel = Channel.MIX,
    whisper: Path | None = None,
) -> TrainingResult:
    """Train the model for live sound and its twin for files, and validate both on speakers left out.

    Parameters
    ----------
    corpora : folders in the corpus format.
    config : how to train the one for live sound.
    n_variations : of each recording, besides the recording itself.
    n_folds : groups of speakers, each of which is left out once; 0 for no validation.
    n_validated : how many of these groups are left out, the first ones, which saves the time of the others; None
        for all.
    on_progress : is told of the progress.
    work : a folder for what is done so far; a training that was interrupted goes on from there.
    channel : what is heard of sounds that have several.
    whisper : the folder of the teacher's encoder; None for no teacher.

    Raises
    ------
    CorpusError : a folder is none, there is too little speech for a batch, or `work` holds another training.
    EngineError : a sound cannot be read.
    ModelError : the teacher cannot be used.
    """
    utterances = _recordings_of(corpora, channel, unlabelled=whisper is not None)
    sources = tuple(sources_of(corpora))
    _check_enough(sources, config)
    configs = (config, replace(config, centred=True, dilations=BOTH_WAYS))
    _begin(work, repr((configs, n_variations, n_folds, n_validated, channel, sources, whisper is not None)))
    speakers = _Speakers.of(sources, n_folds)
    taught = _teach(utterances, speakers, config, work, whisper, on_progress)
    _measure(taught, n_variations, config.seed, work, on_progress)
    # Held-out speakers are scored by the labels as they came, not by those that this training moved.
    scored = [utterance for utterance in utterances if utterance.labels]
    validated = speakers.groups[:n_validated]
    parts = [
        TrainingPart(f"{name}-{k}", kind, tuple(u for u in scored if u.voice in group))
        for k, group in enumerate((set[str](), *validated))
        for name, kind in zip(("live", "files"), configs, strict=True)
    ]
    hear = partial(hear_held_out, teacher=None if taught.head is None else work)
    found = train_parts(parts, work, speakers.weights, hear, partial(on_progress, "training"))
    by_kind = [[group for _, group in found[k :: len(configs)]] for k in range(len(configs))]
    live, files = (
        _trained(model, kind, done, speakers.people)
        for (model, _), kind, done in zip(found, configs, by_kind, strict=False)
    )
    with_encoder = [heard.with_encoder for group in by_kind[-1] for heard in group.heard]
    together = _validated([predictions for predictions in with_encoder if predictions is not None], speakers.people)
    return TrainingResult(sources, live, files, taught.rounds, taught.head, together, n_folds, len(validated))


def _check_enough(sources: Iterable[LabelSource], config: TrainingConfig) -> None:
    if sum(source.minutes for source in sources) * 60 < config.batch_size * config.n_frames * 0.02:
        raise CorpusError(
            "there is too little speech to train with; give at least ten minutes of it, of many speakers"
        )


@dataclass(frozen=True)
class _Speakers:
    """How often each speaker is gone through, which of them are people, and the groups of the validation."""

    weights: dict[str, float]
    people: set[str]
    groups: list[set[str]]

    @classmethod
    def of(cls, sources: Iterable[LabelSource], n_folds: int) -> "_Speakers":
        weights = {source.name: source.weight for source in sources}
        people = {source.name for source in sources if source.kind == HUMAN}
        return cls(weights, people, folds_of(list(weights), n_folds))


@dataclass(frozen=True)
class _Taught:
    """The recordings with the labels that are learned from, and what the teacher says of them, if there is one."""

    utterances: Sequence[LabelledUtterance]
    soft_labels: SoftLabels | None = None
    head: EncoderHead | None = None
    rounds: tuple[Round, ...] = ()


def _teach(
    utterances: Sequence[LabelledUtterance],
    speakers: _Speakers,
    config: TrainingConfig,
    work: Path,
    whisper: Path | None,
    on_progress: OnProgress,
) -> _Taught:
    """Have the teacher hear all recordings, and move the labels of people to where its heads agree with them."""
    if whisper is None:
        return _Taught(utterances)
    weights, groups, people = speakers.weights, speakers.groups, speakers.people
    encoded = encode_all(utterances, work / "encoder", whisper, partial(on_progress, "encoding"))
    soft_labels, head = teach(utterances, encoded, weights, config.seed, work, partial(on_progress, "teaching"))
    if not (soft_labels and groups and people):
        return _Taught(utterances, soft_labels, head)
    aligning = partial(on_progress, "aligning")
    moved, rounds = realign_people(utterances, people, weights, groups, soft_labels, config, work, aligning)
    return _Taught(moved, soft_labels, head, tuple(rounds))


def _measure(taught: _Taught, n_variations: int, seed: int, work: Path, on_progress: OnProgress) -> None:
    """Write the examples of all recordings and their variations, unless an interrupted training did."""
    if (work / INDEX).is_file():
        return
    n_done = 0

    def count(n: int) -> None:
        nonlocal n_done
        n_done += n
        on_progress("measuring", n_done / len(taught.utterances))

    write_examples(work, taught.utterances, n_variations, seed, taught.soft_labels, count)


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


def _trained(
    model: Model, config: TrainingConfig, groups: Sequence[HeldOutGroup], people: Collection[str]
) -> TrainedModel:
    heard = [h for group in groups for h in group.heard]
    adapted = [a for group in groups for a in group.adapted]
    chosen = {"all": adapted, PEOPLE: [a for a in adapted if a.voice in people]}
    gains = {
        name: (scores_of(a.before for a in some), scores_of(a.after for a in some))
        for name, some in chosen.items()
        if some
    }
    validation = _validated([h.predictions for h in heard], people)
    return TrainedModel(model, config, validation, figures_by_look_ahead(heard), gains)


def _validated(predictions: list[Predictions], people: Collection[str]) -> Validation:
    by_name: dict[str, list[Answers]] = {}
    for prediction in predictions:
        by_name.setdefault(prediction.utterance.voice, []).append(prediction.answers)
    together = {"all": list(by_name), PEOPLE: [name for name in by_name if name in people]}
    return Validation(
        {name: scores_of(answers) for name, answers in by_name.items()},
        {
            group: scores_of(answers for name in names for answers in by_name[name])
            for group, names in together.items()
            if names
        },
        confidence_of(predictions),
    )
