"""A sound that is analysed already, and recognised anew while a threshold is dragged: without the sound, at once."""

import numpy as np

from phonemeengine.analyser import BLOCK, sure_of
from phonemeengine.calibration.workbench.retuner import Retuner, front_end_key, names_of, recogniser_key, rules_in
from phonemeengine.features.measure import Features
from phonemeengine.features.variables import SCORES
from phonemeengine.inspection.whole_sound import FrameState, SoundTracks
from phonemeengine.presets.ears import for_files
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.intensity import intensities_of
from phonemeengine.recognition.scores import Sensitivity


class RetunedSound:
    """Recognises a sound anew with presets of the same front end, as `analyse_whole` would.

    Parameters
    ----------
    tracks : of the sound, all of it known.
    preset : with which it was analysed.
    """

    def __init__(self, tracks: SoundTracks, preset: Preset) -> None:
        self._tracks = tracks
        self._key = _key_of(preset)
        scores = _scores_in(tracks)
        if scores is not None:  # what they were before the sensitivities
            less = {phoneme: -value for phoneme, value in preset.sensitivities.items()}
            scores = Sensitivity(less).apply(scores.T).T
        values = {name: tracks.columns[tracks.names.index(name)] for name in names_of(preset)}
        self._retuner = Retuner(values, tracks.recognised.copy(), scores, np.array([0, tracks.n_frames]))

    def retune(self, preset: Preset) -> bool:
        """Write into the tracks what another preset says; says whether that can be known without the sound."""
        if _key_of(preset) != self._key:
            return False
        tracks, settings = self._tracks, preset.settings
        tracks.recognised[:], codes = self._retuner.recognise(preset)
        scores = self._retuner.scores(preset)
        tracks.phonemes[:] = codes
        levels = tracks.columns[tracks.names.index("volume")]
        tracks.intensities[:] = intensities_of(levels, settings.intensity_low, settings.intensity_high)
        tracks.intensities[codes == 0] = 0
        rules = rules_in(preset)
        if rules is None and scores is not None:
            first = tracks.names.index(SCORES[0])
            tracks.columns[first : first + len(SCORES)] = scores
            tracks.confidences[:] = sure_of(for_files(preset), codes, scores.T, None)
        else:
            tracks.confidences[:] = np.nan
        if rules is not None and preset.is_measured:
            for first in range(0, len(codes), BLOCK):
                part = slice(first, first + BLOCK)
                deficits = rules.deficits(Features(tracks.names, tracks.columns[:, part].T))
                tracks.confidences[part] = sure_of(preset, codes[part], None, deficits)
        tracks.states[:] = FrameState.KNOWN
        tracks.revision += 1
        return True


def _key_of(preset: Preset) -> object:
    """Return all that must be equal for answers to be known without the sound."""
    by_rules = rules_in(preset) is not None
    return front_end_key(preset), preset.file_ear, preset.ear, None if by_rules else recogniser_key(preset)


def _scores_in(tracks: SoundTracks) -> np.ndarray | None:
    if SCORES[0] not in tracks.names:
        return None
    first = tracks.names.index(SCORES[0])
    return tracks.columns[first : first + len(SCORES)].copy()
