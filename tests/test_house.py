"""The house rules that a machine can check."""

from collections import defaultdict
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
PRODUCT = ("engine", "phonemeanalyser")
MOST = 10
"""Lines of code that may not stand twice."""


def stretches(text: str, n: int) -> dict[tuple[str, ...], int]:
    """Give all n lines that follow each other, and where they begin; layout and comments do not count."""
    lines = [(number, " ".join(line.split())) for number, line in enumerate(text.splitlines(), 1)]
    lines = [(number, line) for number, line in lines if line and not line.startswith("#")]
    return {tuple(line for _, line in lines[k : k + n]): lines[k][0] for k in range(len(lines) - n + 1)}


def repeated(texts: dict[str, str], n: int) -> list[list[str]]:
    """Give the places of all n lines that stand in two texts or more, but for imports."""
    places = defaultdict(list)
    for name, text in texts.items():
        for stretch, line in stretches(text, n).items():
            if not all(line.startswith(("import ", "from ")) for line in stretch):
                places[stretch].append(f"{name}:{line}")
    return [found for found in places.values() if len(found) > 1]


def test_no_ten_lines_of_product_code_stand_twice() -> None:
    files = [path for folder in PRODUCT for path in (ROOT / folder).rglob("*.py")]
    assert len(files) > 100
    assert repeated({str(path.relative_to(ROOT)): path.read_text(encoding="utf-8") for path in files}, MOST) == []


@pytest.mark.parametrize(("n", "found"), [(3, [["a:2", "b:1"]]), (4, [])])
def test_lines_that_stand_twice_are_found_however_they_are_laid_out(n: int, found: list[list[str]]) -> None:
    texts = {"a": "x = 1\nif y:\n    z()\n\nelse:\n", "b": "if  y:\n  # why\n  z()\nelse:\nw\n"}
    assert repeated(texts, n) == found
