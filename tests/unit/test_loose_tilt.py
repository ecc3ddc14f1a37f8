"""Loads that nothing but their weight keeps upright, where slings come and go."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from gantline.results.loads.tilting import loose_tilt
from gantline.results.recording import Recording
from sample_lift import WEIGHT, ringing_lift, sample_rig


def fifth_to_the_hook(*events: tuple[float, str, str], off: bool = False, **given: Any) -> Recording:
    """The load hangs from 10 s to 40 s on four slings of an equalizer, and the fifth straight to the hook."""
    rig: dict[str, Any] = sample_rig()
    rig["equalizers"][0]["slings"] = rig["equalizers"][0]["slings"][:4]
    rig["slings"][4]["from"] = "test_hook"
    rig["hooks"][0]["direct_slings"] = ["S5"]
    rig["starts_off"] = ["sling.S5"] if off else []
    return ringing_lift(rig=rig, events=list(events), **given)


ON, OFF = "attached", "detached"


@pytest.mark.parametrize(
    ("events", "off", "is_loose"),
    [
        ([], False, False),
        # Not on yet: the sling that is counted on is not there as the load comes clear.
        ([(25.0, ON, "sling.S5")], True, True),
        ([(25.0, OFF, "sling.S5")], False, True),
        # On the ground it does not matter which slings are on.
        ([(5.0, ON, "sling.S5")], True, False),
        ([(3.0, OFF, "sling.S5"), (6.0, ON, "sling.S5")], False, False),
    ],
)
def test_slings_count_while_they_are_on(
    events: list[tuple[float, str, str]], off: bool, is_loose: bool
) -> None:
    """A fifth sling beside an equalizer gives the load tilt stiffness, as long as it is on."""
    recording = fifth_to_the_hook(*events, off=off)
    (load,) = recording.rig.loads
    found = loose_tilt(recording, load)
    assert (found is not None) == is_loose
    if found is not None:
        assert found.equalizers == ("e1",)
        lugs = [lug.at[2] for lug in list(load.lugs.values())[:4]]
        assert found.depth == pytest.approx(sum(lugs) / 4)


def test_slings_of_a_load_that_never_hangs_are_those_of_the_end() -> None:
    """Of a run that ends before lift-off, what it would hang on."""
    stands = np.full((2001, 4), WEIGHT / 4)
    for events, off, is_loose in (([(5.0, ON, "sling.S5")], True, False), ([], True, True)):
        recording = fifth_to_the_hook(*events, off=off, contact=stands)
        (load,) = recording.rig.loads
        assert (loose_tilt(recording, load) is not None) == is_loose
