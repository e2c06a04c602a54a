"""What is done with the words of the current sound: they are played, looked through, and changed by hand."""

from pathlib import Path

from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.session.sources import SourceKind
from phonemeanalyser.desktop.session.time_view import TimeSpan
from phonemeanalyser.desktop.talk.words.sound_words import SoundWords, fits_badly
from phonemeengine.errors import CorpusError
from phonemeengine.labels.table import write_text
from phonemeengine.labels.utterance import LabelUnit, Word, with_boundary
from phonemeengine.labels.utterance_files import format_utterance
from phonemeengine.settings import FRAME_PERIOD


class WordEdits(QObject):
    """Acts on the words of the current sound file; each change can be undone.

    Signals
    -------
    error, info : a sentence for the user.
    """

    error = Signal(str)
    info = Signal(str)

    def __init__(self, session: Session, words: SoundWords) -> None:
        super().__init__()
        self._session, self._words = session, words

    @property
    def possible(self) -> bool:
        """Whether words can be changed: there are some, and no voice has set their times."""
        return self._session.source.kind is SourceKind.FILE and self._words.utterance is not None

    @property
    def poor(self) -> list[Word]:
        """The words that should be looked at, in order of time."""
        utterance = self._words.utterance if self.possible else None
        return [] if utterance is None else [word for word in utterance.words if fits_badly(word)]

    def play(self, start: float, end: float) -> None:
        """Play a segment of the current sound, in seconds; it stands at the segment's beginning afterwards."""
        self._session.play_stretch(TimeSpan(start, end))

    def show(self, word: Word) -> None:
        """Play a word, and have it seen."""
        self._session.view.reveal(TimeSpan(word.start, word.end))
        self.play(word.start, word.end)

    def show_poor(self, step: int) -> None:
        """Play the next word that fits badly (`step` 1), or the one before (-1); after the last comes the first."""
        poor, here = self.poor, self._session.source.position
        later = [word for word in poor if word.start > here + FRAME_PERIOD]
        earlier = [word for word in poor if word.end < here + FRAME_PERIOD]
        if poor:
            self.show((later or poor)[0] if step > 0 else (earlier or poor)[-1])

    def move_boundary(self, unit: LabelUnit, boundary: int, seconds: float) -> None:
        """Move a boundary; see `with_boundary`."""
        utterance = self._words.utterance
        if not self.possible or utterance is None:
            return
        try:
            moved = with_boundary(utterance, unit, boundary, seconds)
        except CorpusError as error:
            self.error.emit(str(error))
            self._words.changed.emit()  # whoever shows the boundary elsewhere shows it where it is
        else:
            self._words.edit(moved, tr("move of a boundary ({unit})").format(unit=tr(unit.value)), by_hand=True)

    def save(self, path: Path) -> bool:
        """Write the words as a TextGrid; says whether that went well."""
        if self._words.utterance is None:
            self.error.emit(tr("There are no words to save; open an audio file and align its text first."))
            return False
        try:
            write_text(format_utterance(self._words.utterance), path)
        except CorpusError as error:
            self.error.emit(str(error))
            return False
        self._words.note_saved()
        self.info.emit(tr("Saved words and phones as {path}.").format(path=path))
        return True
