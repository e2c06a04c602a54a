import pytest

from phonemeengine import TextError
from phonemeengine.labels.phone_sets import ipa_class, ipa_phoneme
from phonemeengine.phonemes import Phoneme
from phonemeengine.text.lexicon import Lexicon
from phonemeengine.text.pronunciation import words_of
from phonemeengine.text.syllables import SpokenSyllable

SAMPLES = {
    "en-us": "The judge would have measured pure fire in the church at 4:30, wouldn't he? Little boys sing louder.",
    "en-gb": "Poor Claire heard the tour near the airport; who knew? Bottle, button, thought, loch, vision.",
    "de": "Der Zug pfeift. Ich möchte schöne Äpfel über 25 Jahre genießen, auch Chance und Garage, Pfütze.",
    "fr": "Les enfants ont mangé un bon vin blanc, l'œuf et la peur, huit feuilles, un parfum de montagne.",
    "it": "Gli gnocchi della zia sono pizza, lasciare, ghiaccio e buon giorno, perché zero sbaglio.",
    "es": "El niño llamó a José: ¿qué haces aquí, guerra, lluvia, cabeza, dedo, agua y Extremadura?",
    "cs": "Příliš žluťoučký kůň úpěl ďábelské ódy, řeka, tři, chléb, džbán.",
    "ru": "Съешь же ещё этих мягких французских булок, да выпей чаю; щука, жизнь, объём.",
    "fi": "Törkylempijävongahdus, yö, kaupunki, äiti, hyvää päivää, rengas.",
    "nl": "Goedemorgen, de ui en het huis, schip, leeuw, nieuw, vrouw, garage, twintig gulden.",
    "pl": "Zażółć gęślą jaźń, szczęście, źdźbło, dziękuję, dżungla, część.",
    "pt": "Coração, não, mãe, pão, filho, amanhã, chuva, cinco, gente, rapaz, muito.",
    "ro": "Țară, șapte, câine, gheață, ciorbă, împărat, băiat, geam, pâine.",
    "hu": "Árvíztűrő tükörfúrógép, gyár, nyúl, zsák, dzsungel, tyúk, cél.",
    "lt": "Įlinkdama fechtuotojo špaga sublykčiojusi pragręžė apvalų arbūzą, džiaugsmas, čia.",
    "ja": "こんにちは、せかい。きょうは とても あつい ですね。じゃあ、りゅうがく。",
    "sv": "Sju sjösjuka sjömän, kött, tjugo, gärna, kjol, barn, fors.",
    "tr": "Pijamalı hasta yağız şoföre çabucak güvendi, ılık, göğüs.",
    "el": "Ξεσκεπάζω την ψυχοφθόρα βδελυγμία, γη, χέρι, θάλασσα.",
    "ko": "안녕하세요, 세계. 꽃이 피었습니다.",
    "hi": "नमस्ते दुनिया, ठंडा पानी, ढाई घंटे, क्षत्रिय।",
    "ar": "السلام عليكم، صباح الخير، ضوء، طفل، عين، غرفة.",
}


def _spoken(text: str, language: str, lexicon: Lexicon | None = None) -> list[str]:
    return ["".join(word.pronunciations[0].phones) for word in words_of(text, language, lexicon)]


@pytest.mark.parametrize("language", SAMPLES)
def test_every_phone_that_a_voice_says_is_known(language: str) -> None:
    words = words_of(SAMPLES[language], language)
    phones = {phone for word in words for variant in word.pronunciations for phone in variant.phones}
    assert len(words) >= 4
    assert {phone for phone in phones if ipa_class(phone) is None} == set()


def test_each_word_has_its_own_phones_though_the_voice_melts_them_together() -> None:
    assert _spoken("out of the house", "en-us") == ["aʊt", "ʌv", "ðə", "haʊs"]


def test_a_word_is_pronounced_as_its_neighbours_have_it_and_as_it_is_alone() -> None:
    les = words_of("les amis", "fr")[0]
    assert [variant.phones for variant in les.pronunciations] == [("l", "e", "z"), ("l", "e")]


def test_an_affricate_is_a_closure_and_friction() -> None:
    (church,) = words_of("church", "en-us")
    assert church.pronunciations[0].phones == ("t", "ʃ", "ɜ", "t", "ʃ")


def test_a_number_is_one_word_that_is_read_out() -> None:
    (number,) = words_of("24", "de")
    assert number.text == "24"
    assert "".join(number.pronunciations[0].phones).startswith("fi")


def test_stress_stands_on_the_syllable_that_bears_it() -> None:
    (potato,) = words_of("potato", "en-us")
    assert [syllable.stress for syllable in potato.pronunciations[0].syllables] == [0, 1, 0]


def test_marks_around_a_word_are_no_part_of_it() -> None:
    assert [word.text for word in words_of("“Well, (yes)!” — no…", "en-us")] == ["Well", "yes", "no"]


def test_the_lexicon_goes_before_the_voice_whatever_the_case_of_letters() -> None:
    lexicon = Lexicon({"nasa": ((SpokenSyllable(("n", "ɔ")),),)})
    assert _spoken("NASA flies", "en-us", lexicon) == ["nɔ", "flaɪz"]


def test_a_long_text_without_a_mark_is_read_to_its_end() -> None:
    assert len(words_of("one two three four five " * 400, "en-us")) == 2000


def test_an_unknown_language_is_refused_and_some_are_named() -> None:
    with pytest.raises(TextError, match=r"language 'xx'.*en-us.*de"):
        words_of("hello", "xx")


@pytest.mark.parametrize("language", [None, ""])
def test_the_language_is_never_guessed(language: str | None) -> None:
    with pytest.raises(TextError, match="not guessed"):
        words_of("hello", language)


def test_a_vowel_keeps_its_class_whatever_its_marks() -> None:
    phones = words_of("mañana", "es")[0].pronunciations[0].phones
    assert [ipa_phoneme(phone) for phone in phones] == [
        Phoneme.M,
        Phoneme.A,
        Phoneme.UNIDENTIFIED,
        Phoneme.A,
        Phoneme.UNIDENTIFIED,
        Phoneme.A,
    ]


@pytest.mark.parametrize(
    ("text", "language"),
    [("Привет, мир", "de"), ("Привет, мир", "en-us"), ("你好，世界", "de"), ("Γειά σου", "en-us"), ("漢字", "ja")],
)
def test_a_text_of_a_script_that_the_voice_only_spells_is_refused(text: str, language: str) -> None:
    with pytest.raises(TextError, match="another script; name the language"):
        words_of(text, language)


def test_a_foreign_word_among_others_is_read_all_the_same() -> None:
    assert len(words_of("Er sagte привет zu mir", "de")) == 5
