"""Bounds past which a lift is not GO without a word where nobody sets a limit, and where they come from."""

from __future__ import annotations

import math
from collections.abc import Callable

from gantline.checks.measure import Alarm
from gantline.checks.moorings import moors_by_its_limit
from gantline.results import series
from gantline.results.gear import Spreader
from gantline.results.loads.carried import carried_round
from gantline.results.loads.hung_so import left_by_water
from gantline.results.recording import Recording
from gantline.results.rig import Load

__all__ = [
    "FALLS",
    "FALLS_TWIST",
    "HEEL",
    "HOOK_DYNAMICS",
    "LUG_PLATE",
    "ROD_ON_STOP",
    "ROPE_FACTOR",
    "SHEAVE_BENDING",
    "SIDE_LEAD",
    "SLACK_IN_WATER",
    "SLING_ANGLE",
    "SLING_BENDING",
    "SPREADER_TILT",
    "TILT",
    "TIPPING",
    "TRIM",
    "YAW",
]

#: Falls out of plumb whichever way [rad].
_OUT_OF_PLUMB = math.radians(2.0)
#: Heel or trim of a vessel [rad].
_LEANS = math.radians(5.0)
#: Turn of a load about plumb past which a corner of it comes where a side was [rad].
_ROUND = math.radians(45.0)
#: Share of what hangs that pulls a boom aside [1].
_ASIDE = 0.02
#: Angles to the plate of a lug: a sixth of the force is across it, more is across than along it [rad].
_ACROSS, _MOSTLY_ACROSS = math.radians(10.0), math.radians(45.0)
#: Share of its least static force that what water does has to leave a sling [1].
_OF_STATIC = 0.1


def _side_lead(recording: Recording, hook: str) -> float:
    """Angle at which the falls of a hook pull its boom aside more than lattice booms are made for [rad]."""
    return max([math.atan(_ASIDE), *_of_chart(recording, hook, "side_lead")])


def _tilt(recording: Recording, _load: str) -> float:
    """Tilt at which loose things begin to move [rad]; none where a plan or hinge turns it on purpose."""
    is_meant = bool(recording.rig.hinges) or any(step.turns for step in recording.rig.plan)
    return math.inf if is_meant else math.radians(5.0)


def _leans(key: str) -> Callable[[Recording, str], float]:
    """Heel or trim at which loose things on deck begin to move [rad], or past that the end of the charts."""

    def bound(recording: Recording, _vessel: str) -> float:
        every = [one for chart in recording.rig.rating_charts for one in (chart, *chart.own.values())]
        charts: list[float | None] = [getattr(chart, key) for chart in every]
        return max([_LEANS, *(angle for angle in charts if angle is not None)])

    return bound


def _yaw(recording: Recording, _load: str) -> float:
    """Turn about plumb past what carries a load turns, by which nobody lets one go [rad].

    None where a step asks for the heading.
    """
    if any("load_yaw" in step.require for step in recording.rig.plan):
        return math.inf
    return _ROUND + carried_round(recording)


def _falls(recording: Recording, hook: str) -> float:
    """Angle of the falls of a hook from plumb at which nobody lifts by intention [rad]."""
    leads = (lead for key in ("off_lead", "side_lead") for lead in _of_chart(recording, hook, key))
    return max([_OUT_OF_PLUMB, *leads])


def _of_chart(recording: Recording, hook: str, key: str) -> list[float]:
    """The lead up to which the chart of a hook holds [rad], if it says so: no alarm before."""
    charts = (chart.of(hook) for chart in recording.rig.rating_charts if hook in chart.hooks)
    return [lead for chart in charts if (lead := getattr(chart, key)) is not None]


def _rope_factor(recording: Recording, rope: str) -> float:
    """Least factor that rules have for slings [1]; none for mooring lines that have a limit of their own."""
    return 0.0 if moors_by_its_limit(recording, rope) else 2.3


def _across_plate(recording: Recording, element: str) -> float:
    """Angle to the plate of a lug past which it is bent by more than designers allow [rad].

    Of a lug of which nobody says how its plate stands that past which more pulls across than along it, if it
    stands as it is taken to.
    """
    holders: list[Load | Spreader] = [*recording.rig.loads, *recording.rig.spreaders]
    lugs = {f"{holder.name}.{name}": lug for holder in holders for name, lug in holder.lugs.items()}
    is_said = element in lugs and not lugs[element].plate_is_assumed
    return _ACROSS if is_said else _MOSTLY_ACROSS


def _slack_in_water(recording: Recording, sling: str) -> float:
    """Tension below which a sling of a load that water bears goes slack and snatches in a larger wave [N].

    Of the least that it bears at rest, once water bears the most of the load; none in air, where a load that
    is turned, or goes from crane to crane, leaves slings slack on purpose, and of a load that floats.
    """
    rig = recording.rig
    own = next(one for one in rig.slings if one.name == sling)
    load = next((one for one in rig.loads if one.name == own.to_load and one.in_water is not None), None)
    clear = series.is_clear(recording)
    if load is None or not clear.any():
        return -math.inf
    left, tension = left_by_water(recording, load), series.sling_tension(recording, own)
    still = []
    for window in series.quiet_windows(recording):
        bears, weighs = (series.static_value(recording, of, window) or 0.0 for of in (tension, left))
        still.append(bears * float(left[clear].min()) / weighs if weighs > 0.0 else 0.0)
    least = min(still, default=0.0)
    return _OF_STATIC * least if least > 0.0 else -math.inf


def _of_all(value: float, source: str) -> Alarm:
    """An alarm that is the same for every element, SI."""
    return Alarm(lambda _recording, _element: value, source)


FALLS = Alarm(_falls, "more than 3 % of what hangs pulls sideways; plausible, no document")
FALLS_TWIST = _of_all(
    0.5, "the hook block turns by 30 deg, and ropes come with torque of their own; plausible, no document"
)
SIDE_LEAD = Alarm(
    _side_lead, "lattice booms are made for 2 % of what is rated sideways, wind included: SAE J1093, J987"
)
TIPPING = _of_all(0.75, "crawler cranes are rated for 75 % of what tips them: ASME B30.5, 5-1.1.1")
SLACK_IN_WATER = Alarm(
    _slack_in_water,
    "a tenth of what slings bear at rest where water bears most: DNV-RP-H103, section 4, slack slings",
)
SLING_ANGLE = _of_all(math.radians(60.0), "slings are rated up to 60 deg: EN 13414-1, table 4")
LUG_PLATE = Alarm(
    _across_plate, "what pulls across a plate is beside the capacity of its lug; plausible, no document"
)
SLING_BENDING = _of_all(1.0, "0027/ND rev 11, 7.8.5, of the body of a sling")
ROPE_FACTOR = Alarm(_rope_factor, "least safety factor of 0027/ND rev 11, 7.3.1, straight and with sockets")
HOOK_DYNAMICS = _of_all(1.3, "more comes of snatching a load; plausible, no document")
SHEAVE_BENDING = _of_all(11.2, "drums of the lightest duty, group M1: ISO 4308-1:2003")
SPREADER_TILT = _of_all(
    math.radians(5.0),
    "makers rate spreaders level, not bent by what hangs; plausible, no document",
)
ROD_ON_STOP = _of_all(0.0, "on a stop it gives no more than a rod of steel; plausible, no document")
_ON_DECK = "loose things on deck begin to move, and cranes are rated for less; plausible, no document"
HEEL, TRIM = Alarm(_leans("heel"), _ON_DECK), Alarm(_leans("trim"), _ON_DECK)
TILT = Alarm(_tilt, "loose things on a load begin to move; plausible, no document")
YAW = Alarm(_yaw, "a corner is where a side was, beyond what crane or vessel turn by; plausible, no document")
