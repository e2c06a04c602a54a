"""How numbers are written beside a distribution, where there is little room."""

import pytest

from phonemeanalyser.desktop.widgets.distribution import shortest


@pytest.mark.parametrize(
    ("value", "written"),
    [
        (0.0, ("0", "0")),
        (0.0003024, ("3e-4", "3.02e-4")),
        (-0.0000104, ("-1e-5", "-1.04e-5")),
        (0.01764, ("0.018", "0.0176")),
        (12.34, ("12", "12.3")),
        (123.4, ("123", "123")),
        (1234.5, ("1234", "1234")),
    ],
)
def test_a_number_keeps_its_size_and_needs_eight_letters_at_most(value, written):
    assert (shortest(value, 2), shortest(value, 3)) == written
    assert max(map(len, written)) <= 8
