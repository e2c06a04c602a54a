"""The script below the head: what is said in the current sound, or what a voice is to say."""

from bisect import bisect_right

from PySide6.QtCore import QSize, Signal
from PySide6.QtGui import QColor, QTextCursor
from PySide6.QtWidgets import QCheckBox, QComboBox, QPlainTextEdit, QTextEdit, QWidget
from typing_extensions import override

from phonemeanalyser.desktop.engine_words import tr_engine
from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.talk.model import TalkModel
from phonemeanalyser.desktop.talk.words.voice_panel import VoiceButton
from phonemeanalyser.desktop.talk.words.written_text import places_of
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets import builders
from phonemeanalyser.desktop.widgets.fields import SearchBox
from phonemeengine.labels.utterance import Utterance

N_LINES = 4
NARROWEST = 90
"""Of the choice of a language, pixels, where the window is small."""
NO_LANGUAGE = tr_noop("Choose language…")
NO_SPEAKER = tr_noop("Choose speaker…")
INVITATION = tr_noop(
    "Text of the recording, or text to speak: Ctrl+Return speaks it, Ctrl+Shift+Return aligns it with the recording"
)

NOTATION = tr_noop(
    "Read names of speakers, [directions], *emphasis*, <tags> and &entities; in a script as words; otherwise "
    "they are left out"
)
LEXICON = tr_noop(
    "Load a file with the pronunciation of words; other words are pronounced by the rules of the language"
)


class TextField(QPlainTextEdit):
    """A text of some lines; Tab goes on to the next control."""

    def __init__(self) -> None:
        super().__init__()
        self.setTabChangesFocus(True)
        self.setPlaceholderText(tr(INVITATION))
        self.setAccessibleName(tr("Text"))

    @override
    def sizeHint(self) -> QSize:
        edges = 2 * (self.frameWidth() + round(self.document().documentMargin()))
        return QSize(200, N_LINES * self.fontMetrics().lineSpacing() + edges + 2)

    @override
    def minimumSizeHint(self) -> QSize:
        return QSize(0, self.sizeHint().height())

    def mark(self, start: int, end: int, theme: Theme) -> None:
        """Mark the characters from one place to another, or none."""
        marked = QTextEdit.ExtraSelection()
        marked.cursor = self.textCursor()
        marked.cursor.setPosition(min(start, self.document().characterCount() - 1))
        last = min(end, self.document().characterCount() - 1)
        marked.cursor.setPosition(last, QTextCursor.MoveMode.KeepAnchor)
        marked.format.setBackground(QColor(theme.accent))
        marked.format.setForeground(QColor(theme.on_colour))
        self.setExtraSelections([marked] if end > start else [])

    def replace_text(self, text: str) -> None:
        """Write another text, so that Ctrl+Z brings the old one back."""
        cursor = self.textCursor()
        cursor.select(QTextCursor.SelectionType.Document)
        cursor.insertText(text)


class TextPanel(QWidget):
    """The text, and beside it its language, voice and lexicon, and the button that does what it is there for.

    Signals
    -------
    script_asked, lexicon_asked : the user wants to choose a script, or a lexicon.

    Attributes
    ----------
    act : aligns the text with the recording that is open; without one it has the text said.
    """

    script_asked = Signal()
    lexicon_asked = Signal()

    def __init__(self, talking: TalkModel, theme: Theme) -> None:
        super().__init__()
        self._talking, self._texts, self._theme = talking, talking.text, theme
        self._spoken: tuple[Utterance, list[float], list[tuple[int, int]]] | None = None
        self._marked = (0, 0)
        self._listed: object = None
        self.field = TextField()
        self.script = builders.spoken_button(
            tr("Script…"),
            tr("Open the text of the recording: a text file, a TextGrid, or JSON with word times"),
            self.script_asked.emit,
        )
        self.speaker = builders.choice((), tr("Speaker"), tr("Speaker whose words are read from the labels"))
        self.language = SearchBox(
            tr("Language of the text"),
            tr("Language of the text, those that were chosen last first; type any part of its name to find it"),
        )
        self.language.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToContents)
        self.language.setMinimumWidth(NARROWEST)
        self.voice = VoiceButton(self._texts.voice, self._texts.drivers, theme)
        self.lexicon = builders.spoken_button(tr("Lexicon…"), tr(LEXICON), self._choose_lexicon)
        self.literal = builders.named(QCheckBox(tr("Literal")), tip=tr(NOTATION))
        self.act = builders.tool_button("", act=self._align_or_say)
        self.act.setStyleSheet(
            f"QToolButton {{ color: {theme.on_colour}; background: {theme.accent}; border: 1px solid {theme.accent};"
            " border-radius: 4px; padding: 4px 14px; font-weight: bold }"
            f"QToolButton:focus {{ border-color: {theme.text} }}"
            f"QToolButton:disabled {{ color: {theme.faint}; background: {theme.raised}; border-color: {theme.line} }}"
        )
        self.anyway = builders.spoken_button(
            tr("Align Anyway"),
            tr("Align the text, though it doesn’t seem to match the recording"),
            self._texts.align_anyway,
        )
        self.refusal = builders.ElidedLabel(tr("The recording doesn’t match this text."))
        self.state = builders.ElidedLabel()
        self._lay_out()
        self._connect()
        self._show_state()
        self._show_text()
        self._texts.voice.wake()
        for files in (self._texts.drivers.performance, self._texts.drivers.network):
            files.wake()

    def _lay_out(self) -> None:
        written = builders.column(self.field, builders.row(self.anyway, (self.refusal, 1), spacing=6), spacing=4)
        beside = builders.column(
            builders.row(self.language, self.speaker, 1, spacing=6),
            builders.row(self.voice, self.script, 1, spacing=6),
            builders.row(self.lexicon, self.literal, 1, spacing=6),
            builders.row(self.act, (self.state, 1), spacing=6),
            1,
            spacing=4,
        )
        builders.row((written, 1), beside, on=self, margins=(8, 4, 8, 4), spacing=8)

    def _connect(self) -> None:
        texts, session = self._texts, self._talking.session
        self.field.textChanged.connect(lambda: texts.set_text(self.field.toPlainText()))
        self.speaker.textActivated.connect(self._choose_speaker)
        self.language.activated.connect(lambda k: texts.set_language(self.language.itemData(k)))
        self.literal.clicked.connect(texts.set_literal)
        texts.changed.connect(self._show_state)
        texts.text_changed.connect(self._show_text)
        texts.voice.changed.connect(self._show_state)
        session.transport_changed.connect(self._show_state)
        session.opened.connect(self._show_state)

    @property
    def _aligns(self) -> bool:
        """Whether there is a recording to align the text with."""
        return self._talking.session.source.path is not None

    def _align_or_say(self) -> None:
        self.field.clearFocus()  # so that Space plays from now on, and is not typed into the text
        if self._aligns:
            self._texts.align()
        else:
            self._texts.say()

    def _choose_speaker(self, name: str) -> None:
        if name in self._texts.speakers:
            self._texts.choose_speaker(name)

    def _choose_lexicon(self) -> None:
        """Choose a lexicon, or do without the one that is in use."""
        if self._texts.lexicon_path is None:
            self.lexicon_asked.emit()
        else:
            self._texts.set_lexicon(None)

    def _show_state(self) -> None:
        texts = self._texts
        self._show_speakers()
        self._show_lexicon()
        self._show_languages()
        self._show_act()
        for part in (self.anyway, self.refusal):
            part.setVisible(texts.refused is not None and not texts.busy)
        self.literal.setChecked(texts.literal)
        lack = "" if texts.voice.choice.by_program else tr_engine(texts.voice.lack)
        self.state.setText(texts.progress or lack)
        self.state.setToolTip(self.state.text())

    def _show_text(self) -> None:
        """Show text and language; what is typed is not written again."""
        if self.field.toPlainText() != self._texts.text:
            with builders.silent(self.field):
                self.field.replace_text(self._texts.text)
        self._spoken = None
        self._show_state()

    def refresh(self) -> None:
        """Mark the word that is playing."""
        utterance = self._texts.utterance
        if utterance is None or not self._talking.session.source.playing:
            span = (0, 0)
        else:
            if self._spoken is None or self._spoken[0] is not utterance:
                starts = [word.start for word in utterance.words]
                self._spoken = utterance, starts, places_of(utterance, self._texts.text)
            position = self._talking.session.source.position
            k = bisect_right(self._spoken[1], position) - 1
            is_said = k >= 0 and position < utterance.words[k].end
            span = self._spoken[2][k] if is_said else (0, 0)
        if span != self._marked:
            self._marked = span
            self.field.mark(*span, self._theme)

    def _show_act(self) -> None:
        """Show what the button does now; while that goes on, it ends it."""
        name, tip = tr("Speak"), tr("Speak the text with a synthetic voice (Ctrl+Return); Escape stops it")
        if self._aligns:
            name, tip = tr("Align"), tr("Find the words of the text in the recording (Ctrl+Shift+Return)")
        if self._aligns and self._texts.busy:
            name, tip = tr("Cancel"), tr("Stop Aligning")
        self.act.setText(name)
        builders.named(self.act, tip, tip)

    def _show_speakers(self) -> None:
        speakers = self._texts.speakers
        builders.offer(
            self.speaker, [(tr(NO_SPEAKER), None), *((name, name) for name in speakers)], self._texts.speaker or None
        )
        self.speaker.setVisible(len(speakers) > 1)

    def _show_languages(self) -> None:
        """List the languages that were chosen last, then all; without a choice the one that is guessed is named."""
        written, installed = self._texts.written, self._texts.voice.installed
        listed = written.guess, written.language, tuple(written.recent), installed
        if listed == self._listed:  # which are more than a hundred
            self.language.setCurrentIndex(max(0, self.language.findData(written.language)))
            return
        self._listed = listed
        names = {one.tag: tr(short_name(one.name)) for one in installed.languages}
        none = tr(NO_LANGUAGE)
        if written.guess in names:
            none = tr("{language} (guessed)").format(language=names[written.guess])
        recent = [(names[tag], tag) for tag in written.recent if tag in names]
        every = sorted((name, tag) for tag, name in names.items() if tag not in written.recent)
        builders.offer(self.language, [(none, ""), *recent, *every], written.language)

    def _show_lexicon(self) -> None:
        path = self._texts.lexicon_path
        if path is None:
            builders.named(self.lexicon, tr(LEXICON), tr(LEXICON)).setText(tr("Lexicon…"))
        else:
            builders.show_removable(self.lexicon, path.name, tr("Remove the lexicon {path}").format(path=path))


def short_name(name: str) -> str:
    """Return the name of a language without what the voice does with Latin letters."""
    return name.replace(", latin as English", "").replace("latin as ", "")
