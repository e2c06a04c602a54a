"""The averaged spectra of files, selections, speakers and phonemes: what is averaged, and the averaging."""

import math
import os
from collections import defaultdict
from collections.abc import Collection, Sequence
from dataclasses import replace
from enum import StrEnum
from pathlib import Path

import numpy as np

from phonemeengine.analyser import analyse_range
from phonemeengine.arrays import BoolArray
from phonemeengine.audio.files import SoundReader, sounds_under
from phonemeengine.calibration.scores.corpus import LabelledUtterance, OnSkipped, is_labelled, read_recordings
from phonemeengine.errors import AudioError, CorpusError, CurveError
from phonemeengine.execution import Progress, no_progress, report_progress, subrange
from phonemeengine.inspection.averaged_spectrum import AveragedSpectrum, SoundPart, SpectrumAverage
from phonemeengine.inspection.measurement import frames_between
from phonemeengine.inspection.whole_sound import tracks_of
from phonemeengine.labels.phone_sets import PhonemeMap
from phonemeengine.labels.utterance import CORE
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import FRAME_PERIOD, AnalysisSettings, Channel
from phonemeengine.storage.files import printable_name

VOWELS = (Phoneme.A, Phoneme.E, Phoneme.I, Phoneme.O, Phoneme.U)
MOST_LISTED = 5
"""Phonemes that the name of an average lists."""


class Grouping(StrEnum):
    """What each average is of: a speaker, a phoneme, or a phoneme of a speaker."""

    SPEAKER = "speaker"
    PHONEME = "phoneme"
    SPEAKER_PHONEME = "speaker-phoneme"


Groups = dict[str, tuple[SoundPart, ...]]
"""What is averaged together, by the name of the average."""


def average_spectrum(
    path: str | os.PathLike[str],
    start: float,
    end: float,
    preset: Preset,
    name: str,
    *,
    channel: Channel = Channel.MIX,
    progress: Progress = no_progress,
) -> AveragedSpectrum:
    """Return the averaged spectrum of a selection of a sound file, through the filters of the preset.

    Raises
    ------
    AudioError : the file cannot be read, or the selection holds nothing of it.
    Cancelled : `progress` did not want to go on.
    """
    part = SoundPart(Path(path), channel, ((start, end),))
    return average_parts([part], preset.settings, name, progress=progress)


def average_parts(
    parts: Sequence[SoundPart], settings: AnalysisSettings, name: str, *, progress: Progress = no_progress
) -> AveragedSpectrum:
    """Return the averaged spectrum of parts of sound files.

    It ends at half the lowest sample rate of the files, above which some hold nothing.

    Parameters
    ----------
    parts : what is averaged; of a single span the nearest frame counts where no frame's middle lies in it.
    settings : the filters.
    name : of the average.
    progress : called with the share that is done, 0..1.

    Raises
    ------
    AudioError : a file cannot be read, or a single span holds nothing of it.
    CurveError : the parts hold no frame.
    Cancelled : `progress` did not want to go on.
    """
    average, highest = SpectrumAverage(), math.inf
    for k, part in enumerate(parts):
        share = subrange(progress, k / len(parts), (k + 1) / len(parts))
        highest = min(highest, _add_part(average, part, settings, share))
    if not average.n_frames:
        raise CurveError(f"{name}: no frame of it was found; choose a longer segment or more recordings")
    curve = average.curve(name, settings.front_end(), _in_words(parts))
    n = int(np.searchsorted(curve.frequencies, highest, "right"))
    assert curve.spread is not None
    return replace(
        curve,
        frequencies=curve.frequencies[:n],
        amplitudes=curve.amplitudes[:n],
        spread=curve.spread[:n],
        parts=tuple(parts),
    )


def measured_again(
    curve: AveragedSpectrum, settings: AnalysisSettings, progress: Progress = no_progress
) -> AveragedSpectrum:
    """Return the average of the same sounds through other filters; name and colour stay.

    Raises
    ------
    CurveError : it is not known which sounds were averaged, or one of them is not there any more.
    AudioError : one of them cannot be read.
    Cancelled : `progress` did not want to go on.
    """
    if not curve.parts:
        raise CurveError(
            f"{curve.name} cannot be measured again, since it does not say of which sound file it is; average the "
            "sound anew"
        )
    try:
        again = average_parts(curve.parts, settings, curve.name, progress=progress)
    except AudioError as error:
        # Looked for only now, since a file may vanish at any moment before it is read.
        gone = next((part.path for part in curve.parts if not part.path.is_file()), None)
        if gone is None:
            raise
        raise CurveError(
            f"{curve.name} cannot be measured again, since {gone.name} is not there any more; put it back, or "
            "average another sound"
        ) from error
    return replace(again, since=curve.since, colour=curve.colour, hidden=curve.hidden)


def whole_file(path: Path, channel: Channel = Channel.MIX) -> SoundPart:
    """Return all of a sound file.

    Raises
    ------
    AudioError : it cannot be read.
    """
    with SoundReader(path, channel) as reader:
        return SoundPart(path, channel, ((0.0, reader.duration),))


def groups_of(
    utterances: Sequence[LabelledUtterance],
    by: Grouping,
    phonemes: Collection[Phoneme] = (),
    speakers: Collection[str] = (),
    vowels: str = "vowels",
) -> Groups:
    """Return what is averaged of labelled recordings: the core frames, by speaker, phoneme or both.

    Parameters
    ----------
    phonemes : those that count; all but silence where there are none.
    speakers : those that count, by `speaker_names`; all where there are none.
    vowels : what the name of a group calls all vowels.
    """
    names, found = speaker_names(utterances), defaultdict(list)
    few = "" if len(phonemes) > MOST_LISTED else " ".join(sorted(p.label for p in phonemes))
    of = f" ({vowels if {*phonemes} == {*VOWELS} else few})" if few else ""
    for utterance in utterances:
        speaker, spans = names[utterance.voice], defaultdict(list)
        if speakers and speaker not in speakers:
            continue
        for label in utterance.labels:
            wanted = label.phoneme in phonemes if phonemes else label.phoneme is not Phoneme.SILENCE
            if wanted and label.certainty == CORE:
                spans[_group_name(speaker, label.phoneme, by, of)].append((label.start, label.end))
        for name, own in spans.items():
            found[name].append(SoundPart(utterance.path, utterance.channel, tuple(own)))
    return {name: tuple(found[name]) for name in sorted(found)}


def speaker_names(utterances: Sequence[LabelledUtterance]) -> dict[str, str]:
    """Return what each speaker is called, by `LabelledUtterance.voice`: the corpus tells apart who shares a name."""
    voices = {utterance.voice: utterance.speaker for utterance in utterances}
    speakers = list(voices.values())
    return {voice: name if speakers.count(name) == 1 else voice for voice, name in voices.items()}


def groups_in(
    folder: Path,
    by: Grouping = Grouping.SPEAKER,
    phonemes: Collection[Phoneme] = (),
    *,
    mapping: PhonemeMap | None = None,
    channel: Channel = Channel.MIX,
    on_skipped: OnSkipped | None = None,
) -> Groups:
    """Return what is averaged of the recordings in a folder; see `groups_of` and `read_recordings`.

    Recordings without any labels count whole, by speaker, which is the folder that they lie in. `on_skipped` is
    called for each sound that cannot be read, which is then left out; None refuses it.

    Raises
    ------
    CorpusError : there is no sound, or none with labels where phonemes are asked for.
    AudioError : a sound cannot be read.
    """
    sounds = sounds_under(folder) if folder.is_dir() else []
    if sounds and by is Grouping.SPEAKER and not phonemes and not is_labelled(folder):
        found = defaultdict(list)
        for sound in sounds:
            try:
                found[sound.parent.absolute().name].append(whole_file(sound, channel))
            except AudioError as error:
                if on_skipped is None:
                    raise
                on_skipped(error)
        return {name: tuple(found[name]) for name in sorted(found)}
    groups = groups_of(read_recordings(folder, mapping, channel=channel, on_skipped=on_skipped), by, phonemes)
    if not groups:
        raise CorpusError(f"{folder.name}: nothing in its labels is one of the phonemes; choose others")
    return groups


def _group_name(speaker: str, phoneme: Phoneme, by: Grouping, of: str) -> str:
    if by is Grouping.PHONEME:
        return phoneme.label
    if by is Grouping.SPEAKER_PHONEME:
        return f"{speaker} {phoneme.label}"
    return speaker + of


def _add_part(average: SpectrumAverage, part: SoundPart, settings: AnalysisSettings, progress: Progress) -> float:
    """Take the frames of a part into an average; return half the sample rate of its file, Hz."""
    with SoundReader(part.path, part.channel) as reader:
        wanted = _frames_in(part, tracks_of(reader).n_frames)
        places = np.flatnonzero(wanted)
        if len(places):
            first, last = int(places[0]), int(places[-1]) + 1
            # spectra need no recogniser, so the quickest one is asked
            for analysis in analyse_range(reader, first, last, Preset(settings=settings)):
                chosen = wanted[analysis.start : analysis.start + len(analysis)]
                average.add(analysis.linear_spectra[chosen], analysis.frames.windows[chosen])
                report_progress(progress, (analysis.start + len(analysis) - first) / (last - first))
        return reader.file_rate / 2


def _frames_in(part: SoundPart, n_frames: int) -> BoolArray:
    """Return the frames whose middles lie in spans, shape (n_frames,)."""
    wanted = np.zeros(n_frames, bool)
    if len(part.spans) == 1:
        try:
            wanted[slice(*frames_between(*part.spans[0], n_frames))] = True
        except AudioError as error:
            raise AudioError(f"{printable_name(part.path)}: {error}") from error
    else:
        middles = (np.arange(n_frames) + 0.5) * FRAME_PERIOD
        for start, end in part.spans:
            wanted[slice(*np.searchsorted(middles, (start, end)))] = True
    return wanted


def _in_words(parts: Sequence[SoundPart]) -> str:
    if len(parts) > 1:
        return f"{len(parts)} sounds"
    (part,) = parts
    if len(part.spans) > 1:
        return f"{len(part.spans)} segments of {part.path.name}"
    start, end = part.spans[0]
    return f"{start:.2f} to {end:.2f} s of {part.path.name}"
