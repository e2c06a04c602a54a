"""What is averaged of files, speakers and phonemes, and through which filters."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import soundfile

from phonemeengine.errors import AudioError, CorpusError, CurveError
from phonemeengine.execution import Cancelled
from phonemeengine.inspection.averaged_spectrum import AveragedSpectrum, SoundPart, distance_of
from phonemeengine.inspection.speaker_spectra import (
    VOWELS,
    Grouping,
    average_parts,
    groups_in,
    groups_of,
    measured_again,
    speaker_names,
    whole_file,
)
from phonemeengine.labels.utterance import Label
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import BIN_WIDTH, SAMPLE_RATE, AnalysisSettings, Channel, Decimation, Filter
from tests.labelled import recording, recordings
from tests.sounds import tone

FINE = AnalysisSettings(filters=frozenset())
COARSE = AnalysisSettings(filters=frozenset({Filter.QUANTISE}), decimation=Decimation.ANTI_ALIASED)
LOW, HIGH = 40 * BIN_WIDTH, 80 * BIN_WIDTH


@pytest.fixture
def two_tones(tmp_path: Path) -> Path:
    """One second of a low tone, one of a high one, and the low one again."""
    parts = [tone(hertz, 1.0, 0.5) for hertz in (LOW, HIGH, LOW)]
    soundfile.write(tmp_path / "tones.wav", np.concatenate(parts), SAMPLE_RATE, subtype="FLOAT")
    return tmp_path / "tones.wav"


def peak_of(curve: AveragedSpectrum) -> float:
    return float(curve.frequencies[curve.amplitudes.argmax()])


def test_segments_that_lie_apart_are_averaged_together(two_tones: Path) -> None:
    low = SoundPart(two_tones, Channel.MIX, ((0.1, 0.9), (2.1, 2.9)))
    curve = average_parts([low], FINE, "low")
    assert curve.n_frames == 160
    assert peak_of(curve) == pytest.approx(LOW)
    assert curve.amplitudes.max() == pytest.approx(0.5, rel=0.01)
    assert curve.spread is not None
    assert curve.spread[40] == pytest.approx(0, abs=0.1)
    assert curve.level == pytest.approx(20 * np.log10(0.5 / np.sqrt(2)), abs=0.1)
    assert (curve.since, curve.parts) == ("2 segments of tones.wav", (low,))
    assert peak_of(average_parts([SoundPart(two_tones, Channel.MIX, ((1.1, 1.9),))], FINE, "high")) == HIGH


def test_several_files_count_by_their_frames(two_tones: Path) -> None:
    parts = [SoundPart(two_tones, Channel.MIX, ((a, b),)) for a, b in ((0.1, 0.9), (1.1, 1.5))]
    curve = average_parts(parts, FINE, "both")
    assert curve.n_frames == 120
    assert curve.amplitudes[40] / curve.amplitudes[80] == pytest.approx(2, rel=0.02)
    assert curve.since == "2 sounds"


def test_a_curve_ends_where_a_file_of_a_lower_rate_holds_nothing(tmp_path: Path, two_tones: Path) -> None:
    soundfile.write(tmp_path / "phone.wav", tone(LOW, 1.0, 0.5)[::4], 11_025, subtype="FLOAT")
    low = average_parts([whole_file(tmp_path / "phone.wav")], FINE, "phone")
    assert low.frequencies[-1] <= 11_025 / 2 < low.frequencies[-1] + BIN_WIDTH
    assert low.spread is not None
    assert len(low.frequencies) == len(low.amplitudes) == len(low.spread)
    full = average_parts([SoundPart(two_tones, Channel.MIX, ((0.0, 1.0),))], FINE, "full")
    assert np.isfinite(distance_of(low, full))


@pytest.mark.parametrize("span", [(5.0, 6.0), (1.0, 1.0), (2.0, 1.0)])
def test_an_empty_selection_is_refused(two_tones: Path, span: tuple[float, float]) -> None:
    with pytest.raises(AudioError, match="there is no sound from"):
        average_parts([SoundPart(two_tones, Channel.MIX, (span,))], FINE, "nothing")
    with pytest.raises(CurveError, match=r"^nothing: no frame of it was found"):
        average_parts([SoundPart(two_tones, Channel.MIX, ((9.0, 9.5), span))], FINE, "nothing")


def test_averaging_can_be_stopped(two_tones: Path) -> None:
    with pytest.raises(Cancelled):
        average_parts([whole_file(two_tones)], FINE, "all", progress=lambda _share: False)


# -- the same sound through other filters ---------------------------------------------------------------------


def test_a_curve_is_measured_again_through_other_filters(two_tones: Path) -> None:
    part = SoundPart(two_tones, Channel.MIX, ((0.1, 0.9),))
    fine = replace(average_parts([part], FINE, "a"), name="mine", colour="#3fb950", hidden=True)
    again, coarse = measured_again(fine, COARSE), average_parts([part], COARSE, "a")
    assert again.is_same(coarse)
    assert (again.name, again.colour, again.hidden) == ("mine", "#3fb950", True)


def test_without_its_sound_a_curve_is_not_measured_again(two_tones: Path) -> None:
    curve = average_parts([whole_file(two_tones)], FINE, "a")
    with pytest.raises(CurveError, match="a cannot be measured again, since it does not say of which sound file"):
        measured_again(replace(curve, parts=()), COARSE)
    two_tones.unlink()
    with pytest.raises(CurveError, match=r"a cannot be measured again, since tones\.wav is not there any more"):
        measured_again(curve, COARSE)


# -- speakers and phonemes ------------------------------------------------------------------------------------


def test_vowels_of_speakers_are_those_that_their_labels_name(tmp_path: Path) -> None:
    utterances = recordings(tmp_path)
    groups = groups_of(utterances, Grouping.SPEAKER, VOWELS)
    assert list(groups) == ["ada (vowels)", "bob (vowels)"]
    assert [len(parts) for parts in groups.values()] == [2, 2]
    of_ada = [label for u in utterances if u.speaker == "ada" for label in u.labels if label.phoneme in VOWELS]
    spans = [span for part in groups["ada (vowels)"] for span in part.spans]
    assert spans == [(label.start, label.end) for label in of_ada]


def test_all_sounds_of_a_speaker_are_those_that_are_not_silence(tmp_path: Path) -> None:
    utterances = recordings(tmp_path)
    groups = groups_of(utterances, Grouping.SPEAKER, speakers=["bob"])
    assert list(groups) == ["bob"]
    said = [label for u in utterances if u.speaker == "bob" for label in u.labels]
    n = sum(label.phoneme is not Phoneme.SILENCE for label in said)
    assert sum(len(part.spans) for part in groups["bob"]) == n


def test_each_phoneme_and_each_of_a_speaker_has_a_curve_of_its_own(tmp_path: Path) -> None:
    utterances = recordings(tmp_path)
    assert list(groups_of(utterances, Grouping.PHONEME, [Phoneme.A, Phoneme.SZ])) == ["a", "sz"]
    of_both = groups_of(utterances, Grouping.SPEAKER_PHONEME, [Phoneme.A, Phoneme.SZ])
    assert list(of_both) == ["ada a", "ada sz", "bob a", "bob sz"]


def test_ambiguous_labels_do_not_count(tmp_path: Path) -> None:
    made = recording(tmp_path / "a.wav", [Phoneme.A, Phoneme.I])
    labels = (replace(made.labels[0], certainty="ambiguous"), Label(0.3, 0.6, "i", Phoneme.I))
    groups = groups_of([replace(made, labels=labels)], Grouping.PHONEME)
    assert list(groups) == ["i"]


def test_speakers_who_share_a_name_are_told_apart_by_their_corpus(tmp_path: Path) -> None:
    one = recording(tmp_path / "a.wav", [Phoneme.A])
    other = replace(one, corpus="other")
    assert speaker_names([one, other]) == {"made/ada": "made/ada", "other/ada": "other/ada"}
    assert speaker_names([one, replace(other, speaker="bob")]) == {"made/ada": "ada", "other/bob": "bob"}


def test_an_a_of_one_speaker_differs_from_an_i_more_than_from_an_a(tmp_path: Path) -> None:
    groups = groups_of(recordings(tmp_path), Grouping.SPEAKER_PHONEME, [Phoneme.A, Phoneme.I])
    curves = {name: average_parts(parts, COARSE, name) for name, parts in groups.items()}
    assert distance_of(curves["ada a"], curves["bob a"]) < distance_of(curves["ada a"], curves["ada i"])


def test_a_folder_without_labels_is_averaged_by_the_folders_in_it(tmp_path: Path) -> None:
    for name in ("ada", "bob"):
        (tmp_path / name).mkdir()
        soundfile.write(tmp_path / name / "a.wav", tone(LOW, 0.5, 0.5), SAMPLE_RATE)
    groups = groups_in(tmp_path)
    assert list(groups) == ["ada", "bob"]
    assert groups["ada"] == (SoundPart(tmp_path / "ada" / "a.wav", Channel.MIX, ((0.0, 0.5),)),)
    with pytest.raises(CorpusError, match="no labelled sound was found here"):
        groups_in(tmp_path, phonemes=VOWELS)


def test_a_folder_without_sounds_or_without_the_phoneme_is_refused(tmp_path: Path) -> None:
    with pytest.raises(CorpusError, match="no labelled sound was found here"):
        groups_in(tmp_path)
    recording(tmp_path / "a.wav", [Phoneme.A])
    (tmp_path / "a.csv").write_text("start_s,end_s,phone,class,certainty\n0,0.3,a,a,core\n")
    with pytest.raises(CorpusError, match="nothing in its labels is one of the phonemes"):
        groups_in(tmp_path, phonemes=[Phoneme.U])
