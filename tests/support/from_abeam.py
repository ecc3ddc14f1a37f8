"""The barge of `crane_barge_in_swell` in a swell and a wind sea from abeam, as the page on waves has it."""

from __future__ import annotations

from typing import Any

from gantline.scenario import Scenario, load_scenario

__all__ = ["SEAS", "barge_from_abeam"]

#: Significant height [m], peak period [s] and peak enhancement of swell and wind sea.
SEAS = ((0.8, 7.0, 3.3), (0.5, 4.5, 1.5))
#: Of what is critical, by lines and hull.
_NOTHING = {name: "0 %" for name in ("surge", "sway", "yaw")}


def barge_from_abeam(*, damped: bool = False, drift: bool = True, drift_damping: bool = True) -> Scenario:
    """The lift in these waves.

    Args:
        damped: Whether lines and hull take 5 % of what is critical, as in the scenario, or nothing.
        drift: Whether waves push by drift forces.
        drift_damping: Whether these damp slow motions.
    """
    swell, wind_sea = (
        {"significant_height": f"{height} m", "peak_period": f"{period} s", "direction": "90 deg"}
        for height, period, _ in SEAS
    )
    changes: dict[str, Any] = {
        "waves.swell": swell,
        "waves.wind_sea": {**wind_sea, "peak_enhancement": SEAS[1][2], "seed": 7},
        "vessels.barge.wave_forces.drift": drift,
    }
    if drift:
        changes["vessels.barge.wave_forces.drift_damping"] = drift_damping
    if not damped:
        periods = {"surge": "26 s", "sway": "39 s", "yaw": "41 s"}
        changes["vessels.barge.water_damping.critical"] = {**_NOTHING, "periods": periods}
    return load_scenario("crane_barge_in_swell").changed(changes)
