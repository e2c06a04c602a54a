"""Words of IPA in a voice's own names: it says the very sounds, or it is known that it cannot."""

import pytest

from phonemeengine.labels.phone_sets import split_ipa
from phonemeengine.text.espeak import SEPARATOR, Language, language_of, names_sounded, phone_names, symbols_of
from phonemeengine.text.respelling import respelt

WORDS = {
    "de": "Straße Bäckerei schön Jahr Feuer Bücher Pferd Garage zwölf Vater Psychologie Kirche öffnen Übung",
    "en-us": "butter church measure thought though bird letter happy singing strength fire cute rhythm",
    "en-gb": "water judge father nurse idea bottle garage vision queen example",
    "fr": "bonjour oiseau vin un lune peu peur montagne travail huit chaud",
    "es": "ayer perro pero ciudad guerra queso llave niño amigo",
    "it": "gnocchi famiglia pizza azzurro bello oggi",
    "ru": "привет хорошо человек любовь щека",
    "pl": "szczęście chrząszcz dziękuję źródło",
    "ja": "ありがとう さくら しんぶん",
}


def sounds_of(respelling: str, language: Language) -> str:
    names = names_sounded(respelling.removeprefix("[[").removesuffix("]]"), language).split(SEPARATOR)
    return "".join(symbol for name in names for symbol in symbols_of(name))


@pytest.mark.parametrize("tag", WORDS)
def test_whatever_a_voice_says_can_be_asked_of_it(tag: str) -> None:
    language = language_of(tag)
    for word in WORDS[tag].split():
        names = phone_names(word, language).split(SEPARATOR)
        said = "".join(symbol for name in names for symbol in symbols_of(name))
        assert sounds_of(respelt("".join(names), language), language) == said


@pytest.mark.parametrize(
    ("tag", "ipa"),
    [("de", "θɪŋ"), ("de", "tʃəˈtʃiːnə"), ("de", "ˈʒɛnɪ"), ("en-us", "ˈbʁoːt"), ("en-us", "ˈnæ.sə"), ("fr", "ʃøːn")],
)
def test_a_voice_may_say_what_its_language_does_not(tag: str, ipa: str) -> None:
    language = language_of(tag)
    assert sounds_of(respelt(ipa, language), language) == "".join(split_ipa(ipa)).replace(".", "")


@pytest.mark.parametrize(
    ("tag", "ipa"), [("de", "ˈnæsə"), ("en-us", "ʃøːn"), ("en-us", "ǃǂ"), ("de", ""), ("de", "ˈ")]
)
def test_what_a_voice_has_no_sounds_for_is_not_respelt(tag: str, ipa: str) -> None:
    assert respelt(ipa, language_of(tag)) == ""


def test_a_voice_keeps_its_own_way_with_sounds_between_others() -> None:
    spanish = language_of("es")
    assert sounds_of(respelt("aˈmiɡo", spanish), spanish) == "amiɣo"


@pytest.mark.parametrize(("tag", "ipa", "said"), [("de", "ˈfaːtɐ", "fatɜ"), ("en-gb", "kæt", "kat")])
def test_symbols_that_the_voice_writes_otherwise_are_understood(tag: str, ipa: str, said: str) -> None:
    assert sounds_of(respelt(ipa, language_of(tag)), language_of(tag)) == said


def test_length_and_stress_are_kept() -> None:
    german = language_of("de")
    assert respelt("ˈbiːtə", german) != respelt("ˈbɪtə", german)
    assert "'" in respelt("tsuːk", german)
    assert respelt("ˌba.ˈna", german).replace("|", "") == "[[b,an'a]]"
