"""The movement of a face through a recording or a spoken text, generated as an export of it would be."""

from collections.abc import Callable, Iterator
from contextlib import closing
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

import numpy as np

from phonemeengine.analyser import analyse_blocks
from phonemeengine.arrays import Float32Array
from phonemeengine.audio.output import Reader
from phonemeengine.batch.work import say_nothing
from phonemeengine.conversion.driving import DriverChoice
from phonemeengine.features.front_end import F0
from phonemeengine.inspection.whole_sound import FrameState, SoundTracks
from phonemeengine.labels.utterance import Utterance
from phonemeengine.mouth.animation import Animation
from phonemeengine.mouth.exports.exporter import Exporter, ExportOptions
from phonemeengine.mouth.transcript import NOTHING, Transcript, transcript_of, transcript_of_utterance
from phonemeengine.presets.model_choice import for_files
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.segments import SegmentBuilder
from phonemeengine.settings import SAMPLE_RATE


@dataclass(frozen=True)
class RecordedSpeech:
    """A recording of which all is recognised, or a text that a voice speaks.

    Attributes
    ----------
    path, duration : its file, None for a text; and how long it lasts, seconds.
    tracks : what is recognised; None for a text.
    utterance : what is said; None where that is unknown.
    """

    path: Path | None
    duration: float
    tracks: SoundTracks | None
    utterance: Utterance | None = None

    def transcript(self) -> Transcript:
        """Return what is said, and how loud and high."""
        loudness = pitches = NOTHING
        name, builder = "" if self.path is None else self.path.name, SegmentBuilder()
        if self.tracks is not None:
            loudness, pitches = self.tracks.intensities, self.tracks.features.values[:, F0].astype(np.float32)
        if self.utterance is not None:
            return transcript_of_utterance(self.utterance, loudness, pitches, name, self.path)
        if self.tracks is None:
            return Transcript(name, self.duration)
        runs = (*builder.extend(self.tracks.phonemes, loudness), *builder.finish(self.duration))
        return Transcript(name, self.duration, runs, loudness, pitches, self.path)


def recording_of(
    path: Path | None, duration: float, tracks: SoundTracks | None, utterance: Utterance | None = None
) -> RecordedSpeech | None:
    """Return a recording; None while not all of it is recognised."""
    if path is None or tracks is None or not tracks.n_frames or np.any(tracks.states == FrameState.UNKNOWN):
        return None
    return RecordedSpeech(path, duration, tracks, utterance)


def heard_in(reopen: Callable[[], Reader], preset: Preset, name: str) -> Transcript:
    """Return what a preset recognises in a sound that is in no file, from its beginning to its end."""
    n_samples = 0

    def counted() -> Iterator[Float32Array]:
        nonlocal n_samples
        for block in _blocks_of(reopen):
            n_samples += len(block)
            yield block

    analyses = [*analyse_blocks(counted(), for_files(preset), pitch=True)]
    return transcript_of(analyses, name, n_samples / SAMPLE_RATE)


def movement_of(
    speech: Transcript, options: ExportOptions, choice: DriverChoice, reopen: Callable[[], Reader] | None = None
) -> Animation:
    """Return how a face says what is said in a recording, or a text.

    Parameters
    ----------
    reopen : gives the sound from its beginning, which a network follows; None where there is none.

    Raises
    ------
    EngineError : the driver cannot move a face by it.
    """
    exporter, utterance = Exporter("curves-json", replace(options, mesh=None)), speech.utterance
    with choice.opened(utterance.language if utterance else "") as driving:
        driver = driving.chosen(utterance, speech.name, exporter.takes)
        sound = None if reopen is None else partial(_blocks_of, reopen)
        track = driving.track(driver, utterance, speech, say_nothing, sound=sound)
        movement = driving.movement(track, speech, exporter, say_nothing)
    return exporter.export_of(speech, movement).animation


def _blocks_of(reopen: Callable[[], Reader]) -> Iterator[Float32Array]:
    with closing(reopen()) as reader:
        while len(block := reader.read(SAMPLE_RATE)):
            yield reader.mono(block)
