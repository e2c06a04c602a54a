"""What is damaged: good files of each kind, and what reads them."""

import io
import json
import struct
import zipfile
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from random import Random

import numpy as np
import soundfile

from phonemeanalyser.server.access import ServerLimits
from phonemeanalyser.server.messages import later_words_of, start_of
from phonemeanalyser.server.repertoire import Repertoire
from phonemeengine.audio.files import SoundReader
from phonemeengine.audio.incoming import Encoding, IncomingSound, StreamFormat
from phonemeengine.labels.pinyin import timed_syllable
from phonemeengine.labels.textgrid import format_tiers
from phonemeengine.labels.timed_words import read_timed_words
from phonemeengine.labels.utterance import Phone, Syllable, Utterance, Word
from phonemeengine.labels.utterance_files import format_utterance, read_utterance
from phonemeengine.mouth.curves_file import read_curves
from phonemeengine.mouth.exports.livelink import lines_of
from phonemeengine.mouth.expression.streams import SHIPPED as EXPRESSIONS
from phonemeengine.mouth.expression.streams import SHIPPED_CHANNELS as CHANNELS
from phonemeengine.mouth.expression.streams import load_channels, load_expressions
from phonemeengine.mouth.files.gltf import parse_gltf
from phonemeengine.mouth.files.gltf_writing import format_glb, format_points
from phonemeengine.mouth.files.obj import parse_obj
from phonemeengine.mouth.files.threedm import format_3dm, format_3dma, parse_3dm, parse_3dma
from phonemeengine.mouth.files.x_file import parse_x
from phonemeengine.mouth.morph_mesh import morph_targets_of
from phonemeengine.mouth.movestate import MovestateSet
from phonemeengine.mouth.poses import USUAL_POSES, load_poses
from phonemeengine.mouth.table import TABLES, load_table
from phonemeengine.performance.choice import ExampleChoice
from phonemeengine.performance.driver import PerformanceDriver, PerformanceOptions
from phonemeengine.performance.face_csv import read_face_csv
from phonemeengine.performance.face_track import read_vmc
from phonemeengine.performance.gltf_face import parse_gltf_face
from phonemeengine.performance.head_driver import HeadDriver
from phonemeengine.performance.keywords import USUAL_KEYWORDS, load_keywords
from phonemeengine.performance.recording import HEAD, phones_of
from phonemeengine.performance.table_file import PerformanceTable, write_table
from phonemeengine.performance.units import UnitKind
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import DEFAULT_PRESET, FACTORY, load_preset
from phonemeengine.recognition.model import load_model, save_model
from phonemeengine.shipping.targets import format_ear
from phonemeengine.speech.pinyin.table import USUAL_PINYIN_TABLE, load_pinyin_table
from phonemeengine.text.espeak import language_of
from phonemeengine.text.lexicon import load_lexicon
from phonemeengine.text.pronunciation import notes_on
from phonemeengine.text.respelling import respelt
from phonemeengine.text.script import load_script
from tests.containers import contained
from tests.ear_probe import HEADER, EarProbe, with_true_header
from tests.engine.performance.corpora import PHONES, SYLLABLES
from tests.engine.performance.faces import animated_face, ramp, recorded_vmc
from tests.engine.performance.sentences import performance_of, phones_in
from tests.meshes import CUBE_OBJ, CUBE_X, FRAMES_X, GLTF_TEXT, LIBRARY, morph_mesh_of_cube
from tests.models import tone_model
from tests.sounds import tone
from tools.fuzz.mutation import mutated

Read = Callable[[bytes], object]

LEXICON = """format = "phonemeanalyser lexicon 1"

[words]
NASA = "ˈnæ.sə"
Zug = "tsuːk"
either = ["ˈiːðɚ", "ˈaɪðɚ"]
"""
LEXICON_ROWS = "word,ipa\nNASA,ˈnæ.sə\nZug,tsuːk\neither,ˈiːðɚ\neither,ˈaɪðɚ\n"
CURVES = """{"format": "phonemeanalyser curves 1", "sound": "a.wav", "duration": 0.1, "rate": 20, "table": "arkit",
 "cues": [{"start": 0, "end": 0.1, "phoneme": "a", "shape": "a", "intensity": 0.5, "phone": "ɑ"}],
 "words": [{"start": 0, "end": 0.1, "word": "ah"}],
 "curves": [{"name": "jawOpen", "values": [0, 0.5, 1]}, {"name": "mouthClose", "values": [0, 0, 0.25]}],
 "head": [{"name": "pitch", "values": [0, 1, 2]}]}
"""
TIMED = (
    '{"segments": [{"words": [{"word": " Hi,", "start": 0.5, "end": 0.9}, {"word": " 7"}], "speaker": "A"}]}',
    '{"NBest": [{"Words": [{"Word": "hi", "Offset": 5000000, "Duration": 4000000}]}]}',
    '{"alignment": {"characters": ["a", " "], "character_start_times_seconds": [0, 0.1],'
    ' "character_end_times_seconds": [0.1, 0.2]}}',
)
SCRIPT = "Es regnet, aber der See ist leer.\nUnd 1984? [[ <b> 你好。\n"
SCRIPT_TABLE = "a.wav\tEs regnet.\nfolder/b.wav\tDer See ist leer.\na.wav\tUnd 1984?\n"
START = b'{"encoding": "f32", "rate": 44100, "channels": 2, "table": "vrm", "language": "de", "text": "Guten Tag."}'
LATER = b'{"text": "Wie geht es?", "end": true}'
SAID = Utterance(
    (
        Word("你好", (timed_syllable("ni3", 0.1, 0.2, 0.3), timed_syllable("hao3", 0.3, 0.4, 0.7))),
        Word("so", (Syllable((Phone(0.9, 1.0, "s", Phoneme.SZ), Phone(1.0, 1.4, "oʊ", Phoneme.O))),)),
    ),
    2.0,
)


@dataclass(frozen=True)
class Kind:
    """Good files, what reads one, what brings a damaged one past the first check, and how long its head is."""

    good: tuple[bytes, ...]
    read: Read
    dress: Callable[[bytes], bytes] = bytes
    head: int = 0

    def damaged(self, chance: Random) -> bytes:
        """Give a damaged file."""
        return self.dress(mutated(chance.choice(self.good), self.good, chance, self.head))


def kinds(folder: Path) -> dict[str, Kind]:
    """Give all kinds; those that are read from a path are written into a folder."""
    morph_mesh = morph_mesh_of_cube()
    face = morph_targets_of(morph_mesh.mesh, morph_mesh.states)
    glb, points = format_glb(morph_mesh), format_points(face)
    text, blob = _parts_of(glb)
    moving = animated_face(["jawOpen", "mouthClose"], [[0, 0], [1, 0.5], [0.5, 0]])
    moving_text, moved = _parts_of(moving)
    model = folder / "good.npz"
    save_model(tone_model({1000.0: Phoneme.A}, n_heads=1), model)
    presets = tuple((FACTORY / f"{name}.toml").read_bytes() for name in ("thesis", "extended"))
    tables = tuple((TABLES / f"{name}.toml").read_bytes() for name in ("five", "eleven"))
    utterances = tuple(format_utterance(SAID, silence).encode() for silence in ("", "sil"))
    old = (b"0,0,5,7,0\n" + b"1,2,3,4\n" * 4,)
    return {
        "3dm": Kind((format_3dm(face), format_3dm(morph_targets_of(morph_mesh.mesh, []))), _morph_3dm, head=10),
        "3dma": Kind((format_3dma(face), format_3dma(morph_targets_of(morph_mesh.mesh, []))), parse_3dma, head=7),
        "x": Kind((CUBE_X, FRAMES_X), parse_x, head=17),
        "obj": Kind((CUBE_OBJ, LIBRARY), lambda content: parse_obj(content, lambda _name: content)),
        "glb": Kind((glb, points), parse_gltf),
        "gltf": Kind((GLTF_TEXT,), lambda content: parse_gltf(content, lambda _name: content)),
        "gltf in glb": Kind((text, GLTF_TEXT), parse_gltf, lambda content: _glb_of(content, blob)),
        "toml": Kind(presets, _through(folder / "preset.toml", load_preset)),
        "mouth table": Kind(tables, _through(folder / "table.toml", load_table)),
        "pinyin table": Kind((USUAL_PINYIN_TABLE.read_bytes(),), _through(folder / "pinyin.toml", load_pinyin_table)),
        "expression channels": Kind((CHANNELS.read_bytes(),), _through(folder / "channels.toml", load_channels)),
        "expressions": Kind((EXPRESSIONS.read_bytes(),), _through(folder / "expressions.toml", load_expressions)),
        "key words": Kind((USUAL_KEYWORDS.read_bytes(),), _through(folder / "keywords.toml", load_keywords)),
        "poses": Kind((USUAL_POSES.read_bytes(),), _through(folder / "poses.toml", load_poses)),
        "face csv": Kind((_livelink(), _openface()), _through(folder / "a.csv", read_face_csv)),
        "curves": Kind((CURVES.encode(),), _through(folder / "a.curves.json", read_curves)),
        "vmc": Kind((recorded_vmc([k / 60 for k in range(20)]).encode(),), _through(folder / "a.osc", read_vmc)),
        "gltf face": Kind((moving,), lambda content: parse_gltf_face(content, "a.glb")),
        "gltf face in glb": Kind(
            (moving_text,), lambda content: parse_gltf_face(content, "a.glb"), lambda content: _glb_of(content, moved)
        ),
        "performed labels": Kind((_labels(),), _through(folder / "a.TextGrid", _performed)),
        "performance table": Kind((_table(folder / "good.sqlite"),), _through(folder / "t.sqlite", _looked_through)),
        "lexicon": Kind((LEXICON.encode(),), _through(folder / "lexicon.toml", _say_lexicon)),
        "lexicon as table": Kind((LEXICON_ROWS.encode(),), _through(folder / "lexicon.csv", _say_lexicon)),
        "script": Kind((SCRIPT.encode(), SCRIPT_TABLE.encode()), _through(folder / "script.txt", _find_texts)),
        "utterance": Kind(utterances, _through(folder / "said.TextGrid", lambda path: read_utterance(path, 2.0))),
        "timed words": Kind(
            tuple(map(str.encode, TIMED)), _through(folder / "words.json", lambda path: read_timed_words(path, 2.0))
        ),
        "phonemedata": Kind(old, _through(folder / "old.phonemedata", load_preset)),
        "opus as it comes": Kind((_opus(),), _read_opus),
        "sound in a container": Kind(_containers(), _through(folder / "a.mp4", _read_file_of), head=12),
        "sound without a count": Kind(_uncounted(), _through(folder / "a.mp3", _read_file_of)),
        "message of a stream": Kind((START, LATER), _understood),
        "npz": Kind((model.read_bytes(),), _through(folder / "model.npz", load_model)),
        "ear": Kind((_ear("thesis"), _ear("templates")), EarProbe().read, with_true_header, head=HEADER),
        "arrays in npz": Kind(_members(model), _through(folder / "model.npz", load_model), _Zipped(model), head=128),
    }


def _morph_3dm(content: bytes) -> object:
    """Read movestates, and use them as the head would."""
    face, mesh = parse_3dm(content), morph_mesh_of_cube().mesh
    fitting = [state for state in face.states if not len(state) or state.numbers[-1] < len(mesh)]
    states = MovestateSet(mesh, fitting)
    for state in fitting:
        states.set_percentage(state.name, 100)
    return states.morphed()


def _say_lexicon(path: Path) -> object:
    """Read a lexicon, and ask a voice for what it says."""
    spellings = load_lexicon(path).spellings.values()
    return [respelt(ipa, language_of("de")) for variants in spellings for ipa in variants]


def _find_texts(path: Path) -> object:
    """Read a script, and look for the texts of two sounds."""
    script = load_script(path)
    texts, _notes = script.texts_of([Path("a.wav"), Path("folder/b.wav")][: 2 if script.texts else 1])
    return [notes_on(text, "de") for text in texts.values()]


def _through(path: Path, read: Callable[[Path], object]) -> Read:
    def write_and_read(content: bytes) -> object:
        path.write_bytes(content)
        return read(path)

    return write_and_read


def _read_opus(content: bytes) -> object:
    """Analyse a stream of Ogg Opus, as it comes."""
    sound = IncomingSound(StreamFormat(Encoding.OPUS))
    return [sum(map(len, sound.pieces(content))), sound.finish()]


def _read_file_of(path: Path) -> object:
    """Analyse a sound file, its end first."""
    with SoundReader(path) as reader:
        reader.seek(reader.n_samples - 1000)
        n_last = len(reader.read_mono())
        reader.seek(0)
        return n_last, sum(map(len, reader.blocks(10_000)))


def _containers() -> tuple[bytes, ...]:
    kinds = (("ipod", "aac"), ("mov", "pcm_s16le"), ("adts", "aac"), ("matroska", "flac"), ("asf", "wmav2"))
    return tuple(contained(tone(440, 0.5), *kind, pictures=kind[0] == "mov") for kind in kinds)


def _uncounted() -> tuple[bytes, ...]:
    """MP3 and FLAC as programs write them to a pipe."""
    mp3 = contained(tone(440, 0.5), "mp3", "libmp3lame", options={"write_xing": "0"})
    file = io.BytesIO()
    soundfile.write(file, tone(440, 0.5), 44_100, format="FLAC")
    flac = bytearray(file.getvalue())
    flac[21:26] = b"\xf0\0\0\0\0"
    return mp3, bytes(flac)


@cache
def _repertoire() -> Repertoire:
    return Repertoire.of_files([DEFAULT_PRESET], [], ServerLimits())


def _understood(content: bytes) -> object:
    """Read what the client of a stream says, first and later."""
    message = content.decode(errors="replace")
    return start_of(message, _repertoire()) if b"rate" in content else later_words_of(message)


def _opus() -> bytes:
    file = io.BytesIO()
    soundfile.write(file, tone(440, 0.2), 48_000, format="OGG", subtype="OPUS")
    return file.getvalue()


def _livelink() -> bytes:
    return "".join(lines_of(ramp(20))).encode()


def _openface() -> bytes:
    rows = (f"{k / 60:.3f}, 1, 0.1, 0.2, 0.3, {k / 4}, 1.0" for k in range(20))
    return "\n".join(["timestamp, success, pose_Rx, pose_Ry, pose_Rz, AU12_r, AU26_r", *rows]).encode()


def _labels() -> bytes:
    return format_tiers({"words": [(0.2, 0.8, "mami")], "syllables": SYLLABLES, "phones": PHONES}, 1.0).encode()


def _performed(path: Path) -> object:
    return phones_of(read_utterance(path, 1.0))


def _table(path: Path) -> bytes:
    performances = (performance_of("ma.ma tu"), performance_of("pa.pi", 0.2))
    turned = [replace(p, channels=(*p.channels, *HEAD), weights=np.tile(p.weights, 3)[:, :5]) for p in performances]
    write_table(path, turned)
    return path.read_bytes()


def _looked_through(path: Path) -> object:
    """Open a table, ask it for all that it has, and have it say a sentence."""
    sentence, times = phones_in("ma.pi tu"), np.arange(60) / 60
    with PerformanceTable.open(path) as table:
        for choice in ExampleChoice:
            driver = PerformanceDriver(table, PerformanceOptions(choice))
            assert np.isfinite(driver.weights(sentence, 0, times, 1 / 60)).all()
        assert np.isfinite(HeadDriver(table, ("Ma", "yes", "no"), "en").track(sentence, times)).all()
        found = [
            table.nearest(kind, names, 0.2, 10) + table.within(kind, names, 0.1, 0.5)
            for kind in UnitKind
            for names in table.names(kind)
        ]
        return found, table.n_units(), [table.recording(number) for number, _ in table.recordings()]


class _Zipped:
    """Puts a damaged array into an otherwise good archive, each time in place of another one."""

    def __init__(self, model: Path) -> None:
        with zipfile.ZipFile(model) as archive:
            self._members = {name: archive.read(name) for name in archive.namelist()}

    def __call__(self, content: bytes) -> bytes:
        names = list(self._members)
        chosen = names[len(content) % len(names)]
        out = io.BytesIO()
        with zipfile.ZipFile(out, "w") as archive:
            for name, member in self._members.items():
                archive.writestr(name, content if name == chosen else member)
        return out.getvalue()


def _members(model: Path) -> tuple[bytes, ...]:
    with zipfile.ZipFile(model) as archive:
        return tuple(archive.read(name) for name in archive.namelist())


def _ear(name: str) -> bytes:
    return format_ear(load_preset(name), ("five",))


def _parts_of(glb: bytes) -> tuple[bytes, bytes]:
    (size,) = struct.unpack_from("<I", glb, 12)
    return json.dumps(json.loads(glb[20 : 20 + size])).encode(), glb[28 + size :]


def _glb_of(text: bytes, blob: bytes) -> bytes:
    text += b" " * (-len(text) % 4)
    head = b"glTF" + struct.pack("<II", 2, 28 + len(text) + len(blob)) + struct.pack("<I4s", len(text), b"JSON")
    return head + text + struct.pack("<I4s", len(blob), b"BIN\0") + blob
