"""A mesh that plays an animation, frame by frame."""

from collections.abc import Iterator

from phonemeanalyser.rendering.errors import RenderingError
from phonemeengine.arrays import Float32Array
from phonemeengine.mouth.animation import Animation
from phonemeengine.mouth.head_motion import HeadPose
from phonemeengine.mouth.morph_mesh import MorphMesh
from phonemeengine.mouth.movestate_set import MovestateSet


class AnimationPlayer:
    """Moves a mesh as an animation says; movestates that the mesh lacks are left out.

    Raises
    ------
    RenderingError : the mesh has none of the animation's movestates.
    """

    def __init__(self, morph_mesh: MorphMesh, animation: Animation) -> None:
        self._animation = animation
        self._states = MovestateSet(morph_mesh.mesh, morph_mesh.states)
        self._columns = [k for k, name in enumerate(animation.movestates) if name in self._states]
        if not self._columns:
            raise RenderingError(
                f"the mesh has none of the table's movestates {', '.join(animation.movestates[:5])}, ...: it has "
                f"{', '.join(self._states.names[:5]) or 'none at all'}; choose another table, or other movestates"
            )

    def __len__(self) -> int:
        return len(self._animation.weights)

    def scenes(self) -> Iterator[tuple[Float32Array, HeadPose]]:
        """Return the vertices and the pose of each frame; the vertices hold until the next one."""
        names = [self._animation.movestates[k] for k in self._columns]
        percentages = self._animation.weights[:, self._columns] * 100.0
        for row, turn in zip(percentages, self._animation.head.tolist(), strict=True):
            self._states.set_percentages(dict(zip(names, row.tolist(), strict=True)))
            yield self._states.morphed(), HeadPose(*turn)
