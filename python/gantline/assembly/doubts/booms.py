"""Booms, their charts and what they hang in, of which a digit has slipped so that more seems allowed."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import pairwise

from gantline.assembly.doubts.cranes import rows_by_radius, tipping_mass
from gantline.assembly.doubts.strength import FARTHEST
from gantline.scenario import Scenario
from gantline.scenario.cranes.boom import FloatingCrane, PlacedBoom
from gantline.scenario.cranes.charts import Chart, boom_charts
from gantline.scenario.cranes.crawler import Crawler
from gantline.scenario.errors import Doubt
from gantline.scenario.findings import Path
from gantline.units import format_quantity

__all__ = ["doubtful_booms"]

#: Hooks hang some metres farther out than a level boom is long, at what reaches over its head [1].
_BEYOND = 1.1
#: Rows of charts by the angle of the boom are 2 to 10 deg apart; over more than this no line between two of
#: them, along which gantline goes, is near what the crane may carry [rad].
_WIDEST_STEP = math.radians(30.0)
#: A-frames, masts and gantries are half to one length of their boom away from its heel pins [1].
_FARTHEST_TOP = 2.0
#: Far out charts are for 75 % of what tips the crane (ASME B30.5, 5-1.1.1), close in for what its boom bears;
#: in the farthest row less than a third of that means that the crane is far too heavy for its chart [1].
_LEAST_OF_TIPPING = 0.25
#: Cranes give at the head by about a hundredth of the boom's length under what they may carry; aside they are
#: several times softer, and bear hundredths of that [1].
_SOFTEST = {"vertical": 0.03, "side": 0.3}
#: Booms have their centre of gravity at 35 % to 55 % of their length, heavy at foot or head [1].
_CENTRE = (0.2, 0.8)


def doubtful_booms(scenario: Scenario) -> Iterator[Doubt]:
    """Each chart with rows out of reach or far apart, each top far away, each crane too heavy."""
    for boom in scenario.booms.values():
        crane = (scenario.cranes or {})[boom.crane]
        charts = [one for one in boom_charts(scenario) if one.crane == boom.crane]
        for chart in charts:
            yield from _chart(boom, chart)
        if isinstance(crane, Crawler) and charts:
            # Without one of the crane that which rates most: auxiliary hooks are rated for what they bear.
            most = max(charts, key=lambda one: (one.hook is None, max(one.rating.rated)))
            yield from _heavy(crane, most) if most.rating.over != "outreach" else ()
        share = boom.boom.centre_of_gravity
        if not _CENTRE[0] <= share <= _CENTRE[1]:
            lies = f"the centre of gravity of {boom.name} is at {100.0 * share:.3g} % of its length"
            usual = "35 % to 55 % is usual, and a digit has slipped"
            yield Doubt((*boom.path, "boom", "centre_of_gravity"), f"{lies}; {usual}")
        yield from _soft(scenario, boom)
        if (gear := boom.gear) is not None and gear.reach > _FARTHEST_TOP * boom.boom.length:
            away = f"is {format_quantity(gear.reach, 'm', 1)} from its heel pins"
            long = f"its boom is {format_quantity(boom.boom.length, 'm', 1)} long"
            sentence = f"the top of the luffing tackles of {boom.crane} {away}, and {long}"
            path: Path = (*boom.path, "luffing", "tackles", "from")
            yield Doubt(path, f"{sentence}; they seem to pull with far less than they do")


def _soft(scenario: Scenario, boom: PlacedBoom) -> Iterator[Doubt]:
    """A crane that gives far more at its head than any does, under all that it may carry."""
    crane = (scenario.cranes or {})[boom.crane]
    assert isinstance(crane, Crawler | FloatingCrane)  # it has a boom
    rows = [most for one in boom_charts(scenario) if one.crane == boom.crane for most in one.rating.rated]
    rated = crane.rated_capacity or max(rows, default=0.0)
    given = boom.boom
    for key, stiffness in (("vertical", given.vertical_stiffness), ("side", given.side_stiffness)):
        sinks = 0.0 if stiffness is None else rated * scenario.simulation.gravity / stiffness
        if sinks > _SOFTEST[key] * given.length:
            moves = f"would give by {format_quantity(sinks, 'm', 2)} under the rated capacity"
            slipped = "a unit of its stiffness has slipped, kN/m for MN/m"
            path: Path = (*boom.path, "boom", f"{key}_stiffness")
            yield Doubt(path, f"the head of {boom.name} {moves}; {slipped}")


def _chart(boom: PlacedBoom, of: Chart) -> Iterator[Doubt]:
    """Rows out of reach, or far apart: what may hang before them is taken from a line to a wrong row."""
    chart, path = of.rating, of.path
    places = [place for place, _ in chart.rows]
    if chart.over == "angle":
        for low, high in pairwise(places):
            if high - low > _WIDEST_STEP * (1 + 1e-9):
                between = " and ".join(format_quantity(one, "deg", 1) for one in (low, high))
                sentence = f"the rating chart of {of.owner} has nothing between {between}"
                right = "what may hang there is taken from a line between both, and a digit may have slipped"
                yield Doubt((*path, "angle"), f"{sentence}; {right}")
        return
    # Of a hook on a jib (BM6) reaches farthest where its pin is level with the heel pins.
    jibs = [math.hypot(boom.boom.length + one.along, one.above) for one in of.hooks]
    farthest = boom.heel[0] - boom.reach_from[0] + max([boom.boom.length, *jibs])
    if _BEYOND * farthest < places[-1] <= FARTHEST:  # what no crane reaches is told as that
        row = f"has a row at {format_quantity(places[-1], 'm', 1)}"
        what = "boom" if max([0.0, *jibs]) <= boom.boom.length else "boom, jib included,"
        reach = f"its {what} reaches no farther than {format_quantity(farthest, 'm', 1)}"
        sentence = f"the rating chart of {of.owner} {row}, and {reach}"
        yield Doubt((*path, chart.over), f"{sentence}; a digit has slipped, or it is of another boom")


def _heavy(crane: Crawler, chart: Chart) -> Iterator[Doubt]:
    """A crane that what its chart allows does not come near to tipping."""
    rows = rows_by_radius(crane, chart)
    radius, rated = max(rows)
    if rated >= max(mass for _, mass in rows):
        return  # as much everywhere: what its hook or falls bear, and not what tips it
    used = rated / max(tipping_mass(crane, radius, chart), 1.0)
    if 0.0 < used < _LEAST_OF_TIPPING:
        row = f"{format_quantity(rated, 't', 1)} at {format_quantity(radius, 'm', 1)}"
        share = f"{100.0 * used:.3g} % of what tips the crane by its masses, where 75 % is usual"
        right = "a mass of the crane is too large, or the chart too small"
        yield Doubt(("cranes", chart.crane), f"the rating chart of {chart.owner} has {row}, {share}; {right}")
