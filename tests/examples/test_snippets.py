"""Every line of Python in the README and the documentation runs."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

from tests.conftest import ROOT

IN_FILES = {"adding.md", "ten-lines.md"}
"""Pages whose Python are files of the program; `tests.tools.test_adding` and `test_ten_lines` run them."""
PAGES = [ROOT / "README.md", *sorted(p for p in (ROOT / "docs").glob("*.md") if p.name not in IN_FILES)]
"""In English: `tests.tools.test_german_pages` holds the code of the German ones beside theirs."""
DEMO = Path("phonemeanalyser") / "demo"


def python_in(page: Path) -> str:
    """The Python of a page, each line where it is in the page, so that an error names the place."""
    lines, inside = [], False
    for line in page.read_text(encoding="utf-8").splitlines():
        is_fence = line.lstrip().startswith("```")
        lines.append(line if inside and not is_fence else "")
        if is_fence:
            inside = not inside and line.strip() == "```python"
    return "\n".join(lines)


RUN_EACH = """
import os, runpy, sys
for page in sys.argv[1:]:
    os.chdir(os.path.dirname(page))
    runpy.run_path(page)
"""


def test_the_python_of_each_page_runs_from_its_beginning_to_its_end(tmp_path: Path) -> None:
    pages = []
    for page in (page for page in PAGES if python_in(page).strip()):
        folder = tmp_path / f"{len(pages)}"
        shutil.copytree(ROOT / DEMO, folder / DEMO)
        (folder / page.name).write_text(python_in(page), encoding="utf-8")
        pages.append(str(folder / page.name))
    assert len(pages) > 5
    path = os.pathsep.join([str(ROOT / "engine"), str(ROOT), os.environ.get("PYTHONPATH", "")])
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", RUN_EACH, *pages],
        env=os.environ | {"PYTHONPATH": path},
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    assert done.returncode == 0, done.stderr


def test_the_readme_shows_the_engine_at_work() -> None:
    assert "from phonemeengine import" in python_in(PAGES[0])


def test_only_python_is_taken_from_a_page(tmp_path: Path) -> None:
    page = tmp_path / "page.md"
    page.write_text("say\n```sh\nmake\n```\n```python\na = 1\nb = a\n```\nso\n```python\nc = b\n```\n")
    assert python_in(page).split("\n") == ["", "", "", "", "", "a = 1", "b = a", "", "", "", "c = b", ""]
