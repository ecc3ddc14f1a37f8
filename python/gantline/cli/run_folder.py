"""The folder that `gantline run` writes: all in it that a run makes is of one run."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from gantline.cli.lift import RECORDING
from gantline.cli.messages import writing
from gantline.cli.report import REPORT
from gantline.replacing import remove_file

if TYPE_CHECKING:
    from gantline.results.recording import Recording

__all__ = ["STATE", "save_run"]

#: Name of the last good state that a run leaves which cannot go on.
STATE = "state.bin"


def save_run(recording: Recording, folder: Path) -> Path:
    """Save a recording, and remove what an earlier run left beside its own.

    Report, pictures and last good state of another run would pass for those of this one, and it may end
    before it makes its own. What others wrote, and what `gantline cases` and `gantline statics` did, stays.

    Returns:
        The file of the recording.
    """
    with writing(folder):
        for path in _left_by_a_run(folder, recording):
            remove_file(path)
        return recording.save(folder / RECORDING)


def _left_by_a_run(folder: Path, recording: Recording) -> Iterator[Path]:
    """Files of the names that a run writes beside its recording."""
    yield folder / REPORT
    yield folder / STATE
    if any(folder.glob("*.png")):
        from gantline.plot.pictures import picture_files

        equalizers = {one.name for one in recording.rig.equalizers} | _equalizers_before(folder)
        yield from (folder / name for name in picture_files(equalizers))


def _equalizers_before(folder: Path) -> set[str]:
    """Equalizers of the recording that is there; none of one that cannot be read."""
    from gantline.results.file.netcdf import load_rig

    if not any(folder.glob("equalizer_*.png")):
        return set()
    try:
        return {one.name for one in load_rig(folder / RECORDING).equalizers}
    except (FileNotFoundError, ValueError):
        return set()
