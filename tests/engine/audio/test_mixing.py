"""What sounds in a file is heard, however its channels and its level are; ordinary files stay as they are."""

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
import soundfile

from phonemeengine import SoundReader, convert_all, load_preset, transcribe
from phonemeengine.audio.mixing import PLAIN, measured_mix
from phonemeengine.inspection.measurement import save_stretch
from phonemeengine.live.listener import MicrophoneAnalyser, status_of
from phonemeengine.live.player import Player
from phonemeengine.settings import SAMPLE_RATE, Channel
from tests.conftest import CORPUS
from tests.fakes.microphones import HandDrivenMicrophone
from tests.fakes.outputs import HandDrivenOutput
from tests.reading import DEMO, english_read
from tests.sounds import Sound, noise, silence, tone

SPEECH = english_read()[0][: 3 * SAMPLE_RATE]
EXTENDED = load_preset("extended")


def written(folder: Path, sound: Sound, name: str = "a.wav") -> Path:
    soundfile.write(folder / name, sound, SAMPLE_RATE, subtype="PCM_24")
    return folder / name


def in_channel(k: int, n: int) -> Sound:
    channels = np.zeros((len(SPEECH), n), np.float32)
    channels[:, k] = SPEECH
    return channels


CASES = {
    "opposite": (np.stack([SPEECH, -SPEECH], axis=1), "channel 2 is inverted"),
    "nearly opposite": (np.stack([SPEECH, -0.9 * SPEECH], axis=1), "channel 2 is inverted"),
    "one silent": (in_channel(0, 2), "only channel 1 of 2 has a signal and is used"),
    "centre alone": (in_channel(2, 6), "only channel 3 of 6 has a signal and is used"),
    "-40 dB": (SPEECH / 100, "dBFS; amplified by"),
    "-50 dB": (SPEECH / 316, "dBFS; amplified by"),
    "-60 dB": (SPEECH / 1000, "dBFS; amplified by"),
}


@pytest.mark.parametrize("case", CASES)
def test_what_sounds_in_a_file_is_heard_as_if_it_were_an_ordinary_one(case: str, tmp_path: Path) -> None:
    sound, note = CASES[case]
    path = written(tmp_path, sound)
    with SoundReader(path) as reader:
        (said,) = reader.notes
        assert note in said
    usual = transcribe(written(tmp_path, SPEECH, "usual.wav"), EXTENDED).intensities
    found = transcribe(path, EXTENDED).intensities
    assert found.mean() == pytest.approx(usual.mean(), rel=0.15)


def test_a_level_is_told_and_corrected(tmp_path: Path) -> None:
    sound = np.concatenate([tone(440, 1.0, 10 ** (-52 / 20)), silence(1.0)])
    with SoundReader(written(tmp_path, sound)) as reader:
        assert reader.notes == ("the recording peaks at -52 dBFS; amplified by 40 dB for recognition",)
        assert np.abs(reader.read_mono()).max() == pytest.approx(10 ** (-12 / 20), rel=0.02)
        reader.seek(0)
        assert np.abs(reader.read(SAMPLE_RATE)).max() == pytest.approx(10 ** (-52 / 20), rel=0.02)


@pytest.mark.parametrize(
    "sound",
    [
        SPEECH,
        np.stack([SPEECH, SPEECH], axis=1),
        np.stack([SPEECH, np.roll(SPEECH, 20_000)], axis=1),
        noise(2.0, 1e-3),
        silence(1.0),
        tone(440, 0.05, 1e-3),
    ],
    ids=["mono", "twice the same", "two voices", "a room", "nothing", "a moment"],
)
def test_other_sounds_stay_as_they_are(sound: Sound, tmp_path: Path) -> None:
    path = written(tmp_path, sound)
    with SoundReader(path) as reader, SoundReader(path, as_it_is=True) as plain:
        assert reader.mix == PLAIN
        np.testing.assert_array_equal(reader.read_mono(), plain.read_mono())


@pytest.mark.parametrize("path", [DEMO, *sorted(CORPUS.rglob("*.flac"))[::40]], ids=lambda path: path.stem)
def test_recordings_of_the_corpus_stay_as_they_are(path: Path) -> None:
    with SoundReader(path) as reader:
        assert reader.mix is PLAIN


def test_a_click_does_not_make_a_quiet_sound_a_loud_one(tmp_path: Path) -> None:
    sound = SPEECH / 316
    sound[5000] = 0.9
    with SoundReader(written(tmp_path, sound)) as reader:
        assert reader.mix.gain > 100


def test_a_channel_that_is_chosen_is_measured_by_itself(tmp_path: Path) -> None:
    path = written(tmp_path, np.stack([SPEECH, -SPEECH / 316], axis=1))
    with SoundReader(path, Channel.LEFT) as left, SoundReader(path, Channel.RIGHT) as right:
        assert left.notes == ()
        assert "amplified" in right.notes[0]


def test_an_ordinary_sound_of_hours_is_measured_by_its_beginning() -> None:
    n_asked = 0

    def blocks() -> Iterator[Sound]:
        nonlocal n_asked
        while True:
            n_asked += 1
            yield SPEECH[:, np.newaxis]

    assert measured_mix(blocks(), SAMPLE_RATE, Channel.MIX) is PLAIN
    assert n_asked == 1


def test_what_is_saved_stays_as_it_is(tmp_path: Path) -> None:
    quiet = written(tmp_path, SPEECH / 316)
    save_stretch(quiet, 0.0, 1.0, tmp_path / "part.wav")
    saved, _ = soundfile.read(tmp_path / "part.wav", dtype="float32")
    np.testing.assert_allclose(saved, SPEECH[:SAMPLE_RATE] / 316, atol=1e-6)


def test_a_player_hears_what_a_file_analysis_hears(tmp_path: Path) -> None:
    path = written(tmp_path, np.stack([SPEECH, -SPEECH], axis=1))
    with SoundReader(path) as reader:
        block = reader.read(1000)
        np.testing.assert_allclose(reader.mono(block), SPEECH[:1000], atol=1e-6)
    player = Player(SoundReader(path), EXTENDED, lambda _n: HandDrivenOutput(ahead=SAMPLE_RATE))
    player.close()


def test_a_batch_notes_it(tmp_path: Path) -> None:
    quiet = written(tmp_path, SPEECH / 316)
    assert convert_all([quiet], tmp_path / "out", "phonemes-csv", EXTENDED, processes=1) == {}
    record = (tmp_path / "out" / ".phonemeanalyser-batch").read_text(encoding="utf-8")
    assert "amplified by" in record


@pytest.mark.parametrize(("sign", "cancelled"), [(-1, True), (1, False)])
def test_a_microphone_whose_channels_cancel_is_told_of(sign: int, cancelled: bool) -> None:
    microphone = HandDrivenMicrophone(n_channels=2)
    heard = MicrophoneAnalyser(microphone, 0, EXTENDED, pitch=False, start=0)
    heard.analyse(np.stack([SPEECH, sign * SPEECH], axis=1))
    assert heard.cancels is cancelled
    words = status_of(microphone, analysed=True, silent=0.0, cancels=heard.cancels).words
    assert ("its channels cancel each other out when mixed" in words) is cancelled
