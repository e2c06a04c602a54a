"""What files are heard with in the window: as the preset says, as the user chooses, and as is told."""

import sys
from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtWidgets import QComboBox

from phonemeanalyser.desktop.session.sources import SourceKind
from phonemeengine.analyser import analyse_file, concatenate_analyses
from phonemeengine.audio.files import SoundReader
from phonemeengine.encoder.live import build_live_encoder
from phonemeengine.labels.files import read_labels
from phonemeengine.mouth.lip_sync import transcribe
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import save_preset
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import AnalysisSettings, ModelKind
from tests.desktop.hands import CARDS, followed, shown, wait_for_results
from tests.fakes.encoder_weights import encoder_weights
from tests.fakes.whisper_model import encoder_head
from tests.models import centred_model, tone_model

PRESET = Preset(
    name="both",
    recogniser="learned",
    model=tone_model({700.0: Phoneme.A, 2500.0: Phoneme.I}).rounded(),
    offline_model=centred_model(dilations=(1, 2, 4, 8, 16, 16, 4)),
    settings=AnalysisSettings(statistics=False),
)
ENCODER = build_live_encoder(encoder_weights(n_layers=1, n_channels=64))


@pytest.fixture
def window(desktop, qtbot, tmp_path):
    save_preset(PRESET, tmp_path / "both.toml")
    desktop.preset.load(tmp_path / "both.toml")
    return followed(desktop, qtbot, seconds=1.0)


def choose(box: QComboBox, kind: ModelKind) -> None:
    box.setCurrentIndex(list(ModelKind).index(kind))
    box.activated.emit(box.currentIndex())


def shown_phonemes(desktop, qtbot) -> np.ndarray:
    wait_for_results(desktop, qtbot)
    history = desktop.session.history
    return history.phonemes[history.indices(0, history.n)]


def in_file(preset: Preset, n: int) -> np.ndarray:
    with SoundReader(CARDS) as reader:
        return concatenate_analyses(list(analyse_file(reader, preset))).phonemes[:n]


def test_a_microphone_is_recognised_with_the_model_that_the_user_chooses(desktop, window):
    choice, live = window.recogniser.live_models, replace(PRESET, live_encoder=ENCODER)
    assert not choice.model().item(1).isEnabled()  # this preset has none
    desktop.preset.edit(live, "test")
    assert choice.model().item(1).isEnabled()
    assert choice.currentText() == "Encoder"
    desktop.session.set_source(SourceKind.MICROPHONE)
    window.status.refresh(frozen=False)
    assert "encoder, look-ahead 20 ms" in window.status.left.text()
    choice.setCurrentIndex(0)
    choice.activated.emit(0)
    window.status.refresh(frozen=False)
    assert "Learned, look-ahead 20 ms" in window.status.left.text()
    assert desktop.preset.preset.live_model is ModelKind.REAL_TIME


def test_the_opened_file_is_heard_as_the_commands_hear_it(window, desktop, qtbot):
    found = shown_phonemes(desktop, qtbot)
    np.testing.assert_array_equal(found, in_file(PRESET, len(found)))
    assert window.recogniser.file_models.currentText() == "Offline"
    window.status.refresh(frozen=False)
    assert "Model: offline, ±0.51 s of context" in window.status.left.text()


def test_another_model_acts_at_once_and_undo_takes_it_back(window, desktop, qtbot):
    choose(window.recogniser.file_models, ModelKind.REAL_TIME)
    found = shown_phonemes(desktop, qtbot)
    np.testing.assert_array_equal(found, in_file(replace(PRESET, file_model=ModelKind.REAL_TIME), len(found)))
    window.status.refresh(frozen=False)
    assert "Model: Learned, look-ahead 50 ms" in window.status.left.text()
    desktop.preset.undo_stack.undo()
    assert window.recogniser.file_models.currentText() == "Offline"
    np.testing.assert_array_equal(shown_phonemes(desktop, qtbot), in_file(PRESET, len(found)))


@pytest.mark.parametrize("kind", [ModelKind.OFFLINE, ModelKind.WHISPER])
def test_a_model_that_is_not_there_is_told_and_changes_nothing(desktop, qtbot, kind):
    window = shown(desktop, qtbot)
    choose(window.recogniser.file_models, kind)
    assert window.banner.label.text().startswith("The recogniser 'thesis' has no other model for files")
    assert window.recogniser.file_models.currentText() == "Real-time"
    assert not window.isWindowModified()


def offered(window) -> list[bool]:
    items = window.recogniser.file_models.model()
    return [items.item(row).isEnabled() for row in range(items.rowCount())]


def test_only_what_is_there_is_offered(desktop, qtbot, tmp_path, whisper):
    window = shown(desktop, qtbot)
    assert offered(window) == [True, False, False, False]  # rules recognise files themselves
    assert window.recogniser.live_models.currentText() == "Thesis"
    whisper_item = window.recogniser.file_models.model().item(3)
    assert "The recogniser Thesis has no other model; choose a preset with a network." in whisper_item.toolTip()
    save_preset(PRESET, tmp_path / "both.toml")
    desktop.preset.load(tmp_path / "both.toml")
    assert offered(window) == [True, False, True, False]
    assert window.recogniser.live_models.currentText() == "Small network"
    desktop.preset.edit(replace(PRESET, encoder_head=encoder_head()), "what is known of Whisper")
    assert offered(window) == [True, False, True, True]


def test_a_preset_whose_model_is_missing_is_loaded_and_that_is_told(desktop, qtbot, tmp_path, monkeypatch):
    window, small = shown(desktop, qtbot), "Learned, look-ahead 20 ms"
    for missing, told, model in (
        ("both.files.npz", "both.files.npz: the model cannot be read", "encoder, look-ahead 20 ms"),
        ("both.encoder.onnx", "both.encoder.onnx: there is no such file", small),
        ("onnxruntime", "needs onnxruntime, which is not installed", small),
    ):
        # bytes of its own, since a model that was opened once stays open
        encoder = build_live_encoder(encoder_weights(n_layers=1, n_channels=64), about={"missing": missing})
        save_preset(replace(PRESET, live_encoder=encoder), tmp_path / "both.toml")
        if missing == "onnxruntime":
            monkeypatch.setitem(sys.modules, missing, None)
        else:
            (tmp_path / missing).unlink()
        window.dialogs.presets.load(tmp_path / "both.toml")
        assert told in window.banner.label.text()
        assert desktop.preset.preset.name == "both"
        desktop.session.set_source(SourceKind.MICROPHONE)
        window.status.refresh(frozen=False)
        assert f"Model: {model}" in window.status.left.text()


def test_what_nobody_knows_beforehand_is_heard_live(window, desktop):
    desktop.session.set_source(SourceKind.TONE)
    assert desktop.session.source.preset.model_kind is ModelKind.REAL_TIME
    desktop.session.set_source(SourceKind.FILE)
    assert desktop.session.source.preset.model_kind is ModelKind.OFFLINE


def test_saved_phonemes_are_those_of_the_file(window, desktop, qtbot, tmp_path):
    target, source = tmp_path / "saved.csv", desktop.session.source
    desktop.session.writer.write(source.name, source.reopen, desktop.preset.in_force, target)
    qtbot.waitUntil(lambda: not desktop.session.writer.busy)
    runs = transcribe(CARDS, PRESET).runs
    assert [label.phoneme for label in read_labels(target)] == [run.phoneme for run in runs]
    assert window.banner.label.text().endswith("Model: offline, ±0.51 s of context.")
