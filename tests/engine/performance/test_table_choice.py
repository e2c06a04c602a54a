import pytest

from phonemeengine import PerformanceError
from phonemeengine.performance.choice import chosen_table
from phonemeengine.performance.table_file import TableAbout

TABLES = [
    TableAbout(f"{person} {language}", False, 1, 1.0, ("jawOpen",), 60.0, "", person, language)
    for person, language in (("Ann", "en-us"), ("Ann", "de"), ("Ann", "en-gb"), ("Bo", "zh"), ("", ""))
]


@pytest.mark.parametrize(
    ("use", "person", "language", "name"),
    [
        ("Bo zh", None, "de", "Bo zh"),
        (None, "Bo", "en-us", "Bo zh"),
        (None, "Ann", "DE", "Ann de"),
        (None, "Ann", "de-at", "Ann de"),
        (None, None, "en-gb", "Ann en-gb"),
        (None, None, "cmn", "Bo zh"),
        (None, None, "fi", " "),
        (None, None, "", " "),
    ],
)
def test_name_person_and_language_choose_a_table(use: str, person: str, language: str, name: str) -> None:
    assert TABLES[chosen_table(TABLES, use, person, language)].name == name


@pytest.mark.parametrize(
    ("use", "person", "language", "sentence"),
    [
        (
            "Eve",
            None,
            "",
            "there is no such table 'Eve', but 'Ann en-us', 'Ann de', 'Ann en-gb', 'Bo zh', ' '; choose",
        ),
        ("Ann de", "Bo", "", "there is no such table 'Ann de', but 'Bo zh'; choose another one with --use"),
        (None, "Eve", "de", "there is no table of 'Eve', but of 'Ann', 'Bo'; choose another one with --person"),
        (None, "Ann", "en", "one table moves a face, and there are 'Ann en-us', 'Ann en-gb'; name one of them"),
    ],
)
def test_a_choice_that_is_none_is_refused_with_what_there_is(
    use: str, person: str, language: str, sentence: str
) -> None:
    with pytest.raises(PerformanceError, match=sentence):
        chosen_table(TABLES, use, person, language)
