"""Slings that bent over the edge of their load just above their lugs: GO, and nothing named it.

Lugs stood on the sides of a module, 0.7 m below the edge of its deck, and the slings led inwards to the hook.
The last metre at a lug is not looked at where slings go through their load, since lugs stand in recesses; but
a lug on the outside has none, and a sling that leads back through the load from there bears on its edge.
"""

from __future__ import annotations

from math import sqrt

import pytest

from four_slings import LIFT
from gantline.checks import Verdict, check_recording, verdict_of
from gantline.results.loads.through import slings_over_edges
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from gantline.statics import Statics
from of_recording import checks_of

#: Of the lugs: along and across the load, and below its top; length of the slings [m].
ALONG, BELOW, LENGTH = 2.5, 0.7, 9.3
HALF, TOP = 2.0, 3.0


def lift(across: float = HALF, below: float = BELOW, more: str = "") -> str:
    """The module with its lugs so far across, and so far below its top [m], well within their strength."""
    text = LIFT.replace("length: 8.6 m", f"length: {LENGTH} m").replace("13.2 t", "40 t")
    text = text.replace("capacity: 46 t", "capacity: 90 t").replace("0 m, 0 m, 1.5 m]", "0 m, 0 m, 1 m]")
    for side in ("  ", " -"):
        text = text.replace(f",{side}1.5 m, 3 m]", f",{side}{across} m, {TOP - below} m]")
    return text + more


def over(across: float, below: float) -> tuple[float, float]:
    """How deep a sling goes through the edge, and where it comes out of the top from its lug, by hand [m].

    Taut, the hook is √(L² − a² − b²) over the lugs. At the top it has come in by e, and
    where it is as far from the side as from the top it is e h/(e + h) deep.
    """
    high = sqrt(LENGTH**2 - ALONG**2 - across**2)
    inwards = across * below / high
    return inwards * below / (inwards + below), below * LENGTH / high


def test_slings_from_the_sides_over_the_edge_of_the_deck() -> None:
    recording = simulate(parse_scenario(lift()))
    deep, out = over(HALF, BELOW)
    assert (deep, out) == pytest.approx((0.130, 0.746), abs=1e-3)
    found = slings_over_edges(recording)
    assert [one.name for one in found] == ["A", "B", "C", "D"]
    # Twenty places along 0.75 m are 39 mm apart; within that the depth falls by 0.022 of 39 mm at the most.
    assert found[0].deep == pytest.approx(deep, abs=5e-3)
    assert found[0].at == pytest.approx(out, abs=2e-3)
    (check,) = checks_of(recording, "sling_over_edge")
    assert check.verdict is Verdict.WARNING
    assert check.remark.startswith("A, B, C and 1 more over an edge of 'module': up to 0.13 m deep")
    assert "out of it 0.75 m from the lug" in check.remark
    assert verdict_of(check_recording(recording)).startswith("GO WITH WARNINGS")


def test_at_rest() -> None:
    (check,) = checks_of(Statics(parse_scenario(lift())).equilibrium().recording, "sling_over_edge")
    assert "up to 0.13 m deep" in check.remark


@pytest.mark.parametrize(
    ("across", "below", "more"),
    [
        (HALF, 0.0, ""),
        (HALF, 0.3, ""),
        (1.5, BELOW, ""),
        (HALF, BELOW, "watch: [{between: [slings, module], smallest: 0 m}]\n"),
    ],
    ids=["at the edge", "just below it", "in a recess", "watched"],
)
def test_slings_that_do_not(across: float, below: float, more: str) -> None:
    """0.3 m below the edge it is 0.06 m deep: pins of lugs stand off the side by that."""
    if below == 0.3:
        assert over(across, below)[0] < 0.1
    assert checks_of(simulate(parse_scenario(lift(across, below, more))), "sling_over_edge") == []
