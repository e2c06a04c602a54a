"""What the engine refuses, as one tree.

EngineError
├── SettingsError   a value that an analysis cannot work with
├── OptionError     an option of a conversion that cannot be, or not beside the others
├── AudioError      a sound that cannot be read
│   ├── DeviceError     a sound card that cannot be used
│   └── RecordingError  a sound that cannot be written
├── PresetError     a preset or PhonemeData file that says something impossible
├── ModelError      a trained model that cannot be used
├── RecogniserError a recogniser of another package that fails
├── CurveError      an averaged-spectrum file that cannot be read
├── MeshError       a mesh, or movestates, that cannot be used
├── MouthError      a mouth table that cannot be used
│   └── ExportError     speech that cannot be written in the form that was asked for
├── BatchError      files that cannot be worked through together
├── PerformanceError recorded performances, or a table of them, that cannot be used
├── TextError       a text, or a lexicon, that cannot be spoken
│   └── VoiceError      a voice that cannot be used
└── CorpusError     labelled recordings that cannot be read
    ├── UnknownPhonemeError names of sounds that stand for no phoneme
    └── TakeError       takes that cannot be kept or used

Every message is one sentence for the person at the screen: what is wrong, the limit, what came, and what to do.
"""

import math
import textwrap
from collections.abc import Iterable, Mapping

MOST_SUGGESTED = 3
MOST_LISTED = 240
"""Letters of a list of what there is."""
_SIMILAR = 0.6
"""How alike a word is to one that may have been meant, 0..1, as `difflib` measures it."""


class EngineError(Exception):
    """Anything the engine refuses; its text is fit to be shown."""


class SettingsError(EngineError, ValueError):
    """A setting lies outside its range."""


class OptionError(EngineError, ValueError):
    """An option of a conversion cannot be what it is, or lacks another one that it goes with."""


class AudioError(EngineError):
    """A sound cannot be read."""


class DeviceError(AudioError):
    """A sound card cannot be used."""


class RecordingError(AudioError):
    """A sound cannot be recorded to disk."""


class PresetError(EngineError, ValueError):
    """A preset or PhonemeData file cannot be used."""


class ModelError(EngineError, ValueError):
    """A trained model's file cannot be used."""


class RecogniserError(EngineError):
    """A recogniser from another package cannot be used."""


class CurveError(EngineError, ValueError):
    """A file of averaged spectra cannot be used."""


class MouthError(EngineError, ValueError):
    """A mouth table, or how a mouth shall move, cannot be used."""


class ExportError(MouthError):
    """Speech cannot be written in the form that was asked for."""


class MeshError(EngineError, ValueError):
    """A mesh, or movestates, cannot be used, or their file."""


class BatchError(EngineError):
    """Files cannot be worked through together: a folder that is taken, a cluster that is not there."""


class PerformanceError(EngineError, ValueError):
    """Recorded performances, or a table of them, cannot be used."""


class TextError(EngineError, ValueError):
    """A text, or a lexicon, cannot be spoken."""


class VoiceError(TextError):
    """A voice cannot be used."""


class CorpusError(EngineError, ValueError):
    """A folder of labelled recordings cannot be used."""


class UnknownPhonemeError(CorpusError):
    """Label files hold names that stand for no phoneme.

    Attributes
    ----------
    counts : how often each unknown name occurs, the most frequent first.
    """

    SHOWN = 8

    def __init__(self, file: str, counts: Mapping[str, int]) -> None:
        self.counts = dict(sorted(counts.items(), key=lambda entry: -entry[1]))
        names = [f"{name[:20]!r} ({count} x)" for name, count in self.counts.items()]
        hidden = len(names) - self.SHOWN
        more = f" and {hidden} others" if hidden > 0 else ""
        super().__init__(
            f"{file}: it is unknown what stands for a phoneme in {', '.join(names[: self.SHOWN])}{more}; map each of "
            "these names to a phoneme, in the window or with --map FILE"
        )


class TakeError(CorpusError):
    """Takes cannot be kept or used."""


def check_range(
    what: str, value: float, limits: tuple[float, float, str], error: type[EngineError] = SettingsError
) -> None:
    """Refuse a number that is not finite, or lies outside its limits.

    Parameters
    ----------
    what : the number's name, with which the sentence begins.
    limits : the lowest and the highest value, and their unit.
    error : what a refusal is.
    """
    low, high, unit = limits
    if not (math.isfinite(value) and low <= value <= high):
        limit = f"{low:g}..{high:g} {unit}".rstrip()
        raise error(f"{what} must lie in {limit}, got {value:g}; choose another value")


def meant_by(word: str, known: Iterable[str]) -> list[str]:
    """Return the known words that may be meant by another one: those that begin alike, else those spelt alike."""
    from difflib import get_close_matches  # noqa: PLC0415 - only where something is wrong

    word, names = word.lower(), {name.lower(): name for name in known}
    begun = [name for name in names if word and name.startswith(word)]
    found = begun or get_close_matches(word, names, MOST_SUGGESTED, _SIMILAR)
    return [names[name] for name in found[:MOST_SUGGESTED]]


def remedy(word: str, known: Iterable[str], whole: str = "choose one of {}") -> str:
    """Return the end of a sentence that refuses a word: what may have been meant, else what there is.

    Parameters
    ----------
    word : what came.
    known : what there is.
    whole : what is said of all that there is.
    """
    names = [*known]
    meant = meant_by(word, names)
    if not meant:
        return whole.format(textwrap.shorten(", ".join(names), MOST_LISTED, placeholder=" …"))
    return f"did you mean {', '.join(meant[:-1])}{' or ' if len(meant) > 1 else ''}{meant[-1]}?"
