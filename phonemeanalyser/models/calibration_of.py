"""What a voice's takes make of a preset: the one place that knows how each recogniser learns a voice."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

from engine.calibration.adaptation import adapt
from engine.calibration.bench.workbench import Workbench
from engine.calibration.fits.fitting import fit_preset
from engine.calibration.fits.templates_of import templates_of
from engine.calibration.heed import Heed, go_on, part_of, tell
from engine.calibration.learning.lessons import Lesson, lesson_of_recording
from engine.calibration.scores.corpus import Utterance
from engine.calibration.scores.scoring import Scores
from engine.calibration.takes.room_noise import RoomNoise
from engine.errors import CorpusError, PresetError
from engine.presets.preset import Preset

Takes = Sequence[Utterance]


@dataclass(frozen=True)
class Outcome:
    """A preset after a calibration, to be accepted or refused.

    Attributes
    ----------
    start : the preset that was calibrated.
    preset : what it became; the same where nothing better was found.
    before, after : the figures of both on the takes.
    """

    start: Preset
    preset: Preset
    before: Scores
    after: Scores

    @property
    def gains(self) -> bool:
        """Whether anything better was found."""
        return self.preset != self.start


def calibration_of(preset: Preset, takes: Takes, room: RoomNoise | None = None, heed: Heed = go_on) -> Preset:
    """Give the preset that knows this voice.

    Parameters
    ----------
    preset : what is calibrated; its recogniser says how.
    takes : labelled recordings of the voice.
    room : what the room sounds like, where that was measured.
    heed : told how far it is.

    Raises
    ------
    CorpusError : the recogniser does not learn voices, or the takes are too few.
    Cancelled : `heed` did not want to go on.
    """
    if preset.recogniser not in CALIBRATIONS:
        raise CorpusError(
            f"the recogniser {preset.recogniser!r} does not learn voices; choose one of {', '.join(CALIBRATIONS)}"
        )
    return CALIBRATIONS[preset.recogniser](preset, takes, room, heed)


def outcome_of(preset: Preset, takes: Takes, room: RoomNoise | None = None, heed: Heed = go_on) -> Outcome:
    """Calibrate a preset, and compare what it was and what it became on the takes.

    Raises
    ------
    CorpusError : as for `calibration_of`, or there are no takes.
    Cancelled : `heed` did not want to go on.
    """
    if not takes:
        raise CorpusError("there is no take to calibrate with; record some first")
    bench = Workbench(takes, preset, heed=part_of(heed, 0.0, 0.1))
    before = bench.confusion(preset).scores()
    found = calibration_of(preset, takes, room, part_of(heed, 0.1, 0.9))
    after = Workbench(takes, found, known=bench, heed=part_of(heed, 0.9, 1.0)).confusion(found).scores()
    if not after.ten_f1 > before.ten_f1:
        return Outcome(preset, preset, before, before)
    return Outcome(preset, found, before, after)


def _with_thresholds(preset: Preset, takes: Takes, room: RoomNoise | None, heed: Heed) -> Preset:
    """Let the room set the silence, and search for the other thresholds, or for the limits of the preset's rules."""
    start = room.thresholds(preset) if room is not None else preset
    bench = Workbench(takes, start, heed=part_of(heed, 0.0, 0.2))
    return fit_preset(bench, start, part_of(heed, 0.2, 1.0), leave_out=False).preset


def _with_model(preset: Preset, takes: Takes, _room: RoomNoise | None, heed: Heed) -> Preset:
    """Adapt the model to the voice."""
    if preset.model is None:
        raise PresetError("this preset has no learned model to adapt; choose the preset learned.toml")
    lessons: list[Lesson] = []
    for k, utterance in enumerate(takes):
        tell(heed, 0.5 * k / len(takes))
        lessons.append(lesson_of_recording(utterance))
    tell(heed, 0.5)
    return replace(preset, model=adapt(preset.model, lessons).model)


def _with_templates(preset: Preset, takes: Takes, _room: RoomNoise | None, heed: Heed) -> Preset:
    """Let the takes be the templates of the sounds that they hold."""
    tell(heed, 0.0)
    return replace(preset, templates=templates_of(takes, preset.templates))


CALIBRATIONS: dict[str, Callable[[Preset, Takes, RoomNoise | None, Heed], Preset]] = {
    "thesis": _with_thresholds,
    "rules": _with_thresholds,
    "learned": _with_model,
    "templates": _with_templates,
}
"""How each recogniser learns a voice."""
