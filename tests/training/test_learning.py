"""Training and adapting: gradients against differences, examples against physics, made-up voices against truth."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from phonemeengine.calibration.adaptation import adapt
from phonemeengine.calibration.fine_tuning import Optimiser, orthogonalised
from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.calibration.training_examples import N_HEARD, NOT_SAID, TrainingExample, example_of
from phonemeengine.dsp.log_mel import N_BANDS, silent_log_mels
from phonemeengine.errors import CorpusError
from phonemeengine.labels.label import Label
from phonemeengine.labels.visemes import STANDARD_VISEMES, Viseme
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.model import Model, OutputHead
from phonemeengine.recognition.network import Network
from phonemeengine.settings import SAMPLE_RATE
from phonemetraining.augmentation import Augmentation, augment, augment_spectra
from phonemetraining.examples import SpeakerExamples, examples_of, key_of
from phonemetraining.trainable_network import Targets, TrainableLayer, TrainableNetwork, targets_of
from phonemetraining.training import Checkpoint, ExponentialAverage, TrainingConfig, train
from phonemetraining.validation import anchors_of, folds_of
from tests.corpora import put
from tests.models import tone_model
from tests.sounds import noise, tone, vowel

FORMANTS = {Phoneme.A: (750, 1300), Phoneme.I: (280, 2300), Phoneme.U: (310, 800)}
COURSE = TrainingConfig(width=32, dilations=(1, 2), n_epochs=20, batch_size=4, n_frames=100, rate=5e-3)


def said(phonemes: list[Phoneme], f0: float, tract: float, seconds: float = 0.3) -> TrainingExample:
    """A made-up voice says vowels, with pauses of faint noise between them."""
    parts, labels, at = [], [], 0.0
    for phoneme in phonemes:
        pause = noise(0.15, 1e-4, seed=len(parts))
        sound = vowel(tuple(f * tract for f in FORMANTS[phoneme]), seconds, f0)
        for part, name in ((pause, Phoneme.SILENCE), (sound, phoneme)):
            parts.append(part)
            labels.append(Label(at, at + len(part) / SAMPLE_RATE, name.label, name))
            at += len(part) / SAMPLE_RATE
    return example_of(np.concatenate(parts), tuple(labels))


def voice(name: str, f0: float, tract: float) -> SpeakerExamples:
    generator = np.random.default_rng(len(name))
    orders = [generator.permutation(list(FORMANTS) * 2) for _ in range(3)]
    return SpeakerExamples(name, tuple((said([Phoneme(int(p)) for p in order], f0, tract),) for order in orders))


def accuracy_of(model: Model, voices: list[SpeakerExamples]) -> float:
    """The share of frames that the model names right, with its longest look-ahead."""
    n_ahead, head, right = len(model.heads) - 1, model.heads[-1], []
    for example in (recording[0] for voice in voices for recording in voice.recordings):
        heard = np.concatenate((example.log_powers.astype(np.float32), silent_log_mels(n_ahead)))
        found = Network(model.layers, silent_log_mels()).forward(heard)[n_ahead:]
        right.append((found @ head.weights + head.bias).argmax(axis=1) == example.phonemes)
    return float(np.concatenate(right).mean())


def viseme_accuracy_of(model: Model, example: TrainingExample) -> float:
    """The share of frames of which the model tells the viseme, as far as the labels do."""
    n_ahead, head = len(model.heads) - 1, model.viseme_heads[-1]
    heard = np.concatenate((example.log_powers.astype(np.float32), silent_log_mels(n_ahead)))
    found = Network(model.layers, silent_log_mels()).forward(heard)[n_ahead:]
    known = example.visemes < len(Viseme)
    return float(((found @ head.weights + head.bias).argmax(axis=1) == example.visemes)[known].mean())


@pytest.fixture(scope="module")
def model():
    voices = [voice(f"{f0}", f0, tract) for f0, tract in ((110, 0.95), (150, 1.0), (200, 1.1))]
    trained = train(voices, COURSE)
    return trained, voices


@pytest.mark.parametrize("centred", [False, True])
def test_the_gradients_are_those_of_small_differences(centred: bool):
    generator = np.random.default_rng(1)
    network = TrainableNetwork(6, (1, 2), 0.0, generator, centred=centred)
    sound = generator.normal(-6, 2, (2, 16, N_BANDS)).astype(np.float32)
    phonemes, visemes = (
        Targets(generator.dirichlet(np.ones(n), (2, 16)).astype(np.float32), generator.random((2, 16), np.float32))
        for n in (len(Phoneme), len(Viseme))
    )
    network.learn(sound, phonemes, visemes)
    gradients = [g.copy() for g in network.gradients]
    for value, gradient in zip(network.values, gradients, strict=True):
        direction = generator.standard_normal(value.shape).astype(np.float32)
        direction *= np.float32(0.005) / np.linalg.norm(direction)
        losses = []
        for sign in (1, -2, 1):
            np.add(value, np.float32(sign) * direction, out=value)
            losses.append(network.learn(sound, phonemes, visemes))
        expected = (losses[0] - losses[1]) / 2  # the step is short, since a rectifier bends
        assert float(np.vdot(gradient, direction)) == pytest.approx(expected, rel=0.05, abs=2e-5)


def test_a_finished_layer_gives_what_the_trained_one_gave():
    generator = np.random.default_rng(2)
    layer = TrainableLayer(5, 4, 2, residual=False, dropout=0.0, generator=generator)
    block = generator.standard_normal((1, 300, 5)).astype(np.float32)
    for _ in range(1500):
        given = layer.forward(block)
    done = layer.finished()
    padded = np.concatenate((np.zeros((4, 5), np.float32), block[0]))
    taps = np.concatenate([padded[k : k + 300] for k in (0, 2, 4)], axis=1)
    np.testing.assert_allclose(np.maximum(taps @ done.weights + done.bias, 0), given[0], atol=1e-3)


def test_the_optimiser_finds_the_bottom_of_a_bowl_and_the_average_follows():
    place = np.array([[3.0, -2.0]], np.float32)
    optimiser, average = Optimiser([place], 400, 0.1), ExponentialAverage([place])
    for _ in range(400):
        optimiser.step([2 * (place - np.float32(1))])
        average.update()
    np.testing.assert_allclose(place, 1, atol=0.02)
    np.testing.assert_allclose(average.means[0], 1, atol=0.3)


def test_an_orthogonalised_matrix_has_the_same_singular_vectors_and_equal_values():
    generator = np.random.default_rng(3)
    for shape in ((6, 4), (4, 6)):
        matrix = generator.normal(size=shape).astype(np.float32)
        left, _, right = np.linalg.svd(matrix, full_matrices=False)
        inner = left.T @ orthogonalised(matrix) @ right.T
        values = np.diag(inner)
        assert ((values > 0.6) & (values < 1.3)).all()
        np.testing.assert_allclose(inner, np.diag(values), atol=1e-4)


def test_hidden_matrices_find_the_bottom_of_a_bowl_too():
    place = np.diag([2.0, -1.0]).astype(np.float32)
    optimiser = Optimiser([place], 400, 0.02, hidden={0})
    for _ in range(400):
        optimiser.step([2 * (place - np.float32(0.5))])
    np.testing.assert_allclose(place, 0.5, atol=0.02)


def test_a_network_learns_the_vowels_of_made_up_voices_and_names_those_of_another(model):
    trained, voices = model
    for group in (voices, [voice("another", 130, 1.05)]):
        assert accuracy_of(trained, group) > 0.9


def test_the_same_seed_trains_the_same_model():
    voices = [voice("one", 120, 1.0)]
    short = TrainingConfig(width=8, dilations=(1,), n_epochs=1, batch_size=2, n_frames=50)
    assert train(voices, short) == train(voices, short)
    assert train(voices, short) != train(voices, TrainingConfig(**{**short.__dict__, "seed": 2}))


def test_an_interrupted_training_goes_on_and_ends_with_the_same_model(tmp_path: Path):
    voices = [voice("one", 120, 1.0)]
    config = TrainingConfig(width=8, dilations=(1,), n_epochs=3, batch_size=2, n_frames=50)

    def interrupt(step: int, n_steps: int, _loss: float) -> None:
        if step > n_steps / 2:
            raise KeyboardInterrupt

    steps = []
    checkpoint = Checkpoint(tmp_path / "state.npz")
    with pytest.raises(KeyboardInterrupt):
        train(voices, config, interrupt, checkpoint)
    resumed = train(voices, config, lambda step, _n, _loss: steps.append(step), checkpoint)
    assert steps[0] > 1
    assert resumed == train(voices, config)


# -- targets -----------------------------------------------------------------------------------------------


def targets(code: int, certainty: float, heard: list[float]) -> tuple[list[float], float]:
    found = targets_of(
        np.array([[code]], np.uint8),
        np.array([[heard]], np.float32),
        np.array([1, 1, 2], np.float32),
        np.array([[certainty]], np.float32),
    )
    return found.wanted[0, 0].tolist(), float(found.weights[0, 0])


def test_a_label_and_a_teacher_count_alike_and_each_alone_where_the_other_is_silent():
    nothing, teacher = [0.0, 0.0, 0.0], [0.1, 0.2, 0.7]
    wanted, weight = targets(0, 1.0, nothing)
    assert wanted == pytest.approx([0.95 + 0.05 / 3, 0.05 / 3, 0.05 / 3])
    assert weight == 1
    both, weight = targets(0, 1.0, teacher)
    assert both == pytest.approx([(a + b) / 2 for a, b in zip(wanted, teacher, strict=True)], abs=1e-6)
    assert weight == 1
    alone, weight = targets(255, 0.0, teacher)
    assert alone == pytest.approx(teacher)
    assert weight == 2  # what the teacher hears is a rare sound
    assert targets(1, 0.0, nothing)[1] == 0


# -- examples ----------------------------------------------------------------------------------------------


def test_a_faster_voice_is_shorter_and_higher():
    once = tone(1000, 1.0, 0.5)
    fast = augment(once, Augmentation(rate=1.2), np.random.default_rng(0))
    assert len(fast) == pytest.approx(len(once) / 1.2, abs=2)
    spectrum = np.abs(np.fft.rfft(fast))
    assert np.fft.rfftfreq(len(fast), 1 / SAMPLE_RATE)[spectrum.argmax()] == pytest.approx(1200, abs=3)


def test_disturbed_speech_keeps_its_shape_and_is_never_below_the_floor():
    generator = np.random.default_rng(0)
    powers = (10 ** generator.uniform(-9, -1, (6, 50, N_BANDS))).astype(np.float32)
    heard = augment_spectra(powers, generator)
    assert heard.shape == powers.shape
    assert heard.dtype == np.float32
    assert np.isfinite(heard).all()
    assert heard.min() >= -11.001
    assert np.corrcoef(heard[..., 10].ravel(), np.log10(powers[..., 10]).ravel())[0, 1] > 0.3


def test_trimmed_frames_count_for_nothing_and_ambiguous_ones_less():
    labels = (
        Label(0, 0.1, "a", Phoneme.A),
        Label(0.1, 0.2, "a", Phoneme.A, "ambiguous"),
        Label(0.2, 0.3, "", Phoneme.UNIDENTIFIED, "trimmed"),
    )
    example = example_of(tone(500, 0.3), labels)
    np.testing.assert_allclose(example.certainties, np.repeat([1, 0.6, 0], 10), atol=1e-3)
    assert len(example) == len(example.log_powers) == 30


def test_a_recording_without_labels_teaches_what_the_teacher_heard():
    heard = np.zeros((30, N_HEARD), np.float16)
    heard[:, Phoneme.A] = heard[:, len(Phoneme) + Viseme.AA] = 1
    example = example_of(tone(500, 0.3), (), heard=heard)
    assert len(example) == 30
    assert set(example.phonemes.tolist()) == {NOT_SAID}
    assert not example.certainties.any()
    np.testing.assert_array_equal(example.heard, heard)
    assert len(example_of(tone(500, 0.3), ())) == 0


def test_what_the_teacher_heard_goes_along_with_another_tempo(tmp_path: Path):
    """A sound of two halves, said faster: its examples change where the sound does, and so does what was heard."""
    halves = np.concatenate((tone(300, 0.6, 0.3), tone(3000, 0.4, 0.3)))
    put(tmp_path, "u", halves, (Label(0, 0.6, "a", Phoneme.A), Label(0.6, 1.0, "i", Phoneme.I)))
    utterance = LabelledUtterance(tmp_path / "u.wav", (), "s", "c")
    heard = np.zeros((100, N_HEARD), np.float16)
    heard[:60, Phoneme.A] = heard[60:, Phoneme.I] = 1
    (made,) = examples_of([utterance], 6, 1, {key_of(utterance): heard})
    assert len({len(example) for example in made}) > 2
    for example in made:
        changes = np.flatnonzero(np.diff(example.heard[:, Phoneme.A]))
        assert changes == pytest.approx([0.6 * len(example)], abs=2)


@pytest.mark.parametrize("n_folds", [2, 3, 7])
def test_every_speaker_is_left_out_once(n_folds):
    names = [f"corpus/{k}" for k in range(7)]
    folds = folds_of(names, n_folds)
    assert sorted(name for fold in folds for name in fold) == names


def test_silence_reads_the_floor():
    np.testing.assert_allclose(silent_log_mels(1, 2), -11)


# -- one voice --------------------------------------------------------------------------------------------


def test_a_voice_with_other_formants_is_learned_from_ten_seconds(model):
    trained, voices = model
    trained = replace(trained, anchors=anchors_of(voices, 1), warps=(0.8, 1.0, 1.2))
    strange = [said([Phoneme.A, Phoneme.U, Phoneme.I] * 2, 300, 1.5) for _ in range(4)]
    whole, _, mild = adapt(trained, strange)
    other = SpeakerExamples("same", ((said([Phoneme.I, Phoneme.A, Phoneme.U] * 2, 310, 1.5),),))
    assert whole.warps == mild.warps == (1.0,)  # they know the speaker's vocal tract
    assert accuracy_of(whole, [other]) > accuracy_of(trained, [other]) + 0.05
    for adapted in (whole, mild):
        assert accuracy_of(adapted, voices) > 0.8  # the anchors keep what was learned before


def test_takes_teach_even_where_each_sound_was_said_once(model):
    trained, voices = model
    trained = replace(trained, anchors=anchors_of(voices, 1))
    takes = [said([phoneme] * 4, 300, 1.5) for phoneme in (Phoneme.A, Phoneme.U, Phoneme.I)]
    other = SpeakerExamples("same", ((said([Phoneme.I, Phoneme.A, Phoneme.U] * 2, 310, 1.5),),))
    assert accuracy_of(adapt(trained, takes)[0], [other]) > accuracy_of(trained, [other])


def test_a_phoneme_that_was_not_said_stays_as_likely_as_it_was(model):
    trained, _ = model
    whole, *_ = adapt(trained, [said([Phoneme.A, Phoneme.U] * 3, 300, 1.5) for _ in range(4)])
    for head, moved in zip(trained.heads, whole.heads, strict=True):
        np.testing.assert_allclose(moved.weights[:, Phoneme.I], head.weights[:, Phoneme.I], atol=1e-3)


def test_some_vowels_alone_teach_no_vowel_lest_all_others_become_them(model):
    trained, voices = model
    trained = replace(trained, anchors=anchors_of(voices, 1), warps=(0.8, 1.0, 1.2))
    few = [said([Phoneme.A, Phoneme.A], 300, 1.5) for _ in range(4)]
    other = SpeakerExamples("same", ((said([Phoneme.I, Phoneme.U] * 3, 310, 1.5),),))
    for adapted in adapt(replace(trained, about={"name": "all", "by_look_ahead_ms": {"50": [0.7, 0.8]}}), few):
        assert (adapted.about, adapted.by_look_ahead) == ({"name": "all"}, {})  # figures were those of the other one
        assert adapted.warps == trained.warps
        assert accuracy_of(adapted, [other]) > accuracy_of(trained, [other]) - 0.01


def test_the_visemes_of_a_voice_are_learned_with_its_phonemes(model):
    trained, voices = model
    trained = replace(trained, anchors=anchors_of(voices, 1))
    strange = [said([Phoneme.A, Phoneme.U, Phoneme.I] * 2, 300, 1.5) for _ in range(4)]
    whole, *_ = adapt(trained, strange)
    other = said([Phoneme.I, Phoneme.A, Phoneme.U] * 2, 310, 1.5)
    assert viseme_accuracy_of(whole, other) > viseme_accuracy_of(trained, other)
    turned = replace(STANDARD_VISEMES, names=STANDARD_VISEMES.names[::-1])
    heads = tuple(OutputHead(head.weights[:, ::-1], head.bias[::-1]) for head in trained.viseme_heads)
    same, *_ = adapt(replace(trained, viseme_heads=heads, viseme_set=turned), strange)
    for a, b in zip(same.viseme_heads, whole.viseme_heads, strict=True):
        np.testing.assert_allclose(a.weights[:, ::-1], b.weights, atol=0.02)
    phonemes_alone = replace(trained, viseme_heads=())
    assert adapt(phonemes_alone, strange)[0].viseme_heads == ()


@pytest.mark.parametrize("examples", [[], [said([Phoneme.A], 120, 1.0)]])
def test_too_little_to_adapt_to_is_refused_with_what_to_give(examples):
    with pytest.raises(CorpusError, match=r"are too little to adapt to; give 2 s or more of several phonemes"):
        adapt(tone_model({700.0: Phoneme.A}), examples)


def test_what_is_trained_fits_into_its_file(model, tmp_path: Path):
    from phonemeengine.recognition.model import load_model, save_model

    trained, _ = model
    save_model(trained, tmp_path / "m.npz")
    assert load_model(tmp_path / "m.npz") == trained
