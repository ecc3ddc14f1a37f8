"""What stops a lift by jacks, which has no hook and no crane.

The first page of the lift in four strand jacks of the guide sent whoever reads load cells to its table
"Hooks", which it does not have, and for the wind to the manual of a crane.
"""

from __future__ import annotations

from gantline.report.first_page import stop_if
from gantline.report.subject import Subject
from gantline.results import Recording


def test_it_names_what_the_page_has() -> None:
    sentences = stop_if(Subject(Recording({}, {}, {"rig": {}})))
    assert sentences[0] == (
        "a load cell differs by more than 10 % from the tension of its rope under “Tensions and travel”"
    )
    assert (
        sentences[-1]
        == "wind exceeds the limit of what lifts (not in the lift file; from its manual: ______ m/s)"
    )
    assert not any("Hooks" in sentence or "crane" in sentence for sentence in sentences)


def test_a_lift_with_a_hook_has_its_table() -> None:
    sentences = stop_if(Subject(Recording({}, {}, {"rig": {"hooks": [{"name": "h"}]}})))
    assert sentences[0].endswith("from its reading in the table “Hooks”")
    assert sentences[-1].startswith("wind exceeds the crane's limit")
