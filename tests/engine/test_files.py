"""The atomic file: what was there stays until what takes its place is complete."""

import errno
import sys

import pytest

from phonemeengine.errors import CurveError
from phonemeengine.files import atomic_write, is_portable, read_file, read_text_file, write_file


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


def test_text_is_read_as_it_was_written_whatever_ends_its_lines(tmp_path):
    path = tmp_path / "a.txt"
    write_file(path, b"\xef\xbb\xbfone\r\ntwo\rthree\n", CurveError)
    assert read_text_file(path, 100, "a curve", CurveError) == "one\ntwo\nthree\n"


@pytest.mark.parametrize("durable", [False, True])
def test_a_place_where_nothing_can_be_written_is_named_in_a_sentence(tmp_path, durable):
    with pytest.raises(CurveError, match=r"^a\.txt: cannot be written \(No such .*\); choose another folder$"):
        write_file(tmp_path / "none" / "a.txt", b"", CurveError, durable=durable)


def test_what_cannot_be_read_is_named_in_a_sentence(tmp_path):
    path = tmp_path / "a.txt"
    with pytest.raises(CurveError, match=r"^a\.txt: cannot be read \(No such .*\); check the file$"):
        read_file(path, 1 << 20, "a curve", CurveError)
    path.write_bytes(bytes(1 << 20))
    assert len(read_file(path, 1 << 20, "a curve", CurveError)) == 1 << 20
    path.write_bytes(bytes((1 << 20) + 1))
    with pytest.raises(CurveError, match=r"^a\.txt: a curve has at most 1 MB, this has 1\.1 MB; choose another$"):
        read_file(path, 1 << 20, "a curve", CurveError)
    path.write_bytes(b"\xff\xfe")
    with pytest.raises(CurveError, match=r"^a\.txt: this is no text file; choose a curve$"):
        read_text_file(path, 1 << 20, "a curve", CurveError)


@pytest.mark.parametrize("name", ["a.wav", "ünï code (2).json", ".hidden", "x" * 251 + ".wav"])
def test_such_a_name_can_be_written_everywhere(name: str) -> None:
    assert is_portable(name)


@pytest.mark.parametrize(
    "name", ["a:b.wav", "why?.wav", "con.wav", "LPT1.csv", "end.", "\udcff.wav", "a\n.wav", "x" * 256]
)
def test_some_system_cannot_write_such_a_name(name: str) -> None:
    assert not is_portable(name)
