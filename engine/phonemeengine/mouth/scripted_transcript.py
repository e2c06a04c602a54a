"""What is said in a sound whose words are known: aligned, and as mouths need it."""

from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

from phonemeengine.alignment.align import align_analyses
from phonemeengine.analyser import Analysis
from phonemeengine.labels.utterance import Utterance
from phonemeengine.mouth.transcript import Prosody, Transcript, transcript_of_utterance
from phonemeengine.text.pronunciation import ScriptWord

Script = Sequence[ScriptWord] | Utterance
"""The words of a sound with their pronunciations, or all that is said in it with times, as label files have it."""


def scripted_transcript_of(
    analyses: Iterable[Analysis],
    script: Script,
    name: str,
    duration: float,
    path: Path | None = None,
    *,
    accept_text: bool = False,
) -> tuple[Utterance, Transcript]:
    """Return what is said in a sound of `duration` seconds, from its consecutive analyses; `path` is its file.

    With `accept_text` words are aligned even where another text seems to be said.

    Raises
    ------
    CorpusError : there is no word in the script.
    """
    prosody = Prosody()

    def kept() -> Iterator[Analysis]:
        for analysis in analyses:
            prosody.add(analysis)
            yield analysis

    if isinstance(script, Utterance):
        utterance = script
        for _ in kept():
            pass
    else:
        utterance = align_analyses(kept(), script, duration, accept_text=accept_text)
    return utterance, transcript_of_utterance(utterance, prosody.intensities, prosody.pitches, name, path)
