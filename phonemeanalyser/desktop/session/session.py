"""The sound in hand: a file, a microphone, a tone or a spoken text; played or heard, and what is known of it."""

from collections.abc import Callable
from enum import StrEnum
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.session.formant_track import FormantTrack
from phonemeanalyser.desktop.session.label_tiers import LabelTiers
from phonemeanalyser.desktop.session.loudspeaker import Loudspeaker
from phonemeanalyser.desktop.session.microphone import Microphone
from phonemeanalyser.desktop.session.phoneme_writer import PhonemeWriter
from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeanalyser.desktop.session.results import AnalysisResults
from phonemeanalyser.desktop.session.second_preset import SecondPreset
from phonemeanalyser.desktop.session.sonagram_tiles import SonagramTiles
from phonemeanalyser.desktop.session.time_view import TimeSpan, TimeView
from phonemeanalyser.desktop.session.waveform_track import WaveformTrack
from phonemeanalyser.desktop.session.whole_file import WholeFile
from phonemeengine.analyser import Analysis
from phonemeengine.audio.files import SoundReader
from phonemeengine.audio.output import Output, open_output
from phonemeengine.audio.slowed_output import SLOWEST
from phonemeengine.audio.source import Reader
from phonemeengine.audio.tone.reader import ToneReader
from phonemeengine.audio.tone.settings import Tone
from phonemeengine.errors import EngineError
from phonemeengine.inspection.whole_sound import FrameRange
from phonemeengine.live.player import Player
from phonemeengine.presets.ears import for_live_use, while_played
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import FRAME_PERIOD, Channel

QUIETEST_DB = -60.0
"""At this volume and below nothing is heard."""


class SoundSource(StrEnum):
    """Where the sound comes from."""

    FILE = tr_noop("file")
    MICROPHONE = tr_noop("microphone")
    TONE = tr_noop("tone")
    TEXT = tr_noop("text")

    @property
    def live(self) -> bool:
        """Whether nothing is known of the sound before it is heard, and nobody can go through it."""
        return self in {SoundSource.MICROPHONE, SoundSource.TONE}


class Session(QObject):
    """Follows one source at a time and gathers its analysis.

    `poll` moves it on, and whoever draws looks at it afterwards. Only the source in use holds its device.

    Signals
    -------
    opened : another file is in hand, or another source.
    looked_back : what the microphone heard is looked at, or no longer.
    transport_changed : playing, pausing, stopping, recording, loop, volume or channel.
    cleared : everything gathered was forgotten.
    rewritten : the columns of the history from this one on are others now.
    heard : a list of the blocks that were heard since the last tick; see `phonemeengine.analyser.Analysis`.
    sought : the file, or the spoken text, stands elsewhere.
    speech_asked : a text is to be spoken, and `speak` to be called.
    error : a sentence for the user.

    Attributes
    ----------
    may_leave : asked before another file takes the place of the one in hand; what it refuses is not opened.
    """

    opened = Signal()
    looked_back = Signal()
    heard = Signal(list)
    sought = Signal()
    speech_asked = Signal()
    transport_changed = Signal()
    cleared = Signal()
    rewritten = Signal(int)
    error = Signal(str)

    def __init__(
        self, preset: PresetModel, open_device: Callable[[int], Output] = open_output,
        microphone: Microphone | None = None,
    ) -> None:  # fmt: skip
        super().__init__()
        self.preset = preset
        self.results = AnalysisResults(preset)
        self.history, self.averages = self.results.history, self.results.averages
        self.microphone = microphone or Microphone()
        self.writer = PhonemeWriter()
        self.view, self.whole = TimeView(), WholeFile()
        self.sonagram, self.formants, self.waveform = SonagramTiles(), FormantTrack(), WaveformTrack()
        self.labels = LabelTiers(preset.undo_stack)
        self.second = SecondPreset(preset, self.whole)
        self.source = SoundSource.FILE
        self.tone = Tone()
        self.loop = False
        self.volume = 0.0
        self.wanted_channel = Channel.MIX
        self.may_leave: Callable[[], bool] = lambda: True
        self.loudspeaker = Loudspeaker(open_device)
        self.speed = 1.0
        self._file: SoundReader | None = None
        self._past: Path | None = None
        self._left_at = 0.0
        self._told = ""
        self._player: Player | None = None
        self._tone_reader: ToneReader | None = None
        self._speak_again: Callable[[], Reader] | None = None
        preset.changed.connect(self._use_preset)
        self.loudspeaker.chosen.connect(self._change_loudspeaker)
        self.microphone.error.connect(self.error)
        self.writer.error.connect(self.error)
        self.labels.error.connect(self.error)
        self.second.error.connect(self._tell_once)
        for model in (self.whole, self.sonagram, self.formants, self.waveform):
            model.error.connect(self._tell_once)
        self.view.moved.connect(self._look)
        self.sonagram_is_filtered = False
        self.results.error.connect(self.error)
        self.results.cleared.connect(self.cleared)
        self.results.rewritten.connect(self.rewritten)

    # -- what it is ---------------------------------------------------------------------------------------

    @property
    def path(self) -> Path | None:
        """The file in hand; it stays so while another source is in use."""
        return self._file.path if self._file else None

    @property
    def looks_back(self) -> bool:
        """Whether what the microphone heard so far is looked at, as a file."""
        return self._past is not None

    @property
    def seen_sound(self) -> tuple[Path, Channel] | None:
        """What is seen on its own time, and which channel: the file in hand, or what a microphone heard."""
        if self._past is not None:
            return self._past, Channel.MIX
        return None if self._file is None else (self._file.path, self._file.channel)

    @property
    def duration(self) -> float:
        """Seconds of the file in hand, or of what is spoken so far of a text; 0 while another source is in use."""
        if self.source is SoundSource.TEXT:
            return self._player.reader.duration if self._player else 0.0
        return self._file.duration if self._file and self.source is SoundSource.FILE else 0.0

    @property
    def position(self) -> float:
        """Seconds from the beginning to what is heard."""
        if self.source is SoundSource.MICROPHONE:
            return self.microphone.listener.seconds
        if self.source is SoundSource.TONE:
            return self._player.position if self._player else 0.0
        return min(self._player.position, self.duration) if self._player else 0.0

    @property
    def playing(self) -> bool:
        """Whether sound is going on, or is listened for."""
        if self.source is SoundSource.MICROPHONE:
            return self.microphone.active
        return self._player is not None and self._player.playing

    @property
    def busy(self) -> bool:
        """Whether more of the file in hand is being found or measured."""
        return any(
            model.busy
            for model in (self.results, self.whole, self.second.whole, self.sonagram, self.formants, self.waveform)
        )

    @property
    def input_silent(self) -> bool:
        """Whether the microphone should be heard, and nothing comes from it: what was heard last is no news then."""
        return self.source is SoundSource.MICROPHONE and self.microphone.active and not self.microphone.listening

    @property
    def name(self) -> str:
        """What is in hand: the file's name, the microphone, the tone or the text."""
        if self.source is SoundSource.FILE:
            return self._file.path.name if self._file else tr("no sound")
        return tr(self.source.value)

    @property
    def description(self) -> str:
        """What is in hand, in words: rate and channels of a file, the microphone's state, the kind of tone."""
        if self.source is SoundSource.MICROPHONE:
            return self.microphone.words
        if self.source is SoundSource.TONE:
            return tr(self.tone.kind.replace("_", " "))
        if self.source is SoundSource.TEXT:
            return tr("a text that a voice speaks")
        if self._file is None:
            return tr("no sound")
        n = self._file.n_file_channels
        channels = {1: "mono", 2: "stereo"}.get(n, tr("{n} channels").format(n=n))
        return ", ".join([f"{self._file.file_rate:,} Hz".replace(",", " "), channels, *self._file.known_notes])

    @property
    def output_name(self) -> str:
        """What the sound is heard on."""
        return self._player.output_name if self._player else ""

    @property
    def has_card(self) -> bool:
        """Whether a sound card plays."""
        return self._player is not None and self._player.has_card

    @property
    def heard_with(self) -> Preset:
        """What the sound in hand is heard with: a file, while it plays, by the ear that the preset has for those."""
        if self.source is SoundSource.MICROPHONE:
            return for_live_use(self.preset.in_force)
        return self.preset.in_force if self._player is None else self._player.preset

    @property
    def n_dropped(self) -> int:
        """Frames that were analysed but never shown, since the source is in use."""
        return self._player.n_dropped if self._player else self.microphone.listener.n_dropped

    @property
    def channel(self) -> Channel:
        """What is analysed of the file in hand: the channel that is wanted, or the mix of a file that lacks it."""
        return self._file.channel if self._file else self.wanted_channel

    @property
    def n_channels(self) -> int:
        """Channels of the file in hand; 2 where there is none yet."""
        return self._file.n_file_channels if self._file else 2

    @property
    def cut_off(self) -> str:
        """What the file in hand lacks, as a sentence; empty where it is whole."""
        return f"{self._file.path.name}: {self._file.cut_off}" if self._file and self._file.cut_off else ""

    # -- where the sound comes from -----------------------------------------------------------------------

    def open(self, path: Path) -> bool:
        """Open a file and stand at its beginning; a file that cannot be read leaves everything as it was.

        So does one that `may_leave` refuses. Of a file without the channel that is wanted, the mix is analysed.
        """
        return self._open(path, None)

    def _open(self, path: Path, channel: Channel | None) -> bool:
        try:
            file = SoundReader(path, channel or Channel.MIX)
            if channel is None and self.wanted_channel.number <= file.n_file_channels:
                file.choose(self.wanted_channel)
        except EngineError as error:
            self.error.emit(str(error))
            return False
        if path != self.path and not self.may_leave():
            file.close()
            return False
        is_another = path != self.path
        self._detach()
        self._told = ""
        self.source = SoundSource.FILE
        self._file = file
        self._attach(Player(file, while_played(self.preset.in_force), self.loudspeaker.open))
        self._see(file, self.preset.in_force)
        if is_another:
            self.labels.follow(path, file.duration)
        return True

    def set_source(self, source: SoundSource) -> None:
        """Follow a file, which goes on from where it was left, or what is heard at once: microphone, tone or text."""
        if source is self.source:
            if source is SoundSource.TONE and not self.playing:
                self.play()
            return
        if self.source is SoundSource.FILE:
            self._left_at = self.position
        if source is SoundSource.FILE and self.path is not None and self.open(self.path):
            self.seek(self._left_at)
            return
        self._detach()
        self.source = source
        self._forget(tr_noop("Opening"))
        if source is SoundSource.TONE:
            self._tone_reader = ToneReader(self.tone)
            self._attach(Player(self._tone_reader, self.preset.in_force, self.loudspeaker.open))
        if source is SoundSource.MICROPHONE:
            self.microphone.refresh_devices()
        if source is not SoundSource.FILE:
            self.play()
        self.opened.emit()

    def speak(self, speech: Reader, again: Callable[[], Reader]) -> None:
        """Play a spoken text, which may be spoken while it is played; it is closed when another sound is in hand.

        Parameters
        ----------
        again : has the same text spoken once more, from its beginning.
        """
        if self.source is SoundSource.FILE:
            self._left_at = self.position
        self._detach()
        self.source = SoundSource.TEXT
        self._speak_again = again
        self._attach(Player(speech, self.preset.in_force, self.loudspeaker.open))
        self.play()

    def player_of(self, reader: Reader) -> Player:
        """Return a player of another sound, as loud as the one in hand; who asks for it closes it."""
        player = Player(reader, while_played(self.preset.in_force), self.loudspeaker.open)
        player.set_gain(self._gain)
        return player

    def look_back(self, on: bool) -> None:
        """Look at all that the microphone heard since Clear, as at a file, or no longer; it goes on listening."""
        if not on:
            self._leave_past()
            return
        past = None if self.microphone.heard is None else self.microphone.heard.snapshot()
        if self.source is not SoundSource.MICROPHONE or past is None:
            failure = self.microphone.heard.failure if self.microphone.heard is not None else None
            self.error.emit(failure or tr("The microphone heard nothing yet; listen to it, then look back."))
            return
        with SoundReader(past) as reader:
            self._past = past
            self._see(reader, self.preset.in_force)
            self.view.show_end()
        self.looked_back.emit()

    def _leave_past(self) -> None:
        if self._past is not None:
            self._past = None
            for model in (self.whole, self.second.whole, self.sonagram, self.formants, self.waveform):
                model.leave()
            self.view.open(0.0)
            self.looked_back.emit()

    def _see(self, sound: SoundReader, preset: Preset) -> None:
        """Have a sound seen on its own time."""
        path, channel = sound.path, sound.channel
        self.view.open(sound.duration)
        for track in (self.sonagram, self.formants, self.waveform):
            track.open(lambda: SoundReader(path, channel), sound.duration)
        self.whole.open(sound, preset)
        self.second.follow()
        self._look()

    def set_tone(self, tone: Tone) -> None:
        """Generate another tone, which is heard at once."""
        self.tone = tone
        if self._tone_reader is not None:
            self._tone_reader.set_tone(tone)
            if not self.playing:
                self.play()
        self.transport_changed.emit()

    def _attach(self, player: Player) -> None:
        player.loop = self.loop
        self._player = player
        player.set_speed(self.speed)
        self.set_volume(self.volume)
        self._forget(tr_noop("Opening"))
        self.opened.emit()
        self.transport_changed.emit()

    def _detach(self) -> None:
        """Let the source in use go: some cards serve one stream at a time."""
        self.microphone.stop()
        self._leave_past()
        for model in (self.whole, self.second.whole, self.sonagram, self.formants, self.waveform):
            model.leave()
        self.view.open(0.0)
        self._tone_reader = None
        if self._player is not None:
            self._player.close()
            self._player = None

    # -- transport ----------------------------------------------------------------------------------------

    def play(self) -> None:
        """Play or listen; the averaged spectrum begins anew when that is the beginning."""
        if self.source is SoundSource.TEXT and self._player is None:
            self.speech_asked.emit()
            return
        if self.source is not SoundSource.MICROPHONE and self._player is None:
            return
        if self.position == 0:
            self.averages.begin(tr_noop("Play"), self.name)
        if self.source is SoundSource.MICROPHONE:
            self.microphone.listen(self.preset.in_force)
        elif self._player is not None:
            self._player.play()
        self.transport_changed.emit()

    def pause(self) -> None:
        """Hold still; a microphone is let go, and a recording ends."""
        if self.source is SoundSource.MICROPHONE:
            self.microphone.stop()
        elif self._player is not None:
            self._player.pause()
        self.transport_changed.emit()

    def toggle(self) -> None:
        """Play or pause."""
        if self.playing:
            self.pause()
        else:
            self.play()

    def stop(self) -> None:
        """Hold still; a file, or a spoken text, stands at its beginning."""
        self.pause()
        if not self.source.live and self._player is not None:
            self._player.seek(0)
            self.sought.emit()
        self.transport_changed.emit()

    def toggle_recording(self) -> None:
        """Record what the microphone hears, or end that; another source makes room for the microphone.

        The averaged spectrum begins anew with a recording.
        """
        if self.microphone.recording:
            self.microphone.end_recording()
        else:
            self.set_source(SoundSource.MICROPHONE)
            self.play()
            self.microphone.begin_recording()
            if self.microphone.recording:
                self.averages.begin(tr_noop("Record"), self.name)
        self.transport_changed.emit()

    def seek(self, seconds: float) -> None:
        """Go to a place in the file, or in what is spoken of a text.

        While nothing plays, the seconds of the file before it are shown in place of the old.
        """
        if self._player is not None and not self.source.live:
            self._player.seek(seconds)
            if not self.playing and self._file is not None and self.source is SoundSource.FILE:
                self.results.show_before(self._file.path, self.channel, self.position)
            self.sought.emit()
            self.transport_changed.emit()

    def play_stretch(self, span: TimeSpan, *, loop: bool | None = None) -> None:
        """Play a stretch of the file, or of a spoken text; it stands at its beginning afterwards.

        Parameters
        ----------
        loop : whether over and over; None for as it is set.
        """
        if self._player is not None and not self.source.live:
            if loop is not None:
                self.set_loop(loop)
            self._player.play_stretch(*span)
            self.sought.emit()
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
            self._player.set_gain(self._gain)
        self.transport_changed.emit()

    def set_speed(self, speed: float) -> None:
        """Play slower, 0.25..1, with the pitch kept; what is recognised stays as it is."""
        self.speed = min(1.0, max(SLOWEST, float(speed)))
        if self._player is not None:
            self._player.set_speed(self.speed)
        self.transport_changed.emit()

    def _change_loudspeaker(self) -> None:
        if self._player is not None:
            self._player.change_device(self.loudspeaker.open)
        self.transport_changed.emit()

    @property
    def _gain(self) -> float:
        return 0.0 if self.volume <= QUIETEST_DB else 10 ** (self.volume / 20)

    def set_channel(self, channel: Channel) -> None:
        """Choose what is analysed of files of several channels; the one in hand goes on from the same place."""
        if channel is self.wanted_channel is self.channel:
            return
        if self._file is None or self.source is not SoundSource.FILE:
            self.wanted_channel = channel
        else:
            position, playing = self.position, self.playing
            if self._open(self._file.path, channel):
                self.wanted_channel = channel
                self.seek(position)
                if playing:
                    self.play()
        self.transport_changed.emit()

    def show_filtered(self, on: bool) -> None:
        """Show the file's sonagram as it is after the filters that are on, or as it is in the file."""
        self.sonagram_is_filtered = on
        self.sonagram.show_filtered(self.preset.in_force.settings if on else None)

    def clear(self) -> None:
        """Forget spectra, averages, sonagram and extremes."""
        self._leave_past()
        self.microphone.forget_heard()
        self._forget(tr_noop("Clear"))

    def close(self) -> None:
        """Let everything go."""
        self._detach()
        self.microphone.close()
        self.writer.close()
        for model in (self.results, self.whole, self.second, self.sonagram, self.formants, self.waveform):
            model.close()

    def write_phonemes(self, target: Path) -> None:
        """Write the phonemes of the whole file in hand, or text, with the preset in force; does not wait."""
        path, channel, again = self.path, self.channel, self._speak_again
        if self.source is SoundSource.TEXT and again is not None:
            self.writer.write(self.name, again, self.preset.in_force, target)
        elif path is not None:
            self.writer.write(path.name, lambda: SoundReader(path, channel), self.preset.in_force, target)

    # -- what is found ------------------------------------------------------------------------------------

    def poll(self) -> bool:
        """Gather what has been heard since the last tick; say whether there was anything."""
        try:
            blocks = (self._player or self.microphone.listener).take_analyses()
        except EngineError as error:
            self.stop()
            self._tell_once(str(error))
            return False
        for analysis in blocks:
            self.results.add(analysis)
        if blocks:
            self.heard.emit(blocks)
        if self._player is not None and self.playing and self._player.finished:
            self._end(self._player)
        return bool(blocks)

    def _end(self, player: Player) -> None:
        """Hold still at the beginning of what was played to its end."""
        stretch = player.stretch
        if stretch is None:
            self.stop()
        else:
            self.pause()
            self.seek(stretch[0])

    def analyse_until(self, seconds: float) -> None:
        """Analyse the file in hand from its beginning up to a time at once, as if it had been played so far."""
        if self._player is None or self._file is None:
            return
        n_frames = round(min(seconds, self.duration) / FRAME_PERIOD) + (seconds >= self.duration)
        self.results.add_file_start(self._file.path, self.channel, n_frames)
        self._player.seek(seconds)
        self.sought.emit()

    def upcoming(self) -> list[tuple[float, Analysis]]:
        """Return what is known of the sound before it is heard, each block with the seconds until then."""
        return self._player.upcoming() if self._player is not None and not self.source.live else []

    def _look(self) -> None:
        """Have what is seen of the file found first."""
        start, end = (round(time / FRAME_PERIOD) for time in self.view.seen)
        self.whole.in_view = self.second.whole.in_view = FrameRange(start, end)

    def _tell_once(self, sentence: str) -> None:
        """Say what is wrong with the sound in hand: who plays it and who analyses it whole find the same."""
        if sentence != self._told:
            self._told = sentence
            self.error.emit(sentence)

    def _forget(self, cause: str) -> None:
        self.averages.begin(cause, self.name)
        self.results.clear()

    def _use_preset(self) -> None:
        self.microphone.set_preset(self.preset.in_force)
        self.whole.use_preset(self.preset.in_force)
        self.second.follow()
        self.show_filtered(self.sonagram_is_filtered)
        if self._player is not None:
            is_file = self.source is SoundSource.FILE
            self._player.set_preset(while_played(self.preset.in_force) if is_file else self.preset.in_force)
            if not self.playing and self.source is SoundSource.FILE and self._file is not None:
                self.results.analyse_again(self._file.path, self.channel)
