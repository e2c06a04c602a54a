"""Rules found in labelled recordings: few, readable, and judged on what they were not grown from."""

from pathlib import Path

import numpy as np
import pytest

from phonemeengine.calibration.fits.rule_finding import candidates, rules_from
from phonemeengine.calibration.fits.rule_search import conditions_in
from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.calibration.workbench.labelled_features import LabelledFeatures
from phonemeengine.errors import CorpusError
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import FACTORY, load_preset, save_preset
from tests.labelled import recording, recordings

THESIS = load_preset(FACTORY / "thesis.toml")


@pytest.fixture(scope="module")
def utterances(tmp_path_factory: pytest.TempPathFactory) -> tuple[LabelledUtterance, ...]:
    return recordings(tmp_path_factory.mktemp("recordings"))


def test_rules_over_bands_are_few_and_hold_for_a_speaker_who_was_held_out(utterances, tmp_path):
    shares: list[float] = []
    report = rules_from(utterances, THESIS, lambda share: shares.append(share) or True)
    anew = LabelledFeatures(utterances, report.preset)
    assert anew.confusion(report.preset).scores().macro_f1 == pytest.approx(report.after.macro_f1)
    assert report.left_out == "speaker"
    assert report.before.macro_f1 < 0.8 < report.held_out.macro_f1 <= report.after.macro_f1
    assert 0 < conditions_in(report.preset.rules) <= 40
    used = {c.variable for rule in report.preset.rules for c in rule.conditions}
    bands = {v.name for v in candidates()}
    divisors = {v.per for v in report.preset.variables if v.name in used}
    assert {v.name for v in report.preset.variables} == (used | divisors) & bands
    assert shares == sorted(shares)
    assert shares[-1] == 1
    save_preset(report.preset, tmp_path / "found.toml")
    assert load_preset(tmp_path / "found.toml").rules == report.preset.rules


def test_rules_over_what_the_preset_measures_keep_its_front_end(utterances):
    report = rules_from(utterances, THESIS, bands=False, most_conditions=6)
    assert report.preset.settings.filters == THESIS.settings.filters
    assert report.preset.variables == THESIS.variables
    assert conditions_in(report.preset.rules) <= 6
    assert report.after.macro_f1 > report.before.macro_f1


def test_takes_are_held_out_where_one_speaks_and_parts_where_there_is_one_recording(utterances):
    ada = [u for u in utterances if u.speaker == "ada"]
    assert rules_from(ada, THESIS, bands=False).left_out == "take"
    alone = rules_from(ada[:1], THESIS, bands=False)
    assert alone.left_out == "part"
    assert np.isfinite(alone.held_out.macro_f1)


def test_one_sound_is_nothing_to_divide(tmp_path: Path):
    only = recording(tmp_path / "a.wav", [Phoneme.A])
    with pytest.raises(CorpusError, match=r"rules need labels .* only a; load some with others"):
        rules_from([only], THESIS, bands=False)
