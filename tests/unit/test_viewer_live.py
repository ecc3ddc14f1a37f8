"""A lift that runs, and those who look at it."""

from __future__ import annotations

import base64
import http.client
import json
import re
import subprocess
import sys
import threading
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from gantline.results import Recording, Variable
from gantline.viewer import BundleMissing, bundle
from gantline.viewer.live import LiveView
from gantline.viewer.pack import Packed, pack
from gantline.viewer.server import PageServer
from packed_arrays import unpacked
from sample_lift import ringing_lift

ROOT = Path(__file__).resolve().parents[2]


def whole() -> Recording:
    """401 samples of a lift that moves: all of them become frames."""
    clock = np.linspace(0.0, 40.0, 2001)
    return picked(ringing_lift(tilt=0.2 * np.sin(clock), yaw=clock, load_z=2.5 + clock), slice(None, None, 5))


def up_to(recording: Recording, count: int) -> Recording:
    return picked(recording, slice(count))


def picked(recording: Recording, samples: slice) -> Recording:
    """Some samples of a recording."""
    cut = {
        name: Variable(one.dims, one.values[samples], one.unit, one.description)
        if "time" in one.dims
        else one
        for name, one in recording.variables.items()
    }
    return Recording(cut, recording.coordinates, recording.attributes)


class Run:
    """A run that is as far as it is told."""

    def __init__(self) -> None:
        self.count, self.asked = 2, 0
        self.recording = whole()
        self.view = LiveView(self.so_far, 40.0)

    def so_far(self) -> Recording:
        self.asked += 1
        return up_to(self.recording, self.count)


def test_parts_of_a_recording_are_the_whole_one() -> None:
    """What a page has got piece by piece is what it would have got at once."""
    recording = whole()
    parts = [pack(up_to(recording, 150)), pack(up_to(recording, 151), since=150), pack(recording, since=151)]
    every = pack(recording)
    for name in ("position", "turn", "path", "sheave_angle"):
        pieces = np.concatenate([unpacked(part, name) for part in parts])
        # Half a step of each: a micrometre, 1e-7, 1e-4 rad.
        assert np.abs(pieces - unpacked(every, name)).max() <= float(every.header["arrays"][name]["step"])
    assert sum(len(unpacked(part, "frames")) for part in parts) == 401
    assert parts[2].header["samples"] == 401
    nothing = pack(recording, since=401)
    assert unpacked(nothing, "frames").size == 0 and nothing.header["curves"][0]["count"] == 0


def test_a_run_at_which_nobody_looks_is_asked_for_nothing() -> None:
    run = Run()
    for _ in range(5):
        run.view.offer()
    assert run.asked == 0


def test_who_looks_gets_what_is_new_and_the_end() -> None:
    run = Run()
    asker = threading.Thread(target=run.view.first)
    asker.start()
    while run.asked == 0:
        run.view.offer()
    asker.join(10.0)
    assert not asker.is_alive()
    run.count = 100
    before = run.asked
    deadline = time.monotonic() + 10.0
    while run.asked == before and time.monotonic() < deadline:
        run.view.offer()
    header, data = told(run.view.since(2))
    assert (header["samples"], header["live"]) == (100, {"status": "running", "duration": 40.0})
    assert unpacked(Packed(header, data), "frames").size == 98
    run.view.finish(run.recording, "done")
    header, _ = told(run.view.since(100))
    assert (header["samples"], header["live"]["status"]) == (401, "done")
    begun = time.monotonic()
    run.view.wait_for_readers(10.0)
    assert time.monotonic() - begun < 2.0  # the end has been seen: nothing to wait for


def test_a_run_that_looks_costly_is_looked_at_less_often() -> None:
    run = Run()
    slow = run.view._recording

    def costly() -> Recording:
        time.sleep(0.2)
        return slow()

    run.view._recording = costly
    threading.Thread(target=run.view.first).start()
    begun = time.monotonic()
    while time.monotonic() - begun < 1.0:
        run.view.offer()
        time.sleep(0.001)
    # A fifth of the time at most: the second one a second after the first.
    assert 1 <= run.asked <= 2


def test_nobody_comes_and_nothing_waits_longer_than_it_was_told() -> None:
    run = Run()
    run.view.finish(run.recording, "stopped")
    begun = time.monotonic()
    run.view.wait_for_readers(0.2)
    assert time.monotonic() - begun < 2.0


def told(answer: str) -> tuple[dict[str, Any], bytes]:
    header, data = answer.split("\n")
    return json.loads(header), base64.b64decode(data)


def get(server: PageServer, path: str) -> tuple[int, str]:
    connection = http.client.HTTPConnection("127.0.0.1", server.server_port, timeout=30)
    connection.request("GET", path)
    answer = connection.getresponse()
    return answer.status, answer.read().decode()


@pytest.mark.parametrize(
    ("path", "status"),
    [
        ("{own}live/0", 200),
        ("{own}live/12", 200),
        ("{own}live/012", 404),
        ("{own}live/-1", 404),
        ("{own}live/1/2", 404),
        ("{own}live/9999999999", 404),
        ("{own}live/", 404),
        ("/other/live/1", 404),
    ],
)
def test_only_whole_numbers_of_samples_are_answered(path: str, status: int) -> None:
    server = PageServer(lambda: "page", lambda: "", since=lambda samples: f"from {samples}")
    threading.Thread(target=server.serve_forever, daemon=True).start()
    try:
        found, text = get(server, path.format(own=f"/{server.token}/"))
        assert found == status
        assert text == (f"from {path.rpartition('/')[2]}" if status == 200 else "Not Found")
    finally:
        server.shutdown()
        server.server_close()


def test_a_lift_is_shown_while_it_runs_and_the_program_ends_as_without(tmp_path: Path) -> None:
    try:
        bundle()
    except BundleMissing as problem:
        pytest.skip(str(problem))
    lift = ROOT / "scenarios" / "equalizer"
    words = ["run", str(lift), "--live", "--no-browser", "--no-plots", "--no-report", "-o", str(tmp_path)]
    with subprocess.Popen(
        [sys.executable, "-m", "gantline", *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    ) as process:
        assert process.stdout is not None
        address = re.fullmatch(r"Live +http://127\.0\.0\.1:(\d+)(/[\w-]+/)\n", process.stdout.readline())
        assert address is not None
        connection = http.client.HTTPConnection("127.0.0.1", int(address[1]), timeout=60)
        connection.request("GET", address[2])
        assert 'name="gantline-live" content="live/"' in connection.getresponse().read().decode()
        status, samples = "running", 0
        while status == "running":
            connection.request("GET", f"{address[2]}live/{samples}")
            answer = connection.getresponse().read().decode()
            if answer:
                header, _ = told(answer)
                status, samples = header["live"]["status"], header["samples"]
        rest = process.stdout.read()
    assert (status, process.returncode) == ("done", 0)
    assert "Recording" in rest
    assert (tmp_path / "recording.nc").is_file()
