"""What `gantline run --live` shows while it runs."""

from __future__ import annotations

import threading
import webbrowser
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from typing import TYPE_CHECKING

import typer

from gantline.cli.messages import stop

if TYPE_CHECKING:
    from gantline.simulation import Simulation
    from gantline.viewer.live import LiveView

_COMING = 10.0  # s that a browser may take to open the page of a lift that is already over


@contextmanager
def live_view(simulation: Simulation, *, browser: bool, aside: bool) -> Iterator[LiveView]:
    """Serve a running lift to the browser of this machine; at the end a page that looks gets all of it.

    Args:
        simulation: What runs.
        browser: Whether to open a browser.
        aside: Whether standard output belongs to something else.

    Yields:
        What is to be told of the run: `offer` while it runs, `finish` at its end.
    """
    from gantline.report import render_live
    from gantline.viewer import BundleMissing, bundle
    from gantline.viewer.live import LiveView
    from gantline.viewer.server import PageServer

    try:
        bundle()
    except BundleMissing as problem:
        stop(f"--live: {problem}")
    view = LiveView(simulation.recording, simulation.duration)
    server = PageServer(lambda: render_live(view.first()), lambda: "", since=view.since)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    typer.echo(f"Live        {server.address}", err=aside)
    if browser:
        webbrowser.open(server.address)
    try:
        yield view
    finally:
        with suppress(KeyboardInterrupt):
            view.wait_for_readers(_COMING)
        server.shutdown()
        server.server_close()
