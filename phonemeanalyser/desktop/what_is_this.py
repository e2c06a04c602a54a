"""*What Is This?* (Shift+F1): a click on anything in the window tells what it is, in the words of the manual."""

from PySide6.QtCore import QEvent, QObject, Signal
from PySide6.QtGui import QHelpEvent, QTextDocument, QWhatsThisClickedEvent
from PySide6.QtWidgets import QAbstractButton, QApplication, QLabel, QWhatsThis, QWidget
from typing_extensions import override

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.manual import passage

PASSAGES = {
    "Transport": ("manual", "Playback"),
    "PositionSlider": ("manual", "#The whole file"),
    "OutputButton": ("manual", "Playback"),
    "StateChips": ("manual", "Chips"),
    "MicrophoneBar": ("manual", "Device, channel, rate and level"),
    "RecordButton": ("manual", "Record"),
    "ToneBar": ("manual", "Tone"),
    "PresetBox": ("manual", "Presets"),
    "FilterColumn": ("manual", "Filters"),
    "LookAheadSlider": ("manual", "Look-ahead"),
    "AveragedView": ("manual", "Averaged spectra"),
    "CurvePanel": ("manual", "Averaged spectra"),
    "SpectrumView": ("manual", "Spectrum"),
    "WaveformView": ("manual", "Spectrum"),
    "ScrollView": ("manual", "Spectrum"),
    "FilePanel": ("manual", "#The whole file"),
    "PhonemeView": ("manual", "Phoneme"),
    "ScoreStrip": ("calibrating", "#The score on Analyse"),
    "RecogniserChoice": ("manual", "Phoneme"),
    "VariablePanel": ("manual", "Variable"),
    "ThresholdView": ("manual", "Thresholds"),
    "RuleEditor": ("manual", "Rules"),
    "DockTabs": ("manual", "Pages"),
    "PhonemeDataPanel": ("calibrating", "#The 21 numbers of PhonemeData"),
    "RulesPanel": ("calibrating", "#Rules found in labelled sound"),
    "PageSwitch": ("manual", "Pages"),
    "QStatusBar": ("manual", "The status line"),
    "GuideView": ("calibrating", "Guided calibration"),
    "TakesPanel": ("calibrating", "Takes"),
    "VariablesPanel": ("calibrating", "Distributions"),
    "DistributionView": ("calibrating", "Distributions"),
    "ConfusionView": ("calibrating", "Confusion matrix"),
    "SegmentList": ("calibrating", "Confusion matrix"),
    "FitPanel": ("calibrating", "Fit"),
    "ComparePanel": ("calibrating", "Compare"),
    "WorkbenchView": ("calibrating", "Recordings"),
    "HeadView": ("manual", "The head"),
    "VisemePanel": ("manual", "Mouth shapes"),
    "MovestateBars": ("manual", "Mouth shapes"),
    "ChoicesPanel": ("manual", "Mouth table"),
    "TransitionTimesView": ("manual", "Mouth table"),
    "ExpressionPanel": ("manual", "Expression"),
    "OscPanel": ("manual", "Other programs"),
    "SpeechTimeline": ("manual", "The timeline"),
    "KeyLanes": ("manual", "Keys"),
    "VoicePanel": ("manual", "Voice & Face…"),
    "VoiceButton": ("manual", "Voice & Face…"),
    "TextPanel": ("manual", "Align"),
    "TalkPage": ("manual", "The head"),
}
"""Page and term of the manual for what lies in a widget, by the name of its class or its own; the innermost wins."""


class WhatIsThis(QObject):
    """Answers for all widgets of a window.

    Signals
    -------
    page_asked : the user wants to read on, on this page of the manual.
    """

    page_asked = Signal(str)

    def __init__(self, window: QWidget) -> None:
        super().__init__(window)
        self._window = window

    def begin(self) -> None:
        """Have the next click ask."""
        app = QApplication.instance()
        assert app is not None
        app.installEventFilter(self)  # not before: each event of the program goes through it
        QWhatsThis.enterWhatsThisMode()

    @override
    def eventFilter(self, asked: QObject, event: QEvent) -> bool:
        """Answer what Qt asks while the pointer has a question mark."""
        kinds = QEvent.Type
        if event.type() not in {kinds.QueryWhatsThis, kinds.WhatsThis, kinds.WhatsThisClicked}:
            return False
        if not isinstance(asked, QWidget) or asked.window() is not self._window:
            return False
        if event.type() == kinds.QueryWhatsThis:
            event.setAccepted(bool(explanation_of(asked)))
        elif isinstance(event, QWhatsThisClickedEvent):
            self.page_asked.emit(event.href())
        elif isinstance(event, QHelpEvent):
            QWhatsThis.showText(event.globalPos(), explanation_of(asked), asked)
        return True


def explanation_of(widget: QWidget) -> str:
    """Return what a widget is, as HTML: its name, its tool tip, and what the manual says; empty for nothing."""
    found = passage_for(widget)
    name, tip = name_of(widget), _tip_of(widget)
    if found is None and not tip:
        return ""
    parts = [f"<b>{name}</b>"] if name else []
    parts += [f"<p>{tip}</p>"] if tip and tip != name else []
    if found is not None:
        document = QTextDocument()
        document.setMarkdown(passage(*found))
        words = document.toHtml()
        parts.append(words[words.index("<body") :].removesuffix("</body></html>"))
        parts.append(f'<p><a href="{found[0]}.md">{tr("More in the manual")}</a></p>')
    return "".join(parts)


def passage_for(widget: QWidget) -> tuple[str, str] | None:
    """Return page and term of the manual for a widget: those of the innermost part of the window that has any."""
    asked: QWidget | None = widget
    while asked is not None:
        for name in (asked.objectName(), *(kind.__name__ for kind in type(asked).__mro__)):
            if name in PASSAGES:
                return PASSAGES[name]
        asked = asked.parentWidget()
    return None


def name_of(widget: QWidget) -> str:
    """Return what a widget is called: its accessible name, or what is written on it."""
    if widget.accessibleName():
        return widget.accessibleName()
    return widget.text() if isinstance(widget, QAbstractButton | QLabel) else ""


def _tip_of(widget: QWidget) -> str:
    """Return the tool tip of a widget, or of what it lies in."""
    asked: QWidget | None = widget
    while asked is not None and not asked.isWindow():
        if asked.toolTip():
            return asked.toolTip()
        asked = asked.parentWidget()
    return ""
