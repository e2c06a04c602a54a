"""What is written for other programs, read back by readers that are not ours, or held against a golden file."""

import csv
import io
import json
import re
import xml.etree.ElementTree as ET
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from praatio import textgrid

from phonemeengine.errors import ExportError
from phonemeengine.labels.audacity import raw_labels_of
from phonemeengine.mouth.animation import Animation, animation_blocks
from phonemeengine.mouth.blendshape_names import ARKIT, OCULUS, SHOULDERS
from phonemeengine.mouth.exports.export import number_lines
from phonemeengine.mouth.exports.exporter import Exporter, ExportOptions
from phonemeengine.mouth.exports.formats import FORMATS
from phonemeengine.mouth.exports.livelink import timecode_of
from phonemeengine.mouth.morpher import Detail
from phonemeengine.mouth.performer import IdleMotion, Performer
from phonemeengine.mouth.table import TABLES, load_table
from phonemeengine.mouth.transcript import Transcript
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.segments import Segment
from tests.engine.mouth.speaking import DURATION, phones_said, speech

GOLDEN = Path(__file__).resolve().parents[2] / "data" / "exports"
TEXTS = [name for name, form in FORMATS.items() if not form.moves_mesh]
CURVES = ["livelink-csv", "openface-csv", "oculus-csv", "curves-json"]


def written(name: str, said: Transcript | None = None, **options: object) -> str:
    parts = list(Exporter(name, ExportOptions(**options)).chunks_of(said or speech()))
    return b"".join(parts).decode("utf-8")


def cues_in(name: str, **options: object) -> list[tuple[float, float, str]]:
    """Give what should be written: start, end and shape of each drawing."""
    drawings = Exporter(name, ExportOptions(**options)).export_of(speech()).drawings
    return [(cue.start, cue.end, cue.shape) for cue in drawings]


@pytest.mark.parametrize("name", [name for name in TEXTS if name not in CURVES])
def test_files_of_cues_are_those_that_were_looked_at_once(name: str) -> None:
    golden = GOLDEN / f"masapo-{name}{FORMATS[name].ending}"
    assert written(name) == golden.read_text(encoding="utf-8")


@pytest.mark.parametrize("name", CURVES)
def test_files_of_movement_are_those_that_were_looked_at_once(name: str) -> None:
    """Numbers may differ in the last digit, as sines do from one system to another."""
    golden = GOLDEN / f"masapo-{name}{FORMATS[name].ending}"
    ours, theirs = (numbers_and_words(text) for text in (written(name, rate=10), golden.read_text(encoding="utf-8")))
    assert ours[1] == theirs[1]
    np.testing.assert_allclose(ours[0], theirs[0], atol=2e-3)


def numbers_and_words(text: str) -> tuple[list[float], list[str]]:
    numbers, words = [], []
    for word in text.replace(",", " ").replace("[", " [ ").replace("]", " ] ").replace("}", " } ").split():
        try:
            numbers.append(float(word))
        except ValueError:
            words.append(word)
    return numbers, words


# -- Rhubarb --------------------------------------------------------------------------------------------------


def test_rhubarbs_lines_are_starts_and_letters_and_end_with_a_closed_mouth() -> None:
    rows = [line.split("\t") for line in written("rhubarb-tsv").splitlines()]
    assert rows[0] == ["0.00", "X"]
    assert rows[-1] == [f"{DURATION:.2f}", "X"]
    assert [float(start) for start, _ in rows[:-1]] == pytest.approx(
        [c[0] for c in cues_in("rhubarb-tsv")], abs=0.006
    )
    assert {letter for _, letter in rows} <= set("ABCDEFGHX")
    times = [float(start) for start, _ in rows]
    assert all(a <= b for a, b in pairwise(times))


def test_rhubarbs_xml_is_read_by_an_xml_reader() -> None:
    root = ET.fromstring(written("rhubarb-xml", speech("a & b <c>.wav")))
    assert root.tag == "rhubarbResult"
    assert root.findtext("metadata/soundFile") == "a & b <c>.wav"
    assert float(root.findtext("metadata/duration", "")) == pytest.approx(DURATION, abs=0.005)
    cues = root.findall("mouthCues/mouthCue")
    assert [cue.text for cue in cues] == [shape for _, _, shape in cues_in("rhubarb-xml")]
    assert all(one.get("end") == other.get("start") for one, other in pairwise(cues))


def test_rhubarbs_json_is_read_by_a_json_reader() -> None:
    document = json.loads(written("rhubarb-json", speech('"ä".wav')))
    assert document["metadata"] == {"soundFile": '"ä".wav', "duration": round(DURATION, 2)}
    cues = document["mouthCues"]
    assert [(cue["start"], cue["end"], cue["value"]) for cue in cues] == [
        (pytest.approx(start, abs=0.006), pytest.approx(end, abs=0.006), shape)
        for start, end, shape in cues_in("rhubarb-json")
    ]


def test_letters_are_those_of_rhubarbs_manual() -> None:
    shapes = load_table("rhubarb").phonemes
    assert (shapes[Phoneme.P], shapes[Phoneme.M], shapes[Phoneme.SILENCE]) == ("A", "A", "X")
    assert (shapes[Phoneme.SZ], shapes[Phoneme.I], shapes[Phoneme.E]) == ("B", "B", "C")
    assert (shapes[Phoneme.A], shapes[Phoneme.O], shapes[Phoneme.U]) == ("D", "E", "F")


# -- frames of a film -----------------------------------------------------------------------------------------


@pytest.mark.parametrize("rate", [12, 25, 60])
def test_moho_has_each_drawing_on_a_frame_of_its_own(rate: float) -> None:
    first, *lines = written("moho-dat", rate=rate).splitlines()
    assert first == "MohoSwitch1"
    frames, shapes = zip(*(line.split() for line in lines), strict=True)
    numbers = [int(frame) for frame in frames]
    assert numbers[0] == 1
    assert all(a < b for a, b in pairwise(numbers))
    assert numbers[-1] == round(DURATION * rate + 1e-9) + 1
    assert shapes[0] == shapes[-1] == "rest"
    expected = [1 + round(start * rate + 1e-9) for start, _, _ in cues_in("moho-dat", rate=rate)]
    assert numbers[:-1] == pytest.approx(expected, abs=1)
    assert set(shapes) <= {"AI", "O", "E", "U", "etc", "L", "WQ", "MBP", "FV", "rest"}


def read_papagayo(text: str) -> tuple[dict[str, object], list[tuple[int, int, str, list[tuple[int, str]]]]]:
    """Read a project as Papagayo does, line by line."""
    lines = iter(text.splitlines())
    head = {"header": next(lines), "sound": next(lines), "fps": int(next(lines)), "frames": int(next(lines))}
    assert next(lines) == "1"
    head["voice"], _text = next(lines).strip(), next(lines)
    phrases = []
    for _ in range(int(next(lines))):
        word, first, last = next(lines).strip(), int(next(lines)), int(next(lines))
        assert next(lines).strip() == "1"
        name, start, end, n = next(lines).split()
        assert (name, int(start), int(end)) == (word, first, last)
        phonemes = [next(lines).split() for _ in range(int(n))]
        phrases.append((first, last, word, [(int(frame), shape) for frame, shape in phonemes]))
    assert next(lines, None) is None
    return head, phrases


def test_papagayo_has_a_phrase_between_two_silences() -> None:
    head, phrases = read_papagayo(written("papagayo-pgo"))
    assert head == {"header": "lipsync version 1", "sound": "masapo.wav", "fps": 24, "frames": 60, "voice": "Voice 1"}
    assert [word for _, _, word, _ in phrases] == ["m-a-p-o-sch-i", "sz-e-u"]
    for first, last, _, phonemes in phrases:
        frames = [frame for frame, _ in phonemes]
        assert frames[0] == first
        assert frames[-1] <= last
        assert all(a < b for a, b in pairwise(frames))
    assert phrases[0][1] < phrases[1][0]


def test_papagayo_is_told_where_the_sound_is_and_its_name_alone_where_nobody_knows(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    for path in (Path("masapo.wav"), tmp_path / "masapo.wav", Path("deep") / ".." / "masapo.wav"):
        head, _ = read_papagayo(written("papagayo-pgo", replace(speech(), path=path)))
        assert head["sound"] == str(tmp_path.resolve() / "masapo.wav")
    head, _ = read_papagayo(written("papagayo-pgo", replace(speech(), path=Path("a\nb.wav"))))
    assert head["sound"] == "masapo.wav"


# -- labels ---------------------------------------------------------------------------------------------------


def test_annosoft_reads_milliseconds_without_gaps() -> None:
    audio, *lines = written("anno").splitlines()
    assert audio == "audio masapo.wav"
    rows = [line.split() for line in lines]
    assert all(row[0] == "phn" for row in rows)
    assert rows[0][1] == "0"
    assert int(rows[-1][2]) == round(1000 * DURATION)
    assert all(one[2] == other[1] for one, other in pairwise(rows))
    assert all((row[3] == "0") == (row[4] == "x") for row in rows)
    assert [row[4] for row in rows[:4]] == ["x", "m", "AA", "p"]


@pytest.mark.parametrize("minimum", [0.055, 0.0605])
@pytest.mark.parametrize("name", ["rhubarb-tsv", "rhubarb-xml", "rhubarb-json", "anno"])
def test_rounded_times_keep_the_shortest_cue(name: str, minimum: float) -> None:
    """Sounds of 5 ms steps, whose borders lie between two hundredths."""
    chance, runs, at = np.random.default_rng(4), [], 0.0
    for phoneme, steps in zip(chance.integers(0, len(Phoneme), 3000), chance.integers(1, 40, 3000), strict=True):
        runs.append(Segment(at, at + steps * 0.005, Phoneme(phoneme), 0.5))
        at = runs[-1].end
    text = written(name, Transcript("long.wav", at, tuple(runs)), minimum=minimum)
    starts = {
        "rhubarb-tsv": r"^([\d.]+)\t",
        "rhubarb-xml": r'mouthCue start="([\d.]+)"',
        "rhubarb-json": r'"start": ([\d.]+)',
        "anno": r"^phn (\d+)",
    }
    times = np.array([float(start) for start in re.findall(starts[name], text, re.MULTILINE)])
    assert len(times) > 500
    assert np.diff(times / (1000 if name == "anno" else 1)).min() >= minimum - 1e-9


def test_praat_files_are_read_by_praatio(tmp_path: Path) -> None:
    path = tmp_path / "a.TextGrid"
    path.write_text(written("textgrid"), encoding="utf-8")
    grid = textgrid.openTextgrid(str(path), includeEmptyIntervals=True)
    assert grid.tierNames == ("phonemes",)
    entries = grid.getTier("phonemes").entries
    expected = cues_in("textgrid")
    assert [(entry.start, entry.end, entry.label) for entry in entries] == [
        (pytest.approx(start), pytest.approx(end), shape) for start, end, shape in expected
    ]
    assert grid.maxTimestamp == pytest.approx(DURATION)


def test_audacity_reads_back_what_was_written() -> None:
    marks = raw_labels_of(written("audacity"), "a.txt")
    assert [(mark.start, mark.end, mark.name) for mark in marks] == [
        (pytest.approx(start), pytest.approx(end), shape) for start, end, shape in cues_in("audacity")
    ]


def test_labels_say_when_a_sound_was_heard_and_drawings_are_a_little_ahead() -> None:
    heard = {shape: start for start, _, shape in cues_in("textgrid")}
    drawn = {shape: start for start, _, shape in cues_in("rhubarb-tsv")}
    assert (heard["p"], heard["o"]) == pytest.approx((0.74, 0.81))
    assert (drawn["A"], drawn["E"]) == pytest.approx(
        (0.70, 0.80)
    )  # the lips are shut for 60 ms of the sound at least


# -- movements ------------------------------------------------------------------------------------------------


def rows_of(text: str) -> list[dict[str, str]]:
    return list(csv.DictReader(io.StringIO(text)))


def test_live_link_has_61_columns_and_a_row_a_frame() -> None:
    rows = rows_of(written("livelink-csv"))
    assert len(rows) == int(DURATION * 60) + 1
    names = list(rows[0])
    assert names[:3] == ["Timecode", "BlendShapeCount", "EyeBlinkLeft"]
    assert [name[0].lower() + name[1:] for name in names[2:54]] == list(ARKIT)
    assert names[54:] == [
        f"{part}{turn}" for part in ("Head", "LeftEye", "RightEye") for turn in ("Yaw", "Pitch", "Roll")
    ]
    assert {row["BlendShapeCount"] for row in rows} == {"61"}
    assert [row["Timecode"] for row in rows[59:62]] == ["00:00:00:59.000", "00:00:01:00.000", "00:00:01:01.000"]
    values = np.array([[float(row[name]) for name in names[2:54]] for row in rows])
    assert values.min() >= 0
    assert values.max() <= 1
    pitch = np.array([float(row["HeadPitch"]) for row in rows])
    assert 0 < np.abs(pitch).max() < np.radians(10)


def test_a_picture_is_shown_at_the_very_end_of_the_sound_and_of_a_mouth_at_rest_after_it() -> None:
    for length, rate, n in ((0.29, 100.0, 30), (0.295, 100.0, 30), (1.0, 24.0, 25)):
        said = Transcript(
            "short.wav",
            length,
            (Segment(0.0, length, Phoneme.A, 1.0),),
            np.ones(29, np.float32),
            np.zeros(29, np.float32),
        )
        rows = rows_of(written("oculus-csv", said, rate=rate))
        assert float(rows[n - 1]["aa"]) > 0.3
        assert float(rows[-1]["aa"]) == 0.0
        assert n < len(rows) < n + 0.3 * rate


def test_lips_are_shut_when_m_and_p_are_heard_and_open_for_a() -> None:
    rows = rows_of(written("livelink-csv", rate=100.0))
    press = np.array([float(row["MouthPressLeft"]) for row in rows])
    jaw = np.array([float(row["JawOpen"]) for row in rows])
    arkit = load_table("arkit").weights()
    m, p = (arkit[phoneme, ARKIT.index("mouthPressLeft")] for phoneme in (Phoneme.M, Phoneme.P))
    assert press[33] == pytest.approx(m, abs=0.01)  # m sounds from 0.30 to 0.39 s
    assert press[77] == pytest.approx(p, abs=0.05)  # p from 0.74 to 0.81 s
    assert jaw[33] < 0.02
    assert jaw[64] > 0.35  # a from 0.39 to 0.74 s
    assert jaw[175] < 0.01  # silence from 1.44 s


def test_the_eyes_and_the_head_can_be_kept_still() -> None:
    for idle, still in ((IdleMotion(head=False), "Head"), (IdleMotion(blinks=False), "EyeBlink")):
        rows = rows_of(written("livelink-csv", longer(8), idle=idle))
        moved = {name for row in rows for name, value in row.items() if name[0] in "EH" and float(value) != 0}
        assert moved
        assert not any(name.startswith(still) for name in moved)


def longer(n: int) -> Transcript:
    """Say it again and again."""
    one = speech()
    runs = tuple(
        Segment(run.start + k * DURATION, run.end + k * DURATION, run.phoneme, run.intensity)
        for k in range(n)
        for run in one.runs
    )
    return Transcript(one.name, n * DURATION, runs, np.tile(one.intensities, n), np.tile(one.pitches, n))


def test_oculus_weights_are_shares_of_one_mouth() -> None:
    rows = rows_of(written("oculus-csv", idle=IdleMotion(seed=4)))
    assert list(rows[0]) == ["time_s", *OCULUS]
    values = np.array([[float(row[name]) for name in OCULUS] for row in rows])
    times = np.array([float(row["time_s"]) for row in rows])
    np.testing.assert_allclose(times, np.arange(len(rows)) / 60, atol=1e-6)
    assert (values >= 0).all()
    assert (values.sum(axis=1) <= 1.0001).all()
    np.testing.assert_allclose(values[0], np.eye(15)[0], atol=1e-6)
    middle = values[round(0.6 * 60)]
    assert OCULUS[middle.argmax()] == "aa"


def test_curves_are_plain_lists_that_a_json_reader_reads() -> None:
    document = json.loads(written("curves-json", rate=30.0))
    assert document["format"] == "phonemeanalyser curves 1"
    assert (document["rate"], document["sound"], document["table"]) == (30.0, "masapo.wav", "ARKit 52")
    n = int(DURATION * 30) + 1
    assert all(len(curve["values"]) == n for curve in document["curves"] + document["head"])
    assert {curve["name"] for curve in document["curves"]} <= set(ARKIT)
    assert [curve["name"] for curve in document["head"]] == ["yaw", "pitch", "roll"]
    cues = document["cues"]
    assert all(one["end"] == other["start"] for one, other in pairwise(cues))
    assert cues[1]["phoneme"] == "m"
    live = rows_of(written("livelink-csv", rate=30.0))
    jaw = next(curve["values"] for curve in document["curves"] if curve["name"] == "jawOpen")
    np.testing.assert_allclose(jaw, [float(row["JawOpen"]) for row in live], atol=1e-4)


def test_a_far_face_needs_less_detail() -> None:
    rows = rows_of(written("livelink-csv", idle=IdleMotion(detail=Detail.LOUDNESS)))
    assert max(float(row["MouthPucker"]) for row in rows) == 0
    assert max(float(row["JawOpen"]) for row in rows) > 0.2


@pytest.mark.parametrize(
    ("frame", "rate", "code"),
    [
        (0, 60, "00:00:00:00.000"),
        (59, 60, "00:00:00:59.000"),
        (3600 * 30, 30, "01:00:00:00.000"),
        (30, 29.97, "00:00:01:00.000"),
    ],
)
def test_time_codes_count_hours_minutes_seconds_and_frames(frame: int, rate: float, code: str) -> None:
    assert timecode_of(frame, rate) == code


# -- odd sounds and wrong wishes ------------------------------------------------------------------------------


@pytest.mark.parametrize("name", TEXTS)
def test_silence_of_no_length_and_of_some_can_be_written(name: str) -> None:
    for length in (0.0, 0.004, 0.5):
        runs = (Segment(0.0, length, Phoneme.SILENCE, 0.0),) if length else ()
        text = written(name, Transcript("nothing.wav", length, runs))
        assert text or (name in {"audacity", "polly-marks"} and not length)
        if name.endswith("json"):
            json.loads(text)
        if name.endswith("xml"):
            ET.fromstring(text)


def mine(folder: Path, **changes: str) -> Path:
    text = (TABLES / "five.toml").read_text(encoding="utf-8")
    for old, new in changes.items():
        text = text.replace(old, new)
    path = folder / "mine.toml"
    path.write_text(text, encoding="utf-8")
    return path


REFUSALS = {
    "unknown format": ("spine", {}, "there is no format 'spine'; choose one of rhubarb-tsv"),
    "frames where none are counted": ("anno", {"rate": 25}, "anno counts no frames, so it has no frame rate"),
    "half frames": (
        "papagayo-pgo",
        {"rate": 29.97},
        "papagayo-pgo must be a whole number in 1..240 frames per second, got",
    ),
    "too many frames": ("livelink-csv", {"rate": 1000}, "must be a number in 1..240 frames per second, got 1000"),
    "no frames": ("livelink-csv", {"rate": 0}, "must be a number in 1..240 frames per second, got 0"),
    "letters": ("rhubarb-tsv", {"table": "five"}, "knows the shapes A, B, .*, but the table 'Five mouth shapes' has"),
    "columns": (
        "oculus-csv",
        {"table": "arkit"},
        "holds the 15 movestates sil ... ou, which are not those of the table",
    ),
    "spaces": (
        "moho-dat",
        {"table": "five"},
        "separates names by spaces, so 'slightly open' of the table .* cannot be",
    ),
    "a mesh for cues": ("anno", {"mesh": Path("a.glb")}, "anno moves no mesh; leave a.glb out, or choose gltf"),
    "no such table": ("anno", {"table": "gone"}, "there is no such mouth table"),
    "times": ("anno", {"minimum": 5}, "minimum must lie in 0..1 s, got 5"),
}


@pytest.mark.parametrize("case", REFUSALS)
def test_what_a_format_cannot_do_is_said_before_any_sound_is_read(case: str) -> None:
    name, options, sentence = REFUSALS[case]
    with pytest.raises((ExportError, Exception), match=sentence.replace("...", r"\.\.\.")) as refusal:
        Exporter(name, ExportOptions(**options))
    assert type(refusal.value).__name__ in {"ExportError", "MouthError"}
    assert str(refusal.value).isprintable()


def test_ones_own_table_names_the_drawings(tmp_path: Path) -> None:
    table = mine(tmp_path, **{"slightly open": "slight"})
    shapes = {line.split()[1] for line in written("moho-dat", table=table).splitlines()[1:]}
    assert shapes == {"closed", "open", "round", "slight", "wide"}


def movement_at(rate: float, movestates: tuple[str, ...] = ARKIT) -> Animation:
    """A face that opens its first movestate, and turns its head."""
    weights = np.zeros((4, len(movestates)), np.float32)
    weights[:, 0] = [0, 0.25, 0.5, 0.75]
    return Animation(rate, movestates, weights, np.full((4, 3), 2, np.float32))


@pytest.mark.parametrize("name", ["livelink-csv", "curves-json", "gltf"])
def test_a_movement_that_is_known_takes_the_place_of_that_of_the_cues(name: str) -> None:
    exporter = Exporter(name, ExportOptions(rate=25.0))
    movement = movement_at(25.0)
    assert exporter.export_of(speech(), movement).animation is movement
    assert b"".join(exporter.chunks_of(speech(), movement)) != b"".join(exporter.chunks_of(speech()))
    if name == "livelink-csv":
        rows = list(csv.DictReader(b"".join(exporter.chunks_of(speech(), movement)).decode().splitlines()))
        assert [float(row["EyeBlinkLeft"]) for row in rows] == [0, 0.25, 0.5, 0.75]


def test_shoulders_travel_in_curves_and_are_left_out_where_a_format_has_none() -> None:
    movement = movement_at(60.0, (SHOULDERS[0], *ARKIT))
    written = b"".join(Exporter("livelink-csv").chunks_of(speech(), movement)).decode()
    rows = [row.split(",") for row in written.splitlines()]
    assert {len(row) for row in rows} == {63}
    assert {cell for row in rows[1:] for cell in row[2:54]} == {"0.00000"}
    curves = json.loads(b"".join(Exporter("curves-json").chunks_of(speech(), movement)))["curves"]
    assert curves == [{"name": "shoulderShiftLeft", "values": [0, 0.25, 0.5, 0.75]}]


@pytest.mark.parametrize(
    ("name", "movement", "words"),
    [
        ("oculus-csv", movement_at(60.0), "oculus-csv is made of cues, or of movestates other than eyeBlinkLeft"),
        ("rhubarb-tsv", movement_at(60.0), "rhubarb-tsv is made of cues, or of movestates"),
        ("livelink-csv", movement_at(60.0, OCULUS), "livelink-csv is made of cues, or of movestates other than sil"),
        ("curves-json", movement_at(30.0), "curves-json has 60 frames per second, the movement 30; make it with"),
    ],
)
def test_a_movement_that_a_format_cannot_hold_is_refused(name: str, movement: Animation, words: str) -> None:
    with pytest.raises(ExportError, match=words):
        Exporter(name).export_of(speech(), movement)


def test_a_long_face_is_made_and_written_in_parts_as_it_is_in_one() -> None:
    whole, parts = ([*animation_blocks(Performer(load_table("arkit")), speech(), 60.0, block=n)] for n in (4096, 7))
    assert len(parts) > len(whole) == 1
    weights = np.concatenate([part.weights for part in parts])
    np.testing.assert_array_equal(weights, whole[0].weights)
    assert [*number_lines(weights, rows=3)] == [*number_lines(weights)]


# -- few pictures a second --------------------------------------------------------------------------------


@pytest.mark.parametrize("rate", [8, 12, 24])
@pytest.mark.parametrize(
    ("name", "shapes"), [("moho-dat", {"p": "MBP", "f": "FV"}), ("papagayo-pgo", {"p": "MBP", "f": "FV"})]
)
def test_what_meets_for_less_than_a_frame_wins_one(name: str, shapes: dict[str, str], rate: int) -> None:
    """Wherever a p or an f of 40 ms lies between two frames, and with neighbours that are short as well."""
    for phone, shape in shapes.items():
        for k in range(12):
            said = phones_said(("a", 0.1 + k / 100), (phone, 0.04), ("ə", 0.05), ("l", 0.05), ("a", 0.1))
            lines = [line.split() for line in written(name, said, rate=rate).splitlines()]
            frames = [int(line[0]) for line in lines if len(line) == 2 and line[1] == shape]
            at = (0.32 - 0.04 + k / 100 + 0.1) * rate + (name == "moho-dat")
            assert frames, (phone, k)
            assert frames == pytest.approx([at] * len(frames), abs=1.6), (phone, k)


def test_two_closures_within_a_frame_have_one_each() -> None:
    said = phones_said(("a", 0.2), ("p", 0.04), ("f", 0.04), ("a", 0.2))
    lines = [line.split()[1] for line in written("moho-dat", said, rate=8).splitlines()[1:]]
    assert [shape for shape in lines if shape in {"MBP", "FV"}] == ["MBP", "FV"]
