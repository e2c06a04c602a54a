"""What `speak` writes of speech: a sound, labels, the movement of a mouth, and its plan; all of them, or none."""

import argparse
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import BinaryIO

from phonemeanalyser.cli.expression import idle_of
from phonemeanalyser.cli.jobs import say_note
from phonemeanalyser.cli.output_files import Guard, print_whole, whole_file
from phonemeanalyser.cli.performing import Performing
from phonemeengine import (
    Animation,
    EngineError,
    ExportOptions,
    PinyinTable,
    PinyinTrack,
    SpokenSentence,
    Spring,
    Transcript,
    Utterance,
    format_plan,
    format_utterance,
    load_pinyin_table,
    pinyin_track,
    spoken_text,
)
from phonemeengine.files import begins_like
from phonemeengine.labels import textgrid
from phonemeengine.mouth.exports.exporter import Exporter
from phonemeengine.speech.pinyin.plan import PLAN_COLUMNS
from phonemeengine.speech.pinyin.timing import has_pinyin

SILENCE = "sil"
"""The name of what lies between words, in labels."""
STANDARD_OUTPUT = Path("-")


def pinyin_table_of(options: argparse.Namespace) -> PinyinTable:
    """Return the table that the command line asks for."""
    table = load_pinyin_table(options.pinyin_table) if options.pinyin_table else load_pinyin_table()
    return table if options.spring is None else replace(table, spring=Spring.of(options.spring))


@dataclass(frozen=True)
class SpeechFiles:
    """What is written of speech.

    Attributes
    ----------
    sound, labels, export, plan : the files; None where they are not asked for.
    exporter : writes the export.
    driver : what moves a face: ``pinyin``, ``table``, ``rules``, or ``auto``: a table, or pinyin for Chinese.
    performer : how recorded faces move it; None where they do not.
    table : the pinyin table.
    seed : of its variation.
    overwrite : whether files of somebody else are replaced.
    """

    sound: Path | None
    labels: Path | None
    export: Path | None
    plan: Path | None
    exporter: Exporter | None
    driver: str
    performer: Performing | None
    table: PinyinTable
    seed: int | None
    overwrite: bool

    @classmethod
    def of(cls, options: argparse.Namespace, performer: Performing | None) -> "SpeechFiles":
        """Check what the command line asks for, before anything is spoken.

        Raises
        ------
        EngineError : it cannot be written, or somebody else's file is there.
        """
        if (options.export is None) != (options.kind is None):
            raise EngineError("--export and --format go together; name both")
        if options.plan is not None and (performer is not None or options.text_driver == "rules"):
            raise EngineError("--plan tells of the pinyin mouth; leave --text-driver rules and --performance out")
        written = ExportOptions(rate=options.fps, idle=idle_of(options))
        exporter = Exporter(options.kind, written) if options.kind else None
        files = cls(
            options.out, options.labels, options.export, options.plan, exporter, options.text_driver, performer,
            pinyin_table_of(options), options.seed, options.overwrite,
        )  # fmt: skip
        for target, guard in files._guards:
            guard.check(target)
        return files

    @property
    def nothing(self) -> bool:
        """Whether nothing is written."""
        units = self.performer and self.performer.units
        return not any((self.sound, self.labels, self.export, self.plan, units))

    def write_spoken(self, sentences: Iterator[SpokenSentence], language: str, text: str) -> None:
        """Write what a voice says of a text, as it says it."""
        with self._opened() as files:
            measured, sound = bool(self.exporter or self.performer), files.get(self.sound)
            said = spoken_text(sentences, language=language, sound=sound, path=self.sound, measured=measured)
            self._fill(files, said.transcript, said.utterance, self._track_of(said.utterance, text))

    def write_said(self, utterance: Utterance, speech: Transcript, track: PinyinTrack | None) -> None:
        """Write what a mouth says, by pinyin where there is a track, and `speech`, how loud and high that is."""
        with self._opened() as files:
            self._fill(files, speech, utterance, track)

    @property
    def _guards(self) -> list[tuple[Path, Guard]]:
        """The files, and what leaves those alone that are there: a voice says no text twice in the same way."""
        form = self.exporter.format.owns if self.exporter else None
        plan = None if self.plan == STANDARD_OUTPUT else self.plan
        asked = (
            (self.sound, lambda _content: False),
            (self.labels, textgrid.owns),
            (self.export, form),
            (plan, begins_like(",".join(PLAN_COLUMNS).encode() + b"\n")),
        )
        return [(target, Guard(owns, self.overwrite)) for target, owns in asked if target is not None]

    @contextmanager
    def _opened(self) -> Iterator[dict[Path | None, BinaryIO]]:
        """Open all files; they are there once the block has ended well."""
        with ExitStack() as stack:
            yield {target: stack.enter_context(whole_file(target, guard)) for target, guard in self._guards}

    def _track_of(self, utterance: Utterance, text: str) -> PinyinTrack | None:
        """Return how pinyin moves the mouth, where it does, or where its plan is asked for."""
        auto = self.driver == "auto" and self.performer is None
        moves = self.driver == "pinyin" or (auto and has_pinyin(utterance))
        if self.plan is None and not moves:
            return None
        return pinyin_track(utterance, self.table, text=text, seed=self.seed)

    def _fill(
        self, files: dict[Path | None, BinaryIO], speech: Transcript, utterance: Utterance, track: PinyinTrack | None
    ) -> None:
        plan = "" if track is None else format_plan(track.plan)
        if self.labels is not None:
            files[self.labels].write(format_utterance(utterance, SILENCE).encode())
        if self.performer is not None:
            movement = self.performer.movement(utterance, speech, self.exporter)
        else:
            movement = self._by_letters(speech, track)
        if self.exporter is not None:
            files[self.export].writelines(self.exporter.chunks_of(speech, movement))
        if self.plan == STANDARD_OUTPUT:
            print_whole(lambda file: file.writelines([plan]))
        elif self.plan is not None:
            files[self.plan].write(plan.encode())

    def _by_letters(self, speech: Transcript, track: PinyinTrack | None) -> Animation | None:
        """Return a movement by the letters; None for drawings and other movestates, which follow the phones."""
        exporter = self.exporter
        if exporter is None:
            return None
        if track is not None and exporter.format.moves_head and self.driver != "rules":
            return track.animation(speech, exporter.rate, exporter.idle)
        if self.driver == "pinyin":
            say_note(exporter.name, "it has shapes of its own, which follow the phones")
        return None
