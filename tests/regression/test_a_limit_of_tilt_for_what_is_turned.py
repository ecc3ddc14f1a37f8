"""A load that its plan turns by 90°, with `load_tilt: 2 deg` under its limits.

`gantline check` had it in order, and the run failed `load_tilt` with 4542 % of its limit: a limit of what
hangs level, copied from the file of another lift.
"""

from __future__ import annotations

from gantline.assembly import assemble
from gantline.scenario import load_scenario


def _told(limit: str) -> list[str]:
    """What is said of a limit of the tilt, in a lift that tilts its load to 70°, 84°, 88° and 89°."""
    lift = load_scenario("upending").changed({"limits.load_tilt": limit})
    return [one.sentence for one in assemble(lift).doubts if one.path == "limits.load_tilt"]


def test_a_step_that_is_to_tilt_farther_is_named() -> None:
    (said,) = _told("2 deg")
    assert said == (
        "2.0 deg hold over the whole lift, and step 'upend' tilts the load to 70.0 deg: it fails; leave it "
        "out, and let steps at whose end the load hangs level 'require' it"
    )


def test_a_limit_beyond_all_of_the_plan_is_not() -> None:
    assert _told("91 deg") == []
