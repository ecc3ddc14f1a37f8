"""A lift with other values, in Python."""

from __future__ import annotations

from pathlib import Path

import pytest

from gantline.scenario import Scenario, ScenarioError, load_scenario
from gantline.statics import Statics

EQUALIZER = Path(__file__).resolve().parents[2] / "scenarios" / "equalizer"


@pytest.fixture(name="lift")
def _lift() -> Scenario:
    return load_scenario(EQUALIZER)


@pytest.mark.parametrize("weight", [280.0, 320.0])
def test_another_weight_hangs_in_the_same_slings(lift: Scenario, weight: float) -> None:
    """By the equalizer each bears a fifth; the frame and five sheaves hang above the slings."""
    other = lift.changed({"load.weight.calculated": f"{weight:g} t"})
    rest = Statics(other).equilibrium()
    vertical = [rest.recording.column("hook_load", hook)[-1] for hook in other.hooks]
    rigging = 20e3 + 5 * 300.0
    assert sum(vertical) == pytest.approx((weight * 1e3 + rigging) * 9.81, rel=1e-9)
    assert lift.load is not None and lift.load.weight.calculated == 300e3


def test_its_text_tells_what_was_changed(lift: Scenario) -> None:
    other = lift.changed({"duration": "50 s", "slings.S1.length": "23.1 m"})
    assert other.duration == 50.0
    assert (
        other.text
        == f"{lift.text.rstrip()}\n# changed: duration: 50 s\n# changed: slings.S1.length: 23.1 m\n"
    )


@pytest.mark.parametrize(
    ("values", "says"),
    [
        ({"load.wieght.calculated": "1 t"}, "did you mean 'weight'"),
        ({"load.weight.calculated": "320"}, "load.weight.calculated"),
    ],
)
def test_what_cannot_be_is_refused(lift: Scenario, values: dict[str, str], says: str) -> None:
    with pytest.raises(ScenarioError, match=says):
        lift.changed(values)
