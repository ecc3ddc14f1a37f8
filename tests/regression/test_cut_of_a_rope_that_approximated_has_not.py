"""A step that cuts the equalizing rope of an equalizer with `mechanism: approximated`, which has none.

Its slings hang from the frame, and no rope runs over sheaves; `cut: e1.equalizing` was taken for a rope all
the same, and `gantline check` and `gantline run` ended in a traceback: an IndexError.
"""

from __future__ import annotations

import pytest

from gantline.assembly import assemble
from gantline.scenario import ScenarioError, parse_scenario
from lift_text import changed, spoiled

APPROXIMATED = "    mechanism: approximated\n    adjusting_factor: 0.02\n"
HOLD = "  - {step: hold, hold: until_end}\n"
CUT = "  - {step: hold, hold: until_end, cut: e1.equalizing}\n"
KIND = f"equalizer_types:\n  old:\n{APPROXIMATED}equalizers:\n  e1:\n    type: old\n"


@pytest.mark.parametrize(
    ("old", "new"),
    [("    rope: thick\n", f"{APPROXIMATED}    rope: thick\n"), ("equalizers:\n  e1:\n", KIND)],
    ids=["its own word", "of its type"],
)
def test_it_is_refused(old: str, new: str) -> None:
    with pytest.raises(ScenarioError) as problem:
        parse_scenario(changed(spoiled(old, new), (HOLD, CUT)))
    said = "plan[2].cut: 'e1.equalizing' is not a rope; known here: 'sling.S1', 'sling.S2'"
    assert said in str(problem.value)


def test_of_sheaves_it_is_cut() -> None:
    document = assemble(parse_scenario(spoiled(HOLD, CUT))).document
    assert document["plan"][1]["cuts"] == ["e1.equalizing"]
