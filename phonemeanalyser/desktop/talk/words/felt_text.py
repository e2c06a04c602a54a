"""What the text of the current sound says of feeling, over time; an edit writes a direction into the text."""

import re
from dataclasses import dataclass, replace

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QUndoStack

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.session.undo import UndoableEdit
from phonemeanalyser.desktop.talk.expression.expression_model import ExpressionModel
from phonemeanalyser.desktop.talk.words.text_model import TextModel
from phonemeanalyser.desktop.talk.words.written_text import places_of
from phonemeengine.errors import TextError
from phonemeengine.labels.utterance import Utterance
from phonemeengine.mouth.expression.felt import TimedFeeling, timed_feelings
from phonemeengine.text.feelings import passages_of

_BRACKET = re.compile(r"\[[^\[\]\n]*\] ?")
NEUTRAL = "[neutral] "
USUAL = "smile 0.5"
"""What is offered where there is no feeling yet."""


@dataclass(frozen=True)
class FeltSpan:
    """A feeling of the text while it is shown.

    Attributes
    ----------
    start, end : seconds.
    words : names with shares, as a direction has them: ``smile 0.6``.
    offset : its place in the text, characters.
    directed : whether a direction says so, and not the words.
    """

    start: float
    end: float
    words: str
    offset: int
    directed: bool


class FeltText(QObject):
    """Follows text and words, and writes directions into the text; these edits can be undone.

    Signals
    -------
    changed : other feelings.

    Attributes
    ----------
    timed : what is felt from when on.
    spans : the same as spans, without what is neutral.
    """

    changed = Signal()

    def __init__(self, texts: TextModel, expression: ExpressionModel, undo_stack: QUndoStack) -> None:
        super().__init__()
        self._texts, self._expression, self._undo_stack = texts, expression, undo_stack
        self.timed: tuple[TimedFeeling, ...] = ()
        self.spans: tuple[FeltSpan, ...] = ()
        self._known: tuple[object, ...] = ()
        for signal in (texts.changed, texts.text_changed):
            signal.connect(self._follow)

    @property
    def _said(self) -> Utterance | None:
        utterance = self._texts.utterance
        return None if utterance is None else replace(utterance, language=self._texts.written.spoken_in)

    def _follow(self) -> None:
        said, text = self._said, self._texts.text_of_words
        if self._known and self._known[0] is self._texts.utterance and self._known[1:] == (text,):
            return
        self._known = self._texts.utterance, text
        try:
            timed = () if said is None else tuple(timed_feelings(text, said))
        except TextError:
            timed = ()  # while it is being typed; exports refuse it
        ends = [*(start for start, _ in timed[1:]), *([said.duration] if said is not None and timed else [])]
        spans = tuple(
            FeltSpan(
                start,
                end,
                ", ".join(f"{name} {share:.2g}" for name, share in felt.shares.items()),
                felt.offset,
                felt.directed,
            )
            for (start, felt), end in zip(timed, ends, strict=True)
            if felt.shares and end > start
        )
        if (timed, spans) != (self.timed, self.spans):  # while a text is spoken, only the last end may change
            self.timed, self.spans = timed, spans
            self._expression.take_text(timed)
            self.changed.emit()

    # -- edits --------------------------------------------------------------------------------------------

    def write(self, span: FeltSpan, words: str) -> None:
        """Have a span show other feelings, such as ``smile 0.6``; none where the words are empty."""
        text, words = self._texts.text, words.strip()
        cut = self._without(text, span)
        after = f"[{words}] " if words else NEUTRAL if not span.directed else ""
        put = cut[: span.offset] + after + cut[span.offset :]
        if not span.directed:
            put = self._ended(put, span, len(after))
        self._push(put, tr("change of a feeling"))

    def insert(self, seconds: float, words: str) -> None:
        """Show feelings from the word at a time on, to the end of its sentence's line or the next direction."""
        if words.strip() and (place := self._place_at(seconds)) is not None:
            text = self._texts.text
            self._push(f"{text[:place]}[{words.strip()}] {text[place:]}", tr("new feeling"))

    def move(self, number: int, *, is_end: bool, seconds: float) -> None:
        """Have a span begin, or end, at the word nearest to a time."""
        span, text, place = self.spans[number], self._texts.text, self._place_at(seconds)
        if place is None:
            return
        if is_end:
            following = next((felt for start, felt in self.timed if start >= span.end and felt.directed), None)
            found = None if following is None else _BRACKET.match(text, following.offset)
            moved, cut = (found[0], found.span()) if found else (NEUTRAL, (place, place))
        else:
            found = _BRACKET.match(text, span.offset) if span.directed else None
            moved, cut = (found[0], found.span()) if found else (f"[{span.words}] ", (span.offset, span.offset))
        moved = moved.rstrip() + " "
        if place >= cut[1]:
            put = text[: cut[0]] + text[cut[1] : place] + moved + text[place:]
        else:
            put = text[:place] + moved + text[place : cut[0]] + text[cut[1] :]
        self._push(put, tr("move of a feeling"))

    def _without(self, text: str, span: FeltSpan) -> str:
        found = _BRACKET.match(text, span.offset) if span.directed else None
        if found is None and span.directed:
            return text[: span.offset] + text[span.offset + 1 :].lstrip(" ")  # an emoji
        return text if found is None else text[: span.offset] + text[found.end() :]

    def _ended(self, text: str, span: FeltSpan, shift: int) -> str:
        """Return a text in which what comes after a sentence is as it was."""
        later = next((felt for _, felt in self.timed if felt.offset > span.offset), None)
        if later is None or later.directed:
            return text
        at = later.offset + shift
        return text[:at] + NEUTRAL + text[at:]

    def _place_at(self, seconds: float) -> int | None:
        """Return where in the text the word stands that begins nearest to a time."""
        said = self._texts.utterance
        if said is None or not said.words:
            return None
        places = [
            (abs(word.start - seconds), place)
            for word, place in zip(said.words, places_of(said, self._texts.text_of_words), strict=True)
            if place[1]
        ]
        return min(places)[1][0] if places else None

    def _push(self, text: str, what: str) -> None:
        if self._texts.stale:
            self._texts.error.emit(self._texts.stale)
            return
        try:
            passages_of(text, self._texts.written.spoken_in)
        except TextError as error:
            self._texts.error.emit(str(error))
            return
        if text != self._texts.text:
            ends = (self._texts.text, text)  # once it was changed otherwise, the edit is of no use
            edit = UndoableEdit(what, self._texts.set_text, *ends, lambda: self._texts.text in ends)
            self._undo_stack.push(edit)
