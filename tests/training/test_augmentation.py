"""Rooms, recorders and sounds under speech, against physics."""

import numpy as np
import pytest

from phonemeengine.calibration.scores.added_noise import BACKGROUNDS, music
from phonemeengine.settings import SAMPLE_RATE
from phonemetraining.augmentation import (
    CHAINS,
    CODECS,
    HIGH,
    RANGE,
    SNRS,
    SPEED_OF_SOUND,
    Augmentation,
    Room,
    augment,
    automatic_gain,
    codec,
    draw_augmentation,
    draw_room,
    impulse_response,
    microphone,
    overdrive,
    telephone,
)
from tests.sounds import noise, silence, tone, vowel

OFFICE = Room((5.0, 4.0, 2.7), (1.0, 1.5, 1.2), (1.6, 1.5, 1.2), (0.5, 0.5))


def speech(seconds: float = 1.0) -> np.ndarray:
    """A vowel that comes and goes, in faint noise."""
    swell = np.sin(np.pi * np.arange(int(seconds * SAMPLE_RATE)) / SAMPLE_RATE * 3) ** 2
    return np.asarray(0.3 * vowel((700, 1200, 2500), seconds, 120) * swell + noise(seconds, 1e-3), np.float32)


def decay_of(response: np.ndarray) -> float:
    """The time of 60 dB by M. Schroeder's backward integration, from -5 to -25 dB, seconds."""
    energy = np.cumsum(response[::-1].astype(float) ** 2)[::-1]
    decibels = 10 * np.log10(energy / energy[0])
    first, last = (int(np.argmax(decibels < level)) for level in (-5, -25))
    return 3 * (last - first) / SAMPLE_RATE


# -- rooms -------------------------------------------------------------------------------------------------


def test_the_direct_sound_comes_first_with_the_level_that_it_had():
    response = impulse_response(OFFICE, np.random.default_rng(0))
    assert response[0] == pytest.approx(1, abs=0.05)
    assert np.abs(response).argmax() == 0


def test_the_floor_reflects_when_its_image_is_heard():
    """Mouth and microphone 1.2 m above the floor and 0.6 m apart: the way over the floor is 2.47 m long."""
    response = impulse_response(OFFICE, np.random.default_rng(0))
    late = (np.hypot(0.6, 2.4) - 0.6) / SPEED_OF_SOUND * SAMPLE_RATE
    before, after = response[20 : round(late) - 3], response[round(late) - 3 : round(late) + 4]
    assert np.abs(after).max() > 5 * np.abs(before).max()
    assert 0.6 / np.hypot(0.6, 2.4) * 0.5 < after.max() < 0.6 / np.hypot(0.6, 2.4)  # 1 / r, less what the floor keeps


@pytest.mark.parametrize("decay", [0.25, 0.5, 1.0])
def test_the_sound_of_a_room_decays_as_is_asked(decay: float):
    room = Room(OFFICE.size, OFFICE.mouth, (3.5, 2.5, 1.5), (decay, decay))
    assert decay_of(impulse_response(room, np.random.default_rng(1))) == pytest.approx(decay, rel=0.2)


def test_walls_keep_high_frequencies_if_they_are_to():
    room = Room(OFFICE.size, OFFICE.mouth, (3.5, 2.5, 1.5), (0.6, 0.2))
    late = impulse_response(room, np.random.default_rng(1))[int(0.2 * SAMPLE_RATE) :]
    powers = np.abs(np.fft.rfft(late)) ** 2
    frequencies = np.fft.rfftfreq(len(late), 1 / SAMPLE_RATE)
    low, high = (powers[(frequencies > a) & (frequencies < b)].mean() for a, b in ((200, 1000), (6000, 8000)))
    assert low > 30 * high


def test_a_nearer_microphone_hears_less_of_the_room():
    near, far = (
        impulse_response(
            Room(OFFICE.size, OFFICE.mouth, (1.0 + d, 1.5, 1.2), OFFICE.decays), np.random.default_rng(0)
        )
        for d in (0.05, 2.0)
    )
    assert np.sum(far[50:] ** 2) > 100 * np.sum(near[50:] ** 2)


def test_every_drawn_room_holds_mouth_and_microphone():
    generator = np.random.default_rng(0)
    for room in (draw_room(generator) for _ in range(300)):
        for place in (room.mouth, room.microphone):
            assert all(0 < x < length for x, length in zip(place, room.size, strict=True))
        assert 0.02 < room.distance <= 3
    assert np.isfinite(impulse_response(room, generator)).all()


# -- recorders ---------------------------------------------------------------------------------------------


@pytest.mark.parametrize("seed", {int(np.random.default_rng(s).integers(len(CODECS))): s for s in range(40)}.values())
def test_codecs_leave_the_sound_in_its_place(seed: int):
    """The seeds draw each codec once."""
    sound = speech()
    heard = codec(sound, np.random.default_rng(seed))
    from scipy.signal import correlate  # it takes seconds, as test files are read by each process

    lag = int(correlate(heard, sound).argmax()) - (len(sound) - 1)
    assert abs(lag) <= SAMPLE_RATE // 1000
    assert len(heard) == len(sound)
    assert np.corrcoef(heard, sound)[0, 1] > 0.5
    assert not np.array_equal(heard, sound)


def test_a_telephone_hears_300_to_3400_hertz_only():
    generator = np.random.default_rng(0)
    levels = {
        f: np.std(telephone(tone(f, 0.5, 0.5), generator)) / np.std(tone(f, 0.5, 0.5)) for f in (150, 1000, 5000)
    }
    assert levels[1000] == pytest.approx(1, abs=0.05)
    assert levels[150] < 0.05
    assert levels[5000] < 0.05


def test_an_automatic_gain_brings_loud_and_soft_nearer_together():
    sound = np.concatenate((tone(500, 2.0, 0.5), tone(500, 2.0, 0.02)))
    heard = automatic_gain(sound, np.random.default_rng(0))
    loud, soft = (np.std(heard[k : k + SAMPLE_RATE]) for k in (SAMPLE_RATE // 2, int(2.5 * SAMPLE_RATE)))
    assert loud / soft < 0.6 * 25


def test_overdrive_cuts_the_peaks_and_nothing_else():
    sound = speech()
    heard = overdrive(sound, np.random.default_rng(0))
    most = np.abs(heard).max()
    assert most < 0.95 * np.abs(sound).max()
    np.testing.assert_array_equal(heard[np.abs(sound) < most], sound[np.abs(sound) < most])


def test_a_microphone_changes_the_colour_and_not_the_time():
    click = np.zeros(SAMPLE_RATE, np.float32)
    click[20000] = 1
    heard = microphone(click, np.random.default_rng(0))
    assert abs(int(np.abs(heard).argmax()) - 20000) <= 2
    assert np.abs(np.fft.rfft(heard))[5] < 0.1 * np.abs(np.fft.rfft(heard))[1000]


# -- sounds under speech -----------------------------------------------------------------------------------


@pytest.mark.parametrize("background", BACKGROUNDS)
def test_backgrounds_are_as_loud_as_is_said_and_none_is_like_another(background):
    one, other = (background(3 * SAMPLE_RATE, np.random.default_rng(seed)) for seed in (0, 1))
    for sound in (one, other):
        assert len(sound) == 3 * SAMPLE_RATE
        assert np.sqrt(np.mean(sound.astype(float) ** 2)) == pytest.approx(1, abs=0.01)
    assert abs(np.corrcoef(one, other)[0, 1]) < 0.3


def test_music_has_harmonics_and_a_beat():
    sound = music(8 * SAMPLE_RATE, np.random.default_rng(3))
    powers = np.abs(np.fft.rfft(sound)) ** 2
    assert np.sort(powers)[::-1][: len(powers) // 100].sum() > 0.5 * powers.sum()  # few lines hold most of it


def test_sounds_under_speech_are_as_much_softer_as_is_drawn():
    sound = speech(3.0)
    heard = augment(sound, Augmentation(background=True), np.random.default_rng(0))
    ratio = 20 * np.log10(np.std(sound) / np.std(heard - sound))
    assert SNRS[0] - 1 < ratio < SNRS[1] + 1


# -- all together ------------------------------------------------------------------------------------------


def test_a_part_of_the_variations_stays_dry_and_the_same_seed_draws_the_same():
    generator = np.random.default_rng(0)
    drawn = [draw_augmentation(generator) for _ in range(2000)]
    dry = sum(not (v.reverberates or v.background or v.chain) for v in drawn) / len(drawn)
    assert 0.2 < dry < 0.4
    for _, step in CHAINS:
        assert any(step in v.chain for v in drawn)
    high = [v.rate for v in drawn if v.rate / v.warp > 1.01 * RANGE[1]]  # formants above those of adults
    assert 0.8 * HIGH < len(high) / len(drawn) <= HIGH + 0.03
    assert min(high) > 1
    generator = np.random.default_rng(0)
    assert drawn == [draw_augmentation(generator) for _ in range(2000)]


@pytest.mark.parametrize(
    "sound", [silence(0.5), np.zeros(0, np.float32), np.zeros(3, np.float32), tone(300, 0.02, 1)]
)
def test_silence_and_the_shortest_sounds_survive_everything(sound: np.ndarray):
    everything = Augmentation(1.1, 1.0, True, True, tuple(step for _, step in CHAINS))
    heard = augment(sound, everything, np.random.default_rng(0))
    assert len(heard) == pytest.approx(len(sound) / 1.1, abs=2)
    assert np.isfinite(heard).all()
    assert not heard.any() or sound.any()
