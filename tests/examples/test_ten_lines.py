"""The programs of the page "In ten lines" run beside stubs of their libraries, which say what they got."""

import asyncio
import io
import json
import math
import re
import sys
from collections.abc import Iterator
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from phonemeengine.audio.resampling import resample_whole
from phonemeengine.settings import SAMPLE_RATE
from tests.conftest import ROOT, SPEECH

PAGE = (ROOT / "docs" / "ten-lines.md").read_text(encoding="utf-8")
PROGRAMS = dict(re.findall(r"^## (.*?)\n.*?^```python\n(.*?)^```", PAGE, re.MULTILINE | re.DOTALL))
"""The programs by their headings."""


def speech(rate: int, n_channels: int = 1) -> bytes:
    sound = resample_whole(SPEECH, SAMPLE_RATE, rate)
    return np.repeat(np.rint(sound * 32_767).astype("<i2"), n_channels).tobytes()


def chunks(data: bytes, size: int) -> Iterator[bytes]:
    return (data[at : at + size] for at in range(0, len(data), size))


@pytest.fixture
def run(monkeypatch: pytest.MonkeyPatch) -> Any:
    """Runs a program beside modules that stand for others; gives what it has defined."""

    def run(heading: str, **modules: Any) -> dict[str, Any]:
        for name, module in modules.items():
            monkeypatch.setitem(sys.modules, name.replace("__", "."), module)
        monkeypatch.chdir(ROOT)
        defined: dict[str, Any] = {"__name__": "ten_lines"}
        exec(compile(PROGRAMS[heading], heading, "exec"), defined)
        return defined

    return run


def test_every_program_is_tried() -> None:
    assert [*PROGRAMS] == [
        "pygame",
        "Panda3D",
        "Ren'Py",
        "Blender, live",
        "The voice of a Discord bot",
        "A stream of a text-to-speech service",
    ]


def test_pygame_draws_until_its_window_is_closed(run: Any) -> None:
    drawn: list[tuple[float, ...]] = []
    nothing = SimpleNamespace(fill=lambda _colour: None, tick=lambda _rate: None)
    run(
        "pygame",
        pygame=SimpleNamespace(
            QUIT=256,
            display=SimpleNamespace(set_mode=lambda _size: nothing, flip=lambda: None),
            time=SimpleNamespace(Clock=lambda: nothing, get_ticks=lambda: 16 * len(drawn)),
            event=SimpleNamespace(peek=lambda _kind: len(drawn) == 3),
            draw=SimpleNamespace(ellipse=lambda _screen, _colour, place: drawn.append(place)),
        ),
    )
    assert len(drawn) == 3
    assert all(150 - 60 <= top <= 150 and 8 <= height <= 128 for _, top, _, height in drawn)


def test_panda3d_moves_every_morph_target_of_an_actor(run: Any) -> None:
    moved: dict[str, float] = {}
    added: list[Any] = []

    class Actor:
        def __init__(self, _model: str) -> None:
            self.reparentTo = lambda _node: None

        def controlJoint(self, _node: None, part: str, name: str) -> Any:
            assert part == "modelRoot"
            return SimpleNamespace(setX=lambda value: moved.__setitem__(name, value))

    class ShowBase:
        render = None
        taskMgr = SimpleNamespace(add=lambda act, _name: added.append(act))  # noqa: N815 - Panda3D's name

        def run(self) -> None:
            assert added[0](SimpleNamespace(time=0.1, cont="cont")) == "cont"

    actor = SimpleNamespace(Actor=Actor)
    run("Panda3D", direct__actor__Actor=actor, direct__showbase__ShowBase=SimpleNamespace(ShowBase=ShowBase))
    assert len(moved) == 52
    assert all(0 <= value <= 1 for value in moved.values())


def test_renpy_shows_the_cue_that_plays(run: Any) -> None:
    files = {"mouths/hello.rhubarb.json": {"mouthCues": [{"start": 0.0, "end": 0.4, "value": "D"}]}}
    playing = {"line": "voice/hello.ogg", "at": 0.2}
    images: dict[str, Any] = {}
    renpy = SimpleNamespace(
        music=SimpleNamespace(get_playing=lambda _ch: playing["line"], get_pos=lambda _ch: playing["at"]),
        open_file=lambda name: io.StringIO(json.dumps(files[name])),
        displayable=str,
        image=images.__setitem__,
    )
    run("Ren'Py", renpy__store=SimpleNamespace(DynamicDisplayable=lambda act: act, renpy=renpy))
    assert images["mouth"](0, 0) == ("mouth D", 0.02)
    playing["at"] = 0.5
    assert images["mouth"](0, 0) == ("mouth X", 0.02)
    playing["line"] = None
    assert images["mouth"](0, 0)[0] == "mouth X"


def test_blender_moves_the_shape_keys_that_a_face_has(run: Any) -> None:
    keys = {"jawOpen": SimpleNamespace(value=math.nan)}
    timers: list[Any] = []
    face = SimpleNamespace(data=SimpleNamespace(shape_keys=SimpleNamespace(key_blocks=keys)))
    bpy = SimpleNamespace(
        data=SimpleNamespace(objects={"Face": face}),
        app=SimpleNamespace(timers=SimpleNamespace(register=timers.append)),
    )
    defined = run("Blender, live", bpy=bpy)
    assert timers[0]() == pytest.approx(1 / 60)
    assert 0 <= keys["jawOpen"].value <= 1
    defined["microphone"].close()


def test_a_discord_bot_has_a_mouth_for_what_it_says(run: Any) -> None:
    sound = speech(48_000, 2)
    played: list[Any] = []

    class Client:
        def __init__(self, intents: str) -> None:
            assert intents == "default"

        def event(self, act: Any) -> None:
            self.act = act

        def get_channel(self, _number: int) -> Any:
            async def connect() -> Any:
                return SimpleNamespace(play=played.append)

            return SimpleNamespace(connect=connect)

        def run(self, _token: str) -> None:
            asyncio.run(self.act())

    blocks = chunks(sound, 3840)
    file = SimpleNamespace(read=lambda: next(blocks, b""))
    run(
        "The voice of a Discord bot",
        discord=SimpleNamespace(
            AudioSource=object,
            Client=Client,
            Intents=SimpleNamespace(default=lambda: "default"),
            FFmpegPCMAudio=lambda _name: file,
        ),
    )
    heard, widest = b"", 0.0
    while data := played[0].read():
        heard += data
        if played[0].weights is not None:
            widest = max(widest, float(played[0].weights.max()))
    assert heard == sound
    assert widest > 0.3


def test_a_stream_of_speech_becomes_weights(run: Any, capsys: pytest.CaptureFixture[str]) -> None:
    def stream(*, text: str, voice_id: str, output_format: str) -> Iterator[bytes]:
        assert (text, voice_id, output_format) == ("Good evening.", "George", "pcm_24000")
        return chunks(speech(24_000), 1000)

    service = SimpleNamespace(text_to_speech=SimpleNamespace(stream=stream))
    run("A stream of a text-to-speech service", elevenlabs=SimpleNamespace(ElevenLabs=lambda: service))
    told = capsys.readouterr().out
    assert told.startswith("0.00 s [")
    assert len(re.findall(r" s \[", told)) > 70 * len(SPEECH) / SAMPLE_RATE
