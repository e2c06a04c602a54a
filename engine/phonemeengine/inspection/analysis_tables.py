"""The tables of what was recognised in a sound: segments of equal phonemes, or every frame's variables."""

import csv
import json
import math
import re
from collections import deque
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any, TextIO

from phonemeengine.analyser import Analysis
from phonemeengine.audio.files import SoundReader
from phonemeengine.features.variables import BUILT_IN_NAMES
from phonemeengine.labels import textgrid
from phonemeengine.labels.audacity import format_audacity
from phonemeengine.labels.utterance import Label, Phone, Utterance, Word
from phonemeengine.labels.utterance_files import format_utterance
from phonemeengine.mouth.transcript import Transcript
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.model_choice import for_files, model_in_words
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.segments import SEGMENT_COLUMNS, Segment, labels_of_segments, segments_of
from phonemeengine.settings import FRAME_PERIOD
from phonemeengine.storage.files import JSON_TEXT, Owns, begins_like

Writer = Callable[[TextIO, Iterator[Analysis], SoundReader, Preset], None]
"""Writes the consecutive analyses of a sound, with its reader and the preset, into a file."""

WordWriter = Callable[[TextIO, Utterance, Transcript, Preset], None]
"""Writes what is said in a sound whose words are known into a file, and how loud it is."""

WORD_COLUMNS = (*SEGMENT_COLUMNS, "phone", "word", "score")
"""The columns of a table of phones."""


@dataclass(frozen=True)
class TableFormat:
    """A kind of table.

    Attributes
    ----------
    ending : of its files, such as ``.csv``.
    write_runs : writes segments of equal phonemes.
    write_words : writes words and phones.
    write_frames : writes every frame of 10 ms with its variables; None where the format has no place for them.
    owns : says which files the format wrote; None where those of another program look alike.
    """

    ending: str
    write_runs: Writer
    write_words: WordWriter
    write_frames: Writer | None = None
    owns: Owns | None = None


def _csv_of_runs(file: TextIO, analyses: Iterator[Analysis], reader: SoundReader, _preset: Preset) -> None:
    rows = csv.writer(file, lineterminator="\n")
    rows.writerow(SEGMENT_COLUMNS)
    rows.writerows(run.row().values() for run in _runs(analyses, reader))


def _json_of_runs(file: TextIO, analyses: Iterator[Analysis], reader: SoundReader, preset: Preset) -> None:
    heading = _heading(reader.path.name, reader.duration, preset)
    _write_json(file, heading, "phonemes", (run.row() for run in _runs(analyses, reader)))


def _textgrid_of_runs(file: TextIO, analyses: Iterator[Analysis], reader: SoundReader, _preset: Preset) -> None:
    file.write(textgrid.format_textgrid(_labels(analyses, reader), reader.duration))


def _audacity_of_runs(file: TextIO, analyses: Iterator[Analysis], reader: SoundReader, _preset: Preset) -> None:
    file.write(format_audacity(_labels(analyses, reader)))


def _csv_of_frames(file: TextIO, analyses: Iterator[Analysis], reader: SoundReader, _preset: Preset) -> None:
    rows = csv.writer(file, lineterminator="\n")
    begun = False
    for frame in _frames(analyses, reader):
        if not begun:
            rows.writerow(frame)
            begun = True
        rows.writerow(frame.values())


def _json_of_frames(file: TextIO, analyses: Iterator[Analysis], reader: SoundReader, preset: Preset) -> None:
    heading = _heading(reader.path.name, reader.duration, preset)
    _write_json(file, heading, "frames", _frames(analyses, reader))


def _csv_of_words(file: TextIO, utterance: Utterance, transcript: Transcript, _preset: Preset) -> None:
    rows = csv.writer(file, lineterminator="\n")
    rows.writerow(WORD_COLUMNS)
    said = deque((phone, word.text) for word in utterance.words for phone in word.phones)
    for run in transcript.runs:
        middle = (run.start + run.end) / 2
        while said and said[0][0].end <= middle:
            said.popleft()
        phone, word = said[0] if said and said[0][0].start <= middle else (None, "")
        ends = ("", "", "") if phone is None else (phone.ipa, word, _score(phone.score))
        rows.writerow([*run.row().values(), *ends])


def _json_of_words(file: TextIO, utterance: Utterance, transcript: Transcript, preset: Preset) -> None:
    heading = _heading(transcript.name, transcript.duration, preset)
    words = {"skipped": list(utterance.skipped), "words": [_word_entry(word) for word in utterance.words]}
    json.dump(heading | words, file, indent=1, ensure_ascii=False)
    file.write("\n")


def _word_entry(word: Word) -> dict[str, Any]:
    syllables = [{"stress": s.stress, "phones": [_phone_entry(phone) for phone in s.phones]} for s in word.syllables]
    return {"word": word.text, **_times(word), "syllables": syllables}


def _phone_entry(phone: Phone) -> dict[str, Any]:
    return {"phone": phone.ipa, "phoneme": phone.phoneme.label, **_times(phone)}


def _times(said: Word | Phone) -> dict[str, Any]:
    return {"start_s": _seconds(said.start), "end_s": _seconds(said.end), "score": _score(said.score)}


def _score(score: float | None) -> float | None:
    return None if score is None else round(score, 3)


def _textgrid_of_words(file: TextIO, utterance: Utterance, _transcript: Transcript, _preset: Preset) -> None:
    file.write(format_utterance(utterance))


def _audacity_of_words(file: TextIO, utterance: Utterance, transcript: Transcript, _preset: Preset) -> None:
    labels = [Label(p.start, p.end, p.ipa, p.phoneme) for p in utterance.phones]
    file.write(format_audacity(labels, transcript.words))


def _write_json(file: TextIO, heading: dict[str, Any], name: str, rows: Iterator[dict[str, Any]]) -> None:
    """Write an object with a list of rows, a line each, as they come: a long file has too many to hold."""
    file.write(json.dumps(heading, indent=1)[:-2] + f',\n "{name}": [')
    file.writelines((",\n  " if k else "\n  ") + json.dumps(row) for k, row in enumerate(rows))
    file.write("\n ]\n}\n")


def _heading(name: str, duration: float, preset: Preset) -> dict[str, Any]:
    model = model_in_words(for_files(preset))
    return {"file": name, "duration_s": _seconds(duration), "preset": preset.name, "model": model}


def _runs(analyses: Iterator[Analysis], reader: SoundReader) -> Iterator[Segment]:
    return segments_of(((a.phonemes, a.intensities, a.confidences) for a in analyses), reader.duration)


def _labels(analyses: Iterator[Analysis], reader: SoundReader) -> tuple[Label, ...]:
    return labels_of_segments(_runs(analyses, reader))


def _frames(analyses: Iterator[Analysis], reader: SoundReader) -> Iterator[dict[str, Any]]:
    for analysis in analyses:
        confidences = [None if math.isnan(sure) else round(sure, 3) for sure in analysis.confidences.tolist()]
        for k in range(len(analysis)):
            start = (analysis.start + k) * FRAME_PERIOD
            yield {
                "start_s": _seconds(start),
                "end_s": _seconds(min(start + FRAME_PERIOD, max(reader.duration, start))),
                "phoneme": Phoneme(int(analysis.phonemes[k])).label,
                "intensity": round(float(analysis.intensities[k]), 3),
                "confidence": confidences[k],
                **{name: float(f"{value:.6g}") for name, value in analysis.features.frame(k).items()},
            }


def _seconds(value: float) -> float:
    return round(value, 6)


_OLDER = ",".join(SEGMENT_COLUMNS[:-1]).encode()  # tables had no confidence once
_RUNS = re.compile(
    b"%s(?:,confidence)?\n(?:[0-9.e-]+,[0-9.e-]+,(?:%s),[0-9.e-]+(?:,[0-9.e-]*)?\n)*"
    % (_OLDER, "|".join(phoneme.label for phoneme in Phoneme).encode())
)
_WORDS = ",".join(WORD_COLUMNS).encode() + b"\n"
_FRAMES = ",".join([*SEGMENT_COLUMNS, *BUILT_IN_NAMES]).encode()
_OLDER_TABLES = tuple(
    b",".join((_OLDER, *(name.encode() for name in names)))
    for names in (("phone", "word", "score\n"), BUILT_IN_NAMES)
)


def _owns_csv(content: bytes) -> bool:
    """Take tables with all the columns that were written, and of runs with no other row either."""
    return content.startswith((_FRAMES, _WORDS, *_OLDER_TABLES)) or _RUNS.fullmatch(content) is not None


_owns_json = begins_like(
    rb'\{\n "file": %s,\n "duration_s": [0-9.e-]+,\n "preset": %s,\n '
    rb'(?:"(?:model|heard_with)": %s,\n )?"(?:phonemes|frames|skipped)": \[' % (JSON_TEXT, JSON_TEXT, JSON_TEXT)
)

TABLES: dict[str, TableFormat] = {
    "csv": TableFormat(".csv", _csv_of_runs, _csv_of_words, _csv_of_frames, _owns_csv),
    "json": TableFormat(".json", _json_of_runs, _json_of_words, _json_of_frames, _owns_json),
    "textgrid": TableFormat(".TextGrid", _textgrid_of_runs, _textgrid_of_words, owns=textgrid.owns),
    "audacity": TableFormat(".txt", _audacity_of_runs, _audacity_of_words),
}
"""What can be written, by the names that the command line has for it."""
