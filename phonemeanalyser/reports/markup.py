"""Elements of HTML and SVG as text, escaped, and well-formed as XML too."""

import html


def text(value: object) -> str:
    """Return words as markup."""
    return html.escape("".join(c if c.isprintable() else "?" for c in str(value)))


def element(name: str, /, *content: str, **attributes: object) -> str:
    """Return an element; content is markup, numbers are rounded to a tenth, underscores in names become hyphens.

    An underscore at the end of an attribute's name is dropped (``class_``), and None leaves the attribute out.
    """
    words = [f' {key.rstrip("_").replace("_", "-")}="{_value(v)}"' for key, v in attributes.items() if v is not None]
    inner = "".join(content)
    return f"<{name}{''.join(words)}>{inner}</{name}>" if inner or name not in VOID else f"<{name}{''.join(words)}/>"


VOID = {"meta", "rect", "line", "path", "wbr", "circle"}
"""Elements that close themselves where they hold nothing."""


def _value(value: object) -> str:
    return f"{value:.1f}".removesuffix(".0") if isinstance(value, float) else text(value)
