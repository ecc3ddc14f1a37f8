"""How high waves of a period get: regular ones before they break, seas before crests topple."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from gantline.hydro.waves import wave_number
from gantline.scenario import Scenario
from gantline.scenario.afloat.water import Water
from gantline.scenario.afloat.waves import WaveTrain
from gantline.scenario.errors import Doubt

__all__ = ["doubts_of_steepness", "highest_sea", "refuse_breaking"]

#: Height over length at which a regular wave breaks in deep water: Michell 1893.
_BREAKS = 0.142
#: A sea is no steeper, height over length in deep water by the peak, linear between these peaks [s]:
#: DNV-RP-C205, 3.5.4.
_STEEPEST = ((8.0, 15.0), (1.0 / 15.0, 1.0 / 25.0))
#: Longest peak of a sea and longest regular waves that anyone lifts in [s]; beyond are surges and tides.
_LONGEST, _LONGEST_REGULAR = 30.0, 60.0
#: A sea that is lower than this share of its length is no sea.
_LOWEST = 1.0 / 20000.0
_SLIPPED = "a unit or digit has slipped"


def refuse_breaking(scenario: Scenario) -> None:
    """Refuse waves that cannot stand.

    Raises:
        ScenarioError: if waves break.
    """
    depth = (scenario.water or Water()).depth
    where = "in deep water" if depth is None else f"in a depth of {depth:g} m"
    for name, train in (scenario.waves or {}).items():
        most = _breaks_from(train.main_period, scenario)
        height = train.main_height
        if height > most:
            key = "height" if train.is_regular else "significant_height"
            found = f"{height:g} m every {train.main_period:g} s break {where}"
            raise scenario.error(("waves", name, key), f"{found}; less than {most:.3g} m stand")


def doubts_of_steepness(scenario: Scenario) -> list[Doubt]:
    """Seas that are steeper than seas are, and waves that are longer or lower."""
    found = list[Doubt]()
    for name, train in (scenario.waves or {}).items():
        found += _longer_or_lower(scenario, name, train)
        if train.is_regular or train.main_height <= _steepest(train.main_period, scenario):
            continue
        share = float(np.interp(train.main_period, *_STEEPEST))
        sentence = (
            f"{name} is steeper than seas are: {train.main_height:g} m at a peak of "
            f"{train.main_period:g} s, more than 1/{1 / share:.3g} of its length (DNV-RP-C205, 3.5.4)"
        )
        found.append(Doubt(("waves", name, "significant_height"), sentence))
    return found


def _longer_or_lower(scenario: Scenario, name: str, train: WaveTrain) -> Iterator[Doubt]:
    """Waves that nothing follows or feels, so that everything passes: 80 s for 8 s, 1.5 mm for 1.5 m."""
    period, is_regular = train.main_period, train.is_regular
    if period > (_LONGEST_REGULAR if is_regular else _LONGEST):
        key = "period" if is_regular else "peak_period"
        found = f"{name} has a {key.replace('_', ' ')} of {period:g} s"
        yield Doubt(("waves", name, key), f"{found}, longer than waves of wind and swell; {_SLIPPED}")
    length = scenario.simulation.gravity * period**2 / (2 * math.pi)
    if not is_regular and 0.0 < train.main_height < _LOWEST * length:
        sentence = f"{name} is {train.main_height:g} m high at a peak of {period:g} s: no sea is as low"
        yield Doubt(("waves", name, "significant_height"), f"{sentence}; {_SLIPPED}")


def highest_sea(scenario: Scenario, name: str, period: float) -> float:
    """Height beyond which waves of a lift would be steeper than any are, with another period [s] too [m]."""
    most = _breaks_from(period, scenario)
    is_regular = (scenario.waves or {})[name].is_regular
    return most if is_regular else min(most, _steepest(period, scenario))


def _breaks_from(period: float, scenario: Scenario) -> float:
    """No wave is higher than 0.142 λ tanh κd [m]: Michell 1893 in deep water, Miche 1944."""
    depth = (scenario.water or Water()).depth
    frequency = np.array([2 * math.pi / period])
    number = float(wave_number(frequency, scenario.simulation.gravity, depth)[0])
    return _BREAKS * 2 * math.pi / number * (1.0 if depth is None else math.tanh(number * depth))


def _steepest(period: float, scenario: Scenario) -> float:
    """Significant height of the steepest sea with this peak [m]."""
    length = scenario.simulation.gravity * period**2 / (2 * math.pi)
    return float(np.interp(period, *_STEEPEST)) * length
