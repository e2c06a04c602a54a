"""The package in the hands of bundlers: a page that any of them made recognises as the engine does."""

import functools
import http.server
import json
import shutil
import subprocess
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest

from phonemeengine import Preset, load_preset
from tests.bundlers import APP, ESBUILD, MORE_PACKAGES, PACKAGES, WORDS, bundled, project, tool
from tests.engine.shipping.test_demo_page import Quiet, chromium, microphone
from tests.engine.shipping.test_same_results import recognised_by_engine, speech
from tests.firefox import in_firefox
from tests.sounds import Sound
from tests.web_ears import node

RATE = 44_100
SAME = 0.99


def said() -> Sound:
    """Give two seconds of speech."""
    return speech()[: 2 * RATE]


@pytest.fixture(scope="module")
def preset() -> Preset:
    return load_preset("learned")


def check_heard(told: dict[str, Any], preset: Preset) -> None:
    found = told["phonemes"]
    expected = recognised_by_engine(preset, said()).phonemes[: len(found)]
    assert len(found) >= 188
    assert (expected == found).mean() >= SAME
    assert told["widest"] > 0.1
    assert told["refusal"] == "EarError: this recogniser was closed; open another one"


@pytest.mark.browser
@pytest.mark.parametrize("by", ["vite", "esbuild"])
def test_a_bundled_page_listens_in_the_audio_thread(
    by: str, web_module: Path, preset: Preset, tmp_path: Path
) -> None:
    folder, script = bundled(by, project(tmp_path / "page", web_module))
    check_heard(in_node(folder, script), preset)


def in_node(folder: Path, script: str) -> dict[str, Any]:
    """Give what a page tells that runs in Node."""
    words = [node(), str(APP / "run.mjs"), str(folder), script, str(RATE)]
    done = subprocess.run(words, input=said().tobytes(), capture_output=True, check=False)
    assert done.returncode == 0, done.stderr.decode()
    told: dict[str, Any] = json.loads(done.stdout)
    return told


HEAR = """(async () => {
  while (!globalThis.hear) await new Promise(requestAnimationFrame);
  const samples = new Float32Array(await (await fetch("/samples.f32")).arrayBuffer());
  return JSON.stringify(await hear(samples, 44100));
})()"""


@pytest.mark.browser
@pytest.mark.parametrize("browser", ["chromium", "firefox"])
@pytest.mark.parametrize("by", [*WORDS, "plain"])
def test_a_page_listens_in_a_browser(by: str, browser: str, web_module: Path, preset: Preset, tmp_path: Path) -> None:
    place = project(tmp_path / "page", web_module, PACKAGES if by in ("vite", "plain") else MORE_PACKAGES)
    made = served_as_it_is(place) if by == "plain" else bundled(by, place)[0]
    (made / "samples.f32").write_bytes(said().tobytes())
    with served(made) as address:
        if browser == "firefox":
            told = in_firefox(address, HEAR, tmp_path / "profile")
        else:
            with chromium() as page:
                page.goto(address)
                told = page.evaluate(HEAR)
    check_heard(json.loads(told), preset)


def served_as_it_is(place: Path) -> Path:
    """Have the page load the package as from a server of packages, by its address; gives the folder to serve."""
    script = place / "main.js"
    module = script.read_text(encoding="utf-8").replace('"phoneme-ear"', '"/node_modules/phoneme-ear/ear.js"')
    script.write_text(module, encoding="utf-8")
    return place


@contextmanager
def served(folder: Path) -> Iterator[str]:
    """Serve a folder on this machine; gives its address."""
    handler = functools.partial(Quiet, directory=str(folder))
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://localhost:{server.server_port}/"
        server.shutdown()


@pytest.mark.browser
def test_the_examples_move_what_they_show_by_a_microphone(web_module: Path, tmp_path: Path) -> None:
    place = project(tmp_path / "page", web_module, MORE_PACKAGES)
    shutil.copytree(web_module / "examples", place / "examples")
    tool(place, "esbuild", "examples.js", *ESBUILD[1:], "--jsx=automatic")
    (place / "dist" / "index.html").write_text(
        '<canvas></canvas><div id="root"></div><script type="module" src="/assets/examples.js"></script>', "utf-8"
    )
    with served(place / "dist") as address, chromium(*microphone(tmp_path, said())) as page:
        page.goto(address)
        page.wait_for_function("() => globalThis.tryExamples")
        told = page.evaluate("() => tryExamples()")
    assert told.keys() == {"three", "vrm", "flat", "react"}
    assert all(told[name] > 0.1 for name in ("three", "vrm", "flat"))
    assert len(told["react"]) >= 3


@pytest.mark.browser
def test_the_types_are_those_of_the_module(web_module: Path, tmp_path: Path) -> None:
    place = project(tmp_path / "page", web_module)
    tool(place, "tsc", "--strict", "--noEmit", "--target", "es2022", "--moduleResolution", "bundler", "types.ts")


def test_the_worklet_is_one_file_and_the_module_has_it_inside(web_module: Path) -> None:
    worklet = (web_module / "ear-worklet.js").read_text(encoding="utf-8")
    assert "import" not in worklet
    assert f"const WORKLET = {json.dumps(worklet)};" in (web_module / "ear.js").read_text(encoding="utf-8")


def test_a_page_that_forbids_blobs_may_name_the_worklet_s_file(web_module: Path, tmp_path: Path) -> None:
    place = tmp_path / "served"
    shutil.copytree(web_module, place)
    (place / "ear-preset.js").unlink()
    app = (APP / "main.js").read_text(encoding="utf-8")
    for old, new in (
        ('from "phoneme-ear"', 'from "./ear.js"'),
        ("{ source,", '{ worklet: "/ear-worklet.js", preset: "/preset.ear", wasm: "/ear.wasm", source,'),
    ):
        assert old in app
        app = app.replace(old, new)
    (place / "main.js").write_text(app, encoding="utf-8")
    assert len(in_node(place, "main.js")["phonemes"]) >= 188
