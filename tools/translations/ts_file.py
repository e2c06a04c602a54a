"""Reads and writes Qt's translation files (.ts): one context, the texts in alphabetical order, no line numbers."""

from collections.abc import Mapping
from pathlib import Path
from xml.etree import ElementTree as ET

from phonemeanalyser.desktop.language import CONTEXT
from tools.translations.sources import Source

HEAD = '<?xml version="1.0" encoding="utf-8"?>\n<!DOCTYPE TS>\n'


def read_translations(path: Path) -> dict[tuple[str, str], str]:
    """Return the translations of a file by text and comment; empty ones are still to be made."""
    if not path.exists():
        return {}
    messages = ET.parse(path).getroot().iter("message")
    return {_key(message): message.findtext("translation") or "" for message in messages}


def write_translations(
    path: Path, language: str, sources: Mapping[tuple[str, str], Source], known: Mapping[tuple[str, str], str]
) -> None:
    """Write all texts with the translations that are known; Qt Linguist shows the others as unfinished."""
    root = ET.Element("TS", version="2.1", language=language, sourcelanguage="en")
    context = ET.SubElement(root, "context")
    ET.SubElement(context, "name").text = CONTEXT
    for key in sorted(sources, key=lambda key: (key[0].casefold(), key)):
        source, translation = sources[key], known.get(key, "")
        message = ET.SubElement(context, "message")
        ET.SubElement(message, "location", filename=f"../../../{source.file}")
        ET.SubElement(message, "source").text = source.text
        if source.comment:
            ET.SubElement(message, "comment").text = source.comment
        translated = ET.SubElement(message, "translation")
        if translation:
            translated.text = translation
        else:
            translated.set("type", "unfinished")
    ET.indent(root, "    ")
    path.write_text(HEAD + ET.tostring(root, encoding="unicode") + "\n", "utf-8")


def _key(message: ET.Element) -> tuple[str, str]:
    return message.findtext("source") or "", message.findtext("comment") or ""
