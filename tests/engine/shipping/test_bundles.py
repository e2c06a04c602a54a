"""The package in the hands of bundlers: a page that vite or esbuild made listens as the module does."""

import functools
import http.server
import json
import shutil
import subprocess
import threading
from pathlib import Path

import pytest

from phonemeengine import Preset, load_preset, ship
from tests.bundlers import APP, BUNDLERS, bundled, project, tool
from tests.engine.shipping.test_demo_page import Quiet, chromium
from tests.engine.shipping.test_same_results import heard_by_engine, speech
from tests.web_ears import node

RATE, SOUND = 44_100, speech()[: 2 * 44_100]
SAME = 0.99


@pytest.fixture(scope="module")
def preset() -> Preset:
    return load_preset("learned")


@pytest.fixture(scope="module")
def package(preset: Preset, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The preset Learned, shipped as a module."""
    place = tmp_path_factory.mktemp("package")
    ship(preset, place, "web-module")
    return place


@pytest.fixture(scope="module", params=BUNDLERS)
def made(request: pytest.FixtureRequest, package: Path, tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, str]:
    """What a bundler makes of a page that imports the package, and its script."""
    return bundled(request.param, project(tmp_path_factory.mktemp(request.param) / "page", package))


def check_heard(found: list[int], preset: Preset) -> None:
    expected = heard_by_engine(preset, SOUND).phonemes[: len(found)]
    assert len(found) >= 188
    assert (expected == found).mean() >= SAME


def test_a_bundled_page_listens_in_the_thread_of_the_sound(made: tuple[Path, str], preset: Preset) -> None:
    folder, script = made
    words = [node(), str(APP / "run.mjs"), str(folder), script, str(RATE)]
    done = subprocess.run(words, input=SOUND.tobytes(), capture_output=True, check=False)
    assert done.returncode == 0, done.stderr.decode()
    check_heard(json.loads(done.stdout), preset)


@pytest.mark.browser
def test_a_bundled_page_listens_in_chromium(made: tuple[Path, str], preset: Preset) -> None:
    handler = functools.partial(Quiet, directory=str(made[0]))
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler) as server, chromium() as page:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        page.goto(f"http://localhost:{server.server_port}/")
        page.wait_for_function("() => globalThis.hear")
        check_heard(page.evaluate("([samples, rate]) => hear(samples, rate)", [SOUND.tolist(), RATE]), preset)
        server.shutdown()


def test_the_types_are_those_of_the_module(package: Path, tmp_path: Path) -> None:
    place = project(tmp_path / "page", package)
    tool(place, "tsc", "--strict", "--noEmit", "--target", "es2022", "--moduleResolution", "bundler", "types.ts")


def test_the_worklet_is_one_file_and_the_module_has_it_inside(package: Path) -> None:
    worklet = (package / "ear-worklet.js").read_text(encoding="utf-8")
    assert "import" not in worklet
    assert f"const WORKLET = {json.dumps(worklet)};" in (package / "ear.js").read_text(encoding="utf-8")


def test_a_page_that_forbids_blobs_may_name_the_worklet_s_file(package: Path, tmp_path: Path) -> None:
    place = tmp_path / "served"
    shutil.copytree(package, place)
    app = (APP / "main.js").read_text(encoding="utf-8")
    for old, new in (
        ('from "phoneme-ear"', 'from "./ear.js"'),
        ('import preset from "phoneme-ear/preset.ear?url"', 'const preset = "/preset.ear"'),
        ('import wasm from "phoneme-ear/ear.wasm?url"', 'const wasm = "/ear.wasm"'),
        ("frame.phoneme))", 'frame.phoneme), "/ear-worklet.js")'),
    ):
        assert old in app
        app = app.replace(old, new)
    (place / "main.js").write_text(app, encoding="utf-8")
    words = [node(), str(APP / "run.mjs"), str(place), "main.js", str(RATE)]
    done = subprocess.run(words, input=SOUND.tobytes(), capture_output=True, check=False)
    assert done.returncode == 0, done.stderr.decode()
    assert len(json.loads(done.stdout)) >= 188
