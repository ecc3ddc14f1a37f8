"""The version of gantline."""

from __future__ import annotations

from functools import cache


@cache
def version() -> str:
    """Version of the installed package; the one place that knows it is Cargo.toml."""
    from importlib.metadata import version as installed

    return installed("gantline")
