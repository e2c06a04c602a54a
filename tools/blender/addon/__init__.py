# SPDX-License-Identifier: MIT
"""Lip sync for faces with shape keys: movestates, curves, cues, mouth tables and sounds of PhonemeAnalyser.

What knows Blender is imported once Blender asks for it, so that the other modules can be tested without it.
"""


def register() -> None:
    """Add the add-on to Blender; it calls this."""
    from .registration import register as add

    add()


def unregister() -> None:
    """Remove it; Blender calls this."""
    from .registration import unregister as remove

    remove()
