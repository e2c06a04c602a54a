"""The compiled ear."""

import pytest

from tests.compiled_ears import COMPILERS, EarLibrary, compiler, ear_library


@pytest.fixture(scope="session")
def library() -> EarLibrary:
    """The shipped ear as a library."""
    return ear_library()


@pytest.fixture(scope="session", params=COMPILERS)
def each_compiler(request: pytest.FixtureRequest) -> str:
    """Each of the C compilers with which the ear is tried."""
    return compiler(request.param)
