"""The commands of the menus, as tables: text, key, and what is done."""

from collections.abc import Callable
from functools import partial

from phonemeanalyser.desktop.analyse.label_dialogs import LabelDialogs
from phonemeanalyser.desktop.analyse.output_button import SPEEDS, next_speed
from phonemeanalyser.desktop.analyse.page import AnalysisPage
from phonemeanalyser.desktop.analyse.selection_dialogs import SelectionDialogs
from phonemeanalyser.desktop.dialogs import Dialogs
from phonemeanalyser.desktop.menus import Command
from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeanalyser.desktop.session.selection import Selection
from phonemeanalyser.desktop.session.session import Session

Commands = tuple[Command, ...]
PRESET_COMMANDS = ("Load Preset…", "Save Preset", "Save Preset As…", "Preset Notes…")
PAGES = ("Analyse", "Calibrate", "Talk")


def file_commands(dialogs: Dialogs) -> Commands:
    """Return what opens and saves files."""
    return (
        Command("Open Sound…", "Ctrl+O", dialogs.ask_sound),
        Command("Save the Phonemes…", "Ctrl+E", dialogs.ask_save_phonemes),
        Command("Export…", "Ctrl+Shift+E", dialogs.show_export),
        Command("Load Preset…", "Ctrl+Shift+O", dialogs.ask_preset),
        Command("Save Preset", "Ctrl+S", dialogs.save),
        Command("Save Preset As…", "Ctrl+Shift+S", dialogs.save_as),
        Command("Preset Notes…", "Ctrl+N", dialogs.ask_notes),
        Command("Speech Encoder…", "", dialogs.show_encoder),
        Command("Load Curve…", "Ctrl+L", dialogs.ask_curves),
        Command("Save Curve…", "Ctrl+Shift+L", dialogs.ask_save_curve),
    )


def play_commands(session: Session) -> Commands:
    """Return what moves the sound in hand."""
    return (
        Command("Play or Pause", "Space", session.toggle),
        Command("Stop", "Escape", session.stop),
        Command("Loop", "L", session.set_loop, checkable=True),
        Command("Back 1 s", "Ctrl+Left", lambda: session.seek(session.position - 1)),
        Command("Forward 1 s", "Ctrl+Right", lambda: session.seek(session.position + 1)),
        Command("To the Beginning", "Home", lambda: session.seek(0)),
        Command("To the End", "End", lambda: session.seek(session.duration)),
        Command("Louder", "Ctrl+Up", lambda: session.set_volume(session.volume + 3)),
        Command("Slower", "Ctrl+Shift+Left", lambda: session.set_speed(next_speed(session.speed, SPEEDS))),
        Command("Faster", "Ctrl+Shift+Right", lambda: session.set_speed(next_speed(session.speed, SPEEDS[::-1]))),
        Command("Quieter", "Ctrl+Down", lambda: session.set_volume(session.volume - 3)),
    )


def selection_commands(selection: Selection, dialogs: SelectionDialogs) -> Commands:
    """Return what is done with the selected part of a file."""
    return (
        Command("Select All", "Ctrl+A", selection.select_all),
        Command("Zoom to the Whole File", "Shift+A", selection.show_all),
        Command("Play Selection", "Shift+Space", selection.play),
        Command("Loop Selection", "Shift+L", lambda: selection.play(loop=True)),
        Command("Zoom to Selection", "Shift+Z", selection.zoom),
        Command("Measure Selection", "Shift+M", selection.measure),
        Command("Average Its Spectrum", "", selection.average),
        Command("Copy Its Frames as a Table", "Ctrl+Shift+C", dialogs.copy_frames),
        Command("Save Selection as Sound…", "", dialogs.ask_save),
    )


def label_commands(labels: LabelDialogs) -> Commands:
    """Return what is done with the labels of a file."""
    return (
        Command("Next Error", "N", labels.next_error),
        Command("Previous Error", "Shift+N", partial(labels.next_error, back=True)),
        Command("Insert Label…", "Ctrl+I", labels.ask_insert),
        Command("Rename Label…", "F2", labels.ask_rename),
        Command("Delete Label", "Delete", labels.delete),
        Command("Tiers…", "", labels.ask_tiers),
        Command("Load Labels…", "", labels.ask_load),
        Command("Save Labels", "Ctrl+Alt+S", labels.save),
        Command("Save Labels As…", "", labels.ask_save_as),
    )


def record_commands(session: Session, dialogs: Dialogs) -> Commands:
    """Return what belongs to the microphone."""
    return (
        Command("Record", "R", session.toggle_recording),
        Command("Look Back", "Ctrl+B", session.look_back, checkable=True),
        Command("Recordings Folder…", "", dialogs.ask_recordings_folder),
        Command("Look for Microphones", "F5", session.microphone.refresh_devices),
    )


def analysis_commands(session: Session, preset: PresetModel, dialogs: Dialogs) -> Commands:
    """Return what belongs to filters and results."""
    return (
        Command("Bypass All Filters", "B", preset.set_bypassed, checkable=True),
        Command("Second Preset…", "", dialogs.ask_second_preset),
        Command("Keep This One as the Second", "", lambda: session.second.take(preset.preset)),
        Command("Hear with the Second", "X", session.second.switch, checkable=True),
        Command("Forget the Second", "", lambda: session.second.take(None)),
        Command("Clear", "C", session.clear),
        Command("Remove Variable…", "", dialogs.ask_remove_variable),
    )


def view_commands(show_page: Callable[[int], None], analysis: AnalysisPage) -> Commands:
    """Return what chooses what is seen, and how."""
    return (
        *(Command(name, f"Ctrl+{k + 1}", partial(show_page, k)) for k, name in enumerate(PAGES)),
        Command("Coarse Display", "Shift+C", analysis.set_coarse, checkable=True),
        Command("Spectra in dB", "D", analysis.set_decibels, checkable=True),
    )
