"""Asks which phonemes of which speakers are averaged."""

from typing import NamedTuple

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QDialog, QListWidget, QListWidgetItem, QSizePolicy, QToolButton, QWidget

from phonemeanalyser.desktop.engine_words import sound_name
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.widgets.builders import (
    CANCEL,
    Button,
    choice,
    column,
    dialog_buttons,
    grid,
    label,
    named,
    row,
    silent,
    toggle_button,
    tool_button,
)
from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.inspection.speaker_spectra import VOWELS, Grouping, Groups, groups_of, speaker_names
from phonemeengine.phonemes import Phoneme

COLUMNS = 5
"""Phonemes in a row."""
SIZE = 420, 440
"""Of the dialog at first, pixels."""


class LabelledSounds(NamedTuple):
    """Labelled recordings, and what they are called."""

    words: str
    utterances: tuple[LabelledUtterance, ...]


class GroupDialog(QDialog):
    """Lets the user choose speakers, phonemes, and what each curve is of; says how much sound that is.

    Attributes
    ----------
    source, by : which recordings, and what each curve is of.
    speakers : a list, of which those count that are ticked.
    phonemes : a button for each.
    told : how much sound that is, or what is missing.
    add : the button that accepts.
    """

    def __init__(self, sources: list[LabelledSounds], parent: QWidget) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Average by Phoneme"))
        self.resize(*SIZE)
        self._sources = sources
        self.source = choice(((source.words, k) for k, source in enumerate(sources)), tr("Recordings"))
        self.speakers = named(QListWidget(), tr("Speakers"))
        self.by = choice(
            (
                (tr("One curve for each speaker"), Grouping.SPEAKER),
                (tr("One curve for each phoneme"), Grouping.PHONEME),
                (tr("One curve for each phoneme of each speaker"), Grouping.SPEAKER_PHONEME),
            ),
            tr("Curves"),
        )
        self.phonemes: dict[Phoneme, QToolButton] = {}
        self.told = label(wraps=True)
        buttons = dialog_buttons(self, CANCEL, verb=tr("Add"))
        self.add = next(b for b in buttons.buttons() if b is not buttons.button(Button.Cancel))
        column(
            self.source,
            row(
                label(tr("Speakers")),
                1,
                tool_button(tr("All"), tr("Choose all speakers"), act=lambda: self._tick_all(True)),
                tool_button(tr("None"), tr("Choose no speaker"), act=lambda: self._tick_all(False)),
            ),
            (self.speakers, 1),
            row(
                label(tr("Phonemes")),
                1,
                tool_button(tr("Vowels"), tr("Choose the vowels"), act=lambda: self.choose(VOWELS)),
                tool_button(
                    tr("All"), tr("Choose all phonemes but silence"), act=lambda: self.choose(tuple(Phoneme))
                ),
            ),
            self._phoneme_buttons(),
            self.by,
            self.told,
            buttons,
            on=self,
            margins=None,
        )
        self.source.currentIndexChanged.connect(self._show_source)
        self.speakers.itemChanged.connect(self._tell)
        self.by.currentIndexChanged.connect(self._tell)
        self._show_source()

    def groups(self) -> Groups:
        """Return what the user chose to average."""
        ticked = [item.text() for item in self.items() if item.checkState() is Qt.CheckState.Checked]
        chosen = [phoneme for phoneme, button in self.phonemes.items() if button.isChecked()]
        if not ticked or not chosen:
            return {}
        is_all = len(chosen) == sum(button.isEnabled() for p, button in self.phonemes.items() if p != Phoneme.SILENCE)
        everything = is_all and not self.phonemes[Phoneme.SILENCE].isChecked()
        by = Grouping(self.by.currentData())
        return groups_of(self._utterances, by, () if everything else chosen, ticked, tr("vowels"))

    def items(self) -> list[QListWidgetItem]:
        """Return the lines of the list of speakers."""
        return [self.speakers.item(k) for k in range(self.speakers.count())]

    def choose(self, phonemes: tuple[Phoneme, ...]) -> None:
        """Choose these phonemes, as far as the recordings have them; silence only by its own button."""
        for phoneme, button in self.phonemes.items():
            with silent(button):
                button.setChecked(button.isEnabled() and phoneme in phonemes and phoneme is not Phoneme.SILENCE)
        self._tell()

    @property
    def _utterances(self) -> tuple[LabelledUtterance, ...]:
        return self._sources[self.source.currentIndex()].utterances

    def _tick_all(self, on: bool) -> None:
        with silent(self.speakers):
            for item in self.items():
                item.setCheckState(Qt.CheckState.Checked if on else Qt.CheckState.Unchecked)
        self.speakers.viewport().update()
        self._tell()

    def _phoneme_buttons(self) -> QWidget:
        body = QWidget()
        places = grid(body, across=4, down=4)
        others = (p for p in reversed(Phoneme) if p not in VOWELS)
        for k, phoneme in enumerate((*VOWELS, *others)):
            button = self.phonemes[phoneme] = toggle_button(sound_name(phoneme), "")
            button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
            button.toggled.connect(self._tell)
            places.addWidget(button, k // COLUMNS, k % COLUMNS)
        return body

    def _show_source(self) -> None:
        said = {label.phoneme for utterance in self._utterances for label in utterance.labels}
        with silent(self.speakers):
            self.speakers.clear()
            for name in sorted(set(speaker_names(self._utterances).values())):
                item = QListWidgetItem(name, self.speakers)
                item.setCheckState(Qt.CheckState.Checked)
        for phoneme, button in self.phonemes.items():
            button.setEnabled(phoneme in said)
            button.setToolTip("" if phoneme in said else tr("The labels have no such phoneme"))
        self.choose(VOWELS if said & set(VOWELS) else tuple(Phoneme))

    def _tell(self) -> None:
        groups = self.groups()
        seconds = sum(end - start for parts in groups.values() for part in parts for start, end in part.spans)
        words = tr(
            "1 curve of {seconds:.1f} s of sound" if len(groups) == 1 else "{n} curves of {seconds:.1f} s of sound"
        ).format(n=len(groups), seconds=seconds)
        self.told.setText(
            words if groups else tr("Choose at least one speaker and one phoneme that the labels have.")
        )
        self.add.setEnabled(bool(groups))
