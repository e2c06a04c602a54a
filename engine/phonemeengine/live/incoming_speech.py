"""Speech that arrives in chunks, and its phonemes and words, at most 60 ms after each chunk."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from phonemeengine.alignment.evidence import evidence_of
from phonemeengine.alignment.growing import GrowingAligner, GrownWords
from phonemeengine.analyser import Analyser, Analysis, concatenate_analyses, push_together
from phonemeengine.arrays import Float32Array
from phonemeengine.audio.incoming import IncomingSound, StreamFormat
from phonemeengine.errors import EngineError
from phonemeengine.features.feeling import NO_FEELINGS, FeelingEstimator, FeltFrames
from phonemeengine.mouth.exports.viseme_events import EventService, messages_of
from phonemeengine.mouth.morpher import Morpher
from phonemeengine.mouth.table import MouthTable, load_table
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.model_choice import for_live_use, with_small_network
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.learned import real_time_look_ahead
from phonemeengine.recognition.spec import spec_of
from phonemeengine.settings import FRAME_PERIOD, HOP, SAMPLE_RATE, WINDOW, ModelKind
from phonemeengine.text.pronunciation import ScriptWord

MOST_LATE = 0.06
"""Seconds from when the last sample of a frame has come to when it is known what it is, work included."""
WORK = 0.005
"""Seconds of these that are left for the work."""
BEYOND = (WINDOW - HOP) / 2 / SAMPLE_RATE
"""Seconds by which the window of a frame reaches beyond its end."""
LOOK = 25
"""Frames from one look at the words of the text to the next."""


@dataclass(frozen=True)
class RecognisedPiece:
    """What is known since a piece came.

    Attributes
    ----------
    analysis : the frames that it completed; often none.
    weights : of the movestates of the mouth table when each frame begins, float32, shape (n_frames, n_movestates);
        None without a table.
    words : what is known of the words of the text by now; None where that was not looked up again.
    feelings : how the voice sounds in the frames, see `FeelingEstimator`; none where that was not asked for.
    events : what a speech service would send of the visemes that begin in the frames; none where none was named.
    """

    analysis: Analysis
    weights: Float32Array | None = None
    words: GrownWords | None = None
    feelings: FeltFrames = field(default_factory=lambda: NO_FEELINGS)
    events: Sequence[str] = ()


class VisemeEvents:
    """Follows a sound, and says of each viseme when it begins.

    Parameters
    ----------
    service : whose events these are.
    """

    def __init__(self, service: EventService) -> None:
        self._service, self._table = service, load_table(service)
        self._last = ""

    def follow(self, analysis: Analysis) -> list[str]:
        """Return what the service would send of the next frames; mostly nothing."""
        starts = []
        for k, (phoneme, phone) in enumerate(zip(analysis.phonemes.tolist(), analysis.viseme_phones, strict=True)):
            viseme = self._table.shape_of(Phoneme(phoneme), phone)
            if viseme != self._last:
                starts.append(((analysis.start + k) * FRAME_PERIOD, viseme))
                self._last = viseme
        return messages_of(self._service, starts)


class IncomingSpeech:
    """Follows one sound, and tells frame by frame what is said.

    Parameters
    ----------
    preset : what to recognise with; it looks ahead only as far as 60 ms allow.
    form : what the bytes of the sound are.
    table : the mouth that moves with it.
    with_text : whether words of a text will come, before what says them or soon after.
    felt : whether the feeling in the voice is estimated, too.
    service : the speech service whose messages tell of visemes; None for none.

    Raises
    ------
    EngineError : the preset's recogniser cannot be made, or the format cannot be read here.

    Attributes
    ----------
    analyser : what analyses it.
    is_foreign : whether a recogniser of another package does.
    n_unlooked : frames in which no words of the text have been looked for yet.
    may_have_encoder : whether the preset's real-time model can be used for it.
    was_without_encoder : whether the small network alone has recognised though another model could have.
    """

    def __init__(
        self,
        preset: Preset,
        form: StreamFormat,
        table: MouthTable | None = None,
        *,
        with_text: bool = False,
        felt: bool = False,
        service: EventService | None = None,
    ) -> None:
        self._sound, self._preset = IncomingSound(form), preset
        self.analyser = Analyser(in_time(preset, self._sound.delay), phonemes_only=True)
        self.may_have_encoder, self.was_without_encoder = self.has_encoder, False
        self.is_foreign = spec_of(preset.recogniser).entry is not None
        self._morpher = Morpher(table) if table is not None else None
        self._aligner = GrowingAligner() if with_text else None
        self._feeling = FeelingEstimator() if felt else None
        self._events = None if service is None else VisemeEvents(service)
        self._unlooked: list[Analysis] = []
        self.n_unlooked = 0

    @property
    def seconds(self) -> float:
        """How much sound has come."""
        return self._sound.seconds

    @property
    def n_silenced(self) -> int:
        """How many values were no finite numbers, and were taken as 0."""
        return self._sound.n_silenced

    @property
    def latency(self) -> float:
        """From the last sample of a frame to its phoneme, without the work, seconds."""
        return BEYOND + self._sound.delay + self.analyser.recogniser.look_ahead * FRAME_PERIOD

    @property
    def has_encoder(self) -> bool:
        """Whether the real-time model recognises, with the small network."""
        return self.analyser.preset.model_kind is ModelKind.ENCODER

    def use_encoder(self, *, on: bool) -> None:
        """Have the real-time model recognise from the next frame on, or the small network alone, which costs a third.

        No frame is lost. It is for sounds that may have the real-time model.
        """
        preset = self._preset if on else replace(self._preset, live_model=ModelKind.REAL_TIME)
        self.analyser.set_preset(in_time(preset, self._sound.delay))
        self.was_without_encoder |= not on

    @property
    def is_other_text(self) -> bool:
        """Whether another text is said, as far as that is known by now."""
        return self._aligner is not None and self._aligner.fit.is_wrong

    def add_words(self, words: Sequence[ScriptWord]) -> None:
        """Take the next words of the text, see `words_of`; it was announced when this was made.

        Raises
        ------
        TextError : a word is endless.
        """
        assert self._aligner is not None
        self._aligner.add_words(words)

    def pieces(self, data: bytes | bytearray) -> Iterator[Float32Array]:
        """Take the next bytes, and give pieces of sound to `push`; see `IncomingSound.pieces`.

        Raises
        ------
        AudioError : they are not what the format says.
        """
        return self._sound.pieces(data)

    def push(self, piece: Float32Array) -> RecognisedPiece:
        """Return what is known since the next piece came."""
        found = self.known_of(self.analyser.push(piece))
        return replace(found, words=self.look()) if self.n_unlooked >= LOOK else found

    def finish(self) -> Iterator[RecognisedPiece]:
        """Return what is known of the rest, since the sound has ended.

        Raises
        ------
        AudioError : it ends in the midst of a sample or a page.
        """
        yield self.push(self._sound.finish())
        rest = self.known_of(self.analyser.finish())
        if self._aligner is not None:
            self._take_evidence(self._aligner)
            rest = replace(rest, words=self._aligner.finish(self.seconds))
        yield rest

    def known_of(self, analysis: Analysis) -> RecognisedPiece:
        """Return what is known since the next frames were analysed, but for words: `look` finds them."""
        if self._aligner is not None and len(analysis):
            self._unlooked.append(analysis)
            self.n_unlooked += len(analysis)
        weights = None if self._morpher is None else _weights(self._morpher, analysis)
        felt = NO_FEELINGS if self._feeling is None else self._feeling.follow(analysis.frames.windows)
        events = () if self._events is None else self._events.follow(analysis)
        return RecognisedPiece(analysis, weights, feelings=felt, events=events)

    def look(self) -> GrownWords | None:
        """Return what is known of the words of the text by now; None where no text was announced."""
        if self._aligner is None:
            return None
        self._take_evidence(self._aligner)
        return self._aligner.look()

    def _take_evidence(self, aligner: GrowingAligner) -> None:
        if self._unlooked:
            aligner.push(evidence_of(concatenate_analyses(self._unlooked)))
        self._unlooked, self.n_unlooked = [], 0


def recognise_together(pieces: Sequence[tuple[IncomingSpeech, Float32Array]]) -> list[RecognisedPiece | EngineError]:
    """Return what is known of several sounds since the next chunk of each came, or why one cannot be analysed.

    Words are left out: `IncomingSpeech.look` finds them, whenever there is time. Many sounds at once cost far less
    than one after the other, see `push_together`.
    """
    together = [(speech, piece) for speech, piece in pieces if not speech.is_foreign]
    analyses = iter(push_together([(speech.analyser, piece) for speech, piece in together]))
    return [
        _recognised_alone(speech, piece) if speech.is_foreign else speech.known_of(next(analyses))
        for speech, piece in pieces
    ]


def _recognised_alone(speech: IncomingSpeech, piece: Float32Array) -> RecognisedPiece | EngineError:
    """Return what is known by a recogniser of another package, which may fail."""
    try:
        return speech.known_of(speech.analyser.push(piece))
    except EngineError as error:
        return error


def in_time(preset: Preset, delay: float) -> Preset:
    """Return the preset that looks ahead as far as live sound may, and no further than 60 ms allow.

    Where they do not allow what the real-time model needs, the small network serves.

    Parameters
    ----------
    delay : seconds by which the sound is delayed before it is analysed.
    """
    left = max(0.0, MOST_LATE - WORK - BEYOND - delay)
    has_time = real_time_look_ahead(left) * FRAME_PERIOD <= left
    live = for_live_use(preset) if has_time else with_small_network(preset)
    return replace(live, settings=replace(live.settings, look_ahead=min(live.settings.look_ahead, left)))


def _weights(morpher: Morpher, analysis: Analysis) -> Float32Array:
    """Return the weights of the movestates when each frame begins, shape (n_frames, n_movestates)."""
    weights = np.empty((len(analysis), len(morpher.movestates)), np.float32)
    columns = (analysis.phonemes.tolist(), analysis.intensities.tolist(), analysis.viseme_phones)
    for k, (phoneme, intensity, phone) in enumerate(zip(*columns, strict=True)):
        time = (analysis.start + k) * FRAME_PERIOD
        morpher.add(time, phoneme, intensity, phone)
        weights[k] = morpher.weights(time)
    return weights
