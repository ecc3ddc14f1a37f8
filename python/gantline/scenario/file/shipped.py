"""The lifts that come with gantline, known by their names wherever it is installed."""

from __future__ import annotations

from pathlib import Path

__all__ = ["shipped"]

# In a checkout these are links to the lift files of the folder `scenarios`; in a wheel, the files themselves.
_FOLDER = Path(__file__).resolve().parents[2] / "scenarios"


def shipped() -> dict[str, Path]:
    """Lift files that come with gantline, by name in alphabetical order."""
    return {path.stem: path for path in sorted(_FOLDER.glob("*.yaml"))}
