"""A style fitted to a performance whose style is known, since the rules made it: the fit gives it back."""

from dataclasses import replace

import numpy as np
import pytest

from phonemeengine.errors import PerformanceError
from phonemeengine.mouth.animation import animation_of
from phonemeengine.mouth.blendshape_names import ARKIT
from phonemeengine.mouth.performer import MOUTH_ALONE
from phonemeengine.mouth.style import Style
from phonemeengine.mouth.table import load_table
from phonemeengine.mouth.transcript import transcript_of_utterance
from phonemeengine.performance.recording import Performance, phones_of
from phonemeengine.performance.style_fit import LOUD_LEVEL, SILENT_LEVEL, fit_style
from tests.engine.mouth.speaking import utterance_of

SAID = utterance_of(*[(ipa, 0.08 + 0.03 * (k % 4)) for k, ipa in enumerate("mapitobesamup")], start=0.3, after=0.4)
LOUD = 0.7


def performed(style: Style, channels: tuple[str, ...] = ARKIT) -> Performance:
    """What a face does by the rules in a style, as if it had been recorded."""
    said = phones_of(SAID)
    loud = np.array(
        [any(p.name != "sil" and p.start <= t < p.end for p in said) for t in np.arange(0, said[-1].end, 0.01)]
    )
    transcript = transcript_of_utterance(
        SAID, LOUD * loud.astype(np.float32), np.zeros(len(loud), np.float32), "take"
    )
    table = style.on_table(load_table("arkit").with_motion(1, 1, random=False))
    weights = animation_of(transcript, table, 60, MOUTH_ALONE).weights
    level = SILENT_LEVEL + LOUD * (LOUD_LEVEL - SILENT_LEVEL)
    phones = tuple(replace(phone, energy=level) for phone in said)
    return Performance("take", 60, channels, weights[:, [ARKIT.index(name) for name in channels]], phones)


@pytest.mark.parametrize(("reach", "speed", "width", "asymmetry"), [(0.7, 1.5, 1.6, 0.4), (1.2, 0.7, 0.6, 0.0)])
def test_the_fit_gives_back_the_style_that_made_the_performance(reach, speed, width, asymmetry):
    usual = Style()
    movement = replace(usual.movement, reach=reach, vowels=speed, consonants=speed, closures=speed)
    poses = {name: replace(pose, width=width) for name, pose in usual.closures.phones.items()}
    style = Style(asymmetry=asymmetry, movement=movement, closures=replace(usual.closures, phones=poses))
    found = fit_style([performed(style)], "anna")
    assert found.style.name == "anna"
    assert found.speed == pytest.approx(speed, rel=0.1)
    assert found.style.movement.reach == pytest.approx(reach, rel=0.1)
    assert found.width == pytest.approx(width, rel=0.25)
    assert found.style.asymmetry == pytest.approx(asymmetry, abs=0.1)
    assert found.after < 0.3 * found.before


def test_a_performance_without_a_mouth_is_refused():
    with pytest.raises(PerformanceError, match="a mouth that moves"):
        fit_style([performed(Style(), ("browInnerUp",))], "none")
