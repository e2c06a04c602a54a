"""What the page on adding things shows is code that runs, with the program's own modules around it."""

import re
import textwrap
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from phonemeanalyser.desktop.session.sources import Playback
from phonemeengine.analyser import Analyser
from phonemeengine.audio.output import ClockOutput
from phonemeengine.mouth.exports.exporter import Exporter
from phonemeengine.mouth.table import table_of
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.model import load_model
from phonemeengine.settings import AnalysisSettings
from tests.conftest import ROOT
from tests.engine.mouth.speaking import speech
from tests.sounds import tone

PAGE = (ROOT / "docs" / "adding.md").read_text(encoding="utf-8")
ENGINE = ROOT / "engine" / "phonemeengine"


def blocks_of(section: str, language: str) -> list[str]:
    """Give the code of a section of the page that says how to add something."""
    text = PAGE.split(f"\n## {section}\n")[1].split("\n## ")[0]
    found = re.findall(rf"^( *)```{language}\n(.*?)^ *```", text, re.MULTILINE | re.DOTALL)
    return [textwrap.dedent(code) for _, code in found]


def defined_by(code: str) -> dict[str, Any]:
    names: dict[str, Any] = {}
    exec(compile(code, "adding.md", "exec"), names)
    return names


def test_the_format_that_the_docs_add_can_be_written() -> None:
    write = defined_by(blocks_of("An export format", "python")[0])["write"]
    text = "".join(write(Exporter("audacity").export_of(speech())))
    assert text.startswith("1\n00:00:00,000 --> 00:00:00,300\nsilence\n\n2\n00:00:00,300 --> ")


def test_the_filter_that_the_docs_add_is_written_as_the_others_are() -> None:
    filters, front_end = (ENGINE / name for name in ("dsp/spectrum.py", "features/front_end.py"))
    _, stage, fields_of_it, function, use = blocks_of("A filter", "python")
    code = f"{filters.read_text(encoding='utf-8')}\n{function}"
    gains = defined_by(code)["band_stop_gains"](5, 10.0, 15.0, 25.0)
    assert gains.tolist() == [1, 1, 0, 1, 1]
    assert use.splitlines()[0].replace("BAND_STOP", "LOW_PASS") in front_end.read_text(encoding="utf-8")
    settings = (ENGINE / "settings.py").read_text(encoding="utf-8")
    settings = settings.replace("    DENOISE = ", '    BAND_STOP = "band_stop"\n    DENOISE = ')
    (made,) = defined_by(f"{settings}\n_new = ({stage})")["_new"]
    assert [parameter.name for parameter in made.parameters] == ["band_stop_start", "band_stop_end"]
    assert [line.partition(":")[0] for line in fields_of_it.splitlines()] == ["band_stop_start", "band_stop_end"]


def test_the_variables_that_the_docs_add_measure() -> None:
    band, function, line = blocks_of("A variable", "python")
    measured = defined_by(f"from phonemeengine.features.variables import *\n_all = ({band})")["_all"]
    assert measured[0].bins(1024).start > 200
    code = (ENGINE / "features/variables.py").read_text(encoding="utf-8")
    found = defined_by(f"{code}\n{function}\n_new = ({line})")["_new"]
    assert found[0].measure(np.full((2, 2048), 0.5, np.float32)).tolist() == [0.5, 0.5]


def test_the_mouth_table_that_the_docs_add_can_be_read() -> None:
    table = table_of(blocks_of("A mouth table", "toml")[0])
    assert table.weights()[Phoneme.A].tolist() == [1.0]


def test_the_viseme_set_that_the_docs_add_is_saved_with_its_model(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    own = defined_by(blocks_of("A viseme set of a recogniser", "python")[0])["own"]
    assert load_model(tmp_path / "own.npz").viseme_set == own


def test_the_recogniser_that_the_docs_add_recognises() -> None:
    made = defined_by(blocks_of("A recogniser", "python")[0])["LoudnessRecogniser"](0.1)
    analysis = Analyser(Preset(settings=AnalysisSettings(statistics=False)), recogniser=made).push(
        tone(300, 0.5, 0.5)
    )
    assert Phoneme.A in analysis.phonemes.tolist()
    assert made.explain(analysis.features, 10).comparisons[0].threshold == "silence_max_energy"


def test_the_source_that_the_docs_add_has_all_that_a_source_has() -> None:
    code = (ROOT / "phonemeanalyser/desktop/session/sources.py").read_text(encoding="utf-8")
    code = code.replace("class SourceKind(StrEnum):", "class SourceKind(StrEnum):\n    RAIN = 'rain'")
    imports = "from phonemeengine.audio.tone import Tone, ToneKind\n"
    found = defined_by(f"{imports}{code}\n{blocks_of('A source of sound', 'python')[0]}")
    with_sound = found["RainSource"](Preset(), Playback(lambda _n: ClockOutput()))
    assert (with_sound.name, with_sound.seekable, with_sound.playing) == ("rain", False, False)
    with_sound.close()
