"""Builds the voices one after the other; the manifest is whole after each."""

from collections.abc import Iterator
from importlib import import_module
from pathlib import Path

from tools.voices.packages import SOURCES
from tools.voices.recordings import PEOPLE
from tools.voices.voice import Voice
from tools.voices.writing import UtteranceWriter, replace_speaker


def build(folder: Path, cache: Path, wanted: list[str], minutes: float) -> None:
    """Speak some minutes with each voice whose name, or whose source's name, is wanted; of people, write all."""
    for voice in chosen(cache, wanted):
        replace_speaker(folder, voice.speaker, [])
        writer = UtteranceWriter(folder, voice.speaker, voice.table, voice.shift)
        for utterance in voice.utterances():
            writer.write(utterance)
            if voice.speaker.kind != PEOPLE and writer.seconds >= 60 * minutes:
                break
        replace_speaker(folder, voice.speaker, writer.rows)
        print(f"{voice.speaker.corpus}/{voice.speaker.name}: {writer.seconds / 60:.1f} min", flush=True)


def chosen(cache: Path, wanted: list[str]) -> Iterator[Voice]:
    """The wanted voices, in the order of the sources."""
    named = set(wanted) - set(SOURCES)
    for source in SOURCES:
        if source in wanted or named:
            everyone = import_module(f"tools.voices.{source}").voices(cache)
            yield from (voice for voice in everyone if source in wanted or voice.speaker.name in named)
