"""A sound card that comes back while a sound plays on without one: it is heard again from the same place."""

from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest
import soundfile

from phonemeengine.analyser import Analysis
from phonemeengine.audio.files import SoundReader
from phonemeengine.settings import HOP, SAMPLE_RATE
from tests.fakes.outputs import Cards, HandDrivenOutput
from tests.fakes.players import PRESET, SPEECH, EagerPlayer, agree, frames_of, go_round, offline
from tests.waiting import wait_for

LONG = np.concatenate([SPEECH] * 6)
N_FRAMES = -(-len(LONG) // HOP)


class Listening:
    """A player on cards that come and go, and what was taken from it."""

    def __init__(self, path: Path, *cards: HandDrivenOutput) -> None:
        self.cards = Cards(*cards)
        self.player = EagerPlayer(SoundReader(path), PRESET, self.cards)
        self.taken: list[Analysis] = []

    def wait(self, truth: Callable[[], bool], what: str) -> None:
        """Take what is heard until something is true."""

        def seen() -> bool:
            self.taken += self.player.take_analyses()
            return truth()

        wait_for(seen, what)

    def hear_on(self, card: HandDrivenOutput) -> None:
        """Have a card play to the end."""

        def ended() -> bool:
            card.move(HOP)
            return self.player.finished

        self.wait(ended, "the end")


@pytest.fixture
def start(tmp_path: Path) -> Iterator[Callable[..., Listening]]:
    made: list[Listening] = []
    soundfile.write(tmp_path / "long.wav", LONG, SAMPLE_RATE, subtype="FLOAT")

    def make(*cards: HandDrivenOutput) -> Listening:
        made.append(Listening(tmp_path / "long.wav", *cards))
        return made[-1]

    yield make
    for listening in made:
        listening.player.close()


Start = Callable[..., Listening]


def test_a_sound_that_began_without_a_card_is_heard_as_soon_as_there_is_one(start: Start, tmp_path: Path) -> None:
    listening, card = start(), HandDrivenOutput()
    listening.player.set_gain(0.25)
    listening.player.play()
    listening.wait(lambda: len(listening.taken) > 5, "the clock")
    assert not listening.player.has_card
    listening.cards.there.append(card)
    listening.wait(lambda: listening.player.has_card and card.running, "the card")
    assert card.gain == 0.25
    assert listening.player.output_name == "moved by hand"
    listening.hear_on(card)
    assert frames_of(listening.taken) == list(range(N_FRAMES))
    agree(listening.taken, offline(tmp_path / "long.wav"))
    aloud = np.concatenate(card.played)[:, 0]
    assert (len(LONG) - len(aloud)) % HOP == 0
    np.testing.assert_allclose(aloud, LONG[-len(aloud) :], atol=1e-6)


def test_a_card_that_goes_and_comes_back_loses_and_doubles_no_frame(start: Start) -> None:
    first, second = HandDrivenOutput(), HandDrivenOutput()
    listening = start(first)
    listening.player.set_gain(0.5)
    listening.player.play()

    def some_heard() -> bool:
        first.move(HOP)
        return len(frames_of(listening.taken)) > 30

    listening.wait(some_heard, "30 frames")
    first.lost = True
    listening.wait(lambda: first.closed, "the clock")
    assert not listening.player.has_card
    listening.cards.there.append(second)
    listening.wait(lambda: listening.player.has_card and second.running, "the second card")
    assert second.gain == 0.5
    assert second.n_written < len(LONG) - 30 * HOP
    listening.hear_on(second)
    assert frames_of(listening.taken) == list(range(N_FRAMES))


def test_a_card_that_opens_and_stands_still_is_let_go_and_the_clock_goes_on(start: Start) -> None:
    listening, still = start(), HandDrivenOutput()
    still.alive = False
    listening.cards.there.append(still)
    listening.player.play()
    listening.wait(lambda: still.closed, "the refusal")
    assert not listening.player.has_card
    assert still.n_written == 0
    n = len(listening.taken)
    listening.wait(lambda: len(listening.taken) > n + 3, "the clock")
    frames = frames_of(listening.taken)
    assert frames == list(range(len(frames)))


def test_nobody_looks_for_a_card_in_a_pause(start: Start) -> None:
    listening = start()
    go_round(listening.player)
    assert listening.cards.n_asked == 1
    listening.player.play()
    listening.wait(lambda: listening.cards.n_asked > 3, "the search")
    listening.player.pause()
    go_round(listening.player)
    n = listening.cards.n_asked
    go_round(listening.player)
    assert listening.cards.n_asked == n


def test_a_card_that_goes_after_the_end_and_one_that_comes_repeat_nothing(start: Start) -> None:
    first, second = HandDrivenOutput(), HandDrivenOutput()
    listening = start(first)
    listening.player.seek(len(LONG) / SAMPLE_RATE - 0.3)
    listening.player.play()
    listening.wait(lambda: first.running, "the card")
    listening.hear_on(first)
    before, place = frames_of(listening.taken), listening.player.position
    assert before[-1] == N_FRAMES - 1
    listening.cards.there.append(second)
    first.lost = True
    listening.wait(lambda: first.closed and not listening.player._target, "the clock")
    go_round(listening.player)
    listening.wait(lambda: listening.player.finished, "the end")
    assert frames_of(listening.taken) == before
    assert listening.player.position == pytest.approx(place)
    assert second.n_written == 0  # nobody needs a card for nothing
    assert listening.cards.n_asked == 1
    listening.player.seek(len(LONG) / SAMPLE_RATE - 0.2)  # and from there it plays on, aloud
    listening.wait(lambda: listening.player.has_card and second.running, "the second card")
    listening.hear_on(second)
    first_again = int(100 * (len(LONG) / SAMPLE_RATE - 0.2))
    assert frames_of(listening.taken)[len(before) :] == list(range(first_again, N_FRAMES))
