"""What the check finds of takes that are on the disk."""

from collections.abc import Mapping
from pathlib import Path

from phonemeengine.arrays import Float32Array
from phonemeengine.audio.files import SoundReader, mono_of
from phonemeengine.calibration.takes.project import TakeProject
from phonemeengine.calibration.takes.quality import TakeReport, check_take
from phonemeengine.calibration.takes.take import Take
from phonemeengine.phonemes import Phoneme


def read_mono(path: Path) -> Float32Array:
    """Read a whole sound, of one channel, shape (n,)."""
    with SoundReader(path, as_it_is=True) as reader:
        return mono_of(reader.read(reader.n_samples), reader.channel)


def take_reports(project: TakeProject) -> dict[int, TakeReport]:
    """Check all takes, the silence first: it tells the room's level."""
    reports: dict[int, TakeReport] = {}
    for take in sorted(project.takes, key=lambda take: take.phoneme is not Phoneme.SILENCE):
        reports[take.number] = take_report(project, take, room_level(project.takes, reports))
    return reports


def take_report(project: TakeProject, take: Take, noise: float) -> TakeReport:
    """Check a take in a room with noise of this amplitude."""
    return check_take(read_mono(project.path_of(take)), noise, take.phoneme)


def room_level(takes: tuple[Take, ...], reports: Mapping[int, TakeReport]) -> float:
    """Return the level of the room as the newest silence tells it, as an amplitude; 0 where there is none."""
    silences = [t for t in takes if t.phoneme is Phoneme.SILENCE and not t.excluded and t.number in reports]
    return float(10 ** (reports[silences[-1].number].level / 20)) if silences else 0.0
