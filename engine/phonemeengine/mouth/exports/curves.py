"""Curves as JSON, easy to read from Unity (JsonUtility), Godot or a page: an object of plain lists.

``format``   "phonemeanalyser curves 1"
``sound``    the sound's file name
``duration`` seconds
``rate``     frames per second; value k of a curve is that of the time k / rate
``table``    the name of the mouth table
``cues``     objects with ``start`` and ``end`` (seconds), ``phoneme``, ``shape`` and ``intensity`` (0..1); and with
             ``phone``, in the IPA, where it is known
``words``    objects with ``start``, ``end`` and ``word``; left out where the words are not known
``curves``   objects with ``name``, a movestate, and ``values``, 1 for its whole movement; those that never move are
             left out
``head``     objects with ``name`` (yaw, pitch, roll) and ``values`` in degrees; empty where the head does not move
"""

import json
from collections.abc import Iterator, Sequence

from phonemeengine.arrays import Float32Array
from phonemeengine.labels.utterance import Word
from phonemeengine.mouth.cues import Cue
from phonemeengine.mouth.curves_file import FORMAT, HEAD
from phonemeengine.mouth.exports.export import Export
from phonemeengine.storage.files import begins_like

owns = begins_like(b'{\n "format": "%s",\n' % FORMAT.encode())


def write(export: Export) -> Iterator[str]:
    """Write the object, a line for each cue and each curve."""
    animation, speech = export.face_animation, export.speech
    heading = {"format": FORMAT, "sound": speech.name, "duration": round(speech.duration, 6)}
    heading |= {"rate": export.rate, "table": export.table.name}
    yield json.dumps(heading, indent=1, ensure_ascii=False)[:-2]
    yield from _list("cues", (_cue(cue) for cue in export.cues))
    if speech.words:
        yield from _list("words", map(word_entry, speech.words))
    yield from _list("curves", _curves(animation.movestates, animation.weights, 4))
    yield from _list("head", _curves(HEAD, animation.head, 3))
    yield "\n}\n"


def _list(name: str, entries: Iterator[str]) -> Iterator[str]:
    yield f',\n "{name}": ['
    for k, entry in enumerate(entries):
        yield f"{',' if k else ''}\n  {entry}"
    yield "\n ]"


def word_entry(word: Word) -> str:
    """Return a word with its times as a JSON object on one line."""
    entry = {"start": round(word.start, 4), "end": round(word.end, 4), "word": word.text}
    return json.dumps(entry, ensure_ascii=False)


def _cue(cue: Cue) -> str:
    times = {"start": round(cue.start, 4), "end": round(cue.end, 4)}
    words = {"phoneme": cue.phoneme.label, "shape": cue.shape, "intensity": round(cue.intensity, 3)}
    phone = {"phone": cue.phone} if cue.phone else {}
    return json.dumps(times | words | phone, ensure_ascii=False)


def _curves(names: Sequence[str], values: Float32Array, digits: int) -> Iterator[str]:
    for name, column in zip(names, values.T, strict=True):
        if column.any():
            numbers = ", ".join(map(f"%.{digits}f".__mod__, column.tolist()))
            yield f'{{"name": {json.dumps(name, ensure_ascii=False)}, "values": [{numbers}]}}'
