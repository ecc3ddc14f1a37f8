"""A hook 0.86 m beside the centre of gravity of a module of 60 t was in order, and so was its lift file.

The slings went taut one after another and pulled the module along the ground; only the drift, the tilt and
falls 22° out of plumb told of it, after the run. `gantline check` says it beforehand, with the way to go, and
keeps silent of loads that are tilted up, hang askew on purpose, or hang between several hooks.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import pytest

from gantline.assembly import assemble
from gantline.scenario import ScenarioError, parse_scenario
from hooked_lift import hooked_lift

LUGS = {"1": (-3.0, 2.0, 4.0), "2": (-3.0, -2.0, 4.0), "3": (3.0, 2.0, 4.0), "4": (3.0, -2.0, 4.0)}
HIGH = 14.0
LIFTS = """\
ground: {level: 0 m, friction: 0.3}
plan:
  - {step: lift off, hoist: [%s], speed: 1 m/min, until: {supports: clear}}
  - {step: hold, hold: until_end}
"""
#: Way of four slings of a hook in the middle down to lugs 3.61 m aside and 10 m below, and slack [m].
LONG = 10.9


def told(
    hooks: Mapping[str, Sequence[float]],
    slings: Mapping[str, tuple[str, str, float]],
    *,
    lugs: Mapping[str, Sequence[float]] = LUGS,
    centre: Sequence[float] = (0.0, 0.0, 2.0),
    plan: str = LIFTS,
    hoists: Sequence[str] = ("A",),
) -> list[str]:
    """What is said of hooks beside a load on the ground, 10 m long, 6 m broad, 4 m high."""
    more = plan % ", ".join(hoists)
    text = hooked_lift(hooks, lugs, slings, centre=centre, more=more)
    standing = text.replace("  lugs:", "  stands_on: ground\n  lugs:").replace(
        "start: as_given", "start: rest"
    )
    return [one for one in assemble(parse_scenario(standing)).warnings if "beside the centre" in one]


def four(length: float = LONG, hook: str = "A") -> dict[str, tuple[str, str, float]]:
    return {f"S{lug}": (hook, lug, length) for lug in LUGS}


def test_one_hook_is_told_which_way_to_go() -> None:
    """hypot(0.80, 0.30) = 0.854, from (0.8, 0.3) to the centre of gravity at (0, 0)."""
    says = told({"A": (0.8, 0.3, 13.5)}, four())
    assert says == [
        "A stands 0.85 m beside the centre of gravity of load where it lifts off: it comes off askew, is "
        "dragged along and swings by that; move A 0.80 m along −x and 0.30 m along −y, or load the other way"
    ]


def test_lugs_about_the_middle_and_a_centre_of_gravity_elsewhere() -> None:
    """A hook over the middle of its lugs hangs from where the weight is not: 1 m along x."""
    (says,) = told({"A": (0.0, 0.0, HIGH)}, four(), centre=(1.0, 0.0, 2.0))
    assert "A stands 1.00 m beside" in says and "move A 1.00 m along +x, or" in says


@pytest.mark.parametrize("aside", [0.0, 0.1, 0.19])
def test_what_a_crew_sets_a_hook_to(aside: float) -> None:
    """Up to 0.2 m; the hook is 12 m above the centre of gravity, and half a degree of that is 0.105 m."""
    assert told({"A": (aside, 0.0, 13.5)}, four()) == []


def test_a_load_that_hangs_askew_on_purpose() -> None:
    """It comes off about its lowest edge, from a hook that stands 0.35 m towards that.

    Slings of 11.9 m at -3 m and 10.9 m at 3 m meet at x with 11.9² - 10.9² = 12 x, 1.90 m, and 10.66 m above
    the lugs, 12.66 m above the centre of gravity: the load hangs at atan(1.90/12.66) = 8.5°. Its edge at
    (-5, -2) m is then at -5 cos 8.5° + 2 sin 8.5° = -4.65 m.
    """
    askew = {"S1": ("A", "1", 11.9), "S2": ("A", "2", 11.9), "S3": ("A", "3", 10.9), "S4": ("A", "4", 10.9)}
    assert told({"A": (-0.35, 0.0, 13.5)}, askew) == []
    assert told({"A": (-0.51, 0.0, 13.5)}, askew) == []
    assert told({"A": (-0.59, 0.0, 13.5)}, askew) != []
    assert told({"A": (0.0, 0.0, 13.5)}, askew) == []
    assert told({"A": (0.25, 0.0, 13.5)}, askew) != []


def test_slings_of_one_length_to_lugs_about_another_place() -> None:
    """A transformer whose centre of gravity is 0.5 m off the middle of its lugs tilts: not on purpose.

    Its hook over that middle is as far beside, and the edge that leaves last is on the other side of it.
    """
    (says,) = told({"A": (0.0, 0.0, HIGH)}, four(), centre=(0.5, 0.0, 2.0))
    assert "A stands 0.50 m beside" in says and "move A 0.50 m along +x, or" in says


def test_one_end_that_is_tilted_up() -> None:
    """Two lugs at one end: the load turns about the other, and the hook stands above its lugs."""
    assert told({"A": (3.0, 0.0, 13.5)}, {"S3": ("A", "3", 10.9), "S4": ("A", "4", 10.9)}) == []


def test_two_hooks_have_the_load_between_them() -> None:
    """Anywhere on the line between them; 1 m beside that line both go the same way."""
    slings = {"S1": ("A", "1", 11.0), "S2": ("A", "2", 11.0), "S3": ("B", "3", 11.0), "S4": ("B", "4", 11.0)}
    both = ("A", "B")
    between = told(
        {"A": (-3.0, 0.0, 13.0), "B": (3.0, 0.0, 13.0)}, slings, centre=(1.0, 0.0, 2.0), hoists=both
    )
    assert between == []
    (says,) = told({"A": (-3.0, 1.0, 13.0), "B": (3.0, 1.0, 13.0)}, slings, hoists=both)
    assert says.startswith("A and B stand 1.00 m beside") and "move A and B at least 1.00 m along −y" in says


def test_a_load_that_nothing_lifts_off() -> None:
    plan = LIFTS.replace("hoist: [%s]", "lower: [%s]").replace("until: {supports: clear}", "by: 1 m")
    assert told({"A": (0.8, 0.3, 13.5)}, four(), plan=plan) == []


def test_slings_too_short_for_a_hook_that_is_beside_its_load() -> None:
    """Ways of 10 m down and hypot(4 + 3, 2) m aside: 12.4 m, and "lower the hook" was all that was said."""
    with pytest.raises(ScenarioError) as refused:
        told({"A": (4.0, 0.0, HIGH)}, four())
    assert "A stands 4.00 m beside" in str(refused.value).splitlines()[0]
    assert "the sling is 10.9 m" in str(refused.value).splitlines()[1]
