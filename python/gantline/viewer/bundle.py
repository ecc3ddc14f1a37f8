"""The player's program and style sheet, built from `viewer/` by `make setup`."""

from __future__ import annotations

from dataclasses import dataclass
from importlib.resources import files


class BundleMissing(RuntimeError):
    """The player was not built in this installation; the message is a plain sentence."""


@dataclass(frozen=True)
class Bundle:
    """What a page needs besides its data.

    Attributes:
        script: JavaScript.
        style: CSS.
    """

    script: str
    style: str


def bundle() -> Bundle:
    """The player as it was built.

    Raises:
        BundleMissing: If it was not.
    """
    folder = files("gantline.viewer") / "static"
    try:
        script, style = ((folder / name).read_text(encoding="utf-8") for name in ("player.js", "player.css"))
    except OSError:
        raise BundleMissing(
            "the player is not built in this installation; 'make setup' in the source folder builds it"
        ) from None
    return Bundle(script, style)
