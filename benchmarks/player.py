"""What the report costs in a browser: size, opening, frames and script of the player, for large lifts.

    python -m benchmarks.player [SCENARIO ...]

Pages of `scenarios/goliath` and of a lift with 100 slings are opened by file in the system's Chromium, which
draws in software; the drawing is 640 by 360 pixels. Opening ends when the page can be used.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import tempfile
from itertools import pairwise
from pathlib import Path
from typing import Any

from rich.console import Console
from rich.table import Table

import gantline
from gantline.report import write_report
from gantline.viewer.chromium import chromium

ROOT = Path(__file__).resolve().parents[1]
VIEWER = ROOT / "viewer"
SLINGS = 100
_PITCH = 1.6  # m


def lift_with_slings(count: int) -> str:
    """A lift file: an equalizer of a row of moving sheaves, a sling from each to a long load."""
    along = [_PITCH * (place - (count - 1) / 2) for place in range(count)]
    between = [(one + other) / 2 for one, other in pairwise(along)]
    ends = [along[0] - _PITCH / 2, along[-1] + _PITCH / 2]
    mass = 60.0 * count
    lengths = [25.2 + 0.1 * ((7 * place) % 11 - 5) / 5 for place in range(count)]

    def row(places: list[float]) -> list[str]:
        return [f"{place:.3f} m" for place in places]

    sheaves = {"pitch_diameter": "0.8 m", "efficiency": 1.0, "rotating_mass": "0 kg"}
    document: dict[str, Any] = {
        "format": 1,
        "lift": {"title": f"{count} slings on one equalizer"},
        "duration": "40 s",
        # As stiff as the load is heavy: under 400 slings it would else sink in until slings were too short.
        "ground": {
            "level": "0 m",
            "friction": 0.5,
            "stiffness": f"{20 * count} MN/m",
            "damping": f"{0.2 * count:g} MN s/m",
        },
        "ropes": {
            "sling": {"axial_stiffness": "200 MN", "damping_time": "2 ms", "mass": "none"},
            "equalizing": {"axial_stiffness": "100 MN", "damping_time": "2 ms", "mass": "none"},
        },
        "load": {
            "name": "block",
            "shape": {"box": [f"{_PITCH * count:g} m", "10 m", "5 m"]},
            "datum": "bottom_centre",
            "position": ["0 m", "0 m", "0 m"],
            "heading": "0 deg",
            "weight": {"calculated": f"{mass:g} t", "contingency": 1.0},
            "inertia": "homogeneous",
            "centre_of_gravity": {"at": ["0 m", "0 m", "2.5 m"]},
            "stands_on": "ground",
            "lugs": {
                f"L{place}": {"at": [f"{x:.3f} m", f"{2.5 * (place % 3 - 1):g} m", "5 m"]}
                for place, x in enumerate(along, 1)
            },
        },
        "cranes": {
            "hook": {
                "type": "fixed_hook",
                "at": ["0 m", "0 m", "38.6 m"],
                "hoist": {"speed": "0.1 m/s", "acceleration": "0.1 m/s^2"},
            }
        },
        "equalizers": {
            "e1": {
                "hangs_from": "hook",
                "heading": "0 deg",
                "frame": {
                    "mass": f"{4 * count} t",
                    "length": f"{_PITCH * (count + 1):g} m",
                    "width": "1.6 m",
                    "height": "3.3 m",
                    "centre_of_gravity_below_hook": "5 m",
                },
                "hinge": {"axis": "vertical", "friction": "0 kN m", "damping": "0 kN m s"},
                "rope": "equalizing",
                "rope_ends": {"along": row(ends), "below_hook": "6.65 m"},
                "fixed_sheaves": {"along": row(between), "below_hook": "6.65 m", **sheaves},
                "moving_sheaves": {
                    "along": row(along),
                    "below_hook": "8.65 m",
                    "mass": "300 kg",
                    "guided": "vertical",
                    **sheaves,
                },
                "travel": {"up": "1.4 m", "down": "1.9 m", "locked": False},
            }
        },
        "slings": {
            f"S{place}": {
                "from": f"e1.{place}",
                "to": f"block.L{place}",
                "length": f"{length:.3f} m",
                "rope": "sling",
            }
            for place, length in enumerate(lengths, 1)
        },
        "plan": [
            {"step": "hoist", "hoist": "hook", "speed": "0.1 m/s", "by": "2.5 m"},
            {"step": "hold", "hold": "until_end"},
        ],
    }
    return json.dumps(document)


def pages(folder: Path, scenarios: list[str]) -> None:
    """Write the reports that are measured."""
    for name in scenarios:
        write_report(gantline.simulate(ROOT / "scenarios" / name), folder / f"{name}.html")
    lift = folder / "slings.yaml"
    lift.write_text(lift_with_slings(SLINGS), encoding="utf-8")
    write_report(gantline.simulate(lift), folder / f"{SLINGS}_slings.html")


def measured(folder: Path, browser: str) -> list[dict[str, Any]]:
    """What `viewer/browser/player.measure.ts` finds of all pages of a folder."""
    node = shutil.which("node")
    if node is None or not (VIEWER / "node_modules" / "vitest").is_dir():
        raise SystemExit("Node or the viewer's npm packages are missing; 'make setup' installs them")
    command = [node, "node_modules/vitest/vitest.mjs", "run", "--config", "vitest.measure.config.ts"]
    given = {"GANTLINE_PAGES": str(folder), "GANTLINE_CHROMIUM": browser}
    subprocess.run(command, cwd=VIEWER, env={**os.environ, **given}, check=True, stdout=subprocess.DEVNULL)
    found: list[dict[str, Any]] = json.loads((folder / "measured.json").read_text(encoding="utf-8"))
    return found


def main(scenarios: list[str]) -> None:
    browser = chromium()
    if browser is None:
        raise SystemExit("no Chromium on the path, and GANTLINE_CHROMIUM names none")
    with tempfile.TemporaryDirectory() as name:
        pages(Path(name), scenarios)
        found = measured(Path(name), browser)
    table = Table(
        "lift", "size [MB]", "opening [s]", "frames/s", "processor [ms/frame]", "script [ms/frame]", "ropes"
    )
    for one in found:
        table.add_row(
            one["name"],
            f"{one['size'] / 1e6:.1f}",
            f"{one['opening'] / 1e3:.2f}",
            f"{one['rate']:.0f}",
            f"{one['processor']:.0f}",
            f"{one['script']:.2f}",
            "thin" if one["isCheap"] else "wide",
        )
    console = Console()
    console.print(table)
    console.print(f"drawn at 640 × 360 by {found[0]['renderer']}")


if __name__ == "__main__":
    main(sys.argv[1:] or ["goliath"])
