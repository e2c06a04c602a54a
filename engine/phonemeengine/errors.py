"""What the engine refuses, as one tree.

EngineError
├── SettingsError   a value that an analysis cannot work with
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

Every message is one sentence for the person at the screen: what is wrong, the limit, and what came.
"""

from collections.abc import Mapping


class EngineError(Exception):
    """Anything the engine refuses; its text is fit to be shown."""


class SettingsError(EngineError, ValueError):
    """A setting lies outside its range."""


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
