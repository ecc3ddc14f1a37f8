"""A limit of 3 rad for 3 deg on heel let everything pass, without a word.

Limits that are angles were told from half a turn on. A vessel that heels by 172° has capsized, and falls that
lead by 40° have left their sheaves.
"""

from __future__ import annotations

import pytest

from gantline.assembly import assemble
from gantline.scenario import load_scenario


@pytest.mark.parametrize(
    ("key", "limit", "shown"),
    [
        ("heel", "3 rad", "172 deg"),
        ("side_lead", "40 deg", "40 deg"),
        ("sling_angle_from_vertical", "90 deg", "90 deg"),
        ("heel", "15 deg", None),
        ("off_lead", "10 deg", None),
        ("load_tilt", "3.14 rad", None),  # a load that is turned over
        ("load_tilt", "5 rad", "286 deg"),
        ("lug_out_of_plane_angle", "90 deg", None),
        ("spreader_tilt", "45 deg", None),
    ],
)
def test_what_is_no_limit(key: str, limit: str, shown: str | None) -> None:
    scenario = load_scenario("revolving_crane").changed({f"limits.{key}": limit})
    said = [f"a limit of {shown} lets everything pass; a unit or digit has slipped"]
    assert [one.sentence for one in assemble(scenario).doubts] == (said if shown else [])
