"""Unpacks files that Rob Northen's ProPack packed with its first method, as games of the nineties do.

Bits come from words of two bytes, low byte and low bit first; plain bytes stand between the words.
"""

PACKED = b"RNC\x01"
HEAD = 18  # bytes: the mark, sizes and checksums (big-endian), leeway, number of blocks
SHORTEST_COPY = 2


class _Bits:
    """The stream of bits and bytes."""

    def __init__(self, data: bytes) -> None:
        self._data, self._at, self._held, self._count = data, HEAD, 0, 0

    def take(self, count: int) -> int:
        """Return the next bits as a number, the first the lowest."""
        while self._count < count:
            self._held |= int.from_bytes(self._data[self._at : self._at + 2], "little") << self._count
            self._at, self._count = self._at + 2, self._count + 16
        value = self._held & ((1 << count) - 1)
        self._held, self._count = self._held >> count, self._count - count
        return value

    def take_bytes(self, count: int) -> bytes:
        """Return bytes that stand behind the words taken so far."""
        self._at += count
        return self._data[self._at - count : self._at]

    def number(self, codes: dict[tuple[int, int], int]) -> int:
        """Return a number: its code tells how many bits it has, and its highest is 1."""
        code = length = 0
        while (length, code) not in codes:
            if length > 16:
                raise ValueError("the packed file is damaged")
            code = code << 1 | self.take(1)
            length += 1
        bits = codes[length, code]
        return bits if bits < 2 else 1 << (bits - 1) | self.take(bits - 1)

    def codes(self) -> dict[tuple[int, int], int]:
        """Return a table (length, code) -> number of bits: of a canonical Huffman code, given by its lengths."""
        lengths = [self.take(4) for _ in range(self.take(5))]
        found, code = {}, 0
        for length in range(1, 17):
            for value, its_length in enumerate(lengths):
                if its_length == length:
                    found[length, code] = value
                    code += 1
            code <<= 1
        return found


def unpacked(file: bytes) -> bytes:
    """Return what a packed file holds."""
    bits, made = _Bits(file), bytearray()
    bits.take(2)
    for _ in range(file[HEAD - 1]):
        plain, distances, lengths = bits.codes(), bits.codes(), bits.codes()
        count = bits.take(16)
        for left in range(count, 0, -1):
            made += bits.take_bytes(bits.number(plain))
            if left > 1:
                distance = bits.number(distances) + 1
                length = bits.number(lengths) + SHORTEST_COPY
                piece = made[len(made) - distance :][:length]
                made += (piece * (length // len(piece) + 1))[:length]
    if len(made) != int.from_bytes(file[4:8], "big"):
        raise ValueError("the packed file is damaged")
    return bytes(made)
