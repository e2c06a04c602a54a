"""Texts that a voice speaks, by which voice and which lexicon."""

import shlex
import socket
import sys
from pathlib import Path

import pytest
import soundfile

from phonemeanalyser.desktop.session.preset import PresetDocument
from phonemeanalyser.desktop.session.sources import SourceKind
from phonemeanalyser.desktop.talk.drivers.driver_model import OTHER_PRESET
from phonemeanalyser.desktop.talk.words.sound_words import KnownWords
from phonemeanalyser.desktop.talk.words.spoken_lanes import lanes_of
from phonemeanalyser.desktop.talk.words.text_model import TextTools
from phonemeanalyser.desktop.talk.words.voice_model import FASTEST, VoiceModel
from phonemeengine.errors import VoiceError
from phonemeengine.labels.files import read_labels
from phonemeengine.labels.utterance import LabelUnit, Phone, Syllable, Utterance, Word, spans_of
from phonemeengine.labels.utterance_files import format_utterance
from phonemeengine.mouth.animation import FaceDriver
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import THESIS_PRESET
from tests.desktop.sessions import settled
from tests.desktop.stage import AN_A
from tests.desktop.talk.desk import DURATION, SAID, Desk
from tests.desktop.talk.voices import SENTENCE, syllable

# -- a voice ------------------------------------------------------------------------------------------


def test_a_voice_is_a_source_like_a_file(desk):
    desk.say("Hello. You there.")
    assert desk.session.source.kind is SourceKind.TEXT
    assert desk.session.source.playing
    assert desk.voice.asked == [("Hello. You there.", "en-us")]
    desk.stage.play(10)
    assert desk.stage.said_an_a
    assert desk.session.source.duration == pytest.approx(2 * SENTENCE)


def test_what_a_voice_says_is_known_with_its_times(desk):
    desk.stage.look()
    desk.say("Hello. You there.")
    desk.stage.play(10)
    assert desk.words() == ["Hello", "You there"]
    assert spans_of(desk.texts.utterance, LabelUnit.WORD)[1] == pytest.approx((0.6, 0.9))
    assert not desk.texts.editable


def test_what_is_typed_meanwhile_is_none_of_what_the_voice_says(desk):
    texts, felt = desk.texts, desk.stage.talking.felt_text
    desk.say("Hello. [smile] You there.")
    texts.set_text("[anger] Never. [anger] Not now.")  # before the second sentence is spoken
    desk.stage.play(10)
    assert [span.words for span in felt.spans] == ["smile 1"]
    assert desk.stage.talking.in_use.texts == dict.fromkeys(desk.stage.talking.in_use.texts, texts.text_before)
    assert texts.stale.endswith("Speak again.")
    felt.insert(0.1, "fear")
    assert desk.failed == [texts.stale]
    texts.set_text("Hello. You there!")
    assert (texts.stale, felt.spans) == ("", ())


def test_the_head_says_what_the_voice_says(desk):
    desk.stage.look()
    jaws: list[float] = []
    desk.say("Hello. You there.")
    desk.stage.play(10, lambda: jaws.append(desk.stage.jaw))
    assert max(jaws) > 5


def test_the_head_shows_the_place_of_a_spoken_text_that_is_gone_to(desk):
    desk.stage.look()
    desk.say("Hello. You there.")
    desk.stage.play(0.62)
    desk.session.pause()
    jaws = []
    for place in (0.35, 0.49, 0.01):  # in the o, in the pause after the word, before it
        desk.session.seek(place)
        desk.stage.wait(0.05)
        jaws.append(desk.stage.jaw)
    assert jaws[0] > 5 > max(jaws[1:])


def test_a_second_preset_recognises_what_the_voice_says(desk):
    desk.stage.look()
    desk.session.preset.set_other(PresetDocument.read(THESIS_PRESET))
    desk.texts.drivers.compare(OTHER_PRESET)
    desk.say("Hello. You there.")
    desk.stage.play(0.1)
    comparison = desk.stage.talking.comparison
    desk.qtbot.waitUntil(lambda: comparison.known is not None)
    assert comparison.known.duration == pytest.approx(2 * SENTENCE)
    assert comparison.known.run_at(0.25).phoneme is Phoneme.A  # the text has it as an o
    assert comparison.found.rms > 0


def test_a_spoken_text_can_be_gone_through(desk):
    desk.say("Hello. You there.")
    desk.stage.play(0.8)
    desk.session.pause()
    desk.session.seek(0.2)
    settled(desk.session, desk.qtbot)
    assert desk.session.source.position == pytest.approx(0.2)
    desk.session.stop()
    settled(desk.session, desk.qtbot)
    assert desk.session.source.position == 0


def test_a_language_that_no_voice_speaks_is_refused_and_the_sound_in_hand_stays(desk, tmp_path):
    desk.open(tmp_path)
    desk.say("Hello.", "xx")
    assert "xx" in desk.failed[0]
    assert desk.session.source.kind is SourceKind.FILE


def test_choosing_the_text_as_source_has_it_said(desk, tmp_path):
    desk.open(tmp_path)
    desk.texts.set_text("Hello.")
    desk.texts.set_language("en-us")
    desk.session.set_source(SourceKind.TEXT)
    desk.qtbot.waitUntil(lambda: desk.session.source.playing)
    assert desk.voice.asked == [("Hello.", "en-us")]


def test_a_file_goes_on_from_where_it_was_left_before_a_text_was_spoken(desk, tmp_path):
    desk.open(tmp_path)
    desk.session.seek(0.5)
    settled(desk.session, desk.qtbot)
    desk.say("Hello.")
    desk.session.set_source(SourceKind.FILE)
    settled(desk.session, desk.qtbot)
    assert desk.session.source.position == pytest.approx(0.5)


def test_chinese_characters_tell_their_language(desk):
    desk.say("你好。", "")
    assert desk.voice.asked == [("你好。", "cmn")]


def test_the_voice_that_is_chosen_speaks_at_the_rate_that_is_chosen(desk):
    desk.texts.voice.choose(name="f2", rate=6.0)
    desk.say("Hello.")
    desk.texts.voice.choose(rate=100.0)
    desk.say("Hello.")
    assert [(choice.name, choice.rate) for choice in desk.voice.choices] == [("f2", 6.0), ("f2", FASTEST)]


def test_chinese_moves_the_mouth_by_letters_unless_sounds_are_chosen(desk, tmp_path):
    desk.open(tmp_path)
    desk.texts.words.put(KnownWords(Utterance((syllable("好", "hao3", 0.6, 1.1),), DURATION, "cmn")))
    drivers = (FaceDriver.AUTO, FaceDriver.RULES, FaceDriver.PINYIN)
    by_letters = []
    for driver in drivers:
        desk.texts.drivers.choose(driver)
        by_letters.append(desk.texts.drivers.letters is not None)
    assert by_letters == [True, False, True]
    assert desk.failed == []


def test_letters_of_pinyin_for_another_language_are_refused_and_its_sounds_move_the_mouth(desk, tmp_path):
    desk.open(tmp_path)
    desk.align()
    desk.texts.drivers.choose(FaceDriver.PINYIN)
    assert desk.texts.drivers.letters is None
    assert "pinyin" in desk.failed[0].lower()


def test_a_spoken_text_is_saved_as_a_sound_with_its_words_and_opened_again(desk, tmp_path):
    saved: list[str] = []
    desk.texts.speech_saved.connect(saved.append)
    desk.texts.set_text("Hello. You there.")
    desk.texts.set_language("en-us")
    desk.texts.save_speech(tmp_path / "spoken.wav")
    desk.wait()
    assert saved == [str(tmp_path / "spoken.wav")]
    assert desk.session.open(tmp_path / "spoken.wav")
    desk.wait()
    assert desk.session.source.duration == pytest.approx(2 * SENTENCE)
    assert desk.words() == ["Hello", "You there"]
    assert spans_of(desk.texts.utterance, LabelUnit.WORD)[1] == pytest.approx((0.6, 0.9), abs=1e-6)
    assert desk.texts.editable


def test_labels_of_others_beside_a_spoken_sound_stay(desk, tmp_path):
    diary = tmp_path / "spoken.TextGrid"
    diary.write_text("a diary")
    desk.texts.set_text("Hello. You there.")
    desk.texts.set_language("en-us")
    desk.texts.save_speech(tmp_path / "spoken.wav")
    desk.wait()
    assert desk.failed == [
        "spoken.TextGrid: this file exists beside the audio file and would be overwritten; choose another name "
        "for the audio file"
    ]
    assert diary.read_text() == "a diary"
    diary.unlink()
    for _ in range(2):
        desk.texts.save_speech(tmp_path / "spoken.wav")
        desk.wait()
    assert len(desk.failed) == 1


@pytest.mark.parametrize(
    ("language", "place"), [("xx", "spoken.wav"), ("en-us", "gone/spoken.wav"), ("en-us", "a.mp3")]
)
def test_a_text_that_cannot_be_saved_leaves_nothing_behind(desk, tmp_path, language, place):
    desk.texts.set_text("Hello.")
    desk.texts.set_language(language)
    desk.texts.save_speech(tmp_path / place)
    desk.wait()
    assert len(desk.failed) == 1
    assert [path for path in tmp_path.rglob("*") if path.is_file()] == []


def test_phonemes_of_a_spoken_text_are_saved_as_those_of_a_file_are(desk, tmp_path):
    desk.say("Hello. You there.")
    spoken = desk.session.source
    desk.session.writer.write(spoken.name, spoken.reopen, desk.session.preset.in_force, tmp_path / "spoken.csv")
    desk.qtbot.waitUntil(lambda: not desk.session.writer.busy)
    labels = read_labels(tmp_path / "spoken.csv")
    assert labels[-1].end == pytest.approx(2 * SENTENCE)
    assert Phoneme.A in {label.phoneme for label in labels}


# -- a program of one's own ---------------------------------------------------------------------------


def own_program(folder: Path, body: str) -> str:
    """Write a text-to-speech program; gives the command that runs it."""
    (folder / "program.py").write_text(f"import sys\nout, text = sys.argv[1:]\n{body}\n", encoding="utf-8")
    python, program = (shlex.quote(str(path)) for path in (sys.executable, folder / "program.py"))
    return f"{python} {program} {{output}} {{text}}"


def test_a_program_of_ones_own_speaks_with_the_words_that_it_writes(desk, tmp_path):
    soundfile.write(tmp_path / "voice.wav", AN_A, 44100)
    (tmp_path / "voice.TextGrid").write_text(format_utterance(SAID), encoding="utf-8")
    body = (
        f"import shutil\nshutil.copy({str(tmp_path / 'voice.wav')!r}, out)\n"
        f"shutil.copy({str(tmp_path / 'voice.TextGrid')!r}, out[:-4] + '.TextGrid')"
    )
    desk.texts.tools = TextTools(desk.aligner.align)
    desk.texts.voice.choose(program=own_program(tmp_path, body), by_program=True)
    desk.say("so oh")
    desk.stage.play(10)
    assert desk.failed == []
    assert desk.words() == ["so", "oh"]
    assert desk.stage.said_an_a


@pytest.mark.parametrize(
    ("body", "reason"), [("sys.exit('no licence')", "no licence"), ("pass", "wrote no sound file")]
)
def test_a_program_that_fails_is_told_in_a_sentence_and_the_sound_in_hand_stays(desk, tmp_path, body, reason):
    desk.open(tmp_path)
    desk.texts.tools = TextTools(desk.aligner.align)
    desk.texts.voice.choose(program=own_program(tmp_path, body), by_program=True)
    desk.say("so oh")
    assert reason in desk.failed[0]
    assert desk.session.source.kind is SourceKind.FILE


def test_the_program_ends_though_a_program_of_ones_own_speaks_for_ever(session, outputs, qtbot, tmp_path):
    desk = Desk(session, outputs, qtbot)
    server = socket.create_server(("127.0.0.1", 0))
    hangs = f"import socket; socket.create_connection({server.getsockname()}).recv(1)"
    desk.texts.tools = TextTools(desk.aligner.align)
    desk.texts.voice.choose(program=own_program(tmp_path, hangs), by_program=True)
    desk.texts.set_text("so oh")
    desk.texts.say()
    started, _ = server.accept()
    desk.stage.talking.close()
    started.close()
    server.close()


def test_a_command_without_a_place_for_the_sound_is_refused(desk):
    desk.texts.tools = TextTools(desk.aligner.align)
    desk.texts.voice.choose(program="my-voice", by_program=True)
    desk.say("so oh")
    assert "{output}" in desk.failed[0]


# -- what there is to choose --------------------------------------------------------------------------


def test_the_languages_are_learnt_once_and_of_several_tags_one_is_shown(desk):
    desk.texts.voice.wake()
    desk.texts.voice.wake()
    desk.wait()
    assert {language.tag for language in desk.texts.voice.installed.languages} == {"de", "en-gb", "en-us"}


def test_without_a_voice_a_sentence_says_what_is_missing(qtbot):
    def missing() -> tuple[()]:
        raise VoiceError("there is no voice; install it")

    voice = VoiceModel(missing)
    voice.wake()
    qtbot.waitUntil(lambda: bool(voice.lack))
    assert voice.lack == "there is no voice; install it"
    voice.close()


def test_a_lexicon_goes_before_the_voice_until_it_is_given_up(desk, tmp_path):
    (tmp_path / "mine.csv").write_text("word,ipa\nso,soʊ\n", encoding="utf-8")
    desk.open(tmp_path)
    desk.texts.set_lexicon(tmp_path / "mine.csv")
    desk.wait()
    desk.align()
    desk.texts.set_lexicon(None)
    desk.align()
    assert [asked.lexicon is not None for asked in desk.aligner.asked] == [True, False]


def test_a_voice_reads_by_the_lexicon_too(desk, tmp_path):
    (tmp_path / "mine.csv").write_text("word,ipa\nso,soʊ\n", encoding="utf-8")
    desk.texts.set_lexicon(tmp_path / "mine.csv")
    desk.wait()
    desk.texts.set_text("So.")
    desk.texts.set_language("en-gb")
    desk.texts.say()
    desk.wait()
    assert desk.voice.choices[-1].lexicon is not None


def test_a_lexicon_with_nonsense_is_refused(desk, tmp_path):
    (tmp_path / "mine.csv").write_text("nonsense\n", encoding="utf-8")
    desk.texts.set_lexicon(tmp_path / "mine.csv")
    desk.wait()
    assert "mine.csv" in desk.failed[0]
    assert desk.texts.lexicon_path is None


def test_syllables_are_named_with_their_stress() -> None:
    said = (Syllable((Phone(0.1 * k, 0.1 * k + 0.1, "a", Phoneme.A),), stress) for k, stress in enumerate((1, 0, 2)))
    lanes = lanes_of(Utterance((Word("aaa", tuple(said)),), 0.3), None, movable=False)
    assert list(lanes[1].texts) == ["ˈa", "a", "ˌa"]
