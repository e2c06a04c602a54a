"""Feeds damaged files to every reader; `python -m tools.fuzz` (make fuzz) feeds 200 000 of them.

A reader may read a damaged file or refuse it in a sentence. Anything else, a hang, or memory beyond 200 MB fails.
"""
