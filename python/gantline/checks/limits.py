"""The quantities that limits can be set for, in the order of the table of checks.

A quantity is one entry of `LIMITS`: how it is worded, and a function of its own that gives what its limit is
held against. Those that everybody has to hand in are listed without a limit too.
"""

from __future__ import annotations

from gantline.checks import (
    booms,
    chain_hoists,
    compensators,
    contacts,
    cranes,
    crawlers,
    drums,
    equalizers,
    guides,
    hinges,
    hooks,
    loads,
    lugs,
    moorings,
    ratings,
    ropes,
    shackles,
    slings,
    spreaders,
    vessels,
)
from gantline.checks.alarms import (
    FALLS,
    FALLS_TWIST,
    HEEL,
    HOOK_DYNAMICS,
    LUG_PLATE,
    ROD_ON_STOP,
    ROPE_FACTOR,
    SHEAVE_BENDING,
    SIDE_LEAD,
    SLACK_IN_WATER,
    SLING_ANGLE,
    SLING_BENDING,
    SPREADER_TILT,
    TILT,
    TIPPING,
    TRIM,
    YAW,
)
from gantline.checks.measure import Alarm, Findings, Measure

_ALL = "by definition"


def _utilisation(
    meaning: str,
    findings: Findings,
    *,
    digits: int = 1,
    definition: str = _ALL,
    warns_up_to: float | None = None,
    alarm: Alarm | None = None,
) -> Measure:
    """What is used of what there is: all of it at most, whether or not a limit is set."""
    return Measure(
        meaning,
        "%",
        digits,
        findings,
        by_definition=1.0,
        definition=definition,
        is_listed=True,
        warns_up_to=warns_up_to,
        alarm=alarm,
    )


def _margin(meaning: str, unit: str, digits: int, findings: Findings, *, definition: str = _ALL) -> Measure:
    """What is left before something ends or meets: no less than nothing, whether or not a limit is set."""
    return Measure(
        meaning,
        unit,
        digits,
        findings,
        at_least=True,
        by_definition=0.0,
        definition=definition,
        is_listed=True,
    )


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
        alarm=HOOK_DYNAMICS,
    ),
    "hoist_load_of_rated_capacity": _utilisation(
        "hoist load (hook load, if the rating leaves the hook block out) / rated capacity of hook, trolley, "
        "crane",
        hooks.of_rated_capacity,
    ),
    "falls_out_of_plumb": Measure(
        "largest angle of the falls of a hook from plumb",
        "deg",
        2,
        cranes.falls_out_of_plumb,
        is_listed=True,
        alarm=FALLS,
    ),
    "off_lead": Measure(
        "largest angle of the falls of a hook from plumb in the plane of its boom",
        "deg",
        2,
        booms.off_lead,
        is_listed=True,
    ),
    "side_lead": Measure(
        "largest angle of the falls of a hook from plumb across its boom",
        "deg",
        2,
        booms.side_lead,
        is_listed=True,
        alarm=SIDE_LEAD,
    ),
    "boom_angle_margin": _margin(
        "distance of the angle of a boom from the nearer end of its range", "deg", 1, booms.angle_margin
    ),
    "hook_height_margin": _margin("highest position of a hook - its height", "m", 2, cranes.height_margin),
    "hook_falls_margin": _margin(
        "shortest part of the falls of a hook block - diameter of its sheaves, which meet those above at 0",
        "m",
        2,
        hooks.falls_margin,
    ),
    "rope_torque_of_falls": _utilisation(
        "torque of the hoist ropes about a hook block / largest torque that its falls give back",
        hooks.rope_torque_of_falls,
        digits=0,
        definition="from there on the falls twist round each other",
        alarm=FALLS_TWIST,
    ),
    "hook_approach_margin": _margin(
        "distance of a hook from a rail - smallest distance of its crane", "m", 2, cranes.approach_margin
    ),
    "hook_distance_margin": _margin(
        "distance along the girder of hooks of two trolleys - smallest distance of their crane",
        "m",
        2,
        cranes.distance_margin,
    ),
    "hook_level_difference": Measure(
        "how far of two hooks that bear the load one goes up more than the other once it is clear",
        "mm",
        0,
        hooks.level_difference,
    ),
    "hoist_load_of_drive_capacity": _utilisation(
        "static hoist load with the design weight / what motor and brake of the drum hold where sheaves lose "
        "nothing",
        hooks.of_drive_capacity,
        definition="more slips; how much less is safe, a rule says",
    ),
    "hoist_load_of_rating": _utilisation(
        "hoist load (hook load, if the rating leaves the hook block out) x factor of several cranes / rated "
        "load of the chart where the hook is, of crane and hook",
        ratings.load_of_rating,
    ),
    "attitude_of_rating": _utilisation(
        "heel, trim, off-lead, side-lead and waves under load / largest for which the rating chart holds",
        ratings.beyond_rating,
        definition="'rating' of the crane or hook",
    ),
    "moment_of_tipping_moment": _utilisation(
        "moment of what hangs / moment of the crane's own weight, about its worst tipping line",
        crawlers.tipping,
        alarm=TIPPING,
    ),
    "ground_pressure_of_allowed": _utilisation(
        "largest pressure on the ground under tracks, outriggers or their mats / what the ground bears",
        crawlers.ground_pressure,
    ),
    "corner_load": Measure(
        "largest load of a corner of a crane, by moments of weights and falls",
        "kN",
        0,
        cranes.corner_load,
        is_listed=True,
    ),
    "wind_of_limit": _utilisation(
        "gusts of the lift / wind limit of the crane", cranes.wind_of_limit, digits=0
    ),
    "equalizer_load_of_rated_capacity": _utilisation(
        "static vertical force of all slings of an equalizer / its rated capacity",
        equalizers.load_of_rated_capacity,
    ),
    "chain_hoist_load_of_rated_capacity": _utilisation(
        "largest force of a sling / rated capacity of the chain hoist in it",
        chain_hoists.load_of_rated_capacity,
    ),
    "drum_load_of_rated_capacity": _utilisation(
        "largest force of a rope on a drum / rated capacity of the winch or strand jack that it stands for",
        drums.load_of_rated_capacity,
    ),
    "spreader_load_of_rated_capacity": _utilisation(
        "static vertical force of all slings under a spreader / its rated capacity",
        spreaders.load_of_rated_capacity,
    ),
    "spreader_thrust": Measure(
        "largest force that pushes a spreader together along its length or breadth: static with the design "
        "weight x the rule's factor, or peak",
        "kN",
        1,
        spreaders.largest_thrust,
        is_listed=True,
    ),
    "spreader_tilt": Measure(
        "largest angle of a spreader's own z axis from plumb while slings below it carry",
        "deg",
        2,
        spreaders.tilt_under_load,
        is_listed=True,
        alarm=SPREADER_TILT,
    ),
    "compensator_load_of_rated_capacity": _utilisation(
        "static vertical force of all slings under a compensator / its rated capacity",
        compensators.load_of_rated_capacity,
    ),
    "compensator_peak_of_rated_capacity": Measure(
        "largest vertical force of all slings under a compensator, static with the design weight x the "
        "rule's factor, or peak / its rated capacity",
        "%",
        1,
        compensators.peak_of_rated_capacity,
        is_listed=True,
    ),
    "compensator_stroke_margin": Measure(
        "least way of the rod of a compensator from either stop / its stroke, once the load is clear",
        "%",
        1,
        compensators.stroke_margin,
        at_least=True,
        is_listed=True,
        alarm=ROD_ON_STOP,
    ),
    "equalizer_travel_used": _utilisation(
        "largest travel of a moving sheave / its stroke that way, once the load is clear",
        equalizers.travel_used,
        warns_up_to=1.0,
    ),
    "equalizer_travel_at_any_time": Measure(
        "largest travel of a moving sheave / its stroke that way, supported or clear",
        "%",
        1,
        equalizers.travel_at_any_time,
    ),
    "pin_force_of_capacity": _utilisation(
        "largest force on a locking pin / its capacity", equalizers.pin_of_capacity
    ),
    "hinge_force_of_rated_capacity": _utilisation(
        "largest force between load and hinge / rated capacity of the hinge", hinges.of_rated_capacity
    ),
    "tension_spread_when_clear": Measure(
        "(max - min)/mean over one equalizer's slings while the load is clear",
        "%",
        2,
        equalizers.tension_spread,
        when_clear=True,
    ),
    "equalizer_tilt": Measure(
        "largest angle from plumb of a frame that tilts", "deg", 2, equalizers.frame_tilt, is_listed=True
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
        alarm=SLING_ANGLE,
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
        alarm=SLACK_IN_WATER,
    ),
    "sling_bending_ratio": Measure(
        "diameter of a shackle's bow, or of what else the eye lies on / diameter of the sling (D/d)",
        "",
        2,
        slings.sling_bending_ratio,
        at_least=True,
        is_listed=True,
        alarm=SLING_BENDING,
    ),
    "sling_factor_on_breaking_force": Measure(
        "minimum breaking force / peak, or static force with the design weight, of a sling at its upper end",
        "",
        2,
        ropes.sling_factor,
        at_least=True,
    ),
    "rope_factor_on_breaking_force": Measure(
        "minimum breaking force / peak, or static force with the design weight, of a rope at its upper end",
        "",
        2,
        ropes.rope_factor,
        at_least=True,
        by_definition=1.0,
        definition="more breaks it; how much less is safe, a rule says",
        is_listed=True,
        alarm=ROPE_FACTOR,
    ),
    "rope_load_of_breaking_force": _utilisation(
        "rope force x load, consequence, material, wear, and termination or bending factor / minimum "
        "breaking force",
        ropes.load_of_breaking_force,
    ),
    "sheave_bending_ratio": Measure(
        "diameter of the smallest sheave or drum / diameter of the rope that bends about it (D/d)",
        "",
        2,
        ropes.sheave_bending_ratio,
        at_least=True,
        is_listed=True,
        alarm=SHEAVE_BENDING,
    ),
    "fleet_angle": Measure(
        "largest angle of a carrying rope to the plane of a sheave",
        "deg",
        2,
        ropes.fleet_angle,
        is_listed=True,
    ),
    "drum_fleet_angle": Measure(
        "largest angle of a rope to the plane of the groove of its drum",
        "deg",
        2,
        drums.fleet_angle,
        is_listed=True,
    ),
    "shackle_load_of_working_load_limit": _utilisation(
        "static load of a shackle / its working load limit, reduced for side load",
        shackles.static_load,
        definition="0027/ND rev 11, 8.2.4",
    ),
    "shackle_dynamic_load_of_strength": _utilisation(
        "dynamic load of a shackle / least of working load limit x the rule's factor, minimum breaking force "
        "/ its factor, proof load",
        shackles.dynamic_load,
        definition="0027/ND rev 11, 8.2.6",
    ),
    "lug_load_of_capacity": _utilisation("load of a lug / its capacity", lugs.load_of_capacity),
    "lug_out_of_plane_angle": Measure(
        "largest angle between a carrying sling and the main plate of its lug",
        "deg",
        1,
        lugs.out_of_plane_angle,
        is_listed=True,
        alarm=LUG_PLATE,
    ),
    "support_force_of_capacity": _utilisation(
        "largest force of a support, with the design weight / its capacity", contacts.of_capacity
    ),
    "clearance_margin": _margin(
        "smallest distance of a watched pair - the distance that it has to keep",
        "m",
        2,
        contacts.clearance_margin,
        definition="'watch' of the lift file",
    ),
    "mooring_tension_of_breaking_force": _utilisation(
        "largest tension of a mooring line / minimum breaking force of its rope",
        moorings.tension_of_breaking_force,
    ),
    "fender_force_of_capacity": _utilisation(
        "largest force of a fender / its capacity", moorings.fender_of_capacity
    ),
    "guide_force_of_capacity": _utilisation(
        "largest force of a landing guide, raised to the design weight / its capacity", guides.of_capacity
    ),
    "heel": Measure(
        "largest heel of a vessel to either side", "deg", 2, vessels.heel, is_listed=True, alarm=HEEL
    ),
    "trim": Measure(
        "largest trim of a vessel by bow or stern", "deg", 2, vessels.trim, is_listed=True, alarm=TRIM
    ),
    "freeboard": _margin(
        "least height of deck edge and openings of a vessel above the water",
        "m",
        2,
        vessels.freeboard,
        definition="nothing may go under",
    ),
    "metacentric_height": Measure(
        "least GM of a vessel for heel, where a run begins at rest and ends, steps end, and as tanks fill",
        "m",
        2,
        vessels.metacentric_height,
        at_least=True,
    ),
    "load_tilt": Measure(
        "largest angle of the load's own z axis from plumb", "deg", 2, loads.tilt, is_listed=True, alarm=TILT
    ),
    "load_yaw": Measure(
        "largest change of the load's heading from the start", "deg", 1, loads.yaw, alarm=YAW
    ),
    "tension_spread": Measure(
        "(max - min)/mean over one equalizer's slings", "%", 2, equalizers.tension_spread
    ),
    "load_transferred": Measure("1 - support forces / weight of the load", "%", 1, loads.transferred),
    "hook_load": Measure("largest hook load, simulated", "kN", 1, hooks.hook_load),
    "sling_tension": Measure("largest sling tension, simulated", "kN", 1, slings.sling_tension),
}
