"""A hook was watched against itself where it was named in two ways, as `goliath.U1` and as `U1`.

Its distance was minus its own size from the start on. So was that of a dock to its own walls.
"""

from __future__ import annotations

import pytest

from gantline.assembly import assemble
from gantline.scenario import ScenarioError, load_scenario, parse_scenario


@pytest.mark.parametrize(
    ("pair", "told"),
    [
        ("goliath.U1, U1", "both are 'goliath.U1'; two things have a distance"),
        ("dock, dock.walls", "both have 'dock.walls'; two things have a distance"),
        ("U1, U2", None),
    ],
)
def test_two_names_of_one_thing(pair: str, told: str | None) -> None:
    lift = load_scenario("goliath")
    first = "  - {between: [block, dock]"
    text = lift.text.replace(first, f"  - {{between: [{pair}], smallest: 0.5 m}}\n{first}")
    try:
        assemble(parse_scenario(text, lift.source))
    except ScenarioError as error:
        assert [f"{one.path}: {one.sentence}" for one in error.problems] == [f"watch[1].between: {told}"]
    else:
        assert told is None
