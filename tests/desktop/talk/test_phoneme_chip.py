"""The phoneme beside the sound's name: what is heard now, and nothing at rest."""

from pathlib import Path

import numpy as np
import pytest
from pytestqt.qtbot import QtBot

from phonemeanalyser.desktop.session.sources import SourceKind
from phonemeanalyser.desktop.talk.page import PhonemeChip
from phonemeanalyser.desktop.theme import DARK
from phonemeengine.audio.tone import Tone, ToneKind
from phonemeengine.phonemes import Phoneme
from tests.desktop.sessions import settled
from tests.desktop.stage import Stage
from tests.desktop.talk.desk import Desk
from tests.sounds import silence, vowel

AN_A_TO_THE_END = np.concatenate((silence(0.3), vowel((700, 1200, 2500), 0.5)))


@pytest.fixture
def stage(desk: Desk, tmp_path: Path) -> Stage:
    desk.open(tmp_path)
    desk.stage.look()
    return desk.stage


@pytest.fixture
def chip(stage: Stage, qtbot: QtBot) -> PhonemeChip:
    chip = PhonemeChip(stage.talking, DARK)
    qtbot.addWidget(chip)
    return chip


def shown(chip: PhonemeChip) -> Phoneme:
    chip.refresh()
    return chip.phoneme


def test_after_a_file_that_ends_in_the_middle_of_an_a_none_is_shown(
    stage: Stage, chip: PhonemeChip, tmp_path: Path
) -> None:
    stage.open(tmp_path, AN_A_TO_THE_END)
    seen: set[Phoneme] = set()
    stage.play(2.0, lambda: seen.add(shown(chip)))
    assert Phoneme.A in seen
    assert not stage.session.source.playing
    assert (shown(chip), chip.intensity) == (Phoneme.SILENCE, 0.0)


def test_a_pause_keeps_what_is_heard_there_and_stop_shows_none(stage: Stage, chip: PhonemeChip, qtbot: QtBot) -> None:
    stage.play(0.9)
    stage.session.pause()
    assert shown(chip) is Phoneme.A
    stage.session.stop()
    settled(stage.session, qtbot)
    assert (shown(chip), chip.intensity) == (Phoneme.SILENCE, 0.0)


def test_a_place_shows_what_is_said_there(stage: Stage, chip: PhonemeChip, qtbot: QtBot) -> None:
    for place, said in ((0.9, Phoneme.A), (0.3, Phoneme.SILENCE), (1.0, Phoneme.A)):
        stage.session.seek(place)
        settled(stage.session, qtbot)
        assert shown(chip) is said, place


def test_a_live_sound_that_is_stopped_shows_none(stage: Stage, chip: PhonemeChip) -> None:
    stage.session.playback.set_tone(Tone(kind=ToneKind.VOWEL))
    stage.session.set_source(SourceKind.TONE)
    stage.session.play()
    stage.play(0.6)
    assert shown(chip) is Phoneme.A
    stage.session.pause()
    assert (shown(chip), chip.intensity) == (Phoneme.SILENCE, 0.0)
