"""`gantline doctor`: what is installed, what each optional part gives, what is wrong."""

from __future__ import annotations

import json
import platform
import shutil
import sys
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import Annotated

import typer

from gantline.cli.messages import CHECK_FAILED, DONE

#: Packages without which something is missing: import, distribution, what it gives, how to have it.
_PACKAGES = (
    ("OCP", "cadquery-ocp-novtk", "loads and hulls from STEP and IGES files", "pip install 'gantline[cad]'"),
    ("trimesh", "trimesh", "loads and hulls from glTF and GLB files", "pip install 'gantline[cad]'"),
    ("pyarrow", "pyarrow", "recordings as Parquet tables", "pip install pyarrow"),
    ("xarray", "xarray", "recordings as datasets (`recording.dataset`)", "pip install xarray"),
    ("rerun", "rerun-sdk", "recordings for the Rerun viewer (.rrd)", "pip install rerun-sdk"),
)
_OLDEST_PYTHON = (3, 11)
_MARKS = {"ok": "ok", "absent": "-", "wrong": "WRONG"}


@dataclass(frozen=True)
class Finding:
    """One part of the installation.

    Attributes:
        part: What it is.
        state: `ok`, `absent` (it is optional) or `wrong`.
        version: Its version or place; empty where it has none.
        gives: What it is for, or what is wrong and what would be right.
    """

    part: str
    state: str
    version: str
    gives: str


def doctor(
    as_json: Annotated[bool, typer.Option("--json", help="Print the findings as JSON.")] = False,
) -> None:
    """Say what is installed, what each optional part gives, and what is wrong.

    Ends with code 1 if something that gantline cannot do without is broken; an optional part that is not
    there is no fault.
    """
    found = list(findings())
    broken = any(one.state == "wrong" for one in found)
    if as_json:
        document = {"sound": not broken, "parts": [asdict(one) for one in found]}
        typer.echo(json.dumps(document, indent=2))
    else:
        typer.echo("\n".join(_lines(found)))
        typer.echo("\nSomething is broken, see above." if broken else "\nIn order.")
    raise typer.Exit(CHECK_FAILED if broken else DONE)


def findings() -> Iterator[Finding]:
    """Every part, what cannot be done without first."""
    from gantline.version import version

    is_new = sys.version_info[:2] >= _OLDEST_PYTHON
    wanted = ".".join(map(str, _OLDEST_PYTHON))
    running = f"{platform.python_version()} ({sys.executable})"
    yield Finding(
        "Python", "ok" if is_new else "wrong", running, "" if is_new else f"needs {wanted} or newer"
    )
    yield Finding("gantline", "ok", version(), str(Path(__file__).parents[1]))
    yield _core()
    yield _player()
    for module, distribution, gives, how in _PACKAGES:
        yield _package(module, distribution, gives, how)
    yield _program("ffmpeg", shutil.which("ffmpeg"), "films as MP4; GIF needs nothing")
    yield _browser()


def _core() -> Finding:
    """The compiled core: whether it can be loaded, and is as new as its sources where those are there."""
    try:
        # Only looked at, never used: that is for the simulation alone.
        core = import_module("gantline._core")
    except ImportError as problem:
        return Finding("core", "wrong", "", f"cannot be loaded ({problem}); 'make setup' builds it")
    library = Path(str(core.__file__))
    built = library.stat().st_mtime
    sources = Path(__file__).parents[3] / "crates"
    newer = [file for file in sources.rglob("*.rs") if file.stat().st_mtime > built]
    if newer:
        first = min(str(file.relative_to(sources.parent)) for file in newer)
        sentence = f"is older than {len(newer)} of its sources, such as {first}; 'make setup' builds it anew"
        return Finding("core", "wrong", str(library), sentence)
    return Finding("core", "ok", str(library), f"{library.stat().st_size / 1e6:.1f} MB, of this source")


def _player() -> Finding:
    from gantline.viewer import BundleMissing, bundle

    try:
        program = bundle()
    except BundleMissing as problem:
        return Finding("player", "wrong", "", f"{problem}; without it there are no reports")
    return Finding("player", "ok", f"{len(program.script) / 1e6:.1f} MB", "reports, and 'gantline view'")


def _package(module: str, distribution: str, gives: str, how: str) -> Finding:
    from importlib import metadata  # takes a sixth of the time of `gantline --help` to load

    if find_spec(module) is None:
        return Finding(distribution, "absent", "", f"{gives} ({how})")
    try:
        installed = metadata.version(distribution)
    except metadata.PackageNotFoundError:
        installed = ""
    return Finding(distribution, "ok", installed, gives)


def _program(name: str, place: str | None, gives: str, how: str = "a package of the system") -> Finding:
    if place is None:
        return Finding(name, "absent", "", f"{gives} ({how})")
    return Finding(name, "ok", place, gives)


def _browser() -> Finding:
    """The browser that tests look with: a variable may name one that is not there."""
    from gantline.viewer.chromium import VARIABLE, chromium

    gives = "the tests of report and player in a browser; any browser opens reports"
    place = chromium()
    if place is not None and shutil.which(place) is None:
        return _program("chromium", None, gives, f"{VARIABLE} names '{place}', which is no program here")
    return _program("chromium", place, gives)


def _lines(found: list[Finding]) -> list[str]:
    from gantline.cli.table import table

    rows = [(one.part, _MARKS[one.state], one.version, one.gives) for one in found]
    return table(("Part", "", "version", "what it gives"), rows, "llll")
