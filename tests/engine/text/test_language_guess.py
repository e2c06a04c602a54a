"""The language of a text, by its script and its short words."""

import pytest

from phonemeengine.text.script import guess_language


@pytest.mark.parametrize(
    ("text", "tag"),
    [
        ("Author of the danger trail, and this is what they have for you.", "en-us"),
        ("Ich glaube nicht, dass wir das mit dem Hund auch noch schaffen.", "de"),
        ("Il ne sait pas que vous êtes dans la maison avec elle.", "fr-fr"),
        ("No sé por qué el perro está con los niños, pero es muy bueno.", "es"),
        ("Ich habe the book und die list for you", ""),
        ("你好，我们去哪里？", "cmn"),
        ("これは日本語です", "ja"),
        ("Это не моя книга", "ru"),
        ("so oh", ""),
        ("", ""),
    ],
)
def test_a_language_is_guessed_where_its_words_or_letters_tell_it(text: str, tag: str) -> None:
    assert guess_language(text) == tag
