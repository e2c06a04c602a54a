"""Takes that are good, and what is said of those that are not: levels are known beforehand."""

import numpy as np
import pytest

from phonemeengine.calibration.takes.quality import Fault, check_take
from phonemeengine.phonemes import Phoneme
from tests.sounds import noise, silence, tone, vowel

ROOM = 0.001
A = (750.0, 1250.0)


def in_a_room(*parts, room=ROOM):
    sound = np.concatenate(parts)
    return sound + noise(len(sound) / 44_100, room, seed=7)[: len(sound)]


def faults(samples, noise_level=ROOM, phoneme=Phoneme.A):
    report = check_take(samples, noise_level, phoneme)
    assert all(text[0].isupper() and text.endswith(".") and text.count(". ") <= 1 for text in report.faults.values())
    return list(report.faults)


def test_a_take_in_which_nothing_sounds_has_the_level_of_all_of_it():
    report = check_take(noise(1.0, 0.001), 0.001, Phoneme.A)
    assert list(report.faults) == [Fault.SILENT]
    assert report.level == pytest.approx(-60, abs=0.5)


def test_a_good_take_is_good_and_says_where_the_sound_is():
    report = check_take(in_a_room(silence(0.5), vowel(A, 1.0), silence(0.5)), ROOM, Phoneme.A)
    assert report.good
    assert (report.onset, report.offset) == pytest.approx((0.5, 1.5), abs=0.02)
    assert (report.start, report.end) == pytest.approx((0.55, 1.45), abs=0.02)


def test_the_steady_part_begins_when_the_voice_is_up_and_ends_before_it_falls():
    voice = vowel(A, 1.4)
    time = np.arange(len(voice)) / 44_100
    envelope = np.clip(np.minimum(time / 0.4, (1.4 - time) / 0.4), 0.001, 1)
    report = check_take(in_a_room(silence(0.3), (voice * envelope).astype(np.float32), silence(0.3)), ROOM, Phoneme.A)
    assert report.start == pytest.approx(0.3 + 0.2, abs=0.05)  # half as loud as its middle is -6 dB
    assert report.end == pytest.approx(0.3 + 1.2, abs=0.05)
    assert report.onset < report.start < report.end < report.offset


def test_level_and_signal_to_noise_are_those_of_the_physics():
    room = 0.1 / 2**0.5 / 10**0.5  # 10 dB below the tone
    report = check_take(tone(1000, 1.0, 0.1) + noise(1.0, room), room, Phoneme.A)
    assert report.level == pytest.approx(20 * np.log10(0.1 / 2**0.5) + 10 * np.log10(1.1), abs=0.1)
    assert report.noise == pytest.approx(20 * np.log10(room))
    assert report.snr == pytest.approx(10, abs=0.1)


def test_nothing_was_said():
    assert faults(in_a_room(silence(1.0))) == [Fault.SILENT]
    assert faults(silence(1.0), 0) == [Fault.SILENT]
    assert faults(silence(0.0), 0) == [Fault.SILENT]


def test_a_short_cry_is_too_short():
    assert faults(in_a_room(silence(0.5), vowel(A, 0.2), silence(0.5))) == [Fault.TOO_SHORT]
    assert faults(in_a_room(silence(0.5), vowel(A, 0.4), silence(0.5))) == []


def test_a_cough_in_the_midst_of_silence_is_not_the_sound():
    sound = in_a_room(vowel(A, 0.1), silence(0.4), vowel(A, 0.8), silence(0.3))
    report = check_take(sound, ROOM, Phoneme.A)
    assert report.good
    assert (report.onset, report.offset) == pytest.approx((0.5, 1.3), abs=0.02)


def test_a_short_pause_does_not_end_a_sound():
    report = check_take(in_a_room(vowel(A, 0.4), silence(0.1), vowel(A, 0.4)), ROOM, Phoneme.A)
    assert report.offset - report.onset == pytest.approx(0.9, abs=0.03)


def test_all_bursts_of_a_p_belong_together():
    bursts = [part for _ in range(4) for part in (noise(0.03, 0.1), silence(0.3))]
    report = check_take(in_a_room(silence(0.2), *bursts), ROOM, Phoneme.P)
    assert report.good
    assert (report.start, report.end) == pytest.approx((0.2, 0.2 + 3 * 0.33 + 0.03), abs=0.02)


def test_between_the_puffs_of_a_p_there_is_silence():
    puffs = np.tile(np.concatenate((noise(0.05, 0.3), silence(0.25))), 4)
    report = check_take(in_a_room(silence(0.3), puffs), ROOM, Phoneme.P)
    assert len(report.pauses) == 3
    for k, (start, end) in enumerate(report.pauses):
        assert start == pytest.approx(0.3 + 0.3 * k + 0.05, abs=0.031)
        assert end == pytest.approx(0.3 + 0.3 * (k + 1), abs=0.021)
    assert check_take(in_a_room(silence(0.3), puffs), ROOM, Phoneme.SZ).pauses == ()
    assert report.within(1.0, 2.0).pauses[0][0] == pytest.approx(1.0 + report.pauses[0][0])


def test_clipping_is_told_with_its_share():
    loud = np.clip(3 * tone(100, 1.0), -1, 1)
    report = check_take(loud, 0, Phoneme.A)
    assert list(report.faults) == [Fault.CLIPPED]
    assert report.clipped == pytest.approx(1 - 2 / np.pi * np.arcsin(1 / 3), abs=0.01)  # where 3 sin exceeds 1
    assert "a little further from the microphone" in report.faults[Fault.CLIPPED]
    assert faults(tone(100, 1.0, 0.99), 0) == []


def test_a_few_samples_at_full_scale_are_let_pass():
    sound = tone(440, 1.0, 0.5)
    sound[[100, 2000, 30_000]] = 1
    assert faults(sound, 0) == []


def test_a_whisper_in_a_quiet_room_is_too_quiet():
    assert faults(in_a_room(silence(0.3), tone(500, 1.0, 0.004), silence(0.3)), ROOM) == [Fault.TOO_QUIET]
    assert faults(tone(500, 1.0, 0.003), 0) == [Fault.TOO_QUIET]


def test_a_voice_in_a_loud_room_is_too_noisy():
    assert faults(in_a_room(silence(0.3), vowel(A, 1.0), silence(0.3), room=0.03), 0.03) == [Fault.TOO_NOISY]


def test_hissing_need_not_stand_out_as_far_as_a_vowel():
    sound = in_a_room(silence(0.3), noise(1.0, 0.004), silence(0.3))  # 12 dB above the room
    assert faults(sound, ROOM, Phoneme.SZ) == []
    assert faults(sound, ROOM, Phoneme.A) == [Fault.TOO_QUIET]


def test_a_constant_offset_is_no_sound():
    assert faults(silence(1.0) + np.float32(0.2), 0) == [Fault.SILENT]


def test_silence_is_to_be_silent():
    room = in_a_room(silence(1.0))
    report = check_take(room, ROOM, Phoneme.SILENCE)
    assert report.good
    assert (report.start, report.end) == (0, 1)
    assert faults(in_a_room(silence(0.5), vowel(A, 0.1), silence(0.5)), ROOM, Phoneme.SILENCE) == [Fault.NOT_SILENT]
    assert faults(room[:4410], ROOM, Phoneme.SILENCE) == [Fault.TOO_SHORT]
