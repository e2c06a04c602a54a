"""Mouths that know phones: what ten sounds hide is shown, and what they tell stays as it is."""

import re
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from phonemeengine.errors import ExportError, MouthError
from phonemeengine.labels.phone_sets import IPA_LETTERS, phone_classes_in
from phonemeengine.labels.utterance import Phone, Syllable, Utterance, Word
from phonemeengine.labels.visemes import VISEME_PHONES, Viseme
from phonemeengine.mouth.animation import animation_of
from phonemeengine.mouth.cues import MINIMUM, MOST_ANTICIPATION, Cue, cues_of
from phonemeengine.mouth.exports.exporter import Exporter, ExportOptions
from phonemeengine.mouth.morpher import Detail, Morpher
from phonemeengine.mouth.performer import MOUTH_ALONE, IdleMotion, Performer, TimedFrame
from phonemeengine.mouth.table import TABLES, MouthTable, TransitionTimes, load_table, shipped_tables, table_of
from phonemeengine.mouth.transcript import Transcript, transcript_of_utterance
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import FRAME_PERIOD
from tests.engine.mouth.speaking import phones_said, speech

ARKIT = load_table("arkit")
VRM = (TABLES / "vrm.toml").read_text(encoding="utf-8")
NO_PHONES = re.sub(r"\[phones\][^\[]*", "", VRM)
STILL = replace(ARKIT, motion=replace(ARKIT.motion, randomness=0.0))
RATE = 100.0


def naming(*entries: str) -> MouthTable:
    """A table of five vowels that has these entries of phones."""
    return table_of(NO_PHONES.replace("[times]", "\n".join(("[phones]", *entries, "[times]")), 1))


def shape(table: MouthTable, phone: str) -> str:
    """The shape that a table has for a phone, as one of the phoneme it counts as."""
    phone_class = phone_classes_in(phone)[1]
    assert phone_class is not None
    return table.shape_of(phone_class.phoneme, phone)


def shapes_in(said: Transcript, table: MouthTable, **options: float) -> list[str]:
    return [cue.shape for cue in cues_of(said.runs, table, **options)]


def shown(said: Transcript, table: MouthTable, movestate: str, detail: Detail = Detail.PHONEMES) -> np.ndarray:
    """How far a movestate is on in each hundredth of a second of a film."""
    film = animation_of(said, table, RATE, IdleMotion(blinks=False, head=False, detail=detail))
    return film.weights[:, table.movestates.index(movestate)]


# -- tables -----------------------------------------------------------------------------------------------


def test_the_narrowest_entry_counts_and_where_there_is_none_the_phoneme() -> None:
    table = naming('consonant = "I"', 'labiodental = "U"', '"v" = "O"')
    assert [shape(table, phone) for phone in ("v", "f", "k", "a")] == ["O", "U", "I", "A"]


def test_a_letter_means_its_sound_whatever_marks_the_phone_wears() -> None:
    table = naming('t = "I"', 'g = "O"', '"open vowel" = "E"')
    assert {shape(table, phone) for phone in ("t", "tʰ", "tʲ")} == {"I"}
    assert {shape(table, phone) for phone in ("g", "ɡ")} == {"O"}
    assert {shape(table, phone) for phone in ("ɑː", "ɑ̃")} == {"E"}


def test_times_and_firmness_are_those_of_the_phone_and_else_of_the_phoneme() -> None:
    table = naming('labiodental = { shape = "U", attack = 0.03, release = 0.2, firm = true }', 'v = "O"')
    assert table.times_of(Phoneme.UNIDENTIFIED, "f") == TransitionTimes(0.03, 0.2)
    assert table.times_of(Phoneme.UNIDENTIFIED, "v") == TransitionTimes(0.03, 0.2)
    assert table.times_of(Phoneme.UNIDENTIFIED, "k") == table.times[Phoneme.UNIDENTIFIED]
    assert [table.closes(Phoneme.UNIDENTIFIED, phone) for phone in ("f", "v", "")] == [True, False, False]
    assert table.closes(Phoneme.P, "p")
    slow = table.with_motion(2.0, 0.5, random=True)
    assert slow.times_of(Phoneme.UNIDENTIFIED, "f") == TransitionTimes(0.06, 0.1)


@pytest.mark.parametrize(
    ("entry", "said"),
    [
        (
            'th = "U"',
            r"\[phones\] knows no sound 'th'; name a letter of the IPA without marks, or a class: labiovelar",
        ),
        ('"tʃ" = "U"', r"\[phones\] knows no sound 'tʃ'"),
        ('"ã" = "U"', r"\[phones\] knows no sound 'ã'"),
        ('labial = "U"', r"\[phones\] knows no sound 'labial'"),
        ('"" = "U"', r"\[phones\] knows no sound ''"),
        ('f = "FF"', r"\[phones\] f has the shape 'FF', which \[shapes\] lacks; add it there"),
        ("f = 5", r"\[phones\] f has the shape 5, which \[shapes\] lacks"),
        ("f = { firm = true }", r"\[phones.f\] lacks shape; add it"),
        ('f = { shape = "U", speed = 1 }', r"\[phones.f\] cannot have an entry 'speed'; did you mean shape"),
        ('f = { shape = "U", firm = 1 }', r"\[phones.f\] firm must be true or false, found 1"),
        ('f = { shape = "U", attack = 0.1 }', r"\[phones.f\] gives attack alone; give attack and release, or none"),
        ('f = { shape = "U", attack = 0, release = 1 }', r"\[phones.f\] attack must be a number of seconds in 0.005"),
        ('g = "U"\n"ɡ" = "I"', r"\[phones\] says twice what ɡ is; remove one"),
    ],
)
def test_what_an_entry_cannot_mean_is_refused_in_one_sentence(entry: str, said: str) -> None:
    with pytest.raises(MouthError, match=said) as refusal:
        naming(entry)
    assert str(refusal.value).isprintable()


@pytest.mark.parametrize("name", shipped_tables())
def test_lips_meet_for_p_b_and_m_and_for_nothing_else_in_every_shipped_table(name: str) -> None:
    table = load_table(name)
    closed = {table.phonemes[phoneme] for phoneme in table.closed_phonemes}
    labials = {phone for phone in IPA_LETTERS if shape(table, phone) in closed | {table.phonemes[Phoneme.SILENCE]}}
    assert {"p", "b", "m"} - {"b" if name == "annosoft" else ""} <= labials <= {"p", "b", "m", "ɱ", "ɓ"}
    assert (table.shape_weights() >= 0).all()
    assert (table.shape_weights() <= 1).all()


@pytest.mark.parametrize(
    ("name", "phones"),
    [
        (
            "oculus",
            "f FF  v FF  θ TH  ð TH  t dd  d dd  k kk  ɡ kk  ŋ kk  n nn  l nn  ɹ RR  r RR  ʃ CH  s SS  w ou  j ih",
        ),
        ("rhubarb", "f G  v G  l H  w F  ɹ E  ɝ E  j B  k B  θ B  ʃ B  m A  æ C  ʌ C  ɔ E  y F"),
        ("preston-blair", "f FV  v FV  l L  w WQ  θ etc  n etc  k etc  ɹ etc  æ AI  i E  y U"),
        ("annosoft", "f f  v v  θ TH  ð DH  ŋ NG  ʒ ZH  h h  j y  w w  l l  ɹ r  b b  æ AE  ʊ UH  ɝ ER  ʌ AH"),
        (
            "azure",
            "f 18  θ 17  t 19  n 19  l 14  ɹ 13  ŋ 20  h 12  w 7  j 6  æ 1  ə 1  ʌ 1  ɝ 5  ɔ 3  ɛ 4  ʊ 4  b 21",
        ),
        (
            "polly",
            "f f  v f  θ T  t t  l t  ɹ r  ŋ k  h k  w u  j i  æ a  ə @  ʌ E  e e  ɛ E  o o  ɔ O  ʃ S  b p  ç k",
        ),
        ("arkit", "f f  v f  θ th  ð th  t d  n d  l l  ɹ r  w w  k k  ʁ k  j i  ɕ sz  ʂ sch  y u  ə schwa"),
        ("vrm", "f teeth  w U  j I"),
        ("five", "w round  j wide  f slightly_open"),
    ],
)
def test_shipped_tables_have_the_shapes_that_these_programs_define(name: str, phones: str) -> None:
    table, words = load_table(name), phones.replace("_", " ").split("  ")
    pairs = [word.split(" ", 1) for word in words]
    assert [(phone, shape(table, phone)) for phone, _ in pairs] == [(phone, wanted) for phone, wanted in pairs]


def test_shapes_of_phones_are_made_as_a_phonetician_says() -> None:
    """f has the lower lip at the upper teeth, th the tongue between them; l shows it too; w is rounder than r."""
    on = {
        name: dict(zip(ARKIT.movestates, row, strict=True))
        for name, row in zip(ARKIT.shapes, ARKIT.shape_weights().tolist(), strict=True)
    }
    assert on["f"]["mouthRollLower"] > 0.5
    assert on["f"]["mouthUpperUpLeft"] == on["f"]["mouthUpperUpRight"] > 0.5
    assert on["f"]["jawOpen"] < 0.1
    assert on["th"]["tongueOut"] > on["l"]["tongueOut"] > 0.2
    assert on["w"]["mouthPucker"] > on["r"]["mouthPucker"] > 0.3
    assert on["w"]["jawOpen"] < on["u"]["jawOpen"]
    assert on["a"]["jawOpen"] > on["æ"]["jawOpen"] > on["e"]["jawOpen"]


# -- what is known becomes a transcript -------------------------------------------------------------------


def test_what_lies_between_phones_is_silence_and_runs_cover_the_sound() -> None:
    said = phones_said(("f", 0.1), ("iː", 0.2))
    assert [(run.start, run.end, run.phoneme, run.phone) for run in said.runs] == [
        (0.0, 0.3, Phoneme.SILENCE, ""),
        (0.3, 0.4, Phoneme.UNIDENTIFIED, "f"),
        (0.4, 0.6, Phoneme.I, "iː"),
        (0.6, 0.9, Phoneme.SILENCE, ""),
    ]
    assert said.runs[1].intensity == pytest.approx(0.7)
    assert [run.phone if run else None for run in map(said.run_at, (0.0, 0.35, 0.4, 0.9))] == ["", "f", "iː", None]


@pytest.mark.parametrize(
    ("phone", "sounds"),
    [
        ("aʊ", [("a", Phoneme.A, 0.6), ("ʊ", Phoneme.U, 0.4)]),
        ("tʃ", [("t", Phoneme.UNIDENTIFIED, 0.45), ("ʃ", Phoneme.SCH, 0.55)]),
        ("pf", [("p", Phoneme.P, 0.45), ("f", Phoneme.UNIDENTIFIED, 0.55)]),
    ],
)
def test_a_phone_of_two_sounds_is_one_after_the_other(phone: str, sounds: list[tuple[str, Phoneme, float]]) -> None:
    runs = phones_said((phone, 1.0)).runs[1:-1]
    assert [(run.phone, run.phoneme, pytest.approx(run.end - run.start)) for run in runs] == sounds


def test_a_phone_of_which_only_the_phoneme_is_known_is_shown_as_that() -> None:
    word = Word("?", (Syllable((Phone(0.0, 0.5, "", Phoneme.A), Phone(0.5, 0.6, "sil", Phoneme.SILENCE))),))
    said = transcript_of_utterance(Utterance((word,), 1.0), np.zeros(0, np.float32), np.zeros(0, np.float32), "x")
    assert [(run.phoneme, run.phone) for run in said.runs] == [
        (Phoneme.A, ""),
        (Phoneme.SILENCE, ""),
        (Phoneme.SILENCE, ""),
    ]
    assert shapes_in(said, ARKIT) == ["a", "silence"]


# -- cues, films, exports ---------------------------------------------------------------------------------


def test_neighbours_of_one_phoneme_are_two_cues_where_they_look_different() -> None:
    said = phones_said(("f", 0.1), ("l", 0.1), ("t", 0.1), ("n", 0.1), ("a", 0.2))
    assert shapes_in(said, ARKIT) == ["silence", "f", "l", "d", "a", "silence"]
    assert shapes_in(said, load_table("eleven")) == ["silence", "unidentified", "a", "silence"]


def test_a_brief_lip_at_the_teeth_takes_the_time_that_it_lacks_and_a_brief_k_gives_its_own() -> None:
    for phone, seen in (("v", True), ("θ", True), ("w", True), ("k", False)):
        cues = cues_of(phones_said(("a", 0.2), (phone, 0.03), ("i", 0.2)).runs, ARKIT)
        found = [cue for cue in cues if cue.phone == phone]
        assert [cue.duration for cue in found] == ([pytest.approx(MINIMUM)] if seen else []), phone


def test_lips_are_at_the_teeth_when_f_is_heard_however_quiet_it_is() -> None:
    said = phones_said(("a", 0.3), ("f", 0.12), ("a", 0.3), loudness=0.05)
    rolled = shown(said, ARKIT, "mouthRollLower")
    whole = ARKIT.shapes["f"]["mouthRollLower"] / 100
    assert rolled[round(0.6 * RATE)] == pytest.approx(whole, abs=0.1 * whole)
    assert rolled[round(0.65 * RATE)] == pytest.approx(whole, abs=1e-3)


def test_each_of_f_th_l_and_w_moves_what_the_others_do_not() -> None:
    def most(phone: str, movestate: str) -> float:
        return float(shown(phones_said(("a", 0.2), (phone, 0.2), ("a", 0.2)), STILL, movestate).max())

    assert most("f", "mouthRollLower") > 0.5 > most("θ", "mouthRollLower")
    assert most("θ", "tongueOut") > most("l", "tongueOut") > 0.1 > most("f", "tongueOut")
    assert most("w", "mouthPucker") > 0.9 > most("l", "mouthPucker")


@pytest.mark.parametrize("phone", ["t", "d", "k", "n"])
def test_t_d_k_and_n_leave_the_lips_open_in_a_file(phone: str) -> None:
    def least_gap(phone: str) -> float:
        said = phones_said(("a", 0.3), (phone, 0.15), ("a", 0.3))
        return float((shown(said, STILL, "mouthUpperUpLeft") + shown(said, STILL, "mouthLowerDownLeft"))[50:85].min())

    assert least_gap(phone) > 0.2
    assert least_gap("m") == least_gap("p") == pytest.approx(0.0, abs=1e-3)


@pytest.mark.parametrize("viseme", ["DD", "KK", "NN"])
def test_t_d_k_and_n_leave_the_lips_open_when_they_are_heard_live(viseme: str) -> None:
    """As of a recogniser that sees them apart, and of one that only knows that they are none of ten sounds."""
    lips = [STILL.movestates.index(f"mouth{lip}Left") for lip in ("UpperUp", "LowerDown")]
    for phone in (VISEME_PHONES[Viseme[viseme]], ""):
        mouth = Morpher(STILL)
        mouth.add(0.0, Phoneme.A, 0.5)
        mouth.add(0.3, Phoneme.UNIDENTIFIED, 0.5, phone)
        mouth.add(0.45, Phoneme.A, 0.5)
        assert min(mouth.weights(0.25 + k / 200)[lips].sum() for k in range(60)) > 0.2


@pytest.mark.parametrize("detail", [Detail.LOUDNESS, Detail.TWO_STATES])
def test_far_characters_follow_no_phones(detail: Detail) -> None:
    said = phones_said(("f", 0.2), ("l", 0.2))
    assert shown(said, ARKIT, "mouthRollLower", detail).max() == 0.0
    assert shown(said, ARKIT, "jawOpen", detail).max() > 0.1


@pytest.mark.parametrize(
    ("form", "line"),
    [
        ("rhubarb-tsv", "\tG"),
        ("rhubarb-tsv", "\tH"),
        ("moho-dat", " FV"),
        ("papagayo-pgo", " L"),
        ("anno", " TH"),
        ("textgrid", '"f"'),
        ("curves-json", '"shape": "th", "intensity": 0.7, "phone": "θ"'),
        ("audacity", "\tu"),
    ],
)
def test_files_hold_the_shapes_of_phones(form: str, line: str) -> None:
    said = phones_said(("f", 0.15), ("ɛ", 0.15), ("l", 0.15), ("ə", 0.15), ("θ", 0.15), ("w", 0.15))
    options = ExportOptions(table="arkit" if form == "textgrid" else None)
    text = b"".join(Exporter(form, options).chunks_of(said)).decode()
    assert any(line in row for row in text.splitlines())


def test_the_weights_of_oculus_are_its_true_visemes() -> None:
    said = phones_said(("f", 0.3), ("θ", 0.3), ("k", 0.3), ("ɹ", 0.3), ("n", 0.3), ("t", 0.3))
    for viseme in ("FF", "TH", "kk", "RR", "nn", "DD"):
        assert shown(said, load_table("oculus"), viseme).max() > 0.5


def test_a_shape_of_a_phone_that_a_format_does_not_know_is_refused(tmp_path: Path) -> None:
    text = (TABLES / "rhubarb.toml").read_text(encoding="utf-8").replace('lateral = "H"', 'lateral = "L"')
    (tmp_path / "mine.toml").write_text(text + "[shapes.L]\n", encoding="utf-8")
    with pytest.raises(ExportError, match=r"knows the shapes A, B, .* but the table 'Rhubarb A-H, X' has 'L'"):
        Exporter("rhubarb-tsv", ExportOptions(table=tmp_path / "mine.toml"))


# -- live -------------------------------------------------------------------------------------------------


def frames_of(said: Transcript) -> Iterator[TimedFrame]:
    for time, loud in zip(said.times.tolist(), said.intensities.tolist(), strict=True):
        run = said.run_at(time + 1e-9)
        assert run is not None
        yield TimedFrame(time, run.phoneme, loud, phone=run.phone)


def test_a_performer_that_hears_phones_moves_as_the_film_does() -> None:
    said = phones_said(
        ("f", 0.1), ("aʊ", 0.2), ("l", 0.1), ("ð", 0.1), ("w", 0.03), ("ə", 0.1), ("t", 0.1), ("n", 0.1)
    )
    film = animation_of(said, ARKIT, RATE, MOUTH_ALONE)
    performer = Performer(ARKIT, MOUTH_ALONE, rate=RATE)
    performer.add(list(frames_of(said)))
    faces = np.array([performer.at(time).weights for time in film.times.tolist()])
    np.testing.assert_allclose(faces, film.weights, atol=1e-5)


def test_a_performer_tells_the_phone_that_it_says_and_holds_it_in_a_pause() -> None:
    performer = Performer(STILL, MOUTH_ALONE)
    performer.add([TimedFrame(k * FRAME_PERIOD, Phoneme.UNIDENTIFIED, 1.0, phone="kf"[k >= 20]) for k in range(40)])
    performer.at(0.39)
    assert [phone for _, _, phone in performer.pop_said()] == ["k", "f", "f"]
    performer.hold(0.4, Phoneme.UNIDENTIFIED, "f")
    held = performer.at(2.0).weights[ARKIT.movestates.index("mouthRollLower")]
    assert held == pytest.approx(ARKIT.shapes["f"]["mouthRollLower"] / 100)


def test_a_morpher_is_told_phones_as_they_come() -> None:
    morpher = Morpher(STILL)
    morpher.add(0.0, Phoneme.UNIDENTIFIED, 1.0, "l")
    expected = STILL.shape_weights()[list(STILL.shapes).index("l")]
    np.testing.assert_allclose(morpher.weights(1.0), expected, atol=1e-6)


# -- and where nothing more is known, nothing is new ------------------------------------------------------


def without_phones(table: MouthTable) -> MouthTable:
    return replace(table, phones={}, phone_times={}, closed_phones=frozenset())


def by_hand(cues: tuple[Cue, ...]) -> list[tuple[object, ...]]:
    return [(cue.start, cue.end, cue.phoneme, cue.shape, cue.intensity, cue.phone) for cue in cues]


@pytest.mark.parametrize("name", shipped_tables())
@pytest.mark.parametrize("detail", Detail)
def test_where_only_phonemes_are_known_phones_change_no_bit(name: str, detail: Detail) -> None:
    table, said = load_table(name), speech()
    other = without_phones(table)
    idle = IdleMotion(seed=3, detail=detail)
    cues, before = (cues_of(said.runs, one, anticipation=MOST_ANTICIPATION) for one in (table, other))
    assert by_hand(cues) == by_hand(before)
    films = [animation_of(said, one, 60.0, idle).weights for one in (table, other)]
    np.testing.assert_array_equal(*films)
    live = [Performer(one, idle) for one in (table, other)]
    for performer in live:
        performer.add(list(frames_of(said)), 0.0)
    np.testing.assert_array_equal(*([one.at(k / 60).weights for k in range(150)] for one in live))
