"""What texts say of feeling, and when a face shows it."""

from pathlib import Path

import pytest

from phonemeengine import Phoneme, TextError, Utterance
from phonemeengine.labels.utterance import Phone, Syllable, Word
from phonemeengine.mouth.blendshape_names import ARKIT
from phonemeengine.mouth.expression.felt import text_expression, timed_feelings
from phonemeengine.text.feelings import SHIPPED, load_feelings, passages_of

SMILE, FROWN = ARKIT.index("mouthSmileLeft"), ARKIT.index("mouthFrownLeft")


def word_of(text: str, start: float, end: float) -> Word:
    return Word(text, (Syllable((Phone(start, end, "a", Phoneme.A),), 0),))


def value(text: str, language: str) -> float:
    (passage,) = passages_of(text, language)
    return passage.shares.get("smile", 0.0) - passage.shares.get("sorrow", 0.0)


@pytest.mark.parametrize(
    ("language", "good", "bad", "neither"),
    [
        ("en-us", "I am very happy.", "I am not happy.", "The train leaves at nine."),
        ("de", "Das freut mich sehr.", "Ich bin traurig.", "Der Zug fährt um neun."),
        ("cmn", "我很高兴。", "我很难过。", "火车九点开。"),
        ("cmn", "他很喜歡。", "我不高兴。", "他是学生。"),
    ],
)
def test_good_words_lift_and_bad_ones_lower(language, good, bad, neither):
    assert value(good, language) > 0.3
    assert value(bad, language) < -0.3
    assert value(neither, language) == 0


def test_marks_and_emphasis_count():
    plain = value("That is good.", "en")
    assert value("That is good!", "en") > plain
    assert value("That is *good*.", "en") > plain
    assert value("That is GOOD.", "en") > plain
    emphasised = '<prosody rate="slow">That is <emphasis level="strong">good</emphasis>.</prosody>'
    assert value(emphasised, "en") == value("That is *good*.", "en")
    assert value('That is <emphasis level="reduced">good</emphasis>.', "en") == plain
    assert value("That is really good.", "en") > plain


@pytest.mark.parametrize(
    ("text", "shares"),
    [
        ("[smile] Well.", [{"smile": 1.0}]),
        ("[angry 0.6] Well.", [{"anger": 0.6}]),
        ("[happy 0.5, surprised 0.3] Well.", [{"smile": 0.5, "surprise": 0.3}]),
        ("Oh 😢 no", [{}, {"sorrow": 0.6}]),
        ('<express-as style="sad" styledegree="1">Oh.</express-as> Well.', [{"sorrow": 0.5}, {}]),
        ('<amazon:emotion name="excited" intensity="high">Oh.</amazon:emotion>', [{"smile": 1.0}, {}]),
        ("[wütend 0.6] Gut, [高兴] gut.", [{"anger": 0.6}, {"smile": 1.0}]),
        ("[opens the door] Well.", [{}]),
    ],
)
def test_directions_are_followed_and_other_ones_are_not(text, shares):
    assert [dict(passage.shares) for passage in passages_of(text, "en")] == shares


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("[angrey 0.6] No.", "there is no feeling 'angrey'; .*angry"),
        ("[angry 6] No.", "a feeling is shown by 0..1, found 6"),
        ("[smile] [sad] No.", "smile and sorrow are asked for at one place"),
        ("[happy 0.5, smile 0.2] No.", "smile is asked for by 0.5 and by 0.2; keep one"),
        ("[neutral, sad] No.", "neutral goes with no other feeling"),
        ('<express-as style="bored">No.</express-as>', "a tag asks for the feeling 'bored'"),
    ],
)
def test_directions_that_cannot_be_followed_are_refused_in_one_sentence(text, sentence):
    with pytest.raises(TextError, match=sentence):
        passages_of(text, "en")


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        ('"0.9" = "love*', '"9" = "love*', "words are good or bad by -1..1, found '9'"),
        ('"-0.5" = "bad', '"-0.5" = "happy bad', "'happy' is called both good and bad"),
        ('"0.9" = "love*', '"0.9" = 3 #', r"must be text, found 3"),
    ],
)
def test_a_lexicon_with_nonsense_is_refused_in_one_sentence(tmp_path: Path, old, new, sentence):
    path = tmp_path / "mine.toml"
    path.write_text(SHIPPED.read_text("utf-8").replace(old, new), "utf-8")
    with pytest.raises(TextError, match=sentence):
        load_feelings(path)


def test_a_face_shows_it_while_it_is_spoken():
    said = enumerate(("Wonderful", "Terrible", "Well"))
    words = tuple(word_of(text, k + 0.5, k + 1.4) for k, text in said)
    text = "Wonderful! Terrible! [neutral] Well."
    shown = text_expression(timed_feelings(text, Utterance(words, 4.0, "en")), 0.5)
    assert shown.weights(0.0)[SMILE] == 0
    assert shown.weights(1.2)[SMILE] > 0.25
    assert (shown.weights(2.2)[SMILE], shown.weights(3.3)[FROWN]) == (0, 0)
    assert shown.weights(2.2)[FROWN] > 0.2
