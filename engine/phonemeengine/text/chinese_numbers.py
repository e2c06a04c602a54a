"""Numbers in Chinese text, in the characters that they are read with."""

import re

DIGITS = "零一二三四五六七八九"
MOST_DIGITS = 16
"""A longer number is read digit by digit, as is one that begins with 0, and a telephone number."""

_PLACES, _GROUPS = ("", "十", "百", "千"), ("", "万", "亿", "万亿")
NUMBER = re.compile(r"(?<![0-9A-Za-z])[+-]?\d+(?:[.,:：]\d+)*[%％年]?(?![A-Za-z])", re.ASCII)
"""With the marks in it; numbers that touch Latin letters belong to their word."""
_YEAR = re.compile(r"(\d{4})年")
_TIME = re.compile(r"(\d{1,2})[:：]([0-5]\d)")
_QUANTITY = re.compile(r"(\d{1,3}(?:,\d{3})+|\d+)(?:\.(\d+))?([%％年]?)")
_FULL_WIDTH = {ord("０") + k: ord("0") + k for k in range(10)}


def numbers_spelt(text: str) -> str:
    """Return a text whose numbers are written in Chinese characters; those in Latin words stay.

    Years are read digit by digit, times as hours and minutes, and what has no known form digit by digit.
    """
    return NUMBER.sub(lambda number: read_number(number[0]), to_ascii_digits(text))


def to_ascii_digits(text: str) -> str:
    """Return a text with digits of full width as narrow ones."""
    return text.translate(_FULL_WIDTH)


def read_number(number: str) -> str:
    """Return the characters that a number is read as; it matches `NUMBER`."""
    if number[0] in "+-":
        return ("负" if number[0] == "-" else "正") + read_number(number[1:])
    if year := _YEAR.fullmatch(number):
        return f"{_one_by_one(year[1])}年"
    if time := _TIME.fullmatch(number):
        return _time(int(time[1]), int(time[2]))
    if quantity := _QUANTITY.fullmatch(number):
        return _quantity(quantity[1].replace(",", ""), quantity[2], quantity[3])
    return _one_by_one(number)


def _time(hour: int, minute: int) -> str:
    minutes = f"{'零' if minute < 10 else ''}{_cardinal(str(minute))}分" if minute else ""
    return f"{_cardinal(str(hour))}点{minutes}"


def _quantity(whole: str, decimals: str | None, unit: str) -> str:
    read = _cardinal(whole) + (f"点{_one_by_one(decimals)}" if decimals else "")
    return f"百分之{read}" if unit in {"%", "％"} else f"{read}{unit}"


def _one_by_one(number: str) -> str:
    return "".join(DIGITS[int(c)] if c.isdecimal() else c if c == "年" else "" for c in number)


def _cardinal(digits: str) -> str:
    telephone = len(digits) == 11 and digits[0] == "1"
    if len(digits) > MOST_DIGITS or telephone or (digits[0] == "0" and len(digits) > 1):
        return _one_by_one(digits)
    groups = [digits[max(k - 4, 0) : k] for k in range(len(digits), 0, -4)]
    read = "".join(_group(group, unit) for group, unit in reversed([*zip(groups, _GROUPS, strict=False)]))
    read = re.sub("零+", "零", read).rstrip("零") or DIGITS[0]
    return read.removeprefix("一") if read.startswith("一十") else read


def _group(digits: str, unit: str) -> str:
    """Return up to four digits with their unit; 零 stands where some are missing."""
    places = reversed(_PLACES[: len(digits)])
    named = (DIGITS[int(d)] + (place if d != "0" else "") for d, place in zip(digits, places, strict=True))
    read = re.sub("零+", "零", "".join(named)).rstrip("零")
    return f"{read}{unit}" if read else DIGITS[0]
