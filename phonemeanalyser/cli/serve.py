"""``phonemeanalyser serve``: recognise streams of speech, and export files, for programs over the network."""

import argparse
import asyncio
import gc
from contextlib import AbstractAsyncContextManager
from dataclasses import fields
from pathlib import Path

from phonemeanalyser.cli.listen import ended_by_signals
from phonemeanalyser.cli.parser import number_in, whole_in
from phonemeanalyser.cli.requirements import module_that_serves
from phonemeanalyser.server.access import LIMITS, USUAL_HOST, USUAL_PORT, Access, ServerLimits, token_in
from phonemeanalyser.server.activity import Activity, Happening, Report, no_report
from phonemeengine.conversion.options import OPTIONS
from phonemeengine.execution import end_with_input
from phonemeengine.presets.files import DEFAULT_PRESET

EXAMPLES = (
    "phonemeanalyser serve",
    "phonemeanalyser serve --port 9000 --preset my-voice.toml --table my-face.toml",
    "phonemeanalyser serve --host 0.0.0.0 --token-file token.txt --origin https://example.org",
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say where it is served, to whom, and how much."""
    parser.add_argument("--host", default=USUAL_HOST, help=f"address (default: {USUAL_HOST}, this machine only)")
    port = f"port; 0 takes a free one (default: {USUAL_PORT})"
    parser.add_argument("--port", type=whole_in(0, 65_535), default=USUAL_PORT, metavar="P", help=port)
    token = "file with the token that clients must send; without it, only this machine is served"  # noqa: S105
    parser.add_argument("--token-file", type=Path, metavar="FILE", help=token)
    origin = "origin of web pages that may connect, such as https://example.org; may be repeated"
    parser.add_argument("--origin", action="append", default=[], metavar="URL", help=origin)
    proxy = "address of a proxy whose X-Forwarded-For names the client, such as 127.0.0.1; may be repeated"
    parser.add_argument("--trusted-proxy", action="append", default=[], metavar="ADDRESS", help=proxy)
    preset = f"{OPTIONS['preset'].words}; may be repeated: clients may name others than the first one"
    parser.add_argument("--preset", action="append", type=Path, metavar="PRESET", help=preset)
    table = "mouth table of your own (.toml) that clients may name; may be repeated"
    parser.add_argument("--table", action="append", default=[], type=Path, metavar="FILE", help=table)
    supervised = (
        "print what clients do, as lines of JSON, and end with the standard input: for programs that start it"
    )
    parser.add_argument("--supervised", action="store_true", help=supervised)
    for limit in fields(ServerLimits):
        low, high, unit, words = LIMITS[limit.name]
        kind = whole_in(int(low), high, unit) if isinstance(limit.default, int) else number_in(low, high, unit)
        help_words = f"{words} (default: {limit.default:g} {unit}".rstrip() + ")"
        name = f"--{limit.name.replace('_', '-')}"
        parser.add_argument(name, type=kind, default=limit.default, metavar="N", help=help_words)


def run(options: argparse.Namespace) -> int:
    """Serve until Ctrl-C."""
    service = module_that_serves()
    token = None if options.token_file is None else token_in(options.token_file)
    limits = ServerLimits(**{limit.name: getattr(options, limit.name) for limit in fields(ServerLimits)})
    report: Report = _print_line if options.supervised else no_report
    access = Access(token, tuple(options.origin), tuple(options.trusted_proxy))
    settings = service.ServerSettings(
        options.preset or [DEFAULT_PRESET], options.table, options.host, options.port, access, limits, report
    )
    with ended_by_signals():
        asyncio.run(_serve(service.serving(settings), options.host, supervised=options.supervised))
    return 0


def _print_line(activity: Activity) -> None:
    print(activity.to_line(), flush=True)


async def _serve(serving: AbstractAsyncContextManager[int], host: str, *, supervised: bool) -> None:
    async with serving as port:
        gc.freeze()  # what is there stays: looking through it would only hold streams up
        shown = f"[{host}]" if ":" in host else host
        if supervised:
            end_with_input()
            _print_line(Activity(Happening.SERVING, f"http://{shown}:{port}"))
        else:
            print(f"serving http://{shown}:{port}, streams at ws://{shown}:{port}/stream; Ctrl-C ends it", flush=True)
        await asyncio.Event().wait()
