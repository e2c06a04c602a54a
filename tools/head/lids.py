"""Keeps the skin around the eyes in front of the eyeballs, however many blend shapes move it at once."""

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float32]

NEAR, CLEARANCE = 1.7, 0.03
"""How far around an eyeball its skin reaches, and how far in front of it skin stays, in radii."""
SOCKET = 0.8
"""How far from the eyeball's centre the back of the lids is at most, in radii: well behind its surface."""
OUTWARD, INWARD = 0.1, -0.3
"""Cosine between a vertex's normal and the way out of the eyeball: of skin in front, and of the back of the lids."""
ALONG_THE_EYE = ("eyeBlink", "eyeLook")
"""Blend shapes whose lids slide over the eyeball, and so neither lead into it nor away from it."""


def kept_off_eye(
    points: Floats, offsets: Floats, normals: Floats, names: list[str], centre: Floats, radius: float
) -> tuple[Floats, Floats]:
    """Return positions and offsets of skin of which no sum of blend shapes goes into an eyeball.

    What leads into the eyeball is made less, for all blend shapes of a vertex by the same share, so that all of them
    together, each at 100 %, still end before it. The back of the lids is laid deeper, so that skin does not go
    through it.

    Parameters
    ----------
    points : of the skin, shape (n, 3).
    offsets : of each blend shape, shape (n_states, n, 3).
    normals : of length 1, shape (n, 3).
    names : of the blend shapes.
    centre, radius : of the eyeball.
    """
    points, offsets = points.copy(), offsets.copy()
    from_centre = points - centre
    apart = np.linalg.norm(from_centre, axis=1)
    out = from_centre / apart[:, np.newaxis]
    faces = (normals * out).sum(axis=1)
    behind = (apart > SOCKET * radius) & (apart < NEAR * radius) & (faces < INWARD)
    points[behind] = centre + SOCKET * radius * out[behind]
    front = np.flatnonzero((apart < NEAR * radius) & (from_centre[:, 2] > 0) & (faces > OUTWARD))
    out = out[front]
    least = radius * (1 + CLEARANCE)
    points[front] += np.maximum(least - apart[front], 0)[:, np.newaxis] * out
    room = np.maximum(apart[front], least) - least
    leading = [k for k, name in enumerate(names) if not name.startswith(ALONG_THE_EYE)]
    inward = np.maximum(-np.einsum("snk,nk->sn", offsets[np.ix_(leading, front)], out), 0)
    share = np.minimum(room / np.maximum(inward.sum(axis=0), 1e-9), 1)
    offsets[np.ix_(leading, front)] += ((1 - share) * inward)[..., np.newaxis] * out
    return points.astype(np.float32), offsets.astype(np.float32)
