"""What can move a face where the words are known."""

from enum import StrEnum


class FaceDriver(StrEnum):
    """What moves a face by what is said; `AUTO` is whatever `usual_driver` chooses."""

    AUTO = "auto"
    PINYIN = "pinyin"
    TABLE = "table"
    RULES = "rules"

    @property
    def caption(self) -> str:
        """What it is called below a face."""
        return _CAPTIONS[self]


_CAPTIONS = {
    FaceDriver.AUTO: "Automatic",
    FaceDriver.PINYIN: "Pinyin letters",
    FaceDriver.TABLE: "Recorded faces",
    FaceDriver.RULES: "Phonemes (rules)",
}


def usual_driver(*, has_table: bool, has_letters: bool) -> FaceDriver:
    """Return what moves a face unless another is chosen: recorded faces, letters of pinyin for Chinese, else rules.

    Parameters
    ----------
    has_table : whether there is a table of recorded faces.
    has_letters : whether Chinese is said, and letters can move the face.
    """
    if has_table:
        return FaceDriver.TABLE
    return FaceDriver.PINYIN if has_letters else FaceDriver.RULES
