"""Words are found where they are said, whatever else is said, and however long it lasts."""

import pytest

from phonemeengine.alignment import aligner as room
from phonemeengine.alignment.aligner import Aligner
from phonemeengine.alignment.evidence import Evidence, joined
from phonemeengine.errors import CorpusError
from phonemeengine.labels.utterance import UNKNOWN_WORD, Utterance
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import FRAME_PERIOD
from phonemeengine.text.pronunciation import ScriptWord
from tests.engine.alignment.speaking import heard, word, words


def aligned(evidence: Evidence, script: list[ScriptWord], block: int = 100) -> tuple[Utterance, Aligner]:
    aligner = Aligner(script, len(evidence))
    for first in range(0, len(evidence), block):
        aligner.push(evidence.part(slice(first, first + block)))
    return aligner.finish(len(evidence) * FRAME_PERIOD, "xx"), aligner


def spans(utterance: Utterance) -> list[tuple[str, int, int]]:
    return [(w.text, round(w.start / FRAME_PERIOD), round(w.end / FRAME_PERIOD)) for w in utterance.words]


def test_words_and_phones_lie_where_they_are_said():
    utterance, aligner = aligned(heard(".sima.lupo."), words("sima lupo"))
    assert spans(utterance) == [("sima", 8, 40), ("lupo", 48, 80)]
    assert [(p.ipa, p.phoneme) for p in utterance.words[0].phones] == [
        ("s", Phoneme.SZ),
        ("i", Phoneme.I),
        ("m", Phoneme.M),
        ("a", Phoneme.A),
    ]
    assert utterance.words[0].syllables[0].stress == 1
    assert (utterance.language, utterance.skipped) == ("xx", ())
    assert not aligner.fit.is_wrong


def test_a_score_is_best_where_the_sound_is_the_word():
    utterance, _ = aligned(heard(".sima.lupa."), words("sima lupo"))
    right, wrong = (w.score for w in utterance.words)
    assert right == pytest.approx(0.0, abs=0.05)
    assert wrong is not None
    assert wrong > 0.5


def test_the_pronunciation_that_is_said_is_taken():
    utterance, _ = aligned(heard(".sima."), [word("x", "lupo", "sima")])
    assert "".join(phone.ipa for phone in utterance.phones) == "sima"


def test_a_word_that_is_left_out_is_skipped():
    utterance, aligner = aligned(heard(".sima.lupo."), words("sima fetu lupo"))
    assert [w.text for w in utterance.words] == ["sima", "lupo"]
    assert utterance.skipped == ("fetu",)
    assert not aligner.fit.is_wrong


@pytest.mark.parametrize("added", ["fetuʃa", "simalu"], ids=["other words", "a repetition"])
def test_what_is_said_besides_is_an_unknown_word_with_its_sounds(added: str):
    utterance, _ = aligned(heard(f".sima.{added}.lupo."), words("sima lupo"))
    assert sorted(w.text for w in utterance.words) == sorted(["sima", "lupo", UNKNOWN_WORD])
    (unknown,) = (w for w in utterance.words if w.text == UNKNOWN_WORD)
    assert {phone.ipa for phone in unknown.phones} == {""}
    assert {phone.phoneme for phone in unknown.phones} >= {Phoneme.U}


def test_the_quiet_of_a_stop_is_part_of_it():
    sound = joined([heard("sima"), heard(".", 6), heard("pa")])
    utterance, _ = aligned(sound, words("simapa"))
    stop = utterance.words[0].phones[4]
    assert (stop.ipa, round(stop.start / FRAME_PERIOD), round(stop.end / FRAME_PERIOD)) == ("p", 32, 46)


def test_another_text_is_known_to_be_wrong():
    _, aligner = aligned(heard(".simasima.lupolupo."), words("fetu zapi kelo miʃu"))
    assert aligner.fit.is_wrong


def test_hurried_speech_has_shorter_sounds():
    utterance, aligner = aligned(joined([heard("."), heard("simalupo", 4), heard(".")]), words("sima lupo"))
    assert spans(utterance) == [("sima", 8, 24), ("lupo", 24, 40)]
    assert not aligner.fit.is_wrong


def test_too_little_sound_for_the_words_is_another_text():
    utterance, aligner = aligned(heard(".s.", 2), words("sima lupo sima lupo"))
    assert aligner.fit.is_wrong
    assert len(utterance.skipped) >= 3
    nothing, _ = aligned(heard(""), words("sima"))
    assert (nothing.words, nothing.skipped) == ((), ("sima",))


def test_a_script_without_words_is_refused():
    with pytest.raises(CorpusError, match="there is no word in the text; write down what is said"):
        Aligner([], 100)


def test_a_long_sound_is_aligned_as_its_parts_are():
    script = words("sima lupo fetu") * 40
    utterance, aligner = aligned(heard(".sima.lupo.fetu" * 40), script, block=512)
    assert len(heard(".sima.lupo.fetu" * 40)) > 3 * room.STRETCH
    assert spans(utterance) == [(w.text, 40 * k + 8, 40 * k + 40) for k, w in enumerate(script)]
    assert not aligner.fit.is_wrong


def test_pauses_and_asides_that_are_longer_than_a_stretch_are_passed():
    pause, aside = "." * 300, "ʃu" * 150
    utterance, _ = aligned(heard(f".sima{pause}lupo{aside}fetu."), words("sima lupo fetu"))
    assert [w.text for w in utterance.words] == ["sima", "lupo", UNKNOWN_WORD, "fetu"]
    assert utterance.skipped == ()


def test_how_the_sound_is_cut_changes_nothing():
    sound, script = heard(".sima.lupo.fetu" * 12), words("sima lupo fetu") * 12
    assert len({aligned(sound, script, block)[0] for block in (1, 77, 5000)}) == 1


def unsure_silence(n_frames: int) -> Evidence:
    """Silence that the recogniser takes for a vowel as likely as not, as it does where it never heard such a room."""
    quiet = heard("." * (n_frames // 8))
    quiet.probabilities[:] = 0.03
    quiet.probabilities[:, [Phoneme.SILENCE, Phoneme.E]] = 0.5, 0.25
    return quiet


@pytest.mark.parametrize("seconds", [3, 15, 40])
def test_silence_before_the_speech_neither_takes_words_nor_makes_another_text(seconds: int):
    before = unsure_silence(100 * seconds)
    utterance, aligner = aligned(joined([before, heard(".sima.lupo.")]), words("sima lupo"))
    n = len(before)
    assert spans(utterance) == [("sima", n + 8, n + 40), ("lupo", n + 48, n + 80)]
    assert not aligner.fit.is_wrong
    _, wrong = aligned(joined([before, heard(".sima.lupo.")]), words("fetu zapi"))
    assert wrong.fit.is_wrong


def test_a_word_in_a_hurry_is_found_after_silence():
    before = heard("." * 300)
    utterance, _ = aligned(joined([before, heard("simalupo", 4), heard(".")]), words("sima lupo"))
    n = len(before)
    assert spans(utterance) == [("sima", n, n + 16), ("lupo", n + 16, n + 32)]


def test_a_text_of_which_a_few_sounds_are_heard_otherwise_is_accepted():
    """Whoever speaks with an accent, or into a bad microphone, says the text nevertheless."""
    utterance, aligner = aligned(heard(".sima.lupo.fetu.zapi."), words("sema lupa fetu tapi"))
    assert not aligner.fit.is_wrong
    assert [w.text for w in utterance.words] == ["sema", "lupa", "fetu", "tapi"]


def test_an_accepted_text_is_aligned_though_another_one_is_said():
    sound, script = heard(".simasima.lupolupo."), words("fetu zapi kelo")
    aligner = Aligner(script, len(sound), accepted=True)
    aligner.push(sound)
    found = aligner.finish(len(sound) * FRAME_PERIOD)
    assert [w.text for w in found.words if w.text != UNKNOWN_WORD] == ["fetu", "zapi", "kelo"]
