"""``phonemeanalyser train`` and ``adapt``: what they write, say and refuse."""

import json
import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import soundfile

from phonemeanalyser.cli.main import main
from phonemeengine.analyser import Analyser, analyse_blocks
from phonemeengine.audio.files import SoundReader
from phonemeengine.calibration.calibrate import calibrate
from phonemeengine.calibration.takes.sentences import SENTENCES, read_sentence, sentences_in
from phonemeengine.encoder.live import open_live_encoder
from phonemeengine.labels.utterance import Label
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import DEFAULT_PRESET, FACTORY, load_preset
from phonemeengine.recognition.model import load_model
from phonemeengine.recognition.templates import Templates
from phonemeengine.settings import SAMPLE_RATE, ModelKind
from phonemeengine.text.pronunciation import words_of
from tests.corpora import put
from tests.reading import english_read
from tests.sounds import noise, vowel
from tests.tables import refused

FORMANTS = {Phoneme.A: (750, 1250, 2500), Phoneme.I: (300, 2200, 3000), Phoneme.U: (310, 800, 2300)}


def samples_of(path: Path) -> np.ndarray:
    with SoundReader(path) as reader:
        return np.concatenate(list(reader.blocks(1 << 16)))


def speak(folder: Path, name: str, f0: float, seconds: float, tract: float = 1.0) -> None:
    """Write a recording of one voice that says all vowels, labelled."""
    parts, labels = [], []
    at = 0.0
    for phoneme, formants in (*FORMANTS.items(), (Phoneme.SILENCE, None)):
        sound = vowel(tuple(f * tract for f in formants), seconds, f0) if formants else noise(seconds, 1e-4)
        parts.append(sound)
        labels.append(Label(at, at + len(sound) / SAMPLE_RATE, phoneme.label, phoneme))
        at = labels[-1].end
    put(folder, name, np.concatenate(parts), tuple(labels))


@pytest.fixture
def takes(tmp_path: Path) -> Path:
    folder = tmp_path / "takes"
    folder.mkdir()
    for k in range(4):
        speak(folder, f"take{k}", 200 + 5 * k, 0.25, tract=1.3)
    return folder


@pytest.fixture(scope="module")
def corpus(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("corpus")
    rows = ["corpus,speaker,language,kind,wav,labels,duration_s,licence,source_package"]
    for k, name in enumerate(("ann", "bob")):
        for n in range(4):
            speak(folder, f"{name}{n}", 100 + 40 * k + n, 2.0)
            rows.append(f"human_test,{name},en,human,{name}{n}.wav,{name}{n}.csv,8.0,CC0,made up")
    (folder / "manifest.csv").write_text("\n".join(rows) + "\n")
    return folder


@pytest.fixture(scope="module")
def quick(corpus: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A preset with small networks that were trained once, without validation."""
    out = tmp_path_factory.mktemp("quick") / "quick.npz"
    arguments = ["--epochs", "1", "--width", "4", "--variations", "0", "--no-validation"]
    assert main(["train", str(corpus), "-o", str(out), *arguments]) == 0
    return out.with_suffix(".toml")


def test_a_voice_is_adapted_to_and_the_preset_written_with_its_model(takes, quick, tmp_path, capsys):
    out = tmp_path / "voice.toml"
    assert main(["adapt", str(takes), "--preset", str(quick), "-o", str(out)]) == 0
    said = capsys.readouterr().out
    assert said.startswith(f"{out}: 4 recordings, 4 s; ")
    assert "each quarter held out in turn" in said
    preset = load_preset(out)
    assert preset.name == "voice"
    assert preset.recogniser == "learned"
    assert (preset.model != load_preset(quick).model) == ("unchanged" not in said)
    assert (tmp_path / "voice.npz").is_file()


@pytest.fixture(scope="module")
def read(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Somebody reads the English line."""
    path = tmp_path_factory.mktemp("read") / "me.wav"
    soundfile.write(path, english_read()[0], SAMPLE_RATE)
    return path


@pytest.fixture(scope="module")
def by_text(read: Path) -> Templates:
    """What that teaches templates, which learn in no time, by the API, whose words are given as a text."""
    before = load_preset("templates")
    found = calibrate(before, [read_sentence(read, words_of(SENTENCES[0].text, "en-us"))]).preset.templates
    assert found is not None
    assert found != before.templates
    return found


def test_one_read_line_is_aligned_with_what_is_read_and_learned(read, tmp_path, capsys):
    out = tmp_path / "voice.toml"
    assert main(["adapt", str(read), "--line", "english", "--preset", "templates", "-o", str(out)]) == 0
    said = capsys.readouterr().out
    assert said.startswith(f"{out}: 1 recording, 8 s; ")
    assert "each quarter held out in turn, 6 s" in said
    by_api = calibrate(load_preset("templates"), [read_sentence(read, sentences_in("English")[0])])
    assert load_preset(out).templates == by_api.preset.templates


def test_a_table_says_what_is_read_in_a_folder_as_it_does_for_other_commands(read, by_text, tmp_path, capsys):
    folder, out = tmp_path / "takes", tmp_path / "voice.toml"
    folder.mkdir()
    for name in ("me.wav", "silent.wav"):
        shutil.copy(read, folder / name)
    (tmp_path / "table.tsv").write_text(f"./takes/me.wav\t{SENTENCES[0].text}\n")
    words = ["--script", str(tmp_path / "table.tsv"), "--language", "en-us", "--preset", "templates"]
    assert main(["adapt", str(folder), *words, "-o", str(out)]) == 0
    assert "there is no text for silent.wav" in capsys.readouterr().err
    assert load_preset(out).templates == by_text


def test_another_text_is_refused_and_nothing_is_written(read, tmp_path, capsys):
    out = tmp_path / "voice.toml"
    assert "me.wav: there is no label file beside this sound; say what is read" in refused(
        capsys, "adapt", read, "-o", out
    )
    assert refused(capsys, "adapt", read, "--line", "german", "-o", out) == (
        "me.wav: the recording does not match this sentence; read it again exactly as shown, without rushing"
    )
    other = "Das ist ein ganz anderer Satz, den niemand gelesen hat."
    said = refused(capsys, "adapt", read, "--text", other, "--language", "de", "-o", out)
    assert said.startswith("me.wav: the recording does not match this sentence")
    with pytest.raises(SystemExit):
        main(["adapt", str(read), "--line", "german", "--text", "Hallo", "-o", str(out)])
    assert "--line is itself the text; leave --text and --script out" in capsys.readouterr().err
    assert not out.exists()


@pytest.mark.parametrize("name", ["extended", "learned", "templates"])
def test_a_room_alone_is_silence_afterwards_whatever_recognises(tmp_path, capsys, name):
    sound = noise(3.0, 0.02, seed=4)
    soundfile.write(tmp_path / "room.wav", sound, SAMPLE_RATE, subtype="FLOAT")
    out, factory = tmp_path / "here.toml", FACTORY / f"{name}.toml"
    assert (
        main(["adapt", "--background-noise", str(tmp_path / "room.wav"), "--preset", str(factory), "-o", str(out)])
        == 0
    )
    said = capsys.readouterr().out
    assert said.startswith(f"{out}: background noise of -34 dBFS, measured for 3.0 s; ")
    assert "Background noise recognised as silence: " in said
    preset = load_preset(out)
    assert preset.settings.denoise_threshold > 0.0001
    another = Analyser(preset).push(noise(2.0, 0.02, seed=5)).recognised
    assert np.mean(another == Phoneme.SILENCE) > 0.95


def test_who_names_neither_takes_nor_a_room_is_told_so(capsys):
    with pytest.raises(SystemExit):
        main(["adapt", "-o", "x.toml"])
    assert "give a FOLDER of takes, or --background-noise" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["takes", "-o", "x.txt"], "x.txt: an adapted preset's file ends in .toml; name it so"),
        (["nowhere", "-o", "x.toml"], "nowhere: there is no such folder; name one with "),
        (
            ["-o", "x.toml", "--background-noise", "takes/take0.wav"],
            "take0.wav: The background noise was as loud as a voice (-1",
        ),
    ],
)
def test_what_cannot_be_adapted_is_refused_in_one_sentence(takes, tmp_path, monkeypatch, capsys, arguments, words):
    monkeypatch.chdir(tmp_path)
    assert refused(capsys, "adapt", *arguments).startswith(words)
    assert not (tmp_path / "x.toml").exists()


def test_training_writes_a_model_and_a_card_that_tells_of_it(corpus, tmp_path, capsys):
    out = tmp_path / "mine.npz"
    (tmp_path / "groups.toml").write_text('validation = ["human_test/bob"]\n')
    arguments = ["--epochs", "1", "--width", "8", "--variations", "1", "--seed", "5"]
    arguments += ["--groups", str(tmp_path / "groups.toml")]
    assert main(["train", str(corpus), "-o", str(out), *arguments]) == 0
    said = capsys.readouterr().out
    assert f"{out}: " in said
    assert "real-time, people left out: macro F1 " in said
    model = load_model(out)
    assert model.about["seed"] == 5
    assert model.about["speakers"] == 2
    assert len(model.heads) == 6
    preset, sound = load_preset(tmp_path / "mine.toml"), next(corpus.glob("*.wav"))
    assert (preset.name, preset.model) == ("mine", model)
    found = np.concatenate([a.recognised for a in analyse_blocks([samples_of(sound)], preset)])
    shipped = replace(load_preset(DEFAULT_PRESET), model=model)
    assert np.array_equal(found, np.concatenate([a.recognised for a in analyse_blocks([samples_of(sound)], shipped)]))
    assert (
        main(["analyse", str(sound), "-o", str(tmp_path / "told.csv"), "--preset", str(tmp_path / "mine.toml")]) == 0
    )
    assert (tmp_path / "told.csv").read_text().startswith("start_s,end_s,phoneme,intensity")
    card = out.with_suffix(".md").read_text()
    for told in (
        "# mine",
        "Seed 5, 1 epochs",
        "in 1 variations",
        "| human_test/ann | en | 0.5 | CC0 | made up |",
        "| **real-time, people** | 0.5 |",
        "| **offline, all** | 0.5 |",
        "| human_test/bob (human) | 0.5 |",
    ):
        assert told in card
    assert "human_test/ann (human)" not in card  # who is not in the groups is not judged
    assert load_preset(tmp_path / "mine.toml").offline_model.about["seed"] == 5
    assert not out.with_suffix(".training").exists()


def test_without_validation_networks_are_trained_once_and_nothing_is_judged(quick):
    assert "Not measured in this training." in quick.with_suffix(".md").read_text()
    preset = load_preset(quick)
    assert preset.model.about["speakers"] == 2
    assert preset.confidences == {}


@pytest.mark.long  # tests/training/test_pipeline.py trains a smaller encoder by the same function
def test_a_teacher_teaches_moves_labels_and_hears_files(corpus, tmp_path, capsys, whisper):
    out = tmp_path / "taught.npz"
    folder = shutil.copytree(corpus, tmp_path / "corpus")
    sound = shutil.copy(folder / "ann0.wav", folder / "unlabelled.wav")  # which the teacher alone is to tell of
    with (folder / "manifest.csv").open("a") as manifest:
        manifest.write("human_test,ann,en,human,unlabelled.wav,,8.0,CC0,made up\n")
    again = tmp_path / "again"  # a recording that two folders have counts once
    again.mkdir()
    for name in ("ann1.wav", "ann1.csv"):
        shutil.copy(folder / name, again)
    (again / "manifest.csv").write_text("corpus,speaker,kind,wav,labels\nhuman_test,ann,human,ann1.wav,ann1.csv\n")
    arguments = ["--epochs", "1", "--width", "8", "--variations", "0", "--encoder-epochs", "1"]
    arguments += ["--teacher", str(whisper)]
    assert main(["train", str(folder), str(again), "-o", str(out), *arguments]) == 0
    assert "whisper, people left out: macro F1 0." in capsys.readouterr().out
    preset = load_preset(tmp_path / "taught.toml")
    assert set(preset.confidences) == set(ModelKind)
    assert preset.live_encoder is not None
    assert open_live_encoder(preset.live_encoder).anchors.shape == (12, 150, 80)
    assert preset.encoder_head is not None
    assert preset.encoder_head.priors.sum() == pytest.approx(2, abs=1e-2)
    card = out.with_suffix(".md").read_text()
    for told in (
        "The teacher is layer 4, counted from 0, of the encoder of Whisper base",
        "| round | boundaries |",
        "1 speakers were left out of a first training of all networks",
        "| **encoder, people** | 0.5",
        "| **whisper, all** | 0.5",
    ):
        assert told in card
    assert main(["analyse", str(sound), "--preset", str(tmp_path / "taught.toml"), "--format", "json"]) == 0
    assert json.loads(capsys.readouterr().out)["model"] == "Whisper"


def test_a_training_does_not_take_over_another_that_was_begun(corpus, tmp_path, capsys):
    begun = tmp_path / "mine.training"
    begun.mkdir()
    (begun / "plan.txt").write_text("another one")
    assert refused(capsys, "train", corpus, "-o", tmp_path / "mine.npz") == (
        f"{begun}: another training was begun here; remove the folder, or name another output"
    )
    assert (begun / "plan.txt").read_text() == "another one"


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["corpus", "-o", "model.bin"], "model.bin: a model's file ends in .npz; name it so"),
        (["nowhere", "-o", "m.npz"], "manifest.csv: there is no such file"),
    ],
)
def test_what_cannot_be_trained_is_refused_in_one_sentence(tmp_path, monkeypatch, capsys, arguments, words):
    monkeypatch.chdir(tmp_path)
    assert refused(capsys, "train", *arguments).startswith(words)
    assert not list(tmp_path.glob("*.npz"))


def test_too_little_speech_is_refused_before_anything_is_trained(takes, tmp_path, capsys):
    rows = "".join(f"c,s,take{k}.wav,take{k}.csv\n" for k in range(4))
    (takes / "manifest.csv").write_text("corpus,speaker,wav,labels\n" + rows)
    assert refused(capsys, "train", takes, "-o", tmp_path / "m.npz").startswith(
        "there is too little speech to train with; give at least ten minutes of it"
    )
