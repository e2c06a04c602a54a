"""Changes of a preset that are in no file of the user's, kept so that no ending of the program loses them."""

from contextlib import suppress
from dataclasses import replace
from itertools import count
from pathlib import Path
from typing import Any

from PySide6.QtCore import QObject, QSettings, QTimer

from phonemeanalyser.desktop.engine_words import tr_engine
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.session.preset import PresetDocument, PresetModel
from phonemeanalyser.desktop.settings import keep, read
from phonemeengine.errors import EngineError
from phonemeengine.presets.files import MODEL_SUFFIXES, load_preset, save_preset
from phonemeengine.storage.replacing import lock_at

KEPT_AFTER_MS = 1000
"""So long after the last change of a preset the changes are written: a drag is not written all the time."""


class UnsavedChanges(QObject):
    """Keeps a copy of a preset with changes that are in no file of the user's; programs at once have one each.

    Parameters
    ----------
    preset : the preset that is changed.
    folder : where the copies are.
    settings : knows of which file a copy is.
    """

    def __init__(self, preset: PresetModel, folder: Path, settings: QSettings) -> None:
        super().__init__(preset)
        with suppress(OSError):  # a write reports what is wrong
            folder.mkdir(parents=True, exist_ok=True)
        self._preset = preset
        self._settings = settings
        self.path, self._lock = _first_free(folder)
        self._timer = QTimer(self, singleShot=True, interval=KEPT_AFTER_MS)
        self._timer.timeout.connect(self.keep)
        preset.file_changed.connect(self._timer.start)

    def restore(self) -> bool:
        """Restore the changes that were left; says whether there were any. Undo takes those of the one in use back.

        Raises
        ------
        EngineError : there are some, but they cannot be read.
        """
        found = False
        if self._of_other.exists():
            base, changed = self._base_of(self._of_other), load_preset(self._of_other)
            saved = load_preset(base) if base.is_file() else changed
            self._preset.set_other(PresetDocument(base, replace(changed, name=saved.name), saved))
            found = True
        if self.path.exists():
            base, changed = self._base_of(self.path), load_preset(self.path)
            if base.is_file() and base != self._preset.path:
                self._preset.load(base)
            self._preset.edit(changed, tr("restore unsaved changes"))
            found |= self._preset.has_unsaved_changes
        return found

    def keep(self) -> None:
        """Write the changes of A and B, or forget those that were written where there are none any more."""
        for path, document in ((self.path, self._preset.document), (self._of_other, self._preset.other)):
            if document is None or not document.has_unsaved_changes:
                _forget(path)
                continue
            keep(self._settings, f"unsaved/{path.stem}", document.path.resolve())
            try:
                save_preset(document.preset, path)
            except EngineError as error:
                sentence = tr("Unsaved changes can't be kept for the next start: {error}")
                self._preset.rejected.emit(sentence.format(error=tr_engine(str(error))))

    def forget(self) -> None:
        """Forget what was written."""
        for path in (self.path, self._of_other):
            _forget(path)

    def close(self) -> None:
        """Leave the copy, if there is one, to the next start."""
        self._timer.stop()
        self._lock.release()

    @property
    def _of_other(self) -> Path:
        """The copy of the preset that is not in use."""
        return self.path.with_stem(f"{self.path.stem}-other")

    def _base_of(self, path: Path) -> Path:
        """Return the file of the preset of which a copy is."""
        return read(self._settings, f"unsaved/{path.stem}", Path())


def _forget(copy: Path) -> None:
    for path in (copy, *(copy.with_suffix(suffix) for suffix in MODEL_SUFFIXES.values())):
        with suppress(OSError):  # it is offered once more at the next start
            path.unlink(missing_ok=True)


def _first_free(folder: Path) -> tuple[Path, Any]:
    """Return the first copy that belongs to no program that lives, and the lock that says so."""
    for number in count(1):
        lock = lock_at(folder / f"unsaved-{number}.lock")
        try:
            lock.acquire(blocking=False)
        except TimeoutError:
            continue
        except (OSError, NotImplementedError):  # no locks on this file system; a write reports what is wrong
            pass
        break
    return folder / f"unsaved-{number}.toml", lock
