"""What a run leaves that did not reach its end: report, pictures, table, and what `check` says of it."""

from __future__ import annotations

import html
import json
import re
from pathlib import Path

import pytest
from typer.testing import CliRunner

import gantline
from gantline.cli.app import app
from gantline.report import render_report
from lift_text import BASE, DEAD_CENTRE
from weak_hoist import hanging

pytestmark = pytest.mark.usefixtures("player", "blank_pictures")

#: A hook that is hoisted 7 m into sheaves that are 6 m above it.
BLOCKED = hanging("{step: up, hoist: crane, speed: 6 m/min, by: 7 m}", 10.0, "capacity: 200 kN", 90.0)
ENDED = "The run did not reach its end"


def call(folder: Path, text: str, *words: str) -> tuple[int, str]:
    """Exit code of a verb with a lift file, and all that it said as one line of words."""
    lift = folder / "lift.yaml"
    lift.write_text(text, encoding="utf-8")
    told = CliRunner().invoke(app, [words[0], str(lift), *words[1:]])
    assert "Traceback" not in told.output
    return told.exit_code, " ".join(told.output.split())


def first_page(page: str) -> str:
    """The words of the first page of a report, as a reader has them."""
    sheet = page[page.index('<div class="sheet">') : page.index("</section>")]
    return " ".join(html.unescape(re.sub(r"<[^>]+>", " ", sheet)).replace("\u00a0", " ").split())


def test_a_run_that_fails_leaves_its_report_and_its_pictures(tmp_path: Path) -> None:
    """With exit code 3, and the page says at its top that there is no GO in it, and why."""
    code, said = call(tmp_path, BLOCKED, "run", "-o", str(tmp_path / "out"))
    assert code == 3
    assert {"recording.nc", "state.bin", "report.html", "hook_load.png", "system.png"} <= {
        one.name for one in (tmp_path / "out").iterdir()
    }
    for told in (ENDED, "Likely cause: its hook block has come up", "What to do next: end that step lower"):
        assert told in said
    page = first_page((tmp_path / "out" / "report.html").read_text(encoding="utf-8"))
    top = page[: page.index("failed hook falls margin")]
    assert ENDED in top and re.search(r"at 6\d\.\d\d s of 90 s, in 'up', at crane", top)
    assert "two-blocking" in top and "what to do next end that step lower" in top
    assert "no GO can be taken from this page" in top and "NO-GO" in top
    assert re.search(r"NO-GO up to 6\d\.\d\d s", page)
    assert "signature" not in page and "Stop if" not in page


def test_a_lift_that_fails_in_its_first_step_is_shown_as_it_starts(tmp_path: Path) -> None:
    """Its recording has the start alone; nothing of that is a verdict."""
    code, said = call(tmp_path, DEAD_CENTRE, "run", "-o", str(tmp_path / "out"))
    assert code == 3 and "could not go on at its start, at plumb" in said
    assert gantline.open_recording(tmp_path / "out" / "recording.nc").time.tolist() == [0.0]
    page = first_page((tmp_path / "out" / "report.html").read_text(encoding="utf-8"))
    assert f"{ENDED} The simulation could not go on at its start, at plumb." in page
    assert "NO VERDICT" in page


def test_check_says_the_same_of_the_recording_and_of_the_lift(tmp_path: Path) -> None:
    """`check --simulate` prints its table too, and ends with 3; of a recording with what its checks say."""
    call(tmp_path, BLOCKED, "run", "-o", str(tmp_path / "out"), "--no-plots", "--no-report")
    told = CliRunner().invoke(app, ["check", str(tmp_path / "out")])
    assert told.exit_code == 1
    code, said = call(tmp_path, BLOCKED, "check", "--simulate")
    assert code == 3
    for words in (said, " ".join(told.output.split())):
        assert ENDED in words and "hook_falls_margin" in words and "NO-GO: 1 failed" in words
        assert "No GO can be taken from it: nothing after 6" in words
    as_json = CliRunner().invoke(app, ["check", str(tmp_path / "lift.yaml"), "--simulate", "--json"])
    assert as_json.exit_code == 3
    document = json.loads(as_json.stdout)
    assert document["ending"]["how"] == "failed" and document["ending"]["element"] == "crane"
    assert document["outcome"] == "NO-GO"


def test_a_plan_that_is_never_finished_says_so_at_the_top(tmp_path: Path) -> None:
    """A hook that takes minutes to what it waits for, in a lift of seconds."""
    text = BASE.replace("brake_from: 10 s", "until: {supports: clear}").replace(
        "duration: 20 s", "duration: 1 s"
    )
    (tmp_path / "lift.yaml").write_text(text, encoding="utf-8")
    recording = gantline.simulate(tmp_path / "lift.yaml")
    page = first_page(render_report(recording))
    top = page[: page.index("NO VERDICT")]
    assert "The plan was not finished The run was over at 1.000 s of 1 s, in 'hoist'" in top
    assert "why 'hoist' waits for supports clear" in top and "a longer 'duration'" in top


def test_one_that_is_stopped_has_a_page_that_says_so(tmp_path: Path) -> None:
    """As by Ctrl-C: what is known up to then, and no GO."""
    (tmp_path / "lift.yaml").write_text(BASE, encoding="utf-8")
    # Who stops it is asked ten times a second: the run has to take longer than that, on any machine.
    method = {"integrator": "del", "step": 1e-5}
    recording = gantline.simulate(tmp_path / "lift.yaml", on_progress=lambda time: False, **method)
    assert recording.attributes["status"] == "stopped"
    page = first_page(render_report(recording))
    assert ENDED in page and "It was stopped from outside" in page
    assert "no GO can be taken from this page" in page
