"""Warnings of what is lifted or set down did not see a load that a step leads up or down.

A wreck that two cranes lead up off a bed under water, a beam that they lead down onto supports of which
nobody has said the friction, and a hook that leads with nothing in it: hoisted or lowered each was a warning,
led it was none.
"""

from __future__ import annotations

import pytest

from gantline.assembly import assemble
from gantline.scenario import parse_scenario
from led_pair import led_text
from lift_text import changed

_RAMPS = "speed: 6 m/min, acceleration: 0.02 m/s^2"
_BED = "ground: {level: 0 m, friction: 0.4}\nwater: {level: 8 m, depth: 8 m}\n"
_SUPPORTS = "supports: {there: {under: beam, measured_from: world, grid: {x: [-8 m, 8 m], y: [17 m]}}}\n"


def _warnings(text: str) -> list[str]:
    return [str(one) for one in assemble(parse_scenario(text)).warnings]


def _lead(up: float, hooks: str = "[a.H, b.H]") -> str:
    return f"{{step: l, lead: {hooks}, by: [0 m, 0 m, {up} m], {_RAMPS}}}"


@pytest.mark.parametrize(("up", "told"), [(4.0, True), (-0.1, False)])
def test_a_wreck_that_is_led_off_its_bed(up: float, told: bool) -> None:
    text = changed(
        led_text(_lead(up), rest=_BED),
        ("position: [0 m, 17 m, 5 m]", "position: [0 m, 17 m, 0 m]"),
        (
            "  inertia: homogeneous\n",
            "  inertia: homogeneous\n  stands_on: ground\n  in_water: {displaced_volume: 13 m^3, "
            "added_mass: [50 t, 100 t, 100 t], drag_coefficients: [1, 1, 1]}\n",
        ),
        ("height: 14 m", "height: 8.9 m"),
    )
    assert any("comes off a bed under water" in one for one in _warnings(text)) == told


@pytest.mark.parametrize(("up", "told"), [(-2.0, True), (2.0, False)])
def test_supports_onto_which_a_beam_is_led(up: float, told: bool) -> None:
    text = led_text(_lead(up), rest=_SUPPORTS.replace("}}}", "}, height: 3 m}}"))
    assert any("nothing says the friction of supports there" in one for one in _warnings(text)) == told


def test_a_hook_that_leads_with_nothing_in_it() -> None:
    text = led_text(_lead(2.0, "b.H")).replace("  B: {from: b.H, to: beam.B, length: 6 m, rope: sling}\n", "")
    (found,) = [one for one in _warnings(text) if "nothing hangs in hook" in one]
    assert found.endswith("nothing hangs in hook b.H, which step 'l' leads")


@pytest.mark.parametrize(("hooks", "told"), [("[a.H, b.H]", True), ("a.H", False)])
def test_a_tilt_beyond_the_balance_after_a_lead(hooks: str, told: bool) -> None:
    """Hooks that lead together stay over their lugs; one alone does not, and the tilt is not known then.

    From one lug, 12 m off and 2 m over the centre of gravity, the beam hangs at atan(12/2), 80.5 degrees.
    """
    tilt = "{step: t, hoist: a.H, speed: 3 m/min, until: {load_tilt: {above: 86 deg}}}"
    lead = _lead(0.0, hooks).replace("[0 m, 0 m, 0.0 m]", "[0 m, 3 m, 0 m]")
    assert any("step 't' waits for a tilt above" in one for one in _warnings(led_text(lead, tilt))) == told
