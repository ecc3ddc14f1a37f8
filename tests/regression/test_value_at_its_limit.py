"""Eyes of 50 mm on prongs of 300 mm failed a limit of D/d = 6, as `6.00 >= 6.00`.

The quotient of 0.3 and 0.05 is 5.999999999999999 in numbers of 64 bits, and was held against six as it is.
What is its limit but for rounding keeps it; what is past it by more than that does not.
"""

from __future__ import annotations

import pytest

from gantline.checks import Verdict, check_recording
from gantline.scenario import parse_scenario
from gantline.statics import Statics
from lift_text import changed
from spreader_lifts import one_bar


@pytest.mark.parametrize(("least", "verdict"), [(6.0, Verdict.OK), (6.000001, Verdict.FAILED)])
def test_what_is_its_limit_keeps_it(least: float, verdict: Verdict) -> None:
    """D/d = 300/50 at both eyes of each sling."""
    text = changed(
        one_bar(),
        ("damping_time: 20 ms,", "damping_time: 20 ms, diameter: 50 mm,"),
        ("{rope: sling}", "{rope: sling, bends_about: {top: 300 mm, bottom: 300 mm}}"),
        ("rule: yard,", f"rule: yard, sling_bending_ratio: {least},"),
    )
    checks = check_recording(Statics(parse_scenario(text)).equilibrium().recording)
    [ratio] = [one for one in checks if one.name == "sling_bending_ratio"]
    assert ratio.value == pytest.approx(6.0, rel=1e-12)
    assert ratio.verdict is verdict
