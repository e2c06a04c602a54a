"""The list of files that the window turns into others."""

from pathlib import Path

from pytestqt.qtbot import QtBot

from phonemeanalyser.desktop.session.exports import ExportOrder, ExportQueue, ExportState
from phonemeengine.mouth.exports.exporter import ExportOptions
from phonemeengine.presets.files import load_preset


def test_files_that_an_unexpected_error_leaves_have_failed(qtbot: QtBot, tmp_path: Path) -> None:
    queue = ExportQueue()
    order = ExportOrder("no such kind", load_preset("thesis"), ExportOptions())
    with qtbot.captureExceptions() as raised:
        queue.start({tmp_path / "a.wav": tmp_path / "a.json"}, order)
        qtbot.waitUntil(lambda: not queue.busy and bool(raised))
    (job,) = queue.jobs
    assert (job.state, job.words) == (ExportState.FAILED, "stopped by an unexpected error")
    assert [kind for kind, *_ in raised] == [KeyError]
