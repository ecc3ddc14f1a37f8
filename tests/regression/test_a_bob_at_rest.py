"""What a researcher asks of a small system at rest: a bob of 10 kg on a rope over a sheave.

`gantline statics` showed 98.1 N as 0.098 kN, where a run shows newtons below one kilonewton. And a
sensitivity to the length of the rope, which a sheave with inertia feeds, was answered with "there is no
equilibrium", of a lift that had just been found at rest.
"""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

import gantline
from gantline.cli.app import app


def weights(folder: Path, mass: str) -> Path:
    """Two weights alike on one rope over a sheave that has inertia."""
    sides = {
        name: {"at": [at, 0, "2 m"], "joint": {"type": "slider", "axis": [0, 0, 1]}, "mass": mass}
        for name, at in (("left", "-0.2 m"), ("right", "0.2 m"))
    }
    sheave = {"type": "sheave", "body": "world", "at": [0, 0, "5 m"], "axis": [0, 1, 0], "diameter": "400 mm"}
    route = [
        {"type": "end", "body": "left"},
        sheave | {"moment_of_inertia": "0.5 kg m^2"},
        {"type": "end", "body": "right"},
    ]
    given = {
        "format": 1,
        "lift": {"title": "Two weights"},
        "duration": "1 s",
        "ropes": {"thin": {"axial_stiffness": "1 MN", "damping_time": "5 ms"}},
        "mechanics": {
            "bodies": sides,
            "ropes": {"over": {"rope": "thin", "length": "as_routed", "route": route}},
        },
    }
    path = folder / "lift.yaml"
    path.write_text(json.dumps(given), encoding="utf-8")
    return path


@pytest.mark.parametrize(("mass", "shown"), [("10 kg", "98.100 N"), ("1 t", "9.810 kN")])
def test_tensions_at_rest_have_their_unit(tmp_path: Path, mass: str, shown: str) -> None:
    """Newtons where no rope has a kilonewton."""
    said = CliRunner().invoke(app, ["statics", str(weights(tmp_path, mass))])
    assert said.exit_code == 0, said.output
    assert f"  over  {shown}\n" in said.output


@pytest.mark.parametrize("kind", ["length", "stiffness"])
def test_a_rope_that_a_sheave_feeds(tmp_path: Path, kind: str) -> None:
    """It is the question that cannot be asked; others about the same equilibrium can."""
    statics = gantline.Statics(weights(tmp_path, "10 kg"))
    assert statics.equilibrium().tension("over") == pytest.approx(98.1, rel=1e-9)
    with pytest.raises(
        ValueError, match=f"no sensitivity to the {kind} of over: a drum or a sheave feeds it"
    ):
        statics.sensitivities([(kind, "over")])
    assert len(statics.sensitivities([("mass", "left")])) == 1
