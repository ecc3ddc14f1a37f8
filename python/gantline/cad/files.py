"""What all readers of CAD files do first: does it exist, is it of a bearable size."""

from __future__ import annotations

import gzip
from difflib import get_close_matches
from pathlib import Path

from gantline.cad.errors import CadError

__all__ = ["content", "missing"]

#: Bytes of a file, unpacked.
_LARGEST = 500_000_000
#: How alike a name has to be that may be meant, of 1.
_ALIKE = 0.8


def content(path: Path) -> bytes:
    """All bytes of a file; one that ends on ``.gz`` is unpacked.

    Raises:
        CadError: if it cannot be read, is empty or too large.
    """
    try:
        if path.stat().st_size > _LARGEST:
            raise CadError(f"{path}: larger than {_LARGEST // 1_000_000} MB, so it is not read")
        if path.suffix.lower() == ".gz":
            with gzip.open(path) as packed:
                data = packed.read(_LARGEST + 1)
        else:
            data = path.read_bytes()
    except CadError:
        raise
    except ValueError:  # a name with a zero byte
        raise CadError(f"{path}: cannot be read (not a usable file name)") from None
    except (OSError, EOFError) as problem:
        reason = getattr(problem, "strerror", None) or str(problem)
        raise CadError(f"{path}: cannot be read ({reason.lower()}){_instead(path)}") from None
    if len(data) > _LARGEST:
        raise CadError(f"{path}: larger than {_LARGEST // 1_000_000} MB when unpacked, so it is not read")
    if not data:
        raise CadError(f"{path}: the file is empty")
    return data


def _instead(path: Path) -> str:
    """Which file beside one that is not there may be meant."""
    try:
        beside = {one.name.lower(): one.name for one in path.parent.iterdir()}
        # Has an error of its own where a name is too long, or a folder may not be entered.
        is_there = path.exists()
    except OSError:
        return ""
    near = [] if is_there else get_close_matches(path.name.lower(), beside, 1, _ALIKE)
    return f"; is '{beside[near[0]]}' meant?" if near else ""


def missing(path: Path, package: str) -> CadError:
    """The error that a package of the extra is not installed."""
    return CadError(
        f"{path}: reading this format needs {package}; install it with: pip install 'gantline[cad]'"
    )
