"""Listening and recording from the command line, without a sound card: words, lines, and refusals."""

import csv
import io
import itertools
import json
from collections.abc import Callable
from contextlib import redirect_stdout
from dataclasses import replace
from functools import partial
from pathlib import Path
from threading import Event

import numpy as np
import pytest
import soundfile

from phonemeanalyser.cli import listen as listening
from phonemeanalyser.cli.listen import ChangePrinter, json_line, text_line
from phonemeanalyser.cli.main import main
from phonemeengine.audio.stream import InputChoice
from phonemeengine.errors import RecordingError
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import DEFAULT_PRESET, factory_preset, load_preset
from phonemeengine.presets.model_choice import for_live_use, with_small_network
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import SAMPLE_RATE
from tests.fakes.microphones import HandDrivenListener, HandDrivenMicrophone, Microphones, frames_in, offline
from tests.fakes.players import SPEECH
from tests.fakes.portaudio import FakePortAudio
from tests.tables import Capsys
from tests.waiting import Clock

PRESET = load_preset(DEFAULT_PRESET)


class Openers(Microphones):
    """Opens microphones in turn; some time passes before each."""

    def __init__(self) -> None:
        super().__init__()
        self.wait: Callable[[], object] = lambda: None

    def __call__(self, choice: InputChoice) -> HandDrivenMicrophone:
        self.wait()
        return super().__call__(choice)


@pytest.fixture
def openers() -> Openers:
    """The microphones that these commands open."""
    return Openers()


@pytest.fixture
def microphone(portaudio: FakePortAudio, openers: Openers) -> HandDrivenMicrophone:
    """The first microphone that these commands open."""
    portaudio.plug("Yeti")
    microphone = HandDrivenMicrophone(name="Yeti · ALSA")
    openers.waiting.append(microphone)
    return microphone


@pytest.fixture
def listener(openers: Openers, clock: Clock) -> Callable[..., HandDrivenListener]:
    """What listens for these commands; no time passes unless the test says so."""
    return partial(HandDrivenListener, openers, clock=clock)


# -- wrong words ----------------------------------------------------------------------------------------------


# -- devices --------------------------------------------------------------------------------------------------


def test_microphones_are_listed_a_line_each_with_a_star_at_the_default(
    portaudio: FakePortAudio, capsys: Capsys
) -> None:
    portaudio.plug("Built-in", 2)
    portaudio.plug("Speaker", 0)
    portaudio.plug("Yeti", 1, api=1, rate=44_100.0)
    portaudio.default.device = (2, 1)
    assert main(["listen", "--list-devices"]) == 0
    assert capsys.readouterr().out.splitlines() == [
        "* Yeti · JACK  (1 channels, 44100 Hz)",
        "  Built-in · ALSA  (2 channels, 48000 Hz)",
    ]


@pytest.mark.usefixtures("portaudio")
@pytest.mark.parametrize("words", [["listen", "--list-devices"], ["listen"], ["record", "never.wav"]])
def test_without_a_microphone_it_says_so_and_fails(words: list[str], capsys: Capsys) -> None:
    assert main(words) == 1
    said = capsys.readouterr()
    assert said.out == ""
    assert said.err == (
        "phonemeanalyser: no microphone was found; connect one, or check that the audio system is running\n"
    )


def test_a_microphone_that_is_not_there_is_said_before_anything_is_begun(
    portaudio: FakePortAudio, capsys: Capsys, tmp_path: Path
) -> None:
    portaudio.plug("Yeti")
    assert main(["record", str(tmp_path / "a.wav"), "--device", "Gone"]) == 1
    assert capsys.readouterr().err == (
        "phonemeanalyser: the microphone 'Gone' is not connected; choose one of: Yeti · ALSA\n"
    )
    assert list(tmp_path.iterdir()) == []


# -- lines ----------------------------------------------------------------------------------------------------


def expected_changes(n_frames: int | None = None, preset: Preset = PRESET) -> list[tuple[float, str, float]]:
    whole = offline(SPEECH, preset).part(slice(n_frames))
    codes = whole.phonemes.astype(int)
    starts = np.flatnonzero(np.diff(codes, prepend=-1))
    return [(int(k) / 100, Phoneme(codes[k]).label, float(whole.intensities[k])) for k in starts]


def expected_confidences() -> list[float]:
    whole = offline(SPEECH, PRESET)
    return [float(whole.confidences[round(100 * change[0])]) for change in expected_changes()]


@pytest.mark.parametrize("n", [1, 7, 1000])
def test_each_change_of_phoneme_is_a_line_however_the_frames_come(n: int, capsys: Capsys) -> None:
    whole, changes = offline(SPEECH, PRESET), ChangePrinter(json_line)
    for k in range(0, len(whole), n):
        changes.follow(whole.part(slice(k, k + n)))
    lines = [json.loads(line) for line in capsys.readouterr().out.splitlines()]
    assert [(line["time_s"], line["phoneme"]) for line in lines] == [change[:2] for change in expected_changes()]
    assert [line["intensity"] for line in lines] == pytest.approx([c[2] for c in expected_changes()], abs=6e-4)
    assert [line["confidence"] for line in lines] == pytest.approx(expected_confidences(), abs=1e-3)
    names = ["time_s", "phoneme", "intensity", "confidence", "latency_ms"]
    assert all(list(line) == names for line in lines)
    assert len(lines) > 4


def test_the_latency_of_a_line_is_the_age_of_its_first_frame(capsys: Capsys) -> None:
    class Aged:
        def age_of(self, frame: int) -> float:
            return frame / 1000

        def time_of(self, frame: int) -> float:
            return frame / 100

    whole, changes = offline(SPEECH, PRESET), ChangePrinter(json_line)
    changes.listener = Aged()  # type: ignore[assignment]
    changes.follow(whole)
    for line in map(json.loads, capsys.readouterr().out.splitlines()):
        assert line["latency_ms"] == pytest.approx(line["time_s"] * 100)


def test_lines_of_text_have_time_phoneme_and_intensity_in_columns(capsys: Capsys) -> None:
    ChangePrinter(text_line).follow(offline(SPEECH, PRESET))
    lines = capsys.readouterr().out.splitlines()
    words = [line.split() for line in lines]
    assert [(float(w[0]), w[1], w[2]) for w in words] == [(t, "s", p) for t, p, _ in expected_changes()]
    assert len({line.index(" s ") for line in lines}) == 1
    assert [int(w[4]) for w in words] == pytest.approx([100 * c for c in expected_confidences()], abs=1)
    assert lines[0].startswith("    0.00 s  silence       0.00  ")
    assert lines[0].endswith(" % confidence")


def test_how_sure_it_is_is_not_said_where_nobody_measured_it() -> None:
    assert text_line(1.0, "a", 0.5, None, 40.0).split() == ["1.00", "s", "a", "0.50"]
    assert json.loads(json_line(1.0, "a", 0.5, None, 40.0))["confidence"] is None


# -- whole commands -------------------------------------------------------------------------------------------


def test_listening_prints_the_changes_and_says_elsewhere_what_it_listens_to(
    microphone: HandDrivenMicrophone, listener: Callable[..., HandDrivenListener], capsys: Capsys
) -> None:
    microphone.give(SPEECH)
    listening.listen(PRESET, InputChoice(), len(SPEECH) / SAMPLE_RATE, "json", open_listener=listener)
    said = capsys.readouterr()
    lines = [json.loads(line) for line in said.out.splitlines()]
    expected = expected_changes(frames_in(len(SPEECH)), for_live_use(PRESET))
    assert [(line["time_s"], line["phoneme"]) for line in lines] == [change[:2] for change in expected]
    assert microphone.closed.is_set()


def test_it_says_how_late_and_how_right_it_was_as_far_ahead_as_the_user_let_it_look(
    microphone: HandDrivenMicrophone, listener: Callable[..., HandDrivenListener], capsys: Capsys
) -> None:
    learned = factory_preset("learned")
    assert learned.model is not None
    model = replace(learned.model, about={"by_look_ahead_ms": {"50": [0.71, 0.742]}})
    settings = replace(learned.settings, look_ahead=0.0, live_look_ahead=0.0).with_number("live_look_ahead", 0.05)
    microphone.give(SPEECH)
    preset = with_small_network(replace(learned, model=model, settings=settings))
    listening.listen(preset, InputChoice(), len(SPEECH) / SAMPLE_RATE, "json", open_listener=listener)
    said = capsys.readouterr().err
    assert " ms (capture " in said
    assert " + look-ahead 50 + analysis " in said
    assert "accuracy with this look-ahead: macro F1 0.71, mouth shapes 74 %" in said


@pytest.mark.parametrize("words", [[], ["--look-ahead", "0.04"]])
def test_the_look_ahead_is_the_presets_or_the_users(
    words: list[str], portaudio: FakePortAudio, capsys: Capsys
) -> None:
    portaudio.plug("Yeti", hears=SPEECH)
    assert main(["listen", "--preset", "learned", "--model", "real-time", "--seconds", "0.5", *words]) == 0
    expected = 0.04 if words else factory_preset("learned").settings.live_look_ahead
    assert f" + look-ahead {1000 * expected:.0f} + " in capsys.readouterr().err


def test_recording_keeps_the_length_and_reports_it(
    microphone: HandDrivenMicrophone, listener: Callable[..., HandDrivenListener], capsys: Capsys, tmp_path: Path
) -> None:
    microphone.give(SPEECH)
    listening.record(tmp_path / "a.wav", PRESET, InputChoice(), 1.0, with_phonemes=True, open_listener=listener)
    found, rate = soundfile.read(tmp_path / "a.wav", dtype="float32")
    assert (len(found), rate) == (SAMPLE_RATE, SAMPLE_RATE)
    np.testing.assert_allclose(found, SPEECH[:SAMPLE_RATE].clip(-1, 1), atol=2**-23)
    assert (tmp_path / "a.csv").read_text().splitlines()[-1].split(",")[1] == "1.0"
    assert f"{tmp_path / 'a.wav'}: 1.00 s recorded, nothing lost" in capsys.readouterr().err


@pytest.mark.usefixtures("microphone")
def test_a_recording_of_nothing_fails_and_leaves_no_file(openers: Openers, tmp_path: Path) -> None:
    seconds = itertools.count()
    listener = partial(HandDrivenListener, openers, clock=lambda: float(next(seconds)))
    with pytest.raises(RecordingError, match=r"^a\.wav: no sound came from the microphone"):
        listening.record(tmp_path / "a.wav", PRESET, InputChoice(), 0.1, with_phonemes=True, open_listener=listener)
    assert list(tmp_path.glob("a*")) == []


def test_a_name_that_is_taken_ends_the_recording_with_its_sentence(
    microphone: HandDrivenMicrophone, listener: Callable[..., HandDrivenListener], tmp_path: Path
) -> None:
    (tmp_path / "a.wav").write_bytes(b"mine")
    microphone.give(SPEECH)
    with pytest.raises(RecordingError, match=r"a\.wav: there is a file of that name"):
        listening.record(tmp_path / "a.wav", PRESET, InputChoice(), 60.0, with_phonemes=False, open_listener=listener)
    assert (tmp_path / "a.wav").read_bytes() == b"mine"


class ClosedPipe(io.StringIO):
    """Where nobody reads."""

    def write(self, _text: str) -> int:
        raise BrokenPipeError


def test_what_fails_in_the_listening_reaches_the_caller(
    microphone: HandDrivenMicrophone, listener: Callable[..., HandDrivenListener]
) -> None:
    microphone.give(SPEECH)
    with redirect_stdout(ClosedPipe()), pytest.raises(BrokenPipeError):
        listening.listen(PRESET, InputChoice(), None, "text", open_listener=listener)
    assert microphone.closed.is_set()


@pytest.mark.parametrize("fill", [False, True])
def test_a_recording_across_a_lost_microphone_says_how_long_the_sound_and_the_gap_are(
    microphone: HandDrivenMicrophone,
    openers: Openers,
    capsys: Capsys,
    tmp_path: Path,
    clock: Clock,
    listener: Callable[..., HandDrivenListener],
    fill: bool,
) -> None:
    def wait() -> None:
        clock.now += 4.21 if openers.asked else 0.0

    back = HandDrivenMicrophone(name="Yeti · ALSA")
    openers.waiting.append(back)
    openers.wait = wait
    microphone.give(SPEECH[: SAMPLE_RATE // 2], SAMPLE_RATE // 2)
    microphone.lost = True
    back.give(SPEECH[: SAMPLE_RATE // 2])  # each block began 10 ms before it came
    listening.record(
        tmp_path / "a.wav", PRESET, InputChoice(), 5.15, with_phonemes=True, fill_gaps=fill, open_listener=listener
    )
    with (tmp_path / "a.csv").open(newline="") as table:
        (gap,) = (row for row in csv.DictReader(table) if row["phoneme"].startswith("gap of "))
    found, _ = soundfile.read(tmp_path / "a.wav")
    length, silent = len(found) / SAMPLE_RATE, float(gap["end_s"]) - float(gap["start_s"])
    assert (gap["start_s"], gap["phoneme"], silent) == ("0.5", "gap of 4.20 s", pytest.approx(4.2 * fill))
    said = f"a.wav: {length:.2f} s recorded, with 1 {gap['phoneme']} marked in it"
    said += f": {length - silent:.2f} s of sound, {silent:.2f} s of silence" if fill else ""
    assert f"{said}, nothing more lost\n" in capsys.readouterr().err


def test_a_microphone_that_vanishes_while_it_is_recorded_is_reported_as_lost(
    microphone: HandDrivenMicrophone,
    clock: Clock,
    listener: Callable[..., HandDrivenListener],
    capsys: Capsys,
    tmp_path: Path,
) -> None:
    class Closed(Event):
        def set(self) -> None:
            clock.now += 60.0

    microphone.give(SPEECH[: SAMPLE_RATE // 2])
    microphone.lost = True
    microphone.closed = Closed()
    listening.record(tmp_path / "a.wav", PRESET, InputChoice(), 0.9, with_phonemes=False, open_listener=listener)
    said = capsys.readouterr().err
    assert "0.50 s recorded" in said
    assert "nothing lost" not in said
    assert " s were lost on the way" in said


def test_the_command_line_records_with_what_it_is_told(portaudio: FakePortAudio, tmp_path: Path) -> None:
    portaudio.plug("Yeti", hears=SPEECH)
    assert main(["record", str(tmp_path / "a.wav"), "--seconds", "0.5", "--phonemes", "--fill-gaps"]) == 0
    assert soundfile.info(tmp_path / "a.wav").frames == SAMPLE_RATE // 2
    assert (tmp_path / "a.csv").exists()
