"""The table of the 21 numbers: what each divides, how far its variable reaches on both sides, and fits of one."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from phonemeengine.calibration.fits.fitting import fit_number
from phonemeengine.calibration.workbench.labelled_features import LabelledFeatures
from phonemeengine.calibration.workbench.phoneme_data_table import (
    NUMBER_COLUMNS,
    number_rows,
    number_table,
    sounds_divided,
)
from phonemeengine.errors import CorpusError
from phonemeengine.execution import Cancelled
from phonemeengine.labels.utterance import Label
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.controls import CONDITION_OF, with_number
from phonemeengine.presets.files import FACTORY, load_preset
from phonemeengine.recognition.rules import LAYOUT
from tests.labelled import recording, recordings

THESIS = load_preset(FACTORY / "thesis.toml")
REST = "p a e u o i m"


@pytest.fixture(scope="module")
def bench(tmp_path_factory: pytest.TempPathFactory) -> LabelledFeatures:
    return LabelledFeatures(recordings(tmp_path_factory.mktemp("recordings")), THESIS)


@pytest.mark.parametrize(
    ("name", "holds", "fails"),
    [
        ("silence_energy", "silence", f"sz sch {REST}"),
        ("szsch_szsch1", "sz sch", REST),
        ("sz_s1", "sz", "sch"),
        ("p_p2", "p", "a e u o i m"),
        ("ae_ae1", "a e", "u o i m"),
        ("a_a1", "a", "e"),
        ("ouim_ae1", "u o i m", "a e"),
        ("u_o1", "u", "o i m"),
        ("o_o1", "o", "i m"),
        ("i_o1", "i", "m"),
    ],
)
def test_each_number_divides_the_sounds_that_the_thesis_divides_with_it(name: str, holds: str, fails: str) -> None:
    found = sounds_divided(CONDITION_OF[name])
    assert [" ".join(p.label for p in side) for side in found] == [holds, fails]


def test_the_table_tells_how_far_a_variable_reaches_on_both_sides_for_each_speaker(bench: LabelledFeatures) -> None:
    rows = {row.name: row for row in number_rows(bench)}
    assert list(rows) == [name for line in LAYOUT for name in line]
    speakers = list(dict.fromkeys(u.speaker for u in bench.utterances))
    assert list(rows["a_a1"].by_speaker) == ["all", *speakers]
    values, labels = bench.values("m_a1"), bench.labels
    of_first = np.repeat([u.speaker == speakers[0] for u in bench.utterances], np.diff(bench.edges))
    for side, phoneme in (("holds", Phoneme.A), ("fails", Phoneme.E)):
        wanted = values[labels.certain & (labels.phonemes == phoneme) & of_first]
        found = getattr(rows["a_a1"].by_speaker[speakers[0]], side)
        assert (found.n, found.least, found.greatest) == (len(wanted), wanted.min(), wanted.max())
        assert found.mean == pytest.approx(wanted.mean())
    assert rows["time_smooth"].by_speaker == {}
    assert (rows["a_a1"].variable, rows["a_a1"].sign) == ("m_a1", "<")


def test_sounds_that_nobody_says_have_no_values(tmp_path: Path) -> None:
    one = LabelledFeatures([recording(tmp_path / "a.wav", (Phoneme.A,))], THESIS)
    rows = {row.name: row for row in number_rows(one)}
    (sides,) = rows["a_a1"].by_speaker.values()
    assert sides.holds is not None
    assert sides.fails is None
    lines = list(number_table(tuple(rows.values()), THESIS.phoneme_data))
    assert {len(line) for line in lines} == {len(NUMBER_COLUMNS)}
    (without,) = [line for line in lines if line[0] == "a_a1" and line[6] == "fails"]
    assert without[7:] == ("e", "0", "", "", "")
    assert [row.name for row in number_rows(None)] == list(rows)


def test_one_number_is_fitted_and_all_others_stay(bench: LabelledFeatures) -> None:
    spoilt = with_number(THESIS, "silence_energy", 0.0)
    found, score = fit_number(bench, spoilt, "silence_energy")
    assert score == bench.confusion(found).agreement.macro_f1 > bench.confusion(spoilt).agreement.macro_f1
    assert with_number(found, "silence_energy", 0.0) == spoilt


def test_a_number_of_a_filter_is_fitted_by_measuring_anew(bench: LabelledFeatures) -> None:
    spoilt = with_number(THESIS, "time_smooth", 0.99)
    found, score = fit_number(LabelledFeatures(bench.utterances, spoilt), spoilt, "time_smooth")
    assert found.settings.time_smooth < 0.99
    assert score == LabelledFeatures(bench.utterances, found).confusion(found).agreement.macro_f1
    assert with_number(found, "time_smooth", 0.99) == spoilt


def test_what_cannot_be_fitted_is_refused_in_a_sentence(tmp_path: Path, bench: LabelledFeatures) -> None:
    with pytest.raises(CorpusError, match="has no thresholds to fit"):
        fit_number(bench, load_preset("templates"), "a_a1")
    unknown = replace(recording(tmp_path / "a.wav"), labels=(Label(0.0, 1.0, "x", Phoneme.UNIDENTIFIED),))
    with pytest.raises(CorpusError, match="nothing to fit to"):
        fit_number(LabelledFeatures([unknown], THESIS), THESIS, "a_a1")
    with pytest.raises(Cancelled):
        fit_number(bench, THESIS, "frequency_smooth", lambda _share: False)


def test_with_one_class_only_a_number_stays_or_gains(tmp_path: Path) -> None:
    one = LabelledFeatures([recording(tmp_path / "a.wav", (Phoneme.A,))], THESIS)
    found, score = fit_number(one, THESIS, "a_a1")
    assert score >= one.confusion(THESIS).agreement.macro_f1
    assert with_number(found, "a_a1", THESIS.thresholds.a_a1) == THESIS
