"""The compiled ear."""

import pytest

from tests.compiled_ears import EarLibrary, ear_library


@pytest.fixture(scope="session")
def library() -> EarLibrary:
    """The shipped ear as a library."""
    return ear_library()
