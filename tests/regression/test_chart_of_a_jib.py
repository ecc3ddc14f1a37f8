"""The rating chart of a crane with a hook on a jib was "of another boom".

A row at 64 m of a boom of 48 m was held against the boom alone, though its `aux` hook hangs 16 m beyond the
head: "its boom reaches no farther than 52.0 m". Level with the heel pins, 4 m ahead of the slewing axis, the
pin of that hook is sqrt((48 + 16)^2 + 4^2) m = 64.12 m from them (BM6), so 68.1 m from the axis.
"""

from __future__ import annotations

import math

import pytest

from gantline.assembly import assemble
from gantline.scenario import load_scenario

REACH = 4.0 + math.hypot(48.0 + 16.0, 4.0)


@pytest.mark.parametrize(
    ("radius", "aux", "said"),
    [
        (64.0, True, None),
        # A tenth more is let through: what hangs over the head.
        (1.09 * REACH, True, None),
        (1.11 * REACH, True, "its boom, jib included, reaches no farther than 68.1 m"),
        (64.0, False, "its boom reaches no farther than 52.0 m"),
    ],
)
def test_rows_as_far_as_the_jib_reaches(radius: float, aux: bool, said: str | None) -> None:
    radii = ["14 m", "20 m", "26 m", "32 m", "40 m", f"{radius} m"]
    changes: dict[str, object] = {
        "cranes.rc.rating.radius": radii,
        "cranes.rc.rating.rated": ["120 t", "120 t", "90 t", "65 t", "45 t", "18 t"],
    }
    if aux:
        jib = {"type": "hook_120", "along": "16 m", "above": "-4 m", "height": "30 m"}
        changes["cranes.rc.hooks.aux"] = jib
    found = [
        one for one in assemble(load_scenario("revolving_crane").changed(changes)).warnings if "row" in one
    ]
    assert len(found) == (said is not None)
    assert said is None or said in found[0]
