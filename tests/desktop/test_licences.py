"""The licences of all parts: on the command line and in the window the same text."""

from phonemeanalyser.cli.main import main
from phonemeanalyser.licences import licences_text, parts


def test_every_part_that_users_get_names_its_licence():
    named = {part.name: part for part in parts()}
    assert next(iter(named)) == "phonemeanalyser"
    assert {"numpy", "PySide6_Essentials", "soundfile", "espeakng-loader", "av"} <= set(named)
    assert not {"pytest", "mypy", "ruff"} & set(named), "what makes the program is no part of it"
    assert [name for name, part in named.items() if part.licence == "?" and not part.libraries] == []


def test_the_licences_are_there_whole():
    text = licences_text()
    assert "Permission is hereby granted, free of charge" in text
    assert "GNU LESSER GENERAL PUBLIC LICENSE" in text
    assert "GNU GENERAL PUBLIC LICENSE" in text
    assert text.count("```") % 2 == 0


def test_the_command_line_prints_what_the_window_shows(desktop, qtbot, capsys):
    from PySide6.QtGui import QTextDocument
    from PySide6.QtWidgets import QTextBrowser

    from phonemeanalyser.desktop.help import LicencesDialog

    assert main(["--licences"]) == 0
    printed, shown = QTextDocument(), desktop.window
    printed.setMarkdown(capsys.readouterr().out)
    shown.menus.actions["Licences"].trigger()
    dialog = shown.findChild(LicencesDialog)
    assert dialog.findChild(QTextBrowser).toPlainText().strip() == printed.toPlainText().strip()
