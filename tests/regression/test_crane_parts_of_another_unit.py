"""Parts of cranes, frames and vessels whose unit has slipped.

A girder of 2.6 t over 148 m, one that bends by 147 m, a boom of 1.5 t for 3600 t, a frame of 20 kg, 2000 % of
critical damping and a fairlead 950 m ahead of the bow were all in order.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from gantline.assembly import assemble
from gantline.scenario import Scenario, ScenarioError, load_scenario

SCENARIOS = Path(__file__).resolve().parents[2] / "scenarios"


@pytest.fixture(name="lifts", scope="module")
def _lifts() -> dict[str, Scenario]:
    return {name: load_scenario(SCENARIOS / name) for name in ("goliath", "floating_crane", "equalizer_yard")}


@pytest.mark.parametrize("name", ["goliath", "floating_crane", "equalizer_yard"])
def test_lifts_as_they_are_say_nothing(lifts: dict[str, Scenario], name: str) -> None:
    assert [one for one in assemble(lifts[name]).warnings if "slipped" in one] == []


@pytest.mark.parametrize(
    ("name", "path", "value", "said"),
    [
        ("goliath", "cranes.goliath.girder.mass", "2600 kg", "the girder of goliath weighs 2,600 kg"),
        ("goliath", "cranes.goliath.legs.fixed", "700 kg", "the fixed leg of goliath weighs 700 kg"),
        ("goliath", "cranes.goliath.trolleys.upper.mass", "300 kg", "trolley upper of goliath weighs 300 kg"),
        # 900 t x 9.81 m/s2 over 60 kN/m.
        ("goliath", "cranes.goliath.girder.vertical_stiffness", "60 kN/m", "would bend by 147.15 m"),
        ("floating_crane", "cranes.fc.boom.mass", "1500 kg", "the boom of fc weighs 1,500 kg"),
        # 1.51e6 t m2 over 1500 t are (31.7 m)2.
        ("floating_crane", "cranes.fc.boom.inertia", "1.51e6 kg m^2", "radius of gyration of 1 m"),
        ("floating_crane", "cranes.fc.boom.inertia", "1.51e9 t m^2", "radius of gyration of 1e+03 m"),
        ("equalizer_yard", "equalizers.e1.frame.mass", "20 kg", "the frame of e1 weighs 20 kg"),
        # 110 933 kg m2 over 20 t are (2.36 m)2.
        ("equalizer_yard", "equalizers.e1.frame.inertia_about_vertical", "110933 t m^2", "of 74.5 m and a"),
        ("equalizer_yard", "equalizers.e1.frame.inertia_about_vertical", "110 kg m^2", "of 0.0742 m and"),
    ],
)
def test_parts_of_another_unit_are_told(
    lifts: dict[str, Scenario], name: str, path: str, value: str, said: str
) -> None:
    told = [one for one in assemble(lifts[name].changed({path: value})).warnings if "slipped" in one]
    assert any(said in one for one in told), told


@pytest.mark.parametrize(
    ("path", "value", "said"),
    [
        ("vessels.barge.water_damping.critical.heave", "20", r"2000 % of critical damping; .* 'heave: 20 %'"),
        (
            "mooring_lines.bow.ps.fairlead.x",
            "1056 m",
            r"bow\.ps\.fairlead: this is 950\.4 m outside the hull of 'barge'",
        ),
    ],
)
def test_what_no_vessel_has_is_refused(lifts: dict[str, Scenario], path: str, value: str, said: str) -> None:
    with pytest.raises(ScenarioError, match=said):
        assemble(lifts["floating_crane"].changed({path: value}))
