"""`'U3' has no shape; known here: …` of a Goliath crane had room for twelve names, and none of a hook.

Each keel block and leg stood there by itself, and `goliath.U1`, which was meant, came after them all.
"""

from __future__ import annotations

import pytest

from gantline.assembly import assemble
from gantline.scenario import ScenarioError, load_scenario


def test_hooks_come_before_parts() -> None:
    lift = load_scenario("goliath")
    hooks = sorted(lift.hooks)
    with pytest.raises(ScenarioError) as error:
        assemble(lift.changed({"watch": [{"between": ["U3", "block"], "smallest": "1 m"}]}))
    [problem] = error.value.problems
    listed = problem.message.partition("known here: ")[2]
    assert hooks and all(f"'{hook}'" in listed for hook in hooks)
    assert "'block'" in listed and "'goliath'" in listed
