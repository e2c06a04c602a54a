"""A mouth table as a section of an ``.ear`` file."""

from phonemeengine.mouth.table import MouthTable
from phonemeengine.phonemes import Phoneme
from phonemeengine.shipping.binary import SectionWriter
from phonemeengine.visemes import VISEME_PHONES, Viseme

SIDES = ("Right", "Left")


def mouth_section(name: str, table: MouthTable) -> tuple[str, SectionWriter]:
    """Return the section of a table that an ear knows by a name."""
    section = SectionWriter()
    shapes = list(table.shapes)
    section.text(name)
    section.doubles(table.motion.loudness, table.motion.minimum_opening, table.motion.randomness)
    section.whole(len(table.movestates))
    for movestate in table.movestates:
        section.text(movestate)
    section.whole(*_left_sides(table.movestates), len(shapes))
    for shape in shapes:
        section.text(shape)
    section.floats(table.weights())
    section.floats(table.shape_weights())
    section.whole(*_looseness(table))
    for phoneme in Phoneme:
        for look in (*Viseme, None):
            _entry(section, table, shapes, phoneme, VISEME_PHONES.get(look, "") if look is not None else "")
    return "MOUT", section


def _entry(section: SectionWriter, table: MouthTable, shapes: list[str], phoneme: Phoneme, phone: str) -> None:
    """Write which shape a sound has, where its weights stand, and how fast the mouth is."""
    shape, silent = table.shape_of(phoneme, phone), phoneme is Phoneme.SILENCE
    row = int(phoneme) if shape == table.phonemes[phoneme] else len(Phoneme) + shapes.index(shape)
    section.whole(shapes.index(shape), row)
    times = None if silent else table.times_of(phoneme, phone)
    section.doubles(times.to_shape if times else 0.0, times.to_rest if times else 0.0)
    section.whole(silent or table.closes(phoneme, phone))


def _left_sides(movestates: tuple[str, ...]) -> list[int]:
    """Return for each movestate of the right side that of the left, and itself for all others."""
    columns = {name: k for k, name in enumerate(movestates)}
    right, left = SIDES
    lefts = (f"{name.removesuffix(right)}{left}" if name.endswith(right) else name for name in movestates)
    return [columns.get(name, k) for k, name in enumerate(lefts)]


def _looseness(table: MouthTable) -> list[bool]:
    """Return of which rows of weights the habits of a mouth may change something: not those at which lips meet."""
    firm = {table.phones[name] for name in table.closed_phones}
    phonemes = [phoneme not in {*table.closed_phonemes, Phoneme.SILENCE} for phoneme in Phoneme]
    return [*phonemes, *(shape not in firm for shape in table.shapes)]
