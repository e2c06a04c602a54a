"""Recognisers of other packages: found without being imported, asked like the program's own, and never believed."""

import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from phonemeengine.analyser import Analyser
from phonemeengine.errors import EngineError, PresetError, RecogniserError
from phonemeengine.features.variables import Features
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import load_preset, save_preset
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.rules import CONDITIONS, ThesisRules, Thresholds
from phonemeengine.recognition.spec import BUILT_IN, RecogniserConfig, recogniser_names, recogniser_of
from phonemeengine.settings import HOP, WINDOW, Filter
from tests.fakes.plug_ins import Shelf, environment_with
from tests.sounds import silence, tone

OPENS_AT_A_TENTH = Thresholds(silence_energy=0.1)
COURSE = (0.05, 0.2, 0.07, 0.04, 0.07, 0.3, 0.06)
A, S = Phoneme.A, Phoneme.SILENCE
UNHEARD = np.zeros((8, WINDOW), np.float32)
"""Windows for recognisers that do not listen to them."""
LISTED = """
import sys
from phonemeengine.recognition.spec import recogniser_names
print(*recogniser_names(), "phonemeanalyser_loudness" in sys.modules)
"""


def energies(*values: float) -> Features:
    return Features(("energy",), np.array(values, np.float32).reshape(-1, 1))


def made_and_asked(name: str, thresholds: Thresholds) -> None:
    recogniser = recogniser_of(name, RecogniserConfig(thresholds))
    recogniser.recognise(UNHEARD[:3], energies(0, 0, 0))
    assert recogniser.used_thresholds is not None


def refusal(name: str = "own", thresholds: Thresholds = OPENS_AT_A_TENTH) -> str:
    """Ask a plug-in for three frames and for a reason, and give the one sentence with which it is refused."""
    with pytest.raises(RecogniserError) as caught:
        made_and_asked(name, thresholds)
    told = str(caught.value)
    assert told.isprintable()
    return told


# -- the example, installed with pip ------------------------------------------------------------------------


def test_an_installed_recogniser_is_listed_but_not_imported(example_site: Path):
    done = subprocess.run(
        [sys.executable, "-c", LISTED],
        env=environment_with(example_site),
        capture_output=True,
        text=True,
        timeout=240,
        check=True,
    )
    assert done.stdout.split() == [*BUILT_IN, "brightness", "loudness", "False"]


def test_without_plug_ins_there_are_the_programs_own():
    assert recogniser_names() == tuple(BUILT_IN)
    assert recogniser_names()[0] == "thesis"


@pytest.mark.parametrize("cut", range(len(COURSE) + 1))
def test_the_example_opens_at_its_threshold_and_stays_open_to_half_of_it(cut: int, loudness: Path):
    recogniser = recogniser_of("loudness", RecogniserConfig(OPENS_AT_A_TENTH))
    parts = [
        recogniser.recognise(UNHEARD[: len(part)], energies(*part)).phonemes for part in (COURSE[:cut], COURSE[cut:])
    ]
    assert np.concatenate(parts).tolist() == [S, A, A, S, S, A, A]


def test_the_example_says_why_with_both_its_limits(loudness: Path):
    trace = recogniser_of("loudness", RecogniserConfig(OPENS_AT_A_TENTH)).explain(energies(0.0, 0.25), 1)
    assert (trace.phoneme, trace.rule) == (A, "opens")
    assert [c.limit for c in trace.comparisons] == pytest.approx([0.1, 0.05])
    assert [c.margin for c in trace.comparisons] == pytest.approx([0.15, 0.2])


def test_an_analysis_with_the_example_hears_a_tone_between_silences(loudness: Path):
    settings = replace(Preset().settings, statistics=False)
    analyser = Analyser(Preset(recogniser="loudness", settings=settings))
    sound = np.concatenate((silence(0.3), tone(1000, 0.3, 0.5), silence(0.3)))
    phonemes = np.concatenate((analyser.push(sound).phonemes, analyser.finish().phonemes))
    assert set(phonemes[:25]) == {S}
    assert set(phonemes[30:55]) == {A}
    assert set(phonemes[65:]) == {S}


def test_another_filter_leaves_a_recogniser_its_memory_and_another_threshold_does_not(loudness: Path):
    preset = Preset(recogniser="loudness", thresholds=OPENS_AT_A_TENTH)
    analyser = Analyser(preset)
    before = analyser.recogniser
    settings = replace(preset.settings, filters=preset.settings.filters - {Filter.HIGH_PASS})
    analyser.set_preset(replace(preset, settings=settings))
    assert analyser.recogniser is before
    analyser.set_preset(replace(preset, thresholds=Thresholds(silence_energy=0.2)))
    assert analyser.recogniser is not before


def test_a_recogniser_says_which_thresholds_it_uses(loudness: Path, shelf: Shelf):
    shelf.offer("class Own(Plain):\n    used_thresholds = ('sz_s1', 'unheard_of')")
    assert recogniser_of("loudness", RecogniserConfig(OPENS_AT_A_TENTH)).used_thresholds == {"silence_energy"}
    assert recogniser_of("own", RecogniserConfig(OPENS_AT_A_TENTH)).used_thresholds == {"sz_s1"}
    assert ThesisRules(Thresholds()).used_thresholds == {c.threshold for c in CONDITIONS}


# -- names --------------------------------------------------------------------------------------------------


def test_a_plug_in_cannot_take_the_name_of_the_thesis(shelf: Shelf):
    shelf.offer("", name="thesis")
    assert recogniser_names() == tuple(BUILT_IN)
    assert isinstance(recogniser_of("thesis", RecogniserConfig(Thresholds())), ThesisRules)


def test_two_packages_that_offer_one_name_are_refused_with_both(shelf: Shelf):
    shelf.offer("", package="one-package")
    shelf.offer("", package="other-package")
    assert recogniser_names() == (*BUILT_IN, "own")
    with pytest.raises(RecogniserError, match="'own' is offered twice, by one-package and other-package; uninstall"):
        recogniser_of("own", RecogniserConfig(Thresholds()))


def test_a_preset_of_a_plug_in_that_is_not_installed_is_refused(shelf: Shelf, tmp_path: Path):
    path = tmp_path / "mine.toml"
    with pytest.MonkeyPatch.context() as here:
        Shelf(tmp_path, here).offer("")
        save_preset(Preset(recogniser="own"), path)
        assert load_preset(path).recogniser == "own"
    with pytest.raises(PresetError, match=r"mine.toml: there is no recogniser named 'own'.*install the package"):
        load_preset(path)


# -- what is wrong with a plug-in ---------------------------------------------------------------------------

BROKEN = {
    "an import that fails": ("import nowhere_at_all\nOwn = 1", "cannot be imported (ModuleNotFoundError: No module"),
    "an import that exits": ("raise SystemExit('Own licence')", "cannot be imported (SystemExit: Own licence)"),
    "nothing to call": ("Own = 5", "cannot be made (TypeError: 'int' object is not callable)"),
    "a factory that fails": (
        "def Own(thresholds):\n    raise OSError(2, 'no\\n\\x1bmodel')",
        "cannot be made (FileNotFoundError: [Errno 2] no model)",
    ),
    "thresholds that are none": ("class Own(Plain):\n    used_thresholds = 5", "cannot name its thresholds ("),
    "a recogniser that fails": (
        "class Own(Plain):\n    def recognise(self, windows, features):\n        raise ValueError()",
        "cannot recognise (ValueError)",
    ),
    "a long complaint": (
        "class Own(Plain):\n    def recognise(self, windows, features):\n        raise ValueError('x' * 5000)",
        "xxx…)",
    ),
    "nothing to recognise with": ("class Own:\n    def __init__(self, thresholds): pass", "cannot recognise (A"),
}
WRONG_CODES = {
    "np.zeros(2, np.uint8)": "gave uint8, shape (2,) where codes of uint8, shape (3,), are wanted",
    "np.zeros((3, 1), np.uint8)": "gave uint8, shape (3, 1) where codes of uint8, shape (3,), are wanted",
    "np.zeros(3)": "gave float64, shape (3,) where codes of uint8, shape (3,), are wanted",
    "[0, 0, 0]": "gave a list where codes of uint8, shape (3,), are wanted",
    "None": "gave a NoneType where codes of uint8, shape (3,), are wanted",
    "np.array([0, 11, 200], np.uint8)": "gave the code 200, and phonemes are 0..10",
}
WRONG_TRACES = {
    "None": "AttributeError",
    "Trace(Phoneme.A, 'rule', 5)": "TypeError",
    "Trace(77, 'rule', ())": "ValueError: 77 is not a valid Phoneme",
    "Trace(Phoneme.A, 'r', (RuleComparison('r', 'x', 'much', '<', 'y', 1, 1),))": "ValueError: could not convert",
    "1 / 0": "ZeroDivisionError",
}


@pytest.mark.parametrize(("source", "what"), BROKEN.values(), ids=BROKEN.keys())
def test_a_broken_plug_in_is_one_sentence_with_its_name_and_package(source: str, what: str, shelf: Shelf):
    shelf.offer(source)
    told = refusal()
    assert told.startswith("the recogniser 'own' of the package own-package ")
    assert what in told
    assert told.endswith("; choose another recogniser")
    assert len(told) < 300


@pytest.mark.parametrize(("codes", "what"), WRONG_CODES.items())
def test_codes_that_are_no_phonemes_of_the_frames_are_refused(codes: str, what: str, shelf: Shelf):
    shelf.offer(f"class Own(Plain):\n    def recognise(self, windows, features):\n        return {codes}")
    assert refusal() == f"the recogniser 'own' of the package own-package {what}; choose another recogniser"


@pytest.mark.parametrize(("trace", "what"), WRONG_TRACES.items())
def test_a_reason_that_cannot_be_shown_is_refused(trace: str, what: str, shelf: Shelf):
    shelf.offer(f"class Own(Plain):\n    def explain(self, features, k):\n        return {trace}")
    with pytest.raises(RecogniserError) as caught:
        recogniser_of("own", RecogniserConfig(Thresholds())).explain(energies(1.0), 0)
    assert str(caught.value).startswith(f"the recogniser 'own' of the package own-package cannot say why ({what}")


def test_a_plug_in_cannot_change_what_was_measured(shelf: Shelf):
    shelf.offer("class Own(Plain):\n    def recognise(self, windows, features):\n        features.values[:] = 0")
    features = energies(1.0, 2.0, 3.0)
    with pytest.raises(RecogniserError, match="read-only"):
        recogniser_of("own", RecogniserConfig(Thresholds())).recognise(UNHEARD[:3], features)
    assert features["energy"].tolist() == [1, 2, 3]
    assert features.values.flags.writeable


def test_a_plug_in_that_writes_into_one_array_again_and_again_does_not_change_the_past(shelf: Shelf):
    shelf.offer(
        "class Own(Plain):\n    codes = np.zeros(2, np.uint8)\n"
        "    def recognise(self, windows, features):\n        self.codes += 1\n        return self.codes"
    )
    recogniser = recogniser_of("own", RecogniserConfig(Thresholds()))
    first = recogniser.recognise(UNHEARD[:2], energies(1, 1)).phonemes
    assert recogniser.recognise(UNHEARD[:2], energies(1, 1)).phonemes.tolist() == [2, 2]
    assert first.tolist() == [1, 1]


def test_an_analyser_goes_on_with_the_old_recogniser_where_the_new_one_cannot_be_imported(shelf: Shelf):
    shelf.offer("import nowhere_at_all\nOwn = 1")
    analyser = Analyser(Preset())
    for _ in range(2):
        with pytest.raises(EngineError, match="nowhere_at_all"):
            analyser.set_preset(Preset(recogniser="own"))
    assert analyser.preset.recogniser == "thesis"
    assert set(analyser.push(np.zeros(10 * HOP, np.float32)).recognised) == {S}
