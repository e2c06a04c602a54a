"""Where the current sound comes from (file, microphone, tone, or text that a voice speaks), and how it is played."""

from collections.abc import Callable
from enum import StrEnum
from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject, Signal
from typing_extensions import override

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.session.microphone import DeviceList, Microphone
from phonemeengine.analyser import Analysis
from phonemeengine.audio.files import SoundReader
from phonemeengine.audio.output import SLOWEST, Output, Reader, open_output
from phonemeengine.audio.stream import Device, devices, outputs_of
from phonemeengine.audio.tone import Tone, ToneReader
from phonemeengine.live.player import Player
from phonemeengine.presets.model_choice import for_live_use, while_played
from phonemeengine.presets.preset import Preset

QUIETEST_DB = -60.0
"""At this volume and below the output is silent."""


class Playback(QObject):
    """Holds what the user chose; the current source follows it.

    Parameters
    ----------
    open_device : opens an output for a number of channels; where the user chose a device, by its label, too.

    Signals
    -------
    changed : something else was chosen.

    Attributes
    ----------
    loop : whether sound begins again at its end.
    volume : dB, -60..0, where -60 is silence.
    speed : 0.25..1 of the usual speed, with the pitch kept; what is recognised stays as it is.
    device : label of the device that plays; empty for the system's default.
    outputs : the devices to choose from.
    tone : what is generated where a tone is the source.
    open_device : see above.
    """

    changed = Signal()

    def __init__(
        self, open_device: Callable[..., Output] = open_output, list_devices: Callable[[], list[Device]] = devices
    ) -> None:
        super().__init__()
        self.loop, self.volume, self.speed, self.device, self.tone = False, 0.0, 1.0, "", Tone()
        self.outputs = DeviceList(list_devices, outputs_of)
        self.open_device = open_device

    def set_loop(self, loop: bool) -> None:
        """Begin again at the end, or not."""
        self.loop = loop
        self.changed.emit()

    def set_volume(self, decibels: float) -> None:
        """Set the loudness of the playback, held to -60..0 dB."""
        self.volume = min(0.0, max(QUIETEST_DB, float(decibels)))
        self.changed.emit()

    def set_speed(self, speed: float) -> None:
        """Play slower, or as usual again; held to 0.25..1."""
        self.speed = min(1.0, max(SLOWEST, float(speed)))
        self.changed.emit()

    def choose_device(self, label: str) -> None:
        """Play on another device from now on; an empty label is the system's default."""
        if label != self.device:
            self.device = label
            self.changed.emit()

    def set_tone(self, tone: Tone) -> None:
        """Generate another tone; where a tone is the source, it is played at once."""
        self.tone = tone
        self.changed.emit()

    @property
    def gain(self) -> float:
        """The volume as a factor, 0..1."""
        return 0.0 if self.volume <= QUIETEST_DB else 10 ** (self.volume / 20)

    def open_output(self, n_channels: int) -> Output:
        """Open the chosen device, or the default one where that is not there, or a clock."""
        return self.open_device(n_channels, self.device) if self.device else self.open_device(n_channels)

    def player_of(self, reader: Reader, preset: Preset) -> Player:
        """Return a player of a sound, as loud as is chosen; the caller closes it."""
        player = Player(reader, preset, self.open_output)
        player.set_gain(self.gain)
        return player


class SourceKind(StrEnum):
    """What there is to choose from."""

    FILE = tr_noop("File")
    MICROPHONE = tr_noop("Microphone")
    TONE = tr_noop("Tone")
    TEXT = tr_noop("Text")


class Source:
    """A source of sound, which is played; without a reader there is no sound.

    Parameters
    ----------
    preset : recognises the sound.
    playback : says how it is played.
    reader : the sound; `close` closes it.

    Attributes
    ----------
    kind : what the user chose.
    title, words : what it is, in English, short and long.
    hint : what the user may do while nothing is played of it, in English.
    live : whether nothing is known of the sound before it is played.
    path : the file that is played; None where it is none.
    preset : recognises the sound.
    player : plays and analyses it; None where that is not done.
    reopen : gives the whole sound once more, from its beginning; None where that cannot be.
    """

    kind, live = SourceKind.FILE, False
    title, words = tr_noop("No file"), tr_noop("open one with Ctrl+O")
    hint = tr_noop("Press Space to play")
    path: Path | None = None
    reopen: Callable[[], Reader] | None = None

    def __init__(self, preset: Preset, playback: Playback | None = None, reader: Reader | None = None) -> None:
        self.preset = preset
        self.player: Player | None = None
        if playback is not None and reader is not None:
            self.player, self._device = playback.player_of(reader, preset), playback.device
            self.follow(playback)

    @property
    def name(self) -> str:
        """What it is, in a word or two, such as the name of a file."""
        return tr(self.title)

    @property
    def description(self) -> str:
        """What it is, in more words, such as rate and channels of a file."""
        return tr(self.words)

    @property
    def seekable(self) -> bool:
        """Whether there are places in the sound to go to."""
        return self.player is not None and not self.live

    @property
    def duration(self) -> float:
        """Seconds of the sound, as far as they are known; 0 of a live one."""
        return 0.0 if self.player is None or self.live else self.player.reader.duration

    @property
    def position(self) -> float:
        """Seconds from the beginning to what is playing."""
        return 0.0 if self.player is None else min(self.player.position, self.player.reader.duration)

    @property
    def playing(self) -> bool:
        """Whether sound goes on, or is listened for."""
        return self.player is not None and self.player.playing

    def play(self) -> bool:
        """Play, or listen; says whether there is anything to play."""
        if self.player is not None:
            self.player.play()
        return self.player is not None

    def pause(self) -> None:
        """Hold still; a microphone is let go, and a recording ends."""
        if self.player is not None:
            self.player.pause()

    def seek(self, seconds: float) -> None:
        """Go to a place in the sound, where it is `seekable`."""
        if self.player is not None and self.seekable:
            self.player.seek(seconds)

    def play_stretch(self, start: float, end: float) -> None:
        """Play the sound from one time to another, seconds, where it is `seekable`."""
        if self.player is not None and self.seekable:
            self.player.play_stretch(start, end)

    def take_analyses(self) -> list[Analysis]:
        """Return what was played since the last call; raises EngineError where that has ended the sound."""
        return [] if self.player is None else self.player.take_analyses()

    def upcoming(self) -> list[tuple[float, Analysis]]:
        """Return what is known of the sound before it is played, each block with the seconds until then."""
        return [] if self.player is None or self.live else self.player.upcoming()

    def set_preset(self, preset: Preset) -> None:
        """Recognise with another preset from here on."""
        self.preset = preset
        if self.player is not None:
            self.player.set_preset(preset)

    def follow(self, playback: Playback) -> None:
        """Play as is chosen now."""
        if self.player is None:
            return
        self.player.loop = playback.loop
        self.player.set_gain(playback.gain)
        self.player.set_speed(playback.speed)
        if playback.device != self._device:
            self._device = playback.device
            self.player.change_device(playback.open_output)

    def close(self) -> None:
        """Let device and sound go."""
        if self.player is not None:
            self.player.close()


class FileSource(Source):
    """Plays a file, recognised by what a preset has for files that are played."""

    def __init__(self, preset: Preset, playback: Playback, file: SoundReader) -> None:
        super().__init__(while_played(preset), playback, file)
        self.path, self._file = file.path, file
        self.reopen = partial(SoundReader, file.path, file.channel)

    @property
    @override
    def name(self) -> str:
        return self._file.path.name

    @property
    @override
    def description(self) -> str:
        """Rate and channels of the file, and what else is known of its sound."""
        n = self._file.n_file_channels
        channels = {1: "mono", 2: "stereo"}.get(n, tr("{n} channels").format(n=n))
        return ", ".join([f"{self._file.file_rate:,} Hz".replace(",", " "), channels, *self._file.known_notes])

    @override
    def set_preset(self, preset: Preset) -> None:
        """Recognise with what another preset has for files that are played."""
        super().set_preset(while_played(preset))


class ToneSource(Source):
    """Plays a tone that changes while it is played."""

    kind = title = SourceKind.TONE
    live = True
    hint = tr_noop("Press Space to play the tone")

    def __init__(self, preset: Preset, playback: Playback) -> None:
        self._reader = ToneReader(playback.tone)
        super().__init__(preset, playback, self._reader)

    @property
    @override
    def description(self) -> str:
        return tr(self._reader.tone.kind.replace("_", " "))

    @override
    def follow(self, playback: Playback) -> None:
        super().follow(playback)
        if playback.tone != self._reader.tone:
            self._reader.set_tone(playback.tone)


class UnspokenText(Source):
    """Stands for a text while there is nothing to play of it; `say` is asked for that."""

    kind = title = SourceKind.TEXT
    words = tr_noop("not spoken yet")
    hint = tr_noop("Enter a text on the Talk page and press Ctrl+Return")

    def __init__(self, preset: Preset, say: Callable[[], None]) -> None:
        super().__init__(preset)
        self._say = say

    @override
    def play(self) -> bool:
        """Ask for the text to be spoken, which is another source."""
        self._say()
        return False


class SpokenSource(Source):
    """Plays a text that a voice or recordings speak, maybe while they are still speaking; `words` says who."""

    kind, title, hint = UnspokenText.kind, UnspokenText.title, UnspokenText.hint

    def __init__(
        self, preset: Preset, playback: Playback, speech: Reader, again: Callable[[], Reader], words: str
    ) -> None:
        super().__init__(preset, playback, speech)
        self.reopen, self.words = again, words


class MicrophoneSource(Source):
    """Listens to the microphone."""

    kind = title = SourceKind.MICROPHONE
    live = True
    hint = tr_noop("Press Space to listen, R to record")

    def __init__(self, preset: Preset, microphone: Microphone) -> None:
        super().__init__(for_live_use(preset))
        self._in_force, self._microphone = preset, microphone
        microphone.refresh_devices()

    @property
    @override
    def description(self) -> str:
        return self._microphone.words

    @property
    @override
    def position(self) -> float:
        """Seconds for which it has been listened to."""
        return self._microphone.listener.seconds

    @property
    @override
    def playing(self) -> bool:
        """Whether it is listened to, or tried to."""
        return self._microphone.active

    @override
    def play(self) -> bool:
        self._microphone.listen(self._in_force)
        return True

    @override
    def take_analyses(self) -> list[Analysis]:
        return self._microphone.listener.take_analyses()

    @override
    def set_preset(self, preset: Preset) -> None:
        """Recognise with another preset, which looks ahead as little as live sound allows."""
        self.preset, self._in_force = for_live_use(preset), preset
        self._microphone.set_preset(preset)

    @override
    def pause(self) -> None:
        """Let the microphone go, and end the recording."""
        self._microphone.stop()

    close = pause


def source_of(
    kind: SourceKind, preset: Preset, playback: Playback, microphone: Microphone, say: Callable[[], None]
) -> Source:
    """Return the source of a kind, as it is when the user chooses it; of files, that there is none.

    Parameters
    ----------
    say : asked to have a text spoken.
    """
    makers: dict[SourceKind, Callable[[], Source]] = {
        SourceKind.MICROPHONE: lambda: MicrophoneSource(preset, microphone),
        SourceKind.TONE: lambda: ToneSource(preset, playback),
        SourceKind.TEXT: lambda: UnspokenText(preset, say),
    }
    return makers[kind]() if kind in makers else Source(preset)
