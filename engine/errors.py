"""What the engine refuses, as one tree.

EngineError
├── SettingsError   a value that an analysis cannot work with
├── AudioError      a sound that cannot be read
│   ├── DeviceError     a sound card that cannot be used
│   └── RecordingError  a sound that cannot be written
├── PresetError     a preset or PhonemeData file that says something impossible
├── RecogniserError a recogniser of another package that fails
├── CurveError      an averaged-spectrum file that cannot be read
└── CorpusError     labelled recordings that cannot be read

Every message is one sentence for the person at the screen: what is wrong, the limit, and what came.
"""


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


class RecogniserError(EngineError):
    """A recogniser from another package cannot be used."""


class CurveError(EngineError, ValueError):
    """A file of averaged spectra cannot be used."""


class CorpusError(EngineError, ValueError):
    """A folder of labelled recordings cannot be used."""
