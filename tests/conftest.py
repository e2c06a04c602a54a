"""What all tests share."""

from pathlib import Path

import pytest
from hypothesis import settings

settings.register_profile("house", deadline=None)  # a busy machine is no failure
settings.load_profile("house")

ROOT = Path(__file__).resolve().parents[1]
CORPUS = ROOT.parent / "shared" / "corpus"


@pytest.fixture(scope="session")
def corpus() -> Path:
    """The labelled development corpus, which only the founders' machines have."""
    if not (CORPUS / "manifest.csv").exists():
        pytest.skip("the development corpus is not on this machine")
    return CORPUS
