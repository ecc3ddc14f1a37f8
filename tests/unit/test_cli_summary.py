"""The final table: rows worked out by hand."""

import math

import numpy as np
import pytest

from gantline.checks import check_recording
from gantline.cli.summary import summary
from gantline.cli.table import table
from sample_lift import ringing_lift, sample_rig

HIGHEST = 600e3 + 100e3 * math.sin(2 * math.pi * 0.24)


def lines(**given: object) -> list[str]:
    recording = ringing_lift(**given)
    return summary(recording, check_recording(recording), lambda verdict: f"  {verdict:<11}")


def row(text: list[str], start: str, below: str = "") -> str:
    """The one line that begins like this, with single blanks; `below` a line that begins like that."""
    first = next(number for number, line in enumerate(text) if line.startswith(below))
    found = next(line for line in text[first:] if line.startswith(start))
    return " ".join(found.split())


def test_columns_are_aligned() -> None:
    assert table(("Sling", "static"), [("S1", "1.0 kN"), ("S10", "20.0 kN")], "lr") == [
        "Sling   static",
        "  S1    1.0 kN",
        "  S10  20.0 kN",
    ]


def test_a_sling_with_its_static_and_peak_force() -> None:
    found = row(lines(), "  S1  ")
    assert found.startswith(f"S1 600.0 kN {HIGHEST / 1e3:.1f} kN ")
    angle = math.degrees(math.atan2(math.hypot(0.7, 2.5), 36.483 - 8.65 - 5.0))
    assert found.endswith(f"{angle:.1f} deg {angle:.1f} deg")


def test_what_rope_shackle_and_lug_use() -> None:
    rig = sample_rig()
    rig["slings"][0]["shackles"] = {
        "top": {"name": "wide", "working_load_limit": 800e3},
        "bottom": {"name": "narrow", "working_load_limit": 750e3},
    }
    text = lines(rig=rig)
    aside = math.degrees(math.asin(2.5 / math.hypot(0.7, 2.5, 22.833)))
    expected = f"S1 {HIGHEST / 3039e3:.1%} {600 / 750:.1%} {HIGHEST / (80e3 * 9.81):.1%} {aside:.1f} deg"
    assert row(text, "  S1", below="Used") == expected.replace("%", " %")


def test_what_an_equalizing_rope_uses() -> None:
    used = f"{HIGHEST / 2 / 1476e3:.1%}".replace("%", " %")
    assert row(lines(), "  equalizing rope").endswith(f"{used} of minimum breaking force")
    rig = sample_rig()
    del rig["ropes"][0]
    assert "minimum breaking force" not in row(lines(rig=rig), "  equalizing rope")


def test_ropes_that_are_neither_slings_nor_equalizing_ropes() -> None:
    assert not any(line.startswith("Rope") for line in lines())
    rig = {**sample_rig(), "slings": [], "equalizers": []}
    text = lines(rig=rig)
    used = f"{HIGHEST / 3039e3:.1%}".replace("%", " %")
    assert row(text, "  sling.S1").startswith(f"sling.S1 600.0 kN {HIGHEST / 1e3:.1f} kN ")
    assert row(text, "  sling.S1").endswith(used)
    text = lines(rig={**rig, "ropes": []})
    assert row(text, "Rope") == "Rope at the end peak at"


def test_hook_and_hoist_load_with_the_share_of_the_rated_capacity() -> None:
    static, peak = 5 * 600e3 + 21.5e3 * 9.81, 5 * HIGHEST + 21.5e3 * 9.81
    found = row(lines(), "  test_hook  hook load")
    assert f"{static / 1e3:.1f} kN {peak / 1e3:.1f} kN" in found
    assert found.endswith(f"{peak / static:.3f} {peak / (400e3 * 9.81):.1%}".replace("%", " %"))


def test_readings_at_hold_points() -> None:
    rig = sample_rig()
    rig["plan"] = [
        {"step": "hoist", "kind": "hoist", "report": ["hook_load", "load_transferred", "equalizer_travel"]}
    ]
    text = lines(rig=rig)
    assert "At the end of 'hoist', 20.00 s" in text
    assert row(text, "  hook load  ") == f"hook load test_hook {(3000e3 + 21.5e3 * 9.81) / 1e3:.1f} kN"
    assert row(text, "  load transferred", below="At the end").split()[2:] == ["block", "100.0", "%"]
    assert "e1.5 0.000 m" in row(text, "  equalizer travel")


def test_checks_stand_with_their_verdicts_and_places() -> None:
    text = lines(rig=sample_rig(rule="example", load_tilt=math.radians(2.0), wind_speed=16.0))
    assert any("Check (example)" in line for line in text)
    assert row(text, "  warning      load_tilt").startswith("warning load_tilt 0.00 deg <= 2.00 deg 0.0 % ")
    at = next(number for number, line in enumerate(text) if "wind_speed" in line)
    assert " ".join(text[at].split()) == "warning wind_speed - - -"
    assert text[at + 1].strip() == "(this limit is not known here)"


@pytest.mark.parametrize(("most", "is_told"), [(1.5, True), (0.5, False)])
def test_yaw_stands_below_tilt_if_the_load_turns_by_more_than_a_degree(most: float, is_told: bool) -> None:
    text = lines(load_yaw=np.radians(np.linspace(0.0, -most, 2001)))
    found = [" ".join(line.split()) for line in text if line.startswith("  yaw")]
    assert found == (["yaw from the start 1.50 deg at most, at 40.00 s"] if is_told else [])


def test_a_lift_that_never_came_clear_says_so() -> None:
    recording = ringing_lift()
    contact = recording["contact_force"].values * 0 + 1e5
    text = lines(contact=contact, events=[])
    assert row(text, "  lift-off") == "lift-off never clear of a support"
    assert row(text, "  S1  ").split()[1] == "-"
