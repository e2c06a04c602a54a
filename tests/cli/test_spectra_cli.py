"""``phonemeanalyser spectra``: averages of speakers and phonemes, as tables, curves and a picture."""

import csv
import io
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
import soundfile

from phonemeanalyser.__main__ import main
from phonemeengine.inspection.averaged_spectrum import format_distances, format_spectra, load_averaged_spectrum
from phonemeengine.inspection.speaker_spectra import VOWELS, Grouping, average_parts, groups_in
from phonemeengine.presets.files import DEFAULT_PRESET, load_preset
from phonemeengine.settings import SAMPLE_RATE
from tests.labelled import recordings
from tests.sounds import tone


@pytest.fixture
def corpus(tmp_path: Path) -> Path:
    """Four labelled recordings of two speakers."""
    for utterance in recordings(tmp_path):
        place = tmp_path / "corpus" / utterance.speaker
        place.mkdir(parents=True, exist_ok=True)
        sound = utterance.path.rename(place / utterance.path.name)
        rows = [f"{label.start},{label.end},{label.phone},{label.phoneme.label},core" for label in utterance.labels]
        sound.with_suffix(".csv").write_text("\n".join(["start_s,end_s,phone,class,certainty", *rows]))
    return tmp_path / "corpus"


def test_prints_and_writes_what_the_api_measures(corpus: Path, tmp_path: Path, capsys: pytest.CaptureFixture) -> None:
    settings = load_preset(DEFAULT_PRESET).settings
    groups = groups_in(corpus, Grouping.SPEAKER, VOWELS)
    curves = [average_parts(parts, settings, name) for name, parts in groups.items()]
    wanted = ["spectra", str(corpus), "--phoneme", "vowels", "--differences", str(tmp_path / "d.csv")]
    assert main(wanted) == 0
    assert capsys.readouterr().out == format_spectra(curves)
    assert (tmp_path / "d.csv").read_text() == format_distances(curves)
    assert main([*wanted, "-o", str(tmp_path / "t.csv"), "--curves", str(tmp_path / "curves")]) == 0
    assert (tmp_path / "t.csv").read_text() == format_spectra(curves)
    assert load_averaged_spectrum(tmp_path / "curves" / "ada (vowels).csv").is_same(curves[0])
    assert main([*wanted, "-o", str(tmp_path / "t.csv")]) == 0  # both are our own


@pytest.mark.parametrize(
    ("by", "names"), [("phoneme", ["a", "sz"]), ("speaker-phoneme", ["ada a", "ada sz", "bob a", "bob sz"])]
)
def test_each_phoneme_has_its_columns(corpus: Path, by: str, names: list[str], capsys: pytest.CaptureFixture) -> None:
    assert main(["spectra", str(corpus), "--by", by, "--phoneme", "a", "--phoneme", "sz"]) == 0
    heading = next(csv.reader(io.StringIO(capsys.readouterr().out)))
    assert heading == ["frequency_hz", *(f"{name} {kind}" for name in names for kind in ("level_db", "spread_db"))]


@pytest.mark.parametrize("theme", ["light", "dark"])
def test_the_picture_has_each_curve_under_its_name(corpus: Path, tmp_path: Path, theme: str) -> None:
    target = tmp_path / "p.svg"
    out = ["-o", str(tmp_path / "t.csv")]
    assert main(["spectra", str(corpus), "--plot", str(target), "--theme", theme, *out]) == 0
    drawn = ElementTree.parse(target).getroot()
    lines = [e for e in drawn.iter() if e.tag.endswith("polyline")]
    assert len(lines) == len([e for e in drawn.iter() if e.tag.endswith("polygon")]) == 2
    assert {"ada", "bob", "Level (dB)"} <= {e.text for e in drawn.iter() if e.tag.endswith("text")}
    places = np.array([[float(n) for n in p.split(",")] for p in lines[0].get("points", "").split()])
    assert (np.diff(places[:, 0]) > 0).all()


def test_folders_without_labels_are_speakers(tmp_path: Path, capsys: pytest.CaptureFixture) -> None:
    for name, hertz in (("ada", 500), ("bob", 1000)):
        (tmp_path / name).mkdir()
        soundfile.write(tmp_path / name / "a.wav", tone(hertz, 0.5, 0.5), SAMPLE_RATE)
    (tmp_path / "bob" / "broken.wav").write_bytes(b"no sound")
    assert main(["spectra", str(tmp_path)]) == 1  # as one could not be read
    found = capsys.readouterr()
    assert found.out.startswith("frequency_hz,ada level_db,ada spread_db,bob level_db,bob spread_db\n")
    assert "broken.wav" in found.err


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["--phoneme", "q"], "there is no phoneme 'q'; choose one of"),
        (["--by", "dialect"], "choose"),
        (["--phoneme", "sch"], "nothing in its labels is one of the phonemes"),
    ],
)
def test_what_cannot_be_is_one_sentence(
    corpus: Path, words: list[str], said: str, capsys: pytest.CaptureFixture
) -> None:
    try:
        code = main(["spectra", str(corpus), *words])
    except SystemExit as ended:
        code = ended.code
    assert code != 0
    assert said in capsys.readouterr().err


def test_leaves_files_of_others_alone(corpus: Path, tmp_path: Path, capsys: pytest.CaptureFixture) -> None:
    target = tmp_path / "mine.csv"
    target.write_text("a diary")
    for option in ("-o", "--differences", "--plot"):
        assert main(["spectra", str(corpus), option, str(target)]) != 0
        assert target.read_text() == "a diary"
        assert "--overwrite" in capsys.readouterr().err
