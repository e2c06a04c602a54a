"""A mouth on springs: each movestate is a mass that a spring draws to its target.

``m a = k (target - x) - damping v``, Hooke's law with friction, by the semi-implicit Euler method (symplectic Euler):
first the new velocity, then the new position from the new velocity.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.errors import MouthError

STEP = 1 / 240
"""Seconds of one step; steps lie on a grid, so that it does not matter how often anybody looks."""
LONGEST_JUMP = 1.0
"""Seconds without a look after which it is a seek: the slowest film has a frame each second."""
LARGEST = 1e6


@dataclass(frozen=True)
class Spring:
    """What the masses and springs of a mouth are like.

    Parameters
    ----------
    mass : of each movestate; only its ratio to the others counts.
    stiffness : of the spring, per s².
    damping : of the velocity, per s. With 2 √(mass · stiffness) the mouth does not overshoot; with less it swings.

    Raises
    ------
    MouthError : a number is not above 0, or the mouth would swing ever farther in steps of 1/240 s.
    """

    mass: float = 1.0
    stiffness: float = 900.0
    damping: float = 60.0

    def __post_init__(self) -> None:
        for name in ("mass", "stiffness", "damping"):
            if not 0 < getattr(self, name) <= LARGEST:
                raise MouthError(
                    f"the {name} of a spring must be a number above 0, at most {LARGEST:g}, got "
                    f"{getattr(self, name):g}; correct it"
                )
        # The eigenvalues of a step lie within the unit circle as long as this is below 4.
        swing, friction = self.stiffness / self.mass * STEP**2, self.damping / self.mass * STEP
        if not swing + 2 * friction < 4:
            raise MouthError(
                f"a spring with mass {self.mass:g}, stiffness {self.stiffness:g} and damping {self.damping:g} swings "
                "ever farther; choose a larger mass, or less of the others"
            )

    @classmethod
    def of(cls, text: str) -> "Spring":
        """Read ``MASS,STIFFNESS,DAMPING``, such as ``1,900,60``.

        Raises
        ------
        MouthError : it is none.
        """
        try:
            mass, stiffness, damping = map(float, text.split(","))
        except ValueError as error:
            words = f"a spring is MASS,STIFFNESS,DAMPING, such as 1,900,60, found {text[:60]!r}; correct it"
            raise MouthError(words) from error
        return cls(mass, stiffness, damping)


class SpringMass:
    """Follows a target that moves; a seek puts it at rest on its target.

    Parameters
    ----------
    target : gives the target at a time, seconds, shape (n_movestates,); it begins at rest before time 0.
    spring : what draws it there.
    """

    def __init__(self, target: Callable[[float], Float32Array], spring: Spring) -> None:
        self._target, self._spring = target, spring
        self._step = -1  # what begins at 0 begins to draw it there
        self._place: Float64Array = target(-STEP).astype(float)
        self._velocity = np.zeros_like(self._place)

    def at(self, time: float) -> Float32Array:
        """Return where it is at a time, seconds, shape (n_movestates,)."""
        step = math.floor(time / STEP)
        if not 0 <= step - self._step <= LONGEST_JUMP / STEP + 1:
            self._rest(step)
        while self._step < step:
            self._place, self._velocity = self._moved(STEP)
            self._step += 1
        return self._moved(time - step * STEP)[0].astype(np.float32)

    def _rest(self, step: int) -> None:
        self._step = step
        self._place = self._target(step * STEP).astype(float)
        self._velocity = np.zeros_like(self._place)

    def _moved(self, seconds: float) -> tuple[Float64Array, Float64Array]:
        """Return place and velocity a moment later, a step at most."""
        spring = self._spring
        force = spring.stiffness * (self._target(self._step * STEP) - self._place) - spring.damping * self._velocity
        velocity = self._velocity + seconds / spring.mass * force
        return self._place + seconds * velocity, velocity
