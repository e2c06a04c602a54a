"""A sound file becomes a mouth in one call."""

import json
from pathlib import Path

import pytest

from phonemeengine import (
    AudioError,
    ExportError,
    ExportOptions,
    MouthError,
    Phoneme,
    cues,
    export,
    load_preset,
    load_table,
    transcribe,
)

PRESET = load_preset("thesis")


def test_what_is_said_covers_the_sound(sound: Path) -> None:
    said = transcribe(str(sound), PRESET)
    assert (said.name, said.path) == ("speech.wav", sound)
    assert [said.runs[0].start, said.runs[-1].end] == [0.0, said.duration]
    assert {run.phoneme for run in said.runs} > {Phoneme.SILENCE}
    assert not said.pitches.any()
    assert transcribe(sound, PRESET, pitch=True).pitches.any()


def test_cues_name_the_shapes_of_the_table(sound: Path) -> None:
    said = transcribe(sound, PRESET)
    for table in ("rhubarb", load_table("rhubarb")):
        found = cues(sound, PRESET, table)
        assert {cue.shape for cue in found} <= set("ABCDEFGHX")
        assert (found[0].start, found[-1].end) == (0.0, said.duration)
        assert [one.end for one in found[:-1]] == [other.start for other in found[1:]]
    assert min(cue.duration for cue in cues(sound, PRESET, minimum=0.2)) >= 0.2 - 1e-9


def test_an_export_holds_the_cues(sound: Path, tmp_path: Path) -> None:
    target = tmp_path / "speech.json"
    export(str(sound), str(target), "rhubarb-json", PRESET, ExportOptions(anticipation=0.0))
    mouth = json.loads(target.read_text())["mouthCues"]
    shapes = [cue.shape for cue in cues(sound, PRESET, "rhubarb")]
    drawn = [shape for k, shape in enumerate(shapes) if k == 0 or shapes[k - 1] != shape]
    assert [cue["value"] for cue in mouth] == drawn
    assert list(tmp_path.glob("speech.json*")) == [target]


def test_a_refusal_leaves_the_old_file(sound: Path, tmp_path: Path) -> None:
    target = tmp_path / "speech.json"
    target.write_text("old")
    with pytest.raises(ExportError, match="there is no format 'rhubarb'; did you mean rhubarb-tsv, "):
        export(sound, target, "rhubarb", PRESET)
    with pytest.raises(AudioError, match=r"^missing\.wav: "):
        export(tmp_path / "missing.wav", tmp_path / "new.json", "rhubarb-json", PRESET)
    with pytest.raises(ExportError, match="is left alone"):
        export(sound, target, "rhubarb-json", PRESET)
    with pytest.raises(MouthError, match=r"^nowhere: "):
        cues(sound, PRESET, "nowhere")
    assert target.read_text() == "old"


def test_an_export_with_other_options_leaves_the_file_alone_unless_told(sound: Path, tmp_path: Path) -> None:
    target = tmp_path / "new" / "speech.csv"
    for _ in range(2):
        export(sound, target, "livelink-csv", PRESET)
    before = target.read_bytes()
    with pytest.raises(ExportError, match="made in another way, so it is left alone"):
        export(sound, target, "livelink-csv", PRESET, ExportOptions(rate=30))
    assert target.read_bytes() == before
    export(sound, target, "livelink-csv", PRESET, ExportOptions(rate=30), overwrite=True)
    assert target.read_bytes() != before
