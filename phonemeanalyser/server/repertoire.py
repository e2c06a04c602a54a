"""The presets and mouth tables that clients may name, and those that they send; no client names a file."""

import tempfile
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from phonemeanalyser.server.access import KILOBYTE, RefusedError, ServerLimits
from phonemeengine import EngineError, MouthTable, Preset, load_preset, load_table
from phonemeengine.mouth.table import shipped_tables, table_of
from phonemeengine.presets.document import preset_from_toml
from phonemeengine.presets.files import preset_path


@dataclass(frozen=True)
class Repertoire:
    """What a server recognises with, and what it moves.

    A client gives either the name of one of these, or the text of a file of its own: that has more than one line.
    The limit of its size bounds the work, too: 32 KB of variables and rules take about twice that of ``extended``.

    Attributes
    ----------
    presets : by name; the first one serves clients that name none.
    tables : mouth tables by name.
    preset_files, table_files : what is not loaded here, but by the processes that export files.
    limits : of the server.
    """

    presets: Mapping[str, Preset] = field(default_factory=dict)
    tables: Mapping[str, MouthTable] = field(default_factory=dict)
    preset_files: Mapping[str, Path] = field(default_factory=dict)
    table_files: Mapping[str, Path] = field(default_factory=dict)
    limits: ServerLimits = field(default_factory=ServerLimits)

    @classmethod
    def of_files(cls, presets: Iterable[Path], tables: Iterable[Path], limits: ServerLimits) -> "Repertoire":
        """Load what is offered; each is named as its file, without the ending.

        Raises
        ------
        EngineError : one cannot be loaded, or two have one name.
        """
        preset_files = _by_name(map(preset_path, presets), "presets", ())
        table_files = _by_name(tables, "mouth tables", shipped_tables())
        loaded = {name: load_table(path) for name, path in table_files.items()}
        shipped = {name: load_table(name) for name in shipped_tables()}
        known = {name: load_preset(path) for name, path in preset_files.items()}
        return cls(known, shipped | loaded, preset_files, table_files, limits)

    @property
    def preset(self) -> Preset:
        """The preset for clients that name none."""
        return next(iter(self.presets.values()))

    def preset_told(self, told: str) -> Preset:
        """Return the preset that a client names or sends; that of all others for an empty text.

        Raises
        ------
        EngineError : there is none of that name, or what it sent is none, or needs a model.
        """
        if not self._is_sent("preset", told, self.presets):
            return self.presets[told] if told else self.preset
        with tempfile.TemporaryDirectory(prefix="phonemeanalyser-") as empty:  # models are not sent
            return preset_from_toml(told, Path(empty))

    def table_told(self, told: str) -> MouthTable | None:
        """Return the mouth table that a client names or sends; None for an empty text.

        Raises
        ------
        EngineError : there is none of that name, or what it sent is none.
        """
        if self._is_sent("table", told, self.tables):
            return table_of(told)
        return self.tables[told] if told else None

    def file_told(self, key: str, told: str, folder: Path) -> Path | None:
        """Return the file of the ``preset`` or ``table`` that a client names or sends; None where it ships.

        Parameters
        ----------
        folder : where it is written to, if it is sent.

        Raises
        ------
        EngineError : as `preset_told` and `table_told` say.
        """
        self.preset_told(told) if key == "preset" else self.table_told(told)
        files = self.preset_files if key == "preset" else self.table_files
        if "\n" not in told:
            return files.get(told) if told or key == "table" else next(iter(files.values()))
        path = folder / f"{key}.toml"
        path.write_text(told, encoding="utf-8")
        return path

    def _is_sent(self, key: str, told: str, known: Mapping[str, object]) -> bool:
        """Return whether a text is that of a file; refuse one that is too long, and a name that is not known."""
        words = {"preset": "preset", "table": "mouth table"}[key]
        if "\n" in told:
            if len(told.encode(errors="replace")) > self.limits.max_own * KILOBYTE:
                raise RefusedError(f"a {words} of your own may have {self.limits.max_own:g} KB; send a shorter one")
            return True
        if told and told not in known:
            choice = f"choose one of {', '.join(known)}, or send the text of a file"
            raise RefusedError(f"there is no {words} {ascii(told)[:60]}; {choice}")
        return False


def _by_name(paths: Iterable[Path], what: str, taken: Iterable[str]) -> dict[str, Path]:
    found: dict[str, Path] = {}
    for path in paths:
        if path.stem in found or path.stem in taken:
            raise EngineError(f"two {what} have the name {path.stem!r}, by which clients ask for them; rename a file")
        found[path.stem] = path
    return found
