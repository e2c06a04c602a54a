"""Who may connect to a server: programs of this machine, or clients with the token; and what it grants them.

Any web page may open connections to this machine, too. So without a token a request must name the
machine as itself (against DNS rebinding), and pages may ask only where the user names their origin.
"""

import hmac
import ipaddress
import os
import re
import time
from collections import OrderedDict
from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass
from pathlib import Path

from phonemeengine import EngineError
from phonemeengine.errors import check_range
from phonemeengine.storage.files import printable_name, read_text_file

# What a server refuses, with the number that HTTP has for it.

FAILED = "the server has failed at this; its log (--log) says where"
"""What is answered where it is the server's fault."""


class RefusedError(EngineError):
    """A request that is refused; its text is one sentence for the author of the client.

    Attributes
    ----------
    status : of the answer over HTTP.
    """

    def __init__(self, sentence: str, status: int = 400) -> None:
        super().__init__(sentence)
        self.status = status


USUAL_HOST, USUAL_PORT = "127.0.0.1", 8765
KILOBYTE, MEGABYTE = 1 << 10, 1 << 20
PER_MESSAGE = 0.005
"""Seconds of sound that a message counts for besides what it holds: very short chunks slow a client down."""
AHEAD = 5.0
"""Seconds of sound that a stream may be ahead of its clock before it is slowed down."""

LIMITS: dict[str, tuple[float, float, str, str]] = {
    "max_streams": (1, 10_000, "", "streams at a time"),
    "max_connections": (1, 20_000, "", "connections at a time, streams and files together"),
    "max_per_address": (1, 20_000, "", "connections at a time that one address may have"),
    "max_speed": (1, 1000, "", "speed at which a stream is read, as a multiple of real time"),
    "idle_timeout": (1, 86_400, "s", "time after which a client that sends or takes nothing is disconnected"),
    "max_message": (0.001, 1024, "MB", "size of a message of a stream"),
    "max_text": (0, 10_000_000, "", "characters in the text of a stream or a file"),
    "max_own": (0, 1000, "KB", "size of a preset or mouth table that a client sends; 0 allows none"),
    "max_file": (0.001, 100_000, "MB", "size of an audio file"),
    "max_duration": (1, 1_000_000, "s", "length of the audio in a file"),
    "max_memory": (128, 1_000_000, "MB", "memory that the export of a file may use (Linux only)"),
    "max_files": (1, 1000, "", "files that are exported at a time, not counting those that take long; others wait"),
    "file_timeout": (1, 86_400, "s", "time that a file may take, from its first byte on"),
}
"""Least, most, unit, and what each is."""


@dataclass(frozen=True)
class ServerLimits:
    """What each of these is stands in `LIMITS`.

    Raises
    ------
    SettingsError : one lies outside its range.
    """

    max_streams: int = 64
    max_connections: int = 128
    max_per_address: int = 64
    max_speed: float = 4.0
    idle_timeout: float = 30.0
    max_message: float = 1.0
    max_text: int = 100_000
    max_own: float = 32.0
    max_file: float = 64.0
    max_duration: float = 1800.0
    max_memory: float = 1024.0
    max_files: int = 1
    file_timeout: float = 300.0

    def __post_init__(self) -> None:
        for name, (low, high, unit, words) in LIMITS.items():
            check_range(f"{words}:", getattr(self, name), (low, high, unit))


PROTOCOL = "phonemeanalyser"
"""The subprotocol of streams; a page names the token as another one, since it cannot set headers."""
LARGEST_TOKEN_FILE = 1 << 12
OF_OTHERS = 0o007
"""The bits of a file's mode that let all users of a machine read or change it."""
FIRST_WAIT, LONGEST_WAIT = 0.05, 5.0
"""Seconds that an address waits after its first wrong token; twice as long after each other one, but no longer."""
FORGOTTEN = 600.0
"""Seconds after which wrong tokens no longer count."""
MOST_GUESSERS = 10_000
"""Addresses whose wrong tokens are remembered."""
NETWORK = 64
"""Bits of an IPv6 address that tell one customer of a provider from another."""
TOKEN = re.compile(r"[A-Za-z0-9._~-]{16,256}")
_HOST = re.compile(r"(localhost\.?|[0-9.]+|\[[0-9a-f:.]+\])(?::[0-9]{1,5})?", re.IGNORECASE)
_ORIGIN = re.compile(r"[a-z][a-z0-9+.-]*://(?:[a-z0-9._-]+|\[[0-9a-f:.]+\])(?::[0-9]{1,5})?", re.IGNORECASE)

Network = ipaddress.IPv4Network | ipaddress.IPv6Network


@dataclass(frozen=True)
class Access:
    """Who may speak to the server.

    Attributes
    ----------
    token : what they must know; None where it is for this machine alone.
    origins : pages that may, such as ``https://example.org`` or ``http://localhost:8000``.
    proxies : addresses, or networks, of proxies that tell truly whom they ask for (``X-Forwarded-For``).

    Raises
    ------
    EngineError : an origin or a proxy is something else.
    """

    token: str | None = None
    origins: Collection[str] = ()
    proxies: Collection[str] = ()

    def __post_init__(self) -> None:
        for origin in self.origins:
            if not _ORIGIN.fullmatch(origin):
                raise EngineError(
                    f"{origin!a:.100} is no origin of a page; name its scheme, host and port alone, such as "
                    "https://example.org"
                )
        self._networks()

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
        elif not is_loopback(_named_host(headers)):
            raise RefusedError(
                "without a token this server is for its own machine; ask for 127.0.0.1 or localhost", 403
            )
        elif origin is not None and not self.allows(origin) and origin.lower() != f"http://{headers['Host']}".lower():
            raise RefusedError(
                f"pages of {origin[:100]} may not ask this server; start it with --origin, or a token", 403
            )

    def check_preflight(self, headers: Mapping[str, str]) -> None:
        """Let a browser send what a page wants to ask, or refuse it; the request itself is looked at when it comes.

        Raises
        ------
        RefusedError : the page comes from where it may not.
        """
        origin = headers.get("Origin", "")
        if not self.allows(origin):
            raise RefusedError(f"pages of {origin[:100]} may not ask this server; start it with --origin", 403)

    def allows(self, origin: str) -> bool:
        """Return whether pages from there may ask, and read what is answered."""
        return origin.lower() in {allowed.lower() for allowed in self.origins}

    def client_of(self, peer: str | None, headers: Mapping[str, str]) -> str:
        """Return for whom a limit counts: the address that asks, or of whom a trusted proxy says that it does.

        Of IPv6 it is the network, since one client has all of its addresses.
        """
        networks, found = self._networks(), _address_in(peer or "")
        for hop in reversed(",".join(_values(headers, "X-Forwarded-For")).split(",")):
            if found is None or not any(found in network for network in networks):
                break
            told = _address_in(hop.strip())
            if told is None:
                break
            found = told
        if isinstance(found, ipaddress.IPv6Address):
            return str(ipaddress.ip_network((found, NETWORK), strict=False))
        return str(found)

    def _networks(self) -> list[Network]:
        try:
            return [ipaddress.ip_network(proxy) for proxy in self.proxies]
        except ValueError as error:
            raise EngineError(f"--trusted-proxy: {error}; name an address such as 127.0.0.1, or a network") from error

    def _check_token(self, headers: Mapping[str, str], protocols: Collection[str]) -> None:
        assert self.token is not None
        known = [hmac.compare_digest(word.encode(), self.token.encode()) for word in tokens_of(headers, protocols)]
        if not any(known):
            raise RefusedError(
                "this server asks for its token; send it as Authorization: Bearer TOKEN, or from a page as the "
                f"second subprotocol after {PROTOCOL}",
                401,
            )


class WrongTokens:
    """Remembers who has sent wrong tokens: the more of them an address sent, the longer it waits to be answered.

    Parameters
    ----------
    clock : gives seconds.
    """

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self._clock = clock
        self._known: OrderedDict[str, tuple[int, float]] = OrderedDict()

    def wait_of(self, client: str) -> float:
        """Return how long a client waits before its token is looked at, seconds."""
        n, last = self._known.get(client, (0, 0.0))
        if not n or self._clock() - last > FORGOTTEN:
            return 0.0
        return float(min(LONGEST_WAIT, FIRST_WAIT * 2 ** min(n - 1, 30)))

    def add(self, client: str) -> int:
        """Remember a wrong token; return how many the client has sent."""
        n = self._known.pop(client, (0, 0.0))[0] + 1 if self.wait_of(client) else 1
        self._known[client] = (n, self._clock())
        if len(self._known) > MOST_GUESSERS:
            self._known.popitem(last=False)
        return n

    def forgive(self, client: str) -> None:
        """Forget what a client has sent, since it knows the token."""
        self._known.pop(client, None)


def tokens_of(headers: Mapping[str, str], protocols: Collection[str]) -> list[str]:
    """Return what a request gives as tokens: mostly one, or none."""
    scheme, _, given = headers.get("Authorization", "").partition(" ")
    if scheme.lower() == "bearer":
        return [given.strip()]
    return [word for word in protocols if word not in ("", PROTOCOL)]


def is_loopback(host: str) -> bool:
    """Return whether a name or an address is that of this machine for itself."""
    if host.lower().rstrip(".") == "localhost":
        return True
    address = _address_in(host.strip("[]"))
    return address is not None and address.is_loopback


def token_in(path: Path) -> str:
    """Return the token in a file: its only line, 16 to 256 letters, digits or ``. _ ~ -``.

    Raises
    ------
    EngineError : the file cannot be read, or all users of the machine can read it, or it holds something else. On
        Windows, where files have no such mode, it is not asked who can read it.
    """
    token = read_text_file(path, LARGEST_TOKEN_FILE, "a file with a token", EngineError).strip()
    name = printable_name(path)
    if os.name == "posix" and path.stat().st_mode & OF_OTHERS:
        raise EngineError(f"{name}: all users of this machine can read or change it; make it yours alone (chmod 600)")
    if not TOKEN.fullmatch(token):
        raise EngineError(f"{name}: a token is one line of 16 to 256 letters, digits or . _ ~ -; write such a one")
    return token


def _named_host(headers: Mapping[str, str]) -> str:
    """Return the host that a request names; empty where it names none, several, or something else beside it."""
    named = _values(headers, "Host")
    found = _HOST.fullmatch(named[0]) if len(named) == 1 else None
    return found[1] if found else ""


def _values(headers: Mapping[str, str], name: str) -> list[str]:
    return [value for key, value in headers.items() if key.lower() == name.lower()]


def _address_in(text: str) -> ipaddress.IPv4Address | ipaddress.IPv6Address | None:
    try:
        found = ipaddress.ip_address(text.partition("%")[0])
    except ValueError:
        return None
    mapped = found.ipv4_mapped if isinstance(found, ipaddress.IPv6Address) else None
    return mapped or found
