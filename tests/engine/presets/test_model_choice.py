"""The model for files: the offline model of a preset, Whisper, or the real-time model."""

import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import soundfile

from phonemeengine import cues, transcribe
from phonemeengine.alignment.evidence import evidence_of
from phonemeengine.analyser import (
    Analyser,
    Analysis,
    analyse_blocks,
    analyse_file,
    analyse_range,
    concatenate_analyses,
)
from phonemeengine.audio.files import SoundReader
from phonemeengine.encoder.model_folder import FOLDER_VARIABLE
from phonemeengine.errors import PresetError
from phonemeengine.labels.visemes import STANDARD_VISEMES
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import beyond_phoneme_data, load_preset, save_preset
from phonemeengine.presets.model_choice import for_files, model_in_words, while_played
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.scores import UNFITTED, ConfidenceCurve
from phonemeengine.settings import HOP, SAMPLE_RATE, AnalysisSettings, ModelKind
from tests.fakes.whisper_model import encoder_head
from tests.models import centred_model, tone_model
from tests.sounds import silence, tone

LIVE = tone_model({700.0: Phoneme.A, 2500.0: Phoneme.I}).rounded()
OFFLINE = centred_model(dilations=(1, 2, 4, 8, 16, 16, 4))
REACH = 51
PRESET = Preset(
    recogniser="learned", model=LIVE, offline_model=OFFLINE, settings=AnalysisSettings(statistics=False), name="both"
)
SOUND = np.concatenate([silence(0.2), tone(700, 0.5, 0.5), silence(0.3), tone(2500, 0.5, 0.5)] * 3)


@pytest.fixture
def wav(tmp_path) -> Path:
    soundfile.write(tmp_path / "tones.wav", SOUND, SAMPLE_RATE, subtype="FLOAT")
    return tmp_path / "tones.wav"


def heard(preset: Preset) -> Analysis:
    """What a preset says of samples that are pushed, as they are live."""
    return concatenate_analyses(list(analyse_blocks([SOUND], preset)))


def scores_of(analysis: Analysis) -> np.ndarray:
    return np.stack([analysis.features[name] for name in analysis.features.names if name.startswith("p_")], axis=1)


def in_file(wav: Path, preset: Preset) -> Analysis:
    with SoundReader(wav) as reader:
        return concatenate_analyses(list(analyse_file(reader, preset)))


def same(one: Analysis, other: Analysis) -> bool:
    return len(one) == len(other) and np.allclose(scores_of(one), scores_of(other), rtol=1e-3, atol=1e-4)


# -- which it is -------------------------------------------------------------------------------------------


def test_files_are_heard_with_the_model_for_files_and_live_sound_is_not(wav):
    assert Analyser(PRESET).recogniser.look_ahead == 5
    assert Analyser(for_files(PRESET)).recogniser.look_ahead == REACH
    by_file, live = in_file(wav, PRESET), heard(PRESET)
    assert same(by_file, heard(Preset(recogniser="learned", model=OFFLINE, settings=PRESET.settings)))
    assert not same(by_file, live)
    assert same(in_file(wav, for_files(PRESET, ModelKind.REAL_TIME)), live)


def test_every_way_to_a_whole_file_uses_the_same_model(wav):
    runs = [(run.phoneme, run.start) for run in transcribe(wav, PRESET).runs]
    assert runs == [(run.phoneme, run.start) for run in transcribe(wav, for_files(PRESET)).runs]
    assert runs != [(run.phoneme, run.start) for run in transcribe(wav, for_files(PRESET, ModelKind.REAL_TIME)).runs]
    assert cues(wav, PRESET) == cues(wav, for_files(PRESET, ModelKind.OFFLINE))
    one, other = (evidence_of(in_file(wav, preset)) for preset in (PRESET, for_files(PRESET)))
    np.testing.assert_array_equal(one.probabilities, other.probabilities)


def test_who_has_chosen_is_not_asked_again():
    for kind in (ModelKind.REAL_TIME, ModelKind.OFFLINE):
        chosen = for_files(PRESET, kind)
        assert for_files(chosen) is chosen
        assert chosen.model_kind is kind


@pytest.mark.parametrize("preset", [replace(PRESET, offline_model=None), Preset()])
def test_a_preset_without_another_model_hears_files_as_all_else_and_says_nothing(preset):
    hears = for_files(preset)
    assert (hears.config, hears.model_kind, hears.warnings) == (preset.config, ModelKind.REAL_TIME, ())


@pytest.mark.parametrize(
    ("preset", "words"),
    [
        (
            replace(PRESET, offline_model=None),
            "the preset 'both' has no offline model; the real-time model recognises files",
        ),
        (Preset(), "the recogniser 'thesis' has no other model for files; it recognises them itself"),
    ],
)
def test_a_model_that_is_asked_for_and_missing_is_told(preset, words):
    hears = for_files(preset, ModelKind.OFFLINE)
    assert hears.model_kind is ModelKind.REAL_TIME
    assert hears.warnings[0].startswith(words)


def test_a_preset_that_wants_no_other_model_has_none():
    assert for_files(replace(PRESET, file_model=ModelKind.REAL_TIME)).model_kind is ModelKind.REAL_TIME


def test_what_is_heard_with_is_told_in_words():
    assert model_in_words(PRESET) == "learned, look-ahead 50 ms"
    assert model_in_words(for_files(PRESET)) == "offline, ±0.51 s of context"
    assert model_in_words(load_preset("extended")) == "rules with a decoder, look-ahead 50 ms"
    assert model_in_words(Preset()) == "thesis"


# -- a part of a file --------------------------------------------------------------------------------------


@pytest.mark.parametrize(("first", "last"), [(0, 60), (100, 101), (440, 10_000)])
def test_a_part_of_a_file_is_heard_as_in_the_whole(wav, first, last):
    whole = in_file(wav, PRESET)
    with SoundReader(wav) as reader:
        part = concatenate_analyses(list(analyse_range(reader, first, last, PRESET)))
    assert part.start == first
    assert len(part) == min(last, len(whole)) - first
    assert same(part, whole.part(slice(first, last)))


# -- the speech encoder ------------------------------------------------------------------------------------

BOTH = replace(PRESET, encoder_head=encoder_head())


@pytest.mark.usefixtures("whisper")
def test_an_encoder_gives_each_frame_its_answer_however_the_sound_was_cut():
    hears, n = for_files(BOTH), 5000
    assert (hears.model_kind, model_in_words(hears)) == (ModelKind.WHISPER, "Whisper")
    found = concatenate_analyses(list(analyse_blocks(np.split(SOUND, range(n, len(SOUND), n)), hears)))
    assert len(found) == -(-len(SOUND) // HOP)
    assert same(found, heard(hears))
    assert not same(found, heard(for_files(BOTH, ModelKind.OFFLINE)))


@pytest.mark.usefixtures("whisper")
def test_nobody_waits_for_an_encoder_while_a_sound_plays():
    assert while_played(BOTH).model_kind is while_played(BOTH, ModelKind.WHISPER).model_kind is ModelKind.OFFLINE
    assert while_played(BOTH, ModelKind.REAL_TIME).model_kind is ModelKind.REAL_TIME


@pytest.mark.usefixtures("whisper")
def test_the_network_beside_the_encoder_is_the_one_for_files_if_there_is_one():
    alone = for_files(replace(BOTH, offline_model=None))
    assert (alone.model_kind, alone.config.model) == (ModelKind.WHISPER, LIVE)
    assert for_files(BOTH).config.model == OFFLINE
    assert not same(heard(alone), heard(for_files(BOTH)))


@pytest.mark.parametrize("offline_model", [OFFLINE, None])
def test_where_the_encoder_is_damaged_the_next_best_serves_and_that_is_told(tmp_path, monkeypatch, offline_model):
    monkeypatch.setenv(FOLDER_VARIABLE, str(tmp_path))
    hears = for_files(replace(BOTH, offline_model=offline_model))
    assert hears.model_kind is (ModelKind.OFFLINE if offline_model else ModelKind.REAL_TIME)
    (warning,) = hears.warnings
    assert warning.startswith(f"{tmp_path}: there is no Whisper model")


def test_where_no_encoder_is_installed_nobody_hears_of_it_unless_he_asks(monkeypatch):
    monkeypatch.setitem(sys.modules, "onnxruntime", None)
    assert (for_files(BOTH).model_kind, for_files(BOTH).warnings) == (ModelKind.OFFLINE, ())
    (told,) = for_files(BOTH, ModelKind.WHISPER).warnings
    assert told.startswith("the speech encoder is not installed; pip install")


@pytest.mark.usefixtures("home")
def test_where_there_is_no_model_of_it_nobody_hears_of_that_unless_he_asks():
    assert (for_files(BOTH).model_kind, for_files(BOTH).warnings) == (ModelKind.OFFLINE, ())
    (told,) = for_files(BOTH, ModelKind.WHISPER).warnings
    assert told.startswith("there is no Whisper model; phonemeanalyser whisper --fetch gets it")


@pytest.mark.usefixtures("whisper")
def test_a_preset_that_was_trained_without_the_encoder_does_without():
    assert for_files(PRESET).model_kind is ModelKind.OFFLINE
    (told,) = for_files(PRESET, ModelKind.WHISPER).warnings
    assert told == "the preset 'both' was trained without Whisper, and so cannot use it; choose another model"


@pytest.mark.usefixtures("whisper")
def test_a_model_with_visemes_of_its_own_is_not_asked_together_with_the_encoder():
    own = replace(STANDARD_VISEMES, phones={})
    (told,) = for_files(replace(BOTH, offline_model=replace(OFFLINE, viseme_set=own)), ModelKind.WHISPER).warnings
    assert told.endswith(
        "has visemes of its own, which the speech encoder does not know; files are recognised without it"
    )


# -- the file ----------------------------------------------------------------------------------------------


def test_a_preset_is_saved_with_all_models_beside_it(tmp_path):
    preset = replace(BOTH, file_model=ModelKind.OFFLINE)
    save_preset(preset, tmp_path / "voice.toml")
    names = ["voice.files.npz", "voice.npz", "voice.toml", "voice.whisper.npz"]
    assert sorted(p.name for p in tmp_path.iterdir()) == names
    back = load_preset(tmp_path / "voice.toml")
    assert (back, back.warnings) == (preset, ())
    assert {"the offline model", "the head on Whisper"} <= set(beyond_phoneme_data(preset))


@pytest.mark.parametrize("content", [None, b"PK"])
def test_without_the_head_on_the_encoder_the_preset_does_without_it_and_one_sentence_says_why(tmp_path, content):
    save_preset(BOTH, tmp_path / "voice.toml")
    (tmp_path / "voice.whisper.npz").unlink()
    if content is not None:
        (tmp_path / "voice.whisper.npz").write_bytes(content)
    back = load_preset(tmp_path / "voice.toml")
    assert back == PRESET
    (warning,) = back.warnings
    assert warning.startswith("voice.whisper.npz: the head of the encoder ")
    assert warning.endswith("; until then files are recognised without Whisper")


@pytest.mark.parametrize(
    ("spoil", "words"),
    [
        (lambda path: path.unlink(), "put it beside its preset"),
        (lambda path: path.write_bytes(b"PK"), "the model's file is damaged"),
        (lambda path: path.write_bytes(path.with_name("voice.npz").read_bytes()), "this is no offline model"),
    ],
)
def test_without_the_model_for_files_the_preset_hears_them_live_and_one_sentence_says_why(tmp_path, spoil, words):
    save_preset(PRESET, tmp_path / "voice.toml")
    spoil(tmp_path / "voice.files.npz")
    back = load_preset(tmp_path / "voice.toml")
    assert back == replace(PRESET, offline_model=None)
    (warning,) = back.warnings
    assert warning.startswith("voice.files.npz: ")
    assert words in warning
    assert "\n" not in warning
    assert for_files(back).model_kind is ModelKind.REAL_TIME
    assert for_files(back).warnings == back.warnings


def test_a_model_for_files_lies_beside_its_preset_too(tmp_path):
    save_preset(PRESET, tmp_path / "p.toml")
    text = (tmp_path / "p.toml").read_text()
    (tmp_path / "p.toml").write_text(text.replace("p.files.npz", "../p.files.npz"))
    with pytest.raises(PresetError, match="a model lies beside its preset"):
        load_preset(tmp_path / "p.toml")


@pytest.mark.parametrize("kind", ["LIVE", 3])
def test_a_model_that_does_not_exist_is_refused(tmp_path, kind):
    save_preset(replace(PRESET, file_model=ModelKind.OFFLINE), tmp_path / "p.toml")
    text = (tmp_path / "p.toml").read_text()
    (tmp_path / "p.toml").write_text(text.replace('file_model = "offline"', f"file_model = {kind!r}"))
    with pytest.raises(PresetError, match="file_model"):
        load_preset(tmp_path / "p.toml")


def test_presets_of_version_1_are_read_for_ever(tmp_path):
    curves = {ModelKind.REAL_TIME: UNFITTED, ModelKind.OFFLINE: ConfidenceCurve((0.5,), (0.4,))}
    preset = replace(PRESET, file_model=ModelKind.OFFLINE, live_model=ModelKind.REAL_TIME, confidences=curves)
    save_preset(preset, tmp_path / "voice.toml")
    old = (tmp_path / "voice.toml").read_text(encoding="utf-8")
    for new, before in (
        ("phonemeanalyser preset 2", "phonemeanalyser preset 1"),
        ('file_model = "offline"', 'file_ear = "twin"'),
        ('live_model = "real-time"', 'live_model = "live"'),
        ("offline_model = ", "file_model = "),
        ("[confidence.real-time]", "[confidence.live]"),
        ("[confidence.offline]", "[confidence.twin]"),
    ):
        assert old.count(new) == 1, new
        old = old.replace(new, before)
    (tmp_path / "voice.toml").write_text(old, encoding="utf-8")
    assert load_preset(tmp_path / "voice.toml") == preset
    save_preset(load_preset(tmp_path / "voice.toml"), tmp_path / "again.toml")
    written = (tmp_path / "again.toml").read_text(encoding="utf-8")
    assert [name for name in ("preset 1", "file_ear", "twin", '"live"') if name in written] == []
