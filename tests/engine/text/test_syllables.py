from phonemeengine.text.syllables import syllables_of


def _joined(phones: str, stresses: str = "") -> str:
    parts = phones.split()
    marks = [int(c) for c in stresses] or [0] * len(parts)
    return ".".join("".join(syllable.phones) for syllable in syllables_of(parts, marks))


def test_a_consonant_between_vowels_begins_the_second_syllable() -> None:
    assert _joined("ɛ s ə n") == "ɛ.sən"


def test_consonants_begin_a_syllable_as_long_as_they_grow_more_sonorous() -> None:
    assert _joined("ɛ n t ɹ i") == "ɛn.tɹi"
    assert _joined("ɪ k s t ɹ i m") == "ɪk.stɹim"


def test_the_halves_of_an_affricate_stay_together() -> None:
    assert _joined("k ɪ t ʃ ə n") == "kɪ.tʃən"
    assert _joined("a p f ə l") == "a.pfəl"


def test_a_velar_nasal_begins_no_syllable() -> None:
    assert _joined("s ɪ ŋ ɪ ŋ") == "sɪŋ.ɪŋ"


def test_a_word_without_a_vowel_is_one_syllable() -> None:
    assert _joined("v") == "v"
    assert _joined("p s t") == "pst"


def test_a_syllabic_consonant_makes_a_syllable() -> None:
    assert _joined("h a b m̩") == "ha.bm̩"


def test_a_syllable_is_stressed_as_its_vowel_is() -> None:
    assert [s.stress for s in syllables_of(("t", "ə", "m", "ɑ"), (0, 0, 0, 1))] == [0, 1]
