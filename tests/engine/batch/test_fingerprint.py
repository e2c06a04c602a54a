"""Fingerprints: the same wherever they are made, and another as soon as anything differs."""

import pickle
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from phonemeengine import Detail, ExportOptions, IdleMotion, for_files, load_preset, load_table
from phonemeengine.batch.order import order_of
from phonemeengine.batch.work import fingerprint_of
from phonemeengine.presets.files import FACTORY_PRESETS
from phonemeengine.settings import ModelKind
from tests.fakes.batch_works import CopyWork

CODE = """
from phonemeengine import ExportOptions, for_files, load_preset, load_table
from phonemeengine.batch.work import fingerprint_of
values = {"b": 1, "a": {"x", "y"}}
print(fingerprint_of(for_files(load_preset("learned")), ExportOptions(), load_table("arkit"), values))
"""


def test_another_process_makes_the_same() -> None:
    done = subprocess.run([sys.executable, "-c", CODE], capture_output=True, text=True, timeout=240, check=True)
    values = {"a": {"y", "x"}, "b": 1}
    here = fingerprint_of(for_files(load_preset("learned")), ExportOptions(), load_table("arkit"), values)
    assert done.stdout.strip() == here


def test_every_preset_has_its_own() -> None:
    assert len({fingerprint_of(load_preset(path)) for path in FACTORY_PRESETS}) == len(FACTORY_PRESETS)


@pytest.mark.parametrize(
    ("one", "other"),
    [
        (1, 1.0),
        ("a", b"a"),
        (("a", "b"), ("ab",)),
        ({"a": 1}, {"a": 2}),
        (np.zeros(4, np.float32), np.zeros((2, 2), np.float32)),
        (ExportOptions(), ExportOptions(idle=IdleMotion(detail=Detail.PHONEMES, seed=3))),
        (load_preset("thesis"), replace(load_preset("thesis"), name="another")),
    ],
)
def test_whatever_differs_differs(one: object, other: object) -> None:
    assert fingerprint_of(one) == fingerprint_of(one) != fingerprint_of(other)


def test_a_path_stands_for_its_file(tmp_path: Path) -> None:
    (tmp_path / "a").write_text("same")
    (tmp_path / "b").write_text("same")
    assert fingerprint_of(tmp_path / "a") == fingerprint_of(tmp_path / "b")
    (tmp_path / "b").write_text("other")
    assert fingerprint_of(tmp_path / "a") != fingerprint_of(tmp_path / "b")


def test_an_order_is_known_by_its_work() -> None:
    assert order_of(CopyWork("a")) == order_of(CopyWork("a")) != order_of(CopyWork("b"))


@pytest.mark.parametrize(("kind", "is_sent"), [(ModelKind.OFFLINE, False), (ModelKind.ENCODER, True)])
def test_an_order_carries_the_real_time_model_only_where_that_recognises(kind: ModelKind, is_sent: bool) -> None:
    work = CopyWork(preset=for_files(load_preset("learned"), kind))
    order = order_of(work)
    assert order.digest == work.fingerprint()
    assert pickle.loads(order.content) == (
        work if is_sent else replace(work, preset=replace(work.preset, live_encoder=None))
    )
    assert (len(order.content) > 11e6) == is_sent
