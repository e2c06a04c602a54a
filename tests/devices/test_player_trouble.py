"""A sound server that dies, comes back, or stands still, while a file is played."""

import json
import time
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.devices.programs import HERE, SIGNATURE, Program, Samples, pcm_noise, place_of
from tests.virtual_sound import VirtualSound

SECONDS = 9.0
AWAY = 1.5
"""Seconds for which there is no sound."""
SOON = 3.0
"""Seconds within which it must be heard again."""


@dataclass(frozen=True)
class Played:
    """What a player said, when the trouble began and ended, what the speaker gave after it, and what was played."""

    seen: dict[str, Any]
    began: float
    ended: float
    heard: Samples
    pcm: Samples

    @property
    def silent_from(self) -> float:
        """When the player went on without a card, seconds after the trouble began."""
        return next(when for when, card in self.seen["cards"] if not card) - self.began

    @property
    def heard_from(self) -> float:
        """When it had a card again, seconds after the trouble ended."""
        return next(when for when, card in self.seen["cards"] if card and when > self.ended) - self.ended


def play_through(folder: Path, begin: Callable[[VirtualSound], None], end: Callable[[VirtualSound], None]) -> Played:
    """Play a noise, with trouble in the midst of it."""
    pcm = pcm_noise(folder / "noise.wav", SECONDS)
    with VirtualSound() as card:
        program = Program(folder, card, HERE / "play_on_card.py", folder / "noise.wav")
        program.wait_for(lambda: program.out)
        time.sleep(1.0)
        begin(card)
        began = time.monotonic()
        time.sleep(AWAY)
        end(card)
        ended = time.monotonic()
        speaker = card.record_speaker(folder / "heard.wav")
        assert program.end(None) == 0, program.errors
        time.sleep(0.3)
        speaker.terminate()
        speaker.wait(5)
    heard = np.fromfile(folder / "heard.wav", np.int16, offset=44).reshape(-1, 2)[:, 0]
    return Played(json.loads(program.out[-1]), began, ended, heard.astype(int), pcm)


@pytest.fixture(scope="module")
def played(minute: object, tmp_path_factory: pytest.TempPathFactory) -> Iterator[dict[str, Played]]:
    """Both kinds of trouble at the same time, each on a card of its own, and a minute is recorded beside them."""
    troubles = {
        "killed": (VirtualSound.kill, VirtualSound.restart),
        "suspended": (lambda card: card.suspend_speaker(True), lambda card: card.suspend_speaker(False)),
    }
    with ThreadPoolExecutor() as threads:
        futures = {
            name: threads.submit(play_through, tmp_path_factory.mktemp(name), *trouble)
            for name, trouble in troubles.items()
        }
        yield {name: future.result() for name, future in futures.items()}


@pytest.mark.parametrize("trouble", ["killed", "suspended"])
def test_a_player_goes_on_silently_and_is_soon_heard_again(trouble: str, played: dict[str, Played]) -> None:
    one = played[trouble]
    print(f"silent after {one.silent_from:.2f} s, has a card {one.heard_from:.2f} s after the end of the trouble")
    assert one.silent_from < AWAY
    assert one.heard_from < SOON
    assert one.seen["card"]
    assert one.seen["finished"]


@pytest.mark.parametrize("trouble", ["killed", "suspended"])
def test_no_frame_is_lost_or_doubled_on_the_way(trouble: str, played: dict[str, Played]) -> None:
    assert played[trouble].seen["frames"] == list(range(round(SECONDS * 100)))
    assert played[trouble].seen["dropped"] == 0


@pytest.mark.parametrize("trouble", ["killed", "suspended"])
def test_what_is_heard_again_is_the_file_to_its_end(trouble: str, played: dict[str, Played]) -> None:
    one = played[trouble]
    end = SIGNATURE + place_of(one.pcm[::-1], one.heard[::-1])
    heard = one.heard[: len(one.heard) - end + SIGNATURE]
    different = np.flatnonzero(np.abs(heard[::-1] - one.pcm[::-1][: len(heard)]) > 1)
    n_heard = int(different[0]) if len(different) else len(heard)
    print(f"{n_heard / 44_100:.2f} s are heard to the end, sample by sample")
    assert n_heard > 2 * 44_100
