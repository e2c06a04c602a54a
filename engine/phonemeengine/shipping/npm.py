"""The door to npm, which fetches the library that draws the demo page's head."""

import hashlib
import io
import shutil
import subprocess
import tarfile
import tempfile
from pathlib import Path

from phonemeengine.errors import ExportError

THREE = "three@0.187.0"
DIGEST = (
    "422bbb47e0a687c0acb59b18d6e24e4969d595fa3b66d34b57b985f0996d9372"
    "c1dc0b43bbd71166572744a90093c638cfa28ac37e73ed8ed4addee3598f1eb4"
)
"""SHA-512 of its package."""
FILES = (
    "LICENSE",
    "build/three.core.js",
    "build/three.module.js",
    "examples/jsm/loaders/GLTFLoader.js",
    "examples/jsm/utils/BufferGeometryUtils.js",
    "examples/jsm/utils/SkeletonUtils.js",
)
TIMEOUT = 120.0
OTHERWISE = "or ship the target web-module, which has no page"


def three_files() -> dict[str, bytes]:
    """Return the files of three.js that the demo page needs, by their path in its package.

    Raises
    ------
    ExportError : there is no npm, or it cannot fetch the package.
    """
    npm = shutil.which("npm")
    if npm is None:
        raise ExportError(
            f"the demo page needs {THREE}, which npm fetches, and there is no npm; install Node.js, {OTHERWISE}"
        )
    with tempfile.TemporaryDirectory() as folder:
        command = [npm, "pack", THREE, "--prefer-offline", "--pack-destination", folder]
        try:
            subprocess.run(command, capture_output=True, timeout=TIMEOUT, check=True)  # noqa: S603 - our own words
            (package,) = (path.read_bytes() for path in Path(folder).iterdir())
        except (OSError, ValueError, subprocess.SubprocessError) as error:
            raise ExportError(f"npm cannot fetch {THREE}; connect to the network, {OTHERWISE}") from error
    if hashlib.sha512(package).hexdigest() != DIGEST:
        raise ExportError(f"npm fetched another {THREE} than the page was made for; clear its cache, {OTHERWISE}")
    return _contents(package)


def _contents(package: bytes) -> dict[str, bytes]:
    with tarfile.open(fileobj=io.BytesIO(package)) as archive:
        found = {name: archive.extractfile(f"package/{name}") for name in FILES}
        return {name: file.read() for name, file in found.items() if file is not None}
