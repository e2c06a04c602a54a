"""A project of takes: what is kept, what other programs read, and that every change can be undone."""

import json
from datetime import datetime

import numpy as np
import pytest
import soundfile

from phonemeengine.calibration.scores.corpus import frame_labels_of, read_corpus
from phonemeengine.calibration.takes.project import TakeProject
from phonemeengine.calibration.takes.quality import check_take
from phonemeengine.calibration.takes.take import Take, folder_for
from phonemeengine.errors import CorpusError, RecordingError, TakeError
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import SAMPLE_RATE
from tests.sounds import noise, silence, vowel

SOUND = vowel((750, 1250), 0.5)


@pytest.fixture
def project(tmp_path):
    with TakeProject(tmp_path / "my takes") as made:
        yield made


def in_manifest(project):
    return [(u.path.name, u.speaker) for u in read_corpus(project.folder)]


def test_a_take_is_a_sound_file_with_labels_in_the_corpus_format(project):
    sound = np.concatenate([silence(0.4), vowel((750, 1250), 1.0), silence(0.3)]) + noise(1.7, 0.001)
    report = check_take(sound, 0.001, Phoneme.A)
    time = datetime(2026, 1, 2, 3, 4, 5).astimezone()
    take = project.add(sound, "Ada", Phoneme.A, report=report, device="Mic 1", time=time)
    assert (take.sound, take.labels, take.name) == ("takes/Ada/a-1.flac", "takes/Ada/a-1.csv", "a-1")
    assert (take.device, take.time) == ("Mic 1", time.isoformat())
    kept, rate = soundfile.read(project.path_of(take), dtype="float32")
    assert rate == SAMPLE_RATE
    assert np.abs(kept - sound).max() < 2**-23
    (utterance,) = read_corpus(project.folder)
    assert (utterance.speaker, utterance.path) == ("Ada", project.path_of(take))
    labels = frame_labels_of(utterance.labels)
    assert labels.certain.sum() == pytest.approx(90, abs=4)
    assert set(labels.phonemes[labels.certain]) == {Phoneme.A}
    assert set(labels.phonemes[:38]) == {Phoneme.SILENCE}
    assert labels.phonemes[42] == Phoneme.UNIDENTIFIED
    assert len(labels.phonemes) == 170


def test_without_a_check_all_of_a_sound_counts(project):
    take = project.add(SOUND, "Ada", Phoneme.A)
    assert (take.start, take.end, take.duration) == (0, 0.5, 0.5)
    assert [x.phoneme for x in take.to_labels()] == [Phoneme.A]


def test_numbers_are_never_given_twice(project):
    first = project.add(SOUND, "Ada", Phoneme.A)
    project.delete(first)
    second = project.add(SOUND, "Ada", Phoneme.A)
    assert (first.number, second.number) == (1, 2)
    project.empty_deleted()
    (project.folder / "takes" / "Ada" / "m-7.flac").write_bytes(b"somebody's")
    assert project.add(SOUND, "Ada", Phoneme.M).number == 8


def test_trimming_leaves_the_sound_as_it_is(project):
    take = project.add(SOUND, "Ada", Phoneme.A)
    before = project.path_of(take).read_bytes()
    trimmed = project.trim(take, 0.1, 0.3)
    assert project.path_of(trimmed).read_bytes() == before
    frames = frame_labels_of(read_corpus(project.folder)[0].labels)
    assert np.flatnonzero(frames.certain).tolist() == list(range(10, 30))
    assert set(frames.phonemes[~frames.certain]) == {Phoneme.UNIDENTIFIED}


def test_changes_made_together_are_undone_together_or_alone_and_a_refused_one_takes_all_back(project):
    takes = [project.add(SOUND, "Ada", Phoneme.A) for _ in range(3)]
    with project.together():
        for take in takes:
            project.exclude(take)
    assert [take.excluded for take in project.takes] == [True] * 3
    project.undo()
    assert [take.excluded for take in project.takes] == [True, True, False]
    with project.together():
        project.undo()
        project.undo()
    assert in_manifest(project) == [(f"a-{k}.flac", "Ada") for k in (1, 2, 3)]

    def delete_and_trim_too_far() -> None:
        with project.together():
            project.delete(takes[0])
            project.trim(takes[1], 0.4, 0.1)

    with pytest.raises(TakeError):
        delete_and_trim_too_far()
    assert project.takes == tuple(takes)
    assert project.changes == ("add a-1", "add a-2", "add a-3")
    assert in_manifest(project) == [(f"a-{k}.flac", "Ada") for k in (1, 2, 3)]


@pytest.mark.parametrize("stretch", [(-0.1, 0.2), (0.2, 0.2), (0.3, 0.2), (0.1, 0.6), (float("nan"), 0.2)])
def test_an_impossible_stretch_is_refused_and_changes_nothing(project, stretch):
    take = project.add(SOUND, "Ada", Phoneme.A)
    with pytest.raises(TakeError, match=r"a-1: what counts of a take must lie in its 0\.5 s"):
        project.trim(take, *stretch)
    assert project.takes == (take,)
    assert project.changes == ("add a-1",)


def test_relabelling_renames_the_files(project):
    take = project.relabel(project.add(SOUND, "Ada", Phoneme.A), Phoneme.E)
    assert take.sound == "takes/Ada/e-1.flac"
    assert sorted(p.name for p in project.path_of(take).parent.iterdir()) == ["e-1.csv", "e-1.flac"]
    assert [x.phoneme for x in read_corpus(project.folder)[0].labels] == [Phoneme.E]


def test_an_excluded_take_counts_for_nothing_but_stays(project):
    one, two = (project.add(SOUND, "Ada", p) for p in (Phoneme.A, Phoneme.E))
    one = project.exclude(one)
    assert in_manifest(project) == [("e-2.flac", "Ada")]
    assert project.takes == (one, two)
    project.include(one)
    assert len(in_manifest(project)) == 2


def test_a_deleted_take_lies_among_the_deleted_until_they_are_emptied(project):
    one, two = (project.add(SOUND, "Ada", p) for p in (Phoneme.A, Phoneme.E))
    gone = project.delete(one)
    assert gone.sound == "deleted/Ada/a-1.flac"
    assert project.path_of(gone).is_file()
    assert not project.path_of(one).exists()
    assert (project.takes, project.deleted) == ((two,), (gone,))
    back = project.restore(gone)
    assert back == one
    assert len(in_manifest(project)) == 2
    project.delete(back)
    assert project.empty_deleted() == 1
    assert not project.path_of(gone).exists()
    assert (project.deleted, project.changes) == ((), ())


def test_every_change_is_undone_and_done_again(project):
    states = [project.takes]
    names = []

    def note(take):
        states.append(project.takes)
        names.append(project.changes[-1])
        return take

    take = note(project.add(SOUND, "Ada", Phoneme.A))
    take = note(project.trim(take, 0.1, 0.3))
    take = note(project.relabel(take, Phoneme.U))
    take = note(project.exclude(take))
    take = note(project.delete(take))
    take = note(project.restore(take))
    assert names == ["add a-1", "trim a-1", "relabel a-1", "exclude u-1", "delete u-1", "restore u-1"]
    for state, name in zip(states[-2::-1], names[::-1], strict=True):
        assert project.changes[-1] == name
        project.undo()
        assert project.takes == state
        assert all(project.path_of(t).is_file() for t in (*project.takes, *project.deleted))
    assert project.undo() is None
    for state, name in zip(states[1:], names, strict=True):
        project.redo()
        assert project.changes[-1] == name
        assert project.takes == state
    assert project.redo() is None
    kept, _ = soundfile.read(project.path_of(project.takes[0]), dtype="float32")
    assert np.abs(kept - SOUND).max() < 2**-23


def test_what_is_done_after_undoing_forgets_what_was_undone(project):
    take = project.add(SOUND, "Ada", Phoneme.A)
    project.trim(take, 0.1, 0.2)
    project.undo()
    project.exclude(take)
    assert project.redo() is None


def test_a_change_to_what_it_is_already_is_none(project):
    take = project.add(SOUND, "Ada", Phoneme.A)
    assert project.include(take) == project.relabel(take, Phoneme.A) == project.restore(take) == take
    assert project.changes == ("add a-1",)


def test_a_project_is_found_again_as_it_was_left(project):
    one, two, three = (project.add(SOUND, name, Phoneme.A) for name in ("Ada", "Bob: Ä/ö?", "CON"))
    project.trim(two, 0.1, 0.2)
    project.exclude(one)
    project.delete(three)
    takes, deleted = project.takes, project.deleted
    project.close()
    with TakeProject(project.folder) as again:
        assert (again.takes, again.deleted, again.notes) == (takes, deleted, ())
        assert again.changes == ()
        assert again.takes[1].speaker == "Bob: Ä/ö?"


def test_the_pauses_of_a_p_are_labelled_and_found_again(project):
    puffs = np.tile(np.concatenate((noise(0.05, 0.3), silence(0.25))), 4) + noise(1.2, 0.001, seed=3)
    take = project.add(puffs, "Ada", Phoneme.P, report=check_take(puffs, 0.001, Phoneme.P))
    said = [label.phoneme for label in take.to_labels() if label.certainty == "core"]
    assert said == [Phoneme.P, *[Phoneme.SILENCE, Phoneme.P] * 3]
    trimmed = project.trim(take, 0.1, 0.5)  # in the midst of two pauses
    said = [label.phoneme for label in trimmed.to_labels() if label.certainty == "core"]
    assert said == [Phoneme.SILENCE, Phoneme.P, Phoneme.SILENCE]
    project.trim(trimmed, take.start, take.end)
    project.close()
    with TakeProject(project.folder) as again:
        assert again.takes == (take,)
    (project.folder / "takes.json").unlink()
    with TakeProject(project.folder) as again:
        found, expected = again.takes[0].to_labels(), take.to_labels()
        assert [x.phoneme for x in found] == [x.phoneme for x in expected]
        assert [x.end for x in found] == pytest.approx([x.end for x in expected])


def test_a_list_of_takes_without_pauses_is_still_read(project):
    take = project.add(SOUND, "Ada", Phoneme.A)
    project.close()
    path = project.folder / "takes.json"
    document = json.loads(path.read_text())
    del document["takes"][0]["pauses"]
    path.write_text(json.dumps(document))
    with TakeProject(project.folder) as again:
        assert again.takes == (take,)
        assert again.notes == ()


@pytest.mark.parametrize(
    ("speaker", "folder"),
    [
        ("Ada", "Ada"),
        ("../x", "___x"),
        ("a/b\\c:d", "a_b_c_d"),
        ("CON", "CON_"),
        ("lpt1", "lpt1_"),
        (" . ", "_"),
        ("Zoë", "Zoë"),
    ],
)
def test_a_speakers_folder_has_a_name_that_every_disk_takes(speaker, folder):
    assert folder_for(speaker) == folder


@pytest.mark.parametrize(("samples", "speaker"), [(SOUND[:0], "Ada"), (SOUND, " ")])
def test_a_take_needs_a_sound_and_a_speaker(project, samples, speaker):
    with pytest.raises(TakeError, match="needs a sound and a speaker's name"):
        project.add(samples, speaker, Phoneme.A)
    assert project.takes == ()


def test_a_take_may_have_two_channels_and_another_rate(project):
    take = project.add(np.stack([SOUND, -SOUND], axis=1), "Ada", Phoneme.A, rate=48_000)
    info = soundfile.info(project.path_of(take))
    assert (info.channels, info.samplerate, info.frames) == (2, 48_000, len(SOUND))
    assert take.duration == pytest.approx(len(SOUND) / 48_000)


def test_a_rate_that_flac_cannot_hold_leaves_nothing(project):
    with pytest.raises(RecordingError, match="cannot be written as FLAC"):
        project.add(SOUND, "Ada", Phoneme.A, rate=10**6)
    assert project.takes == ()
    assert not list(project.folder.glob("takes/*/*"))


def test_two_windows_do_not_have_one_project_open(project):
    with pytest.raises(TakeError, match=r"my takes: this project is open in another window or program; close it"):
        TakeProject(project.folder)
    project.close()
    TakeProject(project.folder).close()


def test_a_foreign_corpus_is_not_made_a_project(tmp_path):
    manifest = tmp_path / "manifest.csv"
    manifest.write_text("corpus,speaker,wav,labels\nmine,ada,a.wav,a.csv\n")
    with pytest.raises(TakeError, match="a corpus that was not made of takes; choose an empty folder"):
        TakeProject(tmp_path)
    assert "mine,ada" in manifest.read_text()


def test_a_file_in_the_place_of_a_folder_is_refused(tmp_path):
    (tmp_path / "x").write_text("")
    with pytest.raises(TakeError, match="x: this folder cannot be made"):
        TakeProject(tmp_path / "x")


def test_a_take_outside_its_project_is_refused():
    for sound in ("/etc/a-1.flac", "takes/../../a-1.flac", "takes/C:a-1.flac", "a-1.flac", "takes/..\\a-1.flac"):
        with pytest.raises(TakeError, match="must lie in takes/"):
            Take(1, sound, "Ada", Phoneme.A, 1, 0, 1, 0, 1)


def test_a_take_that_is_gone_cannot_be_changed(project):
    take = project.add(SOUND, "Ada", Phoneme.A)
    project.delete(take)
    project.empty_deleted()
    with pytest.raises(TakeError, match="a-1: this take is not in the project any more"):
        project.trim(take, 0.1, 0.2)


def test_an_empty_project_is_a_folder_without_a_corpus(project):
    assert (project.takes, project.deleted, project.missing, project.notes) == ((), (), (), ())
    with pytest.raises(CorpusError, match=r"manifest\.csv"):
        read_corpus(project.folder)


def test_the_list_is_plain_json(project):
    take = project.add(SOUND, "Ada", Phoneme.A)
    document = json.loads((project.folder / "takes.json").read_text(encoding="utf-8"))
    assert document["takes"][0]["phoneme"] == "a"
    assert document["takes"][0]["sound"] == take.sound
