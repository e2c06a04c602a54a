"""The feeling in a voice over time: of a file as the engine estimates it in one piece, and the same of live sound."""

from threading import Event

import numpy as np

from phonemeanalyser.desktop.session.results import History
from phonemeanalyser.desktop.session.seen_tracks import COLUMNS_AT_ONCE, FeelingTrack, LiveFeelings
from phonemeanalyser.desktop.session.time_view import TimeSpan
from phonemeengine.analyser import analyse_blocks
from phonemeengine.audio.files import SoundReader
from phonemeengine.dsp.framing import Framer
from phonemeengine.features.feeling import FeelingEstimator
from phonemeengine.presets.files import FACTORY, load_preset
from tests.desktop.hands import wav
from tests.sounds import vowel

SOUND = vowel((700.0, 1200.0, 2500.0), 3.0, f0=110)


def of_all() -> np.ndarray:
    framer = Framer()
    return FeelingEstimator().follow(np.concatenate([framer.cut_frames(SOUND), framer.finish()]))


def test_a_file_and_live_sound_show_what_the_engine_estimates(qtbot, tmp_path):
    track, path, wanted, may_open = FeelingTrack(), wav(tmp_path, SOUND), of_all(), Event()
    track.open(lambda: SoundReader(path) if may_open.wait() else None, 3.0)
    assert track.feelings_in(TimeSpan(1.0, 2.0)).at(150) is None
    with qtbot.waitSignal(track.changed):
        may_open.set()
    np.testing.assert_allclose(track.feelings_in(TimeSpan(0.0, 3.0)).felt, wanted, atol=2e-3)
    known = track.feelings_in(TimeSpan(1.0, 2.0))
    assert (known.first, known.at(99), known.at(150).activation) == (100, None, known.felt[50, 0])
    track.leave()
    assert len(track.feelings_in(TimeSpan(0.0, 3.0)).felt) == 0
    track.close()

    history = History()
    live = LiveFeelings(history)
    assert len(live.feelings_in(TimeSpan(0.0, 3.0)).felt) == 0
    for analysis in analyse_blocks([SOUND], load_preset(FACTORY / "thesis.toml")):
        history.append(analysis)
    for n in (1, 2):  # a part for each picture
        assert len(live.feelings_in(TimeSpan(0.0, 3.0)).felt) == n * COLUMNS_AT_ONCE
    live.feelings_in(TimeSpan(0.0, 3.0))
    np.testing.assert_allclose(live.feelings_in(TimeSpan(0.0, 3.0)).felt, wanted, atol=2e-3)
    live.forget()
    assert len(live.feelings_in(TimeSpan(0.0, 3.0)).felt) == COLUMNS_AT_ONCE
