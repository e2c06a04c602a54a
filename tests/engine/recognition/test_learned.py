"""The learned recogniser, with models whose answers are known: tones that it names, and how far ahead it looks."""

import io
import pickle
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from phonemeengine.analyser import Analyser, Analysis, concatenate_analyses
from phonemeengine.dsp.mel import N_BANDS, log_mels, warped_mel_bank
from phonemeengine.encoder.live import LiveHead
from phonemeengine.errors import ModelError, PresetError
from phonemeengine.features.variables import SCORES
from phonemeengine.labels.visemes import NO_VISEME, Viseme, VisemeSet
from phonemeengine.mouth.performer import MOUTH_ALONE, Performer, timed_frames
from phonemeengine.mouth.table import load_table
from phonemeengine.mouth.transcript import transcript_of
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import load_preset, save_preset
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.model import FORMAT, Model, OutputHead, load_model, save_model
from phonemeengine.recognition.spec import RecogniserConfig, recogniser_of
from phonemeengine.settings import HOP, SAMPLE_RATE, WINDOW, AnalysisSettings
from tests.models import band_of, tone_model
from tests.sounds import silence, tone

TONES = {700.0: Phoneme.A, 2500.0: Phoneme.I}
PARTS = [silence(0.2), tone(700, 0.3, 0.5), silence(0.2), tone(2500, 0.3, 0.5), silence(0.1)]
SOUND = np.concatenate(PARTS)
EDGES = np.cumsum([len(part) for part in PARTS]) / SAMPLE_RATE


def preset_of(model: Model, look_ahead: float = 0.05, **changes: object) -> Preset:
    plain = AnalysisSettings(statistics=False, look_ahead=look_ahead)
    return Preset(recogniser="learned", model=model, settings=replace(plain, **changes))  # type: ignore[arg-type]


def heard(preset: Preset, cuts: list[int] | None = None, sound: np.ndarray = SOUND) -> list[Analysis]:
    analyser = Analyser(preset)
    return [*(analyser.push(part) for part in np.split(sound, sorted(cuts or []))), analyser.finish()]


def codes_of(analyses: list[Analysis]) -> np.ndarray:
    return np.concatenate([a.phonemes for a in analyses])


@pytest.fixture(scope="module")
def model() -> Model:
    return tone_model(TONES)


@pytest.mark.parametrize("look_ahead", [0.0, 0.01, 0.03, 0.05])
def test_each_frame_gets_its_own_answer_however_far_ahead_is_looked(model, look_ahead):
    codes = codes_of(heard(preset_of(model, look_ahead)))
    assert len(codes) == -(-len(SOUND) // HOP)
    middles = (np.arange(len(codes)) + 0.5) * 0.01
    named = [Phoneme.SILENCE, Phoneme.A, Phoneme.SILENCE, Phoneme.I, Phoneme.SILENCE]
    expected = np.array(named)[np.searchsorted(EDGES, middles).clip(0, 4)]
    clear = (
        np.min(np.abs(middles[:, None] - EDGES[None]), axis=1) > 0.02
    )  # half a short window, and the edge's splash
    np.testing.assert_array_equal(codes[clear], expected[clear])


@settings(deadline=None, max_examples=25)
@given(cuts=st.lists(st.integers(0, len(SOUND)), max_size=40), frames=st.integers(0, 5))
def test_the_answers_do_not_depend_on_how_the_sound_was_cut(cuts, frames):
    preset = preset_of(tone_model(TONES), frames / 100)
    whole, parts = heard(preset), heard(preset, cuts)
    np.testing.assert_array_equal(codes_of(parts), codes_of(whole))
    starts = [a.start for a in parts if len(a)]
    assert starts == list(np.cumsum([0, *(len(a) for a in parts if len(a))]))[:-1]
    values = [np.concatenate([a.features.values for a in analyses]) for analyses in (whole, parts)]
    np.testing.assert_allclose(values[1], values[0], rtol=1e-3, atol=1e-4)


def test_what_is_measured_stays_with_its_frame(model):
    ahead, now = (heard(preset_of(model, look_ahead)) for look_ahead in (0.05, 0.0))
    for name in ("energy", "volume", "zero_crossings"):
        one, other = (np.concatenate([a.features[name] for a in analyses]) for analyses in (ahead, now))
        np.testing.assert_array_equal(one, other)


def test_the_answer_comes_as_many_frames_late_as_are_looked_ahead(model):
    for frames in (0, 2, 5):
        analyser = Analyser(preset_of(model, frames / 100))
        first = next(k for k in range(100) if len(analyser.push(SOUND[k * HOP : (k + 1) * HOP])))
        assert first == WINDOW // 2 // HOP + frames


@pytest.mark.parametrize("frames", [0, 3])
def test_where_phonemes_alone_are_wanted_they_are_the_same_and_no_spectrum_is_made(model, frames):
    preset = preset_of(model, frames / 100, statistics=True, hysteresis=0.2)
    whole, alone = (Analyser(preset, phonemes_only=only) for only in (False, True))
    for part in np.array_split(SOUND, 50):
        one, other = whole.push(part), alone.push(part)
        assert one.start == other.start
        for name in ("phonemes", "recognised", "intensities"):
            np.testing.assert_array_equal(getattr(one, name), getattr(other, name))
        assert (other.spectra.shape, other.waveforms.shape) == ((len(one), 0), (len(one), 0))
        np.testing.assert_array_equal(one.features["p_a"], other.features["p_a"])


def test_a_recogniser_that_needs_variables_gets_them_though_phonemes_alone_are_wanted(model):
    rules = Preset(settings=AnalysisSettings(statistics=False))
    analyser, whole = Analyser(preset_of(model, 0.0), phonemes_only=True), Analyser(rules)
    half = HOP * 60
    assert analyser.push(SOUND[:half]).spectra.shape[1] == 0
    analyser.set_preset(rules)
    whole.push(SOUND[:half])
    one, other = whole.push(SOUND[half:]), analyser.push(SOUND[half:])
    np.testing.assert_array_equal(one.phonemes, other.phonemes)
    np.testing.assert_array_equal(one.spectra, other.spectra)


def test_scores_are_probabilities_and_columns_of_the_features(model):
    analysis = heard(preset_of(model))[0]
    assert analysis.features.names[-len(SCORES) :] == SCORES
    scores = np.stack([analysis.features[name] for name in SCORES], axis=1)
    np.testing.assert_allclose(scores.sum(axis=1), 1, atol=1e-5)
    np.testing.assert_array_equal(scores.argmax(axis=1), analysis.recognised)


def test_the_decision_is_told_by_the_likeliest_phonemes(model):
    preset = preset_of(model)
    analysis = heard(preset)[0]
    trace = recogniser_of("learned", preset.config).explain(analysis.features, 35)
    assert trace.phoneme is Phoneme.A
    first, second = trace.comparisons[:2]
    assert (first.rule, first.variable, first.sign) == ("a", "p_a", ">")
    assert first.value > 0.9
    assert first.margin == pytest.approx(first.value - second.value)


def test_hysteresis_keeps_a_phoneme_until_another_is_clearly_likelier(model):
    levels = [log_mels(tone(f, 1)[np.newaxis, :WINDOW])[0, band_of(f)] for f in TONES]
    a_little_more = 0.01 * 10 ** ((levels[0] - levels[1] + 0.05) / 2)  # 0.5 dB: 1.6 times as likely
    faint = np.concatenate([tone(700, 0.2, 0.5), tone(700, 0.2, 0.01) + tone(2500, 0.2, a_little_more), silence(0.2)])
    statistics = {"statistics": True, "minimum_hold": 0.0}
    for hysteresis, expected in ((0.0, Phoneme.I), (0.5, Phoneme.A)):
        preset = preset_of(model, 0.0, hysteresis=hysteresis, **statistics)
        assert codes_of(heard(preset, sound=faint))[30] == expected


def test_another_model_goes_on_with_the_frames_that_still_waited(model):
    other = tone_model({700.0: Phoneme.O, 2500.0: Phoneme.U})
    analyser = Analyser(preset_of(model))
    first = analyser.push(SOUND[: SAMPLE_RATE // 2])
    analyser.set_preset(preset_of(other, 0.0))
    rest = [analyser.push(SOUND[SAMPLE_RATE // 2 :]), analyser.finish()]
    assert rest[0].start == len(first)
    codes = codes_of([first, *rest])
    assert len(codes) == -(-len(SOUND) // HOP)
    assert set(codes.tolist()) == {Phoneme.SILENCE, Phoneme.A, Phoneme.O, Phoneme.U}
    assert codes[35] == Phoneme.A  # named before
    assert codes[47] == Phoneme.O  # had to wait, and so was named by the other one


def test_who_changes_the_recogniser_twice_at_once_gets_every_frame_once(model):
    analyser = Analyser(preset_of(model))
    first = analyser.push(SOUND[: SAMPLE_RATE // 2])
    analyser.set_preset(Preset())
    analyser.set_preset(preset_of(model))
    rest = [analyser.push(SOUND[SAMPLE_RATE // 2 :]), analyser.finish()]
    assert rest[0].start == len(first)
    codes = codes_of([first, *rest])
    assert len(codes) == -(-len(SOUND) // HOP)
    assert codes[35] == codes[47] == Phoneme.A


def test_a_filter_switched_while_frames_wait_loses_none(model):
    analyser = Analyser(preset_of(model))
    first = analyser.push(SOUND[: SAMPLE_RATE // 2])
    preset = preset_of(model)
    analyser.set_preset(replace(preset, settings=replace(preset.settings, filters=frozenset())))
    rest = [analyser.push(SOUND[SAMPLE_RATE // 2 :]), analyser.finish()]
    np.testing.assert_array_equal(codes_of([first, *rest]), codes_of(heard(preset)))


def test_the_recogniser_without_a_model_is_refused_with_what_to_do():
    with pytest.raises(PresetError, match="needs a model, and this preset has none; begin with the preset learned"):
        recogniser_of("learned", RecogniserConfig())


# -- what it hears ----------------------------------------------------------------------------------------


def test_a_full_scale_tone_is_loudest_in_its_band_and_silence_is_the_floor():
    windows = np.stack([tone(1000, 1)[:WINDOW], np.zeros(WINDOW, np.float32)])
    heard_tone, heard_silence = log_mels(windows)
    assert heard_tone.max() > -1
    np.testing.assert_allclose(heard_silence, -11, atol=1e-6)


@pytest.mark.parametrize("warp", [0.85, 1.0, 1.15])
def test_a_warped_bank_finds_at_its_place_what_lies_so_much_higher(warp):
    place = warped_mel_bank()[:, 20].argmax()
    moved = warped_mel_bank(warp)[:, 20].argmax()
    assert moved == pytest.approx(place * warp, abs=1)
    np.testing.assert_allclose(warped_mel_bank(warp).sum(axis=0), 1, atol=1e-5)


# -- the file ---------------------------------------------------------------------------------------------


def test_a_model_comes_back_from_its_file_as_it_was(model, tmp_path):
    rounded = model.rounded()
    save_model(rounded, tmp_path / "m.npz")
    back = load_model(tmp_path / "m.npz")
    assert back == rounded
    assert back.about == {"name": "tones"}
    for one, other in zip(back.layers, rounded.layers, strict=True):
        np.testing.assert_array_equal(one.weights, other.weights)
    assert back != tone_model({700.0: Phoneme.A, 2000.0: Phoneme.I})


def test_a_model_keeps_what_the_real_time_model_learned_of_its_voice(model, tmp_path):
    head = LiveHead(np.full((128, 52), 0.1, np.float32), np.arange(52, dtype=np.float32), "0123", 1.35)
    adapted = replace(model, live_head=head).rounded()
    save_model(adapted, tmp_path / "m.npz")
    back = load_model(tmp_path / "m.npz")
    assert back == adapted != model.rounded()
    assert back.live_head is not None
    assert (back.live_head.origin, back.live_head.warp) == ("0123", 1.35)
    np.testing.assert_array_equal(back.live_head.weights, np.float32(np.float16(0.1)) * np.ones((128, 52)))
    np.testing.assert_array_equal(back.live_head.bias, head.bias)
    save_model(model, tmp_path / "m.npz")
    altered(tmp_path / "m.npz", **HEAD)
    assert load_model(tmp_path / "m.npz").live_head is not None  # so the refusals below are of what is wrong alone


def test_a_preset_is_saved_with_its_model_beside_it(model, tmp_path):
    preset = replace(preset_of(model.rounded()), name="voice")
    save_preset(preset, tmp_path / "voice.toml")
    assert sorted(p.name for p in tmp_path.iterdir()) == ["voice.npz", "voice.toml"]
    assert load_preset(tmp_path / "voice.toml") == preset


def altered(path: Path, **changes: np.ndarray) -> Path:
    with np.load(path) as file:
        arrays = {name: file[name] for name in file.files}
    np.savez(path, **{**arrays, **changes})
    return path


HEAD = {
    "live_head_origin": np.frombuffer(b"0123", np.uint8),
    "live_head_weights": np.zeros((128, 52), np.float16),
    "live_head_bias": np.zeros(52, np.float32),
}
"""That of the real-time model, as it was adapted to a voice."""
BAD = {
    "a newer version": (lambda p: altered(p, format=np.array(FORMAT + 1)), "is of version 5, and this program reads"),
    "weights of another shape": (
        lambda p: altered(p, layer_0_weights=np.zeros((3, 2), np.float16)),
        "do not fit together",
    ),
    "not a number": (
        lambda p: altered(p, head_0_bias=np.full(len(Phoneme), np.nan, np.float32)),
        "do not fit together",
    ),
    "a dilation of a million": (
        lambda p: altered(p, dilations=np.array([1, 10**6, 1, 1, 1, 1])),
        "its dilations must lie in 1..256 frames",
    ),
    "no layers": (lambda p: altered(p, dilations=np.zeros(0, int)), "a model has 1..32 layers"),
    "a lacking array": (lambda p: altered(p, n_heads=np.array(7)), "a model has 1..32 layers and 1..6 heads"),
    "cut in the middle": (lambda p: p.write_bytes(p.read_bytes()[: p.stat().st_size // 2]), "file is damaged"),
    "text": (lambda p: p.write_text("hello"), "file is damaged"),
    "nothing": (lambda p: p.write_bytes(b""), "file is damaged"),
    "nine megabytes": (lambda p: p.write_bytes(bytes(9 << 20)), "smaller than 8 MB"),
    "a head of another size": (
        lambda p: altered(p, **HEAD | {"live_head_weights": np.zeros((128, 26), np.float16)}),
        "do not fit together",
    ),
    "a head without a bias": (
        lambda p: altered(p, **{name: array for name, array in HEAD.items() if name != "live_head_bias"}),
        "file is damaged",
    ),
    "a head with a warp of 3": (lambda p: altered(p, **HEAD, live_head_warp=np.array([3.0])), "warps of 0.5..2"),
    "a missing file": (lambda p: p.unlink(), "put it beside its preset"),
}


@pytest.mark.parametrize("what", BAD)
def test_a_bad_model_is_refused_in_one_sentence(model, tmp_path, what):
    path = tmp_path / "m.npz"
    save_model(model, path)
    spoil, words = BAD[what]
    spoil(path)
    with pytest.raises(ModelError, match=words) as refusal:
        load_model(path)
    assert str(refusal.value).startswith("m.npz: ")
    assert "\n" not in str(refusal.value)


class Trap:
    """Leaves a file behind where it is unpickled."""

    def __init__(self, path: Path) -> None:
        self.path = path

    def __reduce__(self):
        return Path.touch, (self.path,)


def test_nothing_in_a_model_is_executed(model, tmp_path):
    path, sprung = tmp_path / "m.npz", tmp_path / "sprung"
    save_model(model, path)
    trap = np.empty(1, object)
    trap[0] = Trap(sprung)
    with np.load(path) as file:
        arrays = {name: file[name] for name in file.files}
    np.savez(path, allow_pickle=True, **{**arrays, "about": trap})
    with pytest.raises(ModelError, match="damaged"):
        load_model(path)
    assert not sprung.exists()
    pickle.load(io.BytesIO(pickle.dumps(Trap(sprung))))  # the trap works where somebody falls into it
    assert sprung.exists()


@pytest.mark.parametrize("name", ["../m.npz", "/etc/m.npz", "..\\m.npz", ".hidden"])
def test_a_preset_names_no_model_elsewhere(model, tmp_path, name):
    save_preset(preset_of(model), tmp_path / "p.toml")
    text = (tmp_path / "p.toml").read_text().replace('"p.npz"', f"'{name}'")
    (tmp_path / "p.toml").write_text(text)
    with pytest.raises(PresetError, match="a model lies beside its preset"):
        load_preset(tmp_path / "p.toml")


def test_the_bands_are_those_that_models_were_trained_with():
    assert warped_mel_bank().shape[1] == N_BANDS == 40


# -- visemes ------------------------------------------------------------------------------------------

SOUNDS = {700.0: Phoneme.UNIDENTIFIED, 2500.0: Phoneme.UNIDENTIFIED}
SEEN = {700.0: Viseme.FF, 2500.0: Viseme.NN}


@pytest.mark.parametrize("look_ahead", [0.0, 0.05])
def test_a_model_hears_which_viseme_an_unidentified_sound_has(look_ahead):
    analyses = heard(preset_of(tone_model(SOUNDS, visemes=SEEN), look_ahead), [3000, 20_000])
    visemes = np.concatenate([a.visemes for a in analyses])
    middles = (np.arange(len(visemes)) + 0.5) * 0.01
    expected = np.array([Viseme.SIL, Viseme.FF, Viseme.SIL, Viseme.NN, Viseme.SIL])[
        np.searchsorted(EDGES, middles).clip(0, 4)
    ]
    clear = np.min(np.abs(middles[:, None] - EDGES[None]), axis=1) > 0.02
    np.testing.assert_array_equal(visemes[clear], expected[clear])


def test_a_model_without_such_ears_leaves_it_open(model):
    visemes = np.concatenate([a.visemes for a in heard(preset_of(tone_model(SOUNDS)))])
    assert set(visemes.tolist()) == {Viseme.SIL, NO_VISEME}
    assert {Viseme.AA, Viseme.IH} <= set(np.concatenate([a.visemes for a in heard(preset_of(model))]).tolist())


def test_the_file_of_a_model_keeps_its_visemes_and_that_of_one_without_is_as_it_was(model, tmp_path):
    seeing = tone_model(SOUNDS, visemes=SEEN).rounded()
    for name, one in (("seeing", seeing), ("plain", model.rounded())):
        save_model(one, tmp_path / f"{name}.npz")
        again = load_model(tmp_path / f"{name}.npz")
        assert again == one
        assert len(again.viseme_heads) == len(one.viseme_heads)
    with np.load(tmp_path / "plain.npz") as file:
        assert int(file["format"]) == 1


def with_own_visemes(model: Model) -> Model:
    """Give a model that tells two visemes apart, and silence."""
    columns = [Viseme.SIL, Viseme.FF, Viseme.NN]
    heads = tuple(OutputHead(head.weights[:, columns], head.bias[columns]) for head in model.viseme_heads)
    own = VisemeSet(
        names=("rest", "teeth on lip", "tongue up"),
        phonemes={**dict.fromkeys(Phoneme, ("rest",)), Phoneme.UNIDENTIFIED: ("teeth on lip", "tongue up")},
        usual={Phoneme.SILENCE: "rest"},
        phones={"teeth on lip": "v", "tongue up": "l"},
    )
    return replace(model, viseme_heads=heads, viseme_set=own)


def test_a_model_brings_visemes_of_its_own_in_its_file(tmp_path):
    save_model(with_own_visemes(tone_model(SOUNDS, visemes=SEEN)), tmp_path / "own.npz")
    with np.load(tmp_path / "own.npz") as file:
        assert int(file["format"]) == 4
    model = load_model(tmp_path / "own.npz")
    analysis = concatenate_analyses(heard(preset_of(model)))
    assert analysis.viseme_set.labels_of(analysis.visemes[[10, 35, 85]]) == ["rest", "teeth on lip", "tongue up"]
    runs = transcript_of([analysis], "tones", len(SOUND) / SAMPLE_RATE).runs
    assert [run.phone for run in runs if run.end - run.start > 0.05] == ["", "v", "", "l", ""]


def test_a_damaged_viseme_set_is_refused_in_one_sentence(tmp_path):
    save_model(with_own_visemes(tone_model(SOUNDS, visemes=SEEN)), tmp_path / "own.npz")
    for content in (b"[]", b"{}", b'{"names": 1}', b"\xff"):
        path = altered(tmp_path / "own.npz", viseme_set=np.frombuffer(content, np.uint8))
        with pytest.raises(ModelError, match=r"the model's file is damaged; get it anew"):
            load_model(path)


def test_a_mouth_closes_teeth_on_lip_where_an_f_is_heard(tmp_path):
    preset = preset_of(tone_model(SOUNDS, visemes=SEEN))
    runs = transcript_of(heard(preset), "tones", len(SOUND) / SAMPLE_RATE).runs
    assert [(run.phoneme, run.phone) for run in runs if run.end - run.start > 0.05] == [
        (Phoneme.SILENCE, ""),
        (Phoneme.UNIDENTIFIED, "f"),
        (Phoneme.SILENCE, ""),
        (Phoneme.UNIDENTIFIED, "n"),
        (Phoneme.SILENCE, ""),
    ]
    table = load_table("oculus")
    performer = Performer(table, MOUTH_ALONE)
    performer.add(timed_frames(concatenate_analyses(heard(preset)), len(SOUND) / SAMPLE_RATE))
    weights = performer.at(0.4).weights
    assert weights.argmax() == table.movestates.index("FF")
