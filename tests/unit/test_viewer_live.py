"""A lift that runs, and those who look at it."""

from __future__ import annotations

import base64
import http.client
import json
import re
import subprocess
import threading
from contextlib import suppress
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
from program import PROGRAM
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
    """A run that is as far as it is told, by a clock that shows what it is told."""

    def __init__(self, cost: float = 0.0) -> None:
        self.count, self.asked, self.now = 2, 0, 0.0
        self.cost = cost
        self.recording = whole()
        self.view = LiveView(self.so_far, 40.0, lambda: self.now)

    def so_far(self) -> Recording:
        self.asked += 1
        self.now += self.cost
        return up_to(self.recording, self.count)

    def is_looked_at(self) -> None:
        """A first page comes, gets what there is, and has asked for more."""
        page = threading.Thread(target=self.view.first, daemon=True)
        page.start()
        while self.asked == 0:
            self.view.offer()
        assert ends(page)
        assert self.view.since(0)


def ends(thread: threading.Thread) -> bool:
    """Whether a thread that has nothing to wait for ends; much longer than that takes on a busy machine."""
    thread.join(60.0)
    return not thread.is_alive()


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
    run.is_looked_at()
    run.count = 100
    run.view.offer()
    header, data = told(run.view.since(2))
    assert (header["samples"], header["live"]) == (100, {"status": "running", "duration": 40.0})
    assert unpacked(Packed(header, data), "frames").size == 98
    run.view.finish(run.recording, "done")
    header, _ = told(run.view.since(100))
    assert (header["samples"], header["live"]["status"]) == (401, "done")
    # The end has been seen: nothing to wait for, by a clock that stands.
    waiting = threading.Thread(target=run.view.wait_for_readers, args=(1e6,), daemon=True)
    waiting.start()
    assert ends(waiting)


def test_a_run_that_looks_costly_is_looked_at_less_often() -> None:
    """A fifth of the time at most: 0.2 s at 0, 1.2 and 2.4 s; after 3 s without a question nobody looks."""
    run = Run(cost=0.2)
    run.is_looked_at()
    asked_at = [0.0]
    while run.now < 6.0:
        asked, began = run.asked, run.now
        run.view.offer()
        if run.asked > asked:
            asked_at.append(began)
        run.now += 0.01
    # Offers are 10 ms apart, and a sum of them rounds.
    assert asked_at == pytest.approx([0.0, 1.2, 2.4], abs=0.011)


def test_a_page_gets_the_first_samples_of_a_lift_that_is_long_in_beginning() -> None:
    """Statics before the first step may take longer than the 3 s in which a page asks again."""
    run, asked, found = Run(), threading.Event(), list[Recording]()

    def clock() -> float:
        now = run.now
        asked.set()
        return now

    def look() -> None:
        with suppress(ValueError):  # "the lift has not begun yet"
            found.append(run.view.first())

    run.view = LiveView(run.so_far, 40.0, clock)
    page = threading.Thread(target=look, daemon=True)
    page.start()
    assert asked.wait(60.0)
    run.now = 15.0
    while run.asked == 0 and page.is_alive():
        run.view.offer()
    assert ends(page) and [len(one.time) for one in found] == [2]


def test_the_end_waits_for_a_page_that_is_long_in_loading() -> None:
    """A slow browser lays out the page of a quick lift for longer than the 3 s in which it asks again."""
    run = Run()
    run.view.finish(run.recording, "done")
    run.view.first()
    waiting = threading.Thread(target=run.view.wait_for_readers, args=(1e6,), daemon=True)
    run.now = 8.0
    waiting.start()
    waiting.join(0.3)
    assert waiting.is_alive()
    assert told(run.view.since(401))[0]["live"]["status"] == "done"
    assert ends(waiting)


def test_nobody_comes_and_nothing_waits_longer_than_it_was_told() -> None:
    run = Run()
    run.view.finish(run.recording, "stopped")
    waiting = threading.Thread(target=run.view.wait_for_readers, args=(0.2,), daemon=True)
    waiting.start()
    assert ends(waiting)


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
        [*PROGRAM, *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
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
