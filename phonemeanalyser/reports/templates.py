"""Renders pages from the templates beside this module; the only module that imports Jinja2."""

from collections.abc import Callable, Mapping
from typing import Any

from phonemeengine.storage.files import printable


def rendered(template: str, values: Mapping[str, Any], filters: Mapping[str, Callable[..., Any]], **more: Any) -> str:
    """Write a page as HTML in ASCII that is well-formed XML too, and asks the network for nothing.

    Parameters
    ----------
    template : the name of its file.
    values, more : what it asks for by name, `values` within its macros too.
    filters : its functions.
    """
    from jinja2 import Environment, PackageLoader, StrictUndefined  # noqa: PLC0415 - takes 45 ms, for pages alone

    environment = Environment(
        loader=PackageLoader("phonemeanalyser.reports", ""),
        autoescape=True,
        finalize=_shown,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
    environment.globals |= values
    environment.filters |= filters
    page = environment.get_template(template).render(**more)
    return page.encode("ascii", errors="xmlcharrefreplace").decode("ascii")


def _shown(value: Any) -> Any:
    """Return what the page shows of a value: lengths to a tenth, and names without what cannot be printed."""
    if isinstance(value, float):
        return f"{value:.1f}".removesuffix(".0")
    return printable(value) if type(value) is str else value
