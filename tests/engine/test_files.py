"""The atomic file: what was there stays until what takes its place is complete."""

import codecs
import errno
import io
import os
import sys
import zipfile
from pathlib import Path

import pytest

from phonemeengine.errors import CurveError
from phonemeengine.storage.files import atomic_write, is_portable, read_file, read_text_file, write_file


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
    with pytest.raises(CurveError, match=r"^a\.txt: there is no such file; check its name and folder$"):
        read_file(path, 1 << 20, "a curve", CurveError)
    path.write_bytes(bytes(1 << 20))
    assert len(read_file(path, 1 << 20, "a curve", CurveError)) == 1 << 20
    path.write_bytes(bytes((1 << 20) + 1))
    with pytest.raises(CurveError, match=r"^a\.txt: a curve has at most 1 MB, this has 1\.1 MB; choose another$"):
        read_file(path, 1 << 20, "a curve", CurveError)
    path.write_bytes(b"\x89PNG\r\n\x1a\n\xff")
    with pytest.raises(CurveError, match=r"^a\.txt: this is no text file; choose a curve$"):
        read_text_file(path, 1 << 20, "a curve", CurveError)


TEXT = "One\tGrüße, “naïve” €5\nand two\n"


@pytest.mark.parametrize(
    "content",
    [
        TEXT.encode(),
        TEXT.encode("utf-8-sig"),
        TEXT.encode("utf-16"),
        codecs.BOM_UTF16_BE + TEXT.encode("utf-16-be"),
        TEXT.encode("utf-16-le"),
        TEXT.encode("utf-16-be"),
        TEXT.encode("utf-32"),
        TEXT.encode("cp1252"),
        TEXT.replace("\n", "\r\n").encode("cp1252"),
    ],
)
def test_a_text_is_read_in_the_encodings_that_editors_write(tmp_path: Path, content: bytes) -> None:
    (tmp_path / "a.txt").write_bytes(content)
    assert read_text_file(tmp_path / "a.txt", 1 << 20, "a text", CurveError) == TEXT


def word_document(body: str) -> bytes:
    """A document as Word has it, as far as it matters here."""
    name = "http://schemas.openxmlformats.org/wordprocessingml/2006/main"
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("[Content_Types].xml", "<Types/>")
        archive.writestr("word/document.xml", f'<w:document xmlns:w="{name}"><w:body>{body}</w:body></w:document>')
    return content.getvalue()


def test_of_a_word_document_the_paragraphs_and_the_rows_of_tables_are_read(tmp_path: Path) -> None:
    body = (
        "<w:p><w:pPr><w:pStyle w:val='x'/></w:pPr><w:r><w:t>Good </w:t></w:r><w:r><w:rPr><w:b/></w:rPr>"
        "<w:t>morning.</w:t><w:br/><w:t>All.</w:t></w:r><w:del><w:r><w:delText>gone</w:delText></w:r></w:del></w:p><w:p/>"
        "<w:tbl><w:tr><w:tc><w:p><w:r><w:t>a.wav</w:t></w:r></w:p></w:tc>"
        "<w:tc><w:p><w:r><w:t>one &amp; two</w:t></w:r></w:p></w:tc></w:tr></w:tbl>"
    )
    (tmp_path / "a.docx").write_bytes(word_document(body))
    found = read_text_file(tmp_path / "a.docx", 1 << 20, "a script", CurveError)
    assert found == "Good morning.\nAll.\n\na.wav\tone & two\n"


@pytest.mark.parametrize("part", [slice(0, -30), slice(0, -90), slice(0, 4), slice(0, 200)])
def test_a_damaged_word_document_is_refused_in_a_sentence(tmp_path: Path, part: slice) -> None:
    document = word_document("<w:p><w:r><w:t>One.</w:t></w:r></w:p>" * 90)
    (tmp_path / "a.docx").write_bytes(b"PK\x03\x04" + document[part])
    with pytest.raises(CurveError, match=r"^a\.docx: this is no text file; choose a script$"):
        read_text_file(tmp_path / "a.docx", 1 << 20, "a script", CurveError)


def test_a_word_document_that_would_fill_the_memory_is_refused(tmp_path: Path) -> None:
    (tmp_path / "a.docx").write_bytes(word_document("<w:p/>" * 400_000))
    with pytest.raises(CurveError, match="no text file"):
        read_text_file(tmp_path / "a.docx", 1 << 20, "a script", CurveError)


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="this system has no pipes with names")
def test_a_pipe_is_written_into_and_no_file_takes_its_place(tmp_path: Path) -> None:
    path = tmp_path / "pipe"
    os.mkfifo(path)
    reader = os.open(path, os.O_RDONLY | os.O_NONBLOCK)
    try:
        write_file(path, b"new", CurveError)
        assert os.read(reader, 9) == b"new"
    finally:
        os.close(reader)
    assert path.is_fifo()
    assert list(tmp_path.iterdir()) == [path]


@pytest.mark.skipif(not Path("/dev/full").is_char_device(), reason="this system has no device that is always full")
def test_a_device_that_is_full_stays_a_device() -> None:
    with pytest.raises(CurveError, match=r"^full: cannot be written \(No space left on device\)"):
        write_file(Path("/dev/full"), b"new", CurveError)
    assert Path("/dev/full").is_char_device()


@pytest.mark.parametrize("name", ["a.wav", "ünï code (2).json", ".hidden", "x" * 251 + ".wav"])
def test_such_a_name_can_be_written_everywhere(name: str) -> None:
    assert is_portable(name)


@pytest.mark.parametrize(
    "name", ["a:b.wav", "why?.wav", "con.wav", "LPT1.csv", "end.", "\udcff.wav", "a\n.wav", "x" * 256]
)
def test_some_system_cannot_write_such_a_name(name: str) -> None:
    assert not is_portable(name)
