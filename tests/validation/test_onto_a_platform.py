"""What becomes of the skid of `onto_a_platform` if its hook is not kept still, as three pages tell it."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest

import gantline
from gantline.checks import check_recording
from shown import unsaid

SCENARIO = Path(__file__).parents[2] / "scenarios" / "onto_a_platform"


def test_pages_say_what_happens_without_compensation(tmp_path: Path) -> None:
    """The swell picks it up 2.3 s after it has touched, and drops it: speed, and forces that then act.

    It bounces before, so that twelve runs whose weights differ by 1e-9 to 1e-4 come down at 9.1 to
    9.3 m/min; so do runs on different processors. Of what stools bear samples of 50 ms had 338 to 427 kN;
    over all steps it is 486 kN in eight such runs, to 0.2 %. The guides of all had 552 kN.
    """
    shutil.copytree(SCENARIO, tmp_path / "lift")
    file = tmp_path / "lift" / "scenario.yaml"
    text, steps = re.subn(r", compensate_heave: H1", "", file.read_text(encoding="utf-8"))
    assert steps == 3
    file.write_text(text, encoding="utf-8")
    recording = gantline.simulate(file, duration=146.0)
    checks = {check.name: check for check in check_recording(recording)}
    stays, softly = checks["stays_set_down"], checks["set_down_softly"]
    assert stays.time is not None
    touched = min(time for time, _, name in recording.events("set_down") if name == "skid")
    assert stays.time - touched == pytest.approx(2.3, abs=0.1)
    speed = re.search(r"at ([\d.]+) m/min", f"{softly.formula} {softly.remark}")
    assert speed is not None
    stools = [name for name in recording.coordinates["contact"] if name.startswith("support.")]
    assert 8.5 < float(speed[1]) < 9.5
    largest = recording.metrics()["peak_support_force"] / 1e3
    assert max(recording.column("contact_force", name).max() for name in stools) / 1e3 < 0.9 * largest
    guide = f"{recording['guide_force'].values.max() / 1e3:.0f} kN"
    lands, stool = "9 m/min", f"{largest:.0f} kN"
    page = "docs/concepts/heave_compensation.md"
    assert unsaid(page, f"comes down at {lands}", f"a stool bears {stool} for", f"{guide} for 132 kN") == []
    assert unsaid("docs/guides/afloat.md", f"drops it at {lands}") == []
    page = "scenarios/onto_a_platform/README.md"
    assert unsaid(page, lands, f"of 294 kN bears {stool} then", f"of 180 kN bear {guide}") == []
