"""The words of a DirectX .x text file: names, numbers, texts and braces."""

import math
import re
from collections.abc import Sequence

import numpy as np

from phonemeengine.arrays import Float64Array
from phonemeengine.errors import MeshError

WORD = re.compile(r'(?://|#)[^\n]*|"[^"\n]{0,4096}"|<[^<>\n]{0,64}>|[{}\[\]]|[^\s;,{}\[\]"<>#/]+|[^\s;,]')
"""Commas and semicolons only separate; comments begin with // or #."""
SHORTEST_NUMBER = 2
"""Characters of the shortest number and what ends it."""
DEEPEST = 64


class Tokenizer:
    """Hands out the words of a text one after the other, without making a list of them."""

    def __init__(self, text: str) -> None:
        self._text = text
        self._at = 0

    def next_word(self) -> str:
        """Return the next word; empty at the end."""
        while found := WORD.search(self._text, self._at):
            self._at = found.end()
            word = found.group()
            if not word.startswith(("//", "#")):
                return word
        return ""

    def expect(self, word: str) -> None:
        """Take a word that must be the next."""
        if (found := self.next_word()) != word:
            raise MeshError(f"{self.place}: expected {word!r}, found {found[:40]!r}; export it again")

    def number(self) -> float:
        """Take a number."""
        word = self.next_word()
        try:
            value = float(word)
        except ValueError:
            value = math.nan
        if not abs(value) < 1e18:
            raise MeshError(f"{self.place}: expected a finite number, found {word[:40]!r}; export it again")
        return value

    def whole(self, most: int) -> int:
        """Take a whole number of 0..most."""
        value = self.number()
        if not 0 <= value <= most or value != int(value):
            raise MeshError(f"{self.place}: expected a whole number of 0..{most}, found {value:g}; export it again")
        return int(value)

    def count(self, most: int, numbers_each: int) -> int:
        """Take a number of things, which the rest of the text must have room for."""
        n = self.whole(most)
        room = (len(self._text) - self._at) // (SHORTEST_NUMBER * numbers_each) + 1
        if n > room:
            raise MeshError(f"{self.place}: {n} entries are announced, and there is room for {room}; export it again")
        return n

    def numbers(self, n: int, width: int) -> Float64Array:
        """Take n rows of numbers, shape (n, width)."""
        return np.fromiter((self.number() for _ in range(n * width)), np.float64, n * width).reshape(n, width)

    def wholes(self, n: int, most: int) -> Sequence[int]:
        """Take n whole numbers of 0..most."""
        return [self.whole(most) for _ in range(n)]

    def head(self) -> str:
        """Take a block's name, if it has one, and its opening brace; gives the name."""
        word = self.next_word()
        if word == "{":
            return ""
        self.expect("{")
        return word

    def leave(self) -> None:
        """Pass over the rest of a block, up to its closing brace."""
        depth = 1
        while depth:
            match self.next_word():
                case "{":
                    depth += 1
                case "}":
                    depth -= 1
                case "":
                    raise MeshError(f"{self.place}: a block is not closed; it is cut off, export it again")

    @property
    def place(self) -> str:
        """Where the reading is, for people."""
        return f"line {self._text.count(chr(10), 0, self._at) + 1}"
