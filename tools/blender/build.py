"""Builds the add-on's zip: its own modules, and those of the engine that they need.

An add-on may add no module of its own name to Blender's Python, so that the engine's modules lie inside it, and their
imports are made relative. What Blender itself has, NumPy and the standard library, is not taken along.
"""

import ast
import importlib.util
import re
import sys
import zipfile
from collections.abc import Iterator
from importlib.metadata import distribution
from io import BytesIO
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
ADDON = Path(__file__).resolve().parent / "addon"
ENGINE = ROOT / "engine" / "phonemeengine"
TAKEN = ("phonemeengine", "tomli_w", "typing_extensions")
"""The packages of which modules are taken along."""
MARK = b'"""The mark of overrides, which only type checkers read."""\n\n\ndef override(method):\n    return method\n'
"""What stands for `typing_extensions`, of which the engine needs no more."""
OF_BLENDER = ("bpy", "bpy_extras", "mathutils", "numpy")
DATA = ("mouth/tables/*.toml",)
"""Files of the engine that its modules read."""
LONG_AGO = (1980, 1, 1, 0, 0, 0)
"""The time of all files in the zip, so that it is the same whenever it is built."""


def build(folder: Path) -> Path:
    """Write the zip into a folder, and return its path."""
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / f"phonemeanalyser-blender-{version()}.zip"
    path.write_bytes(zip_of(contents()))
    return path


def version() -> str:
    """Return the engine's version, which is the add-on's too."""
    found = re.search(r'^__version__ = "(.+)"$', (ENGINE / "__init__.py").read_text(encoding="utf-8"), re.MULTILINE)
    assert found is not None
    return found[1]


def contents() -> dict[str, bytes]:
    """Return every file of the add-on by its place in the zip."""
    files = {path.name: path.read_bytes() for path in sorted(ADDON.iterdir()) if path.is_file()}
    manifest = files["blender_manifest.toml"].decode()
    files["blender_manifest.toml"] = manifest.replace('"VERSION"', f'"{version()}"').encode()
    files["LICENSE"] = (ROOT / "LICENSE").read_bytes()
    for pattern in DATA:
        files |= {
            f"phonemeengine/{path.relative_to(ENGINE).as_posix()}": path.read_bytes() for path in ENGINE.glob(pattern)
        }
    todo = [file for file in files if file.endswith(".py")]
    while todo:
        place = todo.pop()
        text = files[place].decode()
        for module in sorted(imported_by(text)):
            new = {found: content for found, content in _files_of(module).items() if found not in files}
            files |= new
            todo += new
        files[place] = with_relative_imports(text, place.count("/")).encode()
    files |= _licences()
    return dict(sorted(files.items()))


def zip_of(files: dict[str, bytes]) -> bytes:
    """Return a zip, the same bytes for the same files."""
    out = BytesIO()
    with zipfile.ZipFile(out, "w") as archive:
        for name, content in files.items():
            info = zipfile.ZipInfo(name, LONG_AGO)
            info.external_attr, info.create_system = 0o644 << 16, 3
            archive.writestr(info, content, zipfile.ZIP_DEFLATED, 9)
    return out.getvalue()


def imported_by(text: str) -> set[str]:
    """Return the modules that a module's text imports of the packages that are taken along.

    Raises
    ------
    ValueError : it imports what neither is taken along nor belongs to Blender.
    """
    modules = set()
    for node in _imports_in(text):
        for module in [node.module or ""] if isinstance(node, ast.ImportFrom) else [a.name for a in node.names]:
            package = module.split(".")[0]
            if package in TAKEN:
                modules.add(module)
            elif package not in OF_BLENDER and package not in sys.stdlib_module_names:
                raise ValueError(f"the add-on imports {module}, which Blender does not have; leave it out")
    return modules


def with_relative_imports(text: str, depth: int) -> str:
    """Return a module's text, for some folders below the add-on's, with relative imports of what is taken along."""
    lines = text.splitlines(keepends=True)
    for node in _imports_in(text):
        package = (node.module or "" if isinstance(node, ast.ImportFrom) else node.names[0].name).split(".")[0]
        if package in TAKEN:
            dots, at = "." * (depth + 1), node.lineno - 1
            whole, relative = (
                (f"from {package}", f"from {dots}{package}")
                if isinstance(node, ast.ImportFrom)
                else (f"import {package}", f"from {dots} import {package}")
            )
            lines[at] = lines[at].replace(whole, relative, 1)
    return "".join(lines)


def _imports_in(text: str) -> Iterator[ast.Import | ast.ImportFrom]:
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Import) or (isinstance(node, ast.ImportFrom) and node.level == 0):
            yield node


def _files_of(module: str) -> dict[str, bytes]:
    """Return a module, and the packages that it lies in, by their places in the zip, without the page of names."""
    if module == "typing_extensions":
        return {"typing_extensions.py": MARK}
    parts, files = module.split("."), {}
    folder = _folder_of(parts[0])
    for n in range(1, len(parts) + 1):
        place = "/".join(parts[:n])
        place += "/__init__.py" if (folder / place).is_dir() else ".py"
        files[place] = (folder / place).read_bytes() if folder / place != ENGINE / "__init__.py" else b""
    return files


def _folder_of(package: str) -> Path:
    """Return the folder that a package lies in."""
    if package == ENGINE.name:
        return ENGINE.parent
    spec = importlib.util.find_spec(package)
    if spec is None or spec.origin is None:
        raise ValueError(f"{package} is not installed; run 'make setup'")
    return Path(spec.origin).parents[1]


def _licences() -> dict[str, bytes]:
    """Return the licences of what others wrote, by their places in the zip."""
    taken = distribution("tomli_w")
    found = [file for file in taken.files or () if "LICENSE" in file.name]
    return {"tomli_w/LICENSE": found[0].read_binary()}
