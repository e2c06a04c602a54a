"""The Talk page: a head that speaks what is playing.

What the window needs of it stands in ``__init__.pyi`` and is imported when it is first asked for, since that is a
third of all imports of the program, and the window is to be seen before.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
