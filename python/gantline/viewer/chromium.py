"""The system's Chromium, which tests and benchmarks open pages in."""

from __future__ import annotations

import os
import shutil

VARIABLE = "GANTLINE_CHROMIUM"
NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")


def chromium() -> str | None:
    """Where it is: what the variable `VARIABLE` says, else the first of `NAMES` on the path."""
    return os.environ.get(VARIABLE) or next((p for n in NAMES if (p := shutil.which(n))), None)
