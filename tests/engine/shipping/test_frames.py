"""What a program in C may ask of frames: size, sound of several channels, weights by probabilities, versions."""

import ctypes

import numpy as np
import pytest

import phonemeengine
from phonemeengine import load_preset, load_table
from phonemeengine.mouth.blending import blended_weights, viseme_rows
from phonemeengine.shipping.targets import format_ear
from tests.compiled_ears import FRAME, SOURCES, CEar, CModel, EarLibrary
from tests.engine.shipping.test_same_results import recognised_by_engine, speech
from tests.sounds import tone

BAD_ARGUMENT = 9
TABLES = ("arkit", "oculus", "five")


@pytest.fixture(scope="module")
def model(library: EarLibrary) -> CModel:
    return CModel(library, format_ear(load_preset("learned"), ()))


@pytest.mark.parametrize("name", ["learned", "templates", "thesis"])
def test_weights_by_probabilities_are_those_of_the_engine(library: EarLibrary, name: str) -> None:
    preset, sound = load_preset(name), speech()[: 4 * 44_100]
    opened, analysis = CModel(library, format_ear(preset, TABLES)), recognised_by_engine(preset, sound)
    frames = CEar(opened).hear(sound)
    for number, table in enumerate(map(load_table, TABLES)):
        expected = blended_weights(table, analysis)
        found = np.zeros_like(expected)
        for frame, weights in zip(frames, found, strict=True):
            words = ctypes.c_char_p(frame.tobytes()), weights.ctypes.data_as(ctypes.c_void_p)
            assert library.c.ear_table_blend(opened.handle, number, *words) == 0
        assert np.abs(found - expected).max() < 1e-3
        assert expected.max() > 0.3


def test_a_viseme_that_is_certain_has_the_shape_of_its_phone() -> None:
    table, learned = load_table("oculus"), load_preset("learned").model
    assert learned is not None
    rows, firm = viseme_rows(table, learned.viseme_set)
    for name, row in zip(learned.viseme_set.names, rows, strict=True):
        assert [state for state, weight in zip(table.movestates, row, strict=True) if weight] in ([], [name])
    assert firm[[0, 1]].all()
    assert not firm[10]


@pytest.mark.parametrize("rate", [44_100, 48_000])
def test_channels_and_whole_numbers_are_heard_as_their_mean(model: CModel, rate: int) -> None:
    whole = (np.stack((speech()[:30_000], tone(300, 1.0)[:30_000]), axis=1) * 16384).astype(np.int16)
    floats = whole.astype(np.float32) / 32768
    expected = CEar(model, rate).hear((floats[:, 0] + floats[:, 1]) / 2)
    for given in (whole, floats):
        ear = CEar(model, rate)
        assert (
            np.concatenate([ear.push_channels(given[:701]), ear.push_channels(given[701:]), ear.finish()]) == expected
        ).all()
    mono = CEar(model, rate)
    assert len(mono.push_channels(whole[:, :1])) > 50


def test_numbers_of_channels_and_sizes_of_frames_have_limits(library: EarLibrary, model: CModel) -> None:
    samples, frames, n, handle = np.zeros(640, np.float32), np.zeros(10, FRAME), ctypes.c_size_t(), ctypes.c_void_p()
    words = samples.ctypes.data_as(ctypes.c_void_p), ctypes.c_size_t(10)
    room = frames.ctypes.data_as(ctypes.c_void_p), ctypes.c_size_t(10), ctypes.byref(n)
    for channels in (0, 65):
        assert library.c.ear_push_channels(CEar(model).handle, *words, channels, *room) == BAD_ARGUMENT
    for size in (0, 60, 63, 4100):
        opened = library.c.ear_open_sized(
            model.handle, 44_100, ctypes.c_size_t(size), None, ctypes.c_size_t(0), ctypes.byref(handle)
        )
        assert opened == BAD_ARGUMENT
    assert library.c.ear_table_blend(model.handle, 0, None, None) == BAD_ARGUMENT


@pytest.mark.parametrize("size", [64, FRAME.itemsize, FRAME.itemsize + 64])
def test_a_program_of_another_version_gets_frames_of_its_size(library: EarLibrary, model: CModel, size: int) -> None:
    sound, handle, n = speech()[:22_050], ctypes.c_void_p(), ctypes.c_size_t()
    expected = CEar(model).push(sound)
    if size == 64:  # the function that programs of before have
        opened = library.c.ear_open(model.handle, 44_100, None, ctypes.c_size_t(0), ctypes.byref(handle))
    else:
        opened = library.c.ear_open_sized(
            model.handle, 44_100, ctypes.c_size_t(size), None, ctypes.c_size_t(0), ctypes.byref(handle)
        )
    assert opened == 0
    frames = np.full((60, size), 0xAA, np.uint8)
    words = sound.ctypes.data_as(ctypes.c_void_p), ctypes.c_size_t(len(sound))
    room = frames.ctypes.data_as(ctypes.c_void_p), ctypes.c_size_t(60), ctypes.byref(n)
    assert library.c.ear_push(handle, *words, *room) == 0
    library.c.ear_close(handle)
    known = min(size, FRAME.itemsize)
    assert n.value == len(expected)
    assert frames[: n.value, :known].tobytes() == b"".join(frame.tobytes()[:known] for frame in expected)
    assert not frames[: n.value, known:].any()
    assert (frames[n.value :] == 0xAA).all()


def test_the_version_is_that_of_the_engine(library: EarLibrary) -> None:
    version = phonemeengine.__version__
    assert library.c.ear_version().decode() == version
    for name in ("ear.h", "CMakeLists.txt", "../csharp/Ear.cs", "../web/ear.js"):
        assert version in (SOURCES / name).read_text(encoding="utf-8")
