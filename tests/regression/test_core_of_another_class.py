"""A rope of a known class with a core that the class has not was answered with ropes of other classes.

`34x7 WSC`, as makers call a rotation-resistant rope with a strand of steel in its middle, got "did you mean
'6x7 WSC' or '34x7 FC' or '6x37M WSC'?": a rope that twists, one with a core of fibre, softer by a fifth, and
a third one. The class is known with a `steel core`.
"""

from __future__ import annotations

import pytest

from gantline.scenario import ScenarioError, parse_scenario

LIFT = "format: 1\nlift: {title: t}\nropes:\n  one: {construction: %s, grade: 1960, diameter: 26 mm}\n"


@pytest.mark.parametrize(
    ("construction", "right"),
    [
        ("34x7 WSC", "'34x7 FC' or '34x7 steel core'"),
        ("34x7-IWRC", "'34x7 FC' or '34x7 steel core'"),
        ("8x19 WSC", "'8x19 FC' or '8x19 IWRC'"),
        ("6x19M IWRC", "'6x19M FC' or '6x19M WSC'"),
    ],
)
def test_cores_of_the_class_are_named(construction: str, right: str) -> None:
    """All cores that EN 12385-4 has factors for, and no other class."""
    with pytest.raises(ScenarioError) as error:
        parse_scenario(LIFT % construction)
    assert f"is not a construction that is known here; did you mean {right}?" in str(error.value)
