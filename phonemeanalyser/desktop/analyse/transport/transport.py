"""The bar above the views: source, play, stop, record, loop, what is played on, and what belongs to the source."""

from functools import partial
from typing import Any

import numpy as np
from PySide6 import QtWidgets
from PySide6.QtCore import QRectF, QSize, Qt, Signal
from PySide6.QtGui import QActionGroup, QColor, QIcon, QImage, QKeyEvent, QKeySequence, QMouseEvent, QPainter
from typing_extensions import override

from phonemeanalyser.desktop.analyse.transport.source_bars import MicrophoneBar, RecordButton, ToneBar
from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.session.sources import QUIETEST_DB, Playback, SourceKind
from phonemeanalyser.desktop.theme import PHONEME_COLOURS, Theme, format_clock, set_size
from phonemeanalyser.desktop.widgets import builders
from phonemeanalyser.desktop.widgets.pages import PageStack
from phonemeengine.arrays import UInt8Array, UInt32Array
from phonemeengine.inspection.whole_sound import FrameState, SoundTracks
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import HOP, Channel

SPACINGS = (0.1, 0.2, 0.5, 1, 2, 5, 10, 30, 60, 120, 300, 600, 1200, 3600)
"""Between two marks of time, seconds."""
MARGIN = 6
"""Pixels beside the line."""
WAVE_HEIGHT, BAR_HEIGHT = 15, 3
LOUDEST = 0.05
"""A sound that is nowhere louder than this is drawn as soft as it is."""
NOTHING = len(Phoneme)
"""The code of a column of which no phoneme is known."""


class PositionSlider(QtWidgets.QWidget):
    """The whole file as a line; a click or a drag goes there.

    Signals
    -------
    sought : seconds from the file's beginning.
    """

    sought = Signal(float)

    def __init__(self, session: Session, theme: Theme) -> None:
        super().__init__()
        self._session = session
        self._theme = theme
        self._shown = -1
        self._overview: tuple[tuple[int, int, int], QImage] | None = None
        colours = [*(PHONEME_COLOURS[p] for p in Phoneme), theme.faint]
        self._pixels = np.array([QColor(colour).rgb() for colour in colours], np.uint32)
        self.setMinimumSize(120, 30)
        self.setSizePolicy(QtWidgets.QSizePolicy.Policy.Expanding, QtWidgets.QSizePolicy.Policy.Fixed)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setToolTip(
            tr(
                "Waveform of the whole file in the colours of its phonemes (grey: not analysed yet). Click to go "
                "to that time; arrow keys move by 1 s"
            )
        )
        self.setAccessibleName(tr("Timeline"))
        session.whole.changed.connect(self.update)

    def refresh(self) -> None:
        """Show where the sound is."""
        shown = round(self._x_of(self._session.source.position))
        if shown != self._shown:
            self._shown = shown
            self.update()

    @override
    def paintEvent(self, _event: Any) -> None:
        painter = QPainter(self)
        try:
            self._paint(painter)
        finally:
            painter.end()  # whatever went wrong: Qt crashes where two paint one widget

    def _paint(self, painter: QPainter) -> None:
        width = self.width() - 2 * MARGIN
        tracks = self._session.whole.tracks
        if tracks is not None and width > 0:
            painter.drawImage(MARGIN, 0, self._overview_of(tracks, width))
        painter.fillRect(QRectF(MARGIN, WAVE_HEIGHT, width, BAR_HEIGHT), QColor(self._theme.line))
        x = self._x_of(self._session.source.position)
        painter.fillRect(QRectF(MARGIN, WAVE_HEIGHT, x - MARGIN, BAR_HEIGHT), QColor(self._theme.accent))
        painter.fillRect(QRectF(x - 1, 0, 2, WAVE_HEIGHT + BAR_HEIGHT), QColor(self._theme.text))
        self._paint_marks(painter)

    @override
    def mousePressEvent(self, event: QMouseEvent) -> None:
        self._seek(event)

    @override
    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if event.buttons() & Qt.MouseButton.LeftButton:
            self._seek(event)

    @override
    def keyPressEvent(self, event: QKeyEvent) -> None:
        steps = {Qt.Key.Key_Left: -1.0, Qt.Key.Key_Right: 1.0}
        if event.key() in steps:
            self.sought.emit(max(0.0, self._session.source.position + steps[Qt.Key(event.key())]))
        else:
            super().keyPressEvent(event)

    def _overview_of(self, tracks: SoundTracks, width: int) -> QImage:
        """Return the picture of what is known, which is painted anew only when that changed."""
        key = (id(tracks), tracks.revision, width)
        if self._overview is None or self._overview[0] != key:
            pixels = overview_pixels(tracks, width, self._pixels, np.uint32(QColor(self._theme.window).rgb()))
            image = QImage(pixels.data, width, WAVE_HEIGHT, 4 * width, QImage.Format.Format_RGB32).copy()
            self._overview = key, image
        return self._overview[1]

    def _paint_marks(self, painter: QPainter) -> None:
        duration = self._session.source.duration
        if duration <= 0:
            return
        set_size(painter, 9)
        painter.setPen(QColor(self._theme.faint))
        spacing = next((s for s in SPACINGS if duration / s * 46 < self.width() - 60), SPACINGS[-1])
        for k in range(int(duration / spacing) + 1):
            x = self._x_of(k * spacing)
            if x > self.width() - 24:
                break
            painter.fillRect(QRectF(x, WAVE_HEIGHT, 1, BAR_HEIGHT + 2), QColor(self._theme.faint))
            painter.drawText(QRectF(x + 2, 18, 50, 12), format_clock(k * spacing, spacing < 1))

    def _seek(self, event: QMouseEvent) -> None:
        share = min(max((event.position().x() - MARGIN) / max(1, self.width() - 2 * MARGIN), 0.0), 1.0)
        self.sought.emit(share * self._session.source.duration)

    def _x_of(self, seconds: float) -> float:
        return MARGIN + seconds / max(self._session.source.duration, 1e-6) * (self.width() - 2 * MARGIN)


def overview_pixels(tracks: SoundTracks, width: int, colours: UInt32Array, nothing: np.uint32) -> UInt32Array:
    """Return the waveform of a whole sound in the colours of its phonemes, RGB, shape (WAVE_HEIGHT, width)."""
    peaks = tracks.peaks.between(0, tracks.n_frames * HOP, width)
    loudest = max(LOUDEST, float(np.nanmax([np.abs(peaks.low), np.abs(peaks.high), np.zeros(width)])))
    middle = (WAVE_HEIGHT - 1) / 2
    high, low = (np.nan_to_num(middle - values / loudest * middle, nan=-1.0) for values in (peaks.high, peaks.low))
    rows = np.arange(WAVE_HEIGHT)[:, np.newaxis]
    inside = (rows >= np.round(high)) & (rows <= np.round(low)) & ~np.isnan(peaks.low)
    return np.where(inside, colours[main_phonemes(tracks, width)], nothing).astype(np.uint32)


def main_phonemes(tracks: SoundTracks, width: int) -> UInt8Array:
    """Return the phoneme that most frames of each column have, shape (width,); of speech, where there is any."""
    columns = np.arange(tracks.n_frames) * width // max(1, tracks.n_frames)
    codes = np.where(tracks.states == FrameState.UNKNOWN, NOTHING, tracks.phonemes)
    counts = np.bincount(columns * (NOTHING + 1) + codes, minlength=width * (NOTHING + 1)).reshape(width, -1)
    spoken = counts.copy()
    spoken[:, [Phoneme.SILENCE, NOTHING]] = 0
    found = np.where(spoken.any(axis=1), spoken.argmax(axis=1), counts.argmax(axis=1))
    return np.where(counts.any(axis=1), found, NOTHING).astype(np.uint8)


SPEEDS = (1.0, 0.85, 0.7, 0.5, 0.35, 0.25)
DEFAULT = tr_noop("System default")


class OutputButton(QtWidgets.QToolButton):
    """Says how loud it plays, in dB, and how fast where that is not as usual; its menu has devices and speeds."""

    def __init__(self, playback: Playback) -> None:
        super().__init__()
        self._playback = playback
        self._menu = QtWidgets.QMenu(self)
        builders.open_at_once(self, self._menu)
        builders.named(
            self, tr("Output device and speed"), tr("Playback volume in dB; click to choose output device and speed")
        )
        self._menu.aboutToShow.connect(playback.outputs.look)
        playback.outputs.changed.connect(self._fill)
        playback.changed.connect(self._show_state)
        self._fill()
        self._show_state()

    def _show_state(self) -> None:
        playback = self._playback
        volume = tr("muted") if playback.volume <= QUIETEST_DB else f"{playback.volume:.0f} dB".replace("-", "−")
        speed = "" if playback.speed == 1 else f", {100 * playback.speed:.0f} %"
        self.setText(f"♪ {volume}{speed}")
        for action in self._menu.actions():
            action.setChecked(action.data() in {playback.speed, playback.device})

    def _fill(self) -> None:
        playback = self._playback
        self._menu.clear()
        labels = {"": tr(DEFAULT)} | {device.label: device.label for device in playback.outputs.devices}
        labels.setdefault(playback.device, tr("{name} (not connected)").format(name=playback.device))
        devices, speeds = QActionGroup(self._menu), QActionGroup(self._menu)
        for label, text in labels.items():
            action = self._menu.addAction(text, partial(playback.choose_device, label))
            action.setCheckable(True)
            action.setData(label)
            devices.addAction(action)
        self._menu.addSeparator()
        for speed in SPEEDS:
            action = self._menu.addAction(
                tr("Speed {percent:.0f} %").format(percent=100 * speed), partial(playback.set_speed, speed)
            )
            action.setCheckable(True)
            action.setData(speed)
            speeds.addAction(action)
        self._show_state()


def next_speed(speed: float, speeds: tuple[float, ...]) -> float:
    """Return the speed after this one, in the order given; the last one stays."""
    nearest = min(range(len(speeds)), key=lambda k: abs(speeds[k] - speed))
    return speeds[min(nearest + 1, len(speeds) - 1)]


LEAST_TIME_WIDTH = 112
"""Of the time, pixels, so that a short one leaves the slider where it is."""


class Pages(PageStack):
    """Widgets of which one is seen, and needs room, while the height is that of all."""

    @override
    def minimumSizeHint(self) -> QSize:
        return QSize(super().minimumSizeHint().width(), QtWidgets.QStackedWidget.minimumSizeHint(self).height())


class Transport(builders.Rewrapped):
    """The bar above the views: where the sound comes from, what it does, and what belongs to its source.

    Signals
    -------
    open_asked : the user wants to open a file.
    folder_asked : the user wants to choose where recordings go.
    """

    open_asked = Signal()
    folder_asked = Signal()

    def __init__(self, session: Session, theme: Theme) -> None:
        super().__init__()
        self._session = session
        self._theme = theme
        pixmap = QtWidgets.QStyle.StandardPixmap
        self.open = self._button(pixmap.SP_DialogOpenButton, tr("Open an audio file (Ctrl+O)"))
        self.play = self._button(pixmap.SP_MediaPlay, tr("Play or pause (Space)"))
        self.stop = self._button(pixmap.SP_MediaStop, tr("Stop (Escape); a file returns to its start"))
        self.record = RecordButton(session, theme)
        self.loop = self._button(pixmap.SP_BrowserReload, tr("Loop playback (L)"))
        self.source = builders.choice(
            ((tr(source.value), source) for source in SourceKind),
            tr("Source"),
            tr("Source of the signal: file, microphone, tone or text"),
        )
        self.position_slider = PositionSlider(session, theme)
        self.microphone = MicrophoneBar(session.microphone, theme)
        self.tone = ToneBar(theme)
        self.tone.show_tone(session.playback.tone)
        self.pages = Pages()
        self.time = builders.named(
            builders.StillLabel(LEAST_TIME_WIDTH), tip=tr("Position and duration, in minutes and seconds")
        )
        self.output, self.channel_label = OutputButton(session.playback), QtWidgets.QLabel(tr("Channel"))
        self.volume = builders.named(QtWidgets.QSlider(Qt.Orientation.Horizontal), tr("Volume"))
        self.channel = builders.choice((), tr("Channel of the file"), tr("Channel of the file that is analysed"))
        self._wrapped_for: tuple[int, SourceKind] | None = None
        self._first = (self.source, self.open, self.play, self.stop, self.record, self.loop)
        self._last = (self.time, self.output, self.volume, self.channel_label, self.channel)
        self._lay_out()
        self._connect()
        self._show_state()

    def refresh(self) -> None:
        """Show where the sound is, and how loud the microphone."""
        session = self._session
        self.position_slider.refresh()
        if session.source.kind is SourceKind.MICROPHONE:
            self.microphone.refresh()
        text = format_clock(session.source.position, True)
        if not session.source.live:
            text += f" / {format_clock(session.source.duration, True)}"
        recording = session.microphone.recording
        if recording:
            sign = "●" if session.microphone.listening else tr("waiting")
            text = f"{sign} {format_clock(session.microphone.recorded_seconds, True)}"
        style = f"color: {self._theme.bad}; font-weight: bold" if recording else ""
        if style != self.time.styleSheet():
            self.time.setStyleSheet(style)
        self.time.setText(text)

    def _button(self, icon: QtWidgets.QStyle.StandardPixmap, tip: str) -> QtWidgets.QToolButton:
        button = builders.named(QtWidgets.QToolButton(), tip, tip)
        button.setIcon(tinted_icon(self.style(), icon, self._theme))
        button.setIconSize(QSize(20, 20))
        return button

    def _lay_out(self) -> None:
        self.loop.setCheckable(True)
        self.volume.setRange(int(QUIETEST_DB), 0)
        self.volume.setFixedWidth(80)
        self.channel.setSizeAdjustPolicy(QtWidgets.QComboBox.SizeAdjustPolicy.AdjustToContents)
        self.source.setSizePolicy(QtWidgets.QSizePolicy.Policy.Fixed, QtWidgets.QSizePolicy.Policy.Fixed)
        self.time.setAlignment(Qt.AlignmentFlag.AlignCenter)
        for page in (self.position_slider, self.microphone, self.tone):
            self.pages.addWidget(page)
        # What is over at the right is taken while the pages have a row of their own.
        self._row = builders.row(*self._first, (self.pages, 1), *self._last, 0, spacing=6)
        self._rows = builders.column(self._row, on=self, margins=(6, 3, 6, 3), spacing=3)

    @override
    def minimumSizeHint(self) -> QSize:
        """Ask for the width of the wider row, when what belongs to the source has one of its own."""
        width = max(self._width_of(*self._first, *self._last), self._width_of(self.pages))
        return QSize(width, super().minimumSizeHint().height())

    @override
    def wrap(self) -> None:
        """Give what belongs to the source a row of its own, where one lacks room, until width or source change."""
        wrapped_for = self.window().width(), self._session.source.kind
        wrapped = self.width() < self._width_of(*self._first, self.pages, *self._last)
        wrapped |= self._wrapped_for == wrapped_for
        self._wrapped_for = wrapped_for if wrapped else None
        if wrapped and self._rows.indexOf(self.pages) < 0:
            self._row.removeWidget(self.pages)
            self._rows.addWidget(self.pages)
        elif not wrapped and self._rows.indexOf(self.pages) >= 0:
            self._rows.removeWidget(self.pages)
            self._row.insertWidget(len(self._first), self.pages, 1)

    def _width_of(self, *widgets: QtWidgets.QWidget) -> int:
        seen = [w for w in widgets if not w.isHidden()]
        margins = self._rows.contentsMargins()
        needed = sum(max(w.minimumSizeHint().width(), w.minimumWidth()) for w in seen)
        return needed + (len(seen) - 1) * self._row.spacing() + margins.left() + margins.right()

    def _connect(self) -> None:
        session = self._session
        self.open.clicked.connect(self.open_asked)
        self.play.clicked.connect(session.toggle)
        self.stop.clicked.connect(session.stop)
        self.record.clicked.connect(session.toggle_recording)
        self.record.folder_asked.connect(self.folder_asked)
        self.loop.toggled.connect(session.playback.set_loop)
        self.source.activated.connect(lambda k: session.set_source(SourceKind(self.source.itemData(k))))
        self.position_slider.sought.connect(session.seek)
        self.tone.tone_changed.connect(session.playback.set_tone)
        self.volume.valueChanged.connect(session.playback.set_volume)
        self.channel.activated.connect(lambda k: session.set_channel(Channel(str(k))))
        session.transport_changed.connect(self._show_state)
        session.opened.connect(self._show_state)
        session.microphone.changed.connect(self._show_state)

    def _show_state(self) -> None:
        source, playback = self._session.source, self._session.playback
        icon = (
            QtWidgets.QStyle.StandardPixmap.SP_MediaPause
            if source.playing
            else QtWidgets.QStyle.StandardPixmap.SP_MediaPlay
        )
        self.play.setIcon(tinted_icon(self.style(), icon, self._theme))
        key = QKeySequence("Space").toString(QKeySequence.SequenceFormat.NativeText)
        tip = tr("Listen, or release the microphone") if source.kind is SourceKind.MICROPHONE else tr("Play or pause")
        self.play.setToolTip(f"{tip} ({key})")
        self.volume.setToolTip(
            tr("Playback volume {volume:.0f} dB").format(volume=playback.volume)
            if playback.volume > QUIETEST_DB
            else tr("Muted")
        )
        with builders.silent(self.volume, self.loop):
            self.volume.setValue(round(playback.volume))
            self.loop.setChecked(playback.loop)
        self._show_channels()
        self.source.setCurrentIndex(self.source.findData(source.kind))
        self.record.show_state()
        self._show_page()
        self.position_slider.update()
        self.refresh()

    def _show_channels(self) -> None:
        """Offer the channels of the file, and the mix of them where there are several."""
        file = self._session.file
        n = 2 if file is None else file.n_file_channels
        names = {1: [tr("Mono")], 2: [tr("Mix"), tr("Left"), tr("Right")]}
        texts = names.get(n) or [tr("Mix"), *(str(number) for number in range(1, n + 1))]
        if texts != [self.channel.itemText(k) for k in range(self.channel.count())]:
            self.channel.clear()
            self.channel.addItems(texts)
        self.channel.setCurrentIndex(self._session.channel.number if n > 1 else 0)
        self.channel.setEnabled(n > 1)

    def _show_page(self) -> None:
        """Show the controls of the source in use."""
        kind = self._session.source.kind
        pages: dict[SourceKind, QtWidgets.QWidget] = {
            SourceKind.MICROPHONE: self.microphone,
            SourceKind.TONE: self.tone,
        }
        self.pages.setCurrentWidget(pages.get(kind, self.position_slider))
        of_file: tuple[QtWidgets.QWidget, ...] = (self.loop, self.channel_label, self.channel)
        for widget in of_file:
            widget.setVisible(kind is SourceKind.FILE)
        for widget in (self.output, self.volume):
            widget.setVisible(kind is not SourceKind.MICROPHONE)
        needing_a_file: tuple[QtWidgets.QWidget, ...] = (self.play, self.stop, self.position_slider)
        for widget in needing_a_file:
            widget.setEnabled(kind is not SourceKind.FILE or self._session.path is not None)


def tinted_icon(style: QtWidgets.QStyle, icon: QtWidgets.QStyle.StandardPixmap, theme: Theme) -> QIcon:
    """Return a standard icon in the theme's text colour."""
    pixmap = style.standardIcon(icon).pixmap(20, 20)
    painter = QPainter(pixmap)
    painter.setCompositionMode(QPainter.CompositionMode.CompositionMode_SourceIn)
    painter.fillRect(pixmap.rect(), QColor(theme.text))
    painter.end()
    return QIcon(pixmap)
