"""`gantline report`: one file that shows a recording in any browser, without a network."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from gantline.cli.lift import opened, recording_file, refuse_to_replace, warn_of_gaps
from gantline.cli.messages import stop, warn, writing

if TYPE_CHECKING:
    from gantline.results.recording import Recording

#: Name of the report beside a recording.
REPORT = "report.html"

#: The recording that a verb is about.
Recorded = Annotated[
    Path, typer.Argument(metavar="RECORDING", help="Recording (.nc), or a folder that `gantline run` wrote.")
]


def report(
    recording: Recorded,
    output: Annotated[
        Path | None,
        typer.Option(
            "--output",
            "-o",
            metavar="FILE",
            help="File to write.  [default: report.html beside the recording]",
        ),
    ] = None,
) -> None:
    """Write the report of a recording: a lift plan with the lift played in 3D and its curves, in one file.

    It opens by a double click, prints to A4, and reads nothing from a network.
    """
    from gantline.report import write_report
    from gantline.results.file.saved import FILES_BESIDE, read_beside
    from gantline.viewer import BundleMissing

    file = asked_for(recording)
    target = output if output is not None else file.parent / REPORT
    if target.is_dir():
        stop(f"{target}: is a folder; --output needs a file")
    if target.suffix.lower() == ".nc":
        stop(f"{target}: ends with '.nc' as recordings do; a report is a file such as {REPORT}")
    read = [file, *(file.parent / name for name in FILES_BESIDE)]
    refuse_to_replace(read, [target], "--output needs another file")
    try:
        found = opened(file)
        beside = read_beside(file.parent, found)
        with writing(target):
            written = write_report(found, target, beside=beside)
    except (BundleMissing, ValueError) as problem:
        stop(f"{file}: {problem}")
    warn_of_gaps(found)
    for sentence in beside.left_out:
        warn(f"not in the report: {sentence}")
    typer.echo(f"Report      {written}")


def asked_for(recording: Path) -> Path:
    """The file of the recording that is meant; ends the program if there is none."""
    file = recording_file(recording)
    if file is None:
        stop(f"{recording}: is no recording (.nc) and no folder with one; 'gantline run' makes recordings")
    return file


def write_beside(recording: Recording, target: Path, *, aside: bool) -> None:
    """Write a report at the end of a run; a warning where that cannot be.

    Args:
        recording: What to report.
        target: File to write.
        aside: Whether standard output belongs to something else.
    """
    from gantline.report import write_report
    from gantline.viewer import BundleMissing

    try:
        with writing(target):
            written = write_report(recording, target)
    except (BundleMissing, ValueError) as problem:
        warn(f"no report: {problem}")
        return
    typer.echo(f"Report      {written}", err=aside)
