"""`gantline view`: a report in a browser, of a recording or of a lift file, anew whenever that changes."""

from __future__ import annotations

import threading
import webbrowser
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Annotated, Protocol

import typer

from gantline.cli.draft import Draft
from gantline.cli.lift import lifts_that_begin, recording_file
from gantline.cli.messages import scenario_errors, stop
from gantline.opened import GONE, state_of

#: Recordings from this size on take more than a second to make a page of, of which a line says so [bytes].
LARGE = 5_000_000


def view(
    lift: Annotated[
        Path,
        typer.Argument(
            metavar="LIFT|RECORDING",
            help="Recording (.nc), or a folder that `gantline run` wrote; or a lift file, its folder, or the "
            "name of a lift that comes with gantline.",
            autocompletion=lifts_that_begin,
        ),
    ],
    port: Annotated[int, typer.Option(metavar="N", min=0, max=65535, help="Port; 0 takes a free one.")] = 0,
    browser: Annotated[bool, typer.Option("--browser/--no-browser", help="Open a browser.")] = True,
) -> None:
    """Show a report in the browser of this machine, and again whenever it changes; Ctrl-C ends it.

    Of a recording, equilibrium and cases of the same lift beside it are shown and watched too. A lift file is
    simulated as it stands, at once and whenever it or a file that it names is saved: what is wrong with it
    stands above the last report, and nothing is written. The page is served to this machine alone, at an
    address that nobody can guess.
    """
    file = recording_file(lift)
    if file is None:
        with _draft_of(lift) as draft:
            _serve(draft, port, browser=browser)
        return
    page = _Page(file)
    _serve(page, port, browser=browser, first=page.try_out)


class _Shown(Protocol):
    """What is served."""

    def state(self) -> str:
        """Changes whenever the page does."""

    def text(self) -> str:
        """The page."""


@contextmanager
def _draft_of(lift: Path) -> Iterator[Draft]:
    """A lift file that is followed as it is written."""
    from gantline.scenario.file.reading import lift_file
    from gantline.scenario.file.tree import read_text
    from gantline.viewer import BundleMissing

    with scenario_errors():
        file = lift_file(lift)
        if state_of(file) == GONE or not file.is_file():
            read_text(file, str(file))
    try:
        draft = Draft(file)
    except BundleMissing as problem:
        stop(str(problem))
    following = threading.Thread(target=draft.follow, daemon=True)

    following.start()
    try:
        yield draft
    finally:
        draft.end()
        following.join()


def _serve(shown: _Shown, port: int, *, browser: bool, first: Callable[[str], None] = lambda _: None) -> None:
    """Serve a page until Ctrl-C; `first` is called with its address before anybody is told of it."""
    from gantline.viewer.server import PageServer

    try:
        server = PageServer(shown.text, shown.state, port)
    except OSError as problem:
        stop(f"--port: {port} cannot be used ({(problem.strerror or str(problem)).lower()})")
    try:
        first(server.address)
        typer.echo(f"{server.address}\nCtrl-C ends it.")
        if browser:
            webbrowser.open(server.address)
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

    def try_out(self, address: str) -> None:
        """Make the page; what is wrong ends the program. Of a large recording a line says where it is."""
        from gantline.viewer import BundleMissing

        size = self._file.stat().st_size if self._file.is_file() else 0
        if size >= LARGE:
            shown = f"{size / 1e6:.3g} MB"
            typer.echo(f"making the page of {self._file} ({shown}); it will be at {address}", err=True)
        try:
            self.text()
        except (BundleMissing, FileNotFoundError, ValueError) as problem:
            file = str(self._file)
            stop(f"{file}: {problem}" if file not in str(problem) else str(problem))

    def state(self) -> str:
        """Changes whenever one of the files is written anew; 'gone' while there is no recording to show."""
        own = state_of(self._file)
        return own if own == GONE else " ".join([own, *map(state_of, self._beside)])

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
            if state != self._made_of or state == GONE:
                recording = open_recording(self._file)
                beside = read_beside(self._file.parent, recording)
                self._text = render_report(recording, beside=beside, reload_from="version")
                self._made_of = state
            return self._text
