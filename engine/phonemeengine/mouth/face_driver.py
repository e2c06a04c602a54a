"""What can move a face by what is said."""

from enum import StrEnum


class FaceDriver(StrEnum):
    """What moves a face by what is said; `AUTO` is whatever `usual_driver` chooses."""

    AUTO = "auto"
    PINYIN = "pinyin"
    TABLE = "table"
    NETWORK = "network"
    RULES = "rules"

    @property
    def caption(self) -> str:
        """What it is called below a face."""
        return _CAPTIONS[self]


_CAPTIONS = {
    FaceDriver.AUTO: "Automatic",
    FaceDriver.PINYIN: "Pinyin letters",
    FaceDriver.TABLE: "Recorded faces",
    FaceDriver.NETWORK: "Sound alone (network)",
    FaceDriver.RULES: "Phonemes (rules)",
}


NEEDS_FILE = (FaceDriver.TABLE, FaceDriver.NETWORK)
"""What moves a face by a file that is learned from recorded faces."""


def usual_driver(*, has_table: bool, has_letters: bool, has_network: bool = False) -> FaceDriver:
    """Return what moves a face unless another is chosen: what recorded faces taught, letters of pinyin, else rules.

    Parameters
    ----------
    has_table : whether there is a table of recorded faces, and it is known what is said.
    has_network : whether there is a network that learned from recorded faces.
    has_letters : whether Chinese is said, and letters can move the face.
    """
    if has_table:
        return FaceDriver.TABLE
    if has_network:
        return FaceDriver.NETWORK
    return FaceDriver.PINYIN if has_letters else FaceDriver.RULES
