"""`gantline view`: the report in a browser, made anew whenever what it shows changes."""

from __future__ import annotations

import threading
import webbrowser
from pathlib import Path
from typing import Annotated

import typer

from gantline.cli.messages import stop
from gantline.cli.report import Recorded, asked_for

#: What a page is told while there is nothing to load: it stays as it is.
_GONE = "gone"
#: Recordings from this size on take more than a second to make a page of, of which a line says so [bytes].
LARGE = 5_000_000


def view(
    recording: Recorded,
    port: Annotated[int, typer.Option(metavar="N", min=0, max=65535, help="Port; 0 takes a free one.")] = 0,
    browser: Annotated[bool, typer.Option("--browser/--no-browser", help="Open a browser.")] = True,
) -> None:
    """Show a recording in the browser of this machine, and again whenever it changes; Ctrl-C ends it.

    Equilibrium and cases of the same lift beside it are shown and watched too. The page is served to this
    machine alone, at an address that nobody can guess.
    """
    from gantline.viewer import BundleMissing
    from gantline.viewer.server import PageServer

    file = asked_for(recording)
    page = _Page(file)
    try:
        server = PageServer(page.text, page.state, port)
    except OSError as problem:
        stop(f"--port: {port} cannot be used ({(problem.strerror or str(problem)).lower()})")
    size = file.stat().st_size if file.is_file() else 0
    if size >= LARGE:
        shown = f"{size / 1e6:.3g} MB"
        typer.echo(f"making the page of {file} ({shown}); it will be at {server.address}", err=True)
    try:
        page.text()
    except (BundleMissing, FileNotFoundError, ValueError) as problem:
        server.server_close()
        stop(f"{file}: {problem}" if str(file) not in str(problem) else str(problem))
    typer.echo(f"{server.address}\nCtrl-C ends it.")
    if browser:
        webbrowser.open(server.address)
    try:
        server.serve_forever()
    except KeyboardInterrupt:
        pass
    finally:
        server.server_close()


class _Page:
    """The report of a recording, made anew only when what it shows has changed: that takes seconds.

    Args:
        file: The recording.
    """

    def __init__(self, file: Path) -> None:
        from gantline.results.file.saved import FILES_BESIDE

        self._file = file
        self._beside = [file.parent / name for name in FILES_BESIDE]
        self._made_of = ""
        self._text = ""
        # Pages ask each in a thread of its own; the second one waits for what is made for the first.
        self._making = threading.Lock()

    def state(self) -> str:
        """Changes whenever one of the files is written anew; 'gone' while there is no recording to show."""
        own = _state_of(self._file)
        return own if own == _GONE else " ".join([own, *map(_state_of, self._beside)])

    def text(self) -> str:
        """The report as HTML.

        Raises:
            BundleMissing: If the player is not built.
            FileNotFoundError: If there is no recording.
            ValueError: If it is none.
        """
        from gantline.report import render_report
        from gantline.results import open_recording
        from gantline.results.file.saved import read_beside

        with self._making:
            # Of before it is read: what is written meanwhile is another state.
            state = self.state()
            if state != self._made_of or state == _GONE:
                recording = open_recording(self._file)
                beside = read_beside(self._file.parent, recording)
                self._text = render_report(recording, beside=beside, reload_from="version")
                self._made_of = state
            return self._text


def _state_of(file: Path) -> str:
    try:
        about = file.stat()
    except OSError:
        return _GONE
    return f"{about.st_mtime_ns}-{about.st_size}"
