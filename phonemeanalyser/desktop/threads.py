"""What must not hold up the window: begun in a thread of its own."""

import threading
from collections.abc import Callable


def start_thread(act: Callable[[], object]) -> threading.Thread:
    """Begin something that may wait for a device or a disk; the program's end does not wait for it."""
    thread = threading.Thread(target=act, daemon=True)
    thread.start()
    return thread
