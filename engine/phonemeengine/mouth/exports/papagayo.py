"""Projects of Papagayo and Papagayo-NG, version 1: voice, phrases, words and phonemes on the frames of a film.

A phrase of one word stands for each stretch between two silences; its text spells our phonemes. Frames count from 0,
and Papagayo shows the mouth at rest wherever there is no phrase. The sound is named with all its folders: any other
name is looked for in the folder of the project.
"""

from collections.abc import Iterator

from phonemeengine.mouth.cues import Cue
from phonemeengine.mouth.exports.export import Export
from phonemeengine.mouth.exports.frames import drawings_on_frames, frame_of
from phonemeengine.mouth.transcript import Transcript
from phonemeengine.phonemes import Phoneme

Phrase = list[tuple[int, int, Cue]]


def write(export: Export) -> Iterator[str]:
    """Write a project with one voice."""
    phrases = list(_phrases(export))
    text = "|".join(_spelt(phrase) for phrase in phrases)
    yield f"lipsync version 1\n{_sound_of(export.speech)}\n{export.rate:.0f}\n"
    yield f"{max(frame_of(export.speech.duration, export.rate), 1)}\n1\n"
    yield f"\tVoice 1\n\t{text}\n\t{len(phrases)}\n"
    for phrase in phrases:
        first, last, word = phrase[0][0], phrase[-1][1] - 1, _spelt(phrase)
        yield f"\t\t{word}\n\t\t{first}\n\t\t{last}\n\t\t1\n"
        yield f"\t\t\t{word} {first} {last} {len(phrase)}\n"
        for frame, _, cue in phrase:
            yield f"\t\t\t\t{frame} {cue.shape}\n"


def _sound_of(speech: Transcript) -> str:
    """Return where the sound is; its name alone where that is unknown, or would break the line."""
    place = str(speech.path.resolve()) if speech.path else ""
    return place if place and place.isprintable() else speech.name


def _phrases(export: Export) -> Iterator[Phrase]:
    phrase: Phrase = []
    for drawing in drawings_on_frames(export):
        if drawing[2].phoneme != Phoneme.SILENCE:
            phrase.append(drawing)
        elif phrase:
            yield phrase
            phrase = []
    if phrase:
        yield phrase


def _spelt(phrase: Phrase) -> str:
    return "-".join(cue.phoneme.label for _, _, cue in phrase)
