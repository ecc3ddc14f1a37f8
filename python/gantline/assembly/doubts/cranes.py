"""What can be built of cranes and cannot well be meant: charts, and masses of which a unit has slipped."""

from __future__ import annotations

import math
from collections.abc import Iterator

from gantline.scenario import Scenario
from gantline.scenario.cranes.boom import FloatingCrane
from gantline.scenario.cranes.charts import Chart, boom_charts
from gantline.scenario.cranes.crawler import Crawler
from gantline.scenario.cranes.goliath import Goliath
from gantline.scenario.cranes.heave import FILTER
from gantline.scenario.errors import Doubt
from gantline.scenario.findings import Path
from gantline.units import format_by_size, format_quantity

__all__ = ["doubtful_cranes", "rows_by_radius", "tipping_mass"]

#: Hook blocks weigh some hundredths of what they may carry; less than this share is a slip [1].
_LIGHTEST = 0.002
#: So do girders, legs, trolleys and booms, by a hundredth at the very least [1].
_LIGHTEST_PART = 0.01
#: Motors and brakes of hoists hold 1 to 2.5 times what is rated; more than this is a pull of the hook where
#: that of a rope is asked for [1].
_STRONGEST = 3.0
#: Girders bend by about a thousandth of their span under what they may carry; more than this is none [1].
_SOFTEST = 0.02
#: Radii of gyration of a boom about its middle are about 0.3 of its length [1].
_RADII = (0.03, 1.0)
#: Charts of crawler cranes are for 75 % of what tips them (ASME B30.5, 5-1.1.1), of which lift files may
#: have rough masses; more than this share is neither [1].
_MOST_OF_TIPPING = 0.9
#: Legs stand on their rails by a third to an eighth of the span; less than a twentieth, and more than twice
#: the span, is a slip [1].
_BASES = (0.05, 2.0)
#: Upper sheaves of trolleys are on the girder or under it: how far they may be above its underside, and below
#: it, as shares of the span [1], and on top of either [m].
_SHEAVES_ABOVE, _SHEAVES_BELOW, _SHEAVES_BESIDE = 0.25, 0.1, 3.0
#: Period of a swell [s], and the share of its heave that a filter may leave before it is none [1].
_SWELL, _LEFT = 10.0, 0.25


def doubtful_cranes(scenario: Scenario) -> list[Doubt]:
    """Each thing that cannot well be meant of cranes."""
    return [
        *_rising_charts(scenario),
        *_unsaid_ratings(scenario),
        *_charts_past_tipping(scenario),
        *_counterweights_past_tipping(scenario),
        *_light_hook_blocks(scenario),
        *_strong_hoists(scenario),
        *_light_parts(scenario),
        *_soft_girders(scenario),
        *_bases(scenario),
        *_sheaves_off_girders(scenario),
        *_short_filters(scenario),
        *_thin_booms(scenario),
    ]


def _rising_charts(scenario: Scenario) -> list[Doubt]:
    """Each rating chart by which more may hang farther out."""
    doubts = []
    for one in boom_charts(scenario):
        chart = one.rating
        if chart.rises is not None:
            unit = "deg" if chart.over == "angle" else "m"
            near, far = (
                f"{format_quantity(mass, 't', 1)} at {format_quantity(place, unit, 1)}"
                for place, mass in chart.rises
            )
            sentence = f"the rating chart of {one.owner} has {far} and only {near}, nearer by"
            doubts.append(Doubt(one.path, f"{sentence}; charts fall outwards"))
    return doubts


def _unsaid_ratings(scenario: Scenario) -> list[Doubt]:
    """Each crane of which nothing says whether its ratings have hook block and falls in them.

    They are then taken for hook loads, which leaves the weight of hook block and falls out.
    """
    doubts = []
    charted = {chart.crane for chart in boom_charts(scenario)}
    for name, crane in (scenario.cranes or {}).items():
        hooks = [hook for hook in scenario.hooks.values() if hook.crane == name]
        is_heavy = any(hook.hook_block is not None or hook.hook_block_mass > 0.0 for hook in hooks)
        of_trolleys = crane.trolleys.values() if isinstance(crane, Goliath) else ()
        rated = [one.rated_capacity for one in (crane, *hooks, *of_trolleys)]
        is_rated = name in charted or any(one is not None for one in rated)
        if is_heavy and is_rated and "rating_includes_hook_block" not in crane.model_fields_set:
            sentence = (
                f"nothing says whether {name} is rated with its hook block and falls: they are left out of "
                "what is compared; 'rating_includes_hook_block: true' counts them, as most charts do"
            )
            doubts.append(Doubt(("cranes", name), sentence))
    return doubts


def _charts_past_tipping(scenario: Scenario) -> Iterator[Doubt]:
    """Each crawler crane whose chart and masses do not agree: it would nearly tip, or more."""
    for one in boom_charts(scenario):
        crane = (scenario.cranes or {})[one.crane]
        if not isinstance(crane, Crawler) or one.rating.over == "outreach":
            continue
        used, radius, rated = max(
            (rated / max(tipping_mass(crane, radius, one), 1.0), radius, rated)
            for radius, rated in rows_by_radius(crane, one)
        )
        if used > _MOST_OF_TIPPING:
            row = f"{format_quantity(rated, 't', 1)} at {format_quantity(radius, 'm', 1)}"
            share = f"{100.0 * used:.3g} % of what tips the crane by its masses, where 75 % is usual"
            right = "the chart is too large, or a mass of the crane too small"
            sentence = f"the rating chart of {one.owner} has {row}, {share}; {right}"
            yield Doubt(one.path, sentence)


def _counterweights_past_tipping(scenario: Scenario) -> Iterator[Doubt]:
    """Each crawler crane that its counterweight tips over backwards where nothing hangs in its hooks."""
    for name, crane in (scenario.cranes or {}).items():
        if not isinstance(crane, Crawler):
            continue
        half = min(crane.tracks.gauge, crane.tracks.length) / 2
        weight, boom = crane.counterweight, crane.boom
        head = boom.length * math.cos(boom.angle)
        ahead = boom.heel_pins.ahead
        holds = math.fsum(
            (
                (crane.base_mass + crane.central_ballast) * half,
                boom.mass * (half + ahead + boom.centre_of_gravity * head),
                boom.head_gear * (half + ahead + head),
            )
        )
        tips = weight.mass * (weight.behind - half)
        if tips <= holds:
            continue
        counter = f"{format_quantity(weight.mass, 't', 1)} of counterweight"
        about = f"about the line {format_quantity(half, 'm', 2)} behind its slewing axis"
        moments = f"{tips / 1e3:.0f} t m against {holds / 1e3:.0f} t m of base and boom"
        sentence = (
            f"{counter} tip {name} over backwards {about}, {moments}: only what hangs in its hooks holds it, "
            "and as it lands or is lost the crane falls; see the masses, and 'behind'"
        )
        yield Doubt(("cranes", name, "counterweight"), sentence)


def rows_by_radius(crane: Crawler, chart: Chart) -> list[tuple[float, float]]:
    """Rows of a chart as radius [m] and rated load [kg]."""
    if chart.rating.over == "radius":
        return chart.rating.rows
    ahead, length, over = crane.boom.heel_pins.ahead, *_pin(crane, chart)
    return [(ahead + length * math.cos(angle + over), rated) for angle, rated in chart.rating.rows]


def _pin(crane: Crawler, chart: Chart) -> tuple[float, float]:
    """How far from the heel pins a hook with its own chart hangs [m], and that line over the boom [rad].

    Of a chart of the crane the head of its boom.
    """
    if chart.hook is None:
        return crane.boom.length, 0.0
    hook = chart.hooks[0]
    out = crane.boom.length + hook.along
    return math.hypot(out, hook.above), math.atan2(hook.above, out)


def tipping_mass(crane: Crawler, radius: float, chart: Chart) -> float:
    """What tips a crane that stands alone at a radius, equation (CR4) [kg]; infinite where nothing can."""
    half = min(crane.tracks.gauge, crane.tracks.length) / 2
    boom, weight = crane.boom, crane.counterweight
    ahead = boom.heel_pins.ahead
    reach, over = _pin(crane, chart)
    if not half < radius <= ahead + reach:
        return math.inf
    head = boom.length * math.cos(math.acos(max(-1.0, (radius - ahead) / reach)) - over)
    lumps = (
        (crane.base_mass + crane.central_ballast, 0.0),
        (weight.mass, -weight.behind),
        (boom.mass, ahead + boom.centre_of_gravity * head),
        (boom.head_gear, ahead + head),
    )
    return max(0.0, math.fsum(mass * (half - at) for mass, at in lumps) / (radius - half))


def _light_hook_blocks(scenario: Scenario) -> Iterator[Doubt]:
    """Each hook block that weighs next to nothing of what it may carry."""
    for name, hook in scenario.hooks.items():
        gear, rated = hook.hook_block, hook.rated_capacity
        if gear is not None and rated is not None and gear.mass < _LIGHTEST * rated:
            weight, carried = format_by_size(gear.mass, "mass", 4), format_quantity(rated, "t", 1)
            carries = f"weighs {weight} and may carry {carried}"
            sentence = f"the hook block of {name} {carries}; a unit has slipped, kg for t"
            yield Doubt(hook.paths["hook_block"], sentence)


def _strong_hoists(scenario: Scenario) -> Iterator[Doubt]:
    """Each hoist whose motor or brake pulls as if it were at the hook, not at each rope."""
    gravity = scenario.simulation.gravity
    for name, hook in scenario.hooks.items():
        if hook.reeving is None or hook.hoist.capacity is None:
            continue
        rope, path = (scenario.ropes or {})[hook.reeving.rope], (*hook.paths[""], "hoist")
        parts = hook.reeving.ropes * hook.reeving.parts_each
        pulls: dict[float, list[str]] = {hook.hoist.capacity: ["motor"]}
        if hook.hoist.brake is not None:
            pulls.setdefault(hook.hoist.brake, []).append("brake")
        for pull, of in pulls.items():
            who = f"the {of[0]} of {name} pulls" if len(of) == 1 else f"{' and '.join(of)} of {name} pull"
            said = f"{who} {format_by_size(pull, 'force')} at each rope"
            held = parts * pull / gravity
            if hook.rated_capacity is not None and held > _STRONGEST * hook.rated_capacity:
                would = f"{parts} parts of line would hold {format_by_size(held, 'mass')}"
                rated = f"the rated capacity is {format_by_size(hook.rated_capacity, 'mass')}"
                sentence = f"{said}: {would}, and {rated}; it may be the pull at the hook"
                yield Doubt(path, sentence)
            elif rope.breaking_force is not None and pull > rope.breaking_force:
                breaks = f"which breaks at {format_by_size(rope.breaking_force, 'force')}"
                yield Doubt(path, f"{said}, {breaks}; it may be the pull at the hook")


def _light_parts(scenario: Scenario) -> Iterator[Doubt]:
    """Each part of a crane that weighs next to nothing of what the crane may carry.

    Most cranes with a boom have a chart and no rated capacity: the most of the chart counts then.
    """
    for name, crane in (scenario.cranes or {}).items():
        parts: dict[str, tuple[Path, float, float | None]] = {}
        if isinstance(crane, Goliath):
            rated = crane.rated_capacity
            parts["the girder"] = ("girder",), crane.girder.mass, rated
            if crane.legs is not None:
                parts["the fixed leg"] = ("legs", "fixed"), crane.legs.fixed, rated
                parts["the hinged leg"] = ("legs", "hinged"), crane.legs.hinged, rated
            if crane.end_carriages is not None:
                parts["the end carriages"] = ("end_carriages", "mass"), crane.end_carriages.mass, rated
            parts |= {
                f"trolley {one}": (("trolleys", one), trolley.mass, trolley.rated_capacity or rated)
                for one, trolley in crane.trolleys.items()
            }
        elif isinstance(crane, Crawler | FloatingCrane):
            rows = [rated for one in boom_charts(scenario) if one.crane == name for rated in one.rating.rated]
            parts["the boom"] = ("boom",), crane.boom.mass, crane.rated_capacity or max(rows, default=None)
        for part, (path, mass, rated) in parts.items():
            if rated is not None and mass < _LIGHTEST_PART * rated:
                carries = f"weighs {mass:,.6g} kg, and the rated capacity is {format_quantity(rated, 't', 1)}"
                sentence = f"{part} of {name} {carries}; a unit has slipped, kg for t"
                yield Doubt(("cranes", name, *path), sentence)


def _soft_girders(scenario: Scenario) -> Iterator[Doubt]:
    for name, crane in (scenario.cranes or {}).items():
        if not isinstance(crane, Goliath) or crane.girder.vertical_stiffness is None:
            continue
        if crane.rated_capacity is not None:
            sag = crane.rated_capacity * scenario.simulation.gravity / crane.girder.vertical_stiffness
            if sag > _SOFTEST * crane.span:
                bends = f"would bend by {format_quantity(sag, 'm', 2)} under the rated capacity"
                slipped = "a unit of its stiffness has slipped, kN/m for MN/m"
                path = ("cranes", name, "girder", "vertical_stiffness")
                yield Doubt(path, f"the girder of {name} {bends}; {slipped}")


def _bases(scenario: Scenario) -> Iterator[Doubt]:
    """Each Goliath or overhead crane that stands as none of its span does: corner loads go with that."""
    for name, crane in (scenario.cranes or {}).items():
        if not isinstance(crane, Goliath) or (base := crane.standing.base) is None:
            continue
        least, most = (share * crane.span for share in _BASES)
        if not least <= base <= most:
            key = "end_carriages" if crane.legs is None else "legs"
            what = key.replace("_", " ")
            stands = f"the {what} of {name} stand on a base of {base:g} m at a span of {crane.span:g} m"
            usual = f"{format_quantity(crane.span / 8, 'm', 0)} to {format_quantity(crane.span / 3, 'm', 0)}"
            sentence = f"{stands}, where {usual} is usual; a digit has slipped"
            yield Doubt(("cranes", name, key, "base"), sentence)


def _sheaves_off_girders(scenario: Scenario) -> Iterator[Doubt]:
    """Each Goliath or overhead crane whose falls would begin in the air, far above or below its girder."""
    told = set()
    for name, hook in scenario.hooks.items():
        crane = (scenario.cranes or {}).get(hook.crane)
        at = None if hook.reeving is None else hook.reeving.upper_sheaves_at
        if not isinstance(crane, Goliath) or at is None or hook.crane in told:
            continue
        underside = crane.rail_level + crane.girder.underside
        above, below = (share * crane.span + _SHEAVES_BESIDE for share in (_SHEAVES_ABOVE, _SHEAVES_BELOW))
        if not -below <= at - underside <= above:
            told.add(hook.crane)
            girder = f"the girder of {hook.crane} has its underside at {format_quantity(underside, 'm', 1)}"
            where = f"the upper sheaves of {name} are at {format_quantity(at, 'm', 1)}, both in the world"
            right = "'rail_level' is the height of the rails, 'underside' of the girder its own above these"
            yield Doubt(("cranes", hook.crane), f"{girder}, and {where}; {right}")


def _short_filters(scenario: Scenario) -> Iterator[Doubt]:
    """Each heave compensation whose filter takes waves for what is slow.

    Of heave at the frequency w a filter of the time tau leaves 1/sqrt(1 + (w tau)^2), (HC1) of
    docs/concepts/heave_compensation.md.
    """
    for name, hook in scenario.hooks.items():
        compensation = hook.hoist.heave_compensation
        if compensation is None:
            continue
        left, usual = (
            1.0 / math.hypot(1.0, 2.0 * math.pi / _SWELL * time) for time in (compensation.filter, FILTER)
        )
        if left > _LEFT:
            leaves = f"{format_quantity(left, '%', 0)} of the heave of waves of {_SWELL:g} s"
            sentence = (
                f"the filter of {compensation.filter:g} s of {name} leaves {leaves}: it takes waves for what "
                f"is slow; {FILTER:g} s leave {format_quantity(usual, '%', 0)}"
            )
            yield Doubt((*hook.paths[""], "hoist", "heave_compensation", "filter"), sentence)


def _thin_booms(scenario: Scenario) -> Iterator[Doubt]:
    for name, crane in (scenario.cranes or {}).items():
        if not isinstance(crane, Crawler | FloatingCrane) or crane.boom.inertia is None:
            continue
        radius = math.sqrt(crane.boom.inertia / crane.boom.mass)
        if not _RADII[0] < radius / crane.boom.length < _RADII[1]:
            figures = f"has a radius of gyration of {radius:.3g} m and a length of {crane.boom.length:g} m"
            sentence = f"the boom of {name} {figures}; a unit of its inertia or mass has slipped"
            yield Doubt(("cranes", name, "boom"), sentence)
