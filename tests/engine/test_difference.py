"""Where two presets hear two things."""

import pytest

from phonemeanalyser.__main__ import main
from phonemeengine import Cancelled, Phoneme, SoundReader, difference, load_preset
from phonemeengine.inspection.whole_sound import (
    FrameRange,
    FrameState,
    SoundTracks,
    difference_in,
    format_difference,
    tracks_of,
)
from tests.conftest import ROOT

DEMO = ROOT / "phonemeanalyser" / "demo" / "demo.flac"


def tracks(codes: list[int], known: int = 10) -> SoundTracks:
    found = SoundTracks(len(codes))
    found.phonemes[:] = codes
    found.states[:known] = FrameState.KNOWN
    return found


def test_only_frames_that_both_know_differ() -> None:
    a, o, u = int(Phoneme.A), int(Phoneme.O), int(Phoneme.U)
    one, other = tracks([a] * 10), tracks([a, a, o, o, u, a, a, o, o, o], known=8)
    found = difference_in(one, other, FrameRange(0, 10))
    assert found.share == pytest.approx(4 / 8)
    assert [(s.row()) for s in found.segments] == [
        ("0.02", "0.04", "a", "o"),
        ("0.04", "0.05", "a", "u"),
        ("0.07", "0.08", "a", "o"),
    ]
    assert difference_in(one, other, FrameRange(0, 2)) == (0.0, ())
    assert difference_in(one, other, FrameRange(9, 10)) == (0.0, ())


def test_a_file_is_heard_with_both(capsys: pytest.CaptureFixture[str]) -> None:
    first, second = load_preset("thesis"), load_preset("learned")
    found = difference(DEMO, first, second)
    assert 0 < found.share < 1
    n_different = sum(round(100 * (s.end - s.start)) for s in found.segments)
    with SoundReader(DEMO) as reader:
        assert n_different == pytest.approx(found.share * tracks_of(reader).n_frames)
    assert difference(DEMO, first, first) == (0.0, ())
    with pytest.raises(Cancelled):
        difference(DEMO, first, second, progress=lambda _: False)
    assert main(["analyse", str(DEMO), "--preset", "thesis", "--against", "learned"]) == 0
    told = capsys.readouterr()
    assert told.out == format_difference(found)
    assert f"differ in {100 * found.share:.1f} %" in told.err


def test_a_table_of_its_own_takes_no_other_format(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        main(["analyse", str(DEMO), "--against", "learned", "--format", "json"])
    assert "--against writes a table of its own" in capsys.readouterr().err
