"""Writing files at once: under another name first, then renamed, so that nobody meets half a file."""

from __future__ import annotations

import errno
import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

__all__ = ["replaced"]


@contextmanager
def replaced(path: Path) -> Iterator[Path]:
    """A file to write, which takes the place of `path` once it is complete, and else is gone.

    A link stays a link: what it leads to is replaced. A device or a pipe is no file to replace: it is
    written itself.

    Raises:
        OSError: If there is no writing there.
    """
    target = Path(os.path.realpath(path))
    if target.exists() and not target.is_file():
        yield target
        return
    if not target.parent.is_dir():
        raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), str(target.parent))
    handle, name = tempfile.mkstemp(prefix=f".{target.name}.", suffix=".part", dir=target.parent)
    os.close(handle)
    trial = Path(name)
    try:
        yield trial
        # `mkstemp` keeps others out, which the file itself would not.
        trial.chmod(0o666 & ~_umask())
        trial.replace(target)
    except BaseException:
        trial.unlink(missing_ok=True)
        raise


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask
