"""The workbench: what it says at once is what the analyser says of the files."""

from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

import numpy as np
import pytest
import soundfile
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.calibration.scores.evaluation import predict, score
from phonemeengine.calibration.scores.scoring import ConfusedSegment, confusion_of
from phonemeengine.calibration.workbench.labelled_features import LabelledFeatures
from phonemeengine.dsp.mel import N_BANDS
from phonemeengine.errors import AudioError, CorpusError
from phonemeengine.execution import Cancelled
from phonemeengine.features.variables import Variable
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import FACTORY, load_preset
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.model import Model, OutputHead
from phonemeengine.recognition.network import TAPS, Layer
from phonemeengine.recognition.rules import Condition, Rule
from phonemeengine.settings import Filter
from tests.labelled import SAID, recording, recordings

THESIS = load_preset(FACTORY / "thesis.toml")
A, E, I, O, U = Phoneme.A, Phoneme.E, Phoneme.I, Phoneme.O, Phoneme.U  # noqa: E741
SILENCE, SZ = Phoneme.SILENCE, Phoneme.SZ
OWN = replace(
    THESIS,
    recogniser="rules",
    variables=(Variable("low", 200, 900), Variable("high", 4000, 9000)),
    rules=(
        Rule(SILENCE, (Condition("volume", "<", limit=0.01),)),
        Rule(SZ, (Condition("high", ">", limit=20.0), Condition("low", "<", limit=8.0))),
        Rule(A, (Condition("m_ae1", ">", limit=0.2),)),
        Rule(U, (Condition("low", ">", limit=6.0),)),
    ),
)
QUICK = settings(max_examples=15, suppress_health_check=[HealthCheck.function_scoped_fixture])


@pytest.fixture(scope="module")
def utterances(tmp_path_factory: pytest.TempPathFactory) -> tuple[LabelledUtterance, ...]:
    return recordings(tmp_path_factory.mktemp("recordings"))


@pytest.fixture(scope="module")
def bench(utterances: tuple[LabelledUtterance, ...]) -> LabelledFeatures:
    return LabelledFeatures(utterances, THESIS)


@pytest.fixture(scope="module")
def own_bench(utterances: tuple[LabelledUtterance, ...]) -> LabelledFeatures:
    return LabelledFeatures(utterances, OWN)


def plainly(utterances: tuple[LabelledUtterance, ...], preset: Preset) -> list[int]:
    return [code for utterance in utterances for code in predict(utterance, preset).phonemes.tolist()]


def tiny_model(seed: int = 1) -> Model:
    """A network of one layer that says whatever chance has made it say."""
    generator = np.random.default_rng(seed)
    weights = generator.normal(0, 0.1, (TAPS * N_BANDS, 8)).astype(np.float32)
    heads = tuple(
        OutputHead(generator.normal(0, 1, (8, len(Phoneme))).astype(np.float32), np.zeros(len(Phoneme), np.float32))
        for _ in range(4)
    )
    return Model((Layer(weights, np.zeros(8, np.float32), 1),), heads)


@QUICK
@given(
    limit=st.floats(0.01, 1.0),
    o=st.floats(0.5, 8.0),
    hold=st.integers(0, 6),
    statistics=st.booleans(),
    hysteresis=st.sampled_from([0, 0.1, 0.5]),
    heir=st.sampled_from(list(Phoneme)),
)
def test_a_new_threshold_says_what_the_analyser_says_of_the_files(
    bench, utterances, limit, o, hold, hysteresis, statistics, heir
):
    preset = replace(
        THESIS,
        thresholds=replace(THESIS.thresholds, ae_ae1=limit, o_o1=o, silence_energy=limit),
        settings=replace(THESIS.settings, minimum_hold=hold / 100, hysteresis=hysteresis, statistics=statistics),
        successors=dict(THESIS.successors) | {A: heir},
    )
    assert not bench.needs_measuring(preset)
    assert bench.confusion(preset).predicted.tolist() == plainly(utterances, preset)


@QUICK
@given(low=st.floats(1.0, 12.0), high=st.floats(1.0, 60.0), hysteresis=st.sampled_from([0, 0.2]))
def test_new_limits_of_own_rules_say_what_the_analyser_says(own_bench, utterances, low, high, hysteresis):
    rules = (
        *OWN.rules[:1],
        Rule(SZ, (Condition("high", ">", limit=high), Condition("low", "<", limit=8.0))),
        *OWN.rules[2:3],
        Rule(U, (Condition("low", ">", limit=low),)),
        Rule(O, (Condition("low", ">", limit=low / 2),)),
    )
    preset = replace(OWN, rules=rules, settings=replace(OWN.settings, hysteresis=hysteresis))
    assert own_bench.confusion(preset).predicted.tolist() == plainly(utterances, preset)


@pytest.mark.parametrize("look_ahead", [0.0, 0.03])
def test_a_learned_recogniser_is_heard_once_and_what_tunes_it_acts_at_once(utterances, look_ahead):
    preset = replace(
        THESIS, recogniser="learned", model=tiny_model(), settings=replace(THESIS.settings, look_ahead=look_ahead)
    )
    bench = LabelledFeatures(utterances, preset)
    for hold, hysteresis, sensitivities in ((0.0, 0.0, {}), (0.05, 0.0, {A: 1.5}), (0.03, 0.3, {A: -4.0, O: 2.0})):
        settings = replace(preset.settings, minimum_hold=hold, hysteresis=hysteresis)
        changed = replace(preset, settings=settings, sensitivities=sensitivities)
        assert not bench.needs_measuring(changed)
        assert bench.predict(changed).tolist() == plainly(utterances, changed)
    assert bench.needs_measuring(replace(preset, model=tiny_model(2)))
    assert bench.needs_measuring(replace(preset, settings=replace(preset.settings, look_ahead=0.01)))
    assert not bench.needs_measuring(replace(preset, thresholds=replace(preset.thresholds, ae_ae1=0.7)))
    assert not bench.needs_measuring(replace(THESIS, settings=preset.settings))
    assert bench.predict(THESIS).tolist() == plainly(utterances, THESIS)


def test_a_recogniser_of_another_package_is_asked_while_measuring(utterances, loudness):
    preset = replace(THESIS, recogniser="loudness")
    bench = LabelledFeatures(utterances, preset)
    assert bench.predict(preset).tolist() == plainly(utterances, preset)
    assert bench.needs_measuring(replace(preset, thresholds=replace(preset.thresholds, silence_energy=0.3)))


def test_only_what_changes_the_variables_needs_measuring(bench):
    same = replace(THESIS.settings, minimum_hold=0.1, hysteresis=0.3, look_ahead=0.0, statistics=False)
    assert not bench.needs_measuring(replace(THESIS, settings=same, name="x", rules=OWN.rules[:1]))
    others = (
        replace(THESIS, variables=(Variable("low", 200, 900),)),
        replace(THESIS, settings=replace(THESIS.settings, filters=THESIS.settings.filters - {Filter.NORMALISE})),
        replace(THESIS, settings=replace(THESIS.settings, denoise_threshold=0.01)),
        replace(THESIS, recogniser="learned", model=tiny_model()),
    )
    assert all(bench.needs_measuring(other) for other in others)
    with pytest.raises(CorpusError, match="measured anew"):
        bench.confusion(others[0])


def test_the_counts_and_figures_are_those_of_scoring_the_files(bench, utterances):
    scored = score(THESIS, utterances)
    confusion = bench.confusion(THESIS)
    assert confusion.counts.tolist() == scored.overall.confusion.tolist()
    assert confusion.agreement.accuracy == scored.overall.scores.accuracy
    assert confusion.agreement.macro_f1 == pytest.approx(scored.overall.scores.macro_f1, abs=1e-12)
    assert confusion.agreement.f1_of(A) == pytest.approx(scored.overall.f1_of(A), abs=1e-12)
    assert np.isnan(confusion.agreement.f1_of(Phoneme.M))  # no label has it
    assert confusion.scores() == pytest.approx(scored.overall.scores)
    assert confusion.agreement.changes_per_s == pytest.approx(scored.overall.scores.changes_per_s)
    assert confusion.agreement.label_changes_per_s == pytest.approx(scored.overall.scores.label_changes_per_s)
    line = [confusion.line(k).tolist() for k in range(confusion.n_recordings)]
    assert line == [heard.phonemes.tolist() for heard in scored.predictions]
    part = confusion.scores((1,))
    assert part.minutes == pytest.approx(scored.overall.scores.minutes / 4)


def test_frames_labelled_as_none_of_the_ten_are_counted_but_not_scored(tmp_path):
    heard = recording(tmp_path / "a.wav", [A, SILENCE, SZ, A])
    labels = (*heard.labels[:3], replace(heard.labels[3], phoneme=Phoneme.UNIDENTIFIED))
    half_known = replace(heard, labels=labels)
    always_a = replace(THESIS, recogniser="rules", rules=(Rule(A, ()),))
    confusion = LabelledFeatures([half_known], always_a).confusion(always_a)
    assert confusion.counts[:, A].tolist()[:2] == [30, 30]
    assert confusion.agreement.accuracy == pytest.approx(1 / 3)
    assert confusion.agreement.f1_of(A) == pytest.approx(2 * 30 / (30 + 90))
    assert confusion.agreement.macro_f1 == pytest.approx(score(always_a, [half_known]).overall.scores.macro_f1)
    assert np.isnan(confusion.agreement.f1_of(Phoneme.UNIDENTIFIED))


def test_what_was_measured_otherwise_is_measured_again(bench, utterances):
    bare = replace(THESIS, settings=replace(THESIS.settings, filters=frozenset({Filter.NORMALISE})))
    assert LabelledFeatures(utterances, bare, known=bench).predict(bare).tolist() == plainly(utterances, bare)


def test_the_frames_of_a_cell_are_where_the_label_and_the_answer_are_those(bench):
    confusion = bench.confusion(THESIS)
    for truth in Phoneme:
        for answer in Phoneme:
            passages = confusion.frames_in(truth, answer)
            n = 0
            for passage in passages:
                first, end = round(passage.start * 100), round(passage.end * 100)
                assert set(confusion.label_line(passage.recording)[first:end].tolist()) == {truth}
                assert set(confusion.line(passage.recording)[first:end].tolist()) == {answer}
                n += end - first
            assert n == confusion.counts[truth, answer]


def test_stretches_of_a_cell_end_where_their_recording_does(tmp_path):
    quiet = [recording(tmp_path / f"{k}.wav", [SILENCE], 0.5) for k in range(3)]
    deaf = replace(THESIS, recogniser="rules", rules=(Rule(SILENCE, ()),))
    confusion = LabelledFeatures(quiet, deaf).confusion(deaf)
    assert confusion.frames_in(SILENCE, SILENCE) == tuple(ConfusedSegment(k, 0.0, 0.5) for k in range(3))
    assert confusion.frames_in(SILENCE, A) == ()


def test_what_is_labelled_after_the_end_of_a_sound_is_silence(tmp_path):
    whole = recording(tmp_path / "a.wav", [A, A])
    samples, rate = soundfile.read(whole.path)
    soundfile.write(whole.path, samples[: len(samples) // 2], rate, subtype="FLOAT")
    always_a = replace(THESIS, recogniser="rules", rules=(Rule(A, ()),))
    confusion = LabelledFeatures([whole], always_a).confusion(always_a)
    assert confusion.line(0).tolist() == predict(whole, always_a).phonemes.tolist() == [A] * 30 + [SILENCE] * 30


def test_what_was_measured_is_not_measured_again(utterances, tmp_path):
    moved = recording(tmp_path / "own.wav", SAID, speaker="cyd")
    told: list[float] = []
    first = LabelledFeatures([moved, *utterances], THESIS)
    again = LabelledFeatures(
        [*utterances, moved], THESIS, known=first, progress=lambda share: told.append(share) is None
    )
    assert told == [0.0, 1.0]
    assert again.predict(THESIS).tolist() == plainly((*utterances, moved), THESIS)
    recording(moved.path, SAID[::-1], speaker="cyd", pitch=200.0, level=0.1)
    changed = LabelledFeatures([moved], THESIS, known=again)
    assert changed.predict(THESIS).tolist() == plainly((moved,), THESIS)


def test_measuring_says_how_far_it_is_and_ends_when_it_shall(utterances):
    told: list[float] = []
    LabelledFeatures(utterances, THESIS, progress=lambda share: told.append(share) is None)
    assert told == sorted(told)
    assert (told[0], told[-1]) == (0.0, 1.0)
    with pytest.raises(Cancelled):
        LabelledFeatures(utterances, THESIS, progress=lambda share: share < 0.5)


def test_a_twin_answers_the_same_while_another_thread_asks(bench):
    twin, presets = (
        bench.clone_for_thread(),
        [replace(THESIS, thresholds=replace(THESIS.thresholds, ae_ae1=limit)) for limit in (0.1, 0.3, 0.5, 0.7)],
    )
    expected = [bench.predict(preset).tolist() for preset in presets]
    with ThreadPoolExecutor(2) as threads:
        one = threads.submit(lambda: [bench.predict(p).tolist() for p in presets * 20])
        other = threads.submit(lambda: [twin.predict(p).tolist() for p in presets[::-1] * 20])
        assert one.result() == expected * 20
        assert other.result() == expected[::-1] * 20


def test_without_recordings_there_is_nothing_to_count():
    confusion = LabelledFeatures((), THESIS).confusion(THESIS)
    assert confusion.counts.sum() == 0
    figures = confusion.agreement
    assert np.isnan([figures.accuracy, figures.macro_f1, figures.f1_of(A), figures.changes_per_s]).all()
    assert confusion.frames_in(A, A) == ()
    assert confusion.n_recordings == 0


def test_a_sound_that_is_gone_is_told(tmp_path):
    gone = replace(recording(tmp_path / "a.wav"), path=tmp_path / "b.wav")
    with pytest.raises(AudioError, match=r"b\.wav"):
        LabelledFeatures([gone], THESIS)


def test_a_variable_that_was_not_measured_is_told(bench):
    assert bench.values("volume").shape == (bench.edges[-1],)
    with pytest.raises(CorpusError, match="'nonsense' was not measured"):
        bench.values("nonsense")


def test_counts_are_frames_by_label_and_answer(bench):
    confusion = bench.confusion(THESIS)
    assert confusion.counts.tolist() == confusion_of(confusion.labels.phonemes, confusion.predicted).tolist()
    assert confusion.counts[A].sum() == 4 * 30
