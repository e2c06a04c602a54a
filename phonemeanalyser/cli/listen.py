"""``phonemeanalyser listen``: recognise the sound of a microphone; and record it, see `record`."""

import argparse
import json
import math
import os
import signal
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import asdict, replace
from pathlib import Path
from types import FrameType

import phonemeengine
from phonemeanalyser.cli.arguments import add_options, given
from phonemeanalyser.cli.parser import number_in, whole_in
from phonemeengine.analyser import latest_reading
from phonemeengine.audio.resampling import HIGHEST_RATE, LOWEST_RATE
from phonemeengine.audio.stream import chosen_input, inputs_of
from phonemeengine.features.feeling import FeelingEstimator
from phonemeengine.live.listener import Latency
from phonemeengine.mouth.osc import OscAddress, OscSettings
from phonemeengine.mouth.performer import MOUTH_ALONE, IdleMotion
from phonemeengine.mouth.style import NEUTRAL, load_style
from phonemeengine.mouth.table import USUAL_TABLE
from phonemeengine.performance.driver import FACE
from phonemeengine.performance.face_network import FaceFollower, FaceFrames, FaceNetwork, load_face_network
from phonemeengine.presets.model_choice import figures_ahead, for_live_use, model_in_words
from phonemeengine.presets.preset import LIVE_KINDS
from phonemeengine.settings import PARAMETERS, ModelKind
from phonemeengine.storage.files import printable

LOOK = 0.2
"""Seconds between two looks at how it goes."""
LEAST_LOSS = 0.005
"""Seconds; less is not told."""
PATIENCE = 3.0
"""Seconds that a microphone which gives nothing is waited for beyond the time that was asked for."""

EXAMPLES = (
    "phonemeanalyser listen",
    "phonemeanalyser listen --format json --seconds 10",
    "phonemeanalyser listen --osc 127.0.0.1:39539 --table vrm --look-ahead 0.05",
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare what is listened to, and what is printed of it."""
    add_input(parser)
    ahead = PARAMETERS["live_look_ahead"]
    limits = f"{ahead.low:g} to {ahead.high:g} {ahead.unit}"
    wait = f"look-ahead, {limits}: longer is more accurate, and adds to the latency (default: the preset's)"
    parser.add_argument("--look-ahead", type=number_in(*ahead.limits), metavar="S", help=wait)
    model = "model that recognises; real-time is the small network alone (default: the preset's)"
    parser.add_argument("--model", type=ModelKind, choices=LIVE_KINDS, metavar="|".join(LIVE_KINDS), help=model)
    parser.add_argument("--format", choices=["text", "json"], default="text", dest="kind", help="(default: text)")
    parser.add_argument("--list-devices", action="store_true", help="print the microphones and exit")
    parser.add_argument("--osc", metavar="HOST:PORT", help="send phonemes and mouth shapes as OSC and VMC messages")
    table = f"mouth table for --osc: vrm, oculus, ... or a file (default: {USUAL_TABLE})"
    parser.add_argument("--table", default=USUAL_TABLE, metavar="T", help=table)
    add_options(parser, "decoder", "style", "expression", "feeling", "priority", "face-network")
    received = "receive expressions of other programs here (/expression NAME V, or VMC blend shapes)"
    parser.add_argument("--expression-osc", metavar="HOST:PORT", help=received)


def run(options: argparse.Namespace) -> int:
    """Listen until the time is over, or Ctrl-C."""
    if options.list_devices:
        list_devices()
    else:
        with ExitStack() as stack:
            osc, network = _osc_of(options, stack), _network_of(options)
            listen(_preset_of(options), input_of(options), options.seconds, options.kind, osc, network=network)
    return 0


def _preset_of(options: argparse.Namespace) -> phonemeengine.Preset:
    preset = phonemeengine.load_preset(options.preset).with_decoder(options.decoder)
    if options.look_ahead is not None:
        preset = replace(preset, settings=preset.settings.with_number("live_look_ahead", options.look_ahead))
    if options.model is not None:
        preset = replace(preset, live_model=options.model)
    live = for_live_use(preset)
    for warning in live.warnings:
        print(f"phonemeanalyser: {printable(preset.name)}: note: {warning}", file=sys.stderr)
    if sys.stderr.isatty():
        print(f"phonemeanalyser: model: {model_in_words(live)}", file=sys.stderr)
    return preset


def _osc_of(options: argparse.Namespace, stack: ExitStack) -> OscSettings | None:
    if options.osc is None:
        if any(value is not None for value in (options.expression, options.expression_osc, options.feeling)):
            options.parser.error("an expression is sent with the mouth; say where with --osc")
        if options.face_network is not None:
            options.parser.error("what --face-network moves is sent; say where with --osc")
        return None
    streams = []
    if options.expression_osc is not None:
        streams.append(stack.enter_context(phonemeengine.OscExpression(OscAddress.of(options.expression_osc))))
    style = load_style(options.style or NEUTRAL)
    idle = style.on_idle(IdleMotion(expression=given(options).expressed(*streams)))
    return OscSettings(
        OscAddress.of(options.osc), style.on_table(phonemeengine.load_table(options.table)), idle.expression
    )


def _network_of(options: argparse.Namespace) -> FaceNetwork | None:
    if options.face_network is None:
        return None
    if not {*phonemeengine.load_table(options.table).movestates} <= {*FACE}:
        options.parser.error(
            f"a network moves ARKit's blend shapes, and the table {options.table} has others; use arkit"
        )
    return load_face_network(options.face_network)


def add_input(parser: argparse.ArgumentParser) -> None:
    """Let the user choose the microphone, and what recognises it for how long."""
    parser.add_argument("--device", default="", metavar="NAME", help="microphone, by its name or a part of it")
    add_options(parser, "preset", "channel", channel=phonemeengine.Channel.LEFT)
    rate = whole_in(LOWEST_RATE, HIGHEST_RATE, "Hz")
    parser.add_argument(
        "--rate", type=rate, default=0, metavar="HZ", help="sample rate (default: 44100 if supported)"
    )
    parser.add_argument("--seconds", type=number_in(0, math.inf, "s"), metavar="S", help="stop after S seconds")


def input_of(options: argparse.Namespace) -> phonemeengine.InputChoice:
    """Return the microphone that the user chose."""
    return phonemeengine.InputChoice(options.device, options.channel.number, options.rate)


def list_devices() -> None:
    """Print the microphones, a line each; a star marks the system's default.

    Raises
    ------
    DeviceError : there is none.
    """
    found = inputs_of(phonemeengine.devices())
    if not found:
        raise phonemeengine.DeviceError(
            "no microphone was found; connect one, or check that the audio system is running"
        )
    for device in found:
        star = "*" if device.is_default else " "
        print(f"{star} {device.label}  ({device.n_inputs} channels, {device.rate} Hz)")


def listen(
    preset: phonemeengine.Preset,
    choice: phonemeengine.InputChoice,
    seconds: float | None,
    kind: str,
    osc: OscSettings | None = None,
    open_listener: Callable[..., phonemeengine.Listener] = phonemeengine.Listener,
    network: FaceNetwork | None = None,
) -> None:
    """Print a line at each change of phoneme, for some seconds or until Ctrl-C.

    Parameters
    ----------
    kind : ``text``, or ``json`` for a JSON object on each line.
    osc : where the mouth is sent to as well.
    open_listener : begins to listen.
    network : moves the mouth that is sent, in place of the phonemes.

    Raises
    ------
    DeviceError : the microphone is not there.
    MouthError : the receiver of the mouth is unknown.
    """
    chosen_input(choice, phonemeengine.devices())
    feeling = FeelingEstimator()
    changes = ChangePrinter(json_line if kind == "json" else text_line)
    with _sending(osc) as performer, _quiet_libraries(), ended_by_signals():
        follower, face = (None, None) if network is None else (FaceFollower(network), FaceFrames(network))
        if performer is not None:
            performer.play(face)

        def follow(analysis: phonemeengine.Analysis) -> None:
            changes.follow(analysis)
            if performer is not None:
                now = time.monotonic()
                if follower is not None and face is not None:
                    face.add(follower.listen(analysis), now)
                performer.add(phonemeengine.timed_frames(analysis, now), now, live=True)
                if performer.feels:
                    performer.feel(feeling.follow(analysis.frames.windows), now)

        changes.listener = listener = open_listener(preset, choice, phonemes_only=True, on_analysis=follow)
        try:
            _attend(listener, seconds, lambda: None)
        finally:
            latency = listener.latency  # before it is closed, and knows no microphone any more
            listener.close()
            if listener.lost_seconds:
                print(f"phonemeanalyser: {listener.lost_seconds:.2f} s were lost on the way", file=sys.stderr)
            if latency.analysis:
                print(f"phonemeanalyser: {_late_in_words(latency, preset)}", file=sys.stderr)


def record(
    path: Path,
    preset: phonemeengine.Preset,
    choice: phonemeengine.InputChoice,
    seconds: float | None,
    *,
    with_phonemes: bool,
    fill_gaps: bool = False,
    open_listener: Callable[..., phonemeengine.Listener] = phonemeengine.Listener,
) -> None:
    """Record to a file, for some seconds or until Ctrl-C; see `Recorder`.

    Raises
    ------
    DeviceError : the microphone is not there.
    RecordingError : the file cannot be written, or no sound came.
    """
    chosen_input(choice, phonemeengine.devices())
    limit = math.inf if seconds is None else seconds
    recorder = phonemeengine.Recorder(path, with_phonemes=with_phonemes, fill_gaps=fill_gaps, seconds=limit)
    with _quiet_libraries(), ended_by_signals():
        listener = open_listener(preset, choice, phonemes_only=True, recorder=recorder)
        try:
            _attend(listener, seconds, lambda: _check(recorder))
        finally:
            listener.close()
            recorder.close()
            _report(recorder, listener)
    if recorder.failure:
        raise phonemeengine.RecordingError(recorder.failure)
    if not recorder.paths:
        raise phonemeengine.RecordingError(
            f"{path.name}: no sound came from the microphone, so nothing was recorded; check its plug"
        )


def _late_in_words(latency: Latency, preset: phonemeengine.Preset) -> str:
    """Return the latency of phonemes, and how right they are with that look-ahead, where the training measured it."""
    shares = " + ".join(f"{name.replace('_', '-')} {1000 * share:.0f}" for name, share in asdict(latency).items())
    words = f"mean latency {1000 * latency.total:.0f} ms ({shares})"
    figures = figures_ahead(for_live_use(preset), round(latency.look_ahead / phonemeengine.FRAME_PERIOD))
    if figures is None:
        return words
    shapes = f"mouth shapes {100 * figures.mouth_shapes:.0f} %"
    return f"{words}; accuracy with this look-ahead: macro F1 {figures.macro_f1:.2f}, {shapes}"


@contextmanager
def _sending(osc: OscSettings | None) -> Iterator[phonemeengine.Performer | None]:
    """Send what a performer shows meanwhile, and say at the end if nothing could be sent."""
    if osc is None:
        yield None
        return
    performer = phonemeengine.Performer(osc.table, replace(MOUTH_ALONE, expression=osc.expression))
    mouth = phonemeengine.OscMouth(osc.address, performer)
    try:
        yield performer
    finally:
        mouth.close()
        if mouth.failure:
            print(f"phonemeanalyser: {mouth.failure}", file=sys.stderr)


class ChangePrinter:
    """Prints a line whenever the phoneme is another."""

    def __init__(self, line_of: Callable[[float, str, float, float | None, float], str]) -> None:
        self.listener: phonemeengine.Listener | None = None
        self._line_of = line_of
        self._last = -1

    def follow(self, analysis: phonemeengine.Analysis) -> None:
        """Look through the next frames."""
        for k, code in enumerate(analysis.phonemes.tolist()):
            if code != self._last:
                self._last = code
                frame = analysis.start + k
                age = self.listener.age_of(frame) if self.listener else 0.0
                began = self.listener.time_of(frame) if self.listener else frame * phonemeengine.FRAME_PERIOD
                _, _, sure = latest_reading(analysis.part(slice(k, k + 1)))
                line = self._line_of(
                    began, phonemeengine.Phoneme(code).label, float(analysis.intensities[k]), sure, 1000 * age
                )
                sys.stdout.write(line + "\n")
                sys.stdout.flush()


def text_line(time_s: float, phoneme: str, intensity: float, confidence: float | None, _latency_ms: float) -> str:
    """Return a reading as a line for people."""
    sure = "" if confidence is None else f"  {100 * confidence:3.0f} % confidence"
    return f"{time_s:8.2f} s  {phoneme:<12}  {intensity:.2f}{sure}"


def json_line(time_s: float, phoneme: str, intensity: float, confidence: float | None, latency_ms: float) -> str:
    """Return a reading as a line of JSON."""
    values = {"time_s": round(time_s, 2), "phoneme": phoneme, "intensity": round(intensity, 3)}
    sure = None if confidence is None else round(confidence, 3)
    return json.dumps(values | {"confidence": sure, "latency_ms": round(latency_ms, 1)})


def _attend(listener: phonemeengine.Listener, seconds: float | None, look: Callable[[], None]) -> None:
    """Stay for a number of seconds of sound; report what happens to the microphone."""
    wanted = math.inf if seconds is None else seconds
    end = listener.clock() + wanted + PATIENCE
    said = ""
    while (left := wanted - listener.seconds) > 0 and listener.clock() < end:
        time.sleep(min(LOOK, left))
        listener.take_analyses()
        look()
        status = listener.status
        words = f"listening to {status.words}" if status.listening else status.trouble
        if words != said:
            print(f"phonemeanalyser: {words}", file=sys.stderr, flush=True)
            said = words


def _check(recorder: phonemeengine.Recorder) -> None:
    if recorder.failure:
        raise phonemeengine.RecordingError(recorder.failure)


def _report(recorder: phonemeengine.Recorder, listener: phonemeengine.Listener) -> None:
    lost = listener.lost_seconds - sum(gap.seconds for gap in recorder.gaps)
    other = " more" if recorder.gaps else ""
    missing = f", {lost:.2f} s{other} were lost on the way" if lost >= LEAST_LOSS else f", nothing{other} lost"
    gaps = f", {recorder.gap_words}" if recorder.gaps else ""
    for path in recorder.paths[:-1]:
        print(f"phonemeanalyser: {path}: recorded until the microphone changed", file=sys.stderr)
    if recorder.path is not None and recorder.seconds:
        print(f"phonemeanalyser: {recorder.path}: {recorder.seconds:.2f} s recorded{gaps}{missing}", file=sys.stderr)
    for note in recorder.notes:
        print(f"phonemeanalyser: note: {note}", file=sys.stderr)


@contextmanager
def ended_by_signals() -> Iterator[None]:
    """Have Ctrl-C, and what asks a process to end, be the ordinary end."""

    def end(_number: int, _frame: FrameType | None) -> None:
        raise KeyboardInterrupt

    before = signal.signal(signal.SIGTERM, end) if threading.current_thread() is threading.main_thread() else None
    try:
        yield
    except KeyboardInterrupt:  # the ordinary end: what writes files closes them
        pass
    finally:
        if before is not None:
            signal.signal(signal.SIGTERM, before)


@contextmanager
def _quiet_libraries() -> Iterator[None]:
    """Keep what ALSA and PortAudio print about devices off standard error, which is for sentences."""
    sys.stderr.flush()
    theirs, stderr = os.dup(2), sys.stderr
    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, 2)
    os.close(nowhere)
    if stderr is sys.__stderr__:
        sys.stderr = os.fdopen(os.dup(theirs), "w", buffering=1)
    try:
        yield
    finally:
        os.dup2(theirs, 2)
        os.close(theirs)
        if sys.stderr is not stderr:
            sys.stderr.close()
            sys.stderr = stderr
