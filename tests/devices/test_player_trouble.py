"""A sound server that dies, comes back, or stands still, while a file is played."""

import json
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.devices.programs import HERE, PATIENCE, SIGNATURE, Program, Samples, followed, pcm_noise, place_of
from tests.fakes.virtual_sound import VirtualSound
from tests.waiting import let_pass

pytestmark = pytest.mark.long

SECONDS = 40.0
"""Of sound: it goes on, however long a busy machine takes to see what is there."""
WITH, WITHOUT = "with a card", "without a card"


@dataclass(frozen=True)
class Played:
    """What a player said, what the speaker gave after the trouble, and what was played."""

    seen: dict[str, Any]
    heard: Samples
    pcm: Samples


def play_through(folder: Path, begin: Callable[[VirtualSound], None], end: Callable[[VirtualSound], None]) -> Played:
    """Play a noise, with trouble in the midst of it."""
    pcm = pcm_noise(folder / "noise.wav", SECONDS)
    with VirtualSound() as card:
        program = Program(folder, card, HERE / "play_on_card.py", folder / "noise.wav")
        program.wait_for(lambda: WITH in program.out)
        let_pass(1.0)
        begin(card)
        program.wait_for(lambda: program.out[-1] == WITHOUT)
        let_pass(1.0)
        end(card)
        speaker = card.record_speaker(folder / "heard.wav")
        program.wait_for(lambda: program.out[-1] == WITH)
        assert program.end(None) == 0, program.errors
        let_pass(1.0)
        speaker.terminate()
        speaker.wait(PATIENCE)
    heard = np.fromfile(folder / "heard.wav", np.int16, offset=44).reshape(-1, 2)[:, 0]
    return Played(json.loads(program.out[-1]), heard.astype(np.int64), pcm)


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
def test_a_player_goes_on_silently_and_is_heard_again(trouble: str, played: dict[str, Played]) -> None:
    seen = played[trouble].seen
    assert [card for _, card in seen["cards"]][:3] == [True, False, True]
    assert seen["card"]
    assert seen["finished"]


@pytest.mark.parametrize("trouble", ["killed", "suspended"])
def test_no_frame_is_lost_or_doubled_on_the_way(trouble: str, played: dict[str, Played]) -> None:
    assert played[trouble].seen["frames"] == list(range(round(SECONDS * 100)))
    assert played[trouble].seen["dropped"] == 0


@pytest.mark.parametrize("trouble", ["killed", "suspended"])
def test_what_is_heard_again_is_the_file_to_its_end(trouble: str, played: dict[str, Played]) -> None:
    """A server that is too busy to take sound is let go once more, and what was written to it is heard again."""
    one = played[trouble]
    if len(one.seen["cards"]) > 3:
        pytest.skip("this machine is so busy that its server took nothing for a while, which the player noticed")
    heard = one.heard[np.flatnonzero(one.heard)[0] :]
    rest = one.pcm[place_of(heard[:SIGNATURE], one.pcm) :]
    assert followed(rest, heard).missing < 0.1 * len(rest) / 44_100  # a busy card comes too late for some blocks
