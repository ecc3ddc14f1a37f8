"""A cargo barge without mooring lines drifted 15 m under the jacket leg that was raised from it.

The sheerleg beside it had its four lines; those of the barge were forgotten, and neither `gantline check` nor
the run said so.
"""

from __future__ import annotations

from gantline.assembly import assemble
from gantline.scenario import load_scenario

LINE = {
    "fairlead": ["2 m", "0 m", "6.5 m"],
    "to": ["-250 m", "0 m", "-30 m"],
    "rope": "moor_44",
    "pretension": "200 kN",
}


def _told(*moored: str) -> list[tuple[str, str]]:
    lines = {f"of.{name}": {"vessel": name, **LINE} for name in moored}
    lift = load_scenario("off_a_barge").changed({"mooring_lines": lines})
    return [(one.path, one.sentence) for one in assemble(lift).doubts if "on no mooring line" in one.sentence]


def test_one_beside_a_moored_one_is_told() -> None:
    sentence = (
        "cargo is on no mooring line, as barge is: nothing of the water holds it in plan, and it drifts off "
        "with what pulls or pushes it"
    )
    assert _told("barge") == [("vessels.cargo", sentence)]


def test_none_is_where_all_are_moored() -> None:
    assert _told("barge", "cargo") == []


def test_one_that_another_holds_is_moored() -> None:
    """As the scenario itself has it: the cargo barge lies at the crane barge."""
    doubts = assemble(load_scenario("off_a_barge")).doubts
    assert not any("on no mooring line" in one.sentence for one in doubts)
