"""Damages files: flipped bits, cuts, lying counts, splices; the same seed gives the same damage."""

import json
import re
import struct
from collections.abc import Callable, Sequence
from random import Random
from typing import Any

COUNTS = (0, 1, 2, 255, 256, 65_535, 65_536, 1_000_000, 2**20, 2**31 - 1, 2**31, 2**32 - 2, 2**32 - 1)
WORDS = (
    b"0",
    b"1",
    b"-1",
    b"7",
    b"65536",
    b"999999",
    b"1048576",
    b"2147483648",
    b"4294967295",
    b"1e9",
    b"1e39",
    b"1e999",
    b"-1e308",
    b"nan",
    b"inf",
    b"NaN",
    b"-0",
    b"0.5",
    b"99999999999999999999",
    b"null",
    b"true",
    b'""',
    b"[]",
    b"{}",
)
VALUES = (
    0,
    1,
    2,
    3,
    4,
    5,
    6,
    -1,
    7,
    8,
    12,
    36,
    255,
    5120,
    5121,
    5122,
    5123,
    5125,
    5126,
    65_536,
    2**20,
    2**20 + 1,
    2**31,
    2**32,
    10**30,
    0.5,
    -0.5,
    1e9,
    1e18,
    1e30,
    1e308,
    float("nan"),
    float("inf"),
    None,
    True,
    "",
    "x",
    "SCALAR",
    "VEC4",
    "data:,AAAA",
    [],
    {},
    [0],
    [0] * 1000,
    [[]],
    {"POSITION": 0},
    {"targetNames": ["a"] * 3},
    "\ud800",
    "a\nb",
)
NUMBER = re.compile(rb"-?\d+(?:\.\d+)?(?:e-?\d+)?")
LONGEST = 1 << 16
MOST_PLACES = 10_000
CHANGES = (1, 1, 1, 2, 2, 4)


def mutated(content: bytes, others: Sequence[bytes], chance: Random, head: int = 0) -> bytes:
    """Give a file with one to four kinds of damage; `others` are files of its kind, for splices.

    The first `head` bytes stay good in four of five files, so that what is behind them is looked at.
    """
    kept = content[:head] if chance.random() < 0.8 else b""
    content = content[len(kept) :]
    damages = (*DAMAGES, *[_restructure] * len(DAMAGES)) if content.startswith(b"{") else DAMAGES
    for _ in range(chance.choice(CHANGES)):
        content = chance.choice(damages)(content, others, chance)[:LONGEST]
    return kept + content


def _flip(content: bytes, _others: Sequence[bytes], chance: Random) -> bytes:
    changed = bytearray(content)
    for _ in range(chance.randint(1, 8) if changed else 0):
        changed[chance.randrange(len(changed))] ^= 1 << chance.randrange(8)
    return bytes(changed)


def _cut(content: bytes, _others: Sequence[bytes], chance: Random) -> bytes:
    return content[: chance.randint(0, len(content))]


def _lose(content: bytes, _others: Sequence[bytes], chance: Random) -> bytes:
    begin = chance.randint(0, len(content))
    return content[:begin] + content[begin + chance.randint(1, 64) :]


def _lie(content: bytes, _others: Sequence[bytes], chance: Random) -> bytes:
    """Write another whole number of 32 bits over four bytes, more often at the places where counts stand."""
    if len(content) < 4:
        return content
    at = chance.randrange(len(content) - 3)
    at -= at % chance.choice((1, 2, 4))
    true = struct.unpack_from("<I", content, at)[0]
    lie = chance.choice((*COUNTS, (true + 1) % 2**32, (true - 1) % 2**32, true * 2 % 2**32))
    return content[:at] + struct.pack("<I", lie) + content[at + 4 :]


def _reword(content: bytes, _others: Sequence[bytes], chance: Random) -> bytes:
    """Write another number in place of one that stands there as text."""
    found = list(NUMBER.finditer(content[:LONGEST]))
    if not found:
        return content
    word = chance.choice(found)
    return content[: word.start()] + chance.choice(WORDS) + content[word.end() :]


def _repeat(content: bytes, _others: Sequence[bytes], chance: Random) -> bytes:
    begin = chance.randint(0, len(content))
    piece = content[begin : begin + chance.randint(1, 200)]
    return content[:begin] + piece * chance.choice((2, 3, 50, 1000)) + content[begin:]


def _insert(content: bytes, _others: Sequence[bytes], chance: Random) -> bytes:
    at = chance.randint(0, len(content))
    piece = chance.choice(
        (chance.randbytes(chance.randint(1, 16)), b"[" * 5000, b"{" * 5000, b"\0" * 100, b"\xff" * 9)
    )
    return content[:at] + piece + content[at:]


def _splice(content: bytes, others: Sequence[bytes], chance: Random) -> bytes:
    other = chance.choice(others)
    begin, end = sorted((chance.randint(0, len(other)), chance.randint(0, len(other))))
    at = chance.randint(0, len(content))
    return content[:at] + other[begin:end] + content[at + chance.choice((0, end - begin)) :]


def _restructure(content: bytes, _others: Sequence[bytes], chance: Random) -> bytes:
    """Put something else in one place of a JSON document, or leave it out, or have it twice."""
    try:
        root = json.loads(content)
    except (ValueError, RecursionError):
        return content
    places = _places(root)
    if not places:
        return content
    within, key = chance.choice(places)
    match chance.randrange(6):
        case 0:
            del within[key]
        case 1 if isinstance(within, list):
            within += within * chance.choice((1, 100))
        case _:
            within[key] = chance.choice(VALUES)
    return json.dumps(root).encode()


def _places(root: Any) -> list[tuple[Any, Any]]:
    """Give all tables and lists of a JSON document, each with each of its keys."""
    places: list[tuple[Any, Any]] = []
    waiting = [root]
    while waiting and len(places) < MOST_PLACES:
        within = waiting.pop()
        if isinstance(within, (dict, list)):
            keys = list(within) if isinstance(within, dict) else range(len(within))
            places += [(within, key) for key in keys]
            waiting += [within[key] for key in keys]
    return places


DAMAGES: tuple[Callable[[bytes, Sequence[bytes], Random], bytes], ...] = (
    _flip,
    _cut,
    _lose,
    _lie,
    _lie,
    _reword,
    _reword,
    _repeat,
    _insert,
    _splice,
)
