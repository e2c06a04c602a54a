"""The demo page in Chromium, whose microphone plays a recording, and in Firefox."""

import functools
import http.server
import json
import os
import shutil
import subprocess
import threading
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import soundfile

from phonemeengine import Phoneme, load_preset, ship
from tests.engine.shipping.test_same_results import recognised_by_engine, speech
from tests.fakes.virtual_sound import VirtualSound
from tests.firefox import in_firefox
from tests.sounds import Sound, silence

pytestmark = pytest.mark.browser

SAME = 0.97
TRIES = 3
"""The browser's own microphone drops sound where the machine is busy."""
LONGEST = 60_000.0
"""Milliseconds that a page may take for anything; software draws its head."""
SOUND = speech()[: 7 * 44_100]
FIND_PHONEME = {phoneme.label: int(phoneme) for phoneme in Phoneme}

Page = Any


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The preset Learned, shipped for the web."""
    place = tmp_path_factory.mktemp("page")
    ship(load_preset("learned"), place, "web")
    return place


@pytest.fixture(scope="module")
def address(folder: Path) -> Iterator[str]:
    """The page, served from this machine."""
    handler = functools.partial(Quiet, directory=str(folder))
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://localhost:{server.server_port}/demo/"
        server.shutdown()


class Quiet(http.server.SimpleHTTPRequestHandler):
    """Serves files, and says nothing of it."""

    def log_message(self, *words: object) -> None:
        pass


@contextmanager
def chromium(*flags: str) -> Iterator[Page]:
    """Give a page of the browser; what it asks of other hosts, and what goes wrong in it, is a failure."""
    from playwright.sync_api import sync_playwright

    wrong: list[str] = []
    program = shutil.which("chromium") or shutil.which("google-chrome") or os.environ.get("CHROMIUM")
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(
            executable_path=program, args=["--no-sandbox", "--enable-unsafe-swiftshader", *flags]
        )
        page = browser.new_page(viewport={"width": 640, "height": 480})
        page.set_default_timeout(LONGEST)
        page.on("pageerror", lambda error: wrong.append(str(error)))
        page.on("request", lambda asked: wrong.append(asked.url) if "localhost" not in asked.url else None)
        page.on("requestfailed", lambda asked: wrong.append(asked.url))
        yield page
        browser.close()
    assert [word for word in wrong if not word.startswith(("data:", "blob:"))] == []


@contextmanager
def opened(address: str, *flags: str) -> Iterator[Page]:
    """Open the demo page."""
    with chromium(*flags) as page:
        page.goto(address)
        page.wait_for_selector("#microphone:not([disabled])")
        yield page


def microphone(tmp_path: Path, sound: Sound) -> tuple[str, ...]:
    """Give the flags of a microphone that plays a sound once, with a while of silence before it."""
    path = tmp_path / "microphone.wav"
    soundfile.write(path, np.concatenate((silence(2.0), sound, silence(1.0))), 44_100, subtype="PCM_16")
    words = f"--use-file-for-fake-audio-capture={path}%noloop"
    return "--use-fake-device-for-media-stream", "--use-fake-ui-for-media-stream", words


def shown(page: Page) -> np.ndarray:
    """Give the phoneme that the page shows for each frame."""
    return frames_of_rows(
        page.eval_on_selector_all("#phonemes tr", "rows => rows.map(r => [...r.cells].map(c => c.textContent))")
    )


def frames_of_rows(rows: Sequence[Sequence[str]]) -> np.ndarray:
    """Give the phoneme of each frame of the table: start, end and name in each row."""
    frames: list[int] = []
    for start, end, name in rows:
        assert round(100 * float(start)) == len(frames)
        frames += [FIND_PHONEME[name]] * (round(100 * float(end)) - len(frames))
    return np.array(frames)


def likeness(found: np.ndarray, sound: Sound) -> float:
    """Give the share of frames that are those of Python, at the moment at which the sound began, whichever it was."""
    shares = []
    for late in range(0, 441, 44):  # ms of a frame: nobody knows when the browser's microphone began
        expected = recognised_by_engine(
            load_preset("learned"), np.concatenate((np.zeros(late, np.float32), sound))
        ).phonemes
        shares += [
            float(np.mean(found[start : start + len(expected)] == expected))
            for start in range(len(found) - len(expected) + 1)
        ]
    return max(shares, default=0.0)


def wait_for_frames(page: Page, n: int) -> None:
    words = (
        f"() => Number(document.querySelector('#phonemes tr:last-child td:nth-child(2)')?.textContent) * 100 >= {n}"
    )
    page.wait_for_function(words, timeout=120_000)


def test_the_page_shows_the_phonemes_of_a_microphone_that_python_finds(address: str, tmp_path: Path) -> None:
    shares: list[float] = []
    while max(shares, default=0.0) < SAME and len(shares) < TRIES:
        with opened(address, *microphone(tmp_path, SOUND)) as page:
            page.click("#microphone")
            wait_for_frames(page, len(SOUND) // 441 + 250)
            assert page.is_hidden("#trouble")
            assert " confidence " in page.inner_text("#viseme")
            shares.append(likeness(shown(page), SOUND))
    assert max(shares) >= SAME, shares


def test_a_file_is_shown_as_python_finds_it_and_the_mouth_moves(address: str, tmp_path: Path) -> None:
    path, mouths = tmp_path / "speech.wav", []
    soundfile.write(path, np.concatenate((SOUND, silence(1.0))), 44_100, subtype="PCM_16")
    with opened(address) as page:
        page.wait_for_timeout(2000)  # the head is there
        place = page.locator("#head").bounding_box()
        below = {**place, "y": place["y"] + place["height"] / 2, "height": place["height"] / 3}  # not the eyes
        still = page.screenshot(clip=below)
        page.set_input_files("#file", path)
        for seconds in (1, 2, 3, 4, 5):
            wait_for_frames(page, 100 * seconds)
            mouths.append(page.screenshot(clip=below))
        page.wait_for_selector("#stop[disabled]", state="attached")
        found = shown(page)
        assert page.inner_text("#state") == "Preset Learned"
    assert any(mouth != still for mouth in mouths)
    assert likeness(found, SOUND) >= SAME


USE = """(async () => {
  const element = (id) => document.getElementById(id);
  const until = async (done) => { while (!done()) await new Promise((resolve) => setTimeout(resolve, 50)); };
  await until(() => element("head").ariaLabel.startsWith("head.glb"));
  const sum = new OffscreenCanvas(40, 20).getContext("2d", { willReadFrequently: true });
  const mouths = new Set();
  requestAnimationFrame(function look() {
    const { width, height } = element("head");
    sum.drawImage(element("head"), 0, height / 2, width, height / 3, 0, 0, 40, 20);
    mouths.add(String(sum.getImageData(0, 0, 40, 20).data));
    requestAnimationFrame(look);
  });
  const clip = new Promise((resolve) => {
    HTMLAnchorElement.prototype.click = async function () {
      resolve([this.download, (await (await fetch(this.href)).blob()).size]);
    };
  });
  const files = new DataTransfer();
  files.items.add(new File([await (await fetch("speech.wav")).arrayBuffer()], "speech.wav"));
  element("file").files = files.files;
  element("file").dispatchEvent(new Event("change"));
  await until(() => !element("record").disabled);
  element("record").click();
  await until(() => element("stop").disabled);
  const cells = ({ cells }) => [...cells].map((cell) => cell.textContent);
  const rows = [...document.querySelectorAll("#phonemes tr")].map(cells);
  return JSON.stringify({ rows, mouths: mouths.size, clip: await clip, trouble: element("trouble").textContent });
})()"""


def test_firefox_shows_a_file_moves_the_head_and_records_a_clip(address: str, folder: Path, tmp_path: Path) -> None:
    soundfile.write(folder / "demo" / "speech.wav", np.concatenate((SOUND, silence(1.0))), 44_100, subtype="PCM_16")
    with VirtualSound() as sound, display() as place:
        environment = {**sound.environment, "DISPLAY": place, "LIBGL_ALWAYS_SOFTWARE": "1"}
        told = json.loads(in_firefox(address, USE, tmp_path / "profile", environment))
    assert told["trouble"] == ""
    assert likeness(frames_of_rows(told["rows"]), SOUND) >= SAME
    assert told["mouths"] > 20
    name, size = told["clip"]
    assert name == "clip.webm"
    assert size > 20_000


@contextmanager
def display() -> Iterator[str]:
    """Give the name of a display of its own, without a screen."""
    words = ["Xvfb", "-displayfd", "1", "-screen", "0", "1024x700x24"]
    with subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as server:
        assert server.stdout is not None
        yield f":{server.stdout.readline().strip()}"
        server.terminate()


@pytest.mark.parametrize(
    ("flags", "sentence"),
    [
        (("--use-fake-device-for-media-stream", "--deny-permission-prompts"), "this page may not use the microphone"),
        (("--use-fake-ui-for-media-stream",), "there is no microphone; connect one, and try again"),
    ],
)
def test_a_page_without_permission_or_microphone_says_so(address: str, flags: tuple[str, ...], sentence: str) -> None:
    with opened(address, *flags) as page:
        page.click("#microphone")
        page.wait_for_selector("#trouble:not([hidden])")
        assert sentence in page.inner_text("#trouble")


def test_a_file_that_is_no_sound_or_no_head_is_refused(address: str, tmp_path: Path) -> None:
    (tmp_path / "notes.wav").write_text("my notes", encoding="utf-8")
    with opened(address) as page:
        page.set_input_files("#file", tmp_path / "notes.wav")
        page.wait_for_selector("#trouble:not([hidden])")
        assert "notes.wav: this is no sound that the browser knows" in page.inner_text("#trouble")
        page.set_input_files("#glb", tmp_path / "notes.wav")
        page.wait_for_function("() => document.getElementById('trouble').textContent.includes('head')")
        assert "notes.wav: this head cannot be read; choose a GLB or VRM file" in page.inner_text("#trouble")


def test_the_page_fits_a_phone_and_works_without_a_network(address: str, tmp_path: Path) -> None:
    path = tmp_path / "speech.wav"
    soundfile.write(path, SOUND[: 2 * 44_100], 44_100, subtype="PCM_16")
    with opened(address) as page:
        page.set_viewport_size({"width": 360, "height": 640})
        page.evaluate("() => navigator.serviceWorker.ready")
        page.context.set_offline(True)
        page.reload()
        page.wait_for_selector("#microphone:not([disabled])")
        page.set_input_files("#file", path)
        wait_for_frames(page, 100)
        assert page.inner_text("#latency") == "latency 38 ms"
        assert page.is_hidden("#trouble")
        assert page.evaluate("() => document.documentElement.scrollWidth") == 360
        page.context.set_offline(False)


def test_the_folder_packs_into_a_package_that_another_project_imports(folder: Path, tmp_path: Path) -> None:
    def do(*words: str) -> str:
        return subprocess.run(words, cwd=tmp_path, capture_output=True, text=True, check=True).stdout

    (package,) = json.loads(do("npm", "pack", str(folder), "--json"))
    names = {file["path"] for file in package["files"]}
    assert names == {
        "LICENSE",
        "README.md",
        "package.json",
        "ear.d.ts",
        "ear.js",
        "ear-preset.js",
        "ear-wasm.js",
        "ear-worklet.js",
        *(f"examples/{path.name}" for path in (folder / "examples").iterdir()),
    }
    assert package["size"] <= 1_200_000
    do("npm", "install", "--offline", f"./{package['filename']}")
    line = "import { loadModel } from 'phoneme-ear'; console.log((await loadModel()).name)"
    assert do("node", "--input-type=module", "-e", line) == "Learned\n"
