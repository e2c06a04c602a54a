"""The page of the analysis: spectra above, the waveform amid, the time view below, and the score at the bottom."""

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QAbstractButton, QComboBox, QSplitter, QStackedWidget, QWidget

from phonemeanalyser.desktop.analyse.lanes.file_view import FilePanel
from phonemeanalyser.desktop.analyse.lanes.score_strip import ScoreStrip
from phonemeanalyser.desktop.analyse.lanes.scroll_view import ScrollView
from phonemeanalyser.desktop.analyse.lanes.sonagram import SonagramChoices
from phonemeanalyser.desktop.analyse.recognition.phoneme_view import PhonemeView
from phonemeanalyser.desktop.analyse.recognition.rule_editor import RuleEditor
from phonemeanalyser.desktop.analyse.recognition.threshold_view import ThresholdView
from phonemeanalyser.desktop.analyse.recognition.variable_panel import VariablePanel
from phonemeanalyser.desktop.analyse.spectra.averaged_view import AveragedView
from phonemeanalyser.desktop.analyse.spectra.frame_views import SpectrumView, WaveformView
from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.session.courses import Courses
from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.session.sources import SourceKind
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.builders import column, line

NOTHING = tr_noop("Drop an audio file here, or press Ctrl+O to open one")


class AnalysisPage(QWidget):
    """Lays out what is drawn of the current sound.

    Signals
    -------
    picture_asked : the user wants to save a picture of a plot, of this name.

    Attributes
    ----------
    rows : the splitter between spectra, waveform and time view.
    spectra : the splitter between the two spectra.
    sonagram : what is chosen of the sonagram, of files and of live sound.
    courses : the variables whose courses are drawn.
    score : how right what is recognised is.
    phoneme, variable, thresholds, rules : what is drawn of it in docks beside the page.
    """

    picture_asked = Signal(QWidget, str)

    def __init__(self, session: Session, preset: PresetModel, theme: Theme) -> None:
        super().__init__()
        self._history, self._theme = session.history, theme
        tip = tr("Spectrum of the current window of 46.4 ms, after all active filters")
        self.spectrum = SpectrumView(tr_noop("Spectrum"), tip, theme)
        self.averaged = AveragedView(session.averages, session.curves, theme)
        self.waveform = WaveformView(theme)
        self._session = session
        self.courses = Courses(preset)
        self.sonagram = SonagramChoices(session, self)
        self.scroll_view = ScrollView(session, self.courses, self.sonagram, theme)
        self.file = FilePanel(session, self.courses, self.sonagram, theme)
        self.over_time = QStackedWidget()
        self.phoneme = PhonemeView(session, theme)
        self.thresholds = ThresholdView(preset, session.history, theme)
        self.thresholds.touched.connect(self.courses.touch)
        self.variable = VariablePanel(session, preset, self.courses, theme)
        self.rows, self.spectra = QSplitter(Qt.Orientation.Vertical), QSplitter(Qt.Orientation.Horizontal)
        self.score = ScoreStrip(session, theme)
        self.rules = RuleEditor(session.rules, theme)
        self._lay_out()
        plots = (
            self.spectrum,
            self.averaged,
            self.waveform,
            self.scroll_view,
            self.phoneme,
            self.variable.distribution,
        )
        for view in plots:
            view.menu.save_asked.connect(self.picture_asked)

    def refresh_fast(self) -> None:
        """Draw what changes with every picture; a phoneme at once, when it is another one."""
        if self.phoneme.is_outdated:
            self.phoneme.refresh()
        newest = self._history.newest
        if newest is not None:
            self.spectrum.draw(newest.linear_spectra[-1])
            self.waveform.draw(newest.waveforms[-1])
        else:
            self.spectrum.clear()
            self.waveform.clear()
        self.scroll_view.refresh()
        self.file.refresh()

    def refresh_slow(self) -> None:
        """Draw numbers, and what changes slowly."""
        self.averaged.refresh()
        self.phoneme.refresh()
        self.thresholds.refresh()
        self.variable.refresh()
        self.rules.refresh(self.phoneme.trace)

    def set_coarse(self, on: bool) -> None:
        """Draw everything coarsely, or all of it finely."""
        for view in (self.spectrum, self.averaged, self.waveform):
            view.coarse.setChecked(on)

    def set_decibels(self, on: bool) -> None:
        """Draw both spectra in decibels, or linearly."""
        for view in (self.spectrum, self.averaged):
            view.decibels.setChecked(on)

    @property
    def main_view(self) -> QWidget:
        """What has the focus when the page is entered: the file over time, or the whole page."""
        return self.file.view if self.over_time.currentWidget() is self.file else self

    @property
    def splitters(self) -> dict[str, QSplitter]:
        """What the user may have moved, by the names under which it is kept."""
        return {"rows": self.rows, "spectra": self.spectra}

    @property
    def switches(self) -> dict[str, QAbstractButton | QAction]:
        """What the user may have switched, by the names under which it is kept."""
        return {
            "score": self.score.shown,
            "file_follow": self.file.follow,
            "sonagram_filtered": self.sonagram.filtered,
            **{f"sonagram_{name}": action for name, action in self.sonagram.overlays.items()},
            "coarse_spectrum": self.spectrum.coarse,
            "coarse_average": self.averaged.coarse,
            "coarse_waveform": self.waveform.coarse,
            "auto_waveform": self.waveform.auto,
            "spectrum_db": self.spectrum.decibels,
            "average_db": self.averaged.decibels,
            "average_spread": self.averaged.spread,
        }

    @property
    def choices(self) -> dict[str, QComboBox]:
        """What the user may have chosen, by the names under which it is kept."""
        return {
            "sonagram_axis": self.sonagram.axis,
            "sonagram_top": self.sonagram.top,
            "sonagram_window": self.sonagram.window_length,
            "sonagram_colours": self.sonagram.colours,
            "score_scope": self.score.scope,
        }

    def _show_source(self) -> None:
        """Show a file on its own time, and live sound as it scrolls by."""
        self.scroll_view.back.setVisible(self._session.source.kind is SourceKind.MICROPHONE)
        is_file = self._session.source.path is not None
        self.over_time.setCurrentWidget(self.file if is_file or self._session.seen.looks_back else self.scroll_view)
        if self.hasFocus():
            self.main_view.setFocus()

    def invite(self) -> None:
        """Say what the user may do with the source in use while nothing is seen over time."""
        source = self._session.source
        nothing = source.kind is SourceKind.FILE and not self._session.path
        self.scroll_view.invite(tr(NOTHING if nothing else source.hint))

    def _lay_out(self) -> None:
        self.spectra.addWidget(self.spectrum)
        self.spectra.addWidget(self.averaged)
        self.spectra.setSizes([270, 470])
        self.over_time.addWidget(self.file)
        self.over_time.addWidget(self.scroll_view)
        for widget in (self.spectra, self.waveform, self.over_time):
            self.rows.addWidget(widget)
        column((self.rows, 1), line(self._theme.line), self.score, on=self, spacing=0)
        self._session.opened.connect(self._show_source)
        self._session.seen.looked_back.connect(self._show_source)
        self.scroll_view.back.clicked.connect(lambda _checked: self._session.look_back(True))
        self.over_time.setMinimumWidth(460)
        self._show_source()
        self.rows.setSizes([190, 130, 370])
        for splitter in (self.spectra, self.rows):
            splitter.setChildrenCollapsible(False)
