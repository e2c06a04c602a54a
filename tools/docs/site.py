"""A hook of mkdocs: pages at the top of the repository, and the pictures, are part of the site as they are."""

from pathlib import Path
from typing import Any

from mkdocs.structure.files import File, Files

ROOT = Path(__file__).resolve().parents[2]
PAGES = ("CHANGELOG.md", "CONTRIBUTING.md")


def on_files(files: Files, config: Any) -> Files:
    """Add what lies outside of `docs`."""
    pictures = [f"screenshots/{path.name}" for path in sorted((ROOT / "screenshots").iterdir())]
    for name in (*PAGES, *pictures):
        files.append(File.generated(config, name, abs_src_path=str(ROOT / name)))
    return files


def on_page_markdown(markdown: str, page: Any, **_: Any) -> str:
    """Let links that leave `docs` lead to what was added, and those of the added pages into `docs`."""
    if page.file.src_uri in PAGES:
        return markdown.replace("](docs/", "](")
    for name in (*PAGES, "screenshots/"):
        markdown = markdown.replace(f"../{name}", name)
    return markdown
