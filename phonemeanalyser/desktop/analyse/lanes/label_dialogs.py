"""What the user is asked about the labels of a file: names, tiers, files, and what becomes of changes."""

from PySide6.QtCore import QObject, Qt
from PySide6.QtWidgets import QDialog, QInputDialog, QListWidget, QListWidgetItem, QWidget

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.session.label_tiers import LabelTiers
from phonemeanalyser.desktop.session.selection import NOTHING_SELECTED
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.session.time_view import TimeSpan
from phonemeanalyser.desktop.widgets.builders import CANCEL, OK, choice, column, dialog_buttons, label, named
from phonemeanalyser.desktop.widgets.file_asker import FileAsker, ask_to_save

LABEL_FILTER = tr_noop("Labels (*.TextGrid *.txt *.csv)")
NONE = tr_noop("none")
AROUND = 0.5
"""Seconds that are seen at least on either side of an error."""


WHAT_WAS_HEARD = tr_noop(
    "Save what was heard as a sound (Selection > Save Selection as Sound…), open that, and label it."
)


class LabelDialogs(QObject):
    """Asks, and passes the answers to the labels of the session."""

    def __init__(self, window: QWidget, session: Session, files: FileAsker) -> None:
        super().__init__(window)
        self._window = window
        self._session = session
        self._labels = session.labels
        self._files = files

    # -- errors -------------------------------------------------------------------------------------------

    def next_error(self, *, back: bool = False) -> None:
        """Select the next stretch, or the one before, in which something else was recognised than the labels say."""
        session, tracks = self._session, self._session.whole.tracks
        if not self._has_file():
            return
        if tracks is None or self._labels.said_frames() is None:
            session.error.emit(tr("No labels say what is said; load some by Labels > Load Labels."))
            return
        selected = session.view.selection
        found = self._labels.next_error(
            tracks, session.source.position if selected is None else selected.start, back=back
        )
        if found is None:
            before, after = tr("There is no error before this place."), tr("There is no error after this place.")
            session.labels.info.emit(before if back else after)
            return
        session.seek(found.seen_at)
        session.view.select(TimeSpan(found.start, found.end))
        seen = session.view.seen
        if not (seen.start <= found.start and found.end <= seen.end):
            half = max(seen.seconds / 2, found.end - found.start + AROUND)
            middle = (found.start + found.end) / 2
            session.view.show(TimeSpan(middle - half, middle + half))
        said, recognised = found.said.label, found.recognised.label
        session.labels.info.emit(
            tr("{start:.2f} to {end:.2f} s: {said} is said, {recognised} was recognised").format(
                start=found.start, end=found.end, said=said, recognised=recognised
            )
        )

    def _has_file(self) -> bool:
        """Say whether there is something to label: what a microphone heard becomes a file first."""
        if self._session.seen.looks_back:
            self._session.error.emit(tr(WHAT_WAS_HEARD))
        return not self._session.seen.looks_back

    # -- labels -------------------------------------------------------------------------------------------

    def ask_rename(self) -> None:
        """Let the user rename the chosen label."""
        chosen = self._labels.chosen
        if chosen is None:
            self._session.error.emit(tr("No label is chosen; click one under the sonagram first."))
            return
        name = self._labels.tiers[chosen.tier].raw_labels[chosen.label].name
        name, wanted = QInputDialog.getText(
            self._window, tr("Rename the label"), tr("What is said there:"), text=name
        )
        if wanted:
            self._labels.rename(chosen, name)

    def ask_insert(self) -> None:
        """Let the user label what is selected."""
        span = self._session.view.selection
        if not self._has_file():
            return
        if span is None:
            self._session.error.emit(tr(NOTHING_SELECTED))
            return
        question = tr("What is said from {start:.3f} to {end:.3f} s:").format(start=span.start, end=span.end)
        name, wanted = QInputDialog.getText(self._window, tr("New label"), question)
        if wanted:
            self._labels.insert(self._labels.state.said, *span, name)

    def delete(self) -> None:
        """Delete the chosen label."""
        if self._labels.chosen is None:
            self._session.error.emit(tr("No label is chosen; click one under the sonagram first."))
        else:
            self._labels.delete(self._labels.chosen)

    def ask_tiers(self) -> None:
        """Let the user choose which tiers are shown, and which one says what is said."""
        if not self._labels.tiers:
            self._session.error.emit(tr("There are no labels yet; load some by Labels > Load Labels."))
            return
        dialog = TiersDialog(self._labels, self._window)
        if dialog.exec():
            self._labels.show(dialog.shown(), dialog.said())
        dialog.deleteLater()

    # -- files --------------------------------------------------------------------------------------------

    def ask_load(self) -> None:
        """Let the user choose a label file for the sound in hand."""
        path = self._session.path
        if path is None:
            self._session.error.emit(tr("There is no sound file in hand; open the one that the labels belong to."))
            return
        file = self._files.ask_file(tr("Load labels"), tr(LABEL_FILTER), "labels", path.parent)
        if file is not None and self.may_leave():
            self._labels.load(file)

    def save(self) -> bool:
        """Save the labels to their file, or to one that the user chooses."""
        path = self._labels.path
        return self.ask_save_as() if path is None else self._labels.save(path)

    def ask_save_as(self) -> bool:
        """Let the user choose a file to save the labels to; says whether they were saved."""
        sound = self._session.path
        if sound is None or not self._labels.tiers:
            self._session.error.emit(tr("There are no labels yet; select a stretch and insert one by Ctrl+I."))
            return False
        suggested = self._labels.path or sound.with_suffix(".TextGrid")
        path = self._files.ask_target(tr("Save the labels"), suggested, tr(LABEL_FILTER), "labels")
        return path is not None and self._labels.save(path)

    def may_leave(self) -> bool:
        """Ask what is to become of labels that were changed and not saved; says whether to go on."""
        sound = self._session.path
        if not self._labels.has_unsaved_changes or sound is None:
            return True
        question = tr("Save the labels of {sound}, which you changed?").format(sound=sound.name)
        return ask_to_save(self._window, tr("Unsaved labels"), question, self.save)


class TiersDialog(QDialog):
    """Asks which tiers are shown, and which one says what is said.

    Attributes
    ----------
    list : the tiers, each with a check mark.
    says : the choice of the one that is compared with what is recognised.
    """

    def __init__(self, labels: LabelTiers, parent: QWidget) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Tiers"))
        self.list = named(QListWidget(), tr("tiers that are shown"))
        self.says = choice([(tr(NONE), None)], tr("tier that is compared with what is recognised"))
        for k, tier in enumerate(labels.tiers):
            n = len(tier.raw_labels)
            held = tr("{n} points") if tier.points else tr("{n} labels")
            item = QListWidgetItem(f"{tier.name} ({held.format(n=n)})")
            item.setFlags(item.flags() | Qt.ItemFlag.ItemIsUserCheckable)
            item.setCheckState(Qt.CheckState.Checked if k in labels.state.shown else Qt.CheckState.Unchecked)
            self.list.addItem(item)
            self.says.addItem(tier.name)
        self.says.setCurrentIndex(0 if labels.state.said is None else labels.state.said + 1)
        column(
            label(tr("Shown under the sonagram:")),
            self.list,
            label(tr("Compared with what is recognised:")),
            self.says,
            dialog_buttons(self, OK, CANCEL),
            on=self,
            margins=None,
        )

    def shown(self) -> list[int]:
        """Return the numbers of the tiers that are to be shown."""
        return [k for k in range(self.list.count()) if self.list.item(k).checkState() is Qt.CheckState.Checked]

    def said(self) -> int | None:
        """Return the number of the tier that says what is said."""
        k = self.says.currentIndex() - 1
        return None if k < 0 else k
