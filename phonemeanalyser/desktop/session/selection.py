"""What is done with the selection of a file: it is measured, saved or copied."""

from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.session.time_view import TimeSpan
from phonemeanalyser.desktop.tasks import CLOSE_TIMEOUT, TaskQueue
from phonemeengine.audio.files import SoundReader
from phonemeengine.execution import Progress
from phonemeengine.inspection.measurement import StretchMeasurement, format_frames, measure_stretch, save_stretch

NOTHING_SELECTED = tr_noop(
    "Nothing is selected. Shift+drag over the file, or press [ and ] at the cursor, then try again."
)


class Selection(QObject):
    """Acts on what is selected of the current file, in the background.

    Signals
    -------
    measured : a `StretchMeasurement` is there.
    info, error : a sentence for the user.
    """

    measured = Signal(object)
    info = Signal(str)
    error = Signal(str)

    def __init__(self, session: Session) -> None:
        super().__init__()
        self._session = session
        self._work = TaskQueue(self.error.emit)

    @property
    def span(self) -> TimeSpan | None:
        """What is selected of the current file; None, after saying so, where that is nothing."""
        span = self._session.view.selection
        if span is None or self._session.seen.sound is None:
            self.error.emit(tr(NOTHING_SELECTED))
            return None
        return span

    def play(self, *, loop: bool | None = None) -> None:
        """Play it, once or over and over; None for as the file is played."""
        span = self.span
        if span is not None:
            self._session.play_stretch(span, loop=loop)

    def select_all(self) -> None:
        """Select the whole file."""
        self._session.view.select(TimeSpan(0.0, self._session.view.duration))

    def set_edge(self, *, end: bool) -> None:
        """Have it begin or end at the cursor; its other end stays, or is that of the file where that can't be."""
        view, here = self._session.view, self._session.source.position
        start, stop = view.selection or (0.0, view.duration)
        if end:
            view.select(TimeSpan(start if start < here else 0.0, here))
        else:
            view.select(TimeSpan(here, stop if stop > here else view.duration))

    def show_all(self) -> None:
        """See the whole file."""
        self._session.view.show_all()

    def zoom(self) -> None:
        """See it, and nothing else."""
        span = self.span
        if span is not None:
            self._session.view.show(span)

    def measure(self) -> None:
        """Measure it."""
        span, tracks, seen = self.span, self._session.whole.tracks, self._session.seen.sound
        if span is None or tracks is None or seen is None:
            return
        open_sound, ceiling = partial(SoundReader, *seen), self._session.formants.ceiling

        def act(progress: Progress) -> StretchMeasurement:
            return measure_stretch(open_sound, tracks, *span, ceiling=ceiling, progress=progress)

        self._work.submit(act, self.measured.emit)

    def save(self, target: Path) -> None:
        """Write it as a sound of its own."""
        span, seen = self.span, self._session.seen.sound
        if span is not None and seen is not None:
            path, channel = seen
            self._work.submit(
                lambda _: save_stretch(path, *span, target, channel=channel),
                lambda _: self.info.emit(
                    tr("{seconds:.2f} s of {path} saved as {target}").format(
                        seconds=span.seconds, path=path.name, target=target
                    )
                ),
            )

    def frames_as_text(self) -> str:
        """Return its frames as a table with tabs; empty, after saying why, where there is none."""
        span, tracks = self.span, self._session.whole.tracks
        return "" if span is None or tracks is None else format_frames(tracks, *span)

    def close(self) -> None:
        """End all work."""
        self._work.close(CLOSE_TIMEOUT)
