"""The formants of what is seen of a file, measured in the background."""

from typing import NamedTuple

import numpy as np
from typing_extensions import override

from phonemeanalyser.desktop.session.seen_track import SeenTrack
from phonemeanalyser.desktop.session.time_view import TimeSpan
from phonemeengine.arrays import Float32Array
from phonemeengine.dsp.formants import CEILING, WINDOW_SECONDS, formants_of
from phonemeengine.execution import Progress
from phonemeengine.settings import FRAME_PERIOD, HOP

MOST_SECONDS = 60.0
"""Of formants that are measured at once; in more they could not be told apart."""
AROUND = 0.5
"""Share of what is seen that is measured on either side of it, so that little is missing in scrolling."""


class KnownFormants(NamedTuple):
    """Formants from a frame on: frequencies, float32, shape (n_frames, 5), Hz; NaN where there are none."""

    first: int
    frequencies: Float32Array


class FormantTrack(SeenTrack):
    """Measures the formants that are in view, once they are wanted.

    Attributes
    ----------
    ceiling : Hz below which they are looked for.
    """

    def __init__(self) -> None:
        super().__init__()
        self.ceiling = CEILING
        self._known: KnownFormants | None = None
        self._wanted: tuple[int, int] = (0, 0)

    def formants_in(self, seen: TimeSpan) -> KnownFormants | None:
        """Return what is known, which may be less than is seen; what is missing is measured in the background."""
        if not 0 < seen.seconds <= MOST_SECONDS or self._open is None:
            return None
        first = max(0, int(seen.start / FRAME_PERIOD))
        n_frames = int(np.ceil(self._duration / FRAME_PERIOD))
        last = min(n_frames, int(np.ceil(seen.end / FRAME_PERIOD)))
        begin, end = self._wanted
        if first < begin or last > end:
            around = int(AROUND * (last - first))
            self._measure(max(0, first - around), min(n_frames, last + around))
        return self._known

    def _measure(self, first: int, last: int) -> None:
        open_sound, ceiling, self._wanted = self._open, self.ceiling, (first, last)
        assert open_sound is not None
        margin = int(WINDOW_SECONDS / FRAME_PERIOD)

        def measure(_progress: Progress) -> KnownFormants:
            begin = max(0, first - margin)
            with open_sound() as reader:
                reader.seek(begin * HOP)
                samples = reader.read_mono((last + margin - begin) * HOP)
            found = formants_of(samples, first_frame=first - begin, n_frames=last - first, ceiling=ceiling)
            return KnownFormants(first, found.frequencies)

        self._work.replace(measure, self._take)

    def _take(self, known: KnownFormants) -> None:
        self._known = known
        self.changed.emit()

    @override
    def _forget(self) -> None:
        self._known, self._wanted = None, (0, 0)
        super()._forget()
