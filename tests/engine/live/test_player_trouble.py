"""The player when something goes wrong: it says so, and never hangs."""

import threading
from pathlib import Path

import pytest

from phonemeengine.analyser import Analysis
from phonemeengine.arrays import Float32Array
from phonemeengine.audio.files import SoundReader
from phonemeengine.errors import AudioError, DeviceError
from phonemeengine.live.player import PlaybackQueue, Player
from phonemeengine.settings import FRAME_PERIOD, HOP
from tests.bad_files import BAD_FILES
from tests.fakes.outputs import Cards, HandDrivenOutput
from tests.fakes.players import N_FRAMES, PRESET, SPEECH, ForgetfulPlayer, Rig, agree, frames_of, offline
from tests.waiting import wait_for


@pytest.mark.parametrize("name", ["not_a_number", "truncated_flac"])
def test_a_file_that_breaks_in_the_middle_raises_where_it_is_taken(name: str, tmp_path: Path) -> None:
    rig = Rig(BAD_FILES[name](tmp_path))
    rig.player.play()
    with pytest.raises(AudioError, match=r" \d\.\d{3} s"):
        rig.hear(1000)
    assert rig.player.take_analyses() == [] or not rig.player.finished
    rig.player.seek(0)
    rig.settle()
    assert frames_of(rig.hear(5))[:3] == [0, 1, 2]
    rig.player.close()


def test_a_seek_into_damage_raises_and_the_beginning_still_plays(tmp_path: Path) -> None:
    rig = Rig(BAD_FILES["not_a_number"](tmp_path))
    rig.player.seek(0.9)
    rig.settle()
    with pytest.raises(AudioError, match="not_a_number"):
        rig.player.take_analyses()
    rig.player.seek(0)
    rig.player.play()
    rig.settle()
    assert frames_of(rig.hear(5))[:3] == [0, 1, 2]
    rig.player.close()


class Buggy(SoundReader):
    """A sound that cannot be mixed to be analysed."""

    def mono(self, block: Float32Array) -> Float32Array:
        raise ZeroDivisionError("a bug")


def test_a_bug_in_the_analysis_is_raised_where_it_is_taken(path: Path) -> None:
    player = Player(Buggy(path), PRESET, Cards(HandDrivenOutput()))
    player.play()
    wait_for(player.catch_up, "the error")
    with pytest.raises(ZeroDivisionError):
        player.take_analyses()
    player.close()


@pytest.mark.parametrize("name", ["not_a_sound", "missing", "empty", "list_that_hangs"])
def test_a_bad_file_opens_no_device_and_leaves_no_thread(name: str, tmp_path: Path) -> None:
    before = threading.active_count()
    opened: list[int] = []

    def open_device(n_channels: int) -> HandDrivenOutput:
        opened.append(n_channels)
        return HandDrivenOutput(n_channels)

    with pytest.raises(AudioError):
        Player(SoundReader(BAD_FILES[name](tmp_path)), PRESET, open_device)
    assert threading.active_count() == before
    assert not opened


def test_a_lost_device_goes_on_on_the_clock_from_the_same_place(rig: Rig, path: Path) -> None:
    rig.player.play()
    before = frames_of(rig.hear(33))
    position = rig.player.position
    rig.output.lost = True
    after = rig.player.take_analyses()
    wait_for(lambda: not rig.player.has_card, "the clock")
    wait_for(lambda: rig.output.closed, "the end of the device")
    assert position - FRAME_PERIOD <= rig.player.position < position + 0.5
    assert "No audio device" in rig.player.output_name
    assert rig.player.playing

    def done() -> bool:
        after.extend(rig.player.take_analyses())
        return rig.player.finished

    wait_for(done, "the end")
    first = after[0].start
    assert abs(first - before[-1]) <= 2
    assert frames_of(after) == list(range(first, N_FRAMES))
    agree(after, offline(path), first)


def test_a_device_lost_in_a_pause_stays_paused_on_the_clock(rig: Rig) -> None:
    rig.player.play()
    rig.hear(33)
    rig.player.pause()
    rig.output.lost = True
    position = rig.player.position
    rig.player.take_analyses()
    wait_for(lambda: not rig.player.has_card, "the clock")
    rig.go_round()
    assert position - FRAME_PERIOD <= rig.player.position <= position
    assert rig.player.take_analyses() == []


def test_a_card_that_sleeps_is_waited_for_and_what_is_asked_meanwhile_is_done(rig: Rig) -> None:
    rig.player.loop = True
    rig.player.play()
    rig.hear(33)
    first = rig.output
    first.lost = True
    rig.sleepy = True
    rig.player.take_analyses()
    wait_for(lambda: rig.output is not first, "the card that sleeps")
    rig.player.seek(0.1)
    wait_for(lambda: rig.player._target is None, "the seek, while the card sleeps")
    assert not rig.output.closed
    rig.output.alive = True
    wait_for(lambda: rig.player.has_card, "the card that has slept")


def test_a_player_that_waits_hands_out_every_frame_once_though_the_card_goes(path: Path) -> None:
    first, second = HandDrivenOutput(), HandDrivenOutput()
    cards = Cards(first)
    player = Player(SoundReader(path), PRESET, cards, waits=True)
    taken: list[Analysis] = []

    def heard_on(card: HandDrivenOutput, n_frames: int) -> bool:
        card.move(HOP)
        taken.extend(player.take_analyses())
        return len(frames_of(taken)) >= n_frames

    player.play()
    wait_for(lambda: heard_on(first, 33), "some frames")
    n, first.lost = len(frames_of(taken)), True
    taken += player.take_analyses()
    wait_for(lambda: cards.n_asked > 2, "two looks for a card")  # on the clock, all would be over by then
    taken += player.take_analyses()
    assert len(frames_of(taken)) == n
    cards.there.append(second)
    wait_for(lambda: heard_on(second, N_FRAMES), "the rest")
    assert frames_of(taken) == list(range(N_FRAMES))
    player.close()


def test_a_player_that_waits_says_why_there_is_no_card(path: Path) -> None:
    player = Player(SoundReader(path), PRESET, Cards(), waits=True)
    player.play()
    with pytest.raises(DeviceError, match=r"^the sound card is not there$"):
        player.take_analyses()
    player.close()


def test_frames_that_nobody_takes_are_dropped_and_counted(path: Path) -> None:
    rig = Rig(path, kind=ForgetfulPlayer)
    rig.output.ahead = 10 * len(SPEECH)
    rig.player.play()
    rig.settle()
    rig.output.move(1e9)
    taken = frames_of(rig.player.take_analyses())
    assert rig.player.n_dropped == N_FRAMES - len(taken) > 0
    assert taken == list(range(N_FRAMES - len(taken), N_FRAMES))
    rig.player.close()


def test_closing_ends_the_thread_and_lets_file_and_device_go(path: Path) -> None:
    before = set(threading.enumerate())
    for state in ("standing", "playing", "paused", "seeking", "ended"):
        rig = Rig(path)
        if state != "standing":
            rig.player.play()
        if state == "paused":
            rig.player.pause()
        if state == "seeking":
            rig.player.seek(1.0)
        if state == "ended":
            rig.hear_all()
        rig.player.close()
        assert rig.output.closed, state
        assert rig.player.reader._raw.closed, state
    assert set(threading.enumerate()) == before


class DueWhileCleared(int):
    """When a block is due; another thread clears the queue while this is looked at."""

    def __new__(cls, queue: PlaybackQueue) -> "DueWhileCleared":
        made = super().__new__(cls, 0)
        made.clearing = threading.Thread(target=queue.clear)
        return made

    clearing: threading.Thread

    def __le__(self, heard: float) -> bool:
        self.clearing.start()
        self.clearing.join(timeout=0.2)  # it is through only where nothing holds it back
        return super().__le__(int(heard))


def test_a_seek_between_looking_and_taking_trips_nobody(path: Path) -> None:
    queue, analysis = PlaybackQueue(most=5), offline(path)
    due = DueWhileCleared(queue)
    queue.append(due, analysis)
    assert queue.pop_due(0) == [analysis]
    due.clearing.join()
    assert not queue
