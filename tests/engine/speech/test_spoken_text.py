"""A text that is spoken to its end: sound, times, loudness and mouths, from one and the same call of the voice."""

from pathlib import Path

import numpy as np
import pytest

from phonemeengine import SoundReader, TextError, Voice, export_transcript, pinyin_track, spoken_text
from phonemeengine.labels.utterance_files import format_utterance, read_utterance
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import SAMPLE_RATE
from phonemeengine.speech.voice import SpokenSentence


def test_the_sound_in_the_file_is_as_long_as_what_is_said(tmp_path: Path) -> None:
    path = tmp_path / "a.wav"
    with path.open("xb") as file:
        said = spoken_text(Voice("de").speak("Ein Satz. Noch einer!"), language="de", sound=file, path=path)
    with SoundReader(path) as reader:
        assert reader.duration == pytest.approx(said.utterance.duration, abs=1e-4)
        samples = reader.read_mono()
    assert (said.transcript.name, said.transcript.path) == ("a.wav", path)
    for word in said.utterance.words:
        assert np.abs(samples[round(word.start * SAMPLE_RATE) : round(word.end * SAMPLE_RATE)]).max() > 0.05


def test_the_loudness_is_that_of_the_sound() -> None:
    said = spoken_text(Voice("en-us").speak("Yes. No."))
    transcript, (yes, no) = said.transcript, said.utterance.words
    between = (transcript.times > yes.end + 0.1) & (transcript.times < no.start - 0.1)
    spoken = (transcript.times > no.start) & (transcript.times < no.end)
    assert transcript.intensities[between].max() < 0.2 < transcript.intensities[spoken].max()
    assert transcript.pitches[spoken].max() > 50


def test_sentences_follow_each_other_and_what_was_not_said_is_kept() -> None:
    sentences = [SpokenSentence(np.zeros(SAMPLE_RATE, np.float32), (), f"{k}.", (f"{k}",)) for k in range(3)]
    said = spoken_text(sentences, measured=False)
    assert said.utterance.duration == 3
    assert said.utterance.skipped == ("0", "1", "2")
    assert [run.phoneme for run in said.transcript.runs] == [Phoneme.SILENCE]


def test_chinese_is_written_with_the_movement_of_its_letters(tmp_path: Path) -> None:
    said = spoken_text(Voice("cmn").speak("妈妈好。"), language="cmn")
    track = pinyin_track(said.utterance, text="妈妈好。")
    export_transcript(
        said.transcript, tmp_path / "a.csv", "livelink-csv", movement=track.animation(said.transcript, 60.0)
    )
    lines = (tmp_path / "a.csv").read_text("utf-8").splitlines()
    jaw = lines[0].split(",").index("JawOpen")
    assert max(float(line.split(",")[jaw]) for line in lines[1:]) == pytest.approx(0.66, abs=0.02)


def test_labels_that_are_written_of_a_voice_are_read_again(tmp_path: Path) -> None:
    said = spoken_text(Voice("cmn").speak("我说hello。"), measured=False).utterance
    (tmp_path / "a.TextGrid").write_text(format_utterance(said, "sil"), encoding="utf-8")
    again = read_utterance(tmp_path / "a.TextGrid", said.duration)
    assert [[s.text for s in word.syllables] for word in again.words] == [
        [s.text for s in word.syllables] for word in said.words
    ]
    assert [phone.ipa for phone in again.phones] == [phone.ipa for phone in said.phones]


def test_what_nobody_hears_is_refused_at_its_end() -> None:
    with pytest.raises(TextError, match="the voice has no sounds for this text"):
        spoken_text(Voice("cmn").speak("兙嗧"))
