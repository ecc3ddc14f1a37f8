"""Lift D, its floating crane stiffer and stiffer: hook loads come to those of a crane that stands still."""

from __future__ import annotations

import math
import re
from functools import cache
from unittest.mock import patch

import numpy as np
import pytest

from gantline.assembly import Assembly, assemble
from gantline.results.recording import Recording
from gantline.scenario import Scenario, load_scenario, parse_scenario
from gantline.statics import Statics
from mechanics import G
from several_cranes import DISPLACED, FILE, HANGS, LOAD, TEXT, at_rest, hook_loads, last

_PLAN = """plan:
  - {step: fc, pull_pins: E1, hoist: fc.H2, speed: 1 m/min, by: 0.24 m}
  - {step: c1, hoist: c1.H, speed: 1 m/min, by: 0.12 m}
  - {step: c2, hoist: c2.H, speed: 1 m/min, by: 0.12 m}
  - {step: end, hold: until_end}
"""


def in_part(text: str) -> str:
    """A plan by lengths, at whose end a part of the load hangs; nothing that is checked or watched."""
    text = text[: text.index("plan:\n")] + _PLAN
    return text.replace("duration: 1200 s", "duration: 120 s")


def moored_level() -> str:
    """The lift in part, its vessel at the place of even keel, on level springs that pull nothing down."""
    text = in_part(TEXT).replace("position: [-105.55 m, -3.75 m]", "position: [-105.6 m, -3.75 m]")
    text = text.replace("draft: 4.24 m", "draft: 4.30 m").replace("trim: 0.41 deg", "trim: 0 deg")
    begin, end = text.index("mooring_lines:"), text.index("\ncranes:")
    lines = "mooring_lines:\n"
    for name, (x, y), to in (
        ("bow", (105.6, 0), (60, -3.75)),
        ("stern", (0, 0), (-165.6, -3.75)),
        ("bow.ps", (105.6, 23), (0, 79.25)),
        ("bow.sb", (105.6, -23), (0, -86.75)),
        ("stern.ps", (0, 23), (-105.6, 79.25)),
        ("stern.sb", (0, -23), (-105.6, -86.75)),
    ):
        ends = f"fairlead: [{x} m, {y} m, 7.5 m], to: [{to[0]} m, {to[1]} m, 3.2 m]"
        lines += f"  {name}: {{vessel: barge, {ends}, rope: moor_44, pretension: 150 kN, type: spring}}\n"
    return text[:begin] + lines + text[end:]


@cache
def stiffened(factor: float) -> Recording:
    """Vessel, ballast, water and moorings `factor` times as heavy and stiff; the vessel bears the same crane.

    Vessel and water stay in balance by (factor − 1) times what crane and load weigh on it, at a place where
    all is on even keel at 4.30 m.
    """
    barge = (load_scenario(FILE).vessels or {})["barge"]
    tanks = (barge.tanks or {}).values()
    parts = [(one.content, (*one.bottom[:2], one.bottom[2] + one.depth / 2)) for one in tanks]
    parts += [(one.mass, one.at) for one in barge.masses.values()]
    mass = math.fsum(one for one, _ in parts)
    borne = DISPLACED - mass
    x, y = (
        (DISPLACED * mid - sum(one * at[i] for one, at in parts)) / borne for i, mid in ((0, 52.8), (1, 0.0))
    )
    place = f"parent: barge, at: [{x!r} m, {y!r} m, 60 m], joint: {{type: fixed}}"
    text = f"{moored_level()}mechanics: {{bodies: {{as_borne: {{{place}, mass: 1 kg}}}}}}\n"

    def heavier(scenario: Scenario) -> Assembly:
        assembly = assemble(scenario)
        document = assembly.document
        bodies = {body["name"]: body for body in document["bodies"]}
        bodies["barge"]["mass"] *= factor  # what is in its tanks is part of it
        bodies["as_borne"]["mass"] = (factor - 1) * borne
        for force in document["forces"]:
            if force["type"] in ("buoyancy", "tank"):
                force["density"] *= factor
        for rope in document["ropes"]:
            if rope["name"].startswith("mooring."):
                rope["material"]["axial_stiffness"] *= factor
        return assembly

    with patch("gantline.statics.lift.assemble", heavier):
        found = Statics(parse_scenario(text, str(FILE))).equilibrium()
    assert found.is_stable
    return found.recording


@cache
def fixed() -> Recording:
    """The same crane on a base that stands still, where the vessel is on even keel."""
    text = in_part(TEXT)
    for begin, end in (("vessels:\n", "cranes:\n"), ("water:", "ground:")):
        text = text[: text.index(begin)] + text[text.index(end) :]
    base = "position: [-105.6 m, -3.75 m, -4.30 m]"
    text = text.replace("    vessel: barge\n", f"    {base}\n    outreach_from: 105.6 m\n")
    found = Statics(parse_scenario(text, str(FILE))).equilibrium()
    assert found.is_stable
    return found.recording


FACTORS = (1.0, 10.0, 100.0, 1000.0, 10000.0)


def test_hook_loads_come_to_those_of_a_crane_that_stands_still() -> None:
    """F − F₀ of every hook falls as 1/factor, to 2e-4 of the load at 10 000."""
    still = np.array(hook_loads(fixed()))
    # In part: the stands bear some of the load, and all hooks carry, so that levels decide who carries what.
    assert 0.2 < last(fixed(), "load_transferred", "load") < 0.9
    differences = {factor: np.array(hook_loads(stiffened(factor))) - still for factor in FACTORS}
    assert abs(differences[1.0]).max() > 0.1 * LOAD * G
    # By springs in series, below: 6e-4 of the half of 3 MN that the hook does not have yet, 0.8 kN.
    assert abs(differences[10000.0]).max() < 2e-4 * LOAD * G
    for less, more in ((100.0, 1000.0), (1000.0, 10000.0)):
        # Springs in series: F − F₀ = r (W − F₀)/(1 + r) with r proportional to 1/factor and 0.06 at 100, so
        # that it is 10 but for r of the less stiff one.
        ratio = differences[less][0] / differences[more][0]
        assert ratio == pytest.approx(10.0, rel=7.0 / less)


def test_vessel_and_falls_are_springs_in_series() -> None:
    """(F − F₀)/(W − F) times the factor is one number: stiffness of the falls over that of the vessel."""
    still = hook_loads(fixed())[0]
    full = hook_loads(at_rest(HANGS))[0]
    ratios = [
        factor * (load - still) / (full - load)
        for factor in FACTORS
        for load in [hook_loads(stiffened(factor))[0]]
    ]
    # Vessel at the boom head: ρ g A and Δ g GM_L at 100.2 m, Δ g GM_T at 3.75 m, in series.
    pitch = DISPLACED * G * 203.3 / 100.2**2
    heave = 1025 * G * 105.6 * 46
    vessel = 1 / (1 / pitch + 1 / heave)
    # Falls: 32 parts of 134 MN at 50 m; slings: five of 188 MN at 24 m, each by its moving sheave on an
    # equalizing rope of 97 MN and 31.3 m; the boom on its tackles and stands of the load, which give way too,
    # are left out: 30 %
    falls = 1 / (50 / (32 * 134e6) + 24 / (5 * 188e6) + 31.3 / (100 * 97.3e6))
    assert ratios[2] == pytest.approx(falls / vessel, rel=0.3)
    # Angles are not small at 1, where the vessel trims by some tenths of a degree and falls lean.
    assert ratios[1:] == pytest.approx([ratios[-1]] * 4, rel=0.02)


def test_as_it_hangs_it_does_not_matter_what_floats() -> None:
    """Ballasted for even keel, the vessel holds the hook where a base would: loads as of the fixed crane."""
    text = TEXT[: TEXT.index("watch:")] + TEXT[TEXT.index("rules:") :]
    for begin, end in (("vessels:\n", "cranes:\n"), ("water:", "ground:")):
        text = text[: text.index(begin)] + text[text.index(end) :]
    base = "position: [-105.6 m, -3.75 m, -4.30 m]\n    outreach_from: 105.6 m"
    text = text.replace("vessel: barge\n    rated", f"{base}\n    rated")
    text = re.sub(r"^  (heel|trim|freeboard|mooring_\w+): .*\n", "", text, flags=re.MULTILINE)
    text = text.replace(", trim: below 0.1 deg, heel: below 0.1 deg", "").replace(", trim, draft", "")
    text = text.replace("sling_tension, trim]", "sling_tension]")
    found = Statics(parse_scenario(text, str(FILE))).equilibrium(HANGS).recording
    # Plans wait for hoist loads, so other lengths of rope lead there: levels differ by some centimetres.
    assert hook_loads(found) == pytest.approx(hook_loads(at_rest(HANGS)), rel=5e-3)
