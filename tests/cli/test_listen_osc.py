"""`phonemeanalyser listen --osc`: what is heard reaches a program beside it, and the listening never suffers."""

import itertools
from collections.abc import Iterable, Iterator
from functools import partial

import pytest
from pythonosc.udp_client import SimpleUDPClient

from phonemeanalyser.cli import listen as listening
from phonemeanalyser.cli.main import main
from phonemeengine import Expression, OscExpression, held_expression
from phonemeengine.audio.stream import InputChoice
from phonemeengine.mouth.osc import OscAddress, OscSettings
from phonemeengine.mouth.table import USUAL_TABLE, load_table
from phonemeengine.presets.files import DEFAULT_PRESET, load_preset
from phonemeengine.settings import SAMPLE_RATE
from tests.fakes.microphones import HandDrivenListener, HandDrivenMicrophone, Microphones
from tests.fakes.osc_receiver import Receiver
from tests.fakes.players import SPEECH
from tests.fakes.portaudio import FakePortAudio
from tests.tables import Capsys, refused
from tests.waiting import Clock, wait_for

PRESET = load_preset(DEFAULT_PRESET)


@pytest.fixture
def receiver() -> Iterator[Receiver]:
    receiver = Receiver()
    yield receiver
    receiver.close()


@pytest.fixture
def microphone(portaudio: FakePortAudio) -> HandDrivenMicrophone:
    portaudio.plug("Yeti", hears=SPEECH)
    return HandDrivenMicrophone(name="Yeti · ALSA")


def listen_to_speech(microphone: HandDrivenMicrophone, osc: OscSettings | None, **more: object) -> None:
    microphone.give(SPEECH)
    listener = partial(HandDrivenListener, Microphones(microphone), clock=Clock())
    listening.listen(PRESET, InputChoice(), len(SPEECH) / SAMPLE_RATE, "text", osc, listener, **more)


def spoken(names: Iterable[str]) -> list[str]:
    """Give the phonemes without silences and repetitions."""
    return [name for name, _ in itertools.groupby(names) if name != "silence"]


def test_a_program_beside_it_hears_the_phonemes_that_are_printed(
    microphone: HandDrivenMicrophone, receiver: Receiver, capsys: Capsys
) -> None:
    listen_to_speech(microphone, OscSettings(receiver.address, load_table("vrm")))
    printed = spoken(line.split()[2] for line in capsys.readouterr().out.splitlines())
    wait_for(lambda: spoken(str(name) for name, _ in receiver.of("/phoneme")) == printed, "the printed phonemes")
    shut = dict.fromkeys(("A", "I", "U", "E", "O"), 0.0)
    wait_for(lambda: receiver.weights() == shut, "a shut mouth")
    assert len(printed) > 4
    assert receiver.of("/VMC/Ext/Blend/Apply")


def test_a_receiver_that_cannot_be_reached_is_said_at_the_end_and_all_is_printed(
    microphone: HandDrivenMicrophone, capsys: Capsys
) -> None:
    listen_to_speech(microphone, OscSettings(OscAddress("255.255.255.255", 9), load_table("vrm")))
    said = capsys.readouterr()
    assert said.err.splitlines()[-1].startswith("phonemeanalyser: the OSC receiver cannot be reached (")
    assert len(said.out.splitlines()) > 4


@pytest.mark.usefixtures("microphone")
def test_the_command_line_sends_too(receiver: Receiver, capsys: Capsys) -> None:
    to = f"{receiver.address.host}:{receiver.address.port}"
    assert main(["listen", "--seconds", "0.5", "--osc", to, "--table", "vrm"]) == 0
    wait_for(lambda: set(receiver.weights()) == {"A", "I", "U", "E", "O"}, "a face")
    assert capsys.readouterr().out


def test_the_command_line_moves_a_face_as_the_head_moves_unless_told_otherwise(
    microphone: HandDrivenMicrophone, receiver: Receiver
) -> None:
    head = load_table(USUAL_TABLE)
    moved = {name for name, column in zip(head.movestates, head.weights().T, strict=True) if column.any()}
    microphone.give(SPEECH)
    assert main(["listen", "--seconds", "0.5", "--osc", f"{receiver.address.host}:{receiver.address.port}"]) == 0
    wait_for(lambda: set(receiver.weights()) == moved, "the movestates of the head")


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (("--osc", "nowhere"), "an OSC receiver is HOST:PORT, such as 127.0.0.1:39539, found 'nowhere'"),
        (("--osc", "127.0.0.1:9", "--table", "gone"), "gone: there is no such mouth table; name a file, or one of"),
    ],
)
def test_wrong_receivers_and_tables_are_said_before_anything_is_begun(
    words: tuple[str, ...], sentence: str, microphone: HandDrivenMicrophone, capsys: Capsys
) -> None:
    assert refused(capsys, "listen", *words).startswith(sentence)
    assert not microphone.closed.is_set()


def test_a_smile_is_sent_with_the_mouth_and_another_program_may_ask_for_more(
    microphone: HandDrivenMicrophone, receiver: Receiver, capsys: Capsys
) -> None:
    with OscExpression(OscAddress("127.0.0.1", 0)) as asked:
        client = SimpleUDPClient("127.0.0.1", asked.port)
        client.send_message("/expression", ["browInnerUp", 1.0])
        client.close()
        wait_for(lambda: float(asked.weights(0.0).max()) == 1, "what was asked for")
        expression = Expression((held_expression({"smile": 1.0}), asked))
        listen_to_speech(microphone, OscSettings(receiver.address, load_table(USUAL_TABLE), expression))
    pictures = [weights for _, weights in receiver.pictures]
    assert max(weights.get("browInnerUp", 0.0) for weights in pictures) > 0.85
    assert max(weights.get("cheekSquintLeft", 0.0) for weights in pictures) > 0.4


@pytest.mark.parametrize("words", [["--expression", "smile"], ["--expression-osc", "127.0.0.1:9"]])
def test_an_expression_that_nobody_is_sent_is_a_usage_error(words, capsys) -> None:
    with pytest.raises(SystemExit) as ended:
        main(["listen", *words])
    assert ended.value.code == 2
    assert "--osc" in capsys.readouterr().err
