"""The network over time: what it remembers, and how its frames come."""

from collections.abc import Callable

import numpy as np
import pytest

from phonemeengine.dsp.mel import N_BANDS
from phonemeengine.presets.files import DEFAULT_PRESET, load_preset
from phonemeengine.recognition.network import FEW, Network, vectors_pay

LAYERS = load_preset(DEFAULT_PRESET).model.layers
HEARD = np.random.default_rng(3).normal(-5, 2, (300, 3, N_BANDS)).astype(np.float32)


def found(n: int, pay: Callable[[], bool] = vectors_pay) -> np.ndarray:
    """What the shipped network finds where so many frames come at once."""
    network = Network(LAYERS, np.zeros((3, N_BANDS), np.float32), pay)
    return np.concatenate([network.forward(HEARD[k : k + n]) for k in range(0, len(HEARD), n)])


@pytest.mark.parametrize("n", [1, 2, FEW, FEW + 1, 64, 100])
def test_the_network_remembers_the_same_however_many_frames_come_at_once(n):
    np.testing.assert_allclose(found(n), found(len(HEARD)), rtol=1e-4, atol=1e-4)


@pytest.mark.parametrize("pay", [True, False])
def test_a_microphone_whose_blocks_vary_hears_the_same_to_the_last_bit(pay):
    assert np.array_equal(found(1, lambda: pay), found(2, lambda: pay))
    assert np.array_equal(found(1, lambda: pay), found(3, lambda: pay))
