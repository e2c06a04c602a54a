"""A recording as it was tracked, and the sound that was heard with it."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from phonemeengine.errors import PerformanceError
from phonemeengine.mouth.blendshape_names import ARKIT
from phonemeengine.mouth.performer import MOUTH_ALONE, Performer
from phonemeengine.performance.corpus import build_table
from phonemeengine.performance.own_sound import RecordedFace, original_sound
from phonemeengine.performance.recording import HEAD
from phonemeengine.performance.table_file import PerformanceTable, write_table
from phonemeengine.performance.track import face_table
from tests.engine.performance.corpora import write_recording
from tests.engine.performance.test_track import recorded

JAW, LID = ARKIT.index("jawOpen"), ARKIT.index("eyeBlinkLeft")


def test_a_recorded_face_shows_all_that_was_tracked() -> None:
    plain = recorded("ma")
    turns = np.tile(np.array([[10.0, 2.0, 1.0]], np.float32), (len(plain.weights), 1))
    turns[-1, 0] = 14.0
    performance = replace(
        plain, channels=(*HEAD, *plain.channels[1:]), weights=np.hstack([turns, plain.weights[:, 1:]])
    )
    face = RecordedFace(performance)
    end = (len(plain.weights) - 1) / plain.rate
    assert face.weights(end / 2)[JAW] == pytest.approx(0.5)
    assert face.weights(end / 2)[LID] == 1
    head = face.head(end)
    assert head is not None
    assert (head.yaw, head.pitch, head.roll) == (4.0, 0.0, 0.0)
    assert RecordedFace(plain).head(0.1) is None  # the roll is missing
    performer = Performer(face_table(), MOUTH_ALONE)
    performer.play(face, start=1.0)
    assert performer.at(1.0 + end / 2).weights[JAW] == pytest.approx(0.5)


def test_a_recording_is_found_by_its_name(tmp_path: Path) -> None:
    write_table(tmp_path / "t.sqlite", [recorded("ma"), recorded("mi")])
    with PerformanceTable.open(tmp_path / "t.sqlite") as table:
        assert table.recording_called("mi").name == "mi"
        with pytest.raises(PerformanceError, match=r"no recording 'mo' in this table.*such as 'ma'"):
            table.recording_called("mo")


def test_a_table_knows_where_its_recordings_are_after_both_have_moved(tmp_path: Path) -> None:
    (tmp_path / "a" / "corpus").mkdir(parents=True)
    write_recording(tmp_path / "a" / "corpus", "one")
    build_table(tmp_path / "a" / "corpus", tmp_path / "a" / "t.sqlite")
    (tmp_path / "a").rename(tmp_path / "b")
    with PerformanceTable.open(tmp_path / "b" / "t.sqlite") as table:
        assert table.about.folder == "corpus"
        assert original_sound(table, "one") == tmp_path / "b" / "corpus" / "one.wav"
        assert original_sound(table, "two") is None
        assert original_sound(table, "../corpus/one") is None
        assert original_sound(table, "one", tmp_path) is None
