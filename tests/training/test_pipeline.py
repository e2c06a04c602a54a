"""A whole training with a teacher, as small as it can be, and the processes that share its work."""

from pathlib import Path

import numpy as np
import pytest

from phonemeengine.labels.utterance import Label
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import ModelKind
from phonemetraining.config import TrainingConfig
from phonemetraining.model_card import model_card
from phonemetraining.pipeline import train_and_validate
from phonemetraining.processes import FEW, in_processes
from tests.corpora import put
from tests.sounds import noise, vowel

CONFIG = TrainingConfig(
    width=4,
    n_epochs=1,
    batch_size=2,
    n_frames=50,
    n_layers=1,
    n_encoder_epochs=1,
    encoder_batch=2,
    n_encoder_frames=40,
)


@pytest.mark.long
def test_a_teacher_teaches_moves_labels_and_hears_files(tmp_path: Path, whisper: Path):
    folder = tmp_path / "corpus"
    folder.mkdir()
    sound = np.concatenate([vowel((750, 1250, 2500), 0.5), vowel((300, 2200, 3000), 0.5), noise(0.5, 1e-4)])
    labels = tuple(
        Label(k / 2, (k + 1) / 2, p.label, p) for k, p in enumerate((Phoneme.A, Phoneme.I, Phoneme.SILENCE))
    )
    rows = ["corpus,speaker,language,kind,wav,labels,duration_s,licence,source_package"]
    for name in ("ann", "bob"):
        put(folder, name, sound, labels)
        rows.append(f"human_test,{name},en,human,{name}.wav,{name}.csv,1.5,CC0,made up")
    rows.append("human_test,ann,en,human,bob.wav,,1.5,CC0,made up")  # which the teacher alone is to tell of
    (folder / "manifest.csv").write_text("\n".join(rows) + "\n")
    shares = []
    result = train_and_validate(
        [folder], CONFIG, 0, tmp_path / "work", lambda _what, share: shares.append(share), whisper=whisper
    )
    assert set(result.validations) == set(ModelKind)
    assert result.encoder is not None
    assert result.head is not None
    assert result.head.priors.sum() == pytest.approx(2, abs=1e-2)
    assert 0 < min(shares) <= max(shares) == 1
    card = model_card("taught", result, 0)
    assert "| round | boundaries |" in card
    assert "1 speakers were left out of a first training of all networks" in card


@pytest.mark.parametrize("n", [2, FEW + 1])
def test_work_is_shared_where_there_is_much_and_comes_in_order(n: int):
    numbers = range(n)
    assert list(in_processes(pow, (numbers, numbers), dict, ())) == [k**k for k in numbers]
