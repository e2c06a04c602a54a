"""Continuous weights of a face by how likely each viseme is: no movement, but all shapes at once, by their shares."""

import numpy as np

from phonemeengine.analyser import Analysis
from phonemeengine.arrays import BoolArray, Float32Array
from phonemeengine.labels.visemes import VisemeSet
from phonemeengine.mouth.table import MouthTable
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.scores import scores_in


class VisemeBlender:
    """Blends the shapes of a mouth table, frame by frame; see `blended_weights`.

    Parameters
    ----------
    table : the shape of each viseme: that of its phone, else of the first phoneme that it may show.
    """

    def __init__(self, table: MouthTable) -> None:
        self._table = table
        self._known: tuple[VisemeSet | None, tuple[Float32Array, BoolArray]] | None = None

    def weights(self, analysis: Analysis) -> Float32Array:
        """Return the weights of the table's movestates, float32, shape (n_frames, n_movestates)."""
        visemes, table = analysis.viseme_set if analysis.viseme_scores is not None else None, self._table
        if self._known is None or self._known[0] is not visemes:  # the same for all frames of a sound
            self._known = visemes, viseme_rows(table, visemes) if visemes else _phoneme_rows(table)
        rows, firm = self._known[1]
        shares = analysis.viseme_scores
        if shares is None:
            scores = scores_in(analysis.features)
            shares = np.eye(len(Phoneme), dtype=np.float32)[analysis.phonemes] if scores is None else scores
        least = table.motion.minimum_opening
        gains = np.float32(least) + np.float32(1 - least) * analysis.intensities[:, None]
        return np.asarray((shares * np.where(firm, np.float32(1), gains)) @ rows, np.float32)


def blended_weights(table: MouthTable, analysis: Analysis) -> Float32Array:
    """Return the weights of a table's movestates, not smoothed, float32, shape (n_frames, n_movestates).

    Each viseme adds its shape by how likely it is, and by the intensity but where lips, teeth or tongue meet. Where
    the recogniser tells no visemes apart, phonemes do so by their scores; with rules, which have none, the phoneme
    alone.

    Parameters
    ----------
    table : the shape of each viseme: that of its phone, else of the first phoneme that it may show.
    analysis : of any frames.
    """
    return VisemeBlender(table).weights(analysis)


def viseme_rows(table: MouthTable, visemes: VisemeSet) -> tuple[Float32Array, BoolArray]:
    """Return the weights of every viseme's shape, shape (n_visemes, n_movestates), and at which of them lips meet."""
    place = {shape: k for k, shape in enumerate(table.shapes)}
    phonemes = [Phoneme(int(code)) for code in visemes.allowed.argmax(axis=0)]
    sounds = [(phoneme, visemes.phones.get(name, "")) for name, phoneme in zip(visemes.names, phonemes, strict=True)]
    rows = table.shape_weights()[[place[table.shape_of(*sound)] for sound in sounds]]
    return rows, np.array([_closes(table, *sound) for sound in sounds])


def _phoneme_rows(table: MouthTable) -> tuple[Float32Array, BoolArray]:
    return table.weights(), np.array([_closes(table, phoneme, "") for phoneme in Phoneme])


def _closes(table: MouthTable, phoneme: Phoneme, phone: str) -> bool:
    return phoneme is Phoneme.SILENCE or table.closes(phoneme, phone)
