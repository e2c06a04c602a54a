"""The text of Word documents (.docx): of their paragraphs and tables, without notes, headers and what was deleted."""

import io
import zipfile
import zlib
from collections.abc import Iterator
from xml.etree import ElementTree

BODY = "word/document.xml"
_MARKS = {"tab": "\t", "br": "\n", "cr": "\n", "noBreakHyphen": "-"}
"""Characters that a document has as elements."""
_WITHOUT_TEXT = {"pPr", "rPr", "Fallback"}
"""Elements in a paragraph of which nothing is read: properties, and what stands for a text box in old programs."""


def text_of(content: bytes, largest: int) -> str:
    """Return the text of a document: a line for each paragraph, and for each row of a table, with tabs between.

    Parameters
    ----------
    content : of the file.
    largest : bytes that its body may have.

    Raises
    ------
    ValueError : it is no such document, is damaged or too large.
    """
    try:
        with zipfile.ZipFile(io.BytesIO(content)) as archive:
            body = archive.getinfo(BODY)
            if body.file_size > largest:
                raise ValueError(f"a body of {body.file_size} bytes")
            root = ElementTree.fromstring(archive.read(body))  # noqa: S314 - expat limits what grows by itself
    except (
        zipfile.BadZipFile,
        zlib.error,
        KeyError,
        EOFError,
        NotImplementedError,
        RuntimeError,
        SyntaxError,
    ) as error:
        raise ValueError("no Word document") from error
    return "".join(f"{line}\n" for line in _lines_of(root))


def _lines_of(element: ElementTree.Element) -> Iterator[str]:
    kind = _kind_of(element)
    if kind == "p":
        yield "".join(_MARKS.get(_kind_of(part), part.text or "") for part in _parts_of(element))
    elif kind == "tr":
        yield "\t".join(" ".join(_lines_of(cell)).strip() for cell in element if _kind_of(cell) == "tc")
    else:
        for child in element:
            yield from _lines_of(child)


def _parts_of(element: ElementTree.Element) -> Iterator[ElementTree.Element]:
    """Return what holds the characters of a paragraph."""
    for child in element:
        kind = _kind_of(child)
        if kind == "t" or kind in _MARKS:
            yield child
        elif kind not in _WITHOUT_TEXT:
            yield from _parts_of(child)


def _kind_of(element: ElementTree.Element) -> str:
    return element.tag.rpartition("}")[2]
