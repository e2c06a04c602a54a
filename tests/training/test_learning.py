"""Training and adapting: networks against what the engine runs, examples against physics, voices against truth."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import torch

from phonemeengine.calibration.adaptation import adapt
from phonemeengine.calibration.fine_tuning import (
    N_SOFT_LABELS,
    NOT_SAID,
    VISEME_SHARE,
    Optimiser,
    TrainingExample,
    example_of,
)
from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.dsp.mel import N_BANDS, silent_log_mels
from phonemeengine.encoder.live import EncoderStream, build_live_encoder, open_live_encoder
from phonemeengine.encoder.weights import shapes_of
from phonemeengine.errors import CorpusError
from phonemeengine.labels.utterance import Label
from phonemeengine.labels.visemes import STANDARD_VISEMES, Viseme
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.model import Model, OutputHead
from phonemeengine.recognition.network import CentredNetwork, Network
from phonemeengine.settings import SAMPLE_RATE
from phonemetraining.augmentation import Augmentation, augment
from phonemetraining.config import TrainingConfig
from phonemetraining.examples import Examples, RecordingExample, examples_of, key_of, store
from phonemetraining.networks import SmallNetwork, TrainableEncoder, with_running_floor
from phonemetraining.spectra import SMALL_BANDS, WHISPER_BANDS, disturbed, warped
from phonemetraining.teacher import Groups, folds_of
from phonemetraining.training import SMOOTHING, cross_entropy, targets_of, train_encoder, train_small
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


Voice = tuple[str, list[TrainingExample]]
"""A name, and recordings."""


def voice(name: str, f0: float, tract: float) -> Voice:
    generator = np.random.default_rng(len(name))
    orders = [generator.permutation(list(FORMANTS) * 2) for _ in range(3)]
    return name, [said([Phoneme(int(p)) for p in order], f0, tract) for order in orders]


def examples_in(folder: Path, voices: list[Voice]) -> Examples:
    """Keep recordings in a folder; Whisper's bands are not known of them."""
    folder.mkdir(exist_ok=True)
    made = [
        (name, [RecordingExample(**vars(e), mels=np.zeros((len(e), 80), np.float16))])
        for name, said in voices
        for e in said
    ]
    store(folder, made)
    return Examples(folder, {})


def trained_on(examples: Examples, config: TrainingConfig, checkpoint: Path | None = None) -> Model:
    return train_small(examples, config, checkpoint=checkpoint).finished()


def accuracy_of(model: Model, voices: list[Voice]) -> float:
    """The share of frames that the model names right, with its longest look-ahead."""
    n_ahead, head, right = len(model.heads) - 1, model.heads[-1], []
    for example in (example for _, said in voices for example in said):
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
def voices():
    return [voice(f"{f0}", f0, tract) for f0, tract in ((110, 0.95), (150, 1.0), (200, 1.1))]


@pytest.fixture(scope="module")
def examples(voices, tmp_path_factory):
    return examples_in(tmp_path_factory.mktemp("examples"), voices)


@pytest.fixture(scope="module")
def model(voices, examples):
    return trained_on(examples, COURSE), voices


@pytest.fixture(scope="module")
def anchored(model, examples):
    return replace(model[0], anchors=examples.anchors("log_powers", 32, 150, 1))


@pytest.mark.parametrize("centred", [False, True])
def test_the_engine_finds_what_the_trained_network_finds(centred: bool):
    torch.manual_seed(1)
    network = SmallNetwork(6, (1, 2), 0.0, centred=centred)
    sound = torch.randn(1, 60, N_BANDS) * 2 - 6
    for _ in range(3):  # the normalisation follows the sound
        network.hidden(sound)
    with torch.no_grad():
        network.eval()
        expected = network(network.hidden(sound))[0, :, -1].numpy()
    done = network.finished()
    assert done.centred == centred
    kind = CentredNetwork if centred else Network
    before = np.full(N_BANDS, -6, np.float32)  # the mean, which reads 0, as where the training pads
    found = kind(done.layers, before).forward(sound[0].numpy())
    logits = np.concatenate([found @ h.weights + h.bias for h in (done.heads[-1], done.viseme_heads[-1])], axis=1)
    np.testing.assert_allclose(logits[10:50], expected[10:50], atol=0.02)


def test_the_optimiser_finds_the_bottom_of_a_bowl():
    place = np.array([[3.0, -2.0]], np.float32)
    optimiser = Optimiser([place], 400, 0.1)
    for _ in range(400):
        optimiser.step([2 * (place - np.float32(1))])
    np.testing.assert_allclose(place, 1, atol=0.02)


def test_a_network_learns_the_vowels_of_made_up_voices_and_names_those_of_another(model):
    trained, voices = model
    for group in (voices, [voice("another", 130, 1.05)]):
        assert accuracy_of(trained, group) > 0.9


SHORT = TrainingConfig(width=8, dilations=(1,), n_epochs=3, batch_size=2, n_frames=50)


@pytest.fixture(scope="module")
def short(examples):
    return trained_on(examples, SHORT)


@pytest.mark.long
def test_the_same_seed_trains_the_same_model(examples, short):
    assert trained_on(examples, SHORT) == short
    assert trained_on(examples, SHORT) != trained_on(examples, replace(SHORT, seed=2))


def test_an_interrupted_training_goes_on_and_ends_with_the_same_model(examples, short, tmp_path: Path):
    state, shares = tmp_path / "a.state", []

    def interrupt(share: float) -> None:
        if share > 0.5:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        train_small(examples, SHORT, checkpoint=state, on_progress=interrupt)
    resumed = train_small(examples, SHORT, checkpoint=state, on_progress=shares.append)
    assert shares[0] > 1 / 3
    assert resumed.finished() == short


# -- the encoder -------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def whisper_weights():
    """Weights of the shapes that Whisper base has, drawn at random."""
    generator = np.random.default_rng(0)
    return {
        name: (1 if name.endswith("gamma") else 0) + 0.02 * generator.standard_normal(shape).astype(np.float32)
        for name, shape in shapes_of(0).items()
    }


@pytest.fixture(scope="module")
def causal(whisper_weights):
    torch.manual_seed(0)
    network = TrainableEncoder(whisper_weights, 1).eval()
    network.make_causal(torch.randn(2, 320, 80))
    return network


def test_the_causal_encoder_neither_looks_far_back_nor_ahead(causal):
    generator = torch.Generator().manual_seed(1)
    mels = torch.randn(1, 800, 80, generator=generator)
    for n_ahead in (0, 1):
        base = causal.states(mels, n_ahead)
        changed = mels.clone()
        changed[:, 400:] += 1  # frames from 400 on are heard by states from 199 on, and by one more that looks ahead
        moved = (causal.states(changed, n_ahead) - base).abs().amax(dim=2)[0] > 1e-4
        assert int(moved.nonzero()[0]) == 199 - n_ahead
        changed = mels.clone()
        changed[:, :100] += 1
        moved = (causal.states(changed, n_ahead) - base).abs().amax(dim=2)[0] > 1e-4
        assert int(moved.nonzero()[-1]) == 50 + 150


def test_its_weights_are_those_that_the_engine_runs(causal):
    encoder = open_live_encoder(build_live_encoder(causal.finished(), bits=32))
    logarithms = torch.randn(1, 120, 80)
    logarithms[:, 0] = -10  # as before the sound
    with torch.no_grad():
        scaled = with_running_floor(logarithms, torch.full((1, 1), -2.0))
        for n_ahead in (0, 1):
            expected = causal(causal.states(scaled, n_ahead))[0].numpy()
            states = encoder.encode([EncoderStream(encoder, n_ahead)], [logarithms[0].numpy()])[0]
            found = encoder.head.logits(states)
            np.testing.assert_allclose(found[:-4], expected[: len(found) - 4], atol=1e-3)


def test_a_causal_encoder_is_what_it_was_once_its_weights_are_read(causal, whisper_weights):
    again = TrainableEncoder(whisper_weights, 1).eval()
    again.become_causal(causal.finished())
    mels = torch.randn(1, 100, 80)
    assert torch.equal(again.states(mels), causal.states(mels))


def test_an_encoder_learns_from_examples_and_teaches_the_small_network(voices, whisper_weights, tmp_path: Path):
    generator = np.random.default_rng(1)
    recordings = [
        (name, e, generator.normal(-4, 1, (len(e), 80)).astype(np.float16)) for name, s in voices for e in s
    ]
    store(tmp_path, [(name, [RecordingExample(**vars(e), mels=mels)]) for name, e, mels in recordings])
    examples = Examples(tmp_path, {})
    config = replace(
        SHORT, n_epochs=1, n_layers=1, n_encoder_epochs=1, encoder_batch=2, n_encoder_frames=400, n_frames=100
    )
    encoder = train_encoder(examples, config, whisper_weights)
    assert all(np.isfinite(array).all() for array in encoder.finished().values())
    assert train_small(examples, config, encoder).finished() != trained_on(examples, config)


# -- targets -----------------------------------------------------------------------------------------------


def targets(code: int, certainty: float, heard: list[float]) -> tuple[list[float], float]:
    wanted, weights = targets_of(
        torch.tensor([[code]], dtype=torch.uint8),
        torch.tensor([[heard]]),
        torch.tensor([1.0, 1, 2]),
        torch.tensor([[certainty]]),
    )
    return wanted[0, 0].tolist(), float(weights[0, 0])


def test_a_label_and_a_teacher_count_alike_and_each_alone_where_the_other_is_silent():
    nothing, teacher = [0.0, 0.0, 0.0], [0.1, 0.2, 0.7]
    wanted, weight = targets(0, 1.0, nothing)
    assert wanted == pytest.approx([0.95 + 0.05 / 3, 0.05 / 3, 0.05 / 3])
    assert weight == pytest.approx(1)
    both, weight = targets(0, 1.0, teacher)
    assert both == pytest.approx([(a + b) / 2 for a, b in zip(wanted, teacher, strict=True)], abs=1e-6)
    assert weight == pytest.approx(1)
    alone, weight = targets(255, 0.0, teacher)
    assert alone == pytest.approx(teacher)
    assert weight == pytest.approx(2)  # what the teacher hears is a rare sound
    assert targets(1, 0.0, nothing)[1] == 0


def test_who_takes_all_classes_to_be_alike_is_wrong_by_the_logarithm_of_their_number():
    batch = {
        "phonemes": torch.tensor([[Phoneme.A, Phoneme.I]], dtype=torch.uint8),
        "visemes": torch.tensor([[Viseme.AA, NOT_SAID]], dtype=torch.uint8),  # what counts is told of the first alone
        "certainties": torch.tensor([[1.0, 0.5]]),
        "soft_labels": torch.zeros(1, 2, N_SOFT_LABELS),
    }
    importance = [torch.ones(len(classes)) for classes in (Phoneme, Viseme)]
    error = cross_entropy(torch.zeros(1, 2, 1, N_SOFT_LABELS), batch, importance)
    assert float(error) == pytest.approx(np.log(len(Phoneme)) + VISEME_SHARE * np.log(len(Viseme)))
    late = torch.zeros(1, 2, 2, N_SOFT_LABELS)
    late[0, 1, 1, Phoneme.A] = 50  # the second head says at the second frame what the first one was
    late[0, 1, 1, len(Phoneme) + Viseme.AA] = 50
    assert float(cross_entropy(late, batch, importance, (0.0, 1.0))) == pytest.approx(
        50 * SMOOTHING * (1 / 1.5 * (1 - 1 / len(Phoneme)) + VISEME_SHARE * (1 - 1 / len(Viseme))), rel=1e-4
    )


# -- examples ----------------------------------------------------------------------------------------------


def test_a_faster_voice_is_shorter_and_higher():
    once = tone(1000, 1.0, 0.5)
    fast = augment(once, Augmentation(rate=1.2), np.random.default_rng(0))
    assert len(fast) == pytest.approx(len(once) / 1.2, abs=2)
    spectrum = np.abs(np.fft.rfft(fast))
    assert np.fft.rfftfreq(len(fast), 1 / SAMPLE_RATE)[spectrum.argmax()] == pytest.approx(1200, abs=3)


@pytest.mark.parametrize(("bands", "n"), [(SMALL_BANDS, 40), (WHISPER_BANDS, 80)])
def test_disturbed_speech_keeps_its_shape_and_is_never_below_the_floor(bands, n):
    torch.manual_seed(0)
    logarithms = torch.rand(6, 50, n) * 8 - 9
    heard = disturbed(logarithms, bands)
    assert heard.shape == logarithms.shape
    assert torch.isfinite(heard).all()
    assert heard.min() >= np.log10(bands.floor) - 1e-3
    assert np.corrcoef(heard[..., 10].ravel(), logarithms[..., 10].ravel())[0, 1] > 0.3


def test_a_warp_moves_a_peak_by_its_factor():
    torch.manual_seed(0)
    centres = np.array(SMALL_BANDS.centres)
    peak = torch.from_numpy(-((np.log2(centres / 1000) * 4) ** 2).astype(np.float32)).repeat(256, 3, 1)
    found = centres[warped(peak, SMALL_BANDS)[:, 0].argmax(dim=1)]
    assert 850 <= found.min() < 950
    assert found[found < 1200].max() > 1050
    assert 1300 < found.max() < 1700  # a child's
    assert 0.05 < (found > 1200).mean() < 0.3


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
    heard = np.zeros((30, N_SOFT_LABELS), np.float16)
    heard[:, Phoneme.A] = heard[:, len(Phoneme) + Viseme.AA] = 1
    example = example_of(tone(500, 0.3), (), soft_labels=heard)
    assert len(example) == 30
    assert set(example.phonemes.tolist()) == {NOT_SAID}
    assert not example.certainties.any()
    np.testing.assert_array_equal(example.soft_labels, heard)
    assert len(example_of(tone(500, 0.3), ())) == 0


def test_what_the_teacher_heard_goes_along_with_another_tempo(tmp_path: Path):
    """A sound of two halves, said faster: its examples change where the sound does, and so does what was heard."""
    halves = np.concatenate((tone(300, 0.6, 0.3), tone(3000, 0.4, 0.3)))
    put(tmp_path, "u", halves, (Label(0, 0.6, "a", Phoneme.A), Label(0.6, 1.0, "i", Phoneme.I)))
    utterance = LabelledUtterance(tmp_path / "u.wav", (), "s", "c")
    heard = np.zeros((100, N_SOFT_LABELS), np.float16)
    heard[:60, Phoneme.A] = heard[60:, Phoneme.I] = 1
    (made,) = examples_of([utterance], 6, 1, {key_of(utterance): heard})
    assert len({len(example) for example in made}) > 2
    for example in made:
        changes = np.flatnonzero(np.diff(example.soft_labels[:, Phoneme.A]))
        assert changes == pytest.approx([0.6 * len(example)], abs=2)


def test_every_speaker_is_left_out_once():
    names = [f"corpus/{k}" for k in range(7)]
    for n_folds in (2, 3, 7):
        assert sorted(name for fold in folds_of(names, n_folds) for name in fold) == names


def test_groups_come_from_a_file_or_are_dealt(tmp_path: Path):
    names = ["a/1", "a/2", "b/1"]
    file = tmp_path / "groups.toml"
    file.write_text('validation = ["a/1", "unknown/1"]\nreserved = ["b/1"]\n')
    assert Groups.of(names, file) == Groups(frozenset({"a/1"}), frozenset({"b/1"}))
    assert Groups.of(names).everybody == {"a/1"}
    assert "human_tuxpaint/bg" in Groups.of(["human_tuxpaint/bg", "human_tuxpaint/fr"]).reserved
    for text, words in (("validation = [", "groups are two lists"), ('validation = ["x"]', "none of its validation")):
        file.write_text(text)
        with pytest.raises(CorpusError, match=words):
            Groups.of(names, file)


def test_silence_reads_the_floor():
    np.testing.assert_allclose(silent_log_mels(1, 2), -11)


# -- one voice --------------------------------------------------------------------------------------------


def test_a_voice_with_other_formants_is_learned_from_ten_seconds(anchored, voices):
    trained = replace(anchored, warps=(0.8, 1.0, 1.2))
    strange = [said([Phoneme.A, Phoneme.U, Phoneme.I] * 2, 300, 1.5) for _ in range(4)]
    whole, _, mild = adapt(trained, strange)
    other = "same", [said([Phoneme.I, Phoneme.A, Phoneme.U] * 2, 310, 1.5)]
    assert whole.warps == mild.warps == (1.0,)  # they know the speaker's vocal tract
    assert accuracy_of(whole, [other]) > accuracy_of(trained, [other]) + 0.05
    for adapted in (whole, mild):
        assert accuracy_of(adapted, voices) > 0.8  # the anchors keep what was learned before


def test_takes_teach_even_where_each_sound_was_said_once(anchored):
    trained = anchored
    takes = [said([phoneme] * 4, 300, 1.5) for phoneme in (Phoneme.A, Phoneme.U, Phoneme.I)]
    other = "same", [said([Phoneme.I, Phoneme.A, Phoneme.U] * 2, 310, 1.5)]
    assert accuracy_of(adapt(trained, takes)[0], [other]) > accuracy_of(trained, [other])


def test_a_phoneme_that_was_not_said_stays_as_likely_as_it_was(model):
    trained, _ = model
    whole, *_ = adapt(trained, [said([Phoneme.A, Phoneme.U] * 3, 300, 1.5) for _ in range(4)])
    for head, moved in zip(trained.heads, whole.heads, strict=True):
        np.testing.assert_allclose(moved.weights[:, Phoneme.I], head.weights[:, Phoneme.I], atol=1e-3)


def test_some_vowels_alone_teach_no_vowel_lest_all_others_become_them(anchored):
    trained = replace(anchored, warps=(0.8, 1.0, 1.2))
    few = [said([Phoneme.A, Phoneme.A], 300, 1.5) for _ in range(4)]
    other = "same", [said([Phoneme.I, Phoneme.U] * 3, 310, 1.5)]
    for adapted in adapt(replace(trained, about={"name": "all", "by_look_ahead_ms": {"50": [0.7, 0.8]}}), few):
        assert (adapted.about, adapted.by_look_ahead) == ({"name": "all"}, {})  # figures were those of the other one
        assert adapted.warps == trained.warps
        assert accuracy_of(adapted, [other]) > accuracy_of(trained, [other]) - 0.01


def test_the_visemes_of_a_voice_are_learned_with_its_phonemes(anchored):
    trained = anchored
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
    with pytest.raises(CorpusError, match=r"are not enough to adapt to; record 2 s or more of several phonemes"):
        adapt(tone_model({700.0: Phoneme.A}), examples)


def test_what_is_trained_fits_into_its_file(model, tmp_path: Path):
    from phonemeengine.recognition.model import load_model, save_model

    trained, _ = model
    save_model(trained, tmp_path / "m.npz")
    assert load_model(tmp_path / "m.npz") == trained
