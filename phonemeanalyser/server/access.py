"""Who may speak to a server: programs of this machine, or whoever knows the token.

A web page may open connections to this machine, too, whoever wrote it. So without a token a request must name the
machine as itself (against DNS rebinding), and a page must come from it.
"""

import hmac
import ipaddress
import re
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from pathlib import Path
from urllib.parse import urlsplit

from phonemeanalyser.server.refused import RefusedError
from phonemeengine import EngineError
from phonemeengine.files import printable_name, read_text_file

PROTOCOL = "phonemeanalyser"
"""The subprotocol of streams; a page names the token as another one, since it cannot set headers."""
LARGEST_TOKEN_FILE = 1 << 12
_TOKEN = re.compile(r"[A-Za-z0-9._~-]{16,256}")


@dataclass(frozen=True)
class Access:
    """Who may speak to the server.

    Attributes
    ----------
    token : what they must know; None where it is for this machine alone.
    origins : pages of other machines that may, such as ``https://example.org``.
    """

    token: str | None = None
    origins: Collection[str] = ()

    def check_host(self, host: str) -> None:
        """Refuse to serve other machines without a token.

        Raises
        ------
        EngineError : the address is not of this machine alone, and there is no token.
        """
        if self.token is None and not is_loopback(host):
            raise EngineError(
                f"{host} can be reached from other machines, so a token is needed; name its file with --token-file, "
                "or serve 127.0.0.1"
            )

    def check(self, headers: Mapping[str, str], protocols: Collection[str] = ()) -> None:
        """Let a request in, or refuse it.

        Parameters
        ----------
        headers : of the request.
        protocols : subprotocols that a WebSocket offers.

        Raises
        ------
        RefusedError : it does not know the token, or comes from where it may not.
        """
        origin = headers.get("Origin")
        if self.token is not None:
            self._check_token(headers, protocols)
        elif not is_loopback(_host_in(f"//{headers.get('Host', '')}")):
            raise RefusedError(
                "without a token this server is for its own machine; ask for 127.0.0.1 or localhost", 403
            )
        elif origin is not None and origin not in self.origins and not is_loopback(_host_in(origin)):
            raise RefusedError(
                f"pages of {origin[:100]} may not ask this server; start it with --origin, or a token", 403
            )

    def _check_token(self, headers: Mapping[str, str], protocols: Collection[str]) -> None:
        scheme, _, given = headers.get("Authorization", "").partition(" ")
        known = [given.strip()] if scheme.lower() == "bearer" else list(protocols)
        assert self.token is not None
        if not any(hmac.compare_digest(word.encode(), self.token.encode()) for word in known):
            raise RefusedError(
                "this server asks for its token; send it as Authorization: Bearer TOKEN, or from a page as the "
                f"second subprotocol after {PROTOCOL}",
                401,
            )


def is_loopback(host: str) -> bool:
    """Return whether a name or an address is that of this machine for itself."""
    if host.lower().rstrip(".") == "localhost":
        return True
    try:
        return ipaddress.ip_address(host.strip("[]")).is_loopback
    except ValueError:
        return False


def token_in(path: Path) -> str:
    """Return the token in a file: its only line, 16 to 256 letters, digits or ``. _ ~ -``.

    Raises
    ------
    EngineError : the file cannot be read, or holds something else.
    """
    token = read_text_file(path, LARGEST_TOKEN_FILE, "a file with a token", EngineError).strip()
    if not _TOKEN.fullmatch(token):
        raise EngineError(
            f"{printable_name(path)}: a token is one line of 16 to 256 letters, digits or . _ ~ -; write such a one"
        )
    return token


def _host_in(address: str) -> str:
    try:
        return urlsplit(address).hostname or ""
    except ValueError:
        return ""
