"""What a sound is heard with: live sound by the preset's recogniser, and sounds that are wholly known by better ones.

Nobody waits for a file. So a preset may name a network that hears as far ahead as back, and a speech encoder beside
it; whoever has the whole sound asks `for_files` which of them there is.
"""

import pkgutil
from collections.abc import Callable
from dataclasses import replace
from importlib.util import find_spec

from phonemeengine.errors import ModelError
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.spec import Recogniser, Tuning, recogniser_of, spec_of
from phonemeengine.settings import FRAME_PERIOD, Ear

ENCODER = "phonemeengine.encoder:encoder_recogniser"
"""Makes the recogniser that hears with a speech encoder and the preset's network; it knows rooms above this one.

It is called with the preset, again for each sound, and says by a `ModelError` what it lacks.
"""
ENCODER_LIBRARY = "ctranslate2"
WITHOUT_ENCODER = 'pip install "phonemeanalyser[whisper]" has files heard by one that knows very many voices'
"""What there is to gain where it is not installed."""
_NEXT = {Ear.WHISPER: Ear.TWIN, Ear.TWIN: Ear.LIVE}


def for_files(preset: Preset, ear: Ear | None = None) -> Preset:
    """Return the preset with which whole sounds are heard; one that it gave stays as it is.

    Where an ear cannot be had, the next best serves; `Preset.warnings` says so, unless nobody asked for it.

    Parameters
    ----------
    preset : what is heard with live.
    ear : what is asked for; None for the best that there is, up to the preset's `Preset.file_ear`.
    """
    if ear is None and (preset.ear is not Ear.LIVE or preset.file_ear is Ear.LIVE):
        return preset
    wanted, warnings = ear or preset.file_ear, list(preset.warnings)
    while wanted is not Ear.LIVE:
        if ear is not None or _is_offered(preset, wanted):
            try:
                return _heard_with(preset, wanted, warnings)
            except ModelError as error:
                warnings.append(str(error))
        wanted = _NEXT[wanted]
    return _heard_with(preset, Ear.LIVE, warnings)


def while_played(preset: Preset, ear: Ear | None = None) -> Preset:
    """Return the same for a sound that is played while it is recognised: no encoder is as fast as that."""
    ear = preset.file_ear if ear is None else ear
    return for_files(replace(preset, file_ear=Ear.TWIN if ear is Ear.WHISPER else ear))


def recogniser_for(preset: Preset) -> Recogniser:
    """Return what a preset hears with.

    Raises
    ------
    EngineError : it cannot be made.
    """
    if preset.ear is not Ear.WHISPER:
        return recogniser_of(preset.recogniser, preset.config)
    try:
        make: Callable[[Preset], Recogniser] = pkgutil.resolve_name(ENCODER)
        return make(preset)
    except ImportError as error:
        raise ModelError(f"the speech encoder is not installed; {WITHOUT_ENCODER}") from error


def ear_in_words(preset: Preset) -> str:
    """Return what a preset hears with, for people, such as ``twin, 0.51 s each way``."""
    model = preset.config.model
    if preset.ear is Ear.WHISPER:
        return "Whisper base and network"
    if model is None or not _has_model(preset):
        return preset.recogniser
    seconds = model.frames_ahead(preset.settings.look_ahead) * FRAME_PERIOD
    return f"twin, {seconds:g} s each way" if model.centred else f"{preset.recogniser}, {1000 * seconds:g} ms ahead"


def _is_offered(preset: Preset, ear: Ear) -> bool:
    """Return whether an ear is there as far as can be seen, so that its lack is worth a word."""
    is_there = preset.file_model is not None if ear is Ear.TWIN else find_spec(ENCODER_LIBRARY) is not None
    return is_there and _has_model(preset)


def _has_model(preset: Preset) -> bool:
    """Return whether what a preset hears live with is a network, which alone has others beside it."""
    return Tuning.MODEL in spec_of(preset.recogniser).tuned_by


def _heard_with(preset: Preset, ear: Ear, warnings: list[str]) -> Preset:
    """Return the preset that hears with an ear; ModelError where it cannot be had."""
    if ear is not Ear.LIVE and not _has_model(preset):
        raise ModelError(f"the recogniser {preset.recogniser!r:.60} has no other ear for files; it hears them itself")
    if ear is Ear.TWIN and preset.file_model is None:
        raise ModelError(f"the preset {preset.name[:60]!r} has no model for files; they are heard as live sound is")
    heard = replace(preset, ear=ear, file_ear=Ear.LIVE, warnings=tuple(warnings))
    if ear is Ear.WHISPER:
        recogniser_for(heard)
    return heard
