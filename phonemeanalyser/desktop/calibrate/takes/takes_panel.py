"""The left of the page: the project, its speaker, a button for each phoneme that records a take, and the takes."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from PySide6.QtCore import QRectF, Qt, Signal
from PySide6.QtGui import QColor, QImage, QKeyEvent, QKeySequence, QMouseEvent, QPainter, QPaintEvent, QShortcut
from PySide6.QtWidgets import QGridLayout, QLabel, QLineEdit, QMenu, QSizePolicy, QToolButton, QWidget
from typing_extensions import override

from phonemeanalyser.desktop.calibrate.model import CalibrationModel
from phonemeanalyser.desktop.calibrate.takes.take_list import TakeListView
from phonemeanalyser.desktop.calibrate.takes.takes_model import TakesModel
from phonemeanalyser.desktop.engine_words import sound_name
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.theme import CENTRED, PHONEME_COLOURS, Theme, draw_text, format_clock, letters_on, mixed
from phonemeanalyser.desktop.widgets import builders
from phonemeanalyser.desktop.widgets.keyboard import KEYS, ArrowKeys
from phonemeanalyser.desktop.widgets.lanes import BoundaryDrag, Lane, TimeAxis, wave_pixels
from phonemeanalyser.desktop.widgets.plot import PlotMenu, table_of
from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.dsp.waveform_peaks import Peaks
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import SAMPLE_RATE

HEADING = 15
"""Pixels above the sound, for words."""
NEAR = 8
"""Pixels from an end within which it is taken hold of."""
LEAST = 0.03
"""What counts lasts at least so long, seconds."""
SHARE = 0.92
"""Of the height, that the loudest sample takes."""
THINNED = 60 / 255
"""How much of its colour is seen behind what counts."""


class TakeWaveform(QWidget):
    """Draws a take, and lets its ends be moved with the mouse, or with arrow keys (Shift: the other end).

    Signals
    -------
    trimmed : start and end of what counts, seconds.
    """

    trimmed = Signal(float, float)

    def __init__(self, takes: TakesModel, theme: Theme) -> None:
        super().__init__()
        self._takes = takes
        self._theme = theme
        self.ends: tuple[float, float] | None = None
        self._drag = BoundaryDrag(NEAR)
        self.setMinimumSize(120, 64)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.installEventFilter(ArrowKeys(self))
        self.setMouseTracking(True)
        self.setAccessibleName(tr("Trim take"))
        self.setToolTip(
            tr("Drag the edges to trim the take; the arrow keys move the start by 10 ms, with Shift the end")
        )
        self.menu = PlotMenu(self, "take", lambda _at: table_of(self._columns()))
        takes.changed.connect(self._show)
        takes.sound_read.connect(self._show)

    @override
    def paintEvent(self, _event: Any) -> None:
        painter = QPainter(self)
        painter.fillRect(self.rect(), QColor(self._theme.base))
        take = self._takes.take(self._takes.selected) if self._takes.selected is not None else None
        sound = self._takes.sound
        if take is None or self.ends is None or not len(sound):
            painter.setPen(QColor(self._theme.faint))
            painter.drawText(self.rect(), Qt.AlignmentFlag.AlignCenter, tr("Select a take to play and trim it"))
            return
        left, right = (self.axis.x_of(end) for end in self.ends)
        counting = QColor(PHONEME_COLOURS[take.phoneme])
        self._paint_sound(painter, left, right, counting)
        for x in (left, right):
            painter.fillRect(QRectF(x - 1, HEADING, 2, self.height() - HEADING), counting)
            painter.fillRect(QRectF(x - 4, (self.height() + HEADING) / 2 - 8, 8, 16), counting)
        words = f"{take.name}   " + tr("{start:.2f} – {end:.2f} s of {duration:.2f} s").format(
            start=self.ends[0], end=self.ends[1], duration=take.duration
        )
        draw_text(painter, QRectF(6, 0, self.width() - 10, HEADING), words, self._theme.text, 10)

    @override
    def mousePressEvent(self, event: QMouseEvent) -> None:
        self.setFocus()
        if event.button() == Qt.MouseButton.LeftButton:
            self._drag.press(self._rows(), self.axis, event.position(), self._duration)

    @override
    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        held = self._drag.move(round(self.axis.time_at(event.position().x()), 3))
        if held is None:
            over = self._drag.boundary_at(self._rows(), self.axis, event.position())
            self.setCursor(Qt.CursorShape.ArrowCursor if over is None else Qt.CursorShape.SplitHCursor)
        else:
            self._put(held.boundary, held.seconds)

    @override
    def mouseReleaseEvent(self, _event: QMouseEvent) -> None:
        if self._drag.release() is not None and self.ends is not None:
            self.trimmed.emit(*self.ends)

    @override
    def keyPressEvent(self, event: QKeyEvent) -> None:
        steps = {Qt.Key.Key_Left: -0.01, Qt.Key.Key_Right: 0.01}
        if event.key() not in steps or self.ends is None:
            super().keyPressEvent(event)
            return
        end = int(bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier))
        low, high = self._rows()[0][1].room_of(end, self._duration)
        self._put(end, min(max(self.ends[end] + steps[Qt.Key(event.key())], low), high))
        self.trimmed.emit(*self.ends)

    def _show(self) -> None:
        take = self._takes.take(self._takes.selected) if self._takes.selected is not None else None
        if self._drag.held is None:
            self.ends = (take.start, take.end) if take is not None else None
        self.update()

    def _put(self, end: int, seconds: float) -> None:
        if self.ends is not None:
            self.ends = (self.ends[0], seconds) if end else (seconds, self.ends[1])
            self.update()

    def _columns(self) -> dict[str, Float32Array | Float64Array]:
        sound = self._takes.sound
        return {tr("time (s)"): np.arange(len(sound)) / SAMPLE_RATE, "amplitude": sound}

    def _paint_sound(self, painter: QPainter, left: float, right: float, counting: QColor) -> None:
        sound, width, height = self._takes.sound, max(1, self.width()), max(3, self.height() - HEADING)
        edges = np.linspace(0, len(sound), width + 1).astype(int)[:-1]
        peaks = Peaks(np.minimum.reduceat(sound, edges), np.maximum.reduceat(sound, edges))
        loudest = max(float(np.abs(sound).max()), 1e-4) / SHARE
        columns, base = np.arange(width), QColor(self._theme.base)
        counts = (left <= columns) & (columns <= right)
        colour = np.where(counts, QColor(self._theme.signal).rgb(), QColor(self._theme.faint).rgb())
        background = np.where(counts, mixed(counting, base, THINNED).rgb(), base.rgb())
        pixels = wave_pixels(peaks, loudest, height, colour.astype(np.uint32), background.astype(np.uint32))
        image = QImage(pixels.data, width, height, 4 * width, QImage.Format.Format_RGB32)
        painter.drawImage(0, HEADING, image)

    @property
    def _duration(self) -> float:
        return max(len(self._takes.sound) / SAMPLE_RATE, 1e-3)

    @property
    def axis(self) -> TimeAxis:
        """Where times lie."""
        return TimeAxis(0, max(1, self.width()), 0.0, self._duration)

    def _rows(self) -> list[tuple[QRectF, Lane]]:
        """Return what counts as a lane of one span, whose ends can be dragged anywhere on the widget."""
        if self.ends is None:
            return []
        starts, ends = (np.array([end]) for end in self.ends)
        return [(QRectF(self.rect()), Lane("", starts, ends, movable=True, least=LEAST))]


COLUMNS = 5


class PhonemeButton(QToolButton):
    """Shows a phoneme, its colour and its key."""

    def __init__(self, phoneme: Phoneme, theme: Theme) -> None:
        super().__init__()
        self.phoneme = phoneme
        self.n_takes = 0
        self._theme = theme
        self.setMinimumSize(52, 40)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        name = sound_name(phoneme)
        self.setAccessibleName(tr("Record a take of {name}").format(name=name))
        self.setToolTip(
            tr(
                "Hold the button or the {key} key while you say {name}, or while it sounds in the playing file"
            ).format(key=KEYS[phoneme], name=name)
        )

    @override
    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        colour = QColor(PHONEME_COLOURS[self.phoneme])
        box = self.rect().adjusted(1, 1, -1, -1)
        painter.setPen(QColor(self._theme.accent if self.hasFocus() or self.underMouse() else self._theme.line))
        down = self.isDown()
        painter.setBrush(colour if down else QColor(self._theme.raised))
        painter.drawRoundedRect(box, 4, 4)
        painter.fillRect(box.left() + 4, box.bottom() - 4, box.width() - 8, 3, colour)
        text = QColor(letters_on(PHONEME_COLOURS[self.phoneme]) if down else self._theme.text)
        name = sound_name(self.phoneme)
        inner = self.rect().adjusted(5, 2, -5, -3)
        draw_text(painter, inner.adjusted(-5, 0, 5, 0), name, text, 15 if len(name) < 4 else 12, CENTRED)
        faint = text if down else QColor(self._theme.faint)
        draw_text(painter, inner, KEYS[self.phoneme], faint, 10, Qt.AlignmentFlag.AlignLeft)
        if self.n_takes:
            draw_text(painter, inner, f"×{self.n_takes}", faint, 10, Qt.AlignmentFlag.AlignRight)


class RecordPanel(QWidget):
    """Records takes, of the microphone or of the file that plays, and marks segments of it."""

    def __init__(self, calibration: CalibrationModel, theme: Theme) -> None:
        super().__init__()
        self._calibration = calibration
        self._theme = theme
        self.buttons = {phoneme: PhonemeButton(phoneme, theme) for phoneme in KEYS}
        self.hint = QLabel()
        self.start = builders.spoken_button("[", tr("Start the marked range at the playback position ([)"))
        self.end = builders.spoken_button("]", tr("End the marked range at the playback position (])"))
        self._lay_out()
        self._connect()
        self._show_takes()
        self.show_state()

    def show_state(self) -> None:
        """Show what holding a button does now."""
        session, selection = self._calibration.session, self._calibration.selection
        held = self._calibration.phoneme
        of_file = session.source.path is not None
        if held is not None:
            text = tr("<b>Recording {phoneme}</b>: release to finish").format(phoneme=sound_name(held))
        elif of_file and selection is not None and not session.source.playing:
            start, end = (format_clock(seconds, True) for seconds in selection)
            text = tr("<b>{start} – {end}</b>: choose a phoneme").format(start=start, end=end)
        elif of_file and session.source.playing:
            text = tr("Hold a key while its sound plays")
        else:
            text = tr("Hold a key or button and say its sound")
        self.hint.setText(text)
        for button in (self.start, self.end):
            button.setEnabled(of_file)
        for phoneme, button in self.buttons.items():
            if button.isDown() != (phoneme is held):
                button.setDown(phoneme is held)

    def _lay_out(self) -> None:
        for button in (self.start, self.end):
            button.setFixedWidth(24)
        buttons = QGridLayout()
        buttons.setSpacing(4)
        for k, button in enumerate(self.buttons.values()):
            buttons.addWidget(button, k // COLUMNS, k % COLUMNS)
        builders.column(builders.row((self.hint, 1), self.start, self.end), buttons, on=self, spacing=3)

    def _connect(self) -> None:
        calibration = self._calibration
        for phoneme, button in self.buttons.items():
            button.pressed.connect(lambda phoneme=phoneme: calibration.press(phoneme))
            button.released.connect(calibration.release)
        for sign, end in ((self.start, False), (self.end, True)):
            sign.clicked.connect(lambda _checked=False, end=end: calibration.mark(end=end))
            key = QShortcut(QKeySequence(sign.text()), self)  # a button's own would wait to be seen pressed
            key.activated.connect(lambda end=end: calibration.mark(end=end))
        calibration.held.connect(self.show_state)
        calibration.selection_changed.connect(self.show_state)
        calibration.session.transport_changed.connect(self.show_state)
        calibration.session.opened.connect(self.show_state)
        calibration.takes.changed.connect(self._show_takes)

    def _show_takes(self) -> None:
        takes = self._calibration.takes.now.takes
        for phoneme, button in self.buttons.items():
            button.n_takes = sum(take.phoneme is phoneme and not take.excluded for take in takes)
            button.update()


WIDTH = 330


class TakesPanel(QWidget):
    """The project and its takes.

    Signals
    -------
    project_asked : the user wants another folder for his takes.
    empty_asked : the user wants deleted takes to be removed for ever.
    import_asked : the user wants to load labelled recordings: a folder (True) or files.
    guide_asked : the user wants to be led through all sounds.
    """

    project_asked = Signal()
    empty_asked = Signal()
    import_asked = Signal(bool)
    guide_asked = Signal()

    def __init__(self, calibration: CalibrationModel, theme: Theme) -> None:
        super().__init__()
        self._calibration = calibration
        self._theme = theme
        self.project, self.recordings = builders.ElidedLabel(), builders.ElidedLabel()
        self.open = builders.spoken_button(
            tr("Folder"), tr("Choose the takes folder, write label files, or remove deleted takes")
        )
        self.stop = builders.spoken_button("✕", tr("Stop opening this folder; the takes of the last one stay"))
        self.add = builders.spoken_button(
            tr("Load"), tr("Load labelled recordings: TextGrid, Audacity labels or CSV")
        )
        self.clear = builders.spoken_button("✕", tr("Unload all labelled recordings; their files are kept"))
        self.speaker = builders.named(
            QLineEdit(calibration.takes.speaker), tr("Speaker"), tr("Speaker of the takes recorded from now on")
        )
        self.guide = builders.spoken_button(
            tr("Guided Calibration…"), tr("Calibrate to your voice step by step, in under a minute (G)")
        )
        self.room = builders.spoken_button(
            tr("Measure Noise"),
            tr("Measure the background noise for two seconds; sets silence and denoising for every recogniser"),
        )
        self.record = RecordPanel(calibration, theme)
        self.list = TakeListView(calibration.takes, theme)
        self.wave = TakeWaveform(calibration.takes, theme)
        self.play = builders.spoken_button(
            tr("Play"), tr("Play the trimmed part of the take (Return or double-click)")
        )
        self.exclude = builders.spoken_button(
            tr("Exclude"), tr("Exclude the selected takes from calibration, or include them again (X)")
        )
        self.delete = builders.spoken_button(
            tr("Delete", "verb"), tr("Delete the selected takes (Delete); Ctrl+Z restores them")
        )
        self.phoneme = builders.choice(
            ((sound_name(phoneme), phoneme) for phoneme in KEYS),
            tr("Phoneme of the take"),
            tr("Phoneme of the selected take; choose another to relabel it"),
        )
        self._fill()
        self._lay_out()
        self._connect()
        self._show_project()
        self._show_recordings()
        self._show_take()

    def _fill(self) -> None:
        self._add_menu(
            self.add,
            (tr("Folder of Labelled Recordings…"), lambda: self.import_asked.emit(True)),
            (tr("Audio Files with Label Files…"), lambda: self.import_asked.emit(False)),
        )
        write = self._calibration.takes.write_labels
        self._add_menu(
            self.open,
            (tr("Choose Folder…"), self.project_asked.emit),
            (tr("Write Labels for Praat (TextGrid)"), lambda: write(".TextGrid", "Praat")),
            (tr("Write Labels for Audacity (TXT)"), lambda: write(".txt", "Audacity")),
            (tr("Remove Deleted Takes…"), self.empty_asked.emit),
        )
        self.guide.setSizePolicy(self.record.sizePolicy())
        for button in (self.guide, self.room):
            button.setMinimumHeight(28)
        self.guide.setStyleSheet(
            f"QToolButton {{ color: {self._theme.on_colour}; background: {self._theme.accent}; border: 0;"
            " border-radius: 4px; font-weight: bold }"
            f"QToolButton:disabled {{ background: {self._theme.line} }}"
        )

    def _add_menu(self, button: QToolButton, *entries: tuple[str, Callable[[], object]]) -> None:
        menu = QMenu(button)
        for text, act in entries:
            menu.addAction(text, act)
        builders.open_at_once(button, menu)

    def _lay_out(self) -> None:
        lines = (
            builders.row(builders.label(tr("<b>Takes</b>")), (self.project, 1), self.stop, self.open, spacing=5),
            builders.row(builders.label(tr("Speaker")), self.speaker, spacing=5),
            builders.row(self.guide, self.room, spacing=5),
            self.record,
            (self.list, 1),
            self.wave,
            builders.row(self.play, (self.phoneme, 1), self.exclude, self.delete, spacing=5),
            builders.row(
                builders.label(tr("<b>Recordings</b>")), (self.recordings, 1), self.clear, self.add, spacing=5
            ),
        )
        builders.column(*lines, on=self, margins=(8, 6, 6, 6), spacing=5)
        self.setFixedWidth(WIDTH)

    def _connect(self) -> None:
        takes = self._calibration.takes
        self.stop.clicked.connect(lambda _checked=False: takes.cancel_opening())
        self.clear.clicked.connect(self._calibration.recordings.clear)
        self.guide.clicked.connect(self.guide_asked)
        self.room.clicked.connect(lambda _checked=False: self._calibration.measure_room())
        self._calibration.room.changed.connect(self._show_room)
        key = QShortcut(QKeySequence("G"), self)
        key.setAutoRepeat(False)
        key.activated.connect(self.guide.click)
        self.speaker.textEdited.connect(self._name_speaker)
        self.speaker.returnPressed.connect(self.list.setFocus)
        self.list.play_asked.connect(self._calibration.play_take)
        self.list.delete_asked.connect(lambda: takes.delete(self.list.all_chosen))
        self.list.exclude_asked.connect(self._toggle_excluded)
        self.play.clicked.connect(self.list.play)
        self.delete.clicked.connect(lambda: takes.delete(self.list.all_chosen))
        self.exclude.clicked.connect(self._toggle_excluded)
        self.phoneme.activated.connect(self._relabel)
        self.wave.trimmed.connect(self._trim)
        takes.opened.connect(self._show_project)
        takes.opening_changed.connect(self._show_project)
        takes.changed.connect(self._show_take)
        takes.sound_read.connect(self._show_take)
        self._calibration.recordings.changed.connect(self._show_recordings)
        self._calibration.recordings.progressed.connect(self._show_recordings)

    def _name_speaker(self, name: str) -> None:
        self._calibration.takes.speaker = name

    def _toggle_excluded(self) -> None:
        """Exclude the chosen takes, or include them where the first of them is excluded."""
        takes, number = self._calibration.takes, self.list.chosen
        take = takes.take(number) if number is not None else None
        if take is not None:
            takes.set_excluded(self.list.all_chosen, not take.excluded)

    def _relabel(self, index: int) -> None:
        number = self.list.chosen
        if number is not None:
            self._calibration.takes.relabel(number, self.phoneme.itemData(index))

    def _trim(self, start: float, end: float) -> None:
        if self.list.chosen is not None:
            self._calibration.takes.trim(self.list.chosen, start, end)

    def _show_project(self) -> None:
        folder, opening = self._calibration.takes.folder, self._calibration.takes.opening
        self.stop.setVisible(opening is not None)
        if opening is not None:
            self.project.setText(tr("Opening… {percent:.0f} %").format(percent=100 * opening))
        else:
            self.project.setText(_short(folder) if folder else tr("Created with the first take"))
        self.project.setToolTip(str(folder) if folder else tr("Folder in which takes are saved"))

    def _show_recordings(self) -> None:
        recordings = self._calibration.recordings
        n, speakers = len(recordings.utterances), recordings.n_speakers
        text = (
            tr("Loading… {percent:.0f} %").format(percent=100 * recordings.progress)
            if recordings.busy
            else (
                (tr("{n} from {speakers} speakers") if speakers > 1 else tr("{n} from 1 speaker")).format(
                    n=n, speakers=speakers
                )
                if n
                else tr("None loaded")
            )
        )
        self.recordings.setText(text)
        self.recordings.setToolTip(
            "\n".join(map(str, recordings.sources)) or tr("Labelled recordings used in addition to the takes")
        )
        self.clear.setEnabled(n > 0 or recordings.busy)

    def _show_room(self) -> None:
        self.room.setText(tr("Keep quiet…") if self._calibration.room.listening else tr("Measure Noise"))

    def _show_take(self) -> None:
        takes = self._calibration.takes
        take = takes.take(takes.selected) if takes.selected is not None else None
        for widget in (self.play, self.exclude, self.delete, self.phoneme):
            widget.setEnabled(take is not None)
        self.exclude.setText(tr("Include") if take is not None and take.excluded else tr("Exclude"))
        if take is not None:
            with builders.silent(self.phoneme):
                self.phoneme.setCurrentIndex(self.phoneme.findData(take.phoneme))


def _short(folder: Path) -> str:
    return f"{folder.parent.name}/{folder.name}" if folder.parent.name else str(folder)
