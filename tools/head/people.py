"""Who the two heads are: what makes them differ from the source's mesh, and their colours."""

from dataclasses import dataclass, field

Colour = tuple[int, int, int]


@dataclass(frozen=True)
class Person:
    """The looks of a person.

    Attributes
    ----------
    targets : how much of each of the source's targets; * stands for l and r.
    skin, lips, blush, lid, hair, strand, iris, shirt : colours, 0..255.
    stubble : how much a beard shows, 0..1.
    hair_style : a name in `tools.head.hair.STYLES`.
    brow : how wide the brows are, decimetres, and how much their middle is raised.
    lashes : how long they are, as a share of the source's.
    shoulders : half their width and depth, decimetres.
    """

    targets: dict[str, float]
    skin: Colour
    lips: Colour
    blush: Colour
    lid: Colour
    hair: Colour
    strand: Colour
    iris: Colour
    limbus: Colour
    shirt: Colour
    stubble: float
    hair_style: str
    brow: tuple[float, float]
    lashes: float
    shoulders: tuple[float, float]
    rest: dict[str, float] = field(default_factory=dict)


WOMAN = Person(
    targets={
        "macrodetails/caucasian-female-young": 0.7,
        "macrodetails/asian-female-young": 0.15,
        "macrodetails/african-female-young": 0.15,
        "macrodetails/universal-female-young-averagemuscle-averageweight": 1.0,
        "macrodetails/proportions/female-young-averagemuscle-averageweight-idealproportions": 1.0,
        "eyes/*-eye-scale-incr": 0.35,
        "eyes/*-eye-height2-incr": 0.3,
        "head/head-oval": 0.3,
        "head/head-scale-vert-decr": 0.25,
        "ears/*-ear-scale-decr": 0.4,
        "ears/*-ear-wing-decr": 0.8,
        "mouth/mouth-angles-up": 0.35,
        "nose/nose-width2-decr": 0.2,
        "nose/nose-point-up": 0.15,
    },
    skin=(226, 180, 156),
    lips=(190, 98, 96),
    blush=(222, 146, 126),
    lid=(196, 140, 122),
    hair=(74, 46, 32),
    strand=(128, 84, 56),
    iris=(112, 92, 62),
    limbus=(52, 40, 30),
    shirt=(58, 92, 108),
    stubble=0.0,
    hair_style="bob",
    brow=(0.021, 0.028),
    lashes=0.5,
    shoulders=(1.72, 0.85),
)
MAN = Person(
    targets={
        "macrodetails/caucasian-male-young": 0.7,
        "macrodetails/asian-male-young": 0.15,
        "macrodetails/african-male-young": 0.15,
        "macrodetails/universal-male-young-averagemuscle-averageweight": 1.0,
        "macrodetails/proportions/male-young-averagemuscle-averageweight-idealproportions": 1.0,
        "eyes/*-eye-scale-incr": 0.35,
        "eyes/*-eye-height2-incr": 0.25,
        "head/head-scale-vert-decr": 0.3,
        "ears/*-ear-scale-decr": 0.25,
        "ears/*-ear-wing-decr": 0.6,
        "mouth/mouth-angles-up": 0.35,
        "nose/nose-width2-decr": 0.3,
        "nose/nose-scale-horiz-decr": 0.3,
    },
    skin=(214, 168, 144),
    lips=(184, 112, 102),
    blush=(206, 136, 116),
    lid=(192, 138, 120),
    hair=(58, 42, 34),
    strand=(102, 76, 58),
    iris=(96, 128, 142),
    limbus=(40, 56, 68),
    shirt=(70, 76, 84),
    stubble=0.6,
    hair_style="short",
    brow=(0.030, 0.016),
    lashes=0.2,
    shoulders=(2.1, 1.0),
)
PEOPLE = {"woman": WOMAN, "man": MAN}
