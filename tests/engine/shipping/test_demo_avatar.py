"""What the demo page does beyond recognising: avatars, clips, access for everybody, and refusals."""

from pathlib import Path
from typing import Any

import av
import numpy as np
import pytest
import soundfile

from tests.avatars import avatar
from tests.bundlers import installed
from tests.engine.shipping.test_demo_page import SOUND, Page, address, chromium, folder, opened, wait_for_frames
from tests.sounds import vowel

pytestmark = pytest.mark.browser
__all__ = ["address", "folder"]

AXE = "axe-core@4.14.1"
MOST_BYTES = 5_120_000
"""Of all that the page loads, not compressed; Lighthouse warns from 5000 KiB on."""
LEAST_TARGET = 24
"""Pixels of what is clicked, each way; WCAG 2.2, 2.5.8."""
VRM_LICENCE = "https://vrm.dev/licenses/1.0/"
"""The one that VRM 1 knows."""
LIMBS = ("UpperLeg", "LowerLeg", "Foot", "UpperArm", "LowerArm", "Hand")


def with_whole_body(document: dict[str, Any]) -> None:
    """Add what no program takes an avatar without: the other bones, all at the hips, and who made it."""
    nodes: list[dict[str, Any]] = document["nodes"]
    names = ["spine", *(f"{side}{limb}" for side in ("left", "right") for limb in LIMBS)]
    places = range(len(nodes), len(nodes) + len(names))
    nodes += [{"name": name} for name in names]
    nodes[1]["children"] += places
    (extension,) = document["extensions"].values()
    extension["meta"] = {"title": "Some", "name": "Some", "authors": ["Somebody"], "licenseUrl": VRM_LICENCE}
    bones = extension["humanoid"]["humanBones"]
    if isinstance(bones, list):
        bones += [{"bone": name, "node": place} for name, place in zip(names, places, strict=True)]
    else:
        bones |= {name: {"node": place} for name, place in zip(names, places, strict=True)}


def speech_file(tmp_path: Path, seconds: float) -> Path:
    soundfile.write(tmp_path / "speech.wav", SOUND[: int(seconds * 44_100)], 44_100, subtype="PCM_16")
    return tmp_path / "speech.wav"


def wait_for_pictures(page: Page) -> None:
    """Wait until the head has been drawn some times."""
    page.evaluate("async () => { for (let k = 0; k < 10; k++) await new Promise(requestAnimationFrame) }")


DROP = """async (name) => {
  const dataTransfer = new DataTransfer();
  dataTransfer.items.add(new File([await (await fetch(name)).arrayBuffer()], name));
  document.body.dispatchEvent(new DragEvent("drop", { bubbles: true, cancelable: true, dataTransfer }));
}"""


@pytest.mark.parametrize("version", [0, 1])
def test_an_avatar_that_is_dropped_moves_its_mouth(version: int, address: str, folder: Path, tmp_path: Path) -> None:
    kept = ("jawOpen", "mouthFunnel", "noseSneerLeft")  # for A, I and a blink, in the order of the file
    (folder / "demo" / "some.vrm").write_bytes(avatar(version, only=kept, change=with_whole_body))
    with opened(address) as page:
        page.wait_for_selector('#head[aria-label^="head.glb"]')
        page.evaluate(DROP, "some.vrm")
        page.wait_for_selector('#head[aria-label^="some.vrm"]')
        assert page.is_hidden("#trouble")
        place = page.locator("#head").bounding_box()
        below = {**place, "y": place["y"] + place["height"] / 2, "height": place["height"] / 3}  # not the eyes
        wait_for_pictures(page)
        still = page.screenshot(clip=below)
        soundfile.write(tmp_path / "a.wav", vowel((700, 1200, 2500), 10.0), 44_100)
        page.set_input_files("#file", tmp_path / "a.wav")
        page.wait_for_function("() => document.getElementById('phoneme').textContent === 'a'")
        wait_for_pictures(page)
        assert page.screenshot(clip=below) != still
        if version:
            page.evaluate(DROP, "README.md")
            page.wait_for_selector("#trouble:not([hidden])")
            assert "README.md: this is no sound that the browser knows" in page.inner_text("#trouble")


def test_what_the_head_says_is_saved_as_a_clip_with_its_sound(address: str, tmp_path: Path) -> None:
    with opened(address) as page:
        page.wait_for_selector('#head[aria-label^="head.glb"]')
        assert page.is_disabled("#record")
        assert page.inner_text("#why") == "Clips can be recorded while the microphone or a file is on."
        page.set_input_files("#file", speech_file(tmp_path, 6))
        page.click("#record:not([disabled])")
        wait_for_frames(page, 200)
        with page.expect_download() as saved:
            page.click("text=End clip")
        path = tmp_path / saved.value.suggested_filename
        saved.value.save_as(path)
        page.set_input_files("#file", speech_file(tmp_path, 6))
        with page.expect_download():  # one that is not ended by hand ends with the file
            page.click("#record:not([disabled])")
    assert path.stem == "clip"
    with av.open(str(path)) as clip:
        pictures = [frame.to_ndarray(format="gray") for frame in clip.decode(video=0)]
    with av.open(str(path)) as clip:
        sound = np.concatenate([frame.to_ndarray().mean(axis=0) for frame in clip.decode(audio=0)])
    assert len(pictures) >= 5
    assert any((picture != pictures[0]).any() for picture in pictures[1:])
    assert pictures[0].std() > 10
    assert np.abs(sound).max() > 0.05


NO_WEBGL = """
const original = HTMLCanvasElement.prototype.getContext;
HTMLCanvasElement.prototype.getContext = function (kind, ...more) {
  return kind.startsWith("webgl") ? null : original.call(this, kind, ...more);
};
"""


@pytest.mark.parametrize(
    ("before", "words"),
    [
        ("delete globalThis.MediaRecorder", "This browser records no clips."),
        (NO_WEBGL, "Without a head there is nothing to record."),
    ],
)
def test_a_browser_that_records_no_clips_says_why(before: str, words: str, address: str, tmp_path: Path) -> None:
    with chromium() as page:
        page.add_init_script(before)
        page.goto(address)
        page.set_input_files("#file:not([disabled])", speech_file(tmp_path, 3))
        wait_for_frames(page, 50)
        assert page.is_disabled("#record")
        assert page.inner_text("#why") == words


MICROPHONE = ("--use-fake-device-for-media-stream", "--use-fake-ui-for-media-stream")
KEEP_TRACK = """
const open = MediaDevices.prototype.getUserMedia;
MediaDevices.prototype.getUserMedia = async function (...words) {
  const stream = await open.apply(this, words);
  globalThis.track = stream.getAudioTracks()[0];
  return stream;
};
"""


def test_a_microphone_that_is_taken_away_ends_listening_in_a_sentence(address: str) -> None:
    with chromium(*MICROPHONE) as page:
        page.add_init_script(KEEP_TRACK)
        page.goto(address)
        page.click("#microphone:not([disabled])")
        wait_for_frames(page, 20)
        page.evaluate("() => track.dispatchEvent(new Event('ended'))")
        page.wait_for_selector("#stop[disabled]", state="attached")
        assert page.inner_text("#trouble") == "the microphone was taken away; connect it, and start again"
        assert page.inner_text("#state") == "Preset Learned"
        assert page.evaluate("() => track.readyState") == "ended"
        page.click("#microphone")  # and it can be started again
        page.wait_for_selector("#stop:not([disabled])")
        assert page.is_hidden("#trouble")


def test_a_browser_without_worklets_is_a_sentence(address: str) -> None:
    with chromium(*MICROPHONE) as page:
        page.add_init_script("delete BaseAudioContext.prototype.audioWorklet")
        page.goto(address)
        page.click("#microphone:not([disabled])")
        page.wait_for_selector("#trouble:not([hidden])")
        assert "this page may not listen; open it by https or from localhost" in page.inner_text("#trouble")
        assert page.is_disabled("#stop")


def faults_of(page: Page) -> list[str]:
    """Give what axe-core finds fault with: names, labels, contrast, headings, landmarks, language and much more."""
    page.evaluate((installed((AXE,)) / "axe-core" / "axe.min.js").read_text(encoding="utf-8"))
    told = page.evaluate("() => axe.run({ runOnly: ['wcag2a', 'wcag2aa', 'wcag21aa', 'wcag22aa', 'best-practice'] })")
    assert len(told["passes"]) > 15
    return [f"{fault['id']}: {[node['html'] for node in fault['nodes']]}" for fault in told["violations"]]


FOCUSED = """() => {
  const { id } = document.activeElement;
  const shown = document.activeElement.closest(".button") ?? document.activeElement;
  return [id, getComputedStyle(shown).outlineStyle];
}"""


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_everybody_can_use_the_page(scheme: str, address: str) -> None:
    with chromium(*MICROPHONE) as page:
        page.emulate_media(color_scheme=scheme)
        page.goto(address)
        page.wait_for_selector('#head[aria-label^="head.glb"]')
        page.click("#microphone")
        wait_for_frames(page, 50)
        page.click("h1")  # and the focus begins there
        assert faults_of(page) == []
        order = []
        for _ in range(6):
            page.keyboard.press("Tab")
            order.append(page.evaluate(FOCUSED))
        assert [place for place, _ in order] == ["microphone", "file", "stop", "glb", "record", "list"]
        assert "none" not in {outline for _, outline in order}
        page.focus("#stop")
        page.keyboard.press("Enter")
        page.wait_for_selector("#stop[disabled]", state="attached")
        page.set_viewport_size({"width": 320, "height": 640})
        assert page.evaluate("() => document.documentElement.scrollWidth") == 320
        sizes = page.eval_on_selector_all("button, .button", "all => all.map(e => e.getBoundingClientRect().height)")
        assert min(sizes) >= LEAST_TARGET


LIDS = """async () => {
  const { lidsAt } = await import("./head.js");
  return Math.max(...Array.from({ length: 400 }, (_, k) => lidsAt(k / 50)));
}"""
LOADED = """() => ["navigation", "resource"]
  .flatMap((kind) => performance.getEntriesByType(kind)).reduce((n, entry) => n + entry.decodedBodySize, 0)"""


def test_less_motion_is_respected_and_the_page_is_small(address: str) -> None:
    with opened(address) as page:
        page.wait_for_selector('#head[aria-label^="head.glb"]')
        assert page.evaluate(LIDS) > 0.5
        page.emulate_media(reduced_motion="reduce")
        assert page.evaluate(LIDS) == 0
        assert 3_000_000 < page.evaluate(LOADED) <= MOST_BYTES
