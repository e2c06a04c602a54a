"""What is damaged: good files of each kind, and what reads them."""

import io
import json
import struct
import zipfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from random import Random

from phonemeengine.labels.pinyin import timed_syllable
from phonemeengine.labels.utterance import Phone, Syllable, Utterance, Word
from phonemeengine.labels.utterance_files import format_utterance, read_utterance
from phonemeengine.mouth.files.gltf import parse_gltf
from phonemeengine.mouth.files.gltf_writing import format_glb, format_points
from phonemeengine.mouth.files.obj import parse_obj
from phonemeengine.mouth.files.threedm import format_3dm, parse_3dm
from phonemeengine.mouth.files.threedma import format_3dma, parse_3dma
from phonemeengine.mouth.files.x_file import parse_x
from phonemeengine.mouth.morph_mesh import morph_targets_of
from phonemeengine.mouth.movestate_set import MovestateSet
from phonemeengine.mouth.table import TABLES, load_table
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import FACTORY, load_preset
from phonemeengine.recognition.model import load_model, save_model
from phonemeengine.speech.pinyin.table import USUAL_PINYIN_TABLE, load_pinyin_table
from phonemeengine.text.espeak import language_of
from phonemeengine.text.lexicon import load_lexicon
from phonemeengine.text.pronunciation import notes_on
from phonemeengine.text.respelling import respelt
from phonemeengine.text.script import load_script
from tests.meshes import CUBE_OBJ, CUBE_X, FRAMES_X, GLTF_TEXT, LIBRARY, morph_mesh_of_cube
from tests.models import tone_model
from tools.fuzz.mutation import mutated

Read = Callable[[bytes], object]

LEXICON = """format = "phonemeanalyser lexicon 1"

[words]
NASA = "ˈnæ.sə"
Zug = "tsuːk"
either = ["ˈiːðɚ", "ˈaɪðɚ"]
"""
LEXICON_ROWS = "word,ipa\nNASA,ˈnæ.sə\nZug,tsuːk\neither,ˈiːðɚ\neither,ˈaɪðɚ\n"
SCRIPT = "Es regnet, aber der See ist leer.\nUnd 1984? [[ <b> 你好。\n"
SCRIPT_TABLE = "a.wav\tEs regnet.\nfolder/b.wav\tDer See ist leer.\na.wav\tUnd 1984?\n"
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
        "lexicon": Kind((LEXICON.encode(),), _through(folder / "lexicon.toml", _say_lexicon)),
        "lexicon as table": Kind((LEXICON_ROWS.encode(),), _through(folder / "lexicon.csv", _say_lexicon)),
        "script": Kind((SCRIPT.encode(), SCRIPT_TABLE.encode()), _through(folder / "script.txt", _find_texts)),
        "utterance": Kind(utterances, _through(folder / "said.TextGrid", lambda path: read_utterance(path, 2.0))),
        "phonemedata": Kind(old, _through(folder / "old.phonemedata", load_preset)),
        "npz": Kind((model.read_bytes(),), _through(folder / "model.npz", load_model)),
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


def _parts_of(glb: bytes) -> tuple[bytes, bytes]:
    (size,) = struct.unpack_from("<I", glb, 12)
    return json.dumps(json.loads(glb[20 : 20 + size])).encode(), glb[28 + size :]


def _glb_of(text: bytes, blob: bytes) -> bytes:
    text += b" " * (-len(text) % 4)
    head = b"glTF" + struct.pack("<II", 2, 28 + len(text) + len(blob)) + struct.pack("<I4s", len(text), b"JSON")
    return head + text + struct.pack("<I4s", len(blob), b"BIN\0") + blob
