"""Sound that is played slower, with the pitch kept."""

import numpy as np
import pytest

from phonemeengine import SettingsError
from phonemeengine.audio.output import SlowedOutput
from phonemeengine.settings import SAMPLE_RATE
from tests.fakes.outputs import HandDrivenOutput

PITCH = 220.0
STEP = 2646


def play(speed: float, seconds: float = 1.0) -> tuple[SlowedOutput, HandDrivenOutput]:
    """A tone, played to its end through an output that a test moves."""
    card = HandDrivenOutput(2)
    output = SlowedOutput(card, 2, speed)
    times = np.arange(round(seconds * SAMPLE_RATE)) / SAMPLE_RATE
    tone = np.repeat(0.3 * np.sin(2 * np.pi * PITCH * times)[:, np.newaxis], 2, axis=1).astype(np.float32)
    blocks = [tone[k : k + STEP] for k in range(0, len(tone), STEP)]
    while blocks or card.heard < card.n_written:
        if blocks and output.room >= len(blocks[0]):
            output.write(blocks.pop(0))
        card.move(1000)
        assert 0 <= output.heard <= output.n_written
    return output, card


@pytest.mark.parametrize("speed", [0.25, 0.5, 0.85, 1.0])
def test_it_takes_longer_and_the_pitch_stays(speed: float) -> None:
    output, card = play(speed)
    played = np.concatenate(card.played)[:, 0]
    assert len(played) == pytest.approx(SAMPLE_RATE / speed, abs=3)
    spectrum = np.abs(np.fft.rfft(played[: SAMPLE_RATE // 2] * np.hanning(SAMPLE_RATE // 2), 1 << 17))
    assert spectrum.argmax() * SAMPLE_RATE / (1 << 17) == pytest.approx(PITCH, rel=0.01)
    assert np.abs(np.diff(played[STEP:-STEP])).max() < 0.02  # no clicks between the blocks
    assert output.heard == output.n_written == SAMPLE_RATE


def test_what_is_heard_is_counted_in_samples_of_the_sound() -> None:
    card = HandDrivenOutput(1, ahead=SAMPLE_RATE)
    output = SlowedOutput(card, 1, 0.5)
    output.write(np.zeros((8000, 1), np.float32))
    card.move(4000)
    assert output.heard == 2000
    output.skip()
    assert output.heard == 8000
    output.write(np.zeros((8000, 1), np.float32))
    card.move(2000)
    assert output.heard == 9000


def test_too_slow_or_too_fast_is_refused() -> None:
    for speed in (0.2, 1.2, float("nan")):
        with pytest.raises(SettingsError, match="the speed must lie in"):
            SlowedOutput(HandDrivenOutput(), 1, speed)
