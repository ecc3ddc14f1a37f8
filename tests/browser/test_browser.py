"""Report and player in the system's Chromium: Python makes the pages, `viewer/browser/` looks at them."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np
import pytest

import gantline
from gantline.export import gltf_binary
from gantline.report import render_live, write_report
from gantline.results import Recording
from gantline.results.file.saved import Beside, SavedCase, SavedCases
from gantline.viewer import BundleMissing, bundle
from gantline.viewer.chromium import NAMES, chromium
from gantline.viewer.frames import frames
from gantline.viewer.live import LiveView
from gantline.viewer.server import PageServer
from harbour_lift import HARBOUR_LIFT
from hostile import hostile_recording
from long_names import LONG_NAMES

ROOT = Path(__file__).resolve().parents[2]
VIEWER = ROOT / "viewer"


def browser_found() -> str:
    """The system's Chromium; the test is left out where there is none."""
    found = chromium()
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


WATCHED = """
format: 1
lift: {title: A box is lifted off a support beside the water}
duration: 10 s
ground: {level: 0 m, friction: 0.5, stiffness: 200 MN/m, damping: 2 MN s/m}
water: {level: -1 m}
ropes:
  sling: {axial_stiffness: 200 MN, damping_time: 2 ms, mass: none}
load:
  name: box
  shape: {box: [4 m, 4 m, 2 m]}
  datum: bottom_centre
  position: [0 m, 0 m, 1 m]
  heading: 0 deg
  weight: {calculated: 100 t, contingency: 1.0}
  inertia: homogeneous
  centre_of_gravity: {at: [0 m, 0 m, 1 m]}
  stands_on: keel
  lugs: {L: {at: [0 m, 0 m, 2 m]}}
cranes:
  hook: {type: fixed_hook, at: [0 m, 0 m, 13 m], hoist: {speed: 0.5 m/s, acceleration: 0.5 m/s^2}}
slings:
  S: {from: hook, to: box.L, length: 10.05 m, rope: sling}
supports:
  keel: {under: box, grid: {x: [-1.5 m, 1.5 m], y: [-1.5 m, 1.5 m]}, height: 1 m, removed_at: 8 s}
structures:
  wall: {type: box, x: [4.5 m, 5.5 m], y: [-4 m, 4 m], z: [0 m, 6 m]}
watch:
  - {between: [box, wall], smallest: 3 m}
plan:
  - {step: hoist, hoist: hook, speed: 0.5 m/s, by: 3 m}
  - {step: hold, hold: until_end}
"""


def watched_recording(folder: Path) -> Recording:
    """A box beside a wall and water: supports that are taken away, and a distance that is watched."""
    lift = folder / "watched.yaml"
    lift.write_text(WATCHED, encoding="utf-8")
    return gantline.simulate(lift)


def failed(recording: Recording) -> Recording:
    """The same lift as one that could not go on at its end, for a cause that takes two lines."""
    story = "; before that barge.deck_edge went under at 123.45 s, and barge.hatch at 167.89 s"
    cause = f"it has capsized over its starboard side, more than 60° from upright{story}"
    failure = {"time": float(recording.time[-1]), "element": "barge", "cause": cause}
    attributes = {**recording.attributes, "status": "failed", "failure": failure}
    return Recording(recording.variables, recording.coordinates, attributes)


@contextmanager
def running() -> Iterator[str]:
    """The address of a lift that goes on when its page asks for more, and takes some seconds."""
    simulation = gantline.Simulation(ROOT / "scenarios" / "equalizer")
    view = LiveView(simulation.recording, simulation.duration)
    asked = threading.Event()

    def since(samples: int) -> str:
        asked.set()
        return view.since(samples)

    def run() -> None:
        simulation.run(until=1.0)
        while not asked.wait(0.05):
            view.offer()
        for until in np.linspace(1.0, simulation.duration, 41)[1:]:
            recording = simulation.run(until=float(until))
            view.offer()
            time.sleep(0.1)
        view.finish(recording, "done")

    server = PageServer(lambda: render_live(view.first()), lambda: "", since=since)
    threads = [threading.Thread(target=one, daemon=True) for one in (run, server.serve_forever)]
    for thread in threads:
        thread.start()
    try:
        yield server.address
    finally:
        asked.set()
        threads[0].join()
        server.shutdown()
        server.server_close()


@pytest.mark.slow
def test_report_and_player_in_a_browser(tmp_path: Path) -> None:
    """Every test of `viewer/browser/` holds."""
    program, browser = node(), browser_found()
    recording = gantline.simulate(ROOT / "scenarios" / "equalizer")
    write_report(recording, tmp_path / "report.html")
    write_report(gantline.simulate(ROOT / "scenarios" / "equalizer_yard"), tmp_path / "yard.html")
    write_report(gantline.simulate(ROOT / "scenarios" / "upending"), tmp_path / "upending.html")
    off_a_barge = gantline.simulate(ROOT / "scenarios" / "off_a_barge")
    write_report(off_a_barge, tmp_path / "off_a_barge.html")
    write_report(failed(off_a_barge), tmp_path / "failed.html")
    harbour = tmp_path / "harbour.yaml"
    harbour.write_text(HARBOUR_LIFT, encoding="utf-8")
    write_report(gantline.simulate(harbour), tmp_path / "afloat.html")
    watched = watched_recording(tmp_path)
    write_report(watched, tmp_path / "watched.html")
    (tmp_path / "watched.json").write_text(
        json.dumps({"time": watched.time.tolist(), "points": watched["clearance_point"].values.tolist()}),
        encoding="utf-8",
    )
    write_report(hostile_recording(), tmp_path / "hostile.html")
    long = tmp_path / "long.yaml"
    long.write_text(LONG_NAMES, encoding="utf-8")
    write_report(gantline.simulate(long), tmp_path / "long.html")
    told = "cannot start: slings.S1: the sling is 4.35 m, but from 'hook' to 'hull.A' it is 4.531 m at the"
    told += " start: it would be stretched by 4.16 %; lower the hook or make the sling longer"
    cases = SavedCases("", False, [SavedCase("", 1, ()), SavedCase("hook_level", 4, (told,))], ())
    write_report(recording, tmp_path / "cases.html", beside=Beside(cases=cases))
    (tmp_path / "lift.glb").write_bytes(gltf_binary(recording))
    (tmp_path / "watched.glb").write_bytes(gltf_binary(watched))
    (tmp_path / "expected.json").write_text(json.dumps(expected(recording)), encoding="utf-8")
    command = [program, "node_modules/vitest/vitest.mjs", "run", "--config", "vitest.browser.config.ts"]
    pages = {"GANTLINE_PAGES": str(tmp_path), "GANTLINE_CHROMIUM": browser, "NO_COLOR": "1"}
    with running() as address:
        result = subprocess.run(
            command,
            cwd=VIEWER,
            env={**os.environ, **pages, "GANTLINE_LIVE": address},
            capture_output=True,
            text=True,
            check=False,
            timeout=600,
        )
    assert result.returncode == 0, result.stdout + result.stderr
