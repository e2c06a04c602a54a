"""What the time view invites to, while there is nothing to be seen in it."""

from phonemeanalyser.desktop.session.session import Session, SoundSource

NOTHING = "Drop a sound here, or open one with Ctrl+O"
HINTS = {
    SoundSource.FILE: "Press Space to play",
    SoundSource.MICROPHONE: "Press Space to listen, R to record",
    SoundSource.TONE: "Press Space to hear the tone",
}


def empty_hint(session: Session) -> str:
    """Return what the user may do with the source in use."""
    return NOTHING if session.source is SoundSource.FILE and not session.path else HINTS[session.source]
