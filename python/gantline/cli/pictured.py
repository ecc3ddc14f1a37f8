"""Numbers and their picture as files of one folder."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__all__ = ["write_pictured"]

_DOTS_PER_INCH = 200


def write_pictured(figure: Figure, text: str, numbers: Path) -> Path:
    """Write numbers, and beside them a picture of the same name: both, or none where one cannot be written.

    Args:
        figure: The picture.
        text: The numbers.
        numbers: File of these; what is there is replaced.

    Returns:
        File of the picture.

    Raises:
        OSError: If they cannot be written.
    """
    from gantline.replacing import replace_text, replaced

    picture = numbers.with_suffix(".png")
    with replaced(picture) as trial:
        figure.savefig(trial, format="png", dpi=_DOTS_PER_INCH)
        replace_text(numbers, text)
    return picture
