"""Speech that comes in pieces is named in time, the same alone as beside others."""

import numpy as np
import pytest
import soundfile

from phonemeengine.analyser import Analyser, concatenate_analyses, push_together
from phonemeengine.audio.incoming import Encoding, StreamFormat
from phonemeengine.errors import EngineError
from phonemeengine.live.incoming_speech import MOST_LATE, WORK, IncomingSpeech, in_time, recognise_together
from phonemeengine.presets.files import load_preset
from phonemeengine.presets.model_choice import for_live_use
from phonemeengine.presets.preset import Preset
from tests.conftest import CORPUS
from tests.fakes.plug_ins import Shelf
from tests.sounds import Sound

NAMES = ("learned", "thesis", "extended", "templates")
BROKEN = """
class Own(Plain):
    def recognise(self, windows, features):
        raise ZeroDivisionError
"""


@pytest.fixture(scope="module")
def voices() -> list[Sound]:
    return [soundfile.read(path, dtype="float32")[0] for path in sorted(CORPUS.rglob("*.flac"))[:60:12]]


@pytest.mark.parametrize(
    "rate",
    [1000, 8000, 44_100, *(pytest.param(r, marks=pytest.mark.long) for r in (11_025, 16_000, 48_000, 192_000))],
)
@pytest.mark.parametrize("name", NAMES)
def test_a_frame_is_known_55_ms_after_its_sound_has_come(name: str, rate: int) -> None:
    speech = IncomingSpeech(load_preset(name), StreamFormat(Encoding.F32, rate))
    if rate >= 8000:
        assert speech.latency <= MOST_LATE - WORK
    block, n, slowest = max(1, rate // 500), 0, 0.0
    for _ in range(250):
        for piece in speech.pieces(np.zeros(block, np.float32).tobytes()):
            n += len(speech.push(piece).analysis)
        slowest = max(slowest, speech.seconds - (n + 1) * 0.01)  # the next frame is not known yet
    assert slowest <= speech.latency + 1e-6
    assert n > 0


@pytest.mark.parametrize("name", ["learned", "extended"])
def test_many_sounds_are_heard_together_as_alone(voices: list[Sound], name: str) -> None:
    preset = load_preset(name)
    settings = [for_live_use(preset), in_time(preset, 0.03), for_live_use(preset), preset, preset]
    alone, beside = ([Analyser(p, phonemes_only=True) for p in settings] for _ in range(2))
    random = np.random.default_rng(1)
    found: list[tuple[list, list]] = [([], []) for _ in voices]
    places = [0] * len(voices)
    while any(place < len(voice) for place, voice in zip(places, voices, strict=True)):
        blocks = []
        for k, voice in enumerate(voices):
            n = int(random.choice([0, 1, 441, 882, 3000, 40_000]))
            blocks.append(voice[places[k] : places[k] + n])
            places[k] += n
        for k, together in enumerate(push_together(list(zip(beside, blocks, strict=True)))):
            found[k][0].append(together)
            found[k][1].append(alone[k].push(blocks[k]))
    for k, (together, single) in enumerate(found):
        one = concatenate_analyses([*together, beside[k].finish()])
        other = concatenate_analyses([*single, alone[k].finish()])
        assert np.mean(one.phonemes == other.phonemes) > 0.999
        assert np.mean(one.visemes == other.visemes) > 0.998
        np.testing.assert_allclose(one.intensities, other.intensities, atol=1e-6)
        np.testing.assert_allclose(one.confidences, other.confidences, atol=1e-3)


def test_a_sound_goes_on_at_the_next_frame_without_its_encoder_and_with_it_again(voices: list[Sound]) -> None:
    preset, sound = load_preset("learned"), voices[0][:88_200]
    speech, both, small = (IncomingSpeech(preset, StreamFormat(Encoding.F32)) for _ in range(3))
    small.use_encoder(on=False)
    assert (both.has_encoder, small.has_encoder, small.may_have_encoder) == (True, False, True)
    found = [speech.push(sound[:22_050]).analysis]
    speech.use_encoder(on=False)
    assert speech.latency <= both.latency
    found.append(speech.push(sound[22_050:66_150]).analysis)
    speech.use_encoder(on=True)
    found += [speech.push(sound[66_150:]).analysis, *(rest.analysis for rest in speech.finish())]
    assert [part.start for part in found[1:]] == np.cumsum([len(part) for part in found])[:-1].tolist()
    assert (len(concatenate_analyses(found)), speech.was_without_encoder) == (200, True)
    np.testing.assert_array_equal(found[0].phonemes, both.push(sound[:22_050]).analysis.phonemes)
    later = found[1].phonemes[60:]  # the small network has heard as much by then as it looks back
    alone = small.push(sound[:66_150]).analysis.phonemes[-len(later) :]
    assert np.mean(later == alone) > 0.9


def test_a_recogniser_of_others_that_fails_stops_its_own_sound_alone(shelf: Shelf, voices: list[Sound]) -> None:
    shelf.offer(BROKEN)
    form = StreamFormat(Encoding.F32)
    broken, whole = IncomingSpeech(Preset(recogniser="own"), form), IncomingSpeech(load_preset("thesis"), form)
    failed, heard = recognise_together([(broken, voices[0][:20_000]), (whole, voices[0][:20_000])])
    assert isinstance(failed, EngineError)
    assert not isinstance(heard, EngineError)
    assert len(heard.analysis) > 40
