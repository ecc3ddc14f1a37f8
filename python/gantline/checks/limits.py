"""The quantities that limits can be set for, in the order of the table of checks.

A quantity is one entry of `LIMITS`: how it is worded, and a function of its own that gives what its limit is
held against. Those that everybody has to hand in are listed without a limit too.
"""

from __future__ import annotations

from gantline.checks import contacts, cranes, equalizers, hooks, loads, lugs, ropes, shackles, slings
from gantline.checks.measure import Measure

_ALL = "by definition"

LIMITS: dict[str, Measure] = {
    "static_hook_load": Measure(
        "static hook load with the design weight", "kN", 1, hooks.static_hook_load, is_listed=True
    ),
    "dynamic_hook_load": Measure(
        "larger of static hook load x the rule's factor, and simulated peak",
        "kN",
        1,
        hooks.dynamic_hook_load,
        is_listed=True,
    ),
    "hook_dynamic_factor": Measure(
        "peak / static hook load of the same hook, simulated",
        "",
        3,
        hooks.hook_dynamic_factor,
        is_listed=True,
    ),
    "hoist_load_of_rated_capacity": Measure(
        "hoist load (hook load, if the rating leaves the hook block out) / rated capacity of hook, trolley, "
        "crane",
        "%",
        1,
        hooks.of_rated_capacity,
        by_definition=1.0,
        definition=_ALL,
        is_listed=True,
    ),
    "falls_out_of_plumb": Measure(
        "largest angle of the falls of a hook from plumb", "deg", 2, cranes.falls_out_of_plumb, is_listed=True
    ),
    "hook_height_margin": Measure(
        "highest position of a hook - its height",
        "m",
        2,
        cranes.height_margin,
        at_least=True,
        by_definition=0.0,
        definition=_ALL,
        is_listed=True,
    ),
    "hook_approach_margin": Measure(
        "distance of a hook from a rail - smallest distance of its crane",
        "m",
        2,
        cranes.approach_margin,
        at_least=True,
        by_definition=0.0,
        definition=_ALL,
        is_listed=True,
    ),
    "hook_distance_margin": Measure(
        "distance along the girder of hooks of two trolleys - smallest distance of their crane",
        "m",
        2,
        cranes.distance_margin,
        at_least=True,
        by_definition=0.0,
        definition=_ALL,
        is_listed=True,
    ),
    "corner_load": Measure(
        "largest load of a corner of a crane, by moments of weights and hoist loads",
        "kN",
        0,
        cranes.corner_load,
        is_listed=True,
    ),
    "wind_of_limit": Measure(
        "gusts of the lift / wind limit of the crane",
        "%",
        0,
        cranes.wind_of_limit,
        by_definition=1.0,
        definition=_ALL,
        is_listed=True,
    ),
    "equalizer_load_of_rated_capacity": Measure(
        "static vertical force of all slings of an equalizer / its rated capacity",
        "%",
        1,
        equalizers.load_of_rated_capacity,
        by_definition=1.0,
        definition=_ALL,
        is_listed=True,
    ),
    "equalizer_travel_used": Measure(
        "largest travel of a moving sheave / its stroke that way, once the load is clear",
        "%",
        1,
        equalizers.travel_used,
        warns_up_to=1.0,
        by_definition=1.0,
        definition=_ALL,
        is_listed=True,
    ),
    "equalizer_travel_at_any_time": Measure(
        "largest travel of a moving sheave / its stroke that way, supported or clear",
        "%",
        1,
        equalizers.travel_at_any_time,
    ),
    "tension_spread_when_clear": Measure(
        "(max - min)/mean over one equalizer's slings while the load is clear",
        "%",
        2,
        equalizers.tension_spread,
        when_clear=True,
    ),
    "skew_load_factor": Measure(
        "static force of a sling / its force with perfect lengths",
        "",
        3,
        slings.skew_load_factor,
        is_listed=True,
    ),
    "sling_dynamic_factor": Measure(
        "peak / static tension of the same sling, simulated",
        "",
        3,
        slings.sling_dynamic_factor,
        is_listed=True,
    ),
    "sling_angle_from_vertical": Measure(
        "largest angle of a carrying sling from the vertical",
        "deg",
        1,
        slings.angle_from_vertical,
        is_listed=True,
    ),
    "sling_angle_from_horizontal": Measure(
        "least angle of a carrying sling from the horizontal",
        "deg",
        1,
        slings.angle_from_horizontal,
        at_least=True,
        is_listed=True,
    ),
    "smallest_sling_tension_when_clear": Measure(
        "smallest sling tension while the load is clear",
        "kN",
        1,
        slings.smallest_tension,
        at_least=True,
        when_clear=True,
    ),
    "sling_bending_ratio": Measure(
        "diameter of a shackle's bow / diameter of the sling that bends about it (D/d)",
        "",
        2,
        slings.sling_bending_ratio,
        at_least=True,
        is_listed=True,
    ),
    "sling_factor_on_breaking_force": Measure(
        "minimum breaking force / peak tension of the same sling",
        "",
        2,
        ropes.sling_factor,
        at_least=True,
    ),
    "rope_factor_on_breaking_force": Measure(
        "minimum breaking force / peak tension of the same rope, slings and all other ropes",
        "",
        2,
        ropes.rope_factor,
        at_least=True,
    ),
    "rope_load_of_breaking_force": Measure(
        "rope force x load, consequence, material, wear, and termination or bending factor / minimum "
        "breaking force",
        "%",
        1,
        ropes.load_of_breaking_force,
        by_definition=1.0,
        definition=_ALL,
        is_listed=True,
    ),
    "sheave_bending_ratio": Measure(
        "diameter of the smallest sheave or drum / diameter of the rope that bends about it (D/d)",
        "",
        2,
        ropes.sheave_bending_ratio,
        at_least=True,
        is_listed=True,
    ),
    "fleet_angle": Measure(
        "largest angle of a carrying rope to the plane of a sheave",
        "deg",
        2,
        ropes.fleet_angle,
        is_listed=True,
    ),
    "shackle_load_of_working_load_limit": Measure(
        "static load of a shackle / its working load limit, reduced for side load",
        "%",
        1,
        shackles.static_load,
        by_definition=1.0,
        definition="0027/ND rev 11, 8.2.4",
        is_listed=True,
    ),
    "shackle_dynamic_load_of_strength": Measure(
        "dynamic load of a shackle / least of working load limit x the rule's factor, minimum breaking force "
        "/ its factor, proof load",
        "%",
        1,
        shackles.dynamic_load,
        by_definition=1.0,
        definition="0027/ND rev 11, 8.2.6",
        is_listed=True,
    ),
    "lug_load_of_capacity": Measure(
        "load of a lug / its capacity",
        "%",
        1,
        lugs.load_of_capacity,
        by_definition=1.0,
        definition=_ALL,
        is_listed=True,
    ),
    "lug_out_of_plane_angle": Measure(
        "largest angle between a carrying sling and the main plate of its lug",
        "deg",
        1,
        lugs.out_of_plane_angle,
        is_listed=True,
    ),
    "support_force_of_capacity": Measure(
        "largest force of a support / its capacity",
        "%",
        1,
        contacts.of_capacity,
        by_definition=1.0,
        definition=_ALL,
        is_listed=True,
    ),
    "clearance_margin": Measure(
        "smallest distance of a watched pair - the distance that it has to keep",
        "m",
        2,
        contacts.clearance_margin,
        at_least=True,
        by_definition=0.0,
        definition="'watch' of the lift file",
        is_listed=True,
    ),
    "load_tilt": Measure(
        "largest angle of the load's own z axis from plumb", "deg", 2, loads.tilt, is_listed=True
    ),
    "tension_spread": Measure(
        "(max - min)/mean over one equalizer's slings", "%", 2, equalizers.tension_spread
    ),
    "load_transferred": Measure("1 - support forces / weight of the load", "%", 1, loads.transferred),
    "hook_load": Measure("largest hook load, simulated", "kN", 1, hooks.hook_load),
    "sling_tension": Measure("largest sling tension, simulated", "kN", 1, slings.sling_tension),
}
