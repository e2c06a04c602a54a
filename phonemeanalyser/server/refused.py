"""What a server refuses, with the number that HTTP has for it."""

from phonemeengine import EngineError


class RefusedError(EngineError):
    """A request that is not granted; its text is one sentence for whoever wrote the client.

    Attributes
    ----------
    status : of the answer over HTTP.
    """

    def __init__(self, sentence: str, status: int = 400) -> None:
        super().__init__(sentence)
        self.status = status
