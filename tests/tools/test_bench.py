"""What the benchmark says of a figure on machines of all kinds."""

import subprocess

import pytest

from tests.conftest import ROOT
from tools.bench import speed
from tools.bench.figures import Absolute, Figure

LEARNED = Figure("learned recogniser, one frame", "310 µs", "150 µs", 2.07, 1.0, absolute=Absolute.TIME)


def slow(time: float, work: float = 1.0) -> dict[Absolute, float]:
    return {Absolute.TIME: time, Absolute.WORK: work}


def test_on_the_machine_for_which_a_limit_was_set_it_stays_as_it_is():
    assert LEARNED.here(slow(1.0)) == LEARNED
    assert LEARNED.here(slow(1.0)).verdict == "OVER THE LIMIT"


def test_a_time_may_be_as_much_longer_as_the_machine_is_slower():
    slower = LEARNED.here(slow(2.9))
    assert (slower.limit, slower.ratio, slower.verdict) == (2.9, 2.07, "ok")
    assert LEARNED.here(slow(2.0)).verdict == "OVER THE LIMIT"


def test_a_time_must_be_as_much_shorter_as_the_machine_is_faster():
    fast = Figure("mouth, one picture", "20 µs", "30 µs", 0.67, 1.0, absolute=Absolute.TIME)
    assert fast.here(slow(0.5)).verdict == "OVER THE LIMIT"


@pytest.mark.parametrize("slowness", [0.5, 1.0, 3.0])
def test_a_ratio_to_what_is_measured_in_the_same_run_is_the_same_on_all_machines(slowness: float):
    figure = Figure("one frame, all steps", "81 µs", "scipy.fft.rfft(512) 4.43 µs", 18.4, limit=5.0)
    assert figure.here(slow(slowness)) == figure


def test_a_share_of_a_core_is_measured_by_what_the_processor_can_do_however_busy_it_is():
    share = Figure("window at 60 fps", "32 % of a core", "one busy core", 0.32, 0.30, absolute=Absolute.WORK)
    assert share.here(slow(5.0)).verdict == "OVER THE LIMIT"
    assert share.here(slow(5.0, work=1.5)).limit == pytest.approx(0.45)


def test_how_fast_the_machine_is_stands_before_the_table():
    assert speed.in_words({Absolute.TIME: 18e-6, Absolute.WORK: 9e-6}) == (
        "scipy.fft.rfft of 512 values takes 18.00 µs here, and 9.00 µs of the processor, instead of 4.5 µs: "
        "limits of times are scaled by 4.00, those of shares of a core by 2.00"
    )


def test_no_file_of_the_project_has_a_name_that_programs_take_for_an_option():
    listed = subprocess.run(["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=False).stdout
    assert [name for name in listed.splitlines() if name.startswith("-") or "/-" in name] == []
