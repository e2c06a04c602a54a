"""``phonemeanalyser measure``: the table of a stretch, the stretch itself, and its spectrum."""

from pathlib import Path

import pytest
import soundfile

import phonemeanalyser
from phonemeanalyser.__main__ import main
from phonemeengine import load_preset, measure
from phonemeengine.inspection.averaged_spectrum import load_averaged_spectrum
from phonemeengine.inspection.measurement import format_measurement
from tests.tables import Capsys

DEMO = Path(phonemeanalyser.__file__).parent / "demo" / "demo.flac"


def test_prints_what_the_api_measures(capsys: Capsys) -> None:
    assert main(["measure", str(DEMO), "--from", "0.5", "--to", "2"]) == 0
    assert capsys.readouterr().out == format_measurement(measure(DEMO, 0.5, 2.0, load_preset("learned")))


def test_writes_table_sound_and_spectrum(tmp_path: Path) -> None:
    table, sound, spectrum = (tmp_path / name for name in ("t.csv", "s.wav", "c.csv"))
    wanted = ["measure", str(DEMO), "--from", "0.5", "--to", "1.5", "-o", str(table)]
    assert main([*wanted, "--sound-out", str(sound), "--spectrum-out", str(spectrum)]) == 0
    assert table.read_text().startswith("measure,unit,mean,min,max\nduration,s,1.000")
    assert soundfile.info(sound).duration == pytest.approx(1.0)
    assert load_averaged_spectrum(spectrum).n_frames == 100
    assert main(wanted) == 0  # the table is our own


@pytest.mark.parametrize("option", ["-o", "--spectrum-out"])
def test_leaves_files_of_others_alone(tmp_path: Path, option: str, capsys: Capsys) -> None:
    target = tmp_path / "mine.wav"
    target.write_text("a diary")
    assert main(["measure", str(DEMO), "--to", "1", option, str(target)]) != 0
    assert target.read_text() == "a diary"
    assert "--overwrite" in capsys.readouterr().err
    assert main(["measure", str(DEMO), "--to", "1", option, str(target), "--overwrite"]) == 0


def test_a_stretch_beyond_the_sound_is_one_sentence(capsys: Capsys) -> None:
    assert main(["measure", str(DEMO), "--from", "900", "--to", "901"]) != 0
    assert "there is no sound from 900 to 901 s" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("option", "sentence"),
    [
        (("--ceiling", "10"), "--ceiling: must be a number in 3000..10000 Hz, got '10'"),
        (("--from", "-1"), "--from: must be a number of 0 s or more, got '-1'"),
    ],
)
def test_a_number_out_of_range_is_one_sentence(option: tuple[str, str], sentence: str, capsys: Capsys) -> None:
    with pytest.raises(SystemExit):
        main(["measure", str(DEMO), *option])
    assert sentence in capsys.readouterr().err
