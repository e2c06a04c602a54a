"""What specifications say of recognisers is true, and one of another package can do as much."""

import ast
import itertools
import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import phonemeanalyser
import phonemeengine
from phonemeanalyser.cli.main import main
from phonemeengine.analyser import Analyser
from phonemeengine.calibration.calibrate import calibrate
from phonemeengine.calibration.fits.fitting import fit_preset
from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.calibration.scores.evaluation import predict, score
from phonemeengine.calibration.workbench.labelled_features import LabelledFeatures
from phonemeengine.errors import CorpusError, EngineError, RecogniserError
from phonemeengine.execution import Cancelled
from phonemeengine.labels.table import format_table
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.controls import controls_of, unused_settings
from phonemeengine.presets.files import factory_preset, load_preset, save_preset
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.scores import SCORES
from phonemeengine.recognition.spec import BUILT_IN, Tuning, recogniser_of
from phonemeengine.settings import HOP, AnalysisSettings
from tests.fakes.plug_ins import Shelf
from tests.labelled import recording
from tests.sounds import noise, silence, vowel

A, S, SZ = Phoneme.A, Phoneme.SILENCE, Phoneme.SZ
SOUND = np.concatenate((silence(0.2), vowel((750, 1250, 2500), 0.3), noise(0.3, 0.1), silence(0.2)))
SAID = (S, A, SZ, A, S, SZ, A, S)
SCORING = """
from phonemeengine.recognition.scores import Recognition
from phonemeengine.recognition.spec import RecogniserSpec, Tuning

class Scoring(Plain):
    look_ahead = {look_ahead}
    scores = {scores}

    def __init__(self, config):
        pass

    def recognise(self, windows, features):
        return {answer}

Own = RecogniserSpec("own", Scoring, frozenset({tuned_by}), fit={fit!r}, adapt={adapt!r})
"""


@pytest.fixture
def bright(brightness: Path) -> Preset:
    """A preset of the example that looks ahead, with its limit far from where a and s part."""
    plain = AnalysisSettings(minimum_hold=0.02, hysteresis=0.1, look_ahead=0.03)
    return Preset(settings=plain, recogniser="brightness")


@pytest.fixture
def takes(tmp_path: Path) -> tuple[LabelledUtterance, ...]:
    return tuple(recording(tmp_path / f"{k}.wav", SAID, pitch=110.0 + 20 * k) for k in range(3))


def mistuned(preset: Preset) -> Preset:
    return replace(preset, thresholds=replace(preset.thresholds, szsch_szsch1=1000.0))


def offer(shelf: Shelf, **changes: object) -> Preset:
    """Offer a recogniser with a specification, and give a preset of it."""
    plain = {
        "look_ahead": 0,
        "scores": (),
        "answer": "np.zeros(len(windows), np.uint8)",
        "tuned_by": [],
        "fit": "",
        "adapt": "",
    }
    shelf.offer(SCORING.format(**{**plain, **changes}))
    return Preset(recogniser="own")


def analysed(preset: Preset, cuts: list[int]) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Push the sound in pieces; gives what was recognised, what is shown, and the scores."""
    analyser = Analyser(preset)
    edges = [0, *sorted(cuts), len(SOUND)]
    parts = [analyser.push(SOUND[a:b]) for a, b in itertools.pairwise(edges)]
    parts.append(analyser.finish())
    scores = [p.features.values[:, p.features.names.index(SCORES[0]) :] for p in parts if len(p)]
    return (
        np.concatenate([p.recognised for p in parts]),
        np.concatenate([p.phonemes for p in parts]),
        np.concatenate(scores),
    )


# -- the recognisers of the program ---------------------------------------------------------------------------


@pytest.mark.parametrize("name", BUILT_IN)
def test_what_a_specification_names_is_there(name: str):
    spec = BUILT_IN[name]
    preset = factory_preset(name)
    assert preset is not None
    assert preset.recogniser == name
    for function in filter(None, (spec.fit, spec.adapt)):
        assert callable(spec.load(function))
    recogniser = recogniser_of(name, preset.config)
    assert (recogniser.scores == SCORES) == (Tuning.SENSITIVITIES in spec.tuned_by)
    late = replace(preset, settings=replace(preset.settings, look_ahead=0.05))
    assert (recogniser_of(name, late.config).look_ahead > 0) == (spec.looks_ahead or preset.has_decoder)


def compares_recognisers(node: ast.AST) -> bool:
    """Whether a piece of code tells recognisers apart by their names or classes."""
    if isinstance(node, ast.Compare):
        literals = {n.value for n in ast.walk(node) if isinstance(n, ast.Constant) and isinstance(n.value, str)}
        return "recogniser" in ast.unparse(node) and bool(literals & BUILT_IN.keys())
    is_check = isinstance(node, ast.Call) and ast.unparse(node.func) == "isinstance"
    return is_check and ast.unparse(node).endswith(("Recogniser)", "ThesisRules)", "PlugIn)"))


def test_nothing_in_the_code_tells_recognisers_apart_by_their_names_or_classes():
    folders = [Path(phonemeengine.__file__).parent, Path(phonemeanalyser.__file__).parent]
    found = [
        f"{path.name}:{node.lineno}"
        for folder in folders
        for path in folder.rglob("*.py")
        if re.search("ecogniser|ThesisRules|PlugIn", text := path.read_text(encoding="utf-8"))
        for node in ast.walk(ast.parse(text))
        if compares_recognisers(node)
    ]
    assert found == []
    for told in ("preset.recogniser == 'rules'", "recogniser in ('x', 'learned')", "isinstance(r, RuleRecogniser)"):
        assert compares_recognisers(ast.parse(told, mode="eval").body)


@pytest.mark.parametrize("name", BUILT_IN)
def test_who_needs_no_features_hears_the_same_without_them(name: str):
    preset = factory_preset(name)
    assert preset is not None
    answers = []
    for phonemes_only in (True, False):
        analyser = Analyser(preset, phonemes_only=phonemes_only)
        answers.append(np.concatenate((analyser.push(SOUND).recognised, analyser.finish().recognised)))
    np.testing.assert_array_equal(*answers)
    names = Analyser(preset, phonemes_only=True).push(SOUND).features.names
    assert ("energy" in names) == BUILT_IN[name].needs_features


@pytest.mark.parametrize("name", BUILT_IN)
def test_who_knows_what_falls_short_is_steadied_by_hysteresis(name: str):
    preset = factory_preset(name)
    assert preset is not None
    analyser = Analyser(preset)
    analysis = analyser.push(SOUND)
    assert (analyser.recogniser.deficits(analysis.features) is not None) == BUILT_IN[name].has_deficits


# -- one of another package -----------------------------------------------------------------------------------


@settings(max_examples=25, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(cuts=st.lists(st.integers(0, len(SOUND)), max_size=6))
def test_however_the_sound_is_cut_a_plug_in_that_looks_ahead_says_the_same(bright: Preset, cuts: list[int]):
    for found, whole in zip(analysed(bright, cuts), analysed(bright, []), strict=True):
        assert len(found) == -(-len(SOUND) // HOP)
        np.testing.assert_allclose(found, whole, rtol=1e-5, atol=1e-6)


def test_a_plug_in_hears_what_comes_and_says_how_sure_it_is_and_why(bright: Preset):
    recognised, _, scores = analysed(bright, [])
    assert set(recognised[:10]) == {S}
    assert set(recognised[25:45]) == {A}
    assert set(recognised[55:75]) == {SZ}
    np.testing.assert_allclose(scores.sum(axis=1), 1, rtol=1e-5)
    late, _, _ = analysed(replace(bright, settings=replace(bright.settings, look_ahead=0.0)), [])
    first_s = [np.flatnonzero(codes == SZ)[0] for codes in (recognised, late)]
    assert first_s[0] < first_s[1]  # it is told sooner by what comes
    analyser = Analyser(bright)
    analysis = analyser.push(SOUND)
    assert analyser.recogniser.look_ahead == 3
    for k in range(0, len(analysis), 5):
        trace = analyser.recogniser.explain(analysis.features, k)
        assert trace.phoneme == analysis.recognised[k]
        assert len(trace.comparisons) == 5


def test_sensitivities_thresholds_and_hysteresis_of_a_plug_in_are_controls(bright: Preset):
    controls = {c.name for g in controls_of(bright, recogniser_of("brightness", bright.config)) for c in g.controls}
    assert {"sensitivity_a", "silence_max_energy", "szsch_szsch1", "hysteresis"} <= controls
    assert "sz_s1" not in controls
    assert unused_settings(bright) == {"decoder", "change_cost"}
    deaf = replace(bright, sensitivities={Phoneme.SILENCE: 10.0})
    assert np.mean(analysed(deaf, [])[0] == S) > np.mean(analysed(bright, [])[0] == S)


def test_a_plug_in_is_scored_and_the_workbench_says_what_the_analyser_says(bright: Preset, takes):
    scores = score(bright, takes)
    assert scores.look_ahead == 3
    assert scores.overall.scores.accuracy > 0.8
    workbench = LabelledFeatures(takes, bright)
    for sensitivities in ({}, {Phoneme.A: -3.0}):
        preset = replace(bright, sensitivities=sensitivities)
        assert not workbench.needs_measuring(preset)
        plainly = np.concatenate([predict(utterance, preset).phonemes for utterance in takes])
        np.testing.assert_array_equal(workbench.predict(preset), plainly)
    assert workbench.needs_measuring(mistuned(bright))


def test_a_plug_in_is_fitted_and_what_is_left_out_is_answered_without_it(bright: Preset, takes):
    report = fit_preset(LabelledFeatures(takes, mistuned(bright)), mistuned(bright))
    assert report.after.macro_f1 > report.before.macro_f1 + 0.1
    assert report.held_out is not None
    assert report.held_out.macro_f1 > report.before.macro_f1
    assert report.after == score(report.preset, takes).overall.scores


def test_a_plug_in_learns_a_voice_by_the_api_and_by_the_command_line_alike(bright: Preset, takes, tmp_path: Path):
    for take in takes:
        take.path.with_suffix(".csv").write_text(format_table(take.labels), encoding="utf-8")
    outcome = calibrate(mistuned(bright), takes)
    assert outcome.gains
    assert outcome.after.macro_f1 > outcome.before.macro_f1
    save_preset(mistuned(bright), tmp_path / "bright.toml")
    out = tmp_path / "out" / "mine.toml"
    out.parent.mkdir()
    assert main(["adapt", str(tmp_path), "--preset", str(tmp_path / "bright.toml"), "-o", str(out)]) == 0
    found = load_preset(out)
    assert found.thresholds == outcome.preset.thresholds
    assert found.sensitivities == outcome.preset.sensitivities


def test_a_plug_in_brings_its_factory_preset(shelf: Shelf, tmp_path: Path):
    shelf.offer("")
    save_preset(Preset(name="theirs", recogniser="own"), tmp_path / "theirs.toml")
    assert factory_preset("own") is None
    shelf.offer(
        "from phonemeengine.recognition.spec import RecogniserSpec\n"
        f"Own = RecogniserSpec('other', Plain, factory_preset={str(tmp_path / 'theirs.toml')!r})",
        name="other",
        package="other-package",
    )
    preset = factory_preset("other")
    assert preset is not None
    assert preset.name == "theirs"


def test_a_plug_in_that_neither_fits_nor_learns_says_so(loudness: Path, takes):
    preset = Preset(recogniser="loudness")
    with pytest.raises(CorpusError, match="'loudness' does not learn voices; choose one of thesis, learned"):
        calibrate(preset, takes)


# -- what is wrong with a plug-in -----------------------------------------------------------------------------

PROBABLE = "Recognition(np.zeros(len(windows), np.uint8), np.zeros((len(windows), 11), np.float32))"
SEEING = "Recognition(np.zeros(len(windows), np.uint8), None, np.full((len(windows), {n}), 0.1, np.float32){more})"
WRONG_ANSWERS: dict[str, tuple[dict[str, object], str]] = {
    "an answer too soon": ({"look_ahead": 2}, r"gave uint8, shape \(3,\) where codes of uint8, shape \(1,\)"),
    "a look ahead without end": ({"look_ahead": 101}, r"looks 101 frames ahead, and 0\.\.100 are allowed"),
    "a look back": ({"look_ahead": -1}, "looks -1 frames ahead"),
    "a look ahead that is no number": ({"look_ahead": "'far'"}, "cannot say how far it looks ahead"),
    "no scores": ({"scores": ("x",)}, "gave a NoneType where scores of float32"),
    "too many scores": ({"scores": ("x",), "answer": PROBABLE}, r"shape \(3, 11\) where scores .* \(3, 1\)"),
    "too many visemes": ({"answer": SEEING.format(n=16, more="")}, r"shape \(3, 16\) where visemes .* \(3, 15\)"),
    "visemes of no set": ({"answer": SEEING.format(n=15, more=", 'mine'")}, "gave a str where a VisemeSet is wanted"),
    "scores of no phonemes": (
        {"scores": ("x",), "tuned_by": [str(Tuning.SENSITIVITIES)], "answer": PROBABLE},
        "its scores must be those of all phonemes",
    ),
}


def test_a_plug_in_tells_visemes_apart(shelf: Shelf):
    answer = SEEING.format(n=15, more="")
    found = Analyser(offer(shelf, answer=answer)).push(np.zeros(2048, np.float32))
    np.testing.assert_array_equal(found.viseme_scores, np.full((len(found), 15), 0.1, np.float32))


@pytest.mark.parametrize(("changes", "what"), WRONG_ANSWERS.values(), ids=WRONG_ANSWERS.keys())
def test_a_plug_in_that_answers_wrongly_is_one_sentence(changes: dict[str, object], what: str, shelf: Shelf):
    preset = offer(shelf, **changes)
    with pytest.raises(RecogniserError, match=f"^the recogniser 'own' of the package own-package .*{what}"):
        Analyser(preset).push(np.zeros(2048 + 2 * HOP, np.float32)[: 2048 - 804 + 2 * HOP])


WRONG_LESSONS: dict[str, tuple[str, str]] = {
    "nothing of that name": ("own_package:nowhere", "cannot learn .AttributeError"),
    "a failure": ("builtins:divmod", "cannot learn .TypeError"),
    "no presets": ("builtins:print", "must learn a tuple of presets, got a NoneType"),
}


@pytest.mark.parametrize(("adapt", "what"), WRONG_LESSONS.values(), ids=WRONG_LESSONS.keys())
def test_a_plug_in_that_cannot_learn_is_one_sentence(adapt: str, what: str, shelf: Shelf, takes):
    preset = offer(shelf, adapt=adapt)
    with pytest.raises(EngineError, match=what):
        calibrate(preset, takes, held_out=takes[:1])


def test_a_plug_in_that_fits_no_preset_is_one_sentence(shelf: Shelf, takes):
    preset = offer(shelf, fit="builtins:print")
    with pytest.raises(RecogniserError, match="'own' must fit a preset, got a NoneType"):
        fit_preset(LabelledFeatures(takes, preset), preset)


def test_a_plug_in_that_asks_for_a_model_is_refused_without_one(shelf: Shelf):
    preset = offer(shelf, tuned_by=[str(Tuning.MODEL)])
    with pytest.raises(EngineError, match="'own' needs a model, and this preset has none; choose another preset"):
        Analyser(preset)


def test_what_learns_hears_when_it_shall_end(bright: Preset, takes):
    with pytest.raises(Cancelled):
        calibrate(mistuned(bright), takes, progress=lambda share: share < 0.1)
