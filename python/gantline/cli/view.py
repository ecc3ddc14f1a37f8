"""`gantline view`: the report in a browser, made anew whenever what it shows changes."""

from __future__ import annotations

import webbrowser
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated

import typer

from gantline.cli.messages import stop
from gantline.cli.report import Recorded, asked_for

#: What a page is told while there is nothing to load: it stays as it is.
_GONE = "gone"


def view(
    recording: Recorded,
    port: Annotated[int, typer.Option(min=0, max=65535, help="Port; 0 takes a free one.")] = 0,
    browser: Annotated[bool, typer.Option("--browser/--no-browser", help="Open a browser.")] = True,
) -> None:
    """Show a recording in the browser of this machine, and again whenever it changes; Ctrl-C ends it.

    Equilibrium and cases of the same lift beside it are shown and watched too. The page is served to this
    machine alone, at an address that nobody can guess.
    """
    from gantline.report import render_report
    from gantline.results import open_recording
    from gantline.results.saved import FILES_BESIDE, read_beside
    from gantline.viewer import BundleMissing
    from gantline.viewer.server import PageServer

    file = asked_for(recording)
    beside = [file.parent / name for name in FILES_BESIDE]

    def page() -> str:
        recording = open_recording(file)
        return render_report(recording, beside=read_beside(file.parent, recording), reload_from="version")

    try:
        page()
    except (BundleMissing, FileNotFoundError, ValueError) as problem:
        stop(f"{file}: {problem}" if str(file) not in str(problem) else str(problem))
    try:
        server = PageServer(page, lambda: _state(file, beside), port)
    except OSError as problem:
        stop(f"port {port}: cannot be used ({(problem.strerror or str(problem)).lower()})")
    typer.echo(f"{server.address}\nCtrl-C ends it.")
    if browser:
        webbrowser.open(server.address)
    try:
        server.serve_forever()
    except KeyboardInterrupt:
        pass
    finally:
        server.server_close()


def _state(recording: Path, beside: Sequence[Path]) -> str:
    """Changes whenever one of the files is written anew; 'gone' while there is no recording to show."""
    own = _state_of(recording)
    return own if own == _GONE else " ".join([own, *map(_state_of, beside)])


def _state_of(file: Path) -> str:
    try:
        about = file.stat()
    except OSError:
        return _GONE
    return f"{about.st_mtime_ns}-{about.st_size}"
