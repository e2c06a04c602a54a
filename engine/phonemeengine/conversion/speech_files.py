"""What is written of speech: a sound, labels, the movement of a mouth, and its plan; all of them, or none."""

from collections import deque
from collections.abc import Iterable, Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from io import BytesIO
from pathlib import Path
from typing import BinaryIO

from phonemeengine.arrays import Float32Array
from phonemeengine.audio.files import SoundReader
from phonemeengine.audio.wav import check_wav_name
from phonemeengine.batch.work import Say
from phonemeengine.conversion.driving import Driving
from phonemeengine.errors import EngineError
from phonemeengine.labels import textgrid
from phonemeengine.labels.utterance import Utterance, shifted
from phonemeengine.labels.utterance_files import UtteranceSpool
from phonemeengine.mouth.animation import FaceDriver, MovementTrack
from phonemeengine.mouth.exports.exporter import Exporter
from phonemeengine.mouth.transcript import Transcript
from phonemeengine.performance.face_network import Sound, sound_of
from phonemeengine.settings import SAMPLE_RATE
from phonemeengine.speech.pinyin import timing
from phonemeengine.speech.pinyin.track import PinyinTrack
from phonemeengine.speech.silent import SilentText
from phonemeengine.speech.spoken_text import spoken_text, written_as_spoken
from phonemeengine.speech.voice import SpokenSentence
from phonemeengine.storage.files import begins_like
from phonemeengine.storage.replacing import STANDARD_OUTPUT, Guard, guarded_write, nothing_is_own, write_guarded

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
    say : told what is odd.
    overwrite : whether files that the program did not make are replaced.

    Raises
    ------
    EngineError : they cannot be written, or another file is there; before anything is spoken.
    """

    sound: Path | None
    labels: Path | None
    export: Path | None
    plan: Path | None
    exporter: Exporter | None
    driving: Driving
    say: Say
    overwrite: bool = False

    def __post_init__(self) -> None:
        if [self.sound, self.labels, self.export, self.plan].count(STANDARD_OUTPUT) > 1:
            raise EngineError(
                "one of them can be printed, and several are asked for with -; name files for the others"
            )
        if self.sound is not None:
            check_wav_name(self.sound)
        for target, guard in self._guards:
            guard.check(target)

    @property
    def nothing(self) -> bool:
        """Whether nothing is written."""
        return not any((self.sound, self.labels, self.export, self.plan, self.driving.asked.units))

    def write_spoken(self, sentences: Iterator[SpokenSentence], language: str, text: str) -> None:
        """Write what a voice says of a text, as it says it; its sound and its words are not kept for that."""
        with self._opened() as files:
            noted = self._noted(sentences, files)
            if self._moves:
                blocks: list[Float32Array] = []  # which a network follows once all is said
                if self.driving.network is not None:
                    noted = _with_samples_in(blocks, noted)
                felt = self.exporter is not None and self.exporter.idle.feels
                sound = files.get(self.sound)
                said = spoken_text(noted, language=language, sound=sound, path=self.sound, felt=felt)
                track = self._track_of(said.utterance, said.transcript, text, sound=lambda: blocks)
                self._export(files, said.transcript, track, text)
            else:
                deque(written_as_spoken(noted, files.get(self.sound)), maxlen=0)

    def write_said(self, utterance: Utterance, speech: Transcript) -> None:
        """Write what is said in a recording, and `speech`, how loud and high."""
        plan = timing.plan_of(utterance, self.driving.pinyin, seed=self.driving.asked.seed)
        with self._opened() as files:
            self._write_plan(files, plan.rows)
            text = " ".join(word.text for word in utterance.words)
            self._export(files, speech, self._track_of_recording(utterance, speech) if self._moves else None, text)

    def write_silent(self, text: SilentText, name: str) -> tuple[str, ...]:
        """Write what is said in a text without sound; returns what of it is not said.

        Parameters
        ----------
        name : of the text, for people.
        """
        with self._opened() as files:
            if not self._moves:
                skipped: dict[str, None] = {}
                self._write_plan(files, self._rows_of(text.parts(), skipped, name))
                return tuple(skipped)
            said = text.whole()
            speech = said.transcript(name)
            self._write_plan(files, said.plan.rows)
            letters = (
                PinyinTrack(said.utterance, said.plan, text.table) if timing.has_pinyin(said.utterance) else None
            )
            self._export(files, speech, self._track_of(said.utterance, speech, letters=letters), text.text)
            return said.utterance.skipped

    @property
    def _moves(self) -> bool:
        """Whether a face moves, so that all that is said has to be there at once."""
        return self.exporter is not None or self.driving.recorded is not None

    @property
    def _guards(self) -> list[tuple[Path, Guard]]:
        """The files, and what leaves those alone that are there."""
        form = self.exporter.format.owns if self.exporter else None
        asked = (
            (self.sound, nothing_is_own),
            (self.labels, textgrid.owns),
            (self.export, form),
            (self.plan, begins_like(",".join(timing.PLAN_COLUMNS).encode() + b"\n")),
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
        write_guarded(None, [printed.getvalue()], Guard(), is_text=False)

    def _noted(
        self, sentences: Iterable[SpokenSentence], files: dict[Path | None, BinaryIO]
    ) -> Iterator[SpokenSentence]:
        """Return sentences as they come, and write their plan and labels."""
        planner, n, letters = timing.SentencePlanner(self.driving.pinyin, self.driving.asked.seed), 0, False
        self._write_plan(files, ())
        with UtteranceSpool(SILENCE) as labels:
            for sentence in sentences:
                words = [shifted(word, n / SAMPLE_RATE) for word in sentence.words]
                n += len(sentence.samples)
                letters = letters or any(map(timing.says_pinyin, words))
                if self.labels is not None:
                    for word in words:
                        labels.add(word)
                self._write_plan(files, planner.rows_of(sentence.text, words, n / SAMPLE_RATE), header=False)
                yield sentence
            self.driving.check_letters(
                self.driving.asked.driver, self.sound.name if self.sound else "text", letters=letters
            )
            if self.labels is not None:
                files[self.labels].writelines(line.encode() for line in labels.lines(n / SAMPLE_RATE))

    def _rows_of(
        self, parts: Iterable[timing.SaidPart | str], skipped: dict[str, None], name: str
    ) -> Iterator[timing.PlanRow]:
        """Return the rows of a plan; what is not spoken goes to `skipped`, each once."""
        letters = False
        for part in parts:
            if isinstance(part, str):
                skipped[part] = None
            else:
                letters = letters or (part.word is not None and timing.says_pinyin(part.word))
                yield from part.rows
        self.driving.check_letters(self.driving.asked.driver, name, letters=letters)

    def _track_of_recording(self, utterance: Utterance, speech: Transcript) -> MovementTrack | None:
        """Return what moves the face by a recording."""
        if self.driving.network is None or speech.path is None:
            return self._track_of(utterance, speech)
        with SoundReader(speech.path) as reader:
            return self._track_of(utterance, speech, sound=sound_of(reader))

    def _track_of(
        self,
        utterance: Utterance,
        speech: Transcript,
        text: str = "",
        letters: PinyinTrack | None = None,
        sound: Sound | None = None,
    ) -> MovementTrack | None:
        """Return what moves the face."""
        takes = None if self.exporter is None else self.exporter.takes
        driver = self.driving.chosen(utterance, speech.name, takes)
        if driver is FaceDriver.PINYIN and letters is not None:
            return letters
        return self.driving.track(driver, utterance, speech, self.say, text, sound)

    def _export(
        self, files: dict[Path | None, BinaryIO], speech: Transcript, track: MovementTrack | None, text: str = ""
    ) -> None:
        if self.exporter is not None:
            exporter = self.exporter.felt(text, speech.utterance)
            movement = self.driving.movement(track, speech, exporter, self.say)
            files[self.export].writelines(exporter.chunks_of(speech, movement))

    def _write_plan(
        self, files: dict[Path | None, BinaryIO], rows: Iterable[timing.PlanRow], *, header: bool = True
    ) -> None:
        if self.plan is not None:
            files[self.plan].writelines(line.encode() for line in timing.plan_lines(rows, header=header))


def _with_samples_in(blocks: list[Float32Array], sentences: Iterable[SpokenSentence]) -> Iterator[SpokenSentence]:
    """Return sentences as they come, and keep their samples."""
    for sentence in sentences:
        blocks.append(sentence.samples)
        yield sentence
