"""What moves a face: the same choice of ``speak``, ``export`` and ``preview``, and two of them side by side."""

import csv
import re
from pathlib import Path

import av
import numpy as np
import pytest
from PIL import Image

from phonemeanalyser.cli.main import main
from phonemeanalyser.colours import LIGHT
from phonemeanalyser.rendering.clip import SideBySide
from phonemeengine.arrays import UInt8Array
from phonemeengine.labels.textgrid import format_tiers
from phonemeengine.performance.corpus import build_table
from tests.engine.performance.corpora import DURATION, write_recording
from tests.graphics import context_or_skip
from tests.tables import Capsys

CHINESE = ["--script", "chinese.TextGrid"]
SMALL = ["--size", "128x96", "--fps", "5"]
HEAD = (64, 88)
"""Of a picture with two heads: its half, above the caption."""
DRIVERS = ("pinyin", "table", "rules")


@pytest.fixture
def recorded(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with the recording "mami", a synthetic table of it, and the labels of the same in pinyin."""
    monkeypatch.chdir(tmp_path)
    write_recording(tmp_path)
    (tmp_path / "corpus.toml").write_text('format = "phonemeanalyser corpus 1"\nname = "Ann"\nsynthetic = true\n')
    build_table(tmp_path, tmp_path / "ann.sqlite")
    syllables = [(0.0, 0.2, ""), (0.2, 0.5, "ma1"), (0.5, 0.8, "mi5"), (0.8, DURATION, "")]
    (tmp_path / "chinese.TextGrid").write_text(format_tiers({"syllables": syllables}, DURATION), encoding="utf-8")
    return tmp_path


def table_of(driver: str) -> list[str]:
    return ["--performance", "ann.sqlite"] if driver == "table" else []


def jaws(path: Path) -> list[float]:
    with path.open(encoding="utf-8", newline="") as file:
        return [float(row["JawOpen"]) for row in csv.DictReader(file)]


def exported(out: str, *words: str) -> list[float]:
    assert main(["export", "mami.wav", "--format", "livelink-csv", "-o", out, *CHINESE, *words]) == 0
    return jaws(Path(out))


def shown(out: str, *words: str) -> UInt8Array:
    assert main(["preview", "mami.wav", "-o", out, *SMALL, *CHINESE, *words]) == 0
    return np.stack([np.asarray(Image.open(path)) for path in sorted(Path(out).iterdir())])


def test_chinese_moves_a_face_by_its_letters_unless_something_else_is_chosen(recorded: Path) -> None:
    moved = {driver: exported(f"{driver}.csv", "--text-driver", driver, *table_of(driver)) for driver in DRIVERS}
    assert len({tuple(jaw) for jaw in moved.values()}) == len(DRIVERS)
    assert exported("auto.csv") == moved["pinyin"]
    assert exported("auto-table.csv", *table_of("table")) == moved["table"]


@pytest.mark.parametrize("driver", DRIVERS[:2])
def test_labels_move_a_face_alike_whichever_command_reads_them(recorded: Path, driver: str) -> None:
    (recorded / "mami.TextGrid").write_bytes((recorded / "chinese.TextGrid").read_bytes())
    words = ["--format", "livelink-csv", "--text-driver", driver, *table_of(driver)]
    assert main(["speak", "--recording", "mami.wav", "--export", "speak.csv", *words]) == 0
    assert jaws(recorded / "speak.csv") == exported("export.csv", "--text-driver", driver, *table_of(driver))


def test_a_pinyin_table_of_ones_own_and_a_spring_move_exports_too(recorded: Path) -> None:
    assert exported("spring.csv", "--spring", "1,400,40") != exported("auto.csv")


def test_letters_leave_a_face_with_movestates_of_its_own_to_the_rules(recorded: Path, capsys: Capsys) -> None:
    for driver in ("auto", "rules"):
        words = ["--format", "curves-json", "--table", "vrm", "-o", f"{driver}.json", "--text-driver", driver]
        assert main(["export", "mami.wav", *CHINESE, *words]) == 0
    assert (recorded / "auto.json").read_bytes() == (recorded / "rules.json").read_bytes()
    assert capsys.readouterr().err == ""


@pytest.mark.long
def test_two_heads_are_those_of_two_drivers_alone_in_step(recorded: Path) -> None:
    context_or_skip().release()
    performer = ["--performance", "ann.sqlite"]
    both = shown("both", "--text-driver", "pinyin", "--beside", "table", *performer)
    assert both.shape == (7, 96, 128, 3)  # the sound, and until both faces are at rest
    size = ["--size", "64x88"]
    letters, table = (
        shown("pinyin", "--text-driver", "pinyin", *size),
        shown("table", "--text-driver", "table", *performer, *size),
    )
    for head, alone in ((both[:, :88, :64], letters), (both[:, :88, 64:], table)):
        n = len(alone)
        assert np.array_equal(head[:n], alone)
        assert all(np.array_equal(later, alone[-1]) for later in head[n:])  # the shorter one stays
    assert not np.array_equal(letters, table)


def test_each_head_is_called_what_moves_it_and_a_synthetic_performer_so(recorded: Path) -> None:
    context_or_skip().release()
    heads = np.zeros((2, 88, 64, 3), np.uint8)
    captions = "Ann (synthetic performer)", "Pinyin letters"
    sheet = SideBySide((128, 96), captions, LIGHT.text, LIGHT.window)
    assert sheet.head_size == HEAD
    (first, *_rest) = shown("both", "--beside", "pinyin", "--performance", "ann.sqlite", "--fps", "1")
    assert np.array_equal(first[88:], sheet.picture(list(heads))[88:])


def test_a_film_of_two_heads_has_the_size_of_the_whole_and_one_sound(recorded: Path, capsys) -> None:
    context_or_skip().release()
    assert main(["preview", "mami.wav", "-o", "film.mp4", *SMALL, *CHINESE, "--beside", "rules"]) == 0
    assert re.search(
        r"mami\.wav: note: the heads differ by 0\.\d+ \(RMS of the weights\), most at 0\.", capsys.readouterr().err
    )
    with av.open(recorded / "film.mp4") as film:
        (video,), (audio,) = film.streams.video, film.streams.audio
        assert (video.width, video.height, video.frames) == (128, 96, 7)
        assert float(audio.duration * audio.time_base) == pytest.approx(DURATION, abs=0.05)


PREVIEW = ["preview", "mami.wav", "-o", "out"]
EXPORT = ["export", "mami.wav", "--format", "livelink-csv", "-o", "out.csv"]
TABLE = ["--performance", "ann.sqlite"]


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        ([*EXPORT, "--text-driver", "table"], "--text-driver table needs a table of recorded faces; name it with"),
        ([*PREVIEW, "--beside", "table"], "--beside table needs a table of recorded faces; name it with --perf"),
        (
            [*EXPORT, "--text-driver", "rules", *TABLE],
            "--text-driver rules leaves the table of --performance unused;",
        ),
        (
            [*EXPORT, "--text-driver", "pinyin"],
            "mami.wav: letters of pinyin are those of the syllables that are said",
        ),
        ([*PREVIEW, "--beside", "table", *TABLE], "mami.wav: recorded faces are looked up by the phones that are"),
        (
            [*EXPORT, "--text-driver", "pinyin", "--script", "mami.TextGrid"],
            "mami.wav: there is no syllable of pinyin in what is said; choose another driver",
        ),
        ([*PREVIEW, "--beside", "rules"], "mami.wav: --beside rules would be what moves the first head, too; choose"),
        (
            [*PREVIEW, *CHINESE, "--beside", "pinyin"],
            "mami.wav: --beside pinyin would be what moves the first head, too; choose another one, or another",
        ),
        ([*EXPORT, "--pinyin-table", "mami.csv"], "mami.csv: "),
    ],
)
def test_a_driver_that_cannot_move_the_face_is_refused_in_a_sentence(
    recorded: Path, words: list[str], sentence: str, capsys: Capsys
) -> None:
    told = "phonemeanalyser: Ann: note: the performer is synthetic: no person moved, but a model of one\n"
    assert main(words) == 1
    said = capsys.readouterr().err.replace(told, "")
    assert said.startswith(f"phonemeanalyser: {sentence}")
    assert said.count("\n") == 1
    assert not (recorded / "out").exists()
    assert not (recorded / "out.csv").exists()
