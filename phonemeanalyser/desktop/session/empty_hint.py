"""What the time view invites to, while there is nothing to be seen in it."""

from phonemeanalyser.desktop.session.session import Session, Source

NOTHING = "Drop a sound here, or open one with Ctrl+O"
INVITATIONS = {
    Source.FILE: "Press Space to play",
    Source.MICROPHONE: "Press Space to listen, R to record",
    Source.TONE: "Press Space to hear the tone",
}


def invitation_of(session: Session) -> str:
    """Say what the user may do with the source in use."""
    return NOTHING if session.source is Source.FILE and not session.path else INVITATIONS[session.source]
