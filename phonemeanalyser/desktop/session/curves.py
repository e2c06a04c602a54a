"""Averaged spectra of speakers, phonemes, files and selections, side by side: kept, compared, drawn."""

import math
from collections.abc import Iterable, Sequence
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QUndoCommand
from typing_extensions import override

from phonemeanalyser.colours import free_curve_colour
from phonemeanalyser.desktop.engine_words import tr_engine
from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeanalyser.desktop.tasks import CLOSE_TIMEOUT, TaskQueue
from phonemeengine.analyser import Analysis
from phonemeengine.errors import CurveError, EngineError
from phonemeengine.execution import Progress
from phonemeengine.inspection import averaged_spectrum
from phonemeengine.inspection.speaker_spectra import Groups, average_parts, measured_again
from phonemeengine.settings import FRAME_PERIOD, AnalysisSettings
from phonemeengine.storage.files import free_path, portable_name

SUFFIX = ".csv"
Parts = tuple[averaged_spectrum.SoundPart, ...]


class CurveDifference(NamedTuple):
    """How two curves differ.

    Attributes
    ----------
    decibels : NaN where they cannot be compared.
    words : what it is, or why there is none.
    """

    decibels: float
    words: str


class CurveTable(QObject):
    """The curves that are compared; what is removed comes back by undo.

    Signals
    -------
    changed : a curve was added, removed, or is another.
    added : places of curves that were added, or were to be and are there already.
    compared : more differences are known.
    info, error : a sentence for the user.

    Attributes
    ----------
    curves : in the order in which they were added.
    chosen : places of those that the user chose.
    work : averages what is to be added.
    """

    changed = Signal()
    added = Signal(list)
    compared = Signal()
    info = Signal(str)
    error = Signal(str)

    def __init__(self, preset: PresetModel) -> None:
        super().__init__()
        self.curves: tuple[averaged_spectrum.AveragedSpectrum, ...] = ()
        self.chosen: tuple[int, ...] = ()
        self.work, self._comparing = TaskQueue(self.error.emit), TaskQueue(self.error.emit)
        self._preset = preset
        preset.changed.connect(self._follow_filters)
        self._folder: Path | None = None
        self._files: tuple[Path | None, ...] = ()
        self._again: dict[Parts, averaged_spectrum.AveragedSpectrum | str] = {}
        self._again_through = ""

    @property
    def settings(self) -> AnalysisSettings:
        """The filters through which sounds are averaged now."""
        return self._preset.in_force.settings

    @property
    def shown(self) -> tuple[averaged_spectrum.AveragedSpectrum, ...]:
        """The curves that are drawn and compared."""
        return tuple(curve for curve in self.curves if not curve.hidden)

    # -- what there is ------------------------------------------------------------------------------------

    def keep_in(self, folder: Path) -> None:
        """Store all curves in this folder from now on, and load those that the last run left there."""
        with suppress(OSError):  # what can't be stored there says so
            folder.mkdir(parents=True, exist_ok=True)
        self._folder = folder
        for path in sorted(folder.glob(f"*{SUFFIX}")):
            try:
                curve = averaged_spectrum.load_averaged_spectrum(path)
            except EngineError as error:
                self.error.emit(str(error))
            else:
                self.curves, self._files = (*self.curves, curve), (*self._files, path)
        self.changed.emit()

    def add(self, curves: Iterable[averaged_spectrum.AveragedSpectrum]) -> list[int]:
        """Add curves, and return their places; one that is there already is pointed at."""
        places, known = [], []
        for curve in curves:
            place = next((k for k, other in enumerate(self.curves) if other.is_same(curve)), None)
            if place is None:
                place = len(self.curves)
                taken = [other.colour for other in self.curves]
                colour = free_curve_colour(taken) if curve.colour in (*taken, "") else curve.colour
                self._put(place, replace(curve, colour=colour), None)
            else:
                known.append(self.curves[place].name)
            places.append(place)
        self.changed.emit()
        self.added.emit(places)
        if known:
            self.info.emit(tr("This average is in the table already, as {name}").format(name=", ".join(known)))
        return places

    def add_groups(self, groups: Groups) -> None:
        """Average parts of sounds in the background, through the filters that are on now, and add the curves."""
        together: list[int] = []
        for name, parts in groups.items():
            self.average(name, parts, together)

    def average(
        self, name: str, parts: Sequence[averaged_spectrum.SoundPart], together: list[int] | None = None
    ) -> None:
        """Average parts of sounds in the background, and add the curve.

        Parameters
        ----------
        together : places of those that were added with it so far, to be pointed at with it.
        """
        settings = self.settings
        places = [] if together is None else together

        def act(progress: Progress) -> averaged_spectrum.AveragedSpectrum:
            return average_parts(parts, settings, name, progress=progress)

        def take(curve: averaged_spectrum.AveragedSpectrum) -> None:
            places.extend(self.add([curve]))
            self.added.emit(places)

        self.work.submit(act, take)

    def load(self, path: Path) -> None:
        """Load a curve; EngineError leaves all as it is."""
        self.add([averaged_spectrum.load_averaged_spectrum(path)])

    def remove(self, places: Iterable[int]) -> None:
        """Take curves away."""
        if removed := sorted(set(places)):
            self._preset.undo_stack.push(_Removal(self, [(k, self.curves[k]) for k in removed]))

    def take_away(self, curves: Iterable[averaged_spectrum.AveragedSpectrum]) -> None:
        """Take curves away for good, with their files in the folder."""
        for gone in curves:
            place = next((k for k, curve in enumerate(self.curves) if curve.is_same(gone)), None)
            if place is not None:
                file = self._files[place]
                if file is not None:
                    with suppress(OSError):  # it is there again at the next start
                        file.unlink(missing_ok=True)
                self.curves = self.curves[:place] + self.curves[place + 1 :]
                self._files = self._files[:place] + self._files[place + 1 :]
        self.chosen = ()
        self.changed.emit()

    def put_back(self, removed: Iterable[tuple[int, averaged_spectrum.AveragedSpectrum]]) -> None:
        """Put curves where they were."""
        for place, curve in removed:
            self._put(min(place, len(self.curves)), curve, None)
        self.changed.emit()

    def rename(self, place: int, name: str) -> None:
        """Give a curve another name; an empty one leaves the old one."""
        if name.strip():
            self._change(place, replace(self.curves[place], name=" ".join(name.split())))

    def recolour(self, places: Iterable[int], colour: str) -> None:
        """Draw curves in a colour, as #rrggbb."""
        for place in places:
            self._change(place, replace(self.curves[place], colour=colour))

    def show(self, places: Iterable[int], *, on: bool) -> None:
        """Draw and compare curves, or leave them out."""
        for place in places:
            if self.curves[place].hidden == on:
                self._change(place, replace(self.curves[place], hidden=not on))

    def measure_again(self, places: Iterable[int]) -> None:
        """Have curves be of the same sounds through the filters that are on now."""
        for place in places:
            self._measure_again(self.curves[place])

    def _measure_again(self, curve: averaged_spectrum.AveragedSpectrum) -> None:
        settings = self.settings

        def take(again: averaged_spectrum.AveragedSpectrum) -> None:
            place = next((k for k, other in enumerate(self.curves) if other.is_same(curve)), None)
            if place is not None:
                now = self.curves[place]
                self._change(place, replace(again, name=now.name, colour=now.colour, hidden=now.hidden))

        self.work.submit(lambda progress: measured_again(curve, settings, progress), take)

    def save(self, places: Sequence[int], target: Path) -> None:
        """Save a curve as a file, or several in a folder under their names; EngineError says why not."""
        for place in places:
            curve = self.curves[place]
            path = target if len(places) == 1 else free_path(target / f"{portable_name(curve.name)}{SUFFIX}")
            averaged_spectrum.save_averaged_spectrum(curve, path)
        words = tr("1 curve saved as {target}" if len(places) == 1 else "{n} curves saved in {target}")
        self.info.emit(words.format(n=len(places), target=target))

    def close(self) -> None:
        """End all work."""
        for queue in (self.work, self._comparing):
            queue.close(CLOSE_TIMEOUT)

    # -- how they differ ----------------------------------------------------------------------------------

    def differences(self, curves: Sequence[averaged_spectrum.AveragedSpectrum]) -> list[list[CurveDifference]]:
        """Return how each of some curves differs from each.

        Those that went through different filters are compared as they are through the present ones, for which their
        sounds are measured again in the background; `compared` tells when that is done.
        """
        self._forget_old()
        through = {curve.front_end for curve in curves}
        if len(through) > 1:
            for curve in curves:
                self._compare_again(curve)
        found = [[CurveDifference(0.0, "")] * len(curves) for _ in curves]
        for k, one in enumerate(curves):
            for n in range(k):
                found[k][n] = found[n][k] = self._difference(curves[n], one)
        return found

    def _difference(
        self, one: averaged_spectrum.AveragedSpectrum, other: averaged_spectrum.AveragedSpectrum
    ) -> CurveDifference:
        try:
            averaged_spectrum.check_comparable(one, other)
        except CurveError as error:
            again = self._through_now(one), self._through_now(other)
            if isinstance(again[0], averaged_spectrum.AveragedSpectrum) and isinstance(
                again[1], averaged_spectrum.AveragedSpectrum
            ):
                return _told(again[0], again[1], again=True)
            why = [tr_engine(words) for words in again if isinstance(words, str)]
            return CurveDifference(math.nan, "; ".join([tr_engine(str(error)), *why]))
        return _told(one, other, again=False)

    def _through_now(self, curve: averaged_spectrum.AveragedSpectrum) -> averaged_spectrum.AveragedSpectrum | str:
        """Return a curve through the present filters; a sentence where that cannot be, an empty one meanwhile."""
        if curve.front_end == self._again_through:
            return curve
        if curve.parts:
            return self._again.get(curve.parts, "")
        try:
            return measured_again(curve, self.settings)  # which it refuses
        except CurveError as error:
            return str(error)

    def _follow_filters(self) -> None:
        if self.settings.front_end() != self._again_through:
            self.compared.emit()

    def _forget_old(self) -> None:
        now = self.settings.front_end()
        if now != self._again_through:
            self._comparing.cancel()
            self._again.clear()
            self._again_through = now

    def _compare_again(self, curve: averaged_spectrum.AveragedSpectrum) -> None:
        if not curve.parts or curve.front_end == self._again_through or curve.parts in self._again:
            return
        settings, self._again[curve.parts] = self.settings, tr("Measuring through the current filters…")

        def act(progress: Progress) -> averaged_spectrum.AveragedSpectrum | str:
            try:
                return measured_again(curve, settings, progress)
            except EngineError as error:
                return str(error)

        def take(found: averaged_spectrum.AveragedSpectrum | str) -> None:
            self._again[curve.parts] = found
            self.compared.emit()

        self._comparing.submit(act, take)

    # -- files --------------------------------------------------------------------------------------------

    def _change(self, place: int, curve: averaged_spectrum.AveragedSpectrum) -> None:
        self.curves = (*self.curves[:place], curve, *self.curves[place + 1 :])
        self._keep(place)
        self.changed.emit()

    def _put(self, place: int, curve: averaged_spectrum.AveragedSpectrum, file: Path | None) -> None:
        self.curves = (*self.curves[:place], curve, *self.curves[place:])
        self._files = (*self._files[:place], file, *self._files[place:])
        self._keep(place)

    def _keep(self, place: int) -> None:
        """Write a curve into the folder in which all are kept."""
        if self._folder is None:
            return
        file = self._files[place] or self._new_file()
        try:
            averaged_spectrum.save_averaged_spectrum(self.curves[place], file)
        except EngineError as error:
            self.error.emit(
                tr("The averaged spectra can't be kept for the next start: {error}").format(
                    error=tr_engine(str(error))
                )
            )
        else:
            self._files = (*self._files[:place], file, *self._files[place + 1 :])

    def _new_file(self) -> Path:
        assert self._folder is not None
        names = [file.stem for file in self._files if file is not None]
        last = max((int(name[:5]) for name in names if name[:5].isdecimal()), default=0)
        return free_path(self._folder / f"{last + 1:05d}{SUFFIX}")  # another program may keep its own there


class _Removal(QUndoCommand):
    """Takes curves away from a table."""

    def __init__(self, table: CurveTable, removed: list[tuple[int, averaged_spectrum.AveragedSpectrum]]) -> None:
        super().__init__(tr("remove averaged spectra"))
        self._table, self._removed = table, removed

    @override
    def redo(self) -> None:
        self._table.take_away(curve for _, curve in self._removed)

    @override
    def undo(self) -> None:
        self._table.put_back(self._removed)


def _told(
    one: averaged_spectrum.AveragedSpectrum, other: averaged_spectrum.AveragedSpectrum, *, again: bool
) -> CurveDifference:
    decibels, highest = averaged_spectrum.distance_of(one, other), min(one.frequencies[-1], other.frequencies[-1])
    words = tr(
        "{one} and {other}: {decibels:.1f} dB, up to {highest:.0f} Hz, both measured again with the current filters"
        if again
        else "{one} and {other}: {decibels:.1f} dB, up to {highest:.0f} Hz"
    ).format(one=one.name, other=other.name, decibels=decibels, highest=highest)
    return CurveDifference(decibels, words)


class RunningAverage:
    """The mean spectrum since Play, Record or Clear, through one front end.

    Attributes
    ----------
    settings : of all that is in the running mean; None while that is empty.
    """

    def __init__(self) -> None:
        self.settings: AnalysisSettings | None = None
        self._average = averaged_spectrum.SpectrumAverage()
        self._cause = self._sound = ""
        self._from = 0.0

    @property
    def n_frames(self) -> int:
        """Frames in the running mean."""
        return self._average.n_frames

    @property
    def since(self) -> str:
        """What the running mean begins with, and where in which sound; empty while it is empty."""
        return f"{self._cause} at {self._from:.2f} s of {self._sound}" if self.n_frames else ""

    def begin(self, cause: str, sound: str) -> None:
        """Begin the running mean anew, of a sound of that name, and remember why, in English."""
        self._cause, self._sound = cause, sound
        self.settings = None
        self._average.clear()

    def add(self, analysis: Analysis) -> None:
        """Take in a block of frames; those that other filters shaped begin a new mean."""
        known, given = self.settings, analysis.settings
        if known is not None and given is not known and given.front_end() != known.front_end():
            self.begin(tr_noop("change of the filters"), self._sound)
        if self.settings is None:
            self._from = analysis.start * FRAME_PERIOD
        self.settings = given
        self._average.add(analysis.linear_spectra, analysis.frames.windows)

    def current(self, name: str = "now") -> averaged_spectrum.AveragedSpectrum:
        """Return the running mean."""
        front_end = self.settings.front_end() if self.settings is not None else ""
        return self._average.curve(name, front_end, self.since)

    def save(self, path: Path) -> averaged_spectrum.AveragedSpectrum:
        """Save the running mean under the file's name, and return it; EngineError says why not."""
        curve = self.current(path.stem)
        averaged_spectrum.save_averaged_spectrum(curve, path)
        return curve
