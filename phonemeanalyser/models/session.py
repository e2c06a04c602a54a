"""The sound in hand: opened, played, and what is known of it."""

from collections.abc import Callable, Iterator
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from engine.analyser import Analysis, analyses_between
from engine.audio.files import SoundReader
from engine.audio.stream import Output, open_output
from engine.errors import EngineError
from engine.live import FilePlayer
from engine.recognition.recogniser import recogniser_of
from engine.recognition.trace import Trace
from engine.settings import FRAME_PERIOD, Channel
from phonemeanalyser.models.averages import AveragesModel
from phonemeanalyser.models.history import History
from phonemeanalyser.models.preset import PresetModel

QUIETEST_DB = -60.0
"""At this volume and below nothing is heard."""
AGAIN = 1000
"""Frames that are analysed anew at most when the preset changes while nothing plays: ten seconds."""


class Session(QObject):
    """Plays a file and gathers its analysis; `tick` moves it on, and whoever draws looks at it afterwards.

    Signals
    -------
    opened : another file is in hand.
    transport_changed : playing, pausing, stopping, loop, volume or channel.
    cleared : everything gathered was forgotten.
    rewritten : this many of the newest columns of the history are others now.
    failed : a sentence for the user.
    """

    opened = Signal()
    transport_changed = Signal()
    cleared = Signal()
    rewritten = Signal(int)
    failed = Signal(str)

    def __init__(self, preset: PresetModel, open_device: Callable[[int], Output] = open_output) -> None:
        super().__init__()
        self.preset = preset
        self.history = History()
        self.averages = AveragesModel()
        self.loop = False
        self.volume = 0.0
        self.channel = Channel.MIX
        self._open_device = open_device
        self._player: FilePlayer | None = None
        preset.changed.connect(self._use_preset)

    # -- what it is ---------------------------------------------------------------------------------------

    @property
    def path(self) -> Path | None:
        """The file in hand."""
        return self._player.reader.path if self._player else None

    @property
    def duration(self) -> float:
        """Seconds of the file in hand."""
        return self._player.reader.duration if self._player else 0.0

    @property
    def position(self) -> float:
        """Seconds from the file's beginning to what is heard."""
        return min(self._player.position, self.duration) if self._player else 0.0

    @property
    def playing(self) -> bool:
        """Whether sound is going on."""
        return self._player is not None and self._player.playing

    @property
    def description(self) -> str:
        """The file's rate and channels, in words."""
        if self._player is None:
            return "no sound"
        reader = self._player.reader
        channels = {1: "mono", 2: "stereo"}.get(reader.n_file_channels, f"{reader.n_file_channels} channels")
        return ", ".join([f"{reader.file_rate:,} Hz".replace(",", " "), channels, *reader.notes])

    @property
    def output_name(self) -> str:
        """What the sound is heard on."""
        return self._player.output_name if self._player else ""

    @property
    def has_card(self) -> bool:
        """Whether a sound card plays."""
        return self._player is not None and self._player.has_card

    @property
    def n_dropped(self) -> int:
        """Frames that were analysed but never shown, since the file was opened."""
        return self._player.n_dropped if self._player else 0

    # -- transport ----------------------------------------------------------------------------------------

    def open(self, path: Path) -> bool:
        """Open a file and stand at its beginning; a file that cannot be read leaves the present one in hand."""
        try:
            player = FilePlayer(path, self.preset.in_force, self.channel, self._open_free_device)
        except EngineError as error:
            self.failed.emit(str(error))
            return False
        player.loop = self.loop
        self._player = player
        self.set_volume(self.volume)
        self.clear()
        self.opened.emit()
        self.transport_changed.emit()
        return True

    def _open_free_device(self, n_channels: int) -> Output:
        """Open what is played on, once the present file has let go of it: some cards serve one stream at a time."""
        self.close()
        return self._open_device(n_channels)

    def play(self) -> None:
        """Play from where it stands; the averaged spectrum begins anew when that is the beginning."""
        if self._player is None:
            return
        if self.position == 0:
            self.averages.clear()
        self._player.play()
        self.transport_changed.emit()

    def pause(self) -> None:
        """Hold still."""
        if self._player is not None:
            self._player.pause()
            self.transport_changed.emit()

    def toggle(self) -> None:
        """Play or pause."""
        if self.playing:
            self.pause()
        else:
            self.play()

    def stop(self) -> None:
        """Hold still, at the beginning."""
        if self._player is not None:
            self._player.pause()
            self._player.seek(0)
            self.transport_changed.emit()

    def seek(self, seconds: float) -> None:
        """Go to a place in the file; while nothing plays, the seconds before it are shown in place of the old."""
        if self._player is not None:
            self._player.seek(seconds)
            if not self.playing:
                self._show_before(self.position)
            self.transport_changed.emit()

    def set_loop(self, loop: bool) -> None:
        """Begin again at the end, or not."""
        self.loop = loop
        if self._player is not None:
            self._player.loop = loop
        self.transport_changed.emit()

    def set_volume(self, decibels: float) -> None:
        """Set the loudness of what is heard, -60..0 dB, where -60 is silence."""
        self.volume = min(0.0, max(QUIETEST_DB, float(decibels)))
        if self._player is not None:
            self._player.set_gain(0.0 if self.volume <= QUIETEST_DB else 10 ** (self.volume / 20))
        self.transport_changed.emit()

    def set_channel(self, channel: Channel) -> None:
        """Choose what is analysed of a stereo file; it goes on from the same place."""
        if channel is self.channel:
            return
        before, self.channel = self.channel, channel
        if self._player is not None:
            path, position, playing = self._player.reader.path, self.position, self.playing
            if not self.open(path):
                self.channel = before
            else:
                self.seek(position)
                if playing:
                    self.play()
        self.transport_changed.emit()

    def clear(self) -> None:
        """Forget spectra, averages, sonagram and extremes."""
        self.history.clear()
        self.averages.clear()
        self.cleared.emit()

    def close(self) -> None:
        """Let the file go."""
        if self._player is not None:
            self._player.close()
            self._player = None

    # -- what is found ------------------------------------------------------------------------------------

    def tick(self) -> bool:
        """Gather what has been heard since the last tick; say whether there was anything."""
        if self._player is None:
            return False
        try:
            blocks = self._player.take()
        except EngineError as error:
            self.stop()
            self.failed.emit(str(error))
            return False
        for analysis in blocks:
            self.gather(analysis)
        if self.playing and self._player.finished:
            self.stop()
        return bool(blocks)

    def gather(self, analysis: Analysis) -> None:
        """Take in a block of analysed frames."""
        self.history.append(analysis)
        self.averages.add(analysis)

    def follow(self, seconds: float) -> None:
        """Analyse the file in hand from its beginning up to a time at once, as if it had been played so far."""
        if self._player is None:
            return
        n_wanted = round(min(seconds, self.duration) / FRAME_PERIOD) + (seconds >= self.duration)
        for analysis in self._analyses(0, n_wanted):
            self.gather(analysis)
        self._player.seek(seconds)

    def analyse_again(self) -> None:
        """Analyse what was heard last anew with the preset in force, so that a change shows while nothing plays."""
        first, last = self.history.newest_run(AGAIN)
        if self._player is None or first == last:
            return
        self.history.take_back(last - first)
        self._look_back(first, last)
        self.rewritten.emit(last - first)

    def _show_before(self, seconds: float) -> None:
        last = round(seconds / FRAME_PERIOD)
        self.history.clear()
        self._look_back(max(0, last - AGAIN), last)

    def _look_back(self, first: int, last: int) -> None:
        """Analyse frames that nobody hears into the history; a damaged file is said."""
        try:
            for analysis in self._analyses(first, last):
                self.history.append(analysis)
        except EngineError as error:
            self.failed.emit(str(error))

    def _analyses(self, first: int, last: int) -> Iterator[Analysis]:
        if self._player is not None:
            with SoundReader(self._player.reader.path, self.channel) as reader:
                yield from analyses_between(reader, first, last, self.preset.in_force, pitch=True)

    def explain(self) -> Trace | None:
        """Say why the newest frame was recognised as it was."""
        newest = self.history.newest
        if newest is None:
            return None
        preset = self.preset.in_force
        recogniser = recogniser_of(preset.recogniser, preset.thresholds)
        return recogniser.explain(newest.features, len(newest) - 1)

    def _use_preset(self) -> None:
        if self._player is not None:
            self._player.use(self.preset.in_force)
            if not self.playing:
                self.analyse_again()
