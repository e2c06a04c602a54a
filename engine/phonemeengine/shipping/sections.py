"""The sections of an ``.ear`` file: the mouth, and what a preset recognises with."""

import struct
import zlib
from collections.abc import Iterable, Iterator

import numpy as np
from numpy.typing import ArrayLike

from phonemeengine.dsp.mel import FLOOR, cepstral_cosines, mel_bank, mel_edges, short_window, warped_mel_bank
from phonemeengine.dsp.spectrum import SpectrumAnalyser, window_of
from phonemeengine.errors import PresetError
from phonemeengine.features.front_end import shaper_of
from phonemeengine.features.variables import (
    BAND_VARIABLES,
    ENERGY_VARIABLES,
    WHOLE_FRAME_VARIABLES,
    Kind,
    Spectrum,
    Variable,
    reach_of,
)
from phonemeengine.labels.visemes import STANDARD_VISEMES, VisemeSet
from phonemeengine.mouth.table import MouthTable
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.model_choice import frames_ahead, with_small_network
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.decoder import Decoder
from phonemeengine.recognition.model import Model, OutputHead
from phonemeengine.recognition.rules import Rule, RuleRecogniser
from phonemeengine.recognition.segments import frames_held, line_of
from phonemeengine.recognition.spec import RecogniserSpec, Tuning, spec_of
from phonemeengine.recognition.templates import Templates
from phonemeengine.settings import BIN_WIDTH, AnalysisSettings, Decimation, Filter, WindowFunction

# The bytes of an ``.ear`` file: little-endian numbers of 32 bits, in sections that say how long they are.

MAGIC = b"EAR\x1a"
OWN_VISEMES, DECODER = "VISM", "DECO"
VERSIONS = {OWN_VISEMES: 2, DECODER: 3}
"""Of the layout, by the newest section that a file has, else 1; the runtime refuses newer ones than it knows."""


class SectionWriter:
    """Collects the content of one section."""

    def __init__(self) -> None:
        self._parts: list[bytes] = []

    def whole(self, *numbers: int) -> None:
        """Write whole numbers, 0 or more."""
        self._parts.append(struct.pack(f"<{len(numbers)}I", *numbers))

    def floats(self, numbers: ArrayLike) -> None:
        """Write numbers of single precision."""
        self._parts.append(np.asarray(numbers, "<f4").tobytes())

    def doubles(self, *numbers: float) -> None:
        """Write numbers of double precision."""
        self._parts.append(struct.pack(f"<{len(numbers)}d", *numbers))

    def halves(self, numbers: ArrayLike) -> None:
        """Write numbers of half precision, up to a whole 32 bits."""
        self._padded(np.asarray(numbers, "<f2").tobytes())

    def text(self, text: str) -> None:
        """Write a text in UTF-8 with its length."""
        content = text.encode(errors="replace")
        self.whole(len(content))
        self._padded(content)

    def filters(self, bank: ArrayLike) -> None:
        """Write filters, shape (n_bins, n_filters): of each the range of bins that it weighs."""
        for weights in np.asarray(bank, np.float32).T:
            weighed = np.flatnonzero(weights)
            first, stop = (int(weighed[0]), int(weighed[-1]) + 1) if len(weighed) else (0, 0)
            self.whole(first, stop - first)
            self.floats(weights[first:stop])

    def _padded(self, content: bytes) -> None:
        self._parts.append(content + bytes(-len(content) % 4))

    @property
    def content(self) -> bytes:
        """All that was written."""
        return b"".join(self._parts)


def join_sections(sections: Iterable[tuple[str, SectionWriter]]) -> bytes:
    """Return a file of sections, each with the four letters of its name."""
    parts = [(name.encode(), section.content) for name, section in sections]
    body = b"".join(name + struct.pack("<I", len(content)) + content for name, content in parts)
    version = max((VERSIONS.get(name.decode(), 1) for name, _ in parts), default=1)
    return MAGIC + struct.pack("<III", version, 16 + len(body), zlib.crc32(body)) + body


def is_ear_file(content: bytes) -> bool:
    """Return whether a file's content begins as an ``.ear`` file."""
    return content.startswith(MAGIC)


# A mouth table as a section of an ``.ear`` file.

SIDES = ("Right", "Left")


def mouth_section(name: str, table: MouthTable, visemes: VisemeSet = STANDARD_VISEMES) -> tuple[str, SectionWriter]:
    """Return the section of a table that the runtime finds by a name; the visemes are those of the runtime."""
    section = SectionWriter()
    shapes = list(table.shapes)
    section.text(name)
    section.doubles(table.motion.loudness, table.motion.minimum_opening, table.motion.randomness)
    section.whole(len(table.movestates))
    for movestate in table.movestates:
        section.text(movestate)
    section.whole(*_left_sides(table.movestates), len(shapes))
    for shape in shapes:
        section.text(shape)
    section.floats(table.weights())
    section.floats(table.shape_weights())
    section.whole(*_looseness(table))
    for phoneme in Phoneme:
        for look in (*visemes.names, None):
            _entry(section, table, shapes, phoneme, visemes.phones.get(look, "") if look else "")
    return "MOUT", section


def _entry(section: SectionWriter, table: MouthTable, shapes: list[str], phoneme: Phoneme, phone: str) -> None:
    """Write which shape a sound has, where its weights stand, and how fast the mouth is."""
    shape, silent = table.shape_of(phoneme, phone), phoneme is Phoneme.SILENCE
    row = int(phoneme) if shape == table.phonemes[phoneme] else len(Phoneme) + shapes.index(shape)
    section.whole(shapes.index(shape), row)
    times = None if silent else table.times_of(phoneme, phone)
    section.doubles(times.to_shape if times else 0.0, times.to_rest if times else 0.0)
    section.whole(silent or table.closes(phoneme, phone))


def _left_sides(movestates: tuple[str, ...]) -> list[int]:
    """Return for each movestate of the right side that of the left, and itself for all others."""
    columns = {name: k for k, name in enumerate(movestates)}
    right, left = SIDES
    lefts = (f"{name.removesuffix(right)}{left}" if name.endswith(right) else name for name in movestates)
    return [columns.get(name, k) for k, name in enumerate(lefts)]


def _looseness(table: MouthTable) -> list[bool]:
    """Return of which rows of weights the habits of a mouth may change something: not those at which lips meet."""
    firm = {table.phones[name] for name in table.closed_phones}
    phonemes = [phoneme not in {*table.closed_phonemes, Phoneme.SILENCE} for phoneme in Phoneme]
    return [*phonemes, *(shape not in firm for shape in table.shapes)]


# What a preset recognises with, as sections of an ``.ear`` file.

BY_RULES, BY_NETWORK, BY_TEMPLATES = range(3)
ZERO_CROSSINGS, VOLUME, NOTHING, BAND = range(4)
SOURCES = (Spectrum.RAW, Spectrum.FILTERED, Spectrum.NORMALISED, Spectrum.MEL)
KINDS = (Kind.SUM, Kind.MAX, Kind.MEAN)
WHOLE_FRAME = {"zero_crossings": ZERO_CROSSINGS, "volume": VOLUME, "f0": NOTHING}
"""What is no band; the runtime does not measure the fundamental frequency, so it reads 0, as live."""

Section = tuple[str, SectionWriter]


def recogniser_sections(preset: Preset) -> Iterator[Section]:
    """Give the sections of all that a preset recognises live sound with.

    Raises
    ------
    PresetError : its recogniser is another package's, works on files alone, or chooses sets by the pitch.
    """
    if preset.pitch_ranges:
        raise PresetError(
            f"the preset {preset.name[:60]!r} has pitch sets, and the runtime cannot choose by pitch; ship one "
            "preset for each set"
        )
    live, spec = with_small_network(preset), spec_of(preset.recogniser)
    config = live.config
    if Tuning.MODEL in spec.tuned_by and config.model is not None:
        model = _live_model(config.model)
        yield _preset(live, spec, BY_NETWORK, model.frames_ahead(config.look_ahead))
        yield _log_mels(model.warps)
        yield _network(model, model.frames_ahead(config.look_ahead))
    elif Tuning.TEMPLATES in spec.tuned_by and config.templates is not None:
        yield _preset(live, spec, BY_TEMPLATES, 0)
        yield _log_mels((1.0,))
        yield _templates(config.templates)
    elif spec.rules is not None:
        asked = RuleRecogniser(spec.rules(config), config.thresholds)
        yield _preset(live, spec, BY_RULES, frames_ahead(live))
        variables = _variables_of(live, asked.rules)
        yield _front_end(live.settings, variables)
        yield _rules(asked, [v.name if isinstance(v, Variable) else v for v in variables])
        if config.decoder is not None:
            yield _decoder(config.decoder)
    else:
        raise PresetError(
            f"the recogniser {preset.recogniser!r:.60} is another package's, and only those of the program can be "
            "shipped; choose another preset"
        )


def viseme_set_of(preset: Preset) -> VisemeSet:
    """Return the visemes that the runtime distinguishes with a preset."""
    model = preset.config.model if Tuning.MODEL in spec_of(preset.recogniser).tuned_by else None
    return STANDARD_VISEMES if model is None else model.viseme_set


def viseme_sections(visemes: VisemeSet) -> Iterator[Section]:
    """Give the section of visemes that are not the fifteen: names, which ones each phoneme allows, and the usual."""
    if visemes == STANDARD_VISEMES:
        return
    section = SectionWriter()
    section.whole(len(visemes.names))
    for name in visemes.names:
        section.text(name)
    section.whole(*(sum(1 << k for k in np.flatnonzero(row).tolist()) for row in visemes.allowed))
    section.whole(*visemes.usual_visemes(np.arange(len(Phoneme), dtype=np.uint8)).tolist())
    yield OWN_VISEMES, section


def _live_model(model: Model) -> Model:
    if model.centred:
        raise PresetError(
            "this preset's model recognises files only, the runtime live sound only; choose another preset"
        )
    return model.rounded()


def _preset(preset: Preset, spec: RecogniserSpec, kind: int, look_ahead: int) -> Section:
    section, settings = SectionWriter(), preset.settings
    weighs = Tuning.SENSITIVITIES in spec.tuned_by
    curve = preset.curve if weighs or preset.is_measured else None
    section.text(preset.name)
    section.whole(kind, look_ahead, settings.statistics, frames_held(settings.minimum_hold))
    section.floats(settings.hysteresis if spec.has_deficits and preset.decoder is None else 0.0)
    section.floats([float(part) for part in line_of(settings.intensity_low, settings.intensity_high)])
    section.whole(*(preset.successors.get(phoneme, phoneme) for phoneme in Phoneme))
    sensitivities = [preset.sensitivities.get(phoneme, 0.0) if weighs else 0.0 for phoneme in Phoneme]
    section.whole(any(sensitivities))
    section.floats(np.exp(sensitivities))
    section.whole(len(curve.scores) if curve else 0)
    section.floats([*curve.scores, *curve.shares] if curve else [])
    return "PRST", section


def _log_mels(warps: tuple[float, ...]) -> Section:
    section = SectionWriter()
    section.whole(len(warps))
    section.floats(FLOOR)
    section.whole(len(warped_mel_bank()))
    section.floats(short_window())
    for warp in warps:
        section.filters(warped_mel_bank(warp))
    return "MELS", section


def _network(model: Model, look_ahead: int) -> Section:
    section = SectionWriter()
    section.whole(len(model.layers))
    for layer in model.layers:
        section.whole(len(layer.bias), layer.dilation)
        section.halves(layer.weights)
        section.floats(layer.bias)
    section.whole(bool(model.viseme_heads))
    for heads in filter(None, (model.heads, model.viseme_heads)):
        _head(section, heads[look_ahead])
    return "NETW", section


def _head(section: SectionWriter, head: OutputHead) -> None:
    section.halves(head.weights)
    section.floats(head.bias)


def _variables_of(preset: Preset, rules: tuple[Rule, ...]) -> list[Variable | str]:
    """Return what the rules ask for and what that is divided by, the names alone of what is no band."""
    known = {v.name: v for v in (*ENERGY_VARIABLES, *BAND_VARIABLES, *preset.variables)}
    asked = dict.fromkeys(condition.variable for rule in rules for condition in rule.conditions)
    asked |= dict.fromkeys(known[name].per for name in asked if name in known and known[name].per)
    return [known.get(name, name) for name in asked or WHOLE_FRAME_VARIABLES[:1]]


def _front_end(settings: AnalysisSettings, variables: list[Variable | str]) -> Section:
    section = SectionWriter()
    analyser = SpectrumAnalyser(settings)
    shaper, n_bins = shaper_of(settings, analyser.scale[0]), settings.n_bins
    kept = settings.time_smooth if settings.has(Filter.TIME_SMOOTH) else 0.0
    n_mel = settings.mel_bands if settings.has(Filter.MEL) else 0
    windows = settings.window_in_force is not WindowFunction.RECTANGLE
    section.whole(settings.step, settings.decimation is Decimation.ANTI_ALIASED)
    section.floats([settings.pre_emphasis if settings.has(Filter.PRE_EMPHASIS) else 0.0, kept, 1 - kept])
    section.floats(settings.denoise_threshold if settings.has(Filter.DENOISE) else 0.0)
    section.whole(settings.has(Filter.NORMALISE), windows, shaper.blurs, n_mel)
    section.floats(window_of(settings.window_in_force, settings.n_samples) if windows else [])
    section.floats(analyser.scale)
    section.floats(shaper.centre)
    section.floats([*shaper.below, *shaper.above] if shaper.blurs else [])
    section.filters(mel_bank(n_mel, n_bins, BIN_WIDTH) if n_mel else np.zeros((n_bins, 0)))
    section.whole(len(variables))
    names = [v.name if isinstance(v, Variable) else v for v in variables]
    centres = {source: np.arange(n_bins, dtype=float) * BIN_WIDTH for source in SOURCES}
    centres[Spectrum.MEL] = mel_edges(n_mel, n_bins * BIN_WIDTH)[1:-1] if n_mel else np.zeros(0)
    for v in variables:
        if isinstance(v, str):
            section.whole(WHOLE_FRAME[v], 0, 0, 0, 0, 0)
            continue
        reach = reach_of(v, centres[v.source])
        per = names.index(v.per) + 1 if v.per else 0
        section.whole(BAND, SOURCES.index(v.source), KINDS.index(v.kind), max(reach.stop, reach.start))
        section.whole(reach.start, per)
    return "FRNT", section


def _rules(asked: RuleRecogniser, names: list[str]) -> Section:
    section = SectionWriter()
    conditions = list(dict.fromkeys(c for rule in asked.rules for c in rule.conditions))
    section.whole(len(conditions))
    for condition in conditions:
        rises, limit = condition.sign == ">", asked.limit_of(condition)
        section.whole(names.index(condition.variable), rises)
        section.floats(limit if rises else -limit)
    section.whole(len(asked.rules))
    for rule in asked.rules:
        section.whole(rule.phoneme, len(rule.conditions), *(conditions.index(c) for c in rule.conditions))
    return "RULE", section


def _decoder(decoder: Decoder) -> Section:
    section = SectionWriter()
    section.whole(len(decoder.phonemes), *decoder.phonemes.tolist())
    section.whole(*(-decoder.evidence).ravel().tolist(), *decoder.costs.ravel().tolist())
    return DECODER, section


def _templates(templates: Templates) -> Section:
    section = SectionWriter()
    scale = (1 / np.array(templates.spread)).astype(np.float32)
    section.floats(templates.silence_below)
    section.whole(len(templates.means), *templates.means)
    section.floats(np.array(list(templates.means.values()), np.float32) * scale)
    section.floats(scale)
    section.floats(cepstral_cosines().T)
    return "TMPL", section
