"""What goes wrong while a CAD file is read."""

from __future__ import annotations

__all__ = ["CadError"]


class CadError(ValueError):
    """A CAD file cannot be used; the message is one plain sentence that names the file."""
