"""Holds an sdist or a wheel against the repository: whether it has all that an installation from it needs.

`make packages` builds both and looks at them so. `python tools/packages.py ARCHIVE…` names what is missing
and ends with code 1; a package without the player would install, and make no reports.
"""

from __future__ import annotations

import sys
import tarfile
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PLAYER = ("gantline/viewer/static/player.js", "gantline/viewer/static/player.css")
LICENCES = ("LICENSE", "THIRD_PARTY_LICENSES")
CORE = "gantline/_core.abi3.so"
BUILT = {".so", ".pyc"}


def package_files() -> set[str]:
    """Files of the Python package as they are installed: all of its folder, the player, but no library."""
    folder = ROOT / "python"
    found = {path for path in (folder / "gantline").rglob("*") if path.is_file() and path.suffix not in BUILT}
    return {path.relative_to(folder).as_posix() for path in found} | set(PLAYER)


def sources() -> set[str]:
    """What an installation from the sdist compiles, by place in the repository."""
    crates = [*ROOT.glob("crates/*/Cargo.toml"), *ROOT.glob("crates/*/src/**/*.rs")]
    named = {path.relative_to(ROOT).as_posix() for path in crates}
    return named | {"Cargo.toml", "Cargo.lock", "pyproject.toml", "README.md"}


def names(archive: Path) -> set[str]:
    """Files of an archive; those of an sdist without its folder."""
    if archive.suffix == ".whl":
        return set(zipfile.ZipFile(archive).namelist())
    with tarfile.open(archive) as opened:
        return {member.name.partition("/")[2] for member in opened if member.isfile()}


def lacking(archive: Path) -> list[str]:
    """What the archive should hold and does not, in order."""
    held = names(archive)
    if archive.suffix == ".whl":
        information = "-".join(archive.name.split("-")[:2]) + ".dist-info"
        needed = package_files() | {CORE} | {f"{information}/licenses/{name}" for name in LICENCES}
    else:
        needed = {f"python/{name}" for name in package_files()} | sources() | set(LICENCES)
    return sorted(needed - held)


def main(archives: list[str]) -> int:
    """Print a line for each archive; the code to end with."""
    code = 0
    for archive in map(Path, archives):
        missing = lacking(archive)
        print(f"{archive}: " + (f"lacks {', '.join(missing)}" if missing else "whole"))
        code = 1 if missing else code
    return code


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
