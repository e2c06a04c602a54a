"""What `speak` writes of speech: a sound, labels, the movement of a mouth, and its plan; all of them, or none."""

import argparse
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from io import BytesIO
from pathlib import Path
from typing import BinaryIO

from phonemeanalyser.cli.driving import Driving, FaceTrack
from phonemeanalyser.cli.expression import idle_of
from phonemeanalyser.cli.output_files import STANDARD_OUTPUT, print_bytes
from phonemeengine import (
    EngineError,
    ExportOptions,
    FaceDriver,
    PinyinTrack,
    SpokenSentence,
    Transcript,
    Utterance,
    format_plan,
    format_utterance,
    spoken_text,
)
from phonemeengine.audio.wav import check_wav_name
from phonemeengine.files import begins_like
from phonemeengine.labels import textgrid
from phonemeengine.mouth.exports.exporter import Exporter
from phonemeengine.replacing import Guard, guarded_write, nothing_is_own
from phonemeengine.speech.pinyin.plan import PLAN_COLUMNS

SILENCE = "sil"
"""The name of what lies between words, in labels."""


@dataclass(frozen=True)
class SpeechFiles:
    """What is written of speech.

    Attributes
    ----------
    sound, labels, export, plan : the files; None where they are not asked for.
    exporter : writes the export.
    driving : moves the face.
    overwrite : whether files of somebody else are replaced.
    """

    sound: Path | None
    labels: Path | None
    export: Path | None
    plan: Path | None
    exporter: Exporter | None
    driving: Driving
    overwrite: bool

    @classmethod
    def of(cls, options: argparse.Namespace, driving: Driving) -> "SpeechFiles":
        """Check what the command line asks for, before anything is spoken.

        Raises
        ------
        EngineError : it cannot be written, or another file is there.
        """
        if (options.export is None) != (options.kind is None):
            raise EngineError("--export and --format go together; name both")
        if options.plan is not None and (driving.performer is not None or driving.driver is FaceDriver.RULES):
            raise EngineError("--plan tells of the pinyin mouth; leave --text-driver rules and --performance out")
        written = ExportOptions(rate=options.fps, idle=idle_of(options))
        exporter = Exporter(options.kind, written) if options.kind else None
        files = cls(
            options.out, options.labels, options.export, options.plan, exporter, driving, options.overwrite
        )  # fmt: skip
        if [files.sound, files.labels, files.export, files.plan].count(STANDARD_OUTPUT) > 1:
            raise EngineError(
                "one of them can be printed, and several are asked for with -; name files for the others"
            )
        if files.sound is not None:
            check_wav_name(files.sound)
        for target, guard in files._guards:
            guard.check(target)
        return files

    @property
    def nothing(self) -> bool:
        """Whether nothing is written."""
        units = self.driving.performer and self.driving.performer.units
        return not any((self.sound, self.labels, self.export, self.plan, units))

    def write_spoken(self, sentences: Iterator[SpokenSentence], language: str, text: str) -> None:
        """Write what a voice says of a text, as it says it."""
        with self._opened() as files:
            measured, sound = bool(self.exporter or self.driving.performer), files.get(self.sound)
            said = spoken_text(sentences, language=language, sound=sound, path=self.sound, measured=measured)
            track = self._track_of(said.utterance, said.transcript, text)
            self._fill(files, said.utterance, said.transcript, track)

    def write_said(self, utterance: Utterance, speech: Transcript, letters: PinyinTrack | None = None) -> None:
        """Write what is said, and `speech`, how loud and high; by these letters, where letters move the face."""
        with self._opened() as files:
            self._fill(files, utterance, speech, self._track_of(utterance, speech, letters=letters))

    @property
    def _guards(self) -> list[tuple[Path, Guard]]:
        """The files, and what leaves those alone that are there: a voice says no text twice in the same way."""
        form = self.exporter.format.owns if self.exporter else None
        asked = (
            (self.sound, nothing_is_own),
            (self.labels, textgrid.owns),
            (self.export, form),
            (self.plan, begins_like(",".join(PLAN_COLUMNS).encode() + b"\n")),
        )
        return [
            (target, Guard(owns, self.overwrite)) for target, owns in asked if target not in {None, STANDARD_OUTPUT}
        ]

    @contextmanager
    def _opened(self) -> Iterator[dict[Path | None, BinaryIO]]:
        """Open all files; they are there, and what is printed is, once the block has ended well."""
        printed = BytesIO()
        with ExitStack() as stack:
            files: dict[Path | None, BinaryIO] = {
                target: stack.enter_context(guarded_write(target, guard)) for target, guard in self._guards
            }
            yield files | {STANDARD_OUTPUT: printed}
        print_bytes([printed.getvalue()])

    def _track_of(
        self, utterance: Utterance, speech: Transcript, text: str = "", letters: PinyinTrack | None = None
    ) -> FaceTrack | None:
        """Return what moves the face, or whose plan is asked for."""
        asked = None if self.plan is None else FaceDriver.PINYIN
        takes = None if self.exporter is None else self.exporter.takes
        driver = self.driving.chosen(utterance, speech.name, takes, asked)
        if driver is FaceDriver.PINYIN and letters is not None:
            return letters
        return self.driving.track(driver, utterance, speech, text)

    def _fill(
        self, files: dict[Path | None, BinaryIO], utterance: Utterance, speech: Transcript, track: FaceTrack | None
    ) -> None:
        if self.labels is not None:
            files[self.labels].write(format_utterance(utterance, SILENCE).encode())
        if self.exporter is not None:
            movement = self.driving.movement(track, speech, self.exporter)
            files[self.export].writelines(self.exporter.chunks_of(speech, movement))
        if self.plan is not None and isinstance(track, PinyinTrack):
            files[self.plan].write(format_plan(track.plan).encode())
