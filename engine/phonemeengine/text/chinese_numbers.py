"""Numbers within Chinese text, as characters that are read: 2024年 is 二零二四年, 3.5% is 百分之三点五."""

import re
import unicodedata

_DIGITS = "零一二三四五六七八九"
_UNITS = ("", "十", "百", "千")
_GROUPS = ("", "万", "亿", "万亿")
_MOST_DIGITS = 4 * len(_GROUPS)

NUMBER = re.compile(r"[+-]?\d+(?:,\d{3})+(?:\.\d+)?%?|\d{1,2}:\d{2}(?::\d{2})?|[+-]?\d+(?:\.\d+)?%?(?:年)?")
"""What is read as one number, digits being those of ASCII; see `to_ascii_digits`."""
_WIDE_NUMBER = re.compile(r"[０-９]+(?:[．：，][０-９]+)*％?")


def to_ascii_digits(text: str) -> str:
    """Return a text with numbers of full width, and the marks in them, as narrow ones."""
    return _WIDE_NUMBER.sub(lambda found: unicodedata.normalize("NFKC", found.group()), text)


def read_number(number: str) -> str:
    """Return the characters that a number is read as; `number` matches `NUMBER`."""
    if number.endswith("年"):
        year = number[:-1]
        return (_digit_by_digit(year) if year.isdecimal() and len(year) in {2, 4} else read_number(year)) + "年"
    if ":" in number:
        return _time(number.split(":"))
    if number.endswith("%"):
        return "百分之" + read_number(number[:-1])
    if number[0] in "+-":
        return ("负" if number[0] == "-" else "正") + read_number(number[1:])
    whole, _, decimals = number.replace(",", "").partition(".")
    return _cardinal(whole) + ("点" + _digit_by_digit(decimals) if decimals else "")


def _time(parts: list[str]) -> str:
    read = [_cardinal(part.lstrip("0") or "0") for part in parts]
    minutes = ("零" if parts[1][0] == "0" else "") + read[1] + "分" if int(parts[1]) else "整" * (len(parts) < 3)
    return read[0] + "点" + minutes + (read[2] + "秒" if len(parts) > 2 else "")


def _digit_by_digit(digits: str) -> str:
    return "".join(_DIGITS[int(digit)] for digit in digits)


def _cardinal(digits: str) -> str:
    """Return a number of things; one that begins with 0, such as a code, and one that is too long, digit by digit."""
    if (digits[0] == "0" and len(digits) > 1) or len(digits) > _MOST_DIGITS:
        return _digit_by_digit(digits)
    if digits == "0":
        return _DIGITS[0]
    padded = digits.zfill(-(-len(digits) // 4) * 4)
    groups = [padded[k : k + 4] for k in range(0, len(padded), 4)]
    parts = [
        _group(group) + unit if int(group) else "零"
        for group, unit in zip(groups, reversed(_GROUPS[: len(groups)]), strict=True)
    ]
    read = re.sub("零+", "零", "".join(parts)).strip("零")
    return read.removeprefix("一") if read.startswith("一十") else read


def _group(four: str) -> str:
    """Return four digits, not all 0; zeros between others are said once, those at the end are not."""
    parts = [
        _DIGITS[int(digit)] + unit if digit != "0" else "零"
        for digit, unit in zip(four, reversed(_UNITS), strict=True)
    ]
    return re.sub("零+", "零", "".join(parts)).rstrip("零")
