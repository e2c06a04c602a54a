"""The makers of training speech: tables of phones, phone times, labels."""

from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

from tools.voices.classes import CLASSES, VOWELS, Phone, table_of
from tools.voices.english_phones import ENGLISH
from tools.voices.indian import INDIAN
from tools.voices.labels import Segment, labels_of, segments_from_ends
from tools.voices.openjtalk import JAPANESE, LABIAL
from tools.voices.rhvoice import ESPERANTO, KYRGYZ, PORTUGUESE, RUSSIAN, UKRAINIAN
from tools.voices.texts import is_plain
from tools.voices.writing import Speaker, Utterance, UtteranceWriter, read_manifest, replace_speaker

SAMPLE_RATE = 44100
TABLES = {
    "English": ENGLISH,
    "Russian": RUSSIAN,
    "Ukrainian": UKRAINIAN,
    "Kyrgyz": KYRGYZ,
    "Brazilian Portuguese": PORTUGUESE,
    "Esperanto": ESPERANTO,
    "Japanese": JAPANESE,
    "Hindi, Marathi, Telugu": INDIAN,
}
# What the synthesizers name: RHVoice's phonemes.xml, Open JTalk's label list, the Festival phone set.
NAMED = {
    "English": (
        "aa ae ah ao aw ax ay b ch d dh eh er ey f g hh ih iy jh k l m n ng ow oy p r s sh t th uh uw v w y z zh pau"
    ),
    "Russian": (
        "a e i o y u a0 e0 i0 y0 u0 b bb c ch d dd f ff g gg h hh j k kk l ll m mm n nn p pau pp r rr s "
        "sch sh ss t tt v vv z zh zz"
    ),
    "Ukrainian": (
        "ii i e a o u m mj n nj p pj b bj t tj d dj k kj g gj ts tsj dz dzj tsh tshj dzh dzhj f fj s sj "
        "z zj sh shj zh zhj h hj gh ghj w wj l lj j r rj pau"
    ),
    "Kyrgyz": "a aa e ee i y o oo of oof u uu uf uuf b d g p t k v z zh f s sh sch h dzh c ch m n ng l r j pau",
    "Brazilian Portuguese": (
        "a an ee e en i in oo o on u un b d g p t k v z zh f s sh dj tj m n nj l lj r rh j jn w wn pau"
    ),
    "Esperanto": "a e i o u b d g p t k v z zh f s sh hh h j c ch m n l r y w pau",
    "Japanese": (
        "a i u e o A I U E O N cl pau sil k ky kw g gy gw s sh z j t ty ts ch d dy n ny h hy f b by p py "
        "m my r ry w y v"
    ),
    "Hindi, Marathi, Telugu": (
        "a aa ih iy uh uw eh ee ay oh oo aw f k g ch T D N th dh n p b m y r l v L R s sh j h ksh sri x "
        "kh gh td tth ddh bh zh @ pau w"
    ),
}


@pytest.mark.parametrize("language", TABLES)
def test_every_phone_that_a_synthesizer_names_has_a_class(language: str) -> None:
    table = TABLES[language]
    assert set(NAMED[language].split()) <= set(table)
    assert {phone.class_name for phone in table.values()} <= set(CLASSES)


@pytest.mark.parametrize("language", TABLES)
def test_every_language_has_the_sounds_that_the_mouth_shows(language: str) -> None:
    sure = {phone.class_name for phone in TABLES[language].values() if phone.certainty == "core"}
    assert {"silence", "sz", "m", "p", "a", "i", "u"} <= sure
    assert set(VOWELS) <= {phone.class_name for phone in TABLES[language].values()}


def test_a_phone_in_two_rows_is_refused() -> None:
    with pytest.raises(ValueError, match="s stands twice"):
        table_of(("s", "sz", "core", "s z"), ("ʃ", "sch", "core", "s"))


def test_a_nasal_is_said_as_m_before_lips_that_close() -> None:
    openjtalk = pytest.importorskip("tools.voices.openjtalk")
    segments = segments_from_ends([("N", 0.1), ("p", 0.2), ("a", 0.3), ("N", 0.4), ("k", 0.5)])
    phones = [segment.phone for segment in openjtalk.with_labial_nasals(segments)]
    assert phones == ["N_m", "p", "a", "N", "k"]
    assert JAPANESE["N_m"] == Phone("m", "m", "ambiguous")
    assert "py" in LABIAL


def test_durations_printed_by_flite_become_segments_that_meet() -> None:
    flite = pytest.importorskip("tools.voices.flite")
    segments = flite.segments_printed("pau:0.254 hh:0.296 ax:0.341 \n")
    assert segments == [Segment(0.0, 0.254, "pau"), Segment(0.254, 0.296, "hh"), Segment(0.296, 0.341, "ax")]


def test_a_label_file_of_festival_becomes_segments_that_meet() -> None:
    indian = pytest.importorskip("tools.voices.indian")
    segments = indian.segments_saved("#\n0.2800 100 pau\n0.3266 100 y\n")
    assert segments == [Segment(0.0, 0.28, "pau"), Segment(0.28, 0.3266, "y")]


@pytest.mark.parametrize("shift", [-0.009, 0.0, 0.02])
def test_labels_cover_the_sound_without_gaps_wherever_they_are_shifted(shift: float) -> None:
    sound = np.random.default_rng(1).normal(0, 0.1, SAMPLE_RATE)
    segments = segments_from_ends([("pau", 0.2), ("ch", 0.4), ("aa", 0.4), ("m", 0.7), ("iy", 0.95)])
    labels = labels_of(segments, ENGLISH, sound, SAMPLE_RATE, shift)
    assert labels[0].start == 0
    assert labels[-1].end == pytest.approx(1.0)
    assert all(before.end == after.start for before, after in pairwise(labels))
    assert [label.phone for label in labels] == ["pau", "ch_cl", "ch_fr", "m", "iy", "pau"]


def test_labels_beyond_the_sound_are_cut_at_its_end() -> None:
    labels = labels_of(segments_from_ends([("aa", 0.5), ("m", 2.0)]), ENGLISH, np.zeros(SAMPLE_RATE), SAMPLE_RATE)
    assert [(label.start, label.end) for label in labels] == [(0.0, 0.5), (0.5, 1.0)]


def test_friction_begins_where_the_noise_begins() -> None:
    time = np.arange(SAMPLE_RATE) / SAMPLE_RATE
    noise = np.random.default_rng(1).normal(0, 0.3, SAMPLE_RATE)
    sound = np.where(time >= 0.56, noise, 0)
    labels = labels_of(segments_from_ends([("pau", 0.5), ("ch", 0.62), ("pau", 1.0)]), ENGLISH, sound, SAMPLE_RATE)
    assert labels[1].phone == "ch_cl"
    assert labels[1].end == pytest.approx(0.56, abs=0.003)


def test_the_manifest_keeps_the_other_speakers_when_one_is_made_anew(tmp_path: Path) -> None:
    for name, text in (("bdl", "old"), ("clb", "kept"), ("bdl", "new")):
        speaker = Speaker("rhvoice", name, "en-US", "male", "synthetic-hts", "free", "none", "radio")
        writer = UtteranceWriter(tmp_path, speaker, ENGLISH)
        segments = segments_from_ends([("pau", 0.1), ("aa", 0.3)])
        writer.write(Utterance(np.zeros(4800), 16000, segments, text))
        replace_speaker(tmp_path, speaker, writer.rows)
    rows = read_manifest(tmp_path)
    assert [(row[1], row[-1]) for row in rows] == [("bdl", "new"), ("clb", "kept")]
    assert all((tmp_path / row[5]).exists() and (tmp_path / row[6]).exists() for row in rows)


@pytest.mark.parametrize(
    ("sentence", "plain"),
    [
        ("Привет, это проверка голоса на русском языке.", True),
        ("Слишком мало.", False),
        ("Это предложение содержит число 42 и потому негодно.", False),
        ("Это предложение содержит the word и потому негодно.", False),
        ("Это предложение содержит СССР и потому негодно.", False),
    ],
)
def test_a_sentence_is_spoken_if_it_is_whole_and_of_ordinary_words(sentence: str, plain: bool) -> None:
    assert is_plain(sentence, "ru") == plain
