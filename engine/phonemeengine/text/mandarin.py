"""Mandarin in Chinese characters, as pinyin: the only door to pypinyin.

It knows phrases, so characters that are read in several ways come right as far as their clause tells, and it changes
tones as speech does (a third tone before another one, 不 and 一).
"""

HANZI = "[\u3007\u3400-\u4dbf\u4e00-\u9fff\uf900-\ufaff\U00020000-\U0003ffff]"
"""A Chinese character, as a regular expression."""


def pinyin_of(hanzi: str) -> list[str]:
    """Return the pinyin of each character, with its tone as a digit (5 is neutral) and ü, such as ``lü4``.

    What stands for a character that nobody knows is no pinyin.

    Parameters
    ----------
    hanzi : Chinese characters without anything else, a clause at a time.
    """
    from pypinyin import Style, lazy_pinyin  # noqa: PLC0415 - half a second, and only Chinese needs it

    return lazy_pinyin(
        hanzi,
        style=Style.TONE3,
        errors=list,  # type: ignore[arg-type]  # each unknown character by itself
        neutral_tone_with_five=True,
        tone_sandhi=True,
        v_to_u=True,
    )
