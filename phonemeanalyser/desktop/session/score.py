"""How right what is recognised is, beside labels: of what is seen, of this file, of everything loaded."""

from pathlib import Path
from typing import NamedTuple

import numpy as np
from PySide6.QtCore import QObject, QTimer, Signal

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.session.label_tiers import LabelTiers
from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeanalyser.desktop.session.seen_sound import SeenSound
from phonemeanalyser.desktop.session.time_view import Scope
from phonemeanalyser.desktop.tasks import CLOSE_TIMEOUT, TaskQueue
from phonemeengine.arrays import UInt8Array
from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.calibration.scores.scoring import Agreement, Confusion, confusion_between
from phonemeengine.calibration.workbench.labelled_features import LabelledFeatures
from phonemeengine.inspection.whole_sound import FrameRange, SoundTracks
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import FRAME_PERIOD

ANSWER_MS = 16
"""After a change, until the figures are others: a threshold that is dragged changes all the time."""
Utterances = tuple[LabelledUtterance, ...]


class ConfusionExample(NamedTuple):
    """A segment in which one phoneme was taken for another: the sound, and seconds."""

    path: Path
    start: float
    end: float


class _Loaded(NamedTuple):
    """What a preset recognises in the takes and recordings that are loaded."""

    preset: Preset
    utterances: Utterances
    confusion: Confusion


class ScoreModel(QObject):
    """Follows preset, file, view, labels and what is loaded, and counts anew.

    Signals
    -------
    changed : the figures are others.
    error : a sentence for the user.

    Attributes
    ----------
    scope : of what the figures are: of what is seen, of the whole file, or of everything loaded.
    agreement : of the preset in use; None where nothing is labelled.
    before : what it was before the change that goes on, such as a drag; None without one.
    other : of the other one of A and B; None without one, or while it is measured.
    outdated : whether more is being analysed, and the figures are those from before.
    """

    changed = Signal()
    error = Signal(str)

    def __init__(self, preset: PresetModel, seen: SeenSound, labels: LabelTiers) -> None:
        super().__init__()
        self.scope = Scope.WHOLE
        self.agreement: Agreement | None = None
        self.before: Agreement | None = None
        self.other: Agreement | None = None
        self.outdated = False
        self._preset, self._seen, self._labels = preset, seen, labels
        self._loaded: dict[str, _Loaded] = {}
        self._utterances: Utterances = ()
        self._measures_loaded = False
        self._run: int | None = None  # of the change that goes on; None: the next one begins it
        self._side = preset.letter
        self._opened = labels.opened
        self._codes: UInt8Array | None = None
        self._knows_file = False
        self._codes_before: UInt8Array | None = None
        self._loaded_before: Confusion | None = None
        self._n_shown: dict[tuple[Phoneme, Phoneme], int] = {}
        self._wanted: tuple[str, Preset, Utterances] | None = None
        self._measuring = TaskQueue(self.error.emit)
        self._answering = QTimer(self, singleShot=True, interval=ANSWER_MS)
        self._answering.timeout.connect(self._answer)
        preset.changed.connect(self._follow_preset)
        preset.loaded.connect(self._forget_before)
        for signal in (seen.whole.changed, seen.second.whole.changed, seen.view.moved, labels.changed):
            signal.connect(self._answer_soon)
        preset.sides_changed.connect(self._measure_other)

    # -- what it is of ------------------------------------------------------------------------------------

    @property
    def busy(self) -> bool:
        """Whether other figures are to come."""
        return self._answering.isActive() or self._measuring.busy

    @property
    def file(self) -> Path | None:
        """The open file, where its own labels can be compared; the recording of a microphone has none."""
        return None if self._seen.sound is None or self._seen.looks_back else self._seen.sound[0]

    @property
    def span(self) -> tuple[float, float]:
        """From when to when the file is scored, seconds."""
        frames = self._frames()
        return frames.start * FRAME_PERIOD, frames.stop * FRAME_PERIOD

    @property
    def voices(self) -> tuple[int, int]:
        """How many takes and recordings are loaded besides the file, and how many people speak in them."""
        return len(self._utterances), len({utterance.voice for utterance in self._utterances})

    @property
    def adds_file(self) -> bool:
        """Whether the open file counts beside what is loaded: it is labelled, and not among the recordings."""
        return bool(self._n_labelled()) and self.file not in {u.path for u in self._utterances}

    @property
    def why_not(self) -> str:
        """Why there are no figures, as a sentence; empty where there are some, or will be."""
        if self.scope is Scope.LOADED:
            nothing = not self._utterances and not self._n_labelled()
            return tr("No labelled sound is loaded.") if nothing else ""
        if self.file is None:
            return tr("No file is open.")
        if self._labels.tiers and self._labels.said_frames() is None:
            return tr("No tier of the labels names phonemes only. Choose another one with Labels > Tiers.")
        if not self._n_labelled():
            return tr("No labels yet.")
        return "" if self._frames().stop > self._frames().start else tr("Nothing in view is labelled.")

    def choose(self, scope: Scope) -> None:
        """Have the figures of something else."""
        if scope is not self.scope:
            self.scope = scope
            self._forget_before()
            self._measure_other()
            self._answer()

    def show_measuring(self, *, on: bool) -> None:
        """Take note of whether takes and recordings are being measured."""
        self._measures_loaded = on
        self._answer_soon()

    def show_loaded(self, confusion: Confusion | None, utterances: Utterances) -> None:
        """Take what the preset in use recognises in takes and recordings."""
        if utterances != self._utterances:
            self._utterances, self._loaded_before = utterances, None
        self._loaded.pop(self._preset.letter, None)
        if confusion is not None:
            self._loaded[self._preset.letter] = _Loaded(self._preset.in_force, utterances, confusion)
        self._measure_other()
        self._answer_soon()

    def next_example(self, truth: Phoneme, answer: Phoneme) -> ConfusionExample | None:
        """Return a segment in which one was taken for the other: the longest first, then another each time."""
        found = [
            ConfusionExample(path, begin + segment.start, begin + segment.end)
            for confusion, paths, begin in self._confusions()
            for segment in confusion.frames_in(truth, answer)
            for path in (paths[segment.recording],)
        ]
        if not found:
            return None
        found.sort(key=lambda example: (round((example.start - example.end) / FRAME_PERIOD), example.start))
        k = self._n_shown.get((truth, answer), 0) % len(found)
        self._n_shown[truth, answer] = k + 1
        return found[k]

    def close(self) -> None:
        """End all work."""
        self._answering.stop()
        self._measuring.close(CLOSE_TIMEOUT)

    # -- the work -----------------------------------------------------------------------------------------

    def _n_labelled(self) -> int:
        said = None if self.file is None else self._labels.said_frames()
        return 0 if said is None else len(said.phonemes)

    def _frames(self) -> slice:
        """Return the labelled frames of the file that count."""
        n, seen = self._n_labelled(), self._seen.view.seen
        if self.scope is not Scope.SEEN:
            return slice(0, n)
        first = min(int(seen.start / FRAME_PERIOD + 0.5), n)
        return slice(first, max(first, min(int(seen.end / FRAME_PERIOD + 0.5), n)))

    def _file_codes(self, tracks: SoundTracks | None) -> UInt8Array | None:
        """Return what is recognised in the frames that are labelled; None while some that count are not known."""
        frames = self._frames()
        if tracks is None or not tracks.is_known(FrameRange(frames.start, frames.stop)):
            return None
        codes = np.zeros(self._n_labelled(), np.uint8)  # what comes after the sound counts as silence
        n = min(len(codes), tracks.n_frames)
        codes[:n] = tracks.phonemes[:n]
        return codes

    def _file_confusion(self, codes: UInt8Array | None) -> Confusion | None:
        said, frames = self._labels.said_frames(), self._frames()
        if self.file is None or said is None or codes is None or len(codes) != len(said.phonemes):
            return None
        n = frames.stop - frames.start
        return confusion_between(said.at(frames), codes[frames], np.array([0, n])) if n else None

    def _confusions(self) -> list[tuple[Confusion, list[Path], float]]:
        """Return what counts now, with the paths of its recordings, and where the first one begins."""
        found: list[tuple[Confusion, list[Path], float]] = []
        own = self._loaded.get(self._preset.letter)
        if self.scope is Scope.LOADED and own is not None:
            found.append((own.confusion, [u.path for u in own.utterances], 0.0))
        file = self._file_confusion(self._codes) if self.scope is not Scope.LOADED or self.adds_file else None
        if file is not None and self.file is not None:
            found.append((file, [self.file], self.span[0]))
        return found

    def _agreement(self, codes: UInt8Array | None, loaded: Confusion | None) -> Agreement | None:
        """Return the figures of what was recognised in the file, and in what is loaded, as far as these count."""
        with_file = self.scope is not Scope.LOADED or self.adds_file
        with_loaded = self.scope is Scope.LOADED and bool(self._utterances)
        parts = [self._file_confusion(codes)] if with_file else []
        parts += [loaded] if with_loaded else []
        agreements = [part.agreement for part in parts if part is not None]
        return sum(agreements[1:], agreements[0]) if agreements and len(agreements) == len(parts) else None

    def _answer(self) -> None:
        if self._labels.opened != self._opened:
            self._opened, self.agreement, self._codes_before = self._labels.opened, None, None
        own, other = (self._loaded.get(letter) for letter in (self._preset.letter, self._preset.other_letter))
        tracks = self._seen.whole.tracks
        self._codes = self._file_codes(tracks)
        self._knows_file = tracks is not None and tracks.is_known(FrameRange(0, tracks.n_frames))
        now = self._agreement(self._codes, own.confusion if own else None)
        waits = self.scope is Scope.LOADED and self._measures_loaded
        is_old = waits and (own is None or own.preset != self._preset.in_force)
        self.outdated = is_old or (now is None and not self.why_not)
        if now is not None or self.why_not:
            self.agreement = now
        self.before = self._agreement(self._codes_before, self._loaded_before)
        known = self._file_codes(self._seen.second.whole.tracks) if self._preset.other is not None else None
        self.other = self._agreement(known, other.confusion if other else None)
        self.changed.emit()

    def _answer_soon(self) -> None:
        if not self._answering.isActive():
            self._answering.start()

    def _follow_preset(self) -> None:
        """Keep what was recognised before a change begins."""
        if self._preset.letter != self._side:
            self._side = self._preset.letter
            self._forget_before()
        elif self._preset.run != self._run:
            loaded = self._loaded.get(self._preset.letter)
            self._codes_before = self._codes if self._knows_file else None
            self._loaded_before = loaded.confusion if loaded else None
            self._run, self._n_shown = self._preset.run, {}
        self._answer_soon()

    def _forget_before(self) -> None:
        self._run = self._codes_before = self._loaded_before = self.before = None
        self._n_shown = {}
        self._answer_soon()

    def _measure_other(self) -> None:
        """Have the other one of A and B recognise what is loaded, where that counts and is not known."""
        other, letter, utterances = self._preset.other, self._preset.other_letter, self._utterances
        known = self._loaded.get(letter)
        if known is not None and (other is None or (known.preset, known.utterances) != (other.preset, utterances)):
            del self._loaded[letter]
        counts = other is not None and self.scope is Scope.LOADED and bool(utterances)
        wanted = (letter, other.preset, utterances) if other is not None and counts else None
        if letter in self._loaded or wanted is None:
            self._measuring.cancel()
            self._wanted = None
        elif wanted != self._wanted:
            self._wanted, preset = wanted, wanted[1]
            self._measuring.replace(
                lambda progress: LabelledFeatures(utterances, preset, progress=progress).confusion(preset),
                lambda confusion: self._take_other(letter, _Loaded(preset, utterances, confusion)),
            )
        self._answer_soon()

    def _take_other(self, letter: str, loaded: _Loaded) -> None:
        self._loaded[letter], self._wanted = loaded, None
        self._answer_soon()
