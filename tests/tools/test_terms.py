"""The terms of window, help, documents, docstrings and comments are those of docs/terms.toml."""

import tomllib
from collections import Counter

import pytest

from tools.terms import (
    AREAS,
    GERMAN_PAGES,
    GLOSSARY,
    TERMS,
    found_in,
    german_glossary,
    glossary,
    prose_of,
    words_to_avoid,
)


@pytest.mark.parametrize("area", AREAS)
def test_no_word_to_avoid_stands_anywhere(area: str):
    assert [str(each) for each in found_in(area)] == []


def test_each_term_is_one_concept():
    terms = tomllib.loads(TERMS.read_text("utf-8"))["term"]
    for language, avoid in (("english", "avoid"), ("german", "avoid_german")):
        counts = Counter(word for term in terms for word in term.get(avoid, ()))
        assert [word for word, n in counts.items() if n > 1] == []
        names = {term[language] for term in terms if language in term}
        assert names.isdisjoint(counts)
    english = [term["english"] for term in terms]
    assert len(english) == len(set(english))


def test_the_glossaries_are_those_of_the_term_base():
    assert GLOSSARY.read_text("utf-8") == glossary()
    assert (GERMAN_PAGES / GLOSSARY.name).read_text("utf-8") == german_glossary()


def test_the_german_glossary_is_in_the_order_of_a_dictionary():
    lines = german_glossary().splitlines()
    starts = [
        next(k for k, line in enumerate(lines) if line.startswith(f"| {t} |"))
        for t in ("Aufnahme", "Äußerung", "Aussetzer")
    ]
    assert starts == sorted(starts)


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("The twin hears it.", ["twin", "hears"]),
        ("Call `morpher.add`, see [the ear](ship.md#ear).", ["ear"]),
        ("```\nheard\n```\n", []),
        ("A file `preset.ear` for {ear}.", []),
    ],
)
def test_words_are_found_in_prose_and_not_in_names(text: str, found: list[str]):
    pattern, _ = words_to_avoid("docs")
    assert [match[0] for match in pattern.finditer(prose_of(text, "docs"))] == found
