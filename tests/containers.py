"""Sounds in containers, written by FFmpeg; what is in them is known."""

import io

import av
import numpy as np

from tests.sounds import Sound

RATE = 44_100


def contained(
    samples: Sound,
    form: str,
    codec: str,
    *,
    rate: int = RATE,
    pictures: bool = False,
    n_tracks: int = 1,
    options: dict[str, str] | None = None,
) -> bytes:
    """A sound, shape (n,) or (n, 2), in a container; FFmpeg's names of format and codec."""
    file = io.BytesIO()
    planes = np.atleast_2d(samples.T).astype(np.float32)
    layout = "mono" if len(planes) == 1 else "stereo"
    with av.open(file, "w", format=form, options=options or {}) as container:
        film = container.add_stream("mpeg4", rate=10, width=32, height=32, pix_fmt="yuv420p") if pictures else None
        tracks = [container.add_stream(codec, rate=rate, layout=layout) for _ in range(n_tracks)]
        for track in tracks:
            track.bit_rate = 96_000
            frame = av.AudioFrame.from_ndarray(np.ascontiguousarray(planes), "fltp", layout)
            frame.sample_rate, frame.pts = RATE, 0
            container.mux(track.encode(frame))
            container.mux(track.encode())
        if film is not None:
            for _ in range(10 * planes.shape[1] // RATE + 1):
                container.mux(film.encode(av.VideoFrame(32, 32, "yuv420p")))
            container.mux(film.encode())
    return file.getvalue()
