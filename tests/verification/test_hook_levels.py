"""How far hooks that bear one load go up unlike: as told, and only of a load that is clear."""

from __future__ import annotations

import pytest

from gantline.checks import Check, Verdict, check_recording
from gantline.scenario import parse_scenario
from gantline.simulation import Simulation
from hooked_lift import TWO_HOOKS_LUGS, hooked_lift

LENGTH = 12.0
HOOKS = {"A": (-4.0, 0.0, 16.0), "B": (4.0, 0.0, 16.0)}
SLINGS = {
    "S1": ("A", "1", LENGTH),
    "S2": ("A", "2", LENGTH),
    "S3": ("B", "3", LENGTH),
    "S4": ("B", "4", LENGTH),
}
#: Height of the lugs at which slings are just taut: each goes 2 m aside on its 12 m.
TAUT = 16.0 - (LENGTH**2 - 2.0**2) ** 0.5
UNLIKE = (
    "  - {step: with A, hoist: A, speed: 0.1 m/s, by: 1 m}\n"
    "  - {step: with B, hoist: B, speed: 0.1 m/s, by: 0.8 m, starts: with_previous}\n"
)


def found(plan: str, limits: str, above_ground: float = 0.0, longer: float = 0.0) -> dict[str, Check]:
    """Checks of a run, by name and step.

    Args:
        plan: Steps.
        limits: Keys of `limits`.
        above_ground: Where the bottom of the load is [m]; at 0 it stands at rest on the ground.
        longer: By how much the slings of A are longer than those of B, which are just taut [m].
    """
    ground = "ground: {level: 0 m, stiffness: 1000 MN/m, damping: 10 MN s/m}\n"
    text = hooked_lift(
        {name: (x, y, z + above_ground + 4.0 - TAUT) for name, (x, y, z) in HOOKS.items()},
        TWO_HOOKS_LUGS,
        {
            name: (hook, lug, length + (longer if hook == "A" else 0.0))
            for name, (hook, lug, length) in SLINGS.items()
        },
        position=(0.0, 0.0, above_ground),
        more=f"plan:\n{plan}limits: {{{limits}}}\n{ground}",
    ).replace("duration: 10 s", "duration: 30 s")
    if not above_ground:
        text = text.replace("start: as_given", "start: rest")
    recording = Simulation(parse_scenario(text)).run()
    return {f"{check.name}{check.step or ''}": check for check in check_recording(recording)}


@pytest.mark.parametrize(("limit", "verdict"), [("201 mm", Verdict.OK), ("199 mm", Verdict.FAILED)])
def test_hooks_that_go_different_ways(limit: str, verdict: Verdict) -> None:
    """One hook goes up 1 m and the other 0.8 m, as told: 0.2 m apart from then on, exactly."""
    plan = UNLIKE + "  - {step: look, hold: 2 s, require: {hook_level_difference: below 150 mm}}\n"
    checks = found(plan, f"hook_level_difference: {limit}", above_ground=5.0)
    whole, step = checks["hook_level_difference"], checks["hook_level_differencelook"]
    assert (whole.verdict, whole.element) == (verdict, "A to B")
    assert whole.value == pytest.approx(0.2, abs=1e-12)
    assert "A 1.000 m, B 0.800 m up since it came clear" in whole.formula
    assert (step.verdict, step.limit) == (Verdict.FAILED, 0.15)
    assert step.value == pytest.approx(0.2, abs=1e-12)


def test_what_hooks_do_before_the_load_is_clear_does_not_count() -> None:
    """A takes up the slack of its longer slings while the load stands; both then go up alike."""
    plan = (
        "  - {step: take up, hoist: A, speed: 0.1 m/s, by: 0.3 m}\n"
        "  - {step: up, hoist: [A, B], speed: 0.1 m/s, by: 0.5 m}\n"
    )
    checks = found(plan, "hook_level_difference: 50 mm", longer=0.3)
    check = checks["hook_level_difference"]
    assert check.verdict is Verdict.OK
    # Both follow the same ramp of the second step, in which the load comes clear.
    assert check.value == pytest.approx(0.0, abs=1e-12)


def test_what_has_no_rise_says_so() -> None:
    """A load that stays on the ground: nothing counts, and both hooks are named."""
    checks = found("  - {step: wait, hold: 2 s}\n", "hook_level_difference: 50 mm")
    check = checks["hook_level_difference"]
    assert (check.verdict, check.value) == (Verdict.WARNING, None)
    assert check.remark == "its rise counts from when a run brings the load clear: A, B"


def test_no_row_where_no_limit_asks_for_it() -> None:
    """Loads that are turned on purpose take one hook metres higher: without a limit nothing is said."""
    assert "hook_level_difference" not in found(UNLIKE, "load_tilt: 9 deg", above_ground=5.0)


def test_hooks_that_are_named() -> None:
    """A third hook stays behind by 1 m on purpose: of all hooks that is compared, of A and B 0.2 m is."""
    named = found(UNLIKE, "hook_level_difference: {between: [A, B], largest: 201 mm}", above_ground=5.0)
    check = named["hook_level_difference"]
    assert (check.verdict, check.element, check.limit) == (Verdict.OK, "A to B", 0.201)
    assert check.value == pytest.approx(0.2, abs=1e-12)
