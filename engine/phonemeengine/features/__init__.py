"""Numbers become evidence: named variables measured on each frame."""
