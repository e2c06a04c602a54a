"""How sounds are exported: what they become, what recognises them, and how a face moves."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import QSettings, Signal
from PySide6.QtWidgets import QCheckBox, QComboBox, QFormLayout, QSpinBox, QWidget

from phonemeanalyser.colours import DARK, LIGHT
from phonemeanalyser.desktop.engine_words import table_title
from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.session.exports import CLIPS, EXPORT_KINDS, ExportOrder, FaceInUse
from phonemeanalyser.desktop.settings import read
from phonemeanalyser.desktop.talk import mouth_table
from phonemeanalyser.desktop.talk.head.face_model import HEADS
from phonemeanalyser.desktop.widgets.builders import choice, named
from phonemeanalyser.desktop.widgets.fields import NumberField
from phonemeanalyser.desktop.widgets.file_asker import FileAsker
from phonemeanalyser.desktop.widgets.preset_picker import PresetChoice, Sections
from phonemeanalyser.rendering.clip_options import USUAL_CLIP, ClipOptions
from phonemeengine.conversion.driving import USUAL_DRIVER, DriverChoice
from phonemeengine.conversion.options import CLIP_EDGES, OPTIONS
from phonemeengine.conversion.spoken_texts import NO_TEXTS, SpokenTexts
from phonemeengine.conversion.work import Conversion
from phonemeengine.mouth.animation import FaceDriver
from phonemeengine.mouth.cues import MINIMUM
from phonemeengine.mouth.exports.exporter import ExportOptions
from phonemeengine.mouth.exports.formats import FORMATS
from phonemeengine.mouth.morph_mesh import USUAL_HEAD, Framing
from phonemeengine.mouth.morpher import Detail
from phonemeengine.mouth.table import shipped_tables
from phonemeengine.presets.files import load_preset
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import Channel

USUAL = tr_noop("Format default")
ON_TALK = "Same as Talk"
"""Chosen where it is as the Talk page has it."""
ON_TALK_WORDS = tr_noop("Same as Talk: {name}")
VIEWS = {Framing.MOUTH: tr_noop("Mouth"), Framing.FACE: tr_noop("Face"), Framing.BUST: tr_noop("Bust")}
GROUNDS = {LIGHT.name: (LIGHT, tr_noop("Light")), DARK.name: (DARK, tr_noop("Dark"))}
"""What is behind heads of clips, and what people call it."""


class ExportChoices(QFormLayout):
    """A row for each choice that makes a difference to the kind that is chosen.

    Parameters
    ----------
    preset, channel : what is recognised with, unless another preset is chosen, and of what.
    sounds : of which the window may know the words.
    presets : gives others to choose from, by heading.
    face : what the Talk page holds; its text is exported where it is the source.
    files : asks for any other preset.

    Attributes
    ----------
    kind, preset, timing, driver, table, mesh, expression, rate, minimum, anticipation, detail, blinks, head, seed :
        choices.
    width, height, view, ground : choices for clips.

    Signals
    -------
    changed : the sounds become something else.
    """

    changed = Signal()

    def __init__(
        self,
        preset: Preset,
        channel: Channel,
        sounds: list[Path],
        settings: QSettings,
        presets: Callable[[], Sections],
        face: FaceInUse,
        files: FileAsker,
    ) -> None:
        super().__init__()
        self._preset, self._channel, self._settings, self._face = preset, channel, settings, face
        self._make_choices()
        self.preset = PresetChoice(preset.name, presets, files)
        self._offer_timing(sounds)
        self._lay_out()
        self.kind.currentIndexChanged.connect(self.show_kind)
        self.timing.currentIndexChanged.connect(self.show_kind)

    @property
    def chosen(self) -> Conversion:
        """What the sounds become."""
        return EXPORT_KINDS[self.kind.currentData()]

    @property
    def is_text(self) -> bool:
        """Whether the current text is exported, and no sound."""
        return self._face.speech is not None

    def order(self) -> ExportOrder:
        """Return what the sounds are turned into.

        Raises
        ------
        EngineError : the preset that is chosen cannot be loaded.
        """
        path = self.preset.path
        preset = self._preset if path is None else load_preset(path)
        kind, talk, timing = self.chosen, self._face, self.timing.currentData()
        chosen = talk.driver if self.driver.currentData() == ON_TALK else DriverChoice(FaceDriver.RULES)
        driver = chosen if self._drives else USUAL_DRIVER
        return ExportOrder(
            kind.name,
            preset,
            self._options(kind.options),
            self._channel,
            timing,
            driver,
            talk.movestates if self.mesh.currentData() == ON_TALK else None,
            talk.speech,
            talk.keys if "keys" in kind.options and not self.is_text and self.keys.isChecked() else None,
            look=self._look() if kind.name in CLIPS else USUAL_CLIP,
        )

    def show_kind(self) -> None:
        """Show the choices that make a difference to the format, and no others."""
        kind = self.chosen
        options = kind.options
        has_mesh = self.mesh.count() > 1 and (self._face.movestates is None or kind.name not in FORMATS)
        shown: dict[QWidget, bool] = {
            self.table: "table" in options,
            self.rate: "fps" in options,
            self.minimum: "minimum" in options,
            self.anticipation: "anticipation" in options,
            self.detail: "detail" in options,
            self.seed: "seed" in options,
            self.blinks: "no-blinks" in options,
            self.head: "no-head" in options,
            self.keys: "keys" in options and not self.is_text,
            self.driver: "text-driver" in options and self._drives,
            self.mesh: "mesh" in options and has_mesh,
            self.expression: "expression" in options and self._shows_expression,
            self.timing: not self.is_text and kind.has_words,
            self.preset: not self.is_text,
        } | dict.fromkeys((self.width, self.height, self.view, self.ground), kind.name in CLIPS)
        for widget, is_shown in shown.items():
            widget.setEnabled(is_shown)
            self.setRowVisible(widget, is_shown)
        self._offer_table("text-driver" in options)
        self.changed.emit()

    def allow(self, *, on: bool) -> None:
        """Let what is made be chosen, or not, while it is being made."""
        for widget in (self.kind, self.preset):
            widget.setEnabled(on)
        self.timing.setEnabled(on and self.chosen.has_words)

    def _look(self) -> ClipOptions:
        """Return how clips look."""
        ground = self.ground.currentData()
        return ClipOptions(
            (self.width.value(), self.height.value()),
            theme=GROUNDS[ground or LIGHT.name][0],
            framing=Framing(self.view.currentData()),
            transparent=ground is None,
        )

    @property
    def _drives(self) -> bool:
        """Whether what is chosen on Talk can move the mouth: a network by any sound, all else by words."""
        return self.is_text or self.timing.currentData() != NO_TEXTS or self._face.driver.network is not None

    @property
    def _shows_expression(self) -> bool:
        return self._face.options.idle.expression is not None or self._face.options.text_feeling is not None

    def _feels(self, offered: frozenset[str]) -> bool:
        return "expression" in offered and self.expression.currentData() == ON_TALK

    @property
    def _table_on_talk(self) -> str:
        """What the choice of the mouth table of the Talk page is called."""
        return tr(ON_TALK_WORDS).format(name=table_title(self._face.table))

    def _options(self, offered: frozenset[str]) -> ExportOptions:
        """Return how mouths move, by the choices that the format offers."""
        talk, table = self._face.options, self.table.currentData()
        as_on_talk = table == ON_TALK
        idle = replace(
            talk.idle,
            blinks=self.blinks.isChecked(),
            head=self.head.isChecked(),
            seed=self.seed.value(),
            detail=Detail(self.detail.currentData()),
            expression=talk.idle.expression if self._feels(offered) else None,
        )
        anticipation = self.anticipation.value()
        return replace(
            talk if as_on_talk else ExportOptions(),
            rate=(self.rate.value() or None) if "fps" in offered else None,
            minimum=self.minimum.value() if "minimum" in offered else None,
            anticipation=None if anticipation < 0 else anticipation,
            table=talk.table if as_on_talk else table,
            mesh=talk.mesh if "mesh" in offered and self.mesh.currentData() == ON_TALK else None,
            idle=idle,
            style=talk.style,
            text_feeling=talk.text_feeling if self._feels(offered) else None,
        )

    def _make_choices(self) -> None:
        talk = self._face.options
        kinds = [kind for kind in EXPORT_KINDS.values() if not self.is_text or kind.name in FORMATS]
        self.kind = choice((f"{tr(kind.words)} ({kind.name})", kind.name) for kind in kinds)
        self.kind.setCurrentIndex(max(0, self.kind.findData(read(self._settings, "export/kind", "rhubarb-json"))))
        self.timing = QComboBox()
        tables = ((table_title(table), table) for table in shipped_tables())
        self.table = choice([(self._table_on_talk, ON_TALK), (tr(USUAL), None), *tables])
        by_talk = tr(ON_TALK_WORDS).format(name=tr(self._face.driver.driver.caption))
        self.driver = choice([(by_talk, ON_TALK), (tr(FaceDriver.RULES.caption), None)])
        meshes: list[tuple[str, str | None]] = [(tr(HEADS[USUAL_HEAD]), None)]
        if talk.mesh is not None:
            meshes.insert(0, (tr(ON_TALK_WORDS).format(name=Path(talk.mesh).name), ON_TALK))
        self.mesh = choice(meshes)
        self.expression = choice([(tr("Same as Talk"), ON_TALK), (tr("No expression"), None)])
        self.detail = choice((tr(words), detail) for detail, words in mouth_table.DETAILS.items())
        self.detail.setCurrentIndex(self.detail.findData(talk.idle.detail))
        self.rate = _number("fps", unit=" " + tr("frames/s"), decimals=2, below=1.0)
        self.minimum = _number("minimum", unit=" s", decimals=3, step=0.01)
        self.minimum.setValue(MINIMUM)
        self.anticipation = _number("anticipation", unit=" s", decimals=2, step=0.01, below=0.01)
        self.seed = QSpinBox()
        self.seed.setRange(0, 999_999)
        self.seed.setValue(talk.idle.seed)
        self.width, self.height = _edge(USUAL_CLIP.size[0]), _edge(USUAL_CLIP.size[1])
        self.view = choice((tr(words), view) for view, words in VIEWS.items())
        self.view.setCurrentIndex(self.view.findData(USUAL_CLIP.framing))
        grounds = ((tr(words), name) for name, (_, words) in GROUNDS.items())
        self.ground = choice([*grounds, (tr("Transparent (GIF, PNG)"), None)])
        self.blinks, self.head = QCheckBox(tr("Blinks")), QCheckBox(tr("Head motion"))
        self.keys = QCheckBox(tr("Edited keys"))
        self.keys.setChecked(True)
        self.blinks.setChecked(talk.idle.blinks)
        self.head.setChecked(talk.idle.head)

    def _offer_timing(self, sounds: list[Path]) -> None:
        """Offer when words are said: as recognised, as files beside the sounds say, or as the window knows."""
        words = self._face.words
        self.timing.addItem(tr("Recognition only"), NO_TEXTS)
        self.timing.addItem(tr("Text or labels beside each file"), None)
        if words.keys() & {*sounds}:
            n = sum(len(utterance.words) for utterance in words.values())
            self.timing.addItem(tr("Aligned words ({n})").format(n=n), SpokenTexts(self._face.texts, scripts=words))
            self.timing.setCurrentIndex(self.timing.count() - 1)

    def _lay_out(self) -> None:
        rows: tuple[tuple[QWidget, str, str], ...] = (
            (self.kind, tr("Format"), tr("Format of the exported files")),
            (self.preset, tr("Preset"), tr("Preset that recognises the phonemes")),
            (
                self.timing,
                tr("Word timing"),
                tr(
                    "Where words and their times come from: recognition only, the Talk page, or files "
                    "beside the audio files"
                ),
            ),
            (self.driver, tr("Driven by"), tr("What moves the mouth")),
            (self.table, tr("Mouth table"), tr(mouth_table.TABLE_TIP)),
            (self.mesh, tr("Face"), tr("Face mesh of the exported files")),
            (self.expression, tr("Expression"), tr("Expression that the face shows along with the speech")),
            (self.rate, tr("Frame rate"), tr("Frames per second of the exported animation")),
            (
                self.minimum,
                tr("Minimum duration"),
                tr(
                    "Shortest time that a mouth shape lasts; shorter ones are extended or merged with "
                    "their neighbours"
                ),
            ),
            (self.anticipation, tr("Mouth lead"), tr("Time by which the mouth moves before the speech is audible")),
            (self.detail, tr("Level of detail"), tr(mouth_table.DETAIL_TIP)),
            (
                self.seed,
                tr("Random seed"),
                tr("Start value of all random motion; the same number gives the same blinks and head motion again"),
            ),
            (self.width, tr("Width"), tr("Width of the picture, pixels")),
            (self.height, tr("Height"), tr("Height of the picture, pixels")),
            (self.view, tr("View"), tr("How much is in the picture")),
            (self.ground, tr("Background"), tr("What is behind the head; videos cannot be transparent")),
            (self.blinks, "", tr(mouth_table.BLINKS_TIP)),
            (self.head, "", tr(mouth_table.MOTION_TIP)),
            (self.keys, "", tr("Keys edited on the Talk page, or saved beside a recording as NAME.keys.toml")),
        )
        for widget, words, tip in rows:
            self.addRow(words, named(widget, words, tip))
        for box in (self.kind, self.driver, self.table, self.mesh):
            box.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.kind.setMinimumContentsLength(28)

    def _offer_table(self, fits: bool) -> None:
        """Offer the table of Talk, and first, where a format takes the whole face; drawings have their own shapes."""
        place = self.table.findData(ON_TALK)
        if fits and place < 0:
            self.table.insertItem(0, self._table_on_talk, ON_TALK)
            self.table.setCurrentIndex(0)
        elif not fits and place >= 0:
            self.table.removeItem(place)


def _edge(pixels: int) -> QSpinBox:
    """Make the field of an edge of a picture."""
    field = QSpinBox()
    field.setRange(*CLIP_EDGES)
    field.setSuffix(" px")
    field.setValue(pixels)
    return field


def _number(option: str, *, unit: str, decimals: int, step: float = 1.0, below: float = 0.0) -> NumberField:
    """Make the field of an option, with its limits; the value that is so much below them stands for what is usual."""
    low, high = OPTIONS[option].limits or (0.0, 0.0)
    field = NumberField(low - below, high, decimals=decimals, step=step, unit=unit)
    if below:
        field.setSpecialValueText(tr(USUAL))
        field.setValue(low - below)
    return field
