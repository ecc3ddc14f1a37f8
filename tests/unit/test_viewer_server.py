"""The local server: what it gives, and to whom it gives nothing."""

from __future__ import annotations

import http.client
import threading
from collections.abc import Iterator

import pytest

from gantline.viewer.inline import policy
from gantline.viewer.server import PageServer

POLICY = policy(["run()"], [], connect="'self'")
PAGE = f'<meta http-equiv="Content-Security-Policy" content="{POLICY.replace(chr(39), "&#39;")}">page'


class Served:
    """A server in a thread, and requests to it as one likes to make them."""

    def __init__(self) -> None:
        self.state = "1"
        self.pages = [PAGE]
        self.server = PageServer(lambda: self.pages[-1], lambda: self.state)
        self.thread = threading.Thread(target=self.server.serve_forever, daemon=True)
        self.thread.start()

    def get(
        self, path: str, *, host: str | None = None, method: str = "GET", **headers: str
    ) -> tuple[int, str, http.client.HTTPMessage]:
        connection = http.client.HTTPConnection("127.0.0.1", self.server.server_port, timeout=10)
        connection.putrequest(method, path, skip_host=True, skip_accept_encoding=True)
        connection.putheader("Host", host or f"127.0.0.1:{self.server.server_port}")
        for name, value in headers.items():
            connection.putheader(name.replace("_", "-"), value)
        connection.endheaders()
        answer = connection.getresponse()
        return answer.status, answer.read().decode(), answer.headers

    def own(self, name: str = "") -> str:
        return f"/{self.server.token}/{name}"


@pytest.fixture
def served() -> Iterator[Served]:
    one = Served()
    yield one
    one.server.shutdown()
    one.server.server_close()


def test_the_page_is_served_at_its_address_to_this_machine_alone(served: Served) -> None:
    assert served.server.server_address[0] == "127.0.0.1"
    assert len(served.server.token) >= 32  # 24 random bytes
    status, text, headers = served.get(served.own())
    assert (status, text) == (200, PAGE)
    assert headers["Content-Security-Policy"] == f"{POLICY}; frame-ancestors 'none'"
    assert headers["Cache-Control"] == "no-store" and headers["X-Content-Type-Options"] == "nosniff"


def test_the_page_can_ask_whether_it_has_changed(served: Served) -> None:
    assert served.get(served.own("version"))[:2] == (200, "1")
    served.state = "2"
    assert served.get(served.own("version"))[:2] == (200, "2")


@pytest.mark.parametrize(
    "path",
    [
        "/",
        "/wrong-token/",
        "/../../etc/passwd",
        "{own}../../../etc/passwd",
        "{own}%2e%2e/%2e%2e/etc/passwd",
        "{own}/etc/passwd",
        "{own}recording.nc",
        "{own}?x=1",
        "{own}version/..",
        "//127.0.0.1{own}",
    ],
)
def test_nothing_else_can_be_read(served: Served, path: str) -> None:
    status, text, _ = served.get(path.format(own=served.own()))
    assert (status, text) == (404, "Not Found")


@pytest.mark.parametrize(
    "host", ["evil.example", "evil.example:{port}", "127.0.0.1", "[::1]:{port}", "127.0.0.1:1"]
)
def test_other_hosts_are_refused(served: Served, host: str) -> None:
    assert served.get(served.own(), host=host.format(port=served.server.server_port))[0] == 421


def test_localhost_is_this_host(served: Served) -> None:
    assert served.get(served.own(), host=f"localhost:{served.server.server_port}")[0] == 200


def test_requests_of_other_pages_are_refused(served: Served) -> None:
    assert served.get(served.own(), Sec_Fetch_Site="cross-site")[0] == 403
    assert served.get(served.own(), Sec_Fetch_Site="same-origin")[0] == 200


def test_requests_with_a_body_and_other_methods_are_refused(served: Served) -> None:
    assert served.get(served.own(), Content_Length="5")[0] == 413
    assert served.get(served.own(), method="POST")[0] == 501
    assert served.get(served.own(), method="HEAD")[:2] == (200, "")


def test_a_page_that_cannot_be_made_is_a_sentence(served: Served) -> None:
    def broken() -> str:
        raise ValueError("not a recording")

    served.server.page = broken
    assert served.get(served.own())[:2] == (503, "not a recording")


def test_a_page_that_is_too_large_is_not_sent(served: Served, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("gantline.viewer.server._LARGEST_PAGE", 10)
    assert served.get(served.own())[:2] == (507, "the page is too large")
