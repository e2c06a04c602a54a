"""What a stream and its client say to each other, as JSON, strictly read."""

import json
import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any, TypeVar

import numpy as np

from phonemeanalyser.server.access import RefusedError
from phonemeanalyser.server.repertoire import Repertoire
from phonemeengine import GrownWords, MouthTable, Phoneme, Preset, Word
from phonemeengine.arrays import Float32Array
from phonemeengine.audio.incoming import Encoding, StreamFormat
from phonemeengine.features.feeling import Feeling
from phonemeengine.labels.visemes import viseme_of
from phonemeengine.live.incoming_speech import IncomingSpeech, RecognisedPiece
from phonemeengine.mouth.blending import VisemeBlender
from phonemeengine.mouth.exports.viseme_events import EventService
from phonemeengine.presets.model_choice import model_in_words
from phonemeengine.recognition.scores import scores_in
from phonemeengine.settings import FRAME_PERIOD

_PHONEMES = [phoneme.label for phoneme in Phoneme]
_START = ("encoding", "rate", "channels", "preset", "table", "probabilities", "events", "language", "text", "feeling")
_LATER = ("text", "end")
_THOUSANDTHS = np.array([json.dumps(k / 1000) for k in range(1001)], object)
_T = TypeVar("_T", int, str)


@dataclass(frozen=True)
class StreamStart:
    """What a client says first.

    Attributes
    ----------
    form : what the bytes are that follow.
    preset : what recognises.
    table : the mouth whose weights it wants; None for none.
    events : the service whose messages of visemes it wants in place of frames; None for frames.
    probabilities : whether it wants those of all phonemes and visemes, and the weights that follow them.
    language : of the text; empty where none will come.
    text : the beginning of what is said, as far as it is known.
    felt : whether it wants to know how the voice sounds.
    """

    form: StreamFormat
    preset: Preset
    table: MouthTable | None = None
    events: EventService | None = None
    probabilities: bool = False
    language: str = ""
    text: str = ""
    felt: bool = False

    @cached_property
    def blender(self) -> VisemeBlender | None:
        """What blends the shapes of the table."""
        return VisemeBlender(self.table) if self.table else None


@dataclass(frozen=True)
class LaterWords:
    """What a client says between its sound: more of the text, or that the sound has ended."""

    text: str = ""
    end: bool = False


def start_of(message: str, repertoire: Repertoire) -> StreamStart:
    """Read what a client says first, and load what it chooses.

    Raises
    ------
    EngineError : it is something else.
    """
    told = _object_in(message, _START)
    name = _value(told, "encoding", str, Encoding.S16.value)
    if name not in {encoding.value for encoding in Encoding}:
        raise RefusedError(f"there is no encoding {name[:40]!r}; send {', '.join(Encoding)}")
    encoding = Encoding(name)
    if "rate" not in told and encoding is not Encoding.OPUS:
        raise RefusedError("the first message has no rate; say how many samples a second has")
    rate = _value(told, "rate", int, 48_000)
    form = StreamFormat(encoding, rate, _value(told, "channels", int, 1))
    language, text = _value(told, "language", str, ""), _value(told, "text", str, "")
    if text and not language:
        raise RefusedError("the text has no language; name it in the first message, such as en-us or de")
    table = repertoire.table_told(_value(told, "table", str, ""))
    preset = repertoire.preset_told(_value(told, "preset", str, ""))
    wanted = [_switch(told, name) for name in ("probabilities", "feeling")]
    events = _service_named(_value(told, "events", str, ""))
    if events and (table or any(wanted)):
        raise RefusedError("with events there are no frames; leave out table, probabilities and feeling, or events")
    return StreamStart(form, preset, table, events, wanted[0], language, text, wanted[1])


def later_words_of(message: str) -> LaterWords:
    """Read what a client says between its sound.

    Raises
    ------
    RefusedError : it is something else.
    """
    told = _object_in(message, _LATER)
    return LaterWords(_value(told, "text", str, ""), _switch(told, "end"))


def ready(start: StreamStart, speech: IncomingSpeech) -> str:
    """Return the first message to a client, before it sends its sound."""
    told = {"preset": start.preset.name, "period": FRAME_PERIOD, "latency": round(speech.latency, 4)}
    told |= _recogniser_of(speech)
    return json.dumps({"ready": told | ({"movestates": start.table.movestates} if start.table else {})})


def recogniser(speech: IncomingSpeech) -> str:
    """Return which model recognises from now on."""
    return json.dumps(_recogniser_of(speech))


def words(grown: GrownWords) -> str:
    """Return what is known of the text."""
    told = {"words": [_word(w) for w in grown.settled], "open": [_word(w) for w in grown.open]}
    return json.dumps(told | ({"skipped": grown.skipped} if grown.skipped else {}))


def frames(found: RecognisedPiece, start: StreamStart) -> str:
    """Return what is said in the frames of a piece, of which there are some, to a client that began so."""
    analysis = found.analysis
    told: dict[str, Any] = {
        "time": round(analysis.start * FRAME_PERIOD, 2),
        "phonemes": [_PHONEMES[code] for code in analysis.phonemes.tolist()],
        "visemes": analysis.viseme_set.labels_of(analysis.visemes),
    }
    numbers: dict[str, Float32Array | None] = {"intensities": analysis.intensities}
    if math.isnan(analysis.confidences[0]):
        told["confidences"] = [None] * len(analysis)
    else:
        numbers["confidences"] = analysis.confidences
    if found.weights is not None:
        numbers["weights"] = found.weights
    if start.probabilities:
        numbers |= {"phoneme_scores": scores_in(analysis.features), "viseme_scores": analysis.viseme_scores}
        numbers |= {"blended": start.blender.weights(analysis)} if start.blender else {}
    if len(found.feelings):
        numbers |= zip(Feeling._fields, found.feelings.T, strict=True)
    told |= {name: None for name, values in numbers.items() if values is None}
    return json.dumps(told)[:-1] + _thousandths({k: v for k, v in numbers.items() if v is not None}) + "}"


def end(speech: IncomingSpeech) -> str:
    """Return what is said last."""
    told: dict[str, Any] = {"end": round(speech.seconds, 4)}
    told |= {"other_text": True} if speech.is_other_text else {}
    told |= _recogniser_of(speech) if speech.was_without_encoder else {}
    return json.dumps(told | ({"silenced": speech.n_silenced} if speech.n_silenced else {}))


def error(sentence: str) -> str:
    """Return why something is refused."""
    return json.dumps({"error": sentence})


def _recogniser_of(speech: IncomingSpeech) -> dict[str, Any]:
    return {"recogniser": model_in_words(speech.analyser.preset)}


def _word(word: Word) -> dict[str, Any]:
    phones = [
        {
            "start": round(phone.start, 2),
            "end": round(phone.end, 2),
            "phone": phone.ipa,
            "phoneme": phone.phoneme.label,
            "viseme": viseme.label if (viseme := viseme_of(phone.ipa, phone.phoneme)) is not None else None,
        }
        for phone in word.phones
    ]
    return {"word": word.text, "start": round(word.start, 2), "end": round(word.end, 2), "phones": phones}


def _thousandths(numbers: Mapping[str, Float32Array]) -> str:
    """Return numbers of frames, rounded, as what follows in a JSON object: a list each, or a list of rows.

    Those of 0..1 are looked up, all at once: writing numbers was a fifth of the work for a stream.
    """
    blocks = [values.reshape(len(values), -1) for values in numbers.values()]
    steps = np.rint(np.hstack(blocks).astype(np.float64) * 1000)
    if ((steps >= 0) & (steps <= 1000)).all():
        rows = _THOUSANDTHS[steps.astype(np.intp)].tolist()
    else:
        rows = [[json.dumps(value) for value in row] for row in (steps / 1000).tolist()]
    written, at = "", 0
    for (name, values), block in zip(numbers.items(), blocks, strict=True):
        begin, at = at, at + block.shape[1]
        lists = [", ".join(row[begin:at]) for row in rows]
        joined = ", ".join(lists) if values.ndim == 1 else f"[{'], ['.join(lists)}]"
        written += f', "{name}": [{joined}]'
    return written


def _object_in(message: str, known: tuple[str, ...]) -> Mapping[str, Any]:
    try:
        told = json.loads(message)
    except (ValueError, RecursionError):
        told = None
    if not isinstance(told, dict):
        words = f"a message in words must be a JSON object with {', '.join(known)}"
        raise RefusedError(f"{words}, got {_shown(message)}; correct it")
    for key in told:
        if key not in known:
            raise RefusedError(f"there is no {_shown(key)} in such a message; it may have {', '.join(known)}")
    return told


def _value(told: Mapping[str, Any], key: str, kind: type[_T], usual: _T) -> _T:
    value = told.get(key, usual)
    if not isinstance(value, kind) or isinstance(value, bool):
        must = "a whole number" if kind is int else "a text"
        raise RefusedError(f"{key} must be {must}, got {_shown(value)}; correct it")
    return value


def _switch(told: Mapping[str, Any], key: str) -> bool:
    value = told.get(key, False)
    if not isinstance(value, bool):
        raise RefusedError(f"{key} must be true or false, got {_shown(value)}; correct it")
    return value


def _service_named(name: str) -> EventService | None:
    if name and name not in {service.value for service in EventService}:
        raise RefusedError(f"there are no events of {_shown(name)}; choose {' or '.join(EventService)}")
    return EventService(name) if name else None


def _shown(value: object) -> str:
    return ascii(value)[:60]
