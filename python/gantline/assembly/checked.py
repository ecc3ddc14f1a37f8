"""What checks need to know of a lift beside who carries whom: limits, rules, rated capacities, bends."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

from gantline.assembly.cranes.lifting import lifting_cranes
from gantline.assembly.cranes.reeving import reeved_hooks
from gantline.assembly.parts import Json, Parts
from gantline.rule_data import (
    FACTORS,
    LIFT_FILE,
    PRESETS,
    SIDE_LOAD,
    SIDE_LOAD_SOURCE,
    Preset,
    Sourced,
    dynamic_factor,
    several_cranes,
)
from gantline.scenario import Rigging, Scenario
from gantline.scenario.cranes.charts import boom_charts
from gantline.scenario.cranes.crane import FixedHook
from gantline.scenario.cranes.goliath import Goliath
from gantline.scenario.cranes.hooks import Hook, trolley_name
from gantline.scenario.cranes.rating import Rating
from gantline.scenario.cranes.reeving import hoist_drum
from gantline.scenario.levels import HookLevels, levelled_hooks
from gantline.scenario.limits import Rules

__all__ = ["bends", "limits_and_rules", "rating_charts", "ratings"]

#: Largest fleet angle where the lift file names none [rad]: 4 deg (1 : 15), by the notes on section 20 of
#: DGUV Vorschrift 54; `docs/concepts/sheave.md` has more rules.
FLEET_ANGLE = math.radians(4.0)
_FLEET_ANGLE_SOURCE = "DGUV Vorschrift 54, notes on section 20"


def limits_and_rules(scenario: Scenario, rigging: Rigging, led: Mapping[str, bool]) -> Json:
    """Limits and factors of the lift file, then of its preset, each with its source.

    Args:
        scenario: the lift.
        rigging: what hangs from which hook.
        led: limits of fleet angles, and whether there is something that they are of.
    """
    rules = scenario.rules or Rules()
    preset = PRESETS[rules.preset] if rules.preset is not None else Preset("")
    given = {}
    if scenario.limits is not None:  # the bound of equalising is no limit, but what a result is counted by
        given = scenario.limits.model_dump(exclude_none=True, exclude={"equalised_below"})
        if isinstance(level := scenario.limits.hook_level_difference, HookLevels):
            given["hook_level_difference"] = level.largest
    own = str(given.get("rule", LIFT_FILE))
    sources = {key: own for key in given if key != "rule"}
    of_preset = {key: one for key, one in preset.limits.items() if key not in given}
    assumed = {}
    for key in (key for key, is_there in led.items() if is_there and key not in {*given, *of_preset}):
        assumed[key] = FLEET_ANGLE
        sources[key] = _FLEET_ANGLE_SOURCE
    sources |= {key: one.source for key, one in of_preset.items()}
    named = {"rule": preset.title} if preset.title and "rule" not in given else {}
    return {
        "limits": {**named, **given, **{key: one.value for key, one in of_preset.items()}, **assumed},
        "assumed_limits": list(assumed),
        "limit_sources": sources,
        **({"level_hooks": hooks} if (hooks := levelled_hooks(scenario)) else {}),
        "factors": _factors(scenario, rigging, rules, preset, own),
        "shackle_side_load": _side_load(rules, own),
    }


def _factors(scenario: Scenario, rigging: Rigging, rules: Rules, preset: Preset, own: str) -> Json:
    of_several = None
    if rules.several_cranes is not None:
        of_several = several_cranes(rules.several_cranes, len(lifting_cranes(scenario, rigging)))
    mass = scenario.load.weight.design if scenario.load is not None else None
    of_preset: dict[str, Sourced | None] = {
        **preset.factors,
        "dynamic_amplification_factor": dynamic_factor(preset, mass),
        "several_cranes_factor": of_several,
    }
    found = {}
    for key in FACTORS:
        said = getattr(rules, key)
        one = Sourced(said, own) if said is not None else of_preset.get(key)
        if one is not None:
            found[key] = {"value": one.value, "source": one.source}
    return found


def _side_load(rules: Rules, own: str) -> Json:
    if rules.shackle_side_load is not None:
        return {"rows": [[row.up_to, row.remains] for row in rules.shackle_side_load], "source": own}
    return {"rows": [list(row) for row in SIDE_LOAD], "source": SIDE_LOAD_SOURCE}


def ratings(scenario: Scenario) -> list[Json]:
    """Rated capacities of hooks, trolleys and cranes [N]; None where a hook has none."""
    gravity = scenario.simulation.gravity
    found: list[Json] = []
    hooks = scenario.hooks
    for name, hook in hooks.items():
        found.append(_rating(name, "hook", (name,), hook, gravity))
    for name, crane in (scenario.cranes or {}).items():
        if isinstance(crane, FixedHook):
            continue
        for trolley, given in crane.trolleys.items() if isinstance(crane, Goliath) else ():
            full = trolley_name(name, trolley)
            own = tuple(hook.name for hook in hooks.values() if hook.carrier and hook.carrier.name == full)
            if given.rated_capacity is not None:
                found.append(_shared(full, "trolley", own, given.rated_capacity * gravity, crane))
        own = tuple(hook.name for hook in hooks.values() if hook.crane == name)
        if crane.rated_capacity is not None:
            found.append(_shared(name, "crane", own, crane.rated_capacity * gravity, crane))
    for name, group in (scenario.hook_groups or {}).items():
        found.append(_rating(name, group.type, group.hooks, group, gravity))
    return found


def rating_charts(scenario: Scenario) -> list[Json]:
    """Rating charts of cranes [SI]; shares of hooks as said, or as their rated capacities have them."""
    gravity = scenario.simulation.gravity
    found = []
    for name, crane in (scenario.cranes or {}).items():
        charts = [one for one in boom_charts(scenario) if one.crane == name]
        if not charts or isinstance(crane, FixedHook | Goliath):
            continue
        hooks = [hook for hook in scenario.hooks.values() if hook.crane == name]
        own = {one.hook: one.rating for one in charts if one.hook is not None}
        shared = [hook for hook in hooks if hook.name not in own]
        common = {"crane": name, "includes_hook_block": crane.rating_includes_hook_block}
        chart = next((one.rating for one in charts if one.hook is None), None)
        found.append(
            {
                **common,
                **({} if chart is None else _rows(chart, chart, gravity)),
                "hooks": [hook.name for hook in hooks],
                **_apart(shared),
                "hook_shares": dict.fromkeys(own, 1.0)
                | _shares(crane.rated_capacity, chart, shared, bool(own)),
                "hooks_share": None if chart is None else chart.hooks_share,
                **(
                    {
                        "own": {
                            hook: {**common, "hooks": [hook], **_rows(rating, chart, gravity)}
                            for hook, rating in own.items()
                        }
                    }
                    if own
                    else {}
                ),
            }
        )
    return found


def _rows(chart: Rating, of_crane: Rating | None, gravity: float) -> Json:
    """Rows of a chart and what they hold for; what that of a hook does not say is as in that of its crane."""

    def said(key: str) -> Any:
        own = getattr(chart, key)
        return own if own is not None or of_crane is None else getattr(of_crane, key)

    return {
        "over": chart.over,
        "at": [place for place, _ in chart.rows],
        "rated": [mass * gravity for _, mass in chart.rows],
        "between": said("between") or "lines",
        **{key: said(key) for key in ("heel", "trim", "off_lead", "side_lead", "significant_height")},
    }


def _shares(
    capacity: float | None, chart: Rating | None, hooks: Sequence[Hook], has_others: bool
) -> dict[str, float]:
    """What each of some hooks may carry of a row alone [1]; all of it the only one without its own chart."""
    if chart is None:
        return {}
    if chart.hooks_share is not None or (has_others and len(hooks) == 1):
        return {hook.name: chart.hooks_share or 1.0 for hook in hooks}
    whole = capacity or max(chart.rated)
    return {hook.name: min(1.0, (hook.rated_capacity or whole) / whole) for hook in hooks}


def _apart(hooks: Sequence[Hook]) -> Json:
    """Hooks by where on the boom they hang; nothing where all hang at one place."""
    places: dict[tuple[float, float], list[str]] = {}
    for hook in hooks:
        along, _, above = hook.pin
        places.setdefault((along, above), []).append(hook.name)
    return {"apart": list(places.values())} if len(places) > 1 else {}


def _rating(name: str, level: str, hooks: tuple[str, ...], rated: Any, gravity: float) -> Json:
    capacity = None if rated.rated_capacity is None else rated.rated_capacity * gravity
    return _shared(name, level, hooks, capacity, rated)


def _shared(name: str, level: str, hooks: tuple[str, ...], capacity: float | None, rated: Any) -> Json:
    return {
        "name": name,
        "level": level,
        "hooks": list(hooks),
        "rated_capacity": capacity,
        "includes_hook_block": rated.rating_includes_hook_block,
    }


def bends(scenario: Scenario, parts: Parts) -> list[Json]:
    """The smallest sheave or drum of every rope that runs over any; pitch diameters [m]."""
    mechanics = scenario.mechanics
    # Pitch diameters of drums by what their ropes get per unit of their flow.
    drums = {name: drum.diameter for name, drum in ((mechanics and mechanics.drums) or {}).items()}
    sheaves: dict[str, float] = {}
    for hook in reeved_hooks(scenario):
        drums[hoist_drum(hook.name)] = hook.drum.diameter / hook.reeving.parts_each
        diameter = hook.reeving.diameter((scenario.ropes or {})[hook.reeving.rope].diameter)
        sheaves |= dict.fromkeys(hook.ropes, diameter)
    for placed in scenario.booms.values():
        if placed.tackles is not None and placed.tackles.sheave_diameter is not None:
            sheaves |= dict.fromkeys(placed.ropes, placed.tackles.sheave_diameter)
    found = []
    for rope in parts.ropes:
        over = [
            bend
            for place, guide in enumerate(rope["route"])
            for bend in [_bend(f"{rope['name']}/sheave_{place}", guide, drums, sheaves.get(rope["name"]))]
            if bend is not None
        ]
        if over:
            diameter, element = min(over)
            found.append({"rope": rope["name"], "element": element, "diameter": diameter})
    return found


def _bend(
    sheave: str, guide: Json, drums: Mapping[str, float], diameter: float | None
) -> tuple[float, str] | None:
    """Pitch diameter [m] and name of what a guide bends the rope about; None of dead ends and plain eyes.

    `diameter` is that of half turns where they lead aside, from row to row of a hoist, and of the eyes that
    stand for the sheaves of luffing tackles.
    """
    if guide["type"] == "eye":
        return None if diameter is None else (diameter, sheave)
    if guide["type"] == "half_turn":
        return diameter or math.dist(guide["enter"], guide["leave"]), guide.get("flow", sheave)
    if guide["type"] == "sheave" and guide["radius"] > 0.0:
        return 2 * guide["radius"], sheave
    flow, rate = (guide["drum"]["flow"], guide["drum"]["rate"]) if "drum" in guide else ("", 0.0)
    return (abs(rate) * drums[flow], flow) if flow in drums else None
