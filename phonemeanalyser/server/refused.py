"""What a server refuses, with the number that HTTP has for it."""

from phonemeengine import EngineError

FAILED = "the server has failed at this; its log (--log) says where"
"""What is answered where it is the server's fault."""


class RefusedError(EngineError):
    """A request that is not granted; its text is one sentence for whoever wrote the client.

    Attributes
    ----------
    status : of the answer over HTTP.
    """

    def __init__(self, sentence: str, status: int = 400) -> None:
        super().__init__(sentence)
        self.status = status
