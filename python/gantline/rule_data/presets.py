"""Rules by name: what they ask for, as facts with their sources.

A preset is a start, not a rule to work to: confirm each figure in the edition that binds you. What is
*plausible* comes from no document, and every table of checks says so beside the figure.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Final

from gantline.arguments import needed

__all__ = [
    "FACTORS",
    "FOUR_SLINGS",
    "LIFT_FILE",
    "PRESETS",
    "SEVERAL_CRANES",
    "SIDE_LOAD",
    "SIDE_LOAD_SOURCE",
    "DynamicRow",
    "Preset",
    "Sourced",
    "dynamic_factor",
    "several_cranes",
]

#: Factors that rules may set, and what each is multiplied with.
FACTORS: Final[Mapping[str, str]] = MappingProxyType(
    {
        "dynamic_amplification_factor": "on static hook and sling loads, in place of a simulated peak",
        "skew_load_factor": "on forces with perfect lengths of slings that share so that lengths decide",
        "load_factor": "on rope forces",
        "consequence_factor": "on rope forces",
        "material_factor": "on rope forces",
        "wear_factor": "on rope forces",
        "termination_factor": "on rope forces, unless the bending factor is larger",
        "least_safety_factor": "least product of load, consequence and material factor",
        "lug_consequence_factor": "on lug loads, where a capacity does not hold it already",
        "shackle_breaking_factor": "between the dynamic load of a shackle and its minimum breaking force",
        "several_cranes_factor": "on the share of each crane, where several lift one load",
    }
)

#: Source of limits and factors of a lift file that names no rule.
LIFT_FILE: Final = "lift file"
_PLAUSIBLE: Final = "plausible, no document"
#: Superseded by DNV-ST-N001: confirm there. Sections as in revision 11.2 of 8 July 2016.
_ND: Final = "0027/ND rev 11"
#: What its skew load factor is for; for others 5.6.13 asks to calculate.
FOUR_SLINGS: Final = "four slings in matched pairs"

#: What remains of a shackle's working load limit, of its side load up to an angle [rad]: screw pin and bolt
#: type shackles. Angles between two rows of the chart (10 to 11 deg) belong to the worse one.
SIDE_LOAD: Final = tuple(
    (math.radians(angle), remains)
    for angle, remains in (
        (10.0, 1.00),
        (20.0, 0.85),
        (30.0, 0.75),
        (45.0, 0.70),
        (55.0, 0.60),
        (70.0, 0.55),
        (90.0, 0.50),
    )
)
SIDE_LOAD_SOURCE: Final = "Crosby side loading reduction chart"


@dataclass(frozen=True)
class Sourced:
    """A number with the source it was read in.

    Attributes:
        value: SI.
        source: Document and section, or that it is plausible only.
    """

    value: float
    source: str


@dataclass(frozen=True)
class DynamicRow:
    """Dynamic amplification factor of lifts up to a weight: `factor + falling * sqrt(100 t/weight)`.

    Attributes:
        up_to: Largest design weight of the row, as a mass [kg].
        factor: Its constant part [1].
        falling: Its part that falls with the weight [1].
    """

    up_to: float
    factor: float
    falling: float = 0.0


@dataclass(frozen=True)
class Preset:
    """A rule by name.

    Attributes:
        title: What it is.
        factors: Factors by the names of `FACTORS`.
        dynamic: Rows of its dynamic amplification factor, lightest first; empty if it is among `factors`.
        dynamic_source: Where these rows stand.
        limits: Limits by their names in a lift file, SI.
    """

    title: str
    factors: Mapping[str, Sourced] = field(default_factory=dict)
    dynamic: Sequence[DynamicRow] = ()
    dynamic_source: str = ""
    limits: Mapping[str, Sourced] = field(default_factory=dict)


def dynamic_factor(preset: Preset, mass: float | None) -> Sourced | None:
    """Dynamic amplification factor that a preset asks of a lift.

    Args:
        preset: The rule.
        mass: Design weight of the load [kg]; None if there is none.

    Returns:
        The factor; None if the rule has none, or needs a weight that is not there.

    Raises:
        TypeError: If it is no preset, such as the name of one.
    """
    needed(preset, Preset, "a preset", "gantline.rule_data.PRESETS has them by the names of rules")
    if "dynamic_amplification_factor" in preset.factors:
        return preset.factors["dynamic_amplification_factor"]
    if mass is None or not preset.dynamic:
        return None
    row = next((row for row in preset.dynamic if mass <= row.up_to), preset.dynamic[-1])
    weight = max(mass, 3e3)  # below 3 t the table asks to calculate with 3 t
    return Sourced(row.factor + row.falling * math.sqrt(100e3 / weight), preset.dynamic_source)


#: Factor on the share of each crane by how many lift one load, by the name of the rule; the last row is for
#: more of them too.
SEVERAL_CRANES: Final[Mapping[str, Mapping[int, Sourced]]] = MappingProxyType(
    {
        "queensland": {
            count: Sourced(factor, f"Mobile crane code of practice 2006, Queensland, 14.3.2: {count} cranes")
            for count, factor in ((2, 1.20), (3, 1.33), (4, 1.50))
        }
    }
)


def several_cranes(rule: str, cranes: int) -> Sourced | None:
    """Factor of a rule on the share of each of several cranes; None of one alone.

    Args:
        rule: A name of `SEVERAL_CRANES`.
        cranes: How many lift one load.

    Raises:
        KeyError: If there is no such rule.
    """
    if rule not in SEVERAL_CRANES:
        raise KeyError(f"no rule for several cranes is {rule!r}; there are {', '.join(SEVERAL_CRANES)}")
    rows = SEVERAL_CRANES[rule]
    return rows[min(cranes, max(rows))] if cranes > 1 else None


def _nd(place: str, column: Sequence[tuple[float, float, float]]) -> Preset:
    """0027/ND with one column of its table of dynamic amplification factors."""
    return Preset(
        title=f"0027/ND, marine lifting, {place}",
        factors={
            "skew_load_factor": Sourced(1.25, f"{_ND}, 5.6.12: {FOUR_SLINGS}, made to 2 d"),
            "load_factor": Sourced(1.3, f"{_ND}, 7.4.1"),
            "consequence_factor": Sourced(1.3, f"{_ND}, 7.5.1"),
            "material_factor": Sourced(1.5, f"{_ND}, 7.10.1: steel rope, certified"),
            "wear_factor": Sourced(1.0, f"{_ND}, 7.9.1: inspected; 1.2 for slings of a yard, 7.9.4"),
            "least_safety_factor": Sourced(2.3, f"{_ND}, 7.3.1"),
            "shackle_breaking_factor": Sourced(3.0, f"{_ND}, 8.2.6"),
        },
        dynamic=[DynamicRow(1e3 * up_to, factor, falling) for up_to, factor, falling in column],
        dynamic_source=f"{_ND}, table 5-1, {place}, by design weight",
        limits={"sling_bending_ratio": Sourced(1.0, f"{_ND}, 7.8.5")},
    )


def _example() -> Preset:
    """Figures of a yard that are usual and that no document stands behind."""

    def plausible(value: float) -> Sourced:
        return Sourced(value, _PLAUSIBLE)

    return Preset(
        title="A yard's own rule, for example",
        factors={
            "dynamic_amplification_factor": plausible(1.05),
            "skew_load_factor": Sourced(1.25, f"{_ND}, 5.6.12: {FOUR_SLINGS}, made to 2 d"),
        },
        limits={
            "hook_dynamic_factor": plausible(1.10),
            "load_tilt": plausible(math.radians(2.0)),
            "sling_angle_from_vertical": plausible(math.radians(30.0)),
            "lug_out_of_plane_angle": plausible(math.radians(10.0)),
            "sling_factor_on_breaking_force": plausible(5.0),
            "smallest_sling_tension_when_clear": plausible(20e3),
            "tension_spread_when_clear": plausible(0.05),
            "equalizer_travel_used": plausible(0.90),
            "skew_load_factor": plausible(1.25),
        },
    )


PRESETS: Final[Mapping[str, Preset]] = MappingProxyType(
    {
        "nd_0027_onshore": _nd(
            "onshore", [(100, 1.10, 0), (300, 1.05, 0), (1000, 1.05, 0), (2500, 1.03, 0), (math.inf, 1.03, 0)]
        ),
        "nd_0027_inshore": _nd(
            "inshore",
            [(100, 1.07, 0.05), (300, 1.12, 0), (1000, 1.10, 0), (2500, 1.08, 0), (math.inf, 1.05, 0)],
        ),
        "nd_0027_offshore": _nd(
            "offshore",
            [(100, 1.0, 0.25), (300, 1.25, 0), (1000, 1.20, 0), (2500, 1.15, 0), (math.inf, 1.10, 0)],
        ),
        "example_yard": _example(),
    }
)
