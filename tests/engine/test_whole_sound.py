"""A whole sound in the background: all of it is what a file's analysis gives, and what is in view comes first."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import soundfile

from phonemeengine.analyser import Analysis, analyse_file, concatenate_analyses
from phonemeengine.audio.files import SoundReader
from phonemeengine.errors import AudioError
from phonemeengine.execution import Cancelled
from phonemeengine.inspection.whole_sound import FrameRange, FrameState, SoundTracks, analyse_whole, tracks_of
from phonemeengine.presets.files import load_preset
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import SAMPLE_RATE, ModelKind
from tests.conftest import ROOT
from tests.fakes.whisper_model import encoder_head

DEMO = ROOT / "phonemeanalyser" / "demo" / "demo.flac"
SECONDS = 32


@pytest.fixture(scope="module")
def long(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The demo again and again, with a click in the middle."""
    samples, _ = soundfile.read(DEMO, dtype="float32")
    sound = np.resize(samples, SECONDS * SAMPLE_RATE + 123)
    sound[16 * SAMPLE_RATE] = -1.0
    path = tmp_path_factory.mktemp("long") / "long.wav"
    soundfile.write(path, sound, SAMPLE_RATE, subtype="FLOAT")
    return path


def whole(path: Path, preset: Preset) -> Analysis:
    with SoundReader(path) as reader:
        return concatenate_analyses(list(analyse_file(reader, preset, pitch=True)))


def empty(path: Path) -> SoundTracks:
    with SoundReader(path) as reader:
        return tracks_of(reader)


@pytest.mark.parametrize("name", ["thesis", "learned"])
def test_all_of_it_is_what_the_file_gives(long: Path, name: str):
    preset, tracks = load_preset(name), empty(long)
    analyse_whole(lambda: SoundReader(long), preset, tracks, in_view=lambda: FrameRange(2900, 3000))
    expected = whole(long, preset)
    assert (tracks.states == FrameState.KNOWN).all()
    assert tracks.names == expected.features.names
    for name_of in ("recognised", "phonemes", "intensities"):
        np.testing.assert_array_equal(getattr(tracks, name_of), getattr(expected, name_of))
    np.testing.assert_array_equal(tracks.confidences(), expected.confidences)
    np.testing.assert_array_equal(tracks.values, expected.features.values)
    assert tracks.peaks.n_samples == SECONDS * SAMPLE_RATE + 123
    assert tracks.peaks.between(0, tracks.peaks.n_samples, 32).low.argmin() in (15, 16)


def test_what_is_in_view_is_found_first_and_follows_the_eye(long: Path):
    preset, tracks, known = load_preset("learned"), empty(long), []
    views = iter([FrameRange(1600, 1700), *[FrameRange(2600, 2700)] * 1000])

    def watch(share: float) -> bool:
        known.append((share, tracks.is_known(FrameRange(1600, 1700)), tracks.is_known(FrameRange(2600, 2700))))
        return True

    analyse_whole(lambda: SoundReader(long), preset, tracks, in_view=lambda: next(views), progress=watch)
    first = next(share for share, one, _ in known if one)
    second = next(share for share, _, other in known if other)
    assert first <= second < 0.6  # long before their turn
    expected = whole(long, preset)
    np.testing.assert_array_equal(tracks.phonemes, expected.phonemes)


def test_a_preview_is_what_will_be_found_in_its_turn(long: Path):
    preset, tracks = load_preset("learned"), empty(long)

    def once(_share: float) -> bool:
        return not tracks.is_known(FrameRange(1600, 1700))

    with pytest.raises(Cancelled):
        analyse_whole(
            lambda: SoundReader(long), preset, tracks, in_view=lambda: FrameRange(1600, 1700), progress=once
        )
    expected = whole(long, preset)
    assert np.mean(tracks.phonemes[1600:1700] == expected.phonemes[1600:1700]) > 0.95
    assert tracks.states[2000] == FrameState.UNKNOWN


def test_other_settings_outdate_what_is_known_and_it_stays_to_be_seen(long: Path):
    preset, tracks = load_preset("thesis"), empty(long)
    analyse_whole(lambda: SoundReader(long), preset, tracks)
    before = tracks.phonemes.copy()
    other = replace(preset, settings=replace(preset.settings, statistics=False))
    with pytest.raises(Cancelled):
        analyse_whole(lambda: SoundReader(long), other, tracks, progress=lambda share: share < 0.5)
    assert tracks.states[100] == FrameState.KNOWN
    assert tracks.states[-100] == FrameState.OUTDATED
    assert tracks.phonemes[-100] == before[-100]
    analyse_whole(lambda: SoundReader(long), other, tracks)
    np.testing.assert_array_equal(tracks.phonemes, whole(long, other).phonemes)
    assert tracks.peaks.n_samples == SECONDS * SAMPLE_RATE + 123  # the outline did not grow twice


def test_the_outline_goes_on_where_a_cancelled_analysis_left_it(long: Path):
    tracks = empty(long)
    with pytest.raises(Cancelled):
        analyse_whole(lambda: SoundReader(long), load_preset("thesis"), tracks, progress=lambda share: share < 0.4)
    assert 0 < tracks.peaks.n_samples < SECONDS * SAMPLE_RATE
    analyse_whole(lambda: SoundReader(long), load_preset("thesis"), tracks)
    assert tracks.peaks.n_samples == SECONDS * SAMPLE_RATE + 123


def test_more_in_view_than_a_minute_is_found_in_its_turn(long: Path):
    tracks, known = empty(long), []

    def watch(_share: float) -> bool:
        known.append(tracks.states == FrameState.KNOWN)
        return len(known) < 2

    view = FrameRange(1000, 3000)
    with pytest.raises(Cancelled):
        analyse_whole(
            lambda: SoundReader(long),
            load_preset("thesis"),
            tracks,
            in_view=lambda: view,
            progress=watch,
            most_previewed=300,
        )
    assert known[-1][1000:1300].all()
    assert not known[-1][1300:].any()


def test_with_whisper_a_faster_model_comes_first(whisper: Path):
    tracks, shares = empty(DEMO), []
    preset = replace(load_preset("learned"), encoder_head=encoder_head(), file_model=ModelKind.WHISPER)
    analyse_whole(
        lambda: SoundReader(DEMO),
        preset,
        tracks,
        progress=lambda share: shares.append((share, tracks.states.all())) or True,
    )
    assert next(share for share, all_seen in shares if all_seen) <= 0.5
    np.testing.assert_array_equal(tracks.phonemes, whole(DEMO, preset).phonemes)
    assert (tracks.states == FrameState.KNOWN).all()


def test_a_sound_that_vanishes_leaves_what_was_found(tmp_path: Path, long: Path):
    tracks = empty(long)
    with pytest.raises(AudioError):
        analyse_whole(lambda: SoundReader(tmp_path / "gone.wav"), load_preset("thesis"), tracks)
    assert (tracks.states == FrameState.UNKNOWN).all()
