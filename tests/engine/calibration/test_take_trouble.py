"""Projects after a crash, with damaged lists, missing sounds and full disks: nothing that was made is lost."""

import json
from contextlib import suppress

import pytest
import soundfile

from phonemeengine.calibration.scores.corpus import read_corpus
from phonemeengine.calibration.takes.project import TakeProject
from phonemeengine.errors import EngineError, TakeError
from phonemeengine.phonemes import Phoneme
from tests.disks import refused
from tests.sounds import noise, vowel

SOUND = vowel((750, 1250), 0.3)
HISS = noise(0.3)


def change_both(project, one):
    other = project.takes[1]
    with project.together():
        project.relabel(one, Phoneme.E)
        project.delete(other)


CHANGES = {
    "together": change_both,
    "add": lambda project, one: project.add(HISS, "Ada", Phoneme.SZ),
    "trim": lambda project, one: project.trim(one, 0.1, 0.2),
    "relabel": lambda project, one: project.relabel(one, Phoneme.E),
    "exclude": lambda project, one: project.exclude(one),
    "delete": lambda project, one: project.delete(one),
    "undo": lambda project, one: project.undo(),
}


class Death(BaseException):
    """The process ends here."""


def made(folder):
    with TakeProject(folder) as project:
        return project.add(SOUND, "Ada", Phoneme.A), project.add(SOUND[::-1].copy(), "Bob", Phoneme.U)


def state(project):
    return [
        (t.number, t.phoneme, t.speaker, t.start, t.end, t.excluded, t.deleted)
        for t in (*project.takes, *project.deleted)
    ]


def check_that_all_agrees(folder):
    """Give the state of a project, after checking that its files say the same."""
    with TakeProject(folder) as project:
        counted = [t for t in project.takes if not t.excluded]
        utterances = read_corpus(folder)
        assert [u.path for u in utterances] == [project.path_of(t) for t in counted]
        for utterance, take in zip(utterances, counted, strict=True):
            assert [(x.phoneme, x.certainty) for x in utterance.labels] == [
                (x.phoneme, x.certainty) for x in take.to_labels()
            ]
        for take in (*project.takes, *project.deleted):
            assert soundfile.info(project.path_of(take)).frames == len(SOUND)
        assert project.missing == ()
        return state(project)


@pytest.mark.parametrize("name", CHANGES)
@pytest.mark.parametrize("n", range(1, 12))
def test_a_death_at_any_moment_leaves_the_old_state_or_the_new_one(tmp_path, name, n):
    folder = tmp_path / "p"
    made(folder)
    with TakeProject(folder) as project:
        first = project.takes[0]
        if name == "undo":
            first = project.relabel(first, Phoneme.O)
        old = state(project)
        with refused(folder, n, Death()) as death:
            try:
                CHANGES[name](project, first)
            except Death:
                pass
            else:
                assert len(death.changes) < n
    found = check_that_all_agrees(folder)
    assert found in (old, _new_of(old, name))


def _new_of(old, name):
    """Say what each change makes of the state, by hand."""
    number, _, speaker, start, end, _, _ = old[0]
    rest = old[1:]
    changed = {
        "together": [(number, Phoneme.E, *old[0][2:]), (*rest[0][:-1], True)],
        "trim": [(number, Phoneme.A, speaker, 0.1, 0.2, False, False), *rest],
        "relabel": [(number, Phoneme.E, speaker, start, end, False, False), *rest],
        "exclude": [(number, Phoneme.A, speaker, start, end, True, False), *rest],
        "delete": [*rest, (number, Phoneme.A, speaker, start, end, False, True)],
        "undo": [(number, Phoneme.A, speaker, start, end, False, False), *rest],
        "add": [*old, (3, Phoneme.SZ, "Ada", 0, 0.3, False, False)],
    }
    return changed[name]


@pytest.mark.parametrize("name", ["together", "add", "undo"])
@pytest.mark.parametrize("n", range(1, 7))
def test_a_disk_that_refuses_leaves_the_old_state_here_and_there(tmp_path, name, n):
    folder = tmp_path / "p"
    made(folder)
    with TakeProject(folder) as project:
        first = project.takes[0]
        if name == "undo":
            first = project.relabel(first, Phoneme.O)
        old = state(project)
        with refused(folder, n):
            try:
                CHANGES[name](project, first)
            except EngineError as error:
                told = str(error)
                assert state(project) == old
            else:
                told = None
        here = state(project)
    there = check_that_all_agrees(folder)
    assert there == here or (name == "add" and there == _new_of(old, name))
    assert told is None or "\n" not in told


@pytest.mark.parametrize("name", ["together", "add", "delete"])
@pytest.mark.parametrize("n", range(1, 8))
def test_after_one_refusal_of_the_disk_all_files_say_what_the_project_says(tmp_path, name, n):
    made(tmp_path)
    with TakeProject(tmp_path) as project:
        first = project.takes[0]
        if name == "undo":
            first = project.relabel(first, Phoneme.O)
        with suppress(EngineError), refused(tmp_path, n, once=True):
            CHANGES[name](project, first)
        counted = [t for t in project.takes if not t.excluded]
        found = read_corpus(tmp_path)
        assert [u.path for u in found] == [project.path_of(t) for t in counted]
        assert [[x.certainty for x in u.labels] for u in found] == [
            [x.certainty for x in t.to_labels()] for t in counted
        ]
        assert [[x.phoneme for x in u.labels] for u in found] == [[x.phoneme for x in t.to_labels()] for t in counted]
        assert len(list(tmp_path.glob("*/*/*.flac"))) <= 3


def test_a_project_of_a_newer_version_is_left_alone(tmp_path):
    made(tmp_path)
    path = tmp_path / "takes.json"
    path.write_text(path.read_text().replace('"version": 1', '"version": 2'))
    before = {p: p.read_bytes() for p in tmp_path.rglob("*") if p.is_file() and p.suffix != ".lock"}
    with pytest.raises(TakeError, match="a newer version of the program wrote this project"):
        TakeProject(tmp_path)
    assert {p: p.read_bytes() for p in tmp_path.rglob("*") if p.is_file() and p.suffix != ".lock"} == before


@pytest.mark.parametrize("damage", ["", '{"format": "other"}', '{"a": ' * 5000])
def test_a_damaged_list_is_kept_and_all_takes_come_back(tmp_path, damage):
    with TakeProject(tmp_path) as project:
        one = project.trim(project.add(SOUND, "Ada / A.", Phoneme.A, device="Mic"), 0.1, 0.2)
        two = project.exclude(project.add(SOUND, "Bob", Phoneme.U))
        three = project.delete(project.add(SOUND, "Bob", Phoneme.O))
    (tmp_path / "takes.json").write_text(damage)
    with TakeProject(tmp_path) as project:
        first, second = project.takes
        assert first == one
        assert (second.number, second.phoneme, second.excluded) == (two.number, two.phoneme, True)
        assert [t.number for t in project.deleted] == [three.number]
        assert "takes.json is damaged" in project.notes[0]
        assert "kept as takes.damaged.json" in project.notes[0]
    assert (tmp_path / "takes.damaged.json").read_text() == damage
    with TakeProject(tmp_path) as project:
        assert project.notes == ()
        assert len(project.takes) == 2


@pytest.mark.parametrize("lost", [("takes.json",), ("takes.json", "manifest.csv")])
def test_takes_come_back_without_the_list(tmp_path, lost):
    one, two = made(tmp_path)
    with TakeProject(tmp_path) as project:
        two = project.exclude(two)
    for name in lost:
        (tmp_path / name).unlink()
    with TakeProject(tmp_path) as project:
        assert [(t.number, t.speaker, t.phoneme) for t in project.takes] == [
            (1, "Ada", one.phoneme),
            (2, "Bob", two.phoneme),
        ]
        assert [t.excluded for t in project.takes] == [False, "manifest.csv" not in lost]
        assert "are not in takes.json" in project.notes[0]


@pytest.mark.parametrize(
    ("field", "value"),
    [("phoneme", "th"), ("end", 99.0), ("sound", "../../x/a-1.flac"), ("speaker", None), ("pauses", [["0.1", 0.3]])],
)
def test_one_damaged_entry_does_not_cost_the_others(tmp_path, field, value):
    one, two = made(tmp_path)
    path = tmp_path / "takes.json"
    document = json.loads(path.read_text())
    document["takes"][0][field] = value
    path.write_text(json.dumps(document))
    with TakeProject(tmp_path) as project:
        assert project.takes == (one, two)
        assert "damaged" in project.notes[0]


def test_a_missing_sound_is_told_and_comes_back_with_its_file(tmp_path):
    one, two = made(tmp_path)
    hidden = tmp_path.with_name("hidden.flac")
    (tmp_path / one.sound).rename(hidden)
    with TakeProject(tmp_path) as project:
        assert (project.takes, project.missing) == ((two,), (one,))
        assert project.notes == ("takes/Ada/a-1.flac is missing; put it back and open the project again",)
        assert [u.speaker for u in read_corpus(tmp_path)] == ["Bob"]
        with pytest.raises(TakeError, match="a-1"):
            project.trim(one, 0.1, 0.2)
        project.trim(two, 0.1, 0.2)
    hidden.rename(tmp_path / one.sound)
    with TakeProject(tmp_path) as project:
        assert project.takes[0] == one


def test_a_sound_that_somebody_put_there_is_taken_in(tmp_path):
    made(tmp_path)
    soundfile.write(tmp_path / "takes" / "Ada" / "m-1.flac", HISS, 44_100)
    (tmp_path / "takes" / "Ada" / "notes.flac").write_bytes(b"no take")
    (tmp_path / "takes" / "Ada" / "e-9.flac").write_bytes(b"no sound")
    with TakeProject(tmp_path) as project:
        assert [(t.number, t.name) for t in project.takes][2:] == [(3, "m-3")]
        assert "takes/Ada/m-1.flac is not in takes.json" in project.notes[0]
    assert (tmp_path / "takes" / "Ada" / "notes.flac").exists()


def test_a_file_of_another_in_the_way_is_not_overwritten(tmp_path):
    made(tmp_path)
    with TakeProject(tmp_path) as project:
        other = tmp_path / "deleted" / "Ada" / "a-1.flac"
        other.parent.mkdir(parents=True)
        other.write_bytes(b"somebody's")
        gone = project.delete(project.takes[0])
        assert gone.sound == "deleted/Ada/a-1 (2).flac"
        assert other.read_bytes() == b"somebody's"
        project.undo()
        assert project.takes[0].sound == "takes/Ada/a-1.flac"
