"""One page for the browser of this machine and nobody else.

Any program of this machine, and any page that a browser has open, can send requests to a local server. So the
address holds a random token, requests must name this very host (which stops a foreign name that was made to
lead here), nothing is ever looked up among files, and everything else than the page, its state and, of a
lift that runs, what is new of it is refused.
"""

from __future__ import annotations

import re
import secrets
from collections.abc import Callable
from contextlib import suppress
from http import HTTPStatus
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import ClassVar

_LARGEST_PAGE = 100_000_000  # bytes
_PATIENCE = 15.0  # s that a request may take to arrive
_LIVE = re.compile(r"/[A-Za-z0-9_-]+/live/(0|[1-9][0-9]{0,8})")
_POLICY = re.compile(r'<meta http-equiv="Content-Security-Policy" content="([^"]*)">')


class PageServer(ThreadingHTTPServer):
    """Serves one page at `http://127.0.0.1:<port>/<token>/`.

    Args:
        page: Gives the page as HTML, made anew for each request.
        state: Gives a text that changes whenever the page does.
        port: Port; 0 takes a free one.
        since: Of a lift that runs: what a page that has so many samples has not got yet, see `LiveView`.

    Raises:
        OSError: If the port cannot be used.
    """

    daemon_threads = True

    def __init__(
        self,
        page: Callable[[], str],
        state: Callable[[], str],
        port: int = 0,
        *,
        since: Callable[[int], str] | None = None,
    ) -> None:
        super().__init__(("127.0.0.1", port), _Handler)
        self.page = page
        self.state = state
        self.since = since
        self.token = secrets.token_urlsafe(24)

    @property
    def address(self) -> str:
        """Where the page is."""
        return f"http://127.0.0.1:{self.server_port}/{self.token}/"


class _Handler(BaseHTTPRequestHandler):
    server: PageServer
    protocol_version = "HTTP/1.1"
    server_version = "gantline"
    sys_version = ""
    timeout: ClassVar[float] = _PATIENCE

    def do_GET(self) -> None:
        self._answer(with_body=True)

    def do_HEAD(self) -> None:
        self._answer(with_body=False)

    def _answer(self, *, with_body: bool) -> None:
        refused = self._refused()
        if refused is not None:
            self._send(refused, refused.phrase, "text/plain", with_body=with_body)
            return
        is_page = self.path == f"/{self.server.token}/"
        try:
            text = self.server.page() if is_page else self._told()
        except (OSError, ValueError) as problem:
            # While a recording is written anew, it is none for a moment.
            self._send(HTTPStatus.SERVICE_UNAVAILABLE, str(problem), "text/plain", with_body=with_body)
            return
        self._send(HTTPStatus.OK, text, "text/html" if is_page else "text/plain", with_body=with_body)

    def _told(self) -> str:
        """What a page asks about its recording."""
        samples = self._samples()
        if samples is None or self.server.since is None:
            return self.server.state()
        return self.server.since(samples)

    def _samples(self) -> int | None:
        """How many samples a page has that asks for more of a lift that runs; None if it does not."""
        match = _LIVE.fullmatch(self.path)
        return int(match.group(1)) if match and self.server.since is not None else None

    def _refused(self) -> HTTPStatus | None:
        """Why a request gets nothing; None if it does."""
        port = self.server.server_port
        if self.headers.get_all("Host") not in ([f"127.0.0.1:{port}"], [f"localhost:{port}"]):
            return HTTPStatus.MISDIRECTED_REQUEST
        if self.headers.get("Sec-Fetch-Site", "none") not in ("none", "same-origin"):
            return HTTPStatus.FORBIDDEN
        if self.headers.get("Content-Length", "0") != "0" or "Transfer-Encoding" in self.headers:
            return HTTPStatus(413)
        own = f"/{self.server.token}/"
        known = [own, f"{own}version"]
        samples = self._samples()
        if samples is not None:
            known.append(f"{own}live/{samples}")
        if not any(secrets.compare_digest(self.path.encode(), one.encode()) for one in known):
            return HTTPStatus.NOT_FOUND
        return None

    def _send(self, status: HTTPStatus, text: str, kind: str, *, with_body: bool) -> None:
        body = text.encode("utf-8")
        if len(body) > _LARGEST_PAGE:
            status, body, kind = HTTPStatus.INSUFFICIENT_STORAGE, b"the page is too large", "text/plain"
        self.send_response(status)
        self.send_header("Content-Type", f"{kind}; charset=utf-8")
        self.send_header("Content-Length", str(len(body)))
        self.send_header("Cache-Control", "no-store")
        self.send_header("Referrer-Policy", "no-referrer")
        self.send_header("X-Content-Type-Options", "nosniff")
        self.send_header("X-Frame-Options", "DENY")
        self.send_header("Cross-Origin-Resource-Policy", "same-origin")
        self.send_header("Connection", "close")
        policy = _POLICY.search(text) if kind == "text/html" else None
        said = policy.group(1).replace("&#39;", "'") if policy else "default-src 'none'"
        self.send_header("Content-Security-Policy", f"{said}; frame-ancestors 'none'")
        self.end_headers()
        if with_body:
            # A page that was closed meanwhile needs no answer.
            with suppress(ConnectionError):
                self.wfile.write(body)
        self.close_connection = True

    def log_message(self, format: str, *args: object) -> None:
        """Say nothing: the terminal belongs to the user."""
