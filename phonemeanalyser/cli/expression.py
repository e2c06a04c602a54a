"""What a face expresses beside its speech, as a command's arguments say."""

import argparse

from phonemeengine import (
    Detail,
    Expression,
    ExpressionStream,
    IdleMotion,
    MouthError,
    held_expression,
    read_expression,
)
from phonemeengine.mouth.expression.streams import expression_presets

RECORDED = ".csv"


def add_expression(parser: argparse.ArgumentParser) -> None:
    """Let the user choose what a face expresses, and how much of it the speech leaves."""
    names = ", ".join(expression_presets())
    parser.add_argument(
        "--expression", action="append", metavar="E",
        help=f"beside speech: NAME=V,... (0..1) of {names} or blend shapes; or a Live Link Face CSV; again for more",
    )  # fmt: skip
    parser.add_argument(
        "--priority", metavar="S[,E]", help="of the speech over expressions, 0..1, on its own and on other channels"
    )


def expression_of(options: argparse.Namespace, *more: ExpressionStream) -> Expression | None:
    """Return what a command line with the arguments of `add_expression` asks for, with more streams.

    Raises
    ------
    EngineError : there is no such expression, or a file cannot be read.
    """
    streams = (*map(_stream_of, options.expression or ()), *more)
    if not streams:
        if options.priority is not None:
            options.parser.error("--priority goes with --expression: say what is expressed")
        return None
    if options.priority is None:
        return Expression(streams)
    speech, _, other = options.priority.partition(",")
    return Expression(streams, _number(speech, options.priority), _number(other, options.priority) if other else None)


def idle_of(options: argparse.Namespace) -> IdleMotion:
    """Return what a face does besides speaking, of a command line with the arguments of `add_expression`.

    Raises
    ------
    EngineError : there is no such expression, or a file cannot be read.
    """
    detail = Detail(options.detail) if "detail" in options else Detail.PHONEMES
    return IdleMotion(
        not options.no_blinks, not options.no_head, options.seed or 0, detail, expression=expression_of(options)
    )


def _stream_of(words: str) -> ExpressionStream:
    if words.lower().endswith(RECORDED):
        return read_expression(words)
    shares: dict[str, float] = {}
    for part in words.split(","):
        name, _, share = part.partition("=")
        shares[name.strip()] = _number(share, words) if share else 1.0
    return held_expression(shares)


def _number(text: str, words: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise MouthError(f"{words[:60]!r} holds no number where {text[:20]!r} is; write such as smile=0.5") from None
