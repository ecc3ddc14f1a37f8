"""A crane of which nothing said whether it is rated with its hook block.

Charts of most cranes are for all that hangs from the boom head. Where `rating_includes_hook_block` was left
out the rated capacity was held against the hook load instead, hook block and falls for nothing, and no line
of `check` or of a run said so: 58.9 % of a hook of 250 t became 55.2 %.
"""

from __future__ import annotations

import pytest

from four_slings import LIFT
from gantline.assembly import assemble
from gantline.scenario import parse_scenario

RATED, HEAVY = "rated_capacity: 60 t,", "hook_block_mass: 4 t,"


@pytest.mark.parametrize(
    ("more", "is_told"),
    [
        (f"{RATED} {HEAVY}", True),
        (f"{RATED} {HEAVY} rating_includes_hook_block: false,", False),
        (f"{RATED} {HEAVY} rating_includes_hook_block: true,", False),
        # Hook load and hoist load are the same, or nothing is compared with either.
        (RATED, False),
        (HEAVY, False),
    ],
)
def test_it_is_told_where_it_makes_a_difference(more: str, is_told: bool) -> None:
    warnings = assemble(parse_scenario(LIFT.replace("rated_capacity: 46 t,", more))).warnings
    said = [one for one in warnings if "rating_includes_hook_block" in one]
    assert len(said) == is_told
    assert all("crane" in one for one in said)
