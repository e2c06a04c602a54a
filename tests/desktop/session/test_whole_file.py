"""The current file is analysed whole in the background, and the timeline shows it."""

from pathlib import Path

import numpy as np
import pytest
from PySide6.QtGui import QColor

from phonemeanalyser.desktop.analyse.transport.transport import NOTHING, WAVE_HEIGHT, main_phonemes, overview_pixels
from phonemeanalyser.desktop.session.sources import SourceKind
from phonemeanalyser.desktop.theme import PHONEME_COLOURS
from phonemeengine.analyser import analyse_file, concatenate_analyses
from phonemeengine.audio.files import SoundReader
from phonemeengine.inspection.whole_sound import FrameState, SoundTracks
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import HOP, Channel
from tests.desktop.hands import CARDS, click, shown, wav
from tests.sounds import noise, silence, tone


def phonemes_in(path: Path, preset: Preset, channel: Channel = Channel.MIX) -> np.ndarray:
    with SoundReader(path, channel) as reader:
        return concatenate_analyses(list(analyse_file(reader, preset))).phonemes


def settled(desktop, qtbot) -> SoundTracks:
    qtbot.waitUntil(lambda: not desktop.session.whole.busy)
    return desktop.session.whole.tracks


def test_an_opened_file_is_known_whole_without_being_played(desktop, qtbot):
    shown(desktop, qtbot)
    tracks = settled(desktop, qtbot)
    assert (tracks.states == FrameState.KNOWN).all()
    np.testing.assert_array_equal(tracks.phonemes, phonemes_in(CARDS, desktop.preset.preset))
    assert desktop.session.history.n == 0  # nothing was heard


def test_another_preset_finds_it_anew(desktop, qtbot):
    window = shown(desktop, qtbot)
    before = settled(desktop, qtbot).phonemes.copy()
    click(window.filters.switches["statistics"])
    tracks = settled(desktop, qtbot)
    assert (tracks.phonemes != before).any()
    np.testing.assert_array_equal(tracks.phonemes, phonemes_in(CARDS, desktop.preset.preset))


def test_another_file_and_another_channel_are_known_instead(desktop, qtbot, tmp_path):
    shown(desktop, qtbot)
    settled(desktop, qtbot)
    stereo = np.stack((tone(700, 0.5, 0.5), silence(0.5)), axis=1)
    path = wav(tmp_path, stereo)
    assert desktop.session.open(path)
    tracks = settled(desktop, qtbot)
    assert tracks.n_frames == 50
    loud = tracks.intensities.copy()
    desktop.session.set_channel(Channel.RIGHT)
    assert loud.max() > 0
    assert settled(desktop, qtbot).intensities.max() == 0


def test_with_another_source_nothing_is_known(desktop, qtbot):
    shown(desktop, qtbot)
    settled(desktop, qtbot)
    desktop.session.set_source(SourceKind.TONE)
    assert desktop.session.whole.tracks is None
    desktop.session.set_source(SourceKind.FILE)
    assert settled(desktop, qtbot).n_frames > 0


def test_a_file_that_vanishes_is_said_once_and_what_was_found_stays(desktop, qtbot, tmp_path):
    path = wav(tmp_path, noise(1.0, 0.1))
    errors = []
    desktop.session.error.connect(errors.append)
    desktop.session.open(path)
    known = settled(desktop, qtbot).phonemes.copy()
    path.unlink()
    desktop.preset.set_setting("high_pass_end", 2000.0)
    qtbot.waitUntil(lambda: bool(errors))
    assert "sound.wav" in errors[0]
    np.testing.assert_array_equal(desktop.session.whole.tracks.phonemes, known)


def test_the_time_line_shows_the_waveform_in_the_colours_of_its_phonemes(desktop, qtbot):
    window = shown(desktop, qtbot)
    settled(desktop, qtbot)
    picture = window.transport.position_slider.grab().toImage()
    colours = {QColor(picture.pixel(x, y)).name() for x in range(picture.width()) for y in range(WAVE_HEIGHT)}
    spoken = set(phonemes_in(CARDS, desktop.preset.preset).tolist()) - {Phoneme.SILENCE}
    assert len(colours & {QColor(PHONEME_COLOURS[Phoneme(p)]).name() for p in spoken}) >= 3


# -- the picture ---------------------------------------------------------------------------------------


@pytest.fixture
def tracks() -> SoundTracks:
    """A second of silence, and one of an a; the last half second is not known yet."""
    tracks = SoundTracks(200)
    tracks.peaks.push(np.concatenate((silence(1.0), tone(300, 1.0, 0.8)))[: 200 * HOP])
    tracks.phonemes[100:] = Phoneme.A
    tracks.states[:150] = FrameState.KNOWN
    return tracks


def test_each_column_has_the_phoneme_of_most_of_its_frames(tracks):
    assert main_phonemes(tracks, 4).tolist() == [Phoneme.SILENCE, Phoneme.SILENCE, Phoneme.A, NOTHING]
    assert main_phonemes(tracks, 1).tolist() == [Phoneme.A]  # speech is told before silence
    assert len(main_phonemes(tracks, 1000)) == 1000
    assert (main_phonemes(SoundTracks(0), 3) == NOTHING).all()


def test_the_picture_is_as_high_as_it_is_loud(tracks):
    colours = np.arange(100, 100 + NOTHING + 1, dtype=np.uint32)
    pixels = overview_pixels(tracks, 40, colours, np.uint32(7))
    assert pixels.shape == (WAVE_HEIGHT, 40)
    assert (pixels[:, 30] != 7).sum() == WAVE_HEIGHT
    assert (pixels[:, 5] != 7).sum() == 1  # silence is a line
    assert set(pixels[:, 25].tolist()) == {100 + Phoneme.A}
    assert set(pixels[:, 35].tolist()) == {100 + NOTHING}
    assert (overview_pixels(SoundTracks(100), 40, colours, np.uint32(7)) == 7).all()


def test_a_threshold_is_heard_without_the_sound(desktop, qtbot, tmp_path):
    path = tmp_path / "cards.flac"
    path.write_bytes(CARDS.read_bytes())
    shown(desktop, qtbot, path)
    session = desktop.session
    before = settled(desktop, qtbot).phonemes.copy()
    desktop.preset.tune("silence_energy", 0.4)
    assert not session.whole.busy  # it was known at once
    found = session.whole.tracks.phonemes.copy()
    assert (found != before).any()
    np.testing.assert_array_equal(found, phonemes_in(path, desktop.preset.preset))
    desktop.preset.undo_stack.undo()
    assert not session.whole.busy
    np.testing.assert_array_equal(session.whole.tracks.phonemes, before)
    click(desktop.window.filters.switches["mel"])  # another front end
    assert session.whole.busy
    np.testing.assert_array_equal(settled(desktop, qtbot).phonemes, phonemes_in(path, desktop.preset.preset))
