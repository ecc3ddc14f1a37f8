"""`held_by` of a hinge naming the load itself or a hook: "'main' is not a vessel or a part of a crane".

A hook is a part of a crane to who writes it, and the load something that the file knows; what is wrong with
either was left to guess.
"""

from __future__ import annotations

import pytest

from gantline.scenario import ScenarioError, parse_scenario
from hinged_mast import mast

HOLD = "  - {step: hold, hold: until_end}\n"


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("mast", "the load cannot hold its own hinge; leave it out for a hinge in the yard"),
        (
            "main",
            "'main' is a hook, and a hinge stands on a vessel or another part of a crane; leave it out for a "
            "hinge in the yard",
        ),
    ],
)
def test_messages(name: str, message: str) -> None:
    with pytest.raises(ScenarioError) as caught:
        parse_scenario(mast(HOLD, hinge=f", held_by: {name}"))
    assert f"hinges.foot.held_by: {message}" in str(caught.value)
