"""A load and a lug with long names could not be named together.

A name has at most 64 characters. A sling goes to `LOAD.LUG`, measured as one name before: with a load of
40 characters and a lug of 30, each of them accepted, the lift was refused with "a name has at most 64
characters".
"""

from __future__ import annotations

import pytest

import gantline
from long_names import LOAD, LONG_NAMES, LUG


def test_a_sling_goes_to_a_long_lug_of_a_long_load() -> None:
    """The two names are 63 and 62 characters, 126 with the dot between them."""
    assert (len(LOAD), len(f"{LUG}0"), len(f"{LOAD}.{LUG}0")) == (63, 62, 126)
    scenario = gantline.parse_scenario(LONG_NAMES)
    assert [load.name for load in gantline.simulate(scenario).rig.loads] == [LOAD]


@pytest.mark.parametrize(
    ("name", "right"),
    [
        ("u" * 65, "a name has at most 64 characters"),
        (f"{LOAD}.{'u' * 65}", "a name has at most 64 characters between dots, 256 in all"),
        (".".join([LOAD] * 5), "a name has at most 64 characters between dots, 256 in all"),
    ],
)
def test_names_that_are_too_long(name: str, right: str) -> None:
    """Of the load, of a lug after its load, and of more than four names together."""
    with pytest.raises(gantline.ScenarioError) as refused:
        gantline.parse_scenario(LONG_NAMES.replace(f"to: {LOAD}.{LUG}0", f"to: {name}"))
    assert str(refused.value).rstrip().endswith(f"'; {right}")
