"""`gantline statics --steps` told too much GM of a barge on which a crane ashore had set a load down.

Its equilibria let loads slide. One set down aside of the middle went down the heel that it causes into its
slings, by which the crane ashore held the barge: 10 and 14 m where friction, which holds it, leaves 4.7 m,
with slack slings. Runs took the least of both already; the tables of `gantline statics` did not.
"""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

from gantline.cli.app import app
from gantline.scenario import parse_scenario
from gantline.statics import Statics
from gantline.study import run_steps
from module_on_a_barge import LIFT

#: Lines with little tension, which rights her a little: 20 kN are 0.04 m of GM.
TEXT = LIFT.replace("PULL", "pretension: 2 kN, type: spring")


def by_hand() -> float:
    """KB + BM - KG less free surfaces of the barge, 40 by 12 m, with the module on her deck [m].

    Masses in t, heights over the keel in m; liquids stand as high as mass over density and area, in
    tanks with their bottoms at 0.2 m, and take density b^3 l/12 of moment.
    """
    rho = 1.025
    tanks = [(60.0, 10.0, 4.0), (60.0, 10.0, 4.0), (40.0, 4.0, 8.0), (40.0, 4.0, 8.0)]
    weights = [(700.0, 2.0), (60.0, 4.0 + 2.0)]
    weights += [(mass, 0.2 + mass / (rho * length * breadth) / 2) for mass, length, breadth in tanks]
    mass = sum(one for one, _ in weights)
    draft = mass / (rho * 40.0 * 12.0)
    centre = sum(one * height for one, height in weights) / mass
    surfaces = sum(rho * length * breadth**3 / 12 for _, length, breadth in tanks) / mass
    return draft / 2 + 12.0**2 / 12 / draft - centre - surfaces


def test_what_stands_aboard_is_held() -> None:
    """To 0.5 %: with 0.77 deg of heel BM is 1.5 tan^2 more of its 6.15 m, 0.0017 m, and the lines pull.

    As if it slid she has more than twice as much, which is what the table had.
    """
    found = {one.name: one for one in run_steps(Statics(parse_scenario(TEXT)))}
    for name in ("all", "further", "end of the lift"):
        assert found[name].heights["barge"].transverse > 2.0 * by_hand()
        assert found[name].gm["barge"][0] == pytest.approx(by_hand(), rel=0.005)
    # What hangs is as it was.
    assert found["start"].held == {}
    assert found["start"].gm["barge"][0] == found["start"].heights["barge"].transverse


def test_tables_say_which_it_is(tmp_path: Path) -> None:
    """Of all steps, as JSON, and of one moment; with `--held` there is nothing to say."""
    file = tmp_path / "lift.yaml"
    file.write_text(TEXT, encoding="utf-8")

    def said(*options: str) -> str:
        return CliRunner().invoke(app, ["statics", str(file), *options], env={"COLUMNS": "140"}).stdout

    steps = said("--steps")
    assert "GM as friction holds what stands aboard" in steps
    assert "all, further, end of the lift\n" in steps
    last = json.loads(said("--steps", "--json"))["steps"][-1]["vessels"]["barge"]
    assert last["gm_transverse"] == pytest.approx(by_hand(), rel=0.005)
    assert "GM as friction holds what stands aboard; as if it slid" in said()
    assert "GM as friction holds" not in said("--steps", "--held")
