"""What a voice's takes make of each recogniser's preset, and what is never paid for it."""

from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import soundfile

from phonemeanalyser.cli.main import main
from phonemeanalyser.desktop.calibrate.guide.guide_model import QUIET, SOUNDS
from phonemeengine.calibration.calibrate import MOST_LOSS, calibrate, loss_of
from phonemeengine.calibration.fits.templates import adapt_to_takes
from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.calibration.scores.evaluation import predict
from phonemeengine.calibration.scores.scoring import Scores, scores_of
from phonemeengine.calibration.takes.project import TakeProject
from phonemeengine.calibration.takes.quality import check_take
from phonemeengine.calibration.takes.room_noise import measure_room
from phonemeengine.errors import CorpusError, PresetError
from phonemeengine.labels.table import format_table
from phonemeengine.labels.utterance import CORE, Label
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import DEFAULT_PRESET, FACTORY, load_preset
from phonemeengine.presets.model_choice import for_live_use
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.spec import BUILT_IN, TEMPLATES
from phonemeengine.settings import SAMPLE_RATE
from tests.desktop.calibrate.calibrating import ROOM, in_room, said
from tests.sounds import silence

P = Phoneme
ORDER = (P.SILENCE, P.M, P.A, P.SZ, P.I, P.SCH, P.E, P.SILENCE, P.O, P.M, P.U, P.SZ, P.A, P.SILENCE)
"""What the voice says in the sentence that is held out."""


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Iterator[TakeProject]:
    """A take of each sound by one voice."""
    with TakeProject(tmp_path_factory.mktemp("project")) as project:
        for step in (QUIET, *SOUNDS):
            sound = in_room(np.concatenate((silence(0.2), said(step.phoneme, 1.4))))
            project.add(sound, "Ann", step.phoneme, report=check_take(sound, ROOM, step.phoneme))
        yield project


@pytest.fixture(scope="module")
def takes(project: TakeProject) -> tuple[LabelledUtterance, ...]:
    return tuple(LabelledUtterance(project.path_of(t), t.to_labels(), t.speaker, "takes") for t in project.takes)


@pytest.fixture(scope="module")
def sentence(tmp_path_factory: pytest.TempPathFactory) -> LabelledUtterance:
    """The same voice at another pitch, in other company."""
    path, parts, labels, at = tmp_path_factory.mktemp("sentence") / "s.wav", [], [], 0.0
    for phoneme in ORDER:
        seconds = 0.5 if phoneme is P.SILENCE else 0.2
        parts.append(said(phoneme, seconds, f0=150))
        labels.append(Label(at, at + seconds, phoneme.label, phoneme))
        at += seconds
    soundfile.write(path, in_room(np.concatenate(parts)), SAMPLE_RATE, subtype="FLOAT")
    return LabelledUtterance(path, tuple(labels), "Ann", "held out")


def scores(preset: Preset, utterance: LabelledUtterance) -> Scores:
    return scores_of([predict(utterance, preset).answers])


@pytest.mark.parametrize(
    "name", ["thesis", "templates", *(pytest.param(name, marks=pytest.mark.long) for name in ("extended", "learned"))]
)
def test_a_voice_is_recognised_better_in_a_sentence_that_taught_nothing(
    takes: tuple[LabelledUtterance, ...], sentence: LabelledUtterance, name: str
):
    preset = load_preset(FACTORY / f"{name}.toml")
    outcome = calibrate(preset, takes, held_out=[sentence])
    assert outcome.gains
    before, after = (for_live_use(used) if name == "learned" else used for used in (preset, outcome.preset))
    assert outcome.before == scores(before, sentence)  # the figures are of the sentence alone
    assert outcome.after == scores(after, sentence)
    assert outcome.after.macro_f1 > outcome.before.macro_f1 + 0.02
    assert loss_of(outcome.before, outcome.after) == ""
    assert outcome.preset.recogniser == preset.recogniser
    judged = outcome.preset.judged
    assert judged is not None
    assert judged.start == preset.name
    assert judged.macro_f1 == pytest.approx((outcome.before.macro_f1, outcome.after.macro_f1), abs=1e-4)
    assert outcome.preset.summary.startswith(f"{preset.name}, own voice, 20")
    assert not outcome.preset.notes  # that is the description of what it came from
    assert outcome.gained.macro_f1.difference == pytest.approx(outcome.after.macro_f1 - outcome.before.macro_f1)
    assert outcome.seconds == pytest.approx(sentence.labels[-1].end)
    assert outcome.silence_accuracy is not None
    assert outcome.silence_accuracy.room_silent.value > 0.9


def test_without_a_sentence_quarters_of_the_takes_are_held_out(takes: tuple[LabelledUtterance, ...]):
    outcome = calibrate(load_preset(FACTORY / "templates.toml"), takes)
    assert outcome.cross_validated
    assert outcome.gains
    counted = sum(x.end - x.start for u in takes for x in u.labels if x.certainty == CORE)
    assert outcome.seconds == pytest.approx(counted)


def a_deaf_one(preset: Preset) -> Preset:
    """The preset with templates of this voice that takes hardly anything for speech."""
    assert preset.templates is not None
    return replace(preset, templates=replace(preset.templates, silence_below=-22.0))


def deaf(*given) -> tuple[Preset, ...]:
    return (a_deaf_one(adapt_to_takes(*given)[0]),)


def deaf_or_half(*given) -> tuple[Preset, ...]:
    return a_deaf_one(adapt_to_takes(*given)[0]), adapt_to_takes(*given)[1]


def learn_by(monkeypatch: pytest.MonkeyPatch, adapt: Callable[..., object]) -> None:
    """Have templates learn a voice in another way."""
    monkeypatch.setitem(BUILT_IN, "templates", replace(TEMPLATES, adapt=f"{__name__}:{adapt.__name__}"))


@pytest.mark.parametrize("held_out", [True, False])
def test_what_gains_by_losing_speech_is_refused_and_something_milder_taken(
    takes: tuple[LabelledUtterance, ...], sentence: LabelledUtterance, monkeypatch: pytest.MonkeyPatch, held_out: bool
):
    learn_by(monkeypatch, deaf_or_half)
    preset = load_preset(FACTORY / "templates.toml")
    others = [sentence] if held_out else []
    outcome = calibrate(preset, takes, held_out=others)
    assert "false silence rises from" in outcome.refusal
    assert "a weaker one was chosen" in outcome.refusal
    assert outcome.gains
    assert outcome.after.false_silence <= outcome.before.false_silence + MOST_LOSS
    assert outcome.after.viseme_accuracy >= outcome.before.viseme_accuracy - MOST_LOSS


def test_where_only_what_costs_gains_the_preset_stays_as_it_was(
    takes: tuple[LabelledUtterance, ...], sentence: LabelledUtterance, monkeypatch: pytest.MonkeyPatch
):
    learn_by(monkeypatch, deaf)
    preset = load_preset(FACTORY / "templates.toml")
    outcome = calibrate(preset, takes, held_out=[sentence])
    assert outcome.preset is preset
    assert not outcome.gains
    assert outcome.after == outcome.before
    assert outcome.refusal.endswith("; the preset stays unchanged.")


def test_what_gets_worse_is_said_with_both_figures():
    figures = Scores(0.5, 0.5, 0.5, 0.8, 0.5, 0.999, 0.02, 10, 10, 1, 0.6)
    assert loss_of(figures, replace(figures, viseme_accuracy=0.7901, false_silence=0.0299)) == ""
    worse = replace(figures, silence_recall=0.397, false_silence=0.05)
    assert loss_of(figures, worse) == (
        "silence recall falls from 99.9 % to 39.7 % and false silence rises from 2.0 % to 5.0 %"
    )
    assert loss_of(figures, figures, " in the small network") == ""
    assert loss_of(figures, worse, " in the small network").endswith("rises from 2.0 % to 5.0 % in the small network")
    unknown = replace(figures, silence_recall=float("nan"))
    assert loss_of(unknown, figures) == loss_of(figures, unknown) == ""


def test_the_pauses_of_a_p_are_silence(takes: tuple[LabelledUtterance, ...]):
    said_p = takes[-1]
    certain = [label for label in said_p.labels if label.certainty == CORE]
    bursts = [label for label in certain if label.phoneme is P.P]
    pauses = [label for label in certain if label.phoneme is P.SILENCE]
    assert len(bursts) == 7  # one each 0.2 s, of 0.05 s
    assert len(pauses) == 6
    for k, burst in enumerate(bursts):
        assert burst.start == pytest.approx(0.2 + 0.2 * k, abs=0.021)
        assert burst.end - burst.start < 0.1


def test_the_command_line_gives_the_same_preset(
    project: TakeProject, takes: tuple[LabelledUtterance, ...], sentence: LabelledUtterance, tmp_path: Path, capsys
):
    sentence.path.with_suffix(".csv").write_text(format_table(sentence.labels), encoding="utf-8")
    preset = load_preset(FACTORY / "thesis.toml")
    expected = calibrate(preset, takes, held_out=[sentence]).preset
    out = tmp_path / "mine.toml"
    arguments = [str(project.folder), "-o", str(out), "--preset", str(FACTORY / "thesis.toml")]
    assert main(["adapt", *arguments, "--held-out", str(sentence.path)]) == 0
    assert "on held-out recordings, 4 s: macro F1 " in capsys.readouterr().out
    found = load_preset(out)
    assert found.name == "mine"
    for name_of in ("settings", "thresholds", "rules", "model", "templates", "sensitivities", "recogniser"):
        assert getattr(found, name_of) == getattr(expected, name_of), name_of


def test_the_room_sets_the_silence_of_rules(takes: tuple[LabelledUtterance, ...], sentence: LabelledUtterance):
    preset = load_preset(FACTORY / "thesis.toml")
    room = measure_room(in_room(silence(2.0)), preset)
    found = calibrate(preset, takes, held_out=[sentence], room=in_room(silence(2.0))).preset
    assert found.settings.denoise_threshold == room.set_silence(preset).settings.denoise_threshold


def test_what_gains_nothing_leaves_the_preset_as_it_was(
    takes: tuple[LabelledUtterance, ...], sentence: LabelledUtterance
):
    preset = calibrate(load_preset(FACTORY / "templates.toml"), takes, held_out=[sentence]).preset
    outcome = calibrate(preset, takes, held_out=[sentence])
    assert outcome.preset is preset
    assert not outcome.gains


def test_what_cannot_learn_says_so(takes: tuple[LabelledUtterance, ...]):
    preset = load_preset(DEFAULT_PRESET)
    with pytest.raises(PresetError, match="needs a model"):
        calibrate(replace(preset, model=None), takes)
    with pytest.raises(CorpusError, match="no takes to calibrate with"):
        calibrate(preset, ())


def test_files_of_takes_stay_as_they_are(takes: tuple[LabelledUtterance, ...]):
    before = [Path(u.path).read_bytes() for u in takes]
    calibrate(load_preset(FACTORY / "templates.toml"), takes)
    assert [Path(u.path).read_bytes() for u in takes] == before
