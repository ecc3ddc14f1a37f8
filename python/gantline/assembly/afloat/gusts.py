"""Gusts of the wind: regular ones, carried along by the mean, whose sum has a spectrum of Kaimal's form.

n S(n)/σ² = 6.8 x (1 + 10.2 x)^(−5/3) with x = n L/U, n in hertz: EN 1991-1-4, B.1(2).
"""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass

import numpy as np
import numpy.typing as npt

from gantline.assembly.afloat.trains import Train
from gantline.assembly.parts import Json
from gantline.hydro.waves import Components, phases
from gantline.scenario import Scenario
from gantline.scenario.afloat.stream import Wind

__all__ = ["gusts", "wind_of_limit", "wind_rig"]

Array = npt.NDArray[np.float64]

#: What makes a mean over ten minutes, and what a load answers as a whole [s]: gusts are between.
_SLOWEST, _FASTEST = 600.0, 2.0
#: Gusts are means over so long [s], as of cranes: ISO 4302.
_OF_GUST = 3.0
#: In Kaimal's form (EN 1991-1-4, B.1).
_IN_FORM = 10.2
#: Regular gusts that the speed of gusts is worked out with, whatever the lift has.
_FINE = 1000
#: Constant of Euler and Mascheroni.
_EULER = 0.5772156649015329
#: Gusts grow over so long, about one swing of a load on its falls [s].
_RISE_TIME = 20.0


@dataclass(frozen=True)
class _Regular:
    """Regular gusts of equal energy.

    Attributes:
        frequency: ω (n,) [rad/s].
        amplitude: of each, over the standard deviation of all [1].
    """

    frequency: Array
    amplitude: float

    @property
    def highest_mean(self) -> float:
        """Highest mean over 3 s expected in ten minutes, in standard deviations [1] (Davenport 1964)."""
        share = np.sinc(self.frequency * _OF_GUST / (2 * math.pi))  # of an amplitude, as a mean over 3 s
        variance = self.amplitude**2 / 2 * share**2
        crossings = math.sqrt(float(variance @ self.frequency**2) / float(variance.sum())) / (2 * math.pi)
        most = math.sqrt(2 * math.log(crossings * _SLOWEST))
        return math.sqrt(float(variance.sum())) * (most + _EULER / most)


def _regular(speed: float, length: float, count: int) -> _Regular:
    """Gusts at the middles of equal shares of the energy between ten minutes and two seconds."""
    scale = _IN_FORM * length / speed
    # Energy of what is slower than n: 1 − (1 + 10.2 n L/U)^(−2/3).
    slower = [1.0 - (1.0 + scale / period) ** (-2 / 3) for period in (_SLOWEST, _FASTEST)]
    middles = slower[0] + (slower[1] - slower[0]) * (np.arange(count) + 0.5) / count
    return _Regular(2 * math.pi * ((1.0 - middles) ** -1.5 - 1.0) / scale, math.sqrt(2 / count))


def _deviation(wind: Wind) -> float:
    """σ of the speed [m/s]."""
    gusts = wind.gusts
    assert gusts is not None  # asked for by who has looked
    if gusts.turbulence is not None:
        return gusts.turbulence * wind.speed
    assert gusts.speed is not None  # validated
    return (gusts.speed - wind.speed) / _regular(wind.speed, gusts.length, _FINE).highest_mean


def _gust_speed(wind: Wind) -> float:
    """Speed of gusts as given, or as turbulence makes it; of steady wind its speed [m/s]."""
    if wind.gusts is None:
        return wind.speed
    if wind.gusts.speed is not None:
        return wind.gusts.speed
    return wind.speed + _deviation(wind) * _regular(wind.speed, wind.gusts.length, _FINE).highest_mean


def gusts(wind: Wind) -> Json:
    """What the core reads: η = g(t) Σ a cos(k·x − ωt + ε) on top of the mean, k = ω/U along it.

    Frequencies have no common measure, so that the record does not repeat; phases are drawn by lot.
    """
    given = wind.gusts
    assert given is not None  # asked for by who has looked
    regular, count = _regular(wind.speed, given.length, given.components), given.components
    amplitude = np.full(count, regular.amplitude * _deviation(wind))
    record = Components(regular.frequency, amplitude, phases(count, f"{given.seed}/wind"), wind.direction)
    return {"components": Train.of(record, regular.frequency / wind.speed).document, "rise_time": _RISE_TIME}


def wind_of_limit(scenario: Scenario, top: float) -> float | None:
    """Speed of the wind that is held against limits, of gusts where it has any [m/s]; None if not said.

    Args:
        scenario: the lift.
        top: z of the top of a crane [m], where its maker means it.
    """
    wind = scenario.wind
    if isinstance(wind, Wind):
        return _gust_speed(wind) + wind.speed * (scenario.wind_share(top) - 1.0)
    return 0.0 if wind == "none" else wind


def wind_rig(scenario: Scenario, record: Json | None) -> Json:
    """What results need to know of the wind; SI. Nothing where it has no direction.

    Args:
        scenario: the lift.
        record: gusts of its wind as the core has them.
    """
    wind, profile = scenario.wind, scenario.wind_profile
    if not isinstance(wind, Wind):
        return {}
    found: Json = {"speed": wind.speed, "direction": wind.direction}
    if profile is not None:
        found["profile"] = asdict(profile)
    if record is not None and wind.gusts is not None:
        found |= {"gust_speed": _gust_speed(wind), "turbulence": _deviation(wind) / wind.speed}
        found |= {"seed": wind.gusts.seed, "gusts": record}
    return {"wind": found}
