"""A load in a V cradle had less than nothing transferred, and steps that wait for half came late.

Forces of contacts were added up by their sizes. In a cradle at 45 degrees each face presses with W/(2 cos
45): together 1.414 W, so that a column of 100 t that stood there was at -41.4 %, and `until:
{load_transferred: 50 %}` went on until 64.6 % of it hung. Its wall by which a load is pressed counted as if
it bore it. What counts is what contacts bear, their forces upwards with that of friction: 1 less that is
what the hook carries of the weight.
"""

from __future__ import annotations

import math
from pathlib import Path

import pytest

import gantline
from gantline.results import series
from gantline.results.loads.lift_off import lift_off_time
from gantline.scenario import load_scenario
from gantline.statics import Statics
from hull_lift import text
from round_lift import round_lift

WEIGHT = 100e3 * 9.81
#: 2 m of radius, 45 degrees: the faces touch 1.414 m aside and as much below the axis, 3 m up.
_REACH = 2.0 * math.sqrt(0.5)


def cradle(friction: float, *, swap: bool = False) -> dict[str, object]:
    """A column 3 m up on four faces at 45 degrees, under slings that are 30 mm too long."""
    bodies, contacts = {}, {}
    for end, x in (("fore", 8.0), ("aft", -8.0)):
        for side, sign in (("port", 1.0), ("starboard", -1.0)):
            # Half of 0.7 m below the face, along its normal (-sign, 1)/sqrt 2.
            y, z = sign * (_REACH + 0.35 * math.sqrt(0.5)), 3.0 - _REACH - 0.35 * math.sqrt(0.5)
            name = f"{end}.{side}"
            bodies[name] = {
                "joint": {"type": "fixed"},
                "mass": "1 t",
                "at": [f"{x} m", f"{y!r} m", f"{z!r} m"],
                "orientation": {"about": [1, 0, 0], "angle": f"{45 * sign} deg"},
                "shape": {"box": ["1 m", "2 m", "0.7 m"]},
            }
            contacts[f"on.{name}"] = {
                "between": [name, "column"] if swap and sign > 0 else ["column", name],
                "stiffness": "200 MN/m",
                "damping": "2 MN s/m",
                "friction": friction,
            }
    hook = {"speed": "6 m/min", "acceleration": "0.05 m/s^2"}
    lugs = {name: {"at": [f"{x} m", "0 m", "4 m"]} for name, x in (("a", -8.0), ("b", 8.0))}
    length = f"{math.hypot(20.0, 8.0) + 0.03!r} m"
    return round_lift(
        {"diameter": "4 m", "length": "20 m"},
        (0.0, 0.0, 2.0),
        duration="90 s",
        load={"position": ["0 m", "0 m", "1 m"], "weight": {"calculated": "100 t"}, "lugs": lugs},
        cranes={"hook": {"type": "fixed_hook", "at": ["0 m", "0 m", "25 m"], "hoist": hook}},
        slings={
            name: {"from": "hook", "to": f"column.{name}", "length": length, "rope": "sling"} for name in lugs
        },
        mechanics={"bodies": bodies, "body_contacts": contacts},
        plan=[
            {"step": "stand", "hold": "10 s"},
            {
                "step": "take half",
                "hoist": "hook",
                "speed": "0.1 m/min",
                "until": {"load_transferred": "50 %"},
            },
            {"step": "hold", "hold": "20 s"},
            {"step": "end", "hold": "until_end"},
        ],
    )


def written(folder: Path, given: dict[str, object]) -> Path:
    path = folder / "lift.yaml"
    path.write_text(text(given), encoding="utf-8")
    return path


@pytest.mark.parametrize("friction", [0.0, 0.3])
@pytest.mark.parametrize("swap", [False, True])
def test_what_a_cradle_bears_is_the_weight_less_the_hook_load(
    tmp_path: Path, friction: float, swap: bool
) -> None:
    """Of what stands still the forces up are W: transferred = hook load/W, whatever its sides press with.

    At rest without friction the sides press with W sqrt 2. From 0.1 m/min the hook brakes within less than
    2 mm; slings and contacts together give 8 mm for W.
    """
    path = written(tmp_path, cradle(friction, swap=swap))
    recording = gantline.simulate(path)
    transferred = recording.column("load_transferred", "column")
    still = [int(recording.time.searchsorted(time)) for time in (9.0, 80.0)]
    hung = recording.column("hook_load", "hook") / WEIGHT
    assert transferred[still] == pytest.approx(hung[still], abs=1e-5)
    assert transferred[still[0]] == pytest.approx(0.0, abs=1e-5)
    assert 0.5 < transferred[still[1]] < 0.56
    load = recording.rig.loads[0]
    assert series.borne(recording, load)[still[0]] == pytest.approx(WEIGHT, rel=1e-5)
    if friction == 0.0:
        pressed = series.support_force(recording, load)[still[0]]
        assert pressed == pytest.approx(math.sqrt(2.0) * WEIGHT, rel=1e-4)
    assert lift_off_time(recording) is None


def test_statics_and_del_wait_for_the_same(tmp_path: Path) -> None:
    """At rest the step ends as half hangs; `del` brakes as `adaptive` does."""
    path = written(tmp_path, cradle(0.0))
    rest = Statics(load_scenario(path)).equilibrium(80.0)
    assert 0.5 <= rest.recording.column("load_transferred", "column")[-1] < 0.56
    recording = gantline.simulate(path, integrator="del", step=5e-3)
    last = recording.column("load_transferred", "column")[-1]
    assert 0.5 < last < 0.56
    assert last == pytest.approx(recording.column("hook_load", "hook")[-1] / WEIGHT, abs=1e-4)
