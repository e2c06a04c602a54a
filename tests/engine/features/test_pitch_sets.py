"""Sets of PhonemeData that the pitch of the voice chooses: known voices, cut anywhere, live and retuned."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import soundfile

from phonemeengine.analyser import Analyser, analyse_blocks, analyse_range
from phonemeengine.audio.files import SoundReader
from phonemeengine.errors import PresetError, SettingsError
from phonemeengine.features.front_end import LEAST_VOICED, PitchSetChooser
from phonemeengine.inspection.whole_sound import RetunedSound, analyse_whole, tracks_of
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.document import preset_from_toml, preset_to_toml
from phonemeengine.presets.files import beyond_phoneme_data, load_preset
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.rules import PhonemeData, PitchSet
from phonemeengine.shipping.targets import format_ear
from tests.conftest import ROOT
from tests.sounds import Sound, silence, vowel

NEUTRAL = (500.0, 1500.0, 2500.0)
ALWAYS = {"silence_zero_crossings": 3e3, "silence_energy": 1e3, "silence_max_energy": 1e3, "silence_szsch1": 1e3}
NEVER = {"silence_energy": 0.0, "szsch_szsch1": 1e3, "p_p1": 1e3, "ae_ae1": 1e3, "ouim_ae1": 1e3}


def saying(phoneme: Phoneme, **filters: float) -> PhonemeData:
    """Return numbers that call every voiced frame the same."""
    numbers = {
        Phoneme.SILENCE: ALWAYS,
        Phoneme.M: {**NEVER, "u_o1": 1e3, "o_o1": 1e3, "i_o1": 1e3},
        Phoneme.U: {**NEVER, "u_o1": -1.0},
    }[phoneme]
    return PhonemeData(**numbers, **filters)


def by_pitch(*sets: PitchSet) -> Preset:
    preset = Preset().with_phoneme_data(saying(Phoneme.SILENCE))
    return replace(preset, settings=replace(preset.settings, statistics=False), pitch_sets=sets)


MAN = PitchSet("man", 60, 160, saying(Phoneme.M))
WOMAN = PitchSet("woman", 160, 300, saying(Phoneme.U, frequency_smooth=0.5, high_pass_start=3.0))
PRESET = by_pitch(MAN, WOMAN)


def man_then_woman() -> Sound:
    return np.concatenate([vowel(NEUTRAL, 2.0, f0=110), vowel(NEUTRAL, 2.0, f0=220)])


def chosen(*pitches: tuple[float, int]) -> list[int]:
    """Return the numbers of the sets after frames of each pitch."""
    chooser = PitchSetChooser([(60, 160), (160, 300)])
    return [int(chooser.choose(np.full(n, pitch, np.float32))[-1, 1]) for pitch, n in pitches]


def test_a_set_is_chosen_once_the_pitch_is_known_and_stays_within_a_semitone_of_its_range() -> None:
    assert chosen((110, LEAST_VOICED - 1), (0, 500), (110, 1)) == [0, 0, 1]
    assert chosen((150, 100), (168, 100), (171, 100)) == [1, 1, 2]
    assert chosen((200, 100), (152, 100), (150, 100)) == [2, 2, 1]
    assert chosen((110, 100), (400, 100)) == [1, 0]


def test_the_pitch_is_the_median_of_the_last_second_of_voice() -> None:
    chooser = PitchSetChooser([(60, 160)])
    assert chooser.choose(np.full(100, 100, np.float32))[-1].tolist() == [100, 1]
    assert chooser.choose(np.full(49, 200, np.float32))[-1].tolist() == [100, 1]
    assert chooser.choose(np.full(2, 200, np.float32))[-1].tolist() == [200, 0]


def test_each_voice_is_recognised_with_its_own_numbers() -> None:
    (found,) = [Analyser(PRESET).push(man_then_woman())]
    assert set(found.phonemes[:20].tolist()) == {Phoneme.SILENCE}  # the preset's own numbers, before any pitch
    assert set(found.phonemes[50:190].tolist()) == {Phoneme.M}
    assert set(found.phonemes[-50:].tolist()) == {Phoneme.U}
    assert found.features["pitch_set"][[0, 100, -1]].tolist() == [0, 1, 2]
    assert found.features["voice_pitch"][100] == pytest.approx(110, rel=0.01)


def test_a_set_brings_its_own_filters() -> None:
    (found,) = [Analyser(PRESET).push(man_then_woman())]
    (alone,) = [Analyser(PRESET.by_pitch[2]).push(man_then_woman())]
    np.testing.assert_array_equal(found.spectra[-50:], alone.spectra[-50:])
    assert (found.spectra[100] != alone.spectra[100]).any()


@pytest.mark.parametrize("size", [700, 30_000])
def test_it_does_not_matter_how_the_sound_is_cut(size: int) -> None:
    sound = man_then_woman()
    whole = Analyser(PRESET, live=True).push(sound)
    blocks = [sound[k : k + size] for k in range(0, len(sound), size)]
    parts = list(analyse_blocks(blocks, PRESET))
    for name in ("phonemes", "recognised"):
        joined = np.concatenate([getattr(part, name) for part in parts])
        np.testing.assert_array_equal(joined[: len(whole)], getattr(whole, name))


def test_a_sound_that_is_recognised_anew_says_what_its_analysis_says() -> None:
    def reader() -> SoundReader:
        return SoundReader(ROOT / "tests" / "data" / "cards.flac")

    thesis = load_preset("thesis")
    factory = PitchSet("man", 60, 130, thesis.phoneme_data)
    preset = replace(thesis, pitch_sets=(factory, PitchSet("woman", 130, 300, PhonemeData(time_smooth=0.5))))
    changed = replace(
        preset,
        pitch_sets=(replace(factory, data=replace(factory.data, silence_energy=0.4)), preset.pitch_sets[1]),
        settings=replace(preset.settings, hysteresis=0.2),
    )
    with reader() as opened:
        tracks, expected = tracks_of(opened), tracks_of(opened)
    analyse_whole(reader, preset, tracks)
    analyse_whole(reader, changed, expected)
    assert (tracks.phonemes != expected.phonemes).any()
    assert RetunedSound(tracks, preset).retune(changed)
    np.testing.assert_array_equal(tracks.phonemes, expected.phonemes)
    np.testing.assert_allclose(tracks.confidences(), expected.confidences(), rtol=1e-3)
    with_other_range = replace(preset, pitch_sets=(replace(factory, high=120), preset.pitch_sets[1]))
    assert not RetunedSound(tracks, preset).retune(with_other_range)


def test_a_place_in_a_file_is_recognised_as_in_the_whole_file(tmp_path: Path) -> None:
    sound = np.concatenate([vowel(NEUTRAL, 1.0, f0=110), silence(3.0), vowel(NEUTRAL, 0.5, f0=110)])
    soundfile.write(tmp_path / "pause.wav", sound, 44_100)
    with SoundReader(tmp_path / "pause.wav") as reader:
        (found,) = analyse_range(reader, 405, 420, PRESET)
    assert set(found.phonemes.tolist()) == {Phoneme.M}  # not the preset's own numbers, though it was silent before


def test_sets_are_saved_and_read() -> None:
    text = preset_to_toml(PRESET)
    assert "[[pitch_sets]]" in text
    assert preset_from_toml(text, Path()) == PRESET
    assert "the pitch sets" in beyond_phoneme_data(PRESET)


@pytest.mark.parametrize(
    ("low", "high"), [(160, 160), (200, 100), (10, 100), (100, 900), (float("nan"), 100)], ids=str
)
def test_a_range_is_refused_that_no_voice_can_have(low: float, high: float) -> None:
    with pytest.raises(SettingsError, match=r"'man' must range upwards within 60..500 Hz"):
        replace(MAN, low=low, high=high)
    with pytest.raises(SettingsError, match="a pitch set has no name; give it one, such as woman"):
        replace(MAN, name=" ")


def test_the_runtime_says_that_it_cannot_choose_by_pitch() -> None:
    with pytest.raises(PresetError, match="ship one preset for each set"):
        format_ear(PRESET)


def test_another_recogniser_leaves_the_sets_unused() -> None:
    preset = replace(load_preset("templates"), pitch_sets=PRESET.pitch_sets)
    assert preset.pitch_ranges == ()
    assert "pitch_set" not in Analyser(preset).push(vowel(NEUTRAL, 0.5)).features.names
