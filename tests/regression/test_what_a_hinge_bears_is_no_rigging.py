"""Weights of the first page do not take for rigging what a hook pulls against a hinge.

"+ rigging below the hooks" was static hook load less design weight: a mast of 100 t that a hook pulled past
upright, against its foot pins, was shown with 558.3 t of rigging, in slings without mass.
"""

from __future__ import annotations

from gantline.report.first_page import FirstPage
from gantline.report.subject import Subject
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from hinged_mast import RAISE, mast


def test_no_rigging_is_made_up() -> None:
    content = FirstPage().content(Subject(simulate(parse_scenario(mast(RAISE)))))
    assert content is not None
    weights = dict(content["weights"])
    assert not any("rigging" in name for name in weights)
    # It is no sum of what stands above.
    assert weights["static hook load"] == "658.3 t" and "= static hook load" not in weights
