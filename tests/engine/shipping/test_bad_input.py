"""What an ear in C does with files that are none, sound that is none, and memory that is too little."""

import ctypes
import re
import struct
import subprocess
from dataclasses import replace
from pathlib import Path
from random import Random

import numpy as np
import pytest

from phonemeengine import Phoneme, Preset, load_preset
from phonemeengine.labels.visemes import STANDARD_VISEMES, Viseme
from phonemeengine.shipping.targets import format_ear
from tests.compiled_ears import (
    BAD_RATE,
    COMPILERS,
    DAMAGED_FILE,
    NEWER_FILE,
    NO_EAR_FILE,
    OK,
    SOURCES,
    STRICT,
    TOO_FEW_FRAMES,
    TOO_LITTLE_MEMORY,
    CEar,
    CModel,
    EarLibrary,
    compiler,
)
from tests.ear_probe import EarProbe, with_true_header
from tests.models import tone_model
from tests.sounds import noise, tone

N_DAMAGED = 40


@pytest.fixture(scope="module")
def content() -> bytes:
    return format_ear(small_preset(), ("five",))


def small_preset() -> Preset:
    settings = load_preset("learned").settings
    return Preset(name="tones", recogniser="learned", model=tone_model({1000.0: Phoneme.A}, 2), settings=settings)


def test_every_result_is_one_sentence_that_says_what_to_do(library: EarLibrary) -> None:
    texts = [library.text(code) for code in range(1, 10)]
    assert len(set(texts)) == len(texts)
    assert all("; " in text and "\n" not in text and len(text) < 120 for text in texts)
    assert library.text(99) == "this is none of ear's results"


def test_what_is_no_ear_file_or_a_newer_one_is_refused_as_such(library: EarLibrary, content: bytes) -> None:
    for foreign in (b"", b"EAR", b"RIFF" + bytes(100), bytes(20)):
        assert library.model_size(foreign) == (NO_EAR_FILE, 0)
    assert library.model_size(content[:4] + struct.pack("<I", 4) + content[8:]) == (NEWER_FILE, 0)


def test_a_file_that_was_cut_off_or_changed_is_damaged(library: EarLibrary, content: bytes) -> None:
    assert library.model_size(content)[0] == OK
    for n in (16, 17, 100, len(content) // 2, len(content) - 1):
        assert library.model_size(content[:n])[0] == DAMAGED_FILE
    for place in Random(1).sample(range(8, len(content)), 50):
        changed = content[:place] + bytes([content[place] ^ 1]) + content[place + 1 :]
        assert library.model_size(changed)[0] == DAMAGED_FILE
    assert library.model_size(content + b"\0")[0] == DAMAGED_FILE


def test_sections_that_contradict_each_other_are_refused(library: EarLibrary, content: bytes) -> None:
    network = content.index(b"NETW")
    without = content[:network] + content[network + 8 + struct.unpack_from("<I", content, network + 4)[0] :]
    assert library.model_size(with_true_header(without))[0] == DAMAGED_FILE
    assert library.model_size(with_true_header(content + content[network:]))[0] == DAMAGED_FILE
    lying = content[: network + 8] + struct.pack("<I", 33) + content[network + 12 :]
    assert library.model_size(with_true_header(lying))[0] == DAMAGED_FILE


def test_too_little_memory_is_refused_before_it_is_touched(library: EarLibrary, content: bytes) -> None:
    size = library.model_size(content)[1]
    memory, handle = ctypes.create_string_buffer(b"\xaa" * size, size), ctypes.c_void_p(1)
    words = content, ctypes.c_size_t(len(content)), memory, ctypes.c_size_t(size - 1), ctypes.byref(handle)
    assert library.c.ear_model_open(*words) == TOO_LITTLE_MEMORY
    assert handle.value is None
    assert memory.raw == b"\xaa" * size


def test_a_rate_that_is_no_speech_s_is_refused(library: EarLibrary, content: bytes) -> None:
    model, size = CModel(library, content), ctypes.c_size_t()
    for rate in (0, 999, 768_001, 2**32 - 1):
        assert library.c.ear_size(model.handle, ctypes.c_uint32(rate), ctypes.byref(size)) == BAD_RATE
    assert "1000..768000 Hz" in library.text(BAD_RATE)


def test_where_frames_have_no_room_nothing_is_taken(library: EarLibrary, content: bytes) -> None:
    ear, n = CEar(CModel(library, content)), ctypes.c_size_t()
    samples, frames = tone(1000, 1.0), ctypes.create_string_buffer(100 * 60)
    words = samples.ctypes.data_as(ctypes.c_void_p), ctypes.c_size_t(len(samples))
    assert library.c.ear_push(ear.handle, *words, frames, ctypes.c_size_t(99), ctypes.byref(n)) == TOO_FEW_FRAMES
    assert len(ear.hear(samples)) == 100


@pytest.mark.parametrize("name", ["learned", "extended"])
def test_what_is_no_number_or_far_too_loud_counts_as_silence(library: EarLibrary, name: str) -> None:
    model, sound = CModel(library, format_ear(load_preset(name), ())), noise(0.6, 0.1)
    where = np.arange(len(sound)) % 3 == 0
    silenced = np.where(where, np.float32(0), sound)
    expected = CEar(model).hear(silenced)
    for bad in (np.nan, np.inf, -np.inf, 2e6, -3e38, 1e-40):
        assert (CEar(model).hear(np.where(where, np.float32(bad), sound)) == expected).all(), bad


def test_the_next_sound_knows_nothing_of_the_last_one(library: EarLibrary) -> None:
    for rate in (44_100, 48_000):
        ear = CEar(CModel(library, format_ear(load_preset("learned"), ())), rate)
        first = ear.hear(tone(700, 0.4))
        ear.push(noise(0.3, 1.0))
        ear.finish()
        assert (ear.hear(tone(700, 0.4)) == first).all()


@pytest.mark.parametrize("by", ["", pytest.param("clang", marks=pytest.mark.long)])
def test_damaged_files_and_impossible_sound_leave_nothing_undefined(content: bytes, by: str) -> None:
    model = tone_model({1000.0: Phoneme.A}, 2, visemes={1000.0: Viseme.AA})
    own = replace(small_preset(), model=replace(model, viseme_set=replace(STANDARD_VISEMES, usual={})))
    goods = [content, format_ear(own, ("five",))]
    goods += [format_ear(load_preset(name), ("five",)) for name in ("thesis", "templates")]
    chance = Random(2)
    probe = EarProbe(by and compiler(by))
    assert [probe.ask(good) for good in goods * 4] == [OK] * 16  # a rate each
    results = [probe.ask(damaged(chance.choice(goods), chance)) for _ in range(N_DAMAGED)]
    assert set(results) == {OK, DAMAGED_FILE}


def damaged(good: bytes, chance: Random) -> bytes:
    """Give a file whose header is true, but with another number somewhere behind it, or without its end."""
    place = chance.randrange(16, len(good) - 4) & ~3
    if chance.random() < 0.2:
        return with_true_header(good[:place])
    number = chance.choice([0, 1, 2, 11, 255, 1000, 65_536, 2**31 - 1, 2**32 - 1, 0x7F7FFFFF, 0x7FC00000])
    return with_true_header(good[:place] + struct.pack("<I", number) + good[place + 4 :])


def test_the_ear_keeps_no_state_and_allocates_only_where_something_is_opened(tmp_path: Path) -> None:
    text = (SOURCES / "ear.c").read_text(encoding="utf-8")
    calls = re.findall(r"\b(malloc|calloc|realloc|fopen|printf|setlocale|rand|srand|time)\s*\(", text)
    assert calls == ["malloc"]
    opening = text[text.index("static int begin_arena") :]
    assert opening.index("malloc") < opening.index("\n}\n")
    objects = tmp_path / "ear.o"
    subprocess.run(
        [compiler(), *STRICT, "-fno-pie", "-O0", "-c", str(SOURCES / "ear.c"), "-o", str(objects)], check=True
    )
    listed = subprocess.run(["nm", str(objects)], capture_output=True, text=True, check=True).stdout
    assert re.findall(r" [bBdDcC] (\w+)", listed) == [], "variables of its own"


def test_one_ear_needs_less_than_201_kilobytes_besides_its_model(library: EarLibrary) -> None:
    model = CModel(library, format_ear(load_preset("learned"), ()))
    assert CEar(model).size < 201_000
    assert CEar(model, 48_000).size < 201_000


@pytest.mark.long  # test_folder has both compile the same, less optimised, with warnings as errors
@pytest.mark.parametrize("by", COMPILERS)
def test_no_compiler_has_anything_to_say(by: str, tmp_path: Path) -> None:
    for source in (SOURCES / "ear.c", *sorted(SOURCES.glob("examples/*.c"))):
        command = [compiler(by), *STRICT, "-O2", "-c", str(source), "-o", str(tmp_path / "made.o")]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
