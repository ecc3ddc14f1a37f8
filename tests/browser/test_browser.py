"""Report and player in the system's Chromium: Python makes the pages, `viewer/browser/` looks at them."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

import gantline
from gantline.export import gltf_binary
from gantline.report import write_report
from gantline.results import Recording
from gantline.viewer import BundleMissing, bundle
from gantline.viewer.decimate import frames
from hostile import hostile_recording

ROOT = Path(__file__).resolve().parents[2]
VIEWER = ROOT / "viewer"
NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")


def chromium() -> str:
    """The system's Chromium; the test is left out where there is none."""
    found = os.environ.get("GANTLINE_CHROMIUM") or next((p for n in NAMES if (p := shutil.which(n))), None)
    if found is None:
        pytest.skip(f"no Chromium here: none of {', '.join(NAMES)} is on the path")
    return found


def node() -> str:
    """Node with the packages of the viewer; the test is left out where they are not installed."""
    found = shutil.which("node")
    if found is None or not (VIEWER / "node_modules" / "vitest").is_dir():
        pytest.skip("the viewer's npm packages are not installed: `make setup` does that")
    try:
        bundle()
    except BundleMissing as problem:
        pytest.skip(str(problem))
    return found


def expected(recording: Recording) -> dict[str, object]:
    """What the pages must show, straight from the recording."""
    kept = np.array(frames(recording, 1500))  # between its frames a page goes on straight lines
    samples = kept[np.linspace(0, len(kept) - 1, 9).round().astype(int)]
    ropes = recording.coordinates["rope"]
    owner = recording["rope_of_point"].values
    points = recording["rope_point"].values
    return {
        "times": recording.time.tolist(),
        "ropes": {name: recording.column("rope_tension", name).tolist() for name in ropes},
        "frames": recording.time[samples].tolist(),
        "paths": {name: points[samples][:, owner == name].tolist() for name in ropes},
        "bodies": {
            name: [
                {
                    "position": recording.column("body_position", name)[sample].tolist(),
                    "orientation": recording.column("body_orientation", name)[sample].tolist(),
                }
                for sample in samples
            ]
            for name in recording.coordinates["body"]
        },
        "lengths": {sling.rope: [sling.length] for sling in recording.rig.slings},
        "liftOff": recording.metrics()["lift_off_time"],
        "stepBegins": [time for time, _, _ in recording.events("step_begin")],
    }


@pytest.mark.slow
def test_report_and_player_in_a_browser(tmp_path: Path) -> None:
    """Every test of `viewer/browser/` holds."""
    program, browser = node(), chromium()
    recording = gantline.simulate(ROOT / "scenarios" / "equalizer")
    write_report(recording, tmp_path / "report.html")
    write_report(gantline.simulate(ROOT / "scenarios" / "equalizer_yard"), tmp_path / "yard.html")
    write_report(hostile_recording(), tmp_path / "hostile.html")
    (tmp_path / "lift.glb").write_bytes(gltf_binary(recording))
    (tmp_path / "expected.json").write_text(json.dumps(expected(recording)), encoding="utf-8")
    command = [program, "node_modules/vitest/vitest.mjs", "run", "--config", "vitest.browser.config.ts"]
    pages = {"GANTLINE_PAGES": str(tmp_path), "GANTLINE_CHROMIUM": browser, "NO_COLOR": "1"}
    result = subprocess.run(
        command,
        cwd=VIEWER,
        env={**os.environ, **pages},
        capture_output=True,
        text=True,
        check=False,
        timeout=600,
    )
    assert result.returncode == 0, result.stdout + result.stderr
