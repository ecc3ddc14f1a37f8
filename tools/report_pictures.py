"""Draws the pictures of reports in README and documentation anew, as the system's Chromium shows them.

    python tools/report_pictures.py

`viewer/browser/report.pictures.ts` says which.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from PIL import Image

from gantline.viewer.chromium import chromium

ROOT = Path(__file__).resolve().parents[1]
VIEWER = ROOT / "viewer"
SCENARIOS = ("goliath", "floating_crane")
LARGEST = 150_000  # bytes of a picture
#: Width [pixels] and quality of WebP, the best first; None is without loss.
TRIES = ((1000, None), (1000, 90), (1000, 80), (850, 80), (700, 80))


def pages(folder: Path) -> None:
    """Write the reports of the scenarios, with what they are like at rest."""
    for name in SCENARIOS:
        for verb in ("run", "statics"):
            command = [sys.executable, "-m", "gantline", verb, str(ROOT / "scenarios" / name)]
            subprocess.run([*command, "-o", str(folder / name)], check=True, stdout=subprocess.DEVNULL)
        report = [sys.executable, "-m", "gantline", "report", str(folder / name / "recording.nc")]
        subprocess.run([*report, "-o", str(folder / f"{name}.html")], check=True, stdout=subprocess.DEVNULL)


def keep(drawn: Path, target: Path) -> None:
    """Write a picture as well as its size allows.

    Raises:
        SystemExit: if it stays too large.
    """
    whole = Image.open(drawn).convert("RGB")
    size = 0
    for widest, quality in TRIES:
        width = min(widest, whole.width)
        fitted = whole.resize((width, round(whole.height * width / whole.width)), Image.Resampling.LANCZOS)
        fitted.save(target, "WEBP", lossless=quality is None, quality=quality or 100, method=6)
        size = target.stat().st_size
        if size <= LARGEST:
            print(f"{target.relative_to(ROOT)}: {size / 1e3:.0f} kB")
            return
    raise SystemExit(f"{target.name} has {size / 1e3:.0f} kB; {LARGEST / 1e3:.0f} kB are wanted")


def main() -> None:
    """Simulate, write reports, draw, and keep the files small."""
    browser, node = chromium(), shutil.which("node")
    if browser is None or node is None:
        raise SystemExit("needs Node and a Chromium; 'gantline doctor' says what is here")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        pages(folder)
        drawn = folder / "pictures"
        drawn.mkdir()
        command = [node, "node_modules/vitest/vitest.mjs", "run", "--config", "vitest.pictures.config.ts"]
        given = {"GANTLINE_PAGES": str(folder), "GANTLINE_CHROMIUM": browser, "GANTLINE_PICTURES": str(drawn)}
        subprocess.run(command, cwd=VIEWER, env={**os.environ, **given}, check=True)
        for picture in sorted(drawn.glob("*.png")):
            keep(picture, ROOT / "docs" / "images" / f"{picture.stem}.webp")


if __name__ == "__main__":
    main()
