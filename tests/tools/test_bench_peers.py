"""What the answers of other recognisers are taken for, before they are compared with ours."""

from pathlib import Path

import numpy as np
import pytest

from phonemeengine.calibration.scores.corpus import FrameLabels, LabelledUtterance
from phonemeengine.labels.utterance import Label
from phonemeengine.labels.visemes import NO_VISEME
from phonemeengine.phonemes import PHONEMES_BY_LABEL, Phoneme
from tools.bench.peers.__main__ import first_of_each
from tools.bench.peers.mapping import (
    VISEMES,
    arpabet_class,
    best_delay,
    delayed,
    frames_of,
    ipa_token_class,
    viseme_class,
)
from tools.bench.peers.peer import PEERS, Peer, PeerError, Workshop

POCKETSPHINX = (
    "SIL +NSN+ +SPN+ AA AE AH AO AW AY B CH D DH EH ER EY F G HH IH IY JH K L M N NG OW OY P R S SH T TH UH UW V "
    "W Y Z ZH"
)
HAMA = (
    "a aɪ aʊ b c d d͡ʒ e eə eɪ f g h i j ja je jo ju jʌ k kʰ k͈ l m n o oʊ p pʰ p͈ r s s͈ t tʰ t͈ t͡ɕ t͡ɕʰ t͡ɕ͈ t͡ʃ u v "
    "w wa we wi wʌ x y z ã ä æ ç ð õ ø ħ ĩ ŋ œ ũ ɐ ɑ ɒ ɓ ɔ ɔɪ ɕ ɖ ɗ ɘ ə ɚ ɛ ɜ ɝ ɟ ɡ ɣ ɤ ɥ ɦ ɨ ɪ ɪə ɫ ɮ ɯ ɯi ɰ ɱ ɲ "
    "ɴ ɵ ɸ ɹ ɻ ɽ ɾ ʀ ʁ ʂ ʃ ʈ ʉ ʊ ʋ ʌ ʎ ʏ ʐ ʑ ʒ ʔ ʙ ʝ β θ χ ẽ"
)
HEADAUDIO = "aa E I O U PP SS TH DD FF kk nn RR CH sil"


def found(class_of, names: str) -> dict[str, str]:
    classes = {name: class_of(name) for name in names.split()}
    assert [name for name, known in classes.items() if known is None] == []
    return {name: known.phoneme.label for name, known in classes.items()}


def test_every_phone_of_pocketsphinx_stands_for_a_class_or_silence():
    classes = found(arpabet_class, POCKETSPHINX)
    assert set(classes.values()) == set(PHONEMES_BY_LABEL)
    some = {name: classes[name] for name in ("SIL", "+NSN+", "+SPN+", "M", "P", "CH", "IY", "OW", "NG")}
    assert list(some.values()) == ["silence", "silence", "unidentified", "m", "p", "sch", "i", "o", "unidentified"]


def test_every_sound_of_hama_stands_for_a_class():
    classes = found(ipa_token_class, HAMA)
    assert set(classes.values()) == set(PHONEMES_BY_LABEL) - {"silence"}
    some = {name: classes[name] for name in ("wa", "ju", "t͡ɕ͈", "pʰ", "s͈", "ɚ", "ŋ")}
    assert list(some.values()) == ["a", "u", "sch", "p", "sz", "e", "unidentified"]


@pytest.mark.parametrize("token", ["<blank>", "<wb>", "<unk>", "ː", "˥", "̃", "一", ","])
def test_what_is_no_sound_of_its_own_stands_for_nothing(token: str):
    assert ipa_token_class(token) is None


def test_every_viseme_of_headaudio_stands_for_a_phoneme_of_its_mouth_shape():
    assert set(found(viseme_class, HEADAUDIO)) == set(VISEMES)
    assert found(viseme_class, "sil aa PP kk")["kk"] == "unidentified"


def test_answers_become_frames_with_silence_between_them_and_the_closure_of_affricates():
    marks = [(0.0, 0.02, "AA"), (0.03, 0.07, "CH")]
    names = ["a", "a", "silence", "unidentified", "unidentified", "sch", "sch"]
    assert [Phoneme(code).label for code in frames_of(marks, arpabet_class)] == names


def test_a_mark_that_is_no_sound_prolongs_the_one_before_it_up_to_the_longest():
    marks = [(0.0, 0.02, "a"), (0.02, 0.06, "ː"), (0.06, 0.07, "m")]
    a, m, silence = Phoneme.A, Phoneme.M, Phoneme.SILENCE
    assert frames_of(marks, ipa_token_class).tolist() == [a] * 6 + [m]
    assert frames_of(marks, ipa_token_class, 0.03).tolist() == [a] * 3 + [silence] * 3 + [m]


def labelled(codes: list[Phoneme]) -> FrameLabels:
    n = len(codes)
    return FrameLabels(np.array(codes, np.uint8), np.ones(n, bool), np.full(n, NO_VISEME, np.uint8))


@pytest.mark.parametrize("late", [-4, 0, 7])
def test_the_delay_that_scores_best_is_the_one_by_which_the_answers_are_late(late: int):
    said = [Phoneme.SILENCE] * 20 + [Phoneme.A] * 9 + [Phoneme.M] * 6 + [Phoneme.I] * 11 + [Phoneme.SILENCE] * 20
    labels = [labelled(said), labelled(said[::-1])]
    answers = [np.roll(truth.phonemes, late) for truth in labels]
    assert best_delay(labels, answers, lambda scores: scores.accuracy) == (late, 1.0)
    assert all(np.array_equal(a, t.phonemes) for a, t in zip(delayed(labels, answers, late), labels, strict=True))


def test_a_recogniser_that_cannot_be_installed_says_why(tmp_path):
    (tmp_path / "python").write_text("no folder")
    peer = next(peer for peer in PEERS if not peer.of_npm)
    assert isinstance(peer, Peer)
    with pytest.raises(PeerError, match="python"):
        Workshop(tmp_path).answers_of(peer, tmp_path / "sounds.json")


@pytest.mark.parametrize(
    ("seconds", "chosen"), [(0.5, ""), (3.0, "a1 b1 c1"), (5.5, "a1 a2 b1 c1 c2"), (60.0, "all")]
)
def test_all_speakers_are_compared_by_turns_as_long_as_is_asked(seconds: float, chosen: str):
    said = (Label(0.0, 1.0, "a", Phoneme.A),)
    names = ["a1", "a2", "a3", "b1", "c1", "c2"]
    recordings = [LabelledUtterance(Path(name), said, speaker=name[0], corpus="some") for name in names]
    found = [str(recording.path) for recording in first_of_each(recordings, seconds / 60)]
    assert found == (names if chosen == "all" else chosen.split())
