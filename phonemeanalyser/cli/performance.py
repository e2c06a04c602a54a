"""``phonemeanalyser performance``: tables of recorded faces, and a synthetic performer to try them with."""

import argparse
import sys
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TypeAlias

from tqdm import tqdm

from phonemeanalyser.cli.arguments import add_clip, add_examples, add_options
from phonemeanalyser.cli.jobs import say_note
from phonemeanalyser.cli.parser import file_place, number, number_in, whole_in
from phonemeanalyser.cli.requirements import module_that_draws
from phonemeengine import PerformanceTable, Progress, TextError, Voice, build_table, make_corpus, speak
from phonemeengine.errors import ModelError
from phonemeengine.mouth.style import save_style
from phonemeengine.mouth.table import table_to_toml
from phonemeengine.performance import face_learning
from phonemeengine.performance.corpus import BuiltTable
from phonemeengine.performance.face_network import owns, save_face_network
from phonemeengine.performance.making import sentences
from phonemeengine.performance.style_fit import fit_style
from phonemeengine.performance.table_file import TableAbout
from phonemeengine.presets.files import DEFAULT_PRESET, load_preset
from phonemeengine.storage.files import printable_name, read_text_file
from phonemeengine.storage.replacing import Guard, guarded_text, nothing_is_own, write_guarded

USUAL_MINUTES, MOST_MINUTES = 15.0, 600.0
BAR = "{desc}: {n:.0f} %|{bar}| {elapsed}"
LARGEST = 4 << 20
"""Bytes of a file of sentences."""
Kinds: TypeAlias = "argparse._SubParsersAction[argparse.ArgumentParser]"

EXAMPLES = (
    "phonemeanalyser performance make recorded --minutes 0.2",
    "phonemeanalyser performance build recorded -o face.sqlite",
    "phonemeanalyser performance info face.sqlite",
)
EXAMPLES_OF = {
    "make": (
        "phonemeanalyser performance make recorded --minutes 0.6",
        "phonemeanalyser performance make other --minutes 0.1 --seed 7",
        "phonemeanalyser performance make mine --minutes 0.1 --sentences lines.txt --language en-gb",
    ),
    "build": (
        "phonemeanalyser performance build recorded -o face.sqlite",
        "phonemeanalyser performance build other -o other.sqlite --name Ada --person Ada --language en-us",
        "phonemeanalyser performance build mine -o face.sqlite --overwrite",
    ),
    "learn": (
        "phonemeanalyser performance learn recorded -o recorded.face",
        "phonemeanalyser performance learn recorded -o ada.face --name Ada",
        "phonemeanalyser performance learn recorded -o recorded.face --overwrite",
    ),
    "info": (
        "phonemeanalyser performance info face.sqlite",
        "phonemeanalyser performance info other.sqlite",
        "phonemeanalyser performance info face.sqlite --log log.txt",
    ),
    "pca": (
        "phonemeanalyser performance pca face.sqlite -o small.sqlite",
        "phonemeanalyser performance pca face.sqlite -o smaller.sqlite --explained 95 --rig rig.toml",
        "phonemeanalyser performance pca other.sqlite -o small.sqlite --overwrite",
    ),
    "show": (
        "phonemeanalyser performance show face.sqlite synthetic0001 -o whole.gif --size 64x64 --fps 5",
        "phonemeanalyser performance show face.sqlite synthetic0001 -o start.mp4 --to 0.4",
        "phonemeanalyser performance show face.sqlite synthetic0001 -o frames --from 0.2 --to 0.4 --fps 25",
    ),
    "style": (
        "phonemeanalyser performance style face.sqlite -o face.toml",
        "phonemeanalyser performance style face.sqlite synthetic0001 -o one.toml",
        "phonemeanalyser performance style other.sqlite -o face.toml --overwrite",
    ),
}
"""Examples of what is done with performances; each uses the files of those before it."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what is to be done with recorded performances."""
    parser.epilog = (
        "A recording is NAME.wav, NAME.TextGrid (tiers phones, words, syllables) and NAME.csv of Live Link Face or "
        "OpenFace; or NAME.glb, or NAME.osc of VMC messages, in place of the latter. See performance WHAT --help."
    )
    kinds = parser.add_subparsers(required=True, metavar="WHAT")
    for add in (_add_build, _add_learn, _add_info, _add_pca, _add_show, _add_make, _add_style):
        add(kinds)
    add_examples(kinds, EXAMPLES_OF)


def _add_build(kinds: Kinds) -> None:
    parser = kinds.add_parser("build", help="make a table", description="Make a table from a folder of recordings.")
    parser.add_argument("folder", type=Path, metavar="FOLDER", help="folder of recordings")
    parser.add_argument("-o", "--out", type=file_place, required=True, metavar="T.sqlite", help="the table")
    parser.add_argument("--name", metavar="NAME", help="name of the table (default: the folder's)")
    parser.add_argument("--person", metavar="NAME", help="who speaks (default: as corpus.toml says)")
    parser.add_argument("--language", metavar="L", help="language of the recordings (default: as corpus.toml says)")
    add_options(parser, "overwrite")
    parser.set_defaults(act=_build)


def _add_learn(kinds: Kinds) -> None:
    parser = kinds.add_parser(
        "learn",
        help="learn a face from the sound alone",
        description="Learn a network that moves a face by the sound alone, without phonemes; see --face-network.",
    )
    parser.add_argument("folder", type=Path, metavar="FOLDER", help="folder of recordings")
    parser.add_argument("-o", "--out", type=file_place, required=True, metavar="N.face", help="the network")
    parser.add_argument("--name", metavar="NAME", help="name of the network (default: the folder's)")
    add_options(parser, "preset", "overwrite")
    parser.set_defaults(act=_learn)


def _add_info(kinds: Kinds) -> None:
    parser = kinds.add_parser("info", help="list a table", description="List what a table holds.")
    parser.add_argument("table", type=Path, metavar="T.sqlite", help="the table")
    parser.set_defaults(act=_info)


def _add_pca(kinds: Kinds) -> None:
    parser = kinds.add_parser(
        "pca",
        help="store principal components",
        description="Store principal components in place of blend shapes: the same faces, in a smaller table.",
    )
    parser.add_argument("table", type=Path, metavar="T.sqlite", help="the table")
    parser.add_argument(
        "-o", "--out", type=file_place, required=True, metavar="SMALL.sqlite", help="the smaller table"
    )
    parser.add_argument(
        "--explained",
        type=number_in(1, 100, "percent"),
        default=100 * face_learning.USUAL_SHARE,
        metavar="P",
        help=f"percent of the variance that the components explain (default: {100 * face_learning.USUAL_SHARE:g})",
    )
    parser.add_argument(
        "--rig",
        type=file_place,
        metavar="RIG.toml",
        help="write a mouth table for a rig with a shape for each component, for --table",
    )
    add_options(parser, "overwrite")
    parser.set_defaults(act=_pca)


def _add_show(kinds: Kinds) -> None:
    parser = kinds.add_parser("show", help="render a recording", description="Render a recorded face with its sound.")
    parser.add_argument("table", type=Path, metavar="T.sqlite", help="the table")
    parser.add_argument("recording", metavar="RECORDING", help="name of the recording, as in --units")
    parser.add_argument("--from", dest="start", type=number, metavar="S", help="start, seconds (default: its start)")
    parser.add_argument("--to", dest="end", type=number, metavar="S", help="end, seconds (default: its end)")
    add_clip(parser)
    add_options(parser, "overwrite")
    parser.set_defaults(act=_show)


def _add_make(kinds: Kinds) -> None:
    parser = kinds.add_parser(
        "make", help="make synthetic recordings", description="Make recordings of a synthetic performer, for tests."
    )
    parser.add_argument("folder", type=Path, metavar="FOLDER", help="new folder for the recordings")
    minutes = number_in(0.01, MOST_MINUTES, "minutes")
    parser.add_argument(
        "--minutes", type=minutes, default=USUAL_MINUTES, metavar="M", help="minutes of speech (default: 15)"
    )
    parser.add_argument(
        "--seed", type=whole_in(0), default=0, metavar="N", help="seed of random variation (default: 0)"
    )
    parser.add_argument("--sentences", type=Path, metavar="F", help="text file (UTF-8) with one sentence per line")
    parser.add_argument("--language", default="en-us", metavar="L", help="language of the sentences (default: en-us)")
    parser.set_defaults(act=_make)


def _add_style(kinds: Kinds) -> None:
    parser = kinds.add_parser(
        "style", help="fit a style", description="Fit a style of speaking, by which rules speak as recorded faces do."
    )
    parser.add_argument("table", type=Path, metavar="T.sqlite", help="the table")
    parser.add_argument("recordings", nargs="*", metavar="RECORDING", help="names of recordings (default: the first)")
    parser.add_argument("-o", "--out", type=file_place, required=True, metavar="STYLE.toml", help="the style")
    add_options(parser, "overwrite")
    parser.set_defaults(act=_style)


def run(options: argparse.Namespace) -> int:
    """Run the command; returns its exit code."""
    lines: list[str] = list(options.act(options))
    with guarded_text(None) as file:
        file.writelines(f"{line}\n" for line in lines)
    return 0


def _build(options: argparse.Namespace) -> Iterator[str]:
    Guard(nothing_is_own, options.overwrite).check(options.out)
    with _progress(options.folder) as progress:
        built = build_table(
            options.folder,
            options.out,
            name=options.name,
            person=options.person,
            language=options.language,
            progress=progress,
        )
    _say_notes(options.folder, built)
    yield _summary(options.out, built.about)


def _learn(options: argparse.Namespace) -> Iterator[str]:
    Guard(owns, options.overwrite).check(options.out)
    preset = load_preset(options.preset)
    if preset.model is None:
        raise ModelError(f"{preset.name}: this preset has no network to learn on; choose {DEFAULT_PRESET.stem}")
    with _progress(options.folder) as progress:
        learned = face_learning.learn_face(options.folder, preset.model, name=options.name, progress=progress)
    _say_notes(options.folder, learned)
    save_face_network(learned.network, options.out, overwrite=options.overwrite)
    about = learned.network.about
    yield (
        f"{options.out.name}: {learned.network.title}, from {about['seconds'] / 60:.1f} minutes; error "
        f"{learned.error:.3f} on {about['left_out']} recordings that were left out ({learned.still:.3f} for a face "
        "that stays at its mean)"
    )


def _say_notes(folder: Path, found: BuiltTable | face_learning.LearnedFace) -> None:
    for sentence in found.left_out:
        say_note(printable_name(folder), f"a recording is left out: {sentence}")
    for note in found.notes:
        say_note(printable_name(folder), note)


def _info(options: argparse.Namespace) -> Iterator[str]:
    with PerformanceTable.open(options.table) as table:
        about = table.about
        yield _summary(options.table, about)
        if who := ", ".join(filter(None, (about.person, about.language))):
            yield who
        yield f"{len(about.channels)} channels at {about.rate:g} frames a second"
        for kind, n in table.n_units().items():
            yield f"{kind.value:<20}  {n:8} units of {len(table.names(kind))} kinds"


def _pca(options: argparse.Namespace) -> Iterator[str]:
    guard = Guard(nothing_is_own, options.overwrite)
    guard.check(options.out)
    guard.check(options.rig)
    with PerformanceTable.open(options.table) as table:
        basis = face_learning.principal_components(
            (found for _, found in table.recordings()), options.explained / 100
        )
        about = face_learning.reduce_table(table, options.out, basis)
        with PerformanceTable.open(options.out) as small:
            pairs = zip(table.recordings(), small.recordings(), strict=True)
            error = face_learning.rms_between((before, after) for (_, before), (_, after) in pairs)
        if options.rig is not None:
            text = table_to_toml(face_learning.component_table(basis, options.rig.stem))
            write_guarded(options.rig, [text.encode()], guard)
    yield _summary(options.out, about)
    n, n_shapes = basis.components.shape
    yield f"{n} principal components in place of {n_shapes} shapes, which differ by {error:.4f} RMS"


def _style(options: argparse.Namespace) -> Iterator[str]:
    Guard(nothing_is_own, options.overwrite).check(options.out)
    with PerformanceTable.open(options.table) as table, _progress(options.table) as progress:
        named = map(table.recording_called, options.recordings)
        takes = named if options.recordings else (performance for _, performance in table.recordings())
        fitted = fit_style(takes, options.out.stem, progress)
    save_style(fitted.style, options.out)
    yield (
        f"{options.out.name}: reach {fitted.style.movement.reach:.2f}, times {fitted.speed:.2f}, closures "
        f"{fitted.width:.2f}, asymmetry {fitted.style.asymmetry:.2f}"
    )
    yield f"{fitted.seconds:.0f} s; the rules differ by {fitted.after:.3f} RMS, neutral ones by {fitted.before:.3f}"


def _show(options: argparse.Namespace) -> Iterator[str]:
    module_that_draws("recording_clip").write_recording_clip(options)
    yield from ()


def _make(options: argparse.Namespace) -> Iterator[str]:
    voice = Voice(options.language)
    read = sentences(options.seed) if options.sentences is None else _sentences_in(options.sentences)
    with _progress(options.folder) as progress:
        made = make_corpus(
            options.folder,
            read,
            lambda text: speak(text, voice),
            seconds=60 * options.minutes,
            seed=options.seed,
            language=options.language,
            progress=progress,
        )
    yield f"{options.folder}: {made.n_recordings} synthetic recordings, {made.duration / 60:.1f} minutes"


def _sentences_in(path: Path) -> Iterable[str]:
    lines = read_text_file(path, LARGEST, "a file of sentences", TextError).split("\n")
    return [line.strip() for line in lines if line.strip()]


def _summary(path: Path, about: TableAbout) -> str:
    name = f"{about.name!r}, synthetic" if about.synthetic else repr(about.name)
    length = f"{about.n_recordings} recordings, {about.duration / 60:.1f} minutes"
    return f"{path.name}: {name}, {length}, {path.stat().st_size / 1e6:.1f} MB"


@contextmanager
def _progress(folder: Path) -> Iterator[Progress]:
    """Give what shows how much is done, where the work is long; the work always goes on."""
    with tqdm(
        total=100, desc=printable_name(folder), delay=1, leave=False, disable=None, file=sys.stderr, bar_format=BAR
    ) as bar:

        def show(share: float) -> bool:
            bar.update(100 * share - bar.n)
            return True

        yield show
