"""The notation of scripts is not spoken, and what only looks like it is."""

import pytest

from phonemeengine import words_of
from phonemeengine.text.cleaning import speakable, spoken_part

SPOKEN = {
    "*very* **never** ***so*** _how_ un*believ*able": "very never so how unbelievable",
    "<i>Hi</i>, un<b>think</b>able<br/>is <!-- a remark --> it": "Hi, unthinkable is it",
    "<speak>The <sub alias='World Wide Web'>WWW</sub><break time='1s'/>is <emphasis>old</emphasis></speak>": (
        "The World Wide Web is old"
    ),
    "Tom &amp; Anna say &quot;no&quot; &#228;": 'Tom & Anna say "no" ä',
    "Mary: Hello.": "Hello.",
    "MARY (V.O.): (quietly) Hello.\nDr. Smith: Who?\nGuard 2: Halt!": "Hello. Who? Halt!",
    "**Anna von Berg:** Ja.": "Ja.",
    "[laughs] Oh, no. [door slams]": "Oh, no.",
    "(laughing softly) Oh, no. (sighs)": "Oh, no.",
    "# One\n* two\n> three": "One two three",
    "小明：你好。\n小红：再见。": "你好。 再见。",
}


@pytest.mark.parametrize(("script", "said"), SPOKEN.items())
def test_notation_is_not_spoken(script: str, said: str) -> None:
    assert spoken_part(script).text.split() == said.split()


@pytest.mark.parametrize(
    "text",
    [
        "2 * 3 * 4 is 5*3*2 in snake_case_names <3 and AT&T, R&D; at 10:30",
        "Remember: never give up.",
        "The answer is: no.",
        "He came (as always) too late.",
        "To be honest (to be quite honest), no.",
        "say [[h@'loU]]",
        "他说：你好。",
    ],
)
def test_what_only_looks_like_notation_is_spoken(text: str) -> None:
    assert spoken_part(text).text == text


@pytest.mark.parametrize(
    ("language", "script", "said"),
    [
        ("de", "Achtung: Stufe! (lacht leise)", "Achtung: Stufe!"),
        ("fr-fr", "Attention : (soupire) la marche", "Attention : la marche"),
        ("en-us", "Well (lacht leise)", "Well (lacht leise)"),
        ("de", "Well (laughs)", "Well"),
    ],
)
def test_words_of_the_language_tell_directions_and_names(language: str, script: str, said: str) -> None:
    assert spoken_part(script, language).text.split() == said.split()


def test_names_and_directions_that_are_left_out_are_told() -> None:
    cleaned = speakable("MARY: [laughs] Hello. (sighs)")
    assert cleaned.text.strip() == "Hello."
    assert cleaned.notes == ("names and directions of the script are not spoken: MARY, [laughs], (sighs)",)
    assert speakable("*Very* good").notes == ()


def test_a_literal_script_is_taken_as_it_is() -> None:
    script = "Mary: [laughs] *Hello*."
    assert speakable(script, literal=True) == speakable(script, "en-us", literal=True)
    assert speakable(script, literal=True).text == script
    assert [word.text for word in words_of(script, "en-us")] == ["Hello"]
    assert {"Mary", "laughs", "Hello"} <= {word.text for word in words_of(script, "en-us", literal=True)}


def test_emphasis_changes_no_sound() -> None:
    plain, marked = (words_of(text, "en-us") for text in ("It is very good &c.", "It is *very* <b>good</b> &c."))
    assert plain == marked


def test_a_quarter_of_a_megabyte_of_marks_is_read_in_one_go() -> None:
    for mark in ("_", "*", "(", "[", "<", "&", "A ", "Aa: ", "(laughs) ", "*a* ", "<b> "):
        spoken_part(mark * ((1 << 18) // len(mark)))
