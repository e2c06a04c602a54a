"""The commands of the menus, as tables: text, key, and what is done."""

from collections.abc import Callable
from functools import partial

from phonemeanalyser.desktop.analyse.page import AnalysisPage
from phonemeanalyser.desktop.dialogs import Dialogs
from phonemeanalyser.desktop.menus import Command
from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeanalyser.desktop.session.session import Session

Commands = tuple[Command, ...]
PRESET_COMMANDS = ("Load Preset…", "Save Preset", "Save Preset As…", "Preset Notes…")
PAGES = ("Analyse", "Calibrate", "Talk")


def file_commands(dialogs: Dialogs) -> Commands:
    """Return what opens and saves files."""
    return (
        Command("Open Sound…", "Ctrl+O", dialogs.ask_sound),
        Command("Save the Phonemes…", "Ctrl+E", dialogs.ask_save_phonemes),
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
        Command("Louder", "Ctrl+Up", lambda: session.set_volume(session.volume + 3)),
        Command("Quieter", "Ctrl+Down", lambda: session.set_volume(session.volume - 3)),
    )


def record_commands(session: Session, dialogs: Dialogs) -> Commands:
    """Return what belongs to the microphone."""
    return (
        Command("Record", "R", session.toggle_recording),
        Command("Recordings Folder…", "", dialogs.ask_recordings_folder),
        Command("Look for Microphones", "F5", session.microphone.refresh_devices),
    )


def analysis_commands(session: Session, preset: PresetModel, dialogs: Dialogs) -> Commands:
    """Return what belongs to filters and results."""
    return (
        Command("Bypass All Filters", "B", preset.set_bypassed, checkable=True),
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
