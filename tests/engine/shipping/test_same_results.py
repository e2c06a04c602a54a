"""The ear in C says what the engine says: the same phonemes, and nearly the same numbers."""

from collections.abc import Sequence
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import settings as hypothesis_settings
from hypothesis import strategies as st

from phonemeengine import (
    Analyser,
    AnalysisSettings,
    Filter,
    ModelKind,
    Phoneme,
    Preset,
    SoundReader,
    Variable,
    load_preset,
)
from phonemeengine.analyser import Analysis, concatenate_analyses
from phonemeengine.features.variables import Kind, Spectrum
from phonemeengine.labels.visemes import STANDARD_VISEMES, Viseme, VisemeSet
from phonemeengine.mouth.table import load_table
from phonemeengine.presets.model_choice import with_small_network
from phonemeengine.recognition.model import Model, OutputHead
from phonemeengine.recognition.network import TAPS, Layer
from phonemeengine.recognition.rules import Condition, Rule
from phonemeengine.recognition.scores import ConfidenceCurve, scores_in
from phonemeengine.settings import HOP, SAMPLE_RATE, Decimation, Decoding, WindowFunction
from phonemeengine.shipping.targets import format_ear
from tests.compiled_ears import CEar, CModel, EarLibrary, Frames, compiler, ear_library
from tests.conftest import CORPUS
from tests.models import tone_model
from tests.sounds import Sound, noise, silence, tone

RECORDINGS = ("espeak_de/de_f1/de_f1_00.flac", "festival/kal/kal_03.flac", "human_pocketsphinx/cards/cards_001.flac")
SAME, NEAR = 0.999, 1e-3


@cache
def speech() -> Sound:
    """Three voices, noise and silence."""
    parts = [sound_of(CORPUS / name) for name in RECORDINGS]
    return np.concatenate([*parts, silence(0.3), noise(1.0, 0.05), noise(0.4, 0.001)])


def sound_of(path: Path) -> Sound:
    with SoundReader(path) as reader:
        return np.concatenate([np.zeros(0, np.float32), *reader.blocks(SAMPLE_RATE)])


def recognised_by_engine(preset: Preset, sound: Sound) -> Analysis:
    analyser = Analyser(with_small_network(preset))
    return concatenate_analyses([analyser.push(sound), analyser.finish()])


def heard_in_c(library: EarLibrary, preset: Preset, sound: Sound, cuts: Sequence[int] = ()) -> Frames:
    return CEar(CModel(library, format_ear(preset, ()))).hear(sound, cuts)


def check_same(frames: Frames, analysis: Analysis) -> None:
    assert len(frames) == len(analysis)
    assert (frames["number"] == np.arange(len(frames))).all()
    assert (frames["phoneme"] == analysis.phonemes).mean() >= SAME
    assert (frames["viseme"] == analysis.visemes).mean() >= SAME
    same = frames["phoneme"] == analysis.phonemes
    assert np.allclose(frames["intensity"][same], analysis.intensities[same], atol=NEAR)
    assert np.allclose(frames["confidence"][same], analysis.confidences[same], atol=NEAR, equal_nan=True)
    scores = scores_in(analysis.features)
    assert np.abs(frames["scores"] - (0 if scores is None else scores)).max() <= NEAR
    seen = np.zeros_like(frames["viseme_scores"])
    if analysis.viseme_scores is not None:
        seen[:, : analysis.viseme_scores.shape[1]] = analysis.viseme_scores
    assert np.abs(frames["viseme_scores"] - seen).max() <= NEAR


def says_several(analysis: Analysis, n: int) -> bool:
    return len(np.unique(analysis.phonemes)) >= n


@pytest.mark.parametrize("name", ["learned", "extended", "templates", "thesis", "thesis-calm", "thesis-anti-aliased"])
def test_a_factory_preset_hears_the_same_in_c(library: EarLibrary, name: str) -> None:
    preset = load_preset(name)
    analysis = recognised_by_engine(preset, speech())
    assert says_several(analysis, 9)
    check_same(heard_in_c(library, preset, speech()), analysis)
    if name in {"learned", "thesis"}:
        check_same(heard_in_c(ear_library(compiler("clang")), preset, speech()), analysis)


@hypothesis_settings(max_examples=5)
@given(cuts=st.lists(st.integers(0, 2 * SAMPLE_RATE), max_size=40).map(sorted))
def test_the_frames_are_the_same_however_the_sound_is_cut(library: EarLibrary, cuts: list[int]) -> None:
    sound, preset = speech()[: 2 * SAMPLE_RATE], load_preset("learned")
    assert (heard_in_c(library, preset, sound, cuts) == heard_in_c(library, preset, sound)).all()


@pytest.mark.parametrize("n_samples", [0, 1, HOP, HOP + 1, 2500])
def test_a_short_sound_has_as_many_frames_as_in_the_engine(library: EarLibrary, n_samples: int) -> None:
    preset, sound = load_preset("learned"), tone(300, 1.0)[:n_samples]
    frames = heard_in_c(library, preset, sound)
    assert len(frames) == -(-n_samples // HOP)
    if n_samples:
        check_same(frames, recognised_by_engine(preset, sound))


def test_a_preset_that_was_adapted_and_calmed_hears_the_same(library: EarLibrary) -> None:
    base = load_preset("learned")
    settings = replace(
        base.settings,
        hysteresis=0.3,
        minimum_hold=0.05,
        live_look_ahead=0.05,
        intensity_low=-60.0,
        intensity_high=-20.0,
    )
    preset = replace(
        base,
        settings=settings,
        sensitivities={Phoneme.M: 2.0, Phoneme.SILENCE: -3.0, Phoneme.A: 0.7},
        successors=dict.fromkeys(Phoneme, Phoneme.O),
        confidences={ModelKind.REAL_TIME: ConfidenceCurve((0.2, 0.5, 0.9), (0.1, 0.4, 0.95))},
    )
    analysis = recognised_by_engine(preset, speech())
    assert says_several(analysis, 9)
    check_same(heard_in_c(library, preset, speech()), analysis)
    uncalmed = replace(preset, settings=replace(settings, statistics=False), confidences={})
    check_same(heard_in_c(library, uncalmed, speech()), recognised_by_engine(uncalmed, speech()))


@pytest.mark.parametrize(
    ("widths", "dilations", "warps", "visemes"),
    [
        ((33,), (3,), (1.0,), True),
        ((7, 7, 7), (1, 5, 2), (0.9, 1.1), False),
        ((64, 64), (2, 1), (0.8, 0.9, 1.0, 1.2), True),
    ],
)
def test_a_network_of_any_size_hears_the_same(
    library: EarLibrary, widths: tuple[int, ...], dilations: tuple[int, ...], warps: tuple[float, ...], visemes: bool
) -> None:
    preset = replace(load_preset("learned"), model=random_model(widths, dilations, warps, visemes))
    check_same(heard_in_c(library, preset, speech()), recognised_by_engine(preset, speech()))


def random_model(
    widths: tuple[int, ...], dilations: tuple[int, ...], warps: tuple[float, ...], visemes: bool
) -> Model:
    chance = np.random.default_rng(len(widths))

    def drawn(*shape: int) -> np.ndarray:
        return chance.normal(0, shape[0] ** -0.5, shape).astype(np.float32)

    inputs = (40, *widths[:-1])
    layers = [Layer(drawn(TAPS * n, m), drawn(m), d) for n, m, d in zip(inputs, widths, dilations, strict=True)]
    heads = [[OutputHead(drawn(widths[-1], n), drawn(n)) for _ in range(3)] for n in (len(Phoneme), len(Viseme))]
    model = Model(tuple(layers), tuple(heads[0]), warps, viseme_heads=tuple(heads[1]) if visemes else ())
    return model.rounded()


def test_visemes_of_a_models_own_are_named_and_shown_the_same(library: EarLibrary) -> None:
    model = load_preset("learned").model
    assert model is not None
    own = VisemeSet(
        names=("shut", "teeth", "tongue", "open", "wide"),
        phonemes={
            **dict.fromkeys(Phoneme, ("open", "wide")),
            Phoneme.SILENCE: ("shut",),
            Phoneme.UNIDENTIFIED: ("teeth", "tongue"),
        },
        usual={Phoneme.SILENCE: "shut"},
        phones={"teeth": "f", "tongue": "θ"},
    )
    columns = [Viseme.SIL, Viseme.FF, Viseme.NN, Viseme.AA, Viseme.IH]
    heads = tuple(OutputHead(head.weights[:, columns], head.bias[columns]) for head in model.viseme_heads)
    preset = replace(load_preset("learned"), model=replace(model, viseme_heads=heads, viseme_set=own))
    analysis = recognised_by_engine(preset, speech())
    assert len({*analysis.visemes.tolist()}) > 3
    check_same(heard_in_c(library, preset, speech()), analysis)
    content, table = format_ear(preset, ("oculus",)), load_table("oculus")
    opened = CModel(library, content)
    assert library.visemes(opened) == own.names
    for phoneme in (Phoneme.UNIDENTIFIED, Phoneme.A):
        for code, name in enumerate((*own.names, "")):
            shape = library.c.ear_table_shape(opened.handle, 0, int(phoneme), code)
            shown = library.c.ear_table_shape_name(opened.handle, 0, shape).decode()
            assert shown == table.shape_of(phoneme, own.phones.get(name, "")), (phoneme, name)


def test_only_what_older_runtimes_do_not_know_makes_a_file_of_a_newer_version() -> None:
    own = replace(STANDARD_VISEMES, usual={})
    plain, rules = load_preset("learned"), load_preset("extended")
    assert plain.model is not None
    named = replace(plain, model=replace(plain.model, viseme_set=own))
    told = [format_ear(preset)[4] for preset in (plain, rules.with_decoder(Decoding.OFF), named, rules)]
    assert told == [1, 1, 2, 3]


def test_a_decoder_finds_the_same_in_c_for_any_language_and_look_ahead(library: EarLibrary) -> None:
    base = load_preset("extended").with_decoder(Decoding.GERMAN)
    for ahead, hold in ((0.0, 0.0), (0.05, 0.03)):
        settings = replace(base.settings, live_look_ahead=ahead, minimum_hold=hold)
        preset = replace(base, settings=settings)
        frames = heard_in_c(library, preset, speech(), [5000, 5001, 40_000])
        check_same(frames, recognised_by_engine(preset, speech()))


def test_an_answer_belongs_to_the_frame_at_which_the_tone_began(library: EarLibrary) -> None:
    settings = replace(load_preset("learned").settings, live_look_ahead=0.03, minimum_hold=0.01, hysteresis=0.0)
    preset = Preset(recogniser="learned", model=tone_model({1000.0: Phoneme.A}), settings=settings)
    frames = heard_in_c(library, preset, np.concatenate((silence(0.5), tone(1000, 0.5))))
    assert abs(int(np.flatnonzero(frames["phoneme"] == Phoneme.A)[0]) - 50) <= 1


FILTERS = (
    AnalysisSettings(
        filters=frozenset(Filter),
        quantise=2,
        decimation=Decimation.ANTI_ALIASED,
        pre_emphasis=0.9,
        window_function=WindowFunction.BLACKMAN_HARRIS,
        frequency_smooth=0.7,
        time_smooth=0.6,
        high_pass_start=80.0,
        high_pass_end=300.0,
        low_pass_start=5000.0,
        low_pass_end=7000.0,
        denoise_threshold=0.0005,
        mel_bands=30,
        hysteresis=0.1,
        minimum_hold=0.03,
    ),
    AnalysisSettings(
        filters=frozenset({Filter.PRE_EMPHASIS, Filter.MEL, Filter.TIME_SMOOTH}), time_smooth=0.3, hysteresis=0.2
    ),
    AnalysisSettings(
        filters=frozenset({Filter.QUANTISE, Filter.FREQUENCY_SMOOTH, Filter.DENOISE}),
        quantise=4,
        frequency_smooth=1.0,
        denoise_threshold=0.002,
    ),
)


@pytest.mark.parametrize("settings", FILTERS, ids=["all filters", "few filters", "folded"])
def test_filters_variables_and_rules_of_ones_own_measure_the_same(
    library: EarLibrary, settings: AnalysisSettings
) -> None:
    variables = tuple(
        Variable(f"{kind}_{source}", 150.0, 2600.0, kind, source) for kind in Kind for source in Spectrum
    )
    variables = (*variables, Variable("ratio", 400.0, 900.0, Kind.MEAN, Spectrum.FILTERED, per="max_filtered"))
    names = [
        *(v.name for v in variables),
        "zero_crossings",
        "volume",
        "energy",
        "max_energy",
        "f0",
        "m_p2",
        "energy_n",
    ]
    base = Preset(settings=settings, variables=variables)
    measured = recognised_by_engine(base, speech()).features
    shares = np.linspace(0.15, 0.85, len(names))
    limits = {name: float(np.quantile(measured[name], share)) for name, share in zip(names, shares, strict=True)}
    rules = tuple(
        Rule(
            Phoneme(k % 11),
            tuple(Condition(n, ">" if (k + j) % 2 else "<", limit=limits[n]) for j, n in enumerate(pair)),
        )
        for k, pair in enumerate(zip(names, names[3:] + names[:3], strict=True))
    )
    preset = replace(base, recogniser="rules", rules=rules)
    analysis = recognised_by_engine(preset, speech())
    assert says_several(analysis, 6)
    check_same(heard_in_c(library, preset, speech()), analysis)
