"""What files are heard with: the model that a preset has for them, a speech encoder, or what hears live."""

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
from phonemeengine.presets.ears import ear_in_words, for_files, while_played
from phonemeengine.presets.files import beyond_phoneme_data, load_preset, save_preset
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import HOP, SAMPLE_RATE, AnalysisSettings, Ear
from tests.fakes.whisper_model import encoder_head
from tests.models import centred_model, tone_model
from tests.sounds import silence, tone

LIVE = tone_model({700.0: Phoneme.A, 2500.0: Phoneme.I}).rounded()
TWIN = centred_model(dilations=(1, 2, 4, 8, 16, 16, 4))
REACH = 51
PRESET = Preset(
    recogniser="learned", model=LIVE, file_model=TWIN, settings=AnalysisSettings(statistics=False), name="both"
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
    assert same(by_file, heard(Preset(recogniser="learned", model=TWIN, settings=PRESET.settings)))
    assert not same(by_file, live)
    assert same(in_file(wav, for_files(PRESET, Ear.LIVE)), live)


def test_every_way_to_a_whole_file_hears_with_the_same_ear(wav):
    runs = [(run.phoneme, run.start) for run in transcribe(wav, PRESET).runs]
    assert runs == [(run.phoneme, run.start) for run in transcribe(wav, for_files(PRESET)).runs]
    assert runs != [(run.phoneme, run.start) for run in transcribe(wav, for_files(PRESET, Ear.LIVE)).runs]
    assert cues(wav, PRESET) == cues(wav, for_files(PRESET, Ear.TWIN))
    one, other = (evidence_of(in_file(wav, preset)) for preset in (PRESET, for_files(PRESET)))
    np.testing.assert_array_equal(one.probabilities, other.probabilities)


def test_who_has_chosen_is_not_asked_again():
    for ear in (Ear.LIVE, Ear.TWIN):
        chosen = for_files(PRESET, ear)
        assert for_files(chosen) is chosen
        assert chosen.ear is ear


@pytest.mark.parametrize("preset", [replace(PRESET, file_model=None), Preset()])
def test_a_preset_without_another_model_hears_files_as_all_else_and_says_nothing(preset):
    hears = for_files(preset)
    assert (hears.config, hears.ear, hears.warnings) == (preset.config, Ear.LIVE, ())


@pytest.mark.parametrize(
    ("preset", "words"),
    [
        (
            replace(PRESET, file_model=None),
            "the preset 'both' has no model for files; they are heard as live sound is",
        ),
        (Preset(), "the recogniser 'thesis' has no other ear for files; it hears them itself"),
    ],
)
def test_who_asks_for_an_ear_that_is_not_there_is_told(preset, words):
    hears = for_files(preset, Ear.TWIN)
    assert hears.ear is Ear.LIVE
    assert hears.warnings[0].startswith(words)


def test_a_preset_that_wants_no_other_ear_has_none():
    assert for_files(replace(PRESET, file_ear=Ear.LIVE)).ear is Ear.LIVE


def test_what_is_heard_with_is_told_in_words():
    assert ear_in_words(PRESET) == "learned, 50 ms ahead"
    assert ear_in_words(for_files(PRESET)) == "twin, 0.51 s each way"
    assert ear_in_words(Preset()) == "thesis"


# -- a part of a file --------------------------------------------------------------------------------------


@pytest.mark.parametrize(("first", "last"), [(0, 60), (100, 101), (150, 320), (300, 450), (440, 10_000)])
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
@pytest.mark.parametrize("n", [HOP, 1000, 20_000, len(SOUND)])
def test_an_encoder_gives_each_frame_its_answer_however_the_sound_was_cut(n):
    hears = for_files(BOTH)
    assert (hears.ear, ear_in_words(hears)) == (Ear.WHISPER, "Whisper base and network")
    found = concatenate_analyses(list(analyse_blocks(np.split(SOUND, range(n, len(SOUND), n)), hears)))
    assert len(found) == -(-len(SOUND) // HOP)
    assert same(found, heard(hears))
    assert not same(found, heard(for_files(BOTH, Ear.TWIN)))


@pytest.mark.usefixtures("whisper")
def test_nobody_waits_for_an_encoder_while_a_sound_plays():
    assert while_played(BOTH).ear is while_played(BOTH, Ear.WHISPER).ear is Ear.TWIN
    assert while_played(BOTH, Ear.LIVE).ear is Ear.LIVE


@pytest.mark.usefixtures("whisper")
def test_the_network_beside_the_encoder_is_the_one_for_files_if_there_is_one():
    alone = for_files(replace(BOTH, file_model=None))
    assert (alone.ear, alone.config.model) == (Ear.WHISPER, LIVE)
    assert for_files(BOTH).config.model == TWIN
    assert not same(heard(alone), heard(for_files(BOTH)))


@pytest.mark.parametrize("file_model", [TWIN, None])
def test_where_the_encoder_is_damaged_the_next_best_serves_and_that_is_told(tmp_path, monkeypatch, file_model):
    monkeypatch.setenv(FOLDER_VARIABLE, str(tmp_path))
    hears = for_files(replace(BOTH, file_model=file_model))
    assert hears.ear is (Ear.TWIN if file_model else Ear.LIVE)
    (warning,) = hears.warnings
    assert warning.startswith(f"{tmp_path}: there is no Whisper model")


def test_where_no_encoder_is_installed_nobody_hears_of_it_unless_he_asks(monkeypatch):
    monkeypatch.setitem(sys.modules, "onnxruntime", None)
    assert (for_files(BOTH).ear, for_files(BOTH).warnings) == (Ear.TWIN, ())
    (told,) = for_files(BOTH, Ear.WHISPER).warnings
    assert told.startswith("the speech encoder is not installed; pip install")


@pytest.mark.usefixtures("home")
def test_where_there_is_no_model_of_it_nobody_hears_of_that_unless_he_asks():
    assert (for_files(BOTH).ear, for_files(BOTH).warnings) == (Ear.TWIN, ())
    (told,) = for_files(BOTH, Ear.WHISPER).warnings
    assert told.startswith("there is no Whisper model; phonemeanalyser whisper --fetch gets it")


@pytest.mark.usefixtures("whisper")
def test_a_preset_that_was_trained_without_the_encoder_does_without():
    assert for_files(PRESET).ear is Ear.TWIN
    (told,) = for_files(PRESET, Ear.WHISPER).warnings
    assert told == "the preset 'both' does not know what Whisper hears; it was trained without it"


@pytest.mark.usefixtures("whisper")
def test_a_model_with_visemes_of_its_own_is_not_asked_together_with_the_encoder():
    own = replace(STANDARD_VISEMES, phones={})
    (told,) = for_files(replace(BOTH, file_model=replace(TWIN, viseme_set=own)), Ear.WHISPER).warnings
    assert told.endswith(
        "has visemes of its own, which the speech encoder does not know; files are recognised without it"
    )


# -- the file ----------------------------------------------------------------------------------------------


def test_a_preset_is_saved_with_all_models_beside_it(tmp_path):
    preset = replace(BOTH, file_ear=Ear.TWIN)
    save_preset(preset, tmp_path / "voice.toml")
    names = ["voice.files.npz", "voice.npz", "voice.toml", "voice.whisper.npz"]
    assert sorted(p.name for p in tmp_path.iterdir()) == names
    back = load_preset(tmp_path / "voice.toml")
    assert (back, back.warnings) == (preset, ())
    assert {"the model for files", "what Whisper hears"} <= set(beyond_phoneme_data(preset))


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
    assert warning.endswith("; until then files are heard without Whisper")


@pytest.mark.parametrize(
    ("spoil", "words"),
    [
        (lambda path: path.unlink(), "put it beside its preset"),
        (lambda path: path.write_bytes(b"PK"), "the model's file is damaged"),
        (lambda path: path.write_bytes(path.with_name("voice.npz").read_bytes()), "this model is not for files"),
    ],
)
def test_without_the_model_for_files_the_preset_hears_them_live_and_one_sentence_says_why(tmp_path, spoil, words):
    save_preset(PRESET, tmp_path / "voice.toml")
    spoil(tmp_path / "voice.files.npz")
    back = load_preset(tmp_path / "voice.toml")
    assert back == replace(PRESET, file_model=None)
    (warning,) = back.warnings
    assert warning.startswith("voice.files.npz: ")
    assert words in warning
    assert "\n" not in warning
    assert for_files(back).ear is Ear.LIVE
    assert for_files(back).warnings == back.warnings


def test_a_model_for_files_lies_beside_its_preset_too(tmp_path):
    save_preset(PRESET, tmp_path / "p.toml")
    text = (tmp_path / "p.toml").read_text()
    (tmp_path / "p.toml").write_text(text.replace("p.files.npz", "../p.files.npz"))
    with pytest.raises(PresetError, match="a model lies beside its preset"):
        load_preset(tmp_path / "p.toml")


@pytest.mark.parametrize("ear", ["ears", "LIVE", 3])
def test_an_ear_that_nobody_has_is_refused(tmp_path, ear):
    save_preset(replace(PRESET, file_ear=Ear.TWIN), tmp_path / "p.toml")
    text = (tmp_path / "p.toml").read_text()
    (tmp_path / "p.toml").write_text(text.replace('file_ear = "twin"', f"file_ear = {ear!r}"))
    with pytest.raises(PresetError, match="file_ear"):
        load_preset(tmp_path / "p.toml")
