"""The compiled ear."""

from pathlib import Path

import pytest

from phonemeengine import load_preset, ship
from tests.compiled_ears import EarLibrary, ear_library


@pytest.fixture(scope="session")
def library() -> EarLibrary:
    """The shipped ear as a library."""
    return ear_library()


@pytest.fixture(scope="session")
def web_module(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The preset Learned, shipped as a module."""
    place = tmp_path_factory.mktemp("module")
    ship(load_preset("learned"), place, "web-module")
    return place
