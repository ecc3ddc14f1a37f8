"""A lift file that is being written: simulated, and its report made, anew whenever it changes."""

from __future__ import annotations

import threading
from pathlib import Path
from typing import TYPE_CHECKING

import typer

from gantline.cli.messages import complain
from gantline.opened import GONE, note_opened, noted_opened, state_of

if TYPE_CHECKING:
    from gantline.results.recording import Recording
    from gantline.simulation import Simulation, SimulationError

#: Between two looks at the files [s].
_EVERY = 0.5


class Draft:
    """The report of a lift file as it stands; nothing is written.

    Args:
        file: The lift file.
    """

    def __init__(self, file: Path) -> None:
        from gantline.report import render_notice

        self._file = file
        self._ended = threading.Event()
        #: State of each file that was opened for what is shown, before that.
        self._read: dict[Path, str] = {}
        self._recording: Recording | None = None
        notice = f"{file} is being simulated; its report will stand here."
        # Together, for a page must not be told that it is the newest when it is not.
        self._shown = (0, render_notice(str(file), notice, reload_from="version"))

    def state(self) -> str:
        """Changes whenever there is another report."""
        return str(self._shown[0])

    def text(self) -> str:
        """The report as HTML, or why there is none."""
        return self._shown[1]

    def follow(self) -> None:
        """Make reports until `end` is called; the terminal gets the verdict of each, or what is wrong."""
        while not self._ended.is_set():
            # Many editors save by putting another file in its place, and for a moment there is none.
            if not self._is_as_read() and state_of(self._file) != GONE:
                with noted_opened() as self._read:
                    note_opened(self._file)
                    self._make()
            self._ended.wait(_EVERY)

    def end(self) -> None:
        """Stop a simulation under way, and make no more."""
        self._ended.set()

    def _is_as_read(self) -> bool:
        """Whether all files that were opened for what is shown are as they were then; if any were."""
        # A copy, since the lift may be read meanwhile.
        read = dict(self._read)
        return bool(read) and all(state_of(file) == state for file, state in read.items())

    def _make(self) -> None:
        from gantline.scenario import ScenarioError
        from gantline.simulation import Simulation

        try:
            simulation = Simulation(self._file)
        except ScenarioError as problem:
            complain(str(problem))
            before = "; below is how it was before" if self._recording is not None else ""
            self._show(f"The lift file is refused{before}.\n\n{problem}")
            return
        recording, failure = self._simulated(simulation)
        if recording.attributes["status"] == "stopped":
            return
        self._recording = recording if len(recording.time) else None
        if failure is not None:
            complain(str(failure))
            self._show(str(failure))
            return
        self._tell(recording)
        self._show("")

    def _simulated(self, simulation: Simulation) -> tuple[Recording, SimulationError | None]:
        """What was recorded, and why it could not go on if it could not; stopped where a file has changed."""
        from gantline.simulation import SimulationError

        def goes_on(_: float) -> bool:
            return not self._ended.is_set() and self._is_as_read()

        try:
            return simulation.run(on_progress=goes_on), None
        except SimulationError as problem:
            return problem.recording, problem

    def _tell(self, recording: Recording) -> None:
        from gantline.checks import check_recording, verdict_of

        typer.echo(f"{recording.attributes['title']}: {verdict_of(check_recording(recording))}")

    def _show(self, notice: str) -> None:
        from gantline.report import render_notice, render_report

        number, title = self._shown[0] + 1, str(self._file)
        if self._recording is None:
            self._shown = (number, render_notice(title, notice, reload_from="version"))
            return
        try:
            text = render_report(self._recording, reload_from="version", notice=notice)
        except ValueError as problem:
            text = render_notice(title, str(problem), reload_from="version")
        self._shown = (number, text)
