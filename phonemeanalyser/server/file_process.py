"""A process that makes one file for the server.

Its input has, pickled, a preset's file, what makes the work with that preset, and the job. The server holds the input
open for as long as a client waits. The process prints what came of it: a list in JSON, of one of `MADE`, `REFUSED`,
`NO_MEMORY` and `CRASHED`, and of words.
"""

import json
import pickle
import sys
import traceback

from phonemeengine import EngineError, load_preset
from phonemeengine.batch.order import worked_on
from phonemeengine.execution import end_with_input, no_progress

MADE, REFUSED, NO_MEMORY, CRASHED = "made", "refused", "no memory", "crashed"
CODE = "from phonemeanalyser.server.file_process import run; run()"
"""What Python runs; a bundled program knows no ``-m``."""


def run() -> None:
    """Do what the input asks for."""
    try:
        preset, work_with, job = pickle.load(sys.stdin.buffer)  # noqa: S301 - from the server that started this
        end_with_input()
        with work_with(preset=load_preset(preset)).opened() as act:
            words = worked_on(act, job, no_progress, recorded=False).words
        answer = [REFUSED if words else MADE, words]
    except EngineError as error:
        answer = [REFUSED, str(error)]
    except MemoryError:
        answer = [NO_MEMORY, ""]
    except Exception:  # noqa: BLE001 - the server tells of it in its log
        answer = [CRASHED, traceback.format_exc()]
    sys.stdout.write(json.dumps(answer))
    sys.stdout.flush()
