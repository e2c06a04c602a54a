"""PhonemeData files: 21 numbers in six lines, read generously, refused with the place."""

from dataclasses import asdict, fields

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from phonemeengine.errors import PresetError
from phonemeengine.presets.files import format_phoneme_data, parse_phoneme_data
from phonemeengine.recognition.rules import PhonemeData

NAMES = (
    "time_smooth",
    "frequency_smooth",
    "high_pass_start",
    "high_pass_end",
    "denoise_threshold",
    "silence_zero_crossings",
    "silence_energy",
    "silence_max_energy",
    "silence_szsch1",
    "szsch_szsch1",
    "sz_s1",
    "p_max_energy",
    "p_energy_n",
    "p_p1",
    "p_p2",
    "ae_ae1",
    "a_a1",
    "ouim_ae1",
    "u_o1",
    "o_o1",
    "i_o1",
)
COUNTING = "1,2,3,4,5\n6,7,8,9\n10,11\n12,13,14,15\n16,17\n18,19,20,21\n"
EXAMPLE = PhonemeData(**{name: float(k) for k, name in enumerate(NAMES, 1)})
float32 = st.floats(width=32, allow_nan=False, allow_infinity=False)


def test_there_are_twenty_one_numbers():
    assert len(NAMES) == 21
    assert {f.name for f in fields(PhonemeData)} == set(NAMES)


def test_the_layout_is_six_lines_in_the_order_of_the_thesis():
    assert format_phoneme_data(EXAMPLE) == COUNTING
    assert parse_phoneme_data(COUNTING) == EXAMPLE


@given(values=st.lists(float32, min_size=21, max_size=21))
def test_numbers_come_back_bit_by_bit(values: list[float]):
    data = PhonemeData(**dict(zip(NAMES, values, strict=True)))
    text = format_phoneme_data(data)
    back = asdict(parse_phoneme_data(text))
    before = np.array(values, np.float32).view(np.uint32)
    after = np.array([back[name] for name in NAMES], np.float32).view(np.uint32)
    np.testing.assert_array_equal(after, before)
    assert [line.count(",") for line in text.splitlines()] == [4, 3, 1, 3, 1, 3]


@given(value=st.floats(-3e38, 3e38))
def test_numbers_are_written_at_float_precision(value: float):
    written = format_phoneme_data(PhonemeData(time_smooth=value)).split(",")[0]
    assert np.float32(float(written)) == np.float32(value)


@given(
    separators=st.lists(st.sampled_from([",", ";", " ", "\n", "\r\n", "\t", ", ", " ;\n"]), min_size=22, max_size=22)
)
def test_separators_may_be_mixed(separators: list[str]):
    words = [f"{k}{separator}" for k, separator in zip(range(1, 22), separators, strict=False)]
    assert parse_phoneme_data("".join(words)) == EXAMPLE


@pytest.mark.parametrize(
    "text",
    [
        "\ufeff" + COUNTING,
        COUNTING.replace("\n", "\r\n"),
        "\ufeff" + COUNTING.replace("\n", "\r\n"),
        COUNTING.strip(),
        "\n\n" + COUNTING + "\n\n",
        COUNTING.replace(",", ", "),
        COUNTING.replace("\n", ",\n"),
        COUNTING.replace(",", ";"),
        COUNTING.replace("\n", " ").replace(",", "\n"),
        COUNTING.replace("21", "+2.1e1").replace("20", "20."),
    ],
)
def test_files_of_other_programs_are_read_too(text: str):
    assert parse_phoneme_data(text) == EXAMPLE


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("1,2,3", "one,2,3", "line 1: time_smooth must be a number, found 'one'"),
        ("3,4,5", "3,4,nan", "line 1: denoise_threshold must be a finite number, found 'nan'"),
        ("7,8", "inf,8", "line 2: silence_energy must be a finite number, found 'inf'"),
        ("7,8", "-Infinity,8", "line 2: silence_energy must be a finite number, found '-Infinity'"),
        ("10,11", "10,1e39", "line 3: sz_s1 must be a finite number, found '1e39'"),
        ("10,11", "10,0x1F", "line 3: sz_s1 must be a number, found '0x1F'"),
        ("14,15", "14,1_5", "line 4: p_p2 must be a number, found '1_5'"),
        ("14,15", "14,\u0661", "line 4: p_p2 must be a number, found '\u0661'"),
        ("16,17", "16,-", "line 5: a_a1 must be a number, found '-'"),
        ("20,21", "20,21abc", "line 6: i_o1 must be a number, found '21abc'"),
        ("20,21", "20,\x00", "line 6: i_o1 must be a number, found '\\x00'"),
    ],
)
def test_a_refusal_names_the_line_the_field_and_what_was_found(old: str, new: str, said: str):
    with pytest.raises(PresetError) as refusal:
        parse_phoneme_data(COUNTING.replace(old, new))
    assert str(refusal.value) == f"{said}; correct it"


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "holds 21 numbers, found 0; .* after line 1 is time_smooth"),
        ("\n \n", "holds 21 numbers, found 0; .* after line 1 is time_smooth"),
        ("1,2,3,4,5\n6,7", "holds 21 numbers, found 7; .* after line 2 is silence_max_energy"),
        (COUNTING.replace(",21", ""), "holds 21 numbers, found 20; .* after line 6 is i_o1"),
        (
            COUNTING + "22,23\n",
            "holds 21 numbers and ends with i_o1, found 23; remove '22' in line 7 and what follows",
        ),
        (COUNTING.replace("21", "21 end"), "found 22; remove 'end' in line 6 and what follows"),
    ],
)
def test_a_wrong_count_is_refused_with_the_place(text: str, said: str):
    with pytest.raises(PresetError, match=said):
        parse_phoneme_data(text)


def test_a_word_is_told_before_a_wrong_count():
    with pytest.raises(PresetError, match="line 1: frequency_smooth must be a number, found 'This'"):
        parse_phoneme_data("1 This is a letter")


def test_a_refusal_does_not_repeat_a_whole_book():
    with pytest.raises(PresetError) as refusal:
        parse_phoneme_data("x" * 100_000)
    assert len(str(refusal.value)) < 100


@given(text=st.text(max_size=200))
def test_any_text_is_either_read_or_refused(text: str):
    with pytest.raises(PresetError):
        parse_phoneme_data(text + " no")
