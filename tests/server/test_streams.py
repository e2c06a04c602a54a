"""Streams: what a client is told is what the engine finds in the whole sound, however it is cut."""

import json
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest

from phonemeanalyser.server import messages
from phonemeanalyser.server.access import RefusedError
from phonemeanalyser.server.service import ServerSettings
from phonemeengine import Analyser, Phoneme, Viseme, load_preset, load_table
from phonemeengine.analyser import Analysis, concatenate_analyses
from phonemeengine.audio.incoming import Encoding, IncomingSound, StreamFormat
from phonemeengine.audio.resampling import resample_whole
from phonemeengine.labels.visemes import NO_VISEME
from phonemeengine.live.incoming_speech import IncomingSpeech, in_time
from phonemeengine.mouth.blending import blended_weights
from phonemeengine.mouth.morpher import Morpher
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.scores import scores_in
from phonemeengine.settings import SAMPLE_RATE
from tests.server.conftest import FAST, REPERTOIRE
from tests.server.servers import Told, as_s16, cut, served, streamed
from tests.sounds import Sound

LEARNED = load_preset("learned")


def heard(sound: Sound, preset: Preset = LEARNED, delay: float = 0.0) -> Analysis:
    """What the engine finds, which is given the whole sound at once."""
    analyser = Analyser(in_time(preset, delay), phonemes_only=True)
    return concatenate_analyses([analyser.push(sound), analyser.finish()])


def check(told: Told, expected: Analysis) -> None:
    assert told.code == 1000
    assert told.column("phonemes") == [Phoneme(code).label for code in expected.phonemes.tolist()]
    visemes = [None if code == NO_VISEME else Viseme(code).label for code in expected.visemes.tolist()]
    assert told.column("visemes") == visemes
    np.testing.assert_allclose(told.column("intensities"), expected.intensities, atol=1e-3)
    if not np.isnan(expected.confidences).any():
        np.testing.assert_allclose(told.column("confidences"), expected.confidences, atol=2e-3)
    n = 0
    for frames in told.frames:
        assert frames["time"] == round(n * 0.01, 2)
        n += len(frames["phonemes"])


@pytest.mark.parametrize("sizes", [[1], [1764, 3, 17_777], [1 << 20]], ids=str)
def test_a_stream_is_told_what_the_engine_finds_in_the_whole_sound(
    server: str, recording: Sound, sizes: Sequence[int]
) -> None:
    data = as_s16(recording)[: 12_001 * 2 if sizes == [1] else None]
    told = streamed(server, {"rate": 44_100}, cut(data, sizes))
    check(told, heard(np.frombuffer(data, "<i2").astype(np.float32) / np.float32(32_768)))
    assert told.messages[-1] == {"end": round(len(data) / 2 / 44_100, 4)}


def test_a_client_that_wants_them_is_told_probabilities_and_the_weights_by_them(
    server: str, recording: Sound
) -> None:
    start = {"encoding": "f32", "rate": 44_100, "table": "oculus", "probabilities": True}
    told, expected = streamed(server, start, cut(recording.tobytes(), [7000])), heard(recording)
    assert expected.viseme_scores is not None
    for name, rows in (
        ("phoneme_scores", scores_in(expected.features)),
        ("viseme_scores", expected.viseme_scores),
        ("blended", blended_weights(load_table("oculus"), expected)),
    ):
        np.testing.assert_allclose(told.column(name), rows, atol=1e-3)
    assert (
        "viseme_scores" not in streamed(server, {"encoding": "f32", "rate": 44_100}, [recording.tobytes()]).frames[0]
    )


@pytest.mark.parametrize("name", ["extended", "templates"])
def test_other_recognisers_are_told_as_they_find(recording: Sound, name: str) -> None:
    with served(ServerSettings([Path(name)], port=0, limits=FAST)) as address:
        told = streamed(address, {"encoding": "f32", "rate": 44_100}, cut(recording.tobytes(), [3000]))
    check(told, heard(recording, load_preset(name)))


@pytest.mark.parametrize(
    "rate", [8000, 48_000, *(pytest.param(rate, marks=pytest.mark.long) for rate in (16_000, 24_000, 192_000))]
)
def test_other_rates_are_heard_as_the_same_sound(server: str, recording: Sound, rate: int) -> None:
    data = resample_whole(recording, 44_100, rate).tobytes()
    told = streamed(server, {"encoding": "f32", "rate": rate}, cut(data, [4 * rate // 50]))
    sound = IncomingSound(StreamFormat(Encoding.F32, rate))
    whole = np.concatenate([*sound.pieces(data), sound.finish()])
    check(told, heard(whole, delay=sound.delay))
    plain = heard(recording, delay=sound.delay).phonemes
    same = [Phoneme(code).label for code in plain.tolist()] == np.array(told.column("phonemes"))
    assert np.mean(same) > (0.97 if rate > 20_000 else 0.8)  # nothing above half the rate is heard
    assert told.messages[0]["ready"]["latency"] <= 0.055


def test_channels_are_mixed(server: str, recording: Sound) -> None:
    both = np.stack([recording, np.zeros_like(recording)], axis=1)
    told = streamed(server, {"encoding": "f32", "rate": 44_100, "channels": 2}, cut(both.tobytes(), [9999]))
    check(told, heard(recording / 2))


def test_the_weights_are_those_of_a_mouth_that_hears_the_same(server: str, recording: Sound) -> None:
    told = streamed(server, {"encoding": "f32", "rate": 44_100, "table": "arkit"}, cut(recording.tobytes(), [3528]))
    found, morpher = heard(recording), Morpher(load_table("arkit"))
    assert told.messages[0]["ready"]["movestates"] == list(morpher.movestates)
    phones = found.viseme_phones
    for k, weights in enumerate(told.column("weights")):
        morpher.add(k * 0.01, int(found.phonemes[k]), float(found.intensities[k]), phones[k])
        np.testing.assert_allclose(weights, morpher.weights(k * 0.01), atol=2e-3)
    assert np.max(told.column("weights")) > 0.3


def test_a_client_that_asks_is_told_how_the_voice_sounds():
    start = messages.start_of('{"rate": 44100, "encoding": "f32", "feeling": true}', REPERTOIRE)
    speech = IncomingSpeech(LEARNED, start.form, felt=start.felt)
    tone = np.sin(2 * np.pi * 150 * np.arange(SAMPLE_RATE) / SAMPLE_RATE).astype(np.float32)
    told = [json.loads(messages.frames(speech.push(piece), start)) for piece in speech.pieces(tone.tobytes())][-1]
    names = ("activation", "activation_spread", "pleasantness", "pleasantness_spread")
    assert [len(told[name]) for name in names] == [len(told["phonemes"])] * 4
    assert 0 < told["activation_spread"][-1] < 1
    with pytest.raises(RefusedError, match="feeling must be true or false, got 1"):
        messages.start_of('{"rate": 44100, "feeling": 1}', REPERTOIRE)


class AzureSynthesizer:
    """Reads messages as the public Speech SDK does: ``SynthesisAudioMetadata``, and what it makes of a viseme."""

    def __init__(self) -> None:
        self.received: list[tuple[int, int, str]] = []
        self._animation = ""

    def on_audio_metadata(self, body: str) -> None:
        for metadata in json.loads(body)["Metadata"]:
            if metadata["Type"] == "Viseme":
                self._animation += metadata["Data"]["AnimationChunk"]
                if metadata["Data"]["IsLastAnimation"]:
                    self.received.append((metadata["Data"]["Offset"], metadata["Data"]["VisemeId"], self._animation))


def test_clients_of_azure_and_polly_read_the_same_visemes(server: str, recording: Sound) -> None:
    synthesizer = AzureSynthesizer()
    start = {"encoding": "f32", "rate": 44_100}
    told = streamed(server, start | {"events": "azure"}, [recording.tobytes()])
    assert not told.frames
    for message in told.messages[1:-1]:
        synthesizer.on_audio_metadata(json.dumps(message))
    assert synthesizer.received[0] == (0, 0, "")
    assert {viseme for _, viseme, _ in synthesizer.received} <= {*range(22)}
    marks = streamed(server, start | {"events": "polly"}, [recording.tobytes()]).messages[1:-1]
    assert all(mark.keys() == {"time", "type", "value"} and mark["type"] == "viseme" for mark in marks)
    assert marks[0] == {"time": 0, "type": "viseme", "value": "sil"}
    shut = {"azure": [t / 10_000 for t, viseme, _ in synthesizer.received if viseme == 21]}
    assert shut["azure"] == [mark["time"] for mark in marks if mark["value"] == "p"] != []
