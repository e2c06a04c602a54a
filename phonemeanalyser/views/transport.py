"""Play, stop, the time line, loop, volume and channel."""

from typing import Any

from PySide6.QtCore import QRectF, QSignalBlocker, QSize, Qt, Signal
from PySide6.QtGui import QColor, QIcon, QKeyEvent, QMouseEvent, QPainter
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QLabel, QSizePolicy, QSlider, QStyle, QToolButton, QWidget

from engine.settings import Channel
from phonemeanalyser.models.session import QUIETEST_DB, Session
from phonemeanalyser.theme import Theme


class TimeLine(QWidget):
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
        self.setMinimumSize(120, 30)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setToolTip("Click to go there; arrow keys go by a second")
        self.setAccessibleName("time line")

    def refresh(self) -> None:
        """Show where the sound is."""
        shown = round(self._x_of(self._session.position))
        if shown != self._shown:
            self._shown = shown
            self.update()

    def paintEvent(self, _event: Any) -> None:
        """Paint the track, what has been heard, marks of time, and the place."""
        painter = QPainter(self)
        track = QRectF(6, 5, self.width() - 12, 9)
        painter.fillRect(track, QColor(self._theme.line))
        x = self._x_of(self._session.position)
        painter.fillRect(QRectF(6, 5, x - 6, 9), QColor(self._theme.accent))
        painter.fillRect(QRectF(x - 1.5, 1, 3, 17), QColor(self._theme.text))
        self._paint_marks(painter)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Go there."""
        self._seek(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Follow the mouse."""
        if event.buttons() & Qt.MouseButton.LeftButton:
            self._seek(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Go by a second."""
        steps = {Qt.Key.Key_Left: -1.0, Qt.Key.Key_Right: 1.0}
        if event.key() in steps:
            self.sought.emit(max(0.0, self._session.position + steps[Qt.Key(event.key())]))
        else:
            super().keyPressEvent(event)

    def _paint_marks(self, painter: QPainter) -> None:
        duration = self._session.duration
        if duration <= 0:
            return
        font = painter.font()
        font.setPixelSize(9)
        painter.setFont(font)
        painter.setPen(QColor(self._theme.faint))
        spacing = next((s for s in SPACINGS if duration / s * 46 < self.width() - 60), SPACINGS[-1])
        for k in range(int(duration / spacing) + 1):
            x = self._x_of(k * spacing)
            if x > self.width() - 24:
                break
            painter.fillRect(QRectF(x, 14, 1, 4), QColor(self._theme.faint))
            painter.drawText(QRectF(x + 2, 17, 50, 12), clock_of(k * spacing, spacing < 1))

    def _seek(self, event: QMouseEvent) -> None:
        share = min(max((event.position().x() - 6) / max(1, self.width() - 12), 0.0), 1.0)
        self.sought.emit(share * self._session.duration)

    def _x_of(self, seconds: float) -> float:
        return 6 + seconds / max(self._session.duration, 1e-6) * (self.width() - 12)


SPACINGS = (0.1, 0.2, 0.5, 1, 2, 5, 10, 30, 60, 120, 300, 600, 1200, 3600)


class Transport(QWidget):
    """The bar above the views.

    Signals
    -------
    open_asked : the user wants to open a file.
    """

    open_asked = Signal()

    def __init__(self, session: Session, theme: Theme) -> None:
        super().__init__()
        self._session = session
        self._theme = theme
        self.open = self._button(QStyle.StandardPixmap.SP_DialogOpenButton, "Open a sound file (Ctrl+O)")
        self.play = self._button(QStyle.StandardPixmap.SP_MediaPlay, "Play or pause (Space)")
        self.stop = self._button(QStyle.StandardPixmap.SP_MediaStop, "Stop and go to the beginning (Escape)")
        self.loop = self._button(QStyle.StandardPixmap.SP_BrowserReload, "Begin again at the end (L)")
        self.time_line = TimeLine(session, theme)
        self.time = QLabel()
        self.volume = QSlider(Qt.Orientation.Horizontal)
        self.channel = QComboBox()
        self._lay_out()
        self._connect()
        self._show_state()

    def refresh(self) -> None:
        """Show where the sound is."""
        self.time_line.refresh()
        text = f"{clock_of(self._session.position, True)} / {clock_of(self._session.duration, True)}"
        if text != self.time.text():
            self.time.setText(text)

    def _button(self, icon: QStyle.StandardPixmap, tip: str) -> QToolButton:
        button = QToolButton()
        button.setIcon(tinted_icon(self.style(), icon, self._theme))
        button.setIconSize(QSize(20, 20))
        button.setToolTip(tip)
        button.setAccessibleName(tip)
        button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        return button

    def _lay_out(self) -> None:
        self.loop.setCheckable(True)
        self.volume.setRange(int(QUIETEST_DB), 0)
        self.volume.setFixedWidth(90)
        for channel in Channel:
            self.channel.addItem(channel.value, channel)
        self.channel.setToolTip("Which channel of a stereo file is analysed")
        self.time.setMinimumWidth(120)
        self.time.setAlignment(Qt.AlignmentFlag.AlignCenter)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(6, 3, 6, 3)
        layout.setSpacing(6)
        buttons = (self.open, self.play, self.stop, self.loop)
        others = (self.time, QLabel("volume"), self.volume, QLabel("channel"), self.channel)
        row: tuple[QWidget, ...] = (*buttons, self.time_line, *others)
        for widget in row:
            layout.addWidget(widget, 1 if widget is self.time_line else 0)

    def _connect(self) -> None:
        self.open.clicked.connect(self.open_asked)
        self.play.clicked.connect(self._session.toggle)
        self.stop.clicked.connect(self._session.stop)
        self.loop.toggled.connect(self._session.set_loop)
        self.time_line.sought.connect(self._session.seek)
        self.volume.valueChanged.connect(self._session.set_volume)
        self.channel.activated.connect(lambda k: self._session.set_channel(Channel(self.channel.itemData(k))))
        self._session.transport_changed.connect(self._show_state)

    def _show_state(self) -> None:
        session = self._session
        icon = QStyle.StandardPixmap.SP_MediaPause if session.playing else QStyle.StandardPixmap.SP_MediaPlay
        self.play.setIcon(tinted_icon(self.style(), icon, self._theme))
        self.volume.setToolTip(f"Volume {session.volume:.0f} dB" if session.volume > QUIETEST_DB else "Silent")
        with QSignalBlocker(self.volume), QSignalBlocker(self.loop):
            self.volume.setValue(round(session.volume))
            self.loop.setChecked(session.loop)
        self.channel.setCurrentText(session.channel.value)
        controls: tuple[QWidget, ...] = (self.play, self.stop, self.time_line)
        for widget in controls:
            widget.setEnabled(session.path is not None)
        self.time_line.update()
        self.refresh()


def clock_of(seconds: float, fine: bool) -> str:
    """Write seconds as 1:02:03.4, without hours where there are none."""
    minutes, rest = divmod(seconds, 60)
    hours, minutes = divmod(int(minutes), 60)
    tail = f"{int(rest * 10) / 10:04.1f}" if fine else f"{int(rest):02d}"
    return f"{hours}:{minutes:02d}:{tail}" if hours else f"{minutes}:{tail}"


def tinted_icon(style: QStyle, icon: QStyle.StandardPixmap, theme: Theme) -> QIcon:
    """Give a standard icon in the theme's text colour."""
    pixmap = style.standardIcon(icon).pixmap(20, 20)
    painter = QPainter(pixmap)
    painter.setCompositionMode(QPainter.CompositionMode.CompositionMode_SourceIn)
    painter.fillRect(pixmap.rect(), QColor(theme.text))
    painter.end()
    return QIcon(pixmap)
