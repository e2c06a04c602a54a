"""The atomic file: what was there stays until what takes its place is complete."""

import errno
import sys

import pytest

from phonemeengine.files import atomic_write


def write(path, content, **options):
    with atomic_write(path, **options) as file:
        file.write(content)


def write_half(path, error):
    with atomic_write(path) as file:
        file.write(b"half")
        raise error


@pytest.mark.parametrize("durable", [False, True])
def test_a_file_takes_the_place_of_the_old_one_and_leaves_nothing_else(tmp_path, durable):
    path = tmp_path / "a.txt"
    path.write_bytes(b"old and longer")
    with atomic_write(path, durable=durable) as file:
        file.write(b"new")
        file.flush()
        assert path.read_bytes() == b"old and longer"
    assert path.read_bytes() == b"new"
    assert list(tmp_path.iterdir()) == [path]


@pytest.mark.parametrize("error", [OSError(errno.ENOSPC, "full"), KeyboardInterrupt(), ValueError("odd")])
def test_what_was_there_survives_a_write_that_fails(tmp_path, error):
    path = tmp_path / "a.txt"
    path.write_bytes(b"old")
    with pytest.raises(type(error)):
        write_half(path, error)
    assert path.read_bytes() == b"old"
    assert list(tmp_path.iterdir()) == [path]


def test_two_who_write_one_file_at_once_do_not_mix(tmp_path):
    path = tmp_path / "a.txt"
    with atomic_write(path) as one, atomic_write(path) as other:
        one.write(b"one" * 9000)
        other.write(b"another" * 9000)
    assert path.read_bytes() == b"one" * 9000


@pytest.mark.parametrize("name", ["no folder/a.txt", "a\0b"])
def test_a_place_where_no_file_can_be_is_refused(tmp_path, name):
    with pytest.raises((OSError, ValueError)):
        write(tmp_path / name, b"new")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.skipif(
    sys.platform == "win32", reason="Windows has other permissions and asks an administrator for links"
)
def test_the_new_file_is_a_plain_one_with_the_usual_permissions(tmp_path):
    old, link, usual = tmp_path / "old", tmp_path / "link", tmp_path / "usual"
    old.write_bytes(b"old")
    usual.write_bytes(b"usual")
    link.symlink_to(old)
    write(link, b"new")
    assert (old.read_bytes(), link.read_bytes(), link.is_symlink()) == (b"old", b"new", False)
    assert link.stat().st_mode == usual.stat().st_mode
