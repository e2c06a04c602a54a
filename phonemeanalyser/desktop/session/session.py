"""The current sound: where it comes from, playing and recording it, and what is known of it."""

from collections.abc import Callable, Iterator
from contextlib import closing
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.engine_words import tr_engine
from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.session.curves import CurveTable
from phonemeanalyser.desktop.session.label_tiers import LabelTiers
from phonemeanalyser.desktop.session.microphone import Microphone
from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeanalyser.desktop.session.results import AnalysisResults
from phonemeanalyser.desktop.session.rules import RuleModel
from phonemeanalyser.desktop.session.score import ScoreModel
from phonemeanalyser.desktop.session.seen_sound import SeenSound
from phonemeanalyser.desktop.session.seen_tracks import LiveFeelings
from phonemeanalyser.desktop.session.serving import ServerModel
from phonemeanalyser.desktop.session.sonagram_tiles import LiveSonagram
from phonemeanalyser.desktop.session.sources import FileSource, Playback, Source, SourceKind, source_of
from phonemeanalyser.desktop.session.time_view import TimeSpan
from phonemeanalyser.desktop.tasks import TaskQueue
from phonemeengine.analyser import BLOCK, analyse_blocks
from phonemeengine.arrays import Float32Array
from phonemeengine.audio.files import SoundReader
from phonemeengine.audio.output import Output, Reader, open_output
from phonemeengine.errors import EngineError
from phonemeengine.execution import Progress, report_progress
from phonemeengine.labels.files import write_labels
from phonemeengine.presets.model_choice import for_files, model_in_words
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.segments import SegmentBuilder, labels_of_segments
from phonemeengine.settings import FRAME_PERIOD, HOP, Channel


class Session(QObject):
    """Follows one source of sound at a time and gathers its analysis.

    `poll` moves it on, and views draw its state afterwards. Only the source in use holds its device.

    Signals
    -------
    opened : another file is open, or another source.
    transport_changed : playing, pausing, stopping, recording, the channel, or how sound is played.
    cleared : everything gathered was forgotten.
    rewritten : the columns of the history from this one on are others now.
    analysed : a list of the blocks that were played since the last tick; see `phonemeengine.analyser.Analysis`.
    sought : the file, or the spoken text, stands elsewhere.
    error : a sentence for the user.

    Attributes
    ----------
    source : where the sound comes from.
    file : the current file, which stays so while another source is in use; None where there is none.
    wanted_channel : what is analysed of files of several channels, where they have it.
    playback : how sound is played.
    microphone : listens and records.
    results : what was recognised in what was played; `history` and `averages` are of it.
    seen : the sound that is seen on its own time; `view`, `whole`, `second`, `sonagram`, `formants`, `waveform` and
        `feelings` are of it.
    live, live_feelings : sonagram and formants of what was played lately, and how the voice sounds in it.
    curves : averaged spectra of any sounds, side by side.
    labels : of the current file.
    score : how right what is recognised is beside labels.
    rules : of the preset in use.
    writer : writes phonemes of whole sounds.
    server : recognises for other programs.
    may_leave : asked before another file takes the place of the current one; what it refuses is not opened.
    say : asked to have a text spoken, which `take` then gets, when the user chooses the text as the source.
    """

    opened = Signal()
    analysed = Signal(list)
    sought = Signal()
    transport_changed = Signal()
    cleared = Signal()
    rewritten = Signal(int)
    error = Signal(str)

    def __init__(
        self,
        preset: PresetModel,
        open_device: Callable[[int], Output] = open_output,
        microphone: Microphone | None = None,
    ) -> None:
        super().__init__()
        self.preset = preset
        self.playback, self.microphone = Playback(open_device), microphone or Microphone()
        self.results, self.seen = AnalysisResults(preset), SeenSound(preset)
        self.labels, self.writer = LabelTiers(preset.undo_stack), PhonemeWriter()
        self.curves, self.server = CurveTable(preset), ServerModel()
        self.score = ScoreModel(preset, self.seen, self.labels)
        self.rules = RuleModel(preset, self.seen, self.labels)
        self.history, self.averages = self.results.history, self.results.averages
        self.view, self.whole, self.second = self.seen.view, self.seen.whole, self.seen.second
        self.sonagram, self.formants, self.waveform = self.seen.sonagram, self.seen.formants, self.seen.waveform
        self.feelings = self.seen.feelings
        self.source = Source(preset.in_force)
        self.file: SoundReader | None = None
        self.wanted_channel = Channel.MIX
        self.may_leave: Callable[[], bool] = lambda: True
        self.say: Callable[[], None] = lambda: None
        self._left_at = 0.0
        self._told = ""
        preset.changed.connect(self._use_preset)
        self.playback.changed.connect(self._use_playback)
        for part in (self.microphone, self.writer, self.labels, self.rules, self.score, self.results, self.curves):
            part.error.connect(self.error)
        self.seen.error.connect(self._tell_once)
        self.live = LiveSonagram(self.history, self.sonagram)
        self.live_feelings = LiveFeelings(self.history)
        for live in (self.live, self.live_feelings):
            self.results.cleared.connect(live.forget)
            self.results.rewritten.connect(live.forget)
        self.results.cleared.connect(self.cleared)
        self.results.rewritten.connect(self.rewritten)

    # -- what it is ---------------------------------------------------------------------------------------

    @property
    def path(self) -> Path | None:
        """The path of the current file."""
        return None if self.file is None else self.file.path

    @property
    def channel(self) -> Channel:
        """What is analysed of the current file: the channel that is wanted, or the mix of a file that lacks it."""
        return self.wanted_channel if self.file is None else self.file.channel

    @property
    def busy(self) -> bool:
        """Whether more of the current sound is being found or measured."""
        return self.results.busy or self.seen.busy

    # -- where the sound comes from -----------------------------------------------------------------------

    def open(self, path: Path, channel: Channel | None = None) -> bool:
        """Open a file and stand at its beginning; a file that cannot be read leaves everything as it was.

        So does one that `may_leave` refuses, or that lacks the channel. Without one, the channel that is wanted is
        analysed, or the mix of a file that lacks it.
        """
        try:
            file = SoundReader(path, channel or Channel.MIX)
            if channel is None and self.wanted_channel.number <= file.n_file_channels:
                file.choose(self.wanted_channel)
        except EngineError as error:
            self.error.emit(str(error))
            return False
        # what is known of a file that has become longer or shorter on disk belongs to another sound, too
        is_another = path != self.path or self.file is None or file.duration != self.file.duration
        if is_another and not self.may_leave():
            file.close()
            return False
        self._told, self.file = "", file
        self.take(lambda: FileSource(self.preset.in_force, self.playback, file))
        self.seen.open(file)
        if is_another:
            self.labels.follow(path, file.duration)
        return True

    def set_source(self, kind: SourceKind) -> None:
        """Follow the file, from where it was left, or live sound: microphone, tone or text.

        A tone waits until it is played, since it may be loud.
        """
        if kind is self.source.kind:
            return
        if kind is SourceKind.FILE and self.path is None:
            self.leave_sound()
        elif kind is SourceKind.FILE and self.path is not None and self.open(self.path):
            self.seek(self._left_at)
        else:
            self.take(lambda: self._source_of(kind))
            if kind is not SourceKind.TONE:
                self.play()

    def _source_of(self, kind: SourceKind) -> Source:
        return source_of(kind, self.preset.in_force, self.playback, self.microphone, self.say)

    def take(self, make: Callable[[], Source]) -> None:
        """Follow another source, made once the one in use is let go, since some cards serve one stream at a time."""
        if self.source.path is not None:
            self._left_at = self.source.position
        self.source.close()
        self.seen.leave()
        self.source = make()
        self.results.clear(tr_noop("opening"), self.source.name)
        self.opened.emit()
        self.transport_changed.emit()

    def leave_sound(self) -> None:
        """Have no sound open, as before the first one."""
        self.file, self._told = None, ""
        self.labels.follow(None, 0.0)
        self.take(lambda: self._source_of(SourceKind.FILE))

    def look_back(self, on: bool) -> None:
        """Look at all that the microphone recorded since Clear, as at a file, or no longer; it goes on listening."""
        if not on:
            if self.seen.looks_back:
                self.seen.leave()
            return
        recorded = self.microphone.since_clear if self.source.kind is SourceKind.MICROPHONE else None
        past = None if recorded is None else recorded.snapshot()
        if past is None:
            failure = None if recorded is None else recorded.failure
            self.error.emit(
                failure
                or tr(
                    "The history is empty, since the microphone was not used yet. Press "
                    "Space to listen, then try again."
                )
            )
            return
        with SoundReader(past) as reader:
            self.seen.open(reader, looks_back=True)

    # -- transport ----------------------------------------------------------------------------------------

    def play(self) -> None:
        """Play or listen; the averaged spectrum begins anew when that is the beginning."""
        from_start = self.source.position == 0
        if self.source.play():
            if from_start:
                self.averages.begin(tr_noop("Play"), self.source.name)
            self.transport_changed.emit()

    def pause(self) -> None:
        """Hold still; a microphone is let go, and a recording ends."""
        self.source.pause()
        self.transport_changed.emit()

    def toggle(self) -> None:
        """Play or pause."""
        if self.source.playing:
            self.pause()
        else:
            self.play()

    def stop(self) -> None:
        """Hold still; a file, or a spoken text, stands at its beginning."""
        self.pause()
        if self.source.seekable:
            self.source.seek(0)
            self.sought.emit()
        self.transport_changed.emit()

    def toggle_recording(self) -> None:
        """Record the microphone, or end that; another source gives way to the microphone.

        The averaged spectrum begins anew with a recording.
        """
        if self.microphone.recording:
            self.microphone.end_recording()
        else:
            self.set_source(SourceKind.MICROPHONE)
            self.play()
            self.microphone.begin_recording()
            if self.microphone.recording:
                self.averages.begin(tr_noop("Record"), self.source.name)
        self.transport_changed.emit()

    def seek(self, seconds: float) -> None:
        """Go to a place in the file, or in what is spoken of a text.

        While nothing plays, the seconds of the file before it are shown in place of the old.
        """
        if self.source.seekable:
            self.source.seek(seconds)
            if not self.source.playing and self.source.path is not None:
                self.results.show_before(self.source.path, self.channel, self.source.position)
            self.sought.emit()
            self.transport_changed.emit()

    def show_segment(self, span: TimeSpan, at: float) -> None:
        """Select a segment of the file, go to a time in it, and have it seen with something around it."""
        self.seek(at)
        self.view.select(span)
        self.view.reveal(span)

    def step(self, seconds: float) -> None:
        """Go forwards, or backwards, by some seconds."""
        self.seek(self.source.position + seconds)

    def play_stretch(self, span: TimeSpan, *, loop: bool | None = None) -> None:
        """Play a segment of the file, or of a spoken text; it stands at its beginning afterwards.

        Parameters
        ----------
        loop : whether over and over; None for as it is set.
        """
        if self.source.seekable:
            if loop is not None:
                self.playback.set_loop(loop)
            self.source.play_stretch(*span)
            self.sought.emit()
            self.transport_changed.emit()

    def set_channel(self, channel: Channel) -> None:
        """Choose what is analysed of files of several channels; the current one goes on from the same place."""
        if channel is self.wanted_channel is self.channel:
            return
        path, position, playing = self.source.path, self.source.position, self.source.playing
        if path is None:
            self.wanted_channel = channel
        elif self.open(path, channel):
            self.wanted_channel = channel
            self.seek(position)
            if playing:
                self.play()
        self.transport_changed.emit()

    def clear(self) -> None:
        """Forget spectra, averages, sonagram and extremes."""
        self.look_back(False)
        self.microphone.forget_recorded()
        self.results.clear(tr_noop("Clear"), self.source.name)

    def close(self) -> None:
        """Let everything go."""
        self.source.close()
        self.source = self._source_of(SourceKind.FILE)
        for part in (
            self.rules,
            self.score,
            self.seen,
            self.microphone,
            self.writer,
            self.results,
            self.curves,
            self.server,
        ):
            part.close()

    # -- what is found ------------------------------------------------------------------------------------

    def poll(self) -> bool:
        """Gather what has been played since the last tick; say whether there was anything.

        What was played to its end holds still at its beginning.
        """
        try:
            blocks = self.source.take_analyses()
        except EngineError as error:
            self.stop()
            self._tell_once(str(error))
            return False
        for analysis in blocks:
            self.results.add(analysis)
        if blocks:
            self.analysed.emit(blocks)
        player = self.source.player
        if player is not None and player.playing and player.finished:
            if player.stretch is None:
                self.stop()
            else:
                start, _end = player.stretch
                self.pause()
                self.seek(start)
        return bool(blocks)

    def analyse_until(self, seconds: float) -> None:
        """Analyse the current file from its beginning up to a time at once, as if it had been played so far."""
        path, duration = self.source.path, self.source.duration
        if path is not None:
            n_frames = round(min(seconds, duration) / FRAME_PERIOD) + (seconds >= duration)
            self.results.add_file_start(path, self.channel, n_frames)
            self.source.seek(seconds)
            self.sought.emit()

    def _use_preset(self) -> None:
        self.seen.use_preset()
        self.source.set_preset(self.preset.in_force)
        if self.source.path is not None and not self.source.playing:
            self.results.analyse_again(self.source.path, self.channel)

    def _use_playback(self) -> None:
        self.source.follow(self.playback)
        self.transport_changed.emit()

    def _tell_once(self, sentence: str) -> None:
        """Say what is wrong with the current sound: who plays it and who analyses it whole find the same."""
        if sentence != self._told:
            self._told = sentence
            self.error.emit(sentence)


AT_ONCE = BLOCK * HOP
"""Samples that are read at a time."""


class PhonemeWriter(QObject):
    """Analyses sounds in the background and writes what was found.

    Signals
    -------
    info : a sentence for the user about something that goes well.
    error : a sentence for the user.
    """

    info = Signal(str)
    error = Signal(str)

    def __init__(self) -> None:
        super().__init__()
        self._work = TaskQueue(self.error.emit)

    @property
    def busy(self) -> bool:
        """Whether there are phonemes that are not written yet."""
        return self._work.busy

    def write(self, name: str, open_sound: Callable[[], Reader], preset: Preset, target: Path) -> None:
        """Write the phonemes that a preset recognises in a sound.

        Parameters
        ----------
        name : of the sound, for people.
        open_sound : gives it from its beginning.
        target : its ending says in which format: .TextGrid, .txt (Audacity) or .csv (the corpus format).
        """
        self.info.emit(
            tr("Recognising the phonemes of {name} and saving them as {target}…").format(
                name=name, target=target.name
            )
        )
        self._work.submit(
            lambda progress: _write(open_sound, preset, target, progress),
            lambda chosen: self._tell(name, target, chosen),
        )

    def _tell(self, name: str, target: Path, chosen: Preset) -> None:
        self.info.emit(
            tr("Phonemes of {name} saved as {target}. Model: {model}.").format(
                name=name, target=target, model=tr_engine(model_in_words(chosen))
            )
        )
        for warning in chosen.warnings:
            self.error.emit(f"{name}: {warning}")

    def close(self) -> None:
        """Wait until what was asked for is written."""
        self._work.finish()


def _write(open_sound: Callable[[], Reader], preset: Preset, target: Path, progress: Progress) -> Preset:
    """Write the phonemes of a sound; return the preset that recognised them."""
    preset = for_files(preset)
    with closing(open_sound()) as reader:
        joiner, segments = SegmentBuilder(), []
        for analysis in analyse_blocks(_blocks(reader, progress), preset):
            segments += joiner.extend(analysis.phonemes, analysis.intensities)
        segments += joiner.finish(reader.duration)
        write_labels(labels_of_segments(segments), target, duration=reader.duration)
    return preset


def _blocks(reader: Reader, progress: Progress) -> Iterator[Float32Array]:
    """Return what is recognised in a sound, whose length is known at its end at the latest."""
    n = 0
    while len(block := reader.read(AT_ONCE)):
        n += len(block)
        report_progress(progress, n / reader.n_samples)
        yield reader.mono(block)
