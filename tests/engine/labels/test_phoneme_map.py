"""Names of sounds: what is known, what is doubtful, what the user says, and what is asked for."""

import pytest

from phonemeengine.errors import CorpusError, UnknownPhonemeError
from phonemeengine.labels.files import read_labels
from phonemeengine.labels.phone_sets import PhonemeMap, load_phoneme_map
from phonemeengine.phonemes import Phoneme


def meanings(names, mapping=None):
    """Give phoneme and certainty of each name, where the names stand together in a file."""
    senses = (mapping or PhonemeMap()).phone_classes_of(dict.fromkeys(names.split(), 1), "x.txt")
    return {name: (senses[name].phoneme.label, senses[name].certainty) for name in names.split()}


def tracked(tmp_path, *names):
    path = tmp_path / "x.txt"
    path.write_text("".join(f"{k}\t{k + 1}\t{name}\n" for k, name in enumerate(names)), encoding="utf-8")
    return path


@pytest.mark.parametrize("name", [p.label for p in Phoneme])
def test_our_own_names_are_known_in_any_case(name):
    for spelt in (name, name.upper(), name.title()):
        assert meanings(spelt)[spelt] == (name, "core")


def test_arpabet_is_known_with_its_stress():
    found = meanings("SH IY1 HH AE1 D Y ER0 S AY2 sil sp")
    assert found["SH"] == ("sch", "core")
    assert found["IY1"] == ("i", "core")
    assert found["AE1"] == ("e", "ambiguous")
    assert found["S"] == ("sz", "core")
    assert found["AY2"] == ("a", "diphthong")
    assert found["sil"] == found["sp"] == ("silence", "core")
    assert found["HH"] == ("unidentified", "core")


def test_ipa_is_known_with_its_marks():
    found = meanings("ˈʃ ɑː n̩ ʔ t͡s pʰ ə")
    assert [name for name, _ in found.values()] == ["sch", "a", "unidentified", "unidentified", "sz", "p", "e"]


def test_the_company_of_s_tells_which_alphabet_it_is_of():
    assert meanings("S AA1 Z T")["S"] == ("sz", "core")
    assert meanings("S a: Z 2: @ t")["S"] == ("sch", "core")
    assert meanings("S ɐ ʃ Z", PhonemeMap({"S": Phoneme.SZ, "Z": Phoneme.SZ}))["S"] == ("sz", "core")


def test_s_alone_is_asked_for():
    with pytest.raises(UnknownPhonemeError) as caught:
        meanings("S a m")
    assert caught.value.counts == {"S": 1}


def test_an_affricate_is_closure_and_friction(tmp_path):
    labels = read_labels(tracked(tmp_path, "tʃ", "a"))
    assert [(x.phoneme.label, x.certainty) for x in labels] == [
        ("unidentified", "affricate"),
        ("sch", "affricate"),
        ("a", "core"),
    ]
    assert (labels[0].start, labels[0].end, labels[1].end) == (0, 0.45, 1)
    assert [x.phone for x in labels] == ["tʃ_cl", "tʃ_fr", "a"]


def test_all_unknown_names_are_told_with_their_counts(tmp_path):
    path = tracked(tmp_path, "xyz", "a", "blub", "blub", "m")
    with pytest.raises(
        UnknownPhonemeError, match=r"x\.txt: .*'blub' \(2 x\), 'xyz' \(1 x\); map each .*--map"
    ) as caught:
        read_labels(path)
    assert caught.value.counts == {"blub": 2, "xyz": 1}
    labels = read_labels(path, PhonemeMap({"blub": Phoneme.U, "xyz": Phoneme.SILENCE}))
    assert [x.phoneme.label for x in labels] == ["silence", "a", "u", "u", "m"]
    assert labels[2].phone == "blub"


def test_hundreds_of_unknown_names_are_one_sentence():
    with pytest.raises(UnknownPhonemeError) as caught:
        meanings(" ".join(f"q{k}{'x' * 50}" for k in range(300)))
    assert len(caught.value.counts) == 300
    assert len(str(caught.value)) < 500
    assert "and 292 others" in str(caught.value)


def test_what_the_user_says_goes_before_all_else():
    assert meanings("e i", PhonemeMap({"e": Phoneme.I}))["e"] == ("i", "core")


def test_a_mapping_may_be_written_by_hand(tmp_path):
    toml, table = tmp_path / "m.toml", tmp_path / "m.csv"
    toml.write_text('[phonemes]\n"ö" = "O"\n', encoding="utf-8")
    table.write_text("name,phoneme\nö, O\n", encoding="utf-16")
    assert load_phoneme_map(toml) == load_phoneme_map(table) == PhonemeMap({"ö": Phoneme.O})


@pytest.mark.parametrize(
    ("name", "text", "message"),
    [
        ("m.toml", "", "a table"),
        ("m.toml", "[phonemes", "no TOML"),
        ("m.toml", '[phonemes]\nx = "q"', "'x' must stand for one of silence, .*, found 'q'"),
        ("m.toml", "[phonemes]\nx = 3", "found 3"),
        ("m.toml", "phonemes = 3", "a table"),
        ("m.toml", 'format = "phonemeanalyser mapping 2"\n[phonemes]\nx = "a"', "newer version"),
        ("m.csv", "name,phoneme\nx,q\n", "found 'q'"),
        ("m.csv", "a,b\n", "lacks the column name"),
        ("m.csv", "name,phoneme\nx,a\nx,m\n", "line 3: 'x' stands there twice"),
    ],
)
def test_a_bad_mapping_is_refused_in_one_sentence(tmp_path, name, text, message):
    path = tmp_path / name
    path.write_text(text)
    with pytest.raises(CorpusError, match=message) as caught:
        load_phoneme_map(path)
    assert str(caught.value).startswith(name)
    assert "\n" not in str(caught.value)
