"""Our recognisers and others on the same labelled recordings, as one table; see docs/figures.md."""

import argparse
import json
import math
import re
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from datetime import date
from pathlib import Path

import numpy as np
import soxr

from phonemeengine import LabelledUtterance, Preset, load_preset, read_recordings
from phonemeengine.arrays import UInt8Array
from phonemeengine.calibration.scores.corpus import frame_labels_of
from phonemeengine.calibration.scores.evaluation import HUMAN, kind_of, predict
from phonemeengine.calibration.scores.scoring import Scores, scores_of
from phonemeengine.labels.utterance import CORE
from phonemeengine.presets.files import DEFAULT_PRESET
from phonemeengine.presets.model_choice import (
    for_files,
    for_live_use,
    frames_ahead,
    has_model,
    model_in_words,
    with_small_network,
)
from phonemeengine.settings import FRAME_PERIOD, SAMPLE_RATE, ModelKind
from tools.bench.peers.mapping import best_delay, delayed, frames_of
from tools.bench.peers.peer import LEFT_OUT, PEERS, Answer, Peer, PeerError, Workshop

COLUMNS = "macro F1 | mouth shapes | clear vowels | silence recall | false silence | delay | x real time"
OUTSIDE = "*"
"""Marks figures of recordings in languages that a recogniser is not made for."""
MOST_MINUTES = 6.0
"""Of speech that are compared where nothing else is asked for: one core needs some minutes for that."""
LEARNED = ", learned from"
"""Marks speakers from whom the network learned."""


@dataclass(frozen=True)
class Row:
    """What a recogniser answered.

    Attributes
    ----------
    title : its name.
    notes : how it was used, in words.
    frames : codes of `Phoneme` for each recording, as many as it has labels.
    delay : by which they were taken to come late, seconds.
    speed : seconds of sound for one of the processor.
    language : the only one that it is made for; empty for all.
    shapes_only : whether it tells no ten classes.
    """

    title: str
    notes: str
    frames: tuple[UInt8Array, ...]
    delay: float
    speed: float
    language: str = ""
    shapes_only: bool = False


class Comparison:
    """Labelled recordings, and what recognisers answer there.

    Parameters
    ----------
    utterances : the recordings.
    """

    def __init__(self, utterances: Sequence[LabelledUtterance]) -> None:
        self.utterances = utterances
        self.labels = [frame_labels_of(utterance.labels) for utterance in utterances]
        self.minutes = sum(len(labels.phonemes) for labels in self.labels) * FRAME_PERIOD / 60

    def of_preset(self, title: str, preset: Preset) -> Row:
        """Recognise all with a preset, as `score` does."""
        predict(self.utterances[0], preset)  # opens its models
        began = time.process_time()
        frames = tuple(predict(utterance, preset).phonemes for utterance in self.utterances)
        return Row(title, model_in_words(preset), frames, 0.0, self._speed(time.process_time() - began))

    def of_peer(self, peer: Peer, answers: Sequence[Answer]) -> Row:
        """Take the answers of a peer by the delay and the length with which those of its language score best."""
        chosen = [k for k, u in enumerate(self.utterances) if u.language.startswith(peer.language)]
        chosen = chosen or list(range(len(self.utterances)))
        labels = [self.labels[k] for k in chosen]

        def judged_by(scores: Scores) -> float:
            return scores.viseme_accuracy if peer.shapes_only else scores.macro_f1

        found = []
        for longest in peer.longest:
            frames = [frames_of(answer.marks, peer.class_of, longest) for answer in answers]
            delay, figure = best_delay(labels, [frames[k] for k in chosen], judged_by)
            found.append((figure, longest, delay, frames))
        _, longest, delay, frames = max(found, key=lambda candidate: candidate[0])
        shifted = delayed(self.labels, frames, delay)
        at_most = "" if math.isinf(longest) else f", at most {1000 * longest:g} ms"
        notes = f"{peer.package}: {peer.settings}{at_most}"
        speed = self._speed(sum(answer.seconds for answer in answers))
        return Row(peer.title, notes, shifted, delay * FRAME_PERIOD, speed, peer.language, peer.shapes_only)

    def write_sounds(self, folder: Path, rate: int) -> Path:
        """Write all sounds as 16-bit samples at a rate, and their list; gives the file of the list."""
        listed = []
        for number, utterance in enumerate(self.utterances):
            with utterance.opened() as reader:
                samples = np.concatenate(list(reader.blocks(SAMPLE_RATE)))
            if rate != SAMPLE_RATE:
                samples = soxr.resample(samples, SAMPLE_RATE, rate)
            path = folder / f"{number}-{rate}.raw"
            np.rint(np.clip(samples, -1, 1) * 32767).astype("<i2").tofile(path)
            labels = [(x.start, x.end, x.phoneme.label) for x in utterance.labels if x.certainty == CORE]
            listed.append({"path": str(path), "speaker": utterance.voice, "labels": labels})
        path = folder / f"sounds-{rate}.json"
        path.write_text(json.dumps(listed), encoding="utf-8")
        return path

    def _speed(self, seconds: float) -> float:
        return 60 * self.minutes / max(seconds, 1e-9)


def first_of_each(utterances: Sequence[LabelledUtterance], minutes: float) -> list[LabelledUtterance]:
    """Return the first recordings of all speakers, taken by turns as long as they last no more than some minutes."""
    seen: Counter[str] = Counter()
    turns = []
    for k, utterance in enumerate(utterances):
        turns.append((seen[utterance.voice], k))
        seen[utterance.voice] += 1
    order = [k for _, k in sorted(turns)]
    ends = np.cumsum([len(frame_labels_of(utterances[k].labels).phonemes) * FRAME_PERIOD / 60 for k in order])
    return [utterances[k] for k in sorted(order[: int((ends <= minutes).sum())])]


def ours() -> Iterator[tuple[str, Preset]]:
    """Return the presets that are compared, each as it is used, under its title."""
    learned = load_preset(DEFAULT_PRESET)
    live, small = for_live_use(learned), with_small_network(learned)
    yield f"learned, small network, {_ahead(small)}", small
    yield f"learned, small network, {_ahead(learned)}", for_files(learned, ModelKind.REAL_TIME)
    if live.model_kind is ModelKind.ENCODER:
        yield f"learned, real-time model, {_ahead(live)}", live
        slower = for_files(learned, ModelKind.ENCODER)
        yield f"learned, real-time model, {_ahead(slower)}", slower
    for title, kind in (
        ("learned, files, offline model", ModelKind.OFFLINE),
        ("learned, files with Whisper's encoder", ModelKind.WHISPER),
    ):
        if has_model(learned, kind):
            yield title, for_files(learned, kind)
    for name in ("templates", "extended"):
        yield name, load_preset(name)


def _ahead(preset: Preset) -> str:
    return f"look-ahead {1000 * frames_ahead(preset) * FRAME_PERIOD:g} ms"


def learned_from() -> set[str]:
    """Return the speakers of the training of the default preset, as its card lists them."""
    card = DEFAULT_PRESET.with_suffix(".md").read_text(encoding="utf-8")
    return set(re.findall(r"^\| (\S+/\S+) \| [\w-]+ \| [\d.]+ \|", card, re.MULTILINE))


def groups_of(utterances: Sequence[LabelledUtterance], known: set[str]) -> dict[str, list[int]]:
    """Return the recordings that have figures, by the group's name; a group like one before is left out."""
    asked: dict[str, Callable[[LabelledUtterance], bool]] = {
        "all": lambda u: True,
        "people": lambda u: kind_of(u) == HUMAN,
        "English": lambda u: u.language.startswith("en"),
        "people, English": lambda u: kind_of(u) == HUMAN and u.language.startswith("en"),
        "*learned* did not learn from": lambda u: u.voice not in known,
    }
    found: dict[str, list[int]] = {}
    for name, wanted in asked.items():
        chosen = [k for k, utterance in enumerate(utterances) if wanted(utterance)]
        if chosen and chosen not in found.values():
            found[name] = chosen
    return found


def table_of(comparison: Comparison, rows: Sequence[Row], groups: dict[str, list[int]]) -> Iterator[str]:
    """Write the figures as a table in Markdown; each cell has those of all groups."""
    yield f"| recogniser | {COLUMNS} |"
    yield "| --- " * 8 + "|"
    for row in rows:
        scored = [_figures_of(comparison, row, chosen) for chosen in groups.values()]
        cells = [" / ".join(cell) for cell in zip(*scored, strict=True)]
        yield f"| {row.title} | {' | '.join(cells)} | {1000 * row.delay:.0f} ms | {row.speed:.0f} |"


def _figures_of(comparison: Comparison, row: Row, chosen: Sequence[int]) -> list[str]:
    s = scores_of((comparison.labels[k], row.frames[k]) for k in chosen)
    foreign = any(not comparison.utterances[k].language.startswith(row.language) for k in chosen)
    macro_f1 = math.nan if row.shapes_only else s.macro_f1
    figures = (macro_f1, s.viseme_accuracy, s.vowel_accuracy, s.silence_recall, s.false_silence)
    return ["–" if math.isnan(figure) else f"{figure:.2f}{OUTSIDE * foreign}" for figure in figures]


def _groups_in_words(comparison: Comparison, groups: dict[str, list[int]]) -> Iterator[str]:
    for name, chosen in groups.items():
        n_voices = len({comparison.utterances[k].voice for k in chosen})
        minutes = sum(len(comparison.labels[k].phonemes) for k in chosen) * FRAME_PERIOD / 60
        yield f"{name} ({n_voices} speaker{'s' * (n_voices != 1)}, {minutes:.1f} minutes)"


def _speakers(utterances: Sequence[LabelledUtterance], known: set[str]) -> str:
    voices = sorted({(utterance.voice, utterance.language) for utterance in utterances})
    return ", ".join(f"{voice} ({language}{LEARNED * (voice in known)})" for voice, language in voices)


def main() -> None:
    """Recognise the recordings of a corpus with all that can be run, and print the table."""
    parser = argparse.ArgumentParser(prog="python -m tools.bench.peers", description=__doc__)
    parser.add_argument("corpus", nargs="?", type=Path, default=Path("tests/data/corpus"))
    parser.add_argument("--folder", type=Path, default=Path("build/peers"), help="where the others are installed")
    least = "of recordings, by turns of each speaker in the order of the manifest (default: %(default)g)"
    parser.add_argument("--minutes", type=float, default=MOST_MINUTES, help=least)
    options = parser.parse_args()
    utterances = first_of_each(read_recordings(options.corpus), options.minutes)
    comparison, workshop = Comparison(utterances), Workshop(options.folder)
    rows, troubles = [], [LEFT_OUT]
    for title, preset in ours():
        print(f"recognising with {title} ...", flush=True)
        rows.append(comparison.of_preset(title, preset))
    with tempfile.TemporaryDirectory() as folder:
        sounds = {rate: comparison.write_sounds(Path(folder), rate) for rate in {peer.rate for peer in PEERS}}
        for peer in PEERS:
            print(f"recognising with {peer.title} ...", flush=True)
            try:
                rows.append(comparison.of_peer(peer, workshop.answers_of(peer, sounds[peer.rate])))
            except PeerError as error:
                troubles.append(f"{peer.title} is left out: {error}")
    known = learned_from()
    groups = groups_of(comparison.utterances, known)
    print(f"\n{date.today()}; each cell: {' / '.join(_groups_in_words(comparison, groups))}\n")
    print(*table_of(comparison, rows, groups), sep="\n")
    print(f"\n{OUTSIDE} made for one language alone: others are outside of its claim\n")
    print(*(f"- {row.title}: {row.notes}" for row in rows), *(f"- {trouble}" for trouble in troubles), sep="\n")
    print(f"\nSpeakers: {_speakers(comparison.utterances, known)}")


if __name__ == "__main__":
    main()
