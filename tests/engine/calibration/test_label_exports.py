"""Label files for Praat and Audacity beside takes: they follow their takes, and count for nothing."""

from contextlib import suppress
from pathlib import Path

import numpy as np
import parselmouth
import pytest
from parselmouth.praat import call

from phonemeengine.calibration.scores.corpus import read_recordings
from phonemeengine.calibration.takes.project import TakeProject
from phonemeengine.calibration.takes.quality import check_take
from phonemeengine.calibration.takes.storage import COPY_SUFFIXES
from phonemeengine.errors import EngineError
from phonemeengine.labels.files import read_labels, write_labels
from phonemeengine.labels.utterance import Label
from phonemeengine.phonemes import Phoneme
from tests.disks import refused
from tests.sounds import noise, silence, vowel

SOUND = (np.concatenate([silence(0.4), vowel((750, 1250), 1.0), silence(0.3)]) + noise(1.7, 0.001)).astype(np.float32)
REPORT = check_take(SOUND, 0.001, Phoneme.A)


@pytest.fixture
def project(tmp_path):
    with TakeProject(tmp_path / "my takes") as made:
        yield made


@pytest.fixture
def take(project):
    made = project.add(SOUND, "Ada", Phoneme.A, report=REPORT)
    for suffix in COPY_SUFFIXES:
        assert project.write_copies(suffix) == ()
    return made


def heard(labels):
    return [(round(x.start, 6), round(x.end, 6), x.phoneme) for x in labels]


def beside(project, take):
    """Give the label files beside a take's sound by their endings; they must all say what the take says."""
    files = [p for p in project.path_of(take).parent.glob("*") if p.suffix != ".flac"]
    for path in files:
        assert path.stem == project.path_of(take).stem
        assert heard(read_labels(path)) == heard(take.to_labels()), path.name
    return sorted(path.suffix for path in files)


ALL = [".TextGrid", ".csv", ".txt"]


def test_copies_cover_the_whole_sound_as_the_table_does(project, take):
    assert beside(project, take) == ALL
    assert [x.phoneme.label for x in take.to_labels()] == ["silence", "unidentified", "a", "unidentified", "silence"]
    grid = parselmouth.read(str(project.path_of(take).with_suffix(".TextGrid")))
    assert call(grid, "Get total duration") == pytest.approx(1.7)
    assert call(grid, "Get number of intervals", 1) == 5


def test_excluded_takes_have_copies_too_and_deleted_ones_have_not(project):
    one, two = (project.add(SOUND, "Ada", p) for p in (Phoneme.A, Phoneme.E))
    one, two = project.exclude(one), project.delete(two)
    project.write_copies(".TextGrid")
    assert project.path_of(one).with_suffix(".TextGrid").exists()
    assert not project.path_of(two).with_suffix(".TextGrid").exists()


CHANGES = {
    "trim": lambda project, take: project.trim(take, 0.6, 0.9),
    "relabel": lambda project, take: project.relabel(take, Phoneme.E),
    "exclude": lambda project, take: project.exclude(take),
    "delete": lambda project, take: project.delete(take),
}


@pytest.mark.parametrize("change", CHANGES)
def test_copies_follow_their_take_there_and_back(project, take, change):
    old = project.path_of(take)
    changed = CHANGES[change](project, take)
    assert beside(project, changed) == ALL
    if project.path_of(changed) != old:
        assert list(old.parent.glob("a-1.*")) == []
    assert beside(project, project.undo()) == ALL
    assert beside(project, project.redo()) == ALL


def test_a_take_that_is_removed_for_ever_takes_its_copies_along(project, take):
    gone = project.delete(take)
    project.empty_deleted()
    assert list(project.path_of(gone).parent.glob("*")) == []


def test_only_what_was_asked_for_is_written(project):
    take = project.add(SOUND, "Ada", Phoneme.A)
    project.write_copies(".txt")
    assert beside(project, project.relabel(take, Phoneme.E)) == [".csv", ".txt"]


@pytest.mark.parametrize("place", [".", "takes", "takes/Ada", "takes/Ada/{name}"])
@pytest.mark.parametrize("change", ["trim", "relabel"])
def test_a_stale_textgrid_beside_a_take_counts_for_nothing(project, take, place, change):
    stale = project.path_of(take).with_suffix(".TextGrid").read_bytes()
    take = CHANGES[change](project, take)
    project.path_of(take).with_suffix(".TextGrid").write_bytes(stale)  # as if another program had kept it
    assert heard(read_labels(project.path_of(take).with_suffix(".TextGrid"))) != heard(take.to_labels())
    (found,) = read_recordings(project.folder / place.format(name=project.path_of(take).name))
    assert [(x.phoneme, x.certainty) for x in found.labels] == [(x.phoneme, x.certainty) for x in take.to_labels()]
    assert heard(found.labels) == heard(take.to_labels())
    project.close()
    with TakeProject(project.folder) as again:
        assert (again.takes, again.notes) == ((take,), ())


def test_a_take_that_comes_back_without_its_list_is_labelled_by_its_table(project, take):
    stale = project.path_of(take).with_suffix(".TextGrid").read_bytes()
    take = project.trim(take, 0.6, 0.9)
    project.path_of(take).with_suffix(".TextGrid").write_bytes(stale)
    project.close()
    (project.folder / "takes.json").unlink()
    with TakeProject(project.folder) as again:
        assert [(t.start, t.end, t.phoneme) for t in again.takes] == [(0.6, 0.9, Phoneme.A)]


def test_what_praat_only_saved_again_is_still_a_copy(project, take):
    path = project.path_of(take).with_suffix(".TextGrid")
    parselmouth.read(str(path)).save(str(path))
    assert beside(project, project.trim(take, 0.6, 0.9)) == ALL


def test_what_somebody_labelled_himself_is_not_touched_until_copies_are_asked_for_and_then_kept(project, take):
    path = project.path_of(take).with_suffix(".TextGrid")
    mine = (Label(0.5, 0.8, "a", Phoneme.A), Label(0.8, 1.0, "u", Phoneme.U))
    write_labels(mine, path, duration=1.7)
    take = project.trim(take, 0.6, 0.9)
    assert heard(read_labels(path)) == heard(mine)
    project.relabel(take, Phoneme.E)
    assert heard(read_labels(path)) == heard(mine)
    take = project.undo()
    (aside,) = project.write_copies(".TextGrid")
    assert aside == path.with_name("a-1 (2).TextGrid")
    assert heard(read_labels(aside)) == heard(mine)
    assert heard(read_labels(path)) == heard(take.to_labels())
    assert project.write_copies(".TextGrid") == ()
    (found,) = read_recordings(project.folder / "takes")
    assert heard(found.labels) == heard(take.to_labels())


def test_notes_beside_a_take_are_no_copy(project):
    take = project.add(SOUND, "Ada", Phoneme.A)
    notes = project.path_of(take).with_suffix(".txt")
    notes.write_text("she had a cold\n")
    project.trim(take, 0.6, 0.9)
    assert notes.read_text() == "she had a cold\n"
    (aside,) = project.write_copies(".txt")
    assert aside.read_text() == "she had a cold\n"


def test_a_disk_that_refuses_leaves_what_was_there(project, take):
    mine = project.path_of(take).with_suffix(".TextGrid")
    mine.write_text("mine")
    refusal = pytest.raises(EngineError, match=r"a-1\.TextGrid: this file cannot be renamed \(Permission denied\)")
    with refused(project.folder, error=OSError(13, "Permission denied")), refusal:
        project.write_copies(".TextGrid")
    assert mine.read_text() == "mine"


class Death(BaseException):
    """The process ends here."""


@pytest.mark.parametrize(
    ("change", "error"),
    [("trim", OSError(28, "No space left on device")), ("delete", OSError(28, "full")), ("relabel", Death())],
)
def test_wherever_a_change_breaks_no_copy_says_anything_else_than_its_take(tmp_path, change, error):
    for n in range(1, 60):
        folder = tmp_path / str(n)
        with TakeProject(folder) as project:
            take = project.add(SOUND, "Ada", Phoneme.A, report=REPORT)
            for suffix in COPY_SUFFIXES:
                project.write_copies(suffix)
            with suppress(EngineError, Death), refused(folder, n, error) as refusal:
                CHANGES[change](project, take)
        with TakeProject(folder) as again:
            for found in (*again.takes, *again.deleted):
                beside_found = [again.path_of(found).with_suffix(suffix) for suffix in COPY_SUFFIXES]
                for path in filter(Path.exists, beside_found):
                    assert heard(read_labels(path)) == heard(found.to_labels()), (n, path)
        if len(refusal.changes) < n:
            assert n > 5
            return
    pytest.fail("the change has more steps than this test thought")
