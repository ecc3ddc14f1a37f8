"""Limits that a lift is checked against, and the rules by which loads and strengths are reckoned for that."""

from __future__ import annotations

from itertools import pairwise
from typing import Annotated, ClassVar

from pydantic import Field, model_validator

from gantline.rule_data import PRESETS, SEVERAL_CRANES
from gantline.scenario.base import Element
from gantline.scenario.levels import LevelLimit
from gantline.scenario.quantities import (
    NotNegativeAngle,
    NotNegativeLength,
    Number,
    PositiveAngle,
    PositiveForce,
    PositiveLength,
    Quantity,
    Share,
    Text,
    Word,
    refuse,
)

__all__ = ["Limits", "Rules", "SideLoad"]

_Share = Annotated[float, Share()]
_Factor = Annotated[float, Number(least=1.0, most=100.0)]


class Limits(Element):
    """Limits that the lift is checked against."""

    what: ClassVar[str] = "limits"

    rule: Text | None = Field(None, description="Rule and edition that the limits come from.")
    support_force_of_capacity: _Share | None = Field(
        None, description="Force of a support of its capacity; 100 % if not given."
    )
    load_tilt: PositiveAngle | None = Field(None, description="Tilt of the load.")
    load_yaw: PositiveAngle | None = Field(
        None, description="Change of the load's heading from the start, to either side."
    )
    spreader_tilt: PositiveAngle | None = Field(
        None, description="Angle of a spreader's own z axis from plumb, while slings below it carry."
    )
    equalizer_tilt: PositiveAngle | None = Field(
        None, description="Angle from plumb of an equalizer's frame, of one that tilts."
    )
    sling_angle_from_vertical: PositiveAngle | None = Field(
        None, description="Angle of slings from the vertical."
    )
    sling_angle_from_horizontal: PositiveAngle | None = Field(
        None, description="Least angle of slings from the horizontal."
    )
    lug_out_of_plane_angle: PositiveAngle | None = Field(
        None, description="Angle of slings to the lug's plate."
    )
    fleet_angle: PositiveAngle | None = Field(
        None,
        description="Angle of a carrying rope to the plane of a sheave with true tangents; if not given, "
        "more than 4 deg is a warning.",
    )
    drum_fleet_angle: PositiveAngle | None = Field(
        None,
        description="Angle of a rope to the plane of the groove of a drum with a 'first_sheave'; if not "
        "given, more than 4 deg is a warning.",
    )
    sling_factor_on_breaking_force: _Factor | None = Field(
        None,
        description="Least factor of minimum breaking force over peak tension, or static tension with the "
        "design weight, of every sling.",
    )
    rope_factor_on_breaking_force: _Factor | None = Field(
        None,
        description="Least factor of minimum breaking force over the same tension, of every rope: slings, "
        "equalizing ropes, hoist ropes, ropes of 'mechanics'; 1 if not given.",
    )
    rope_load_of_breaking_force: _Share | None = Field(
        None,
        description="Rope force times the factors of 'rules', of minimum breaking force; 100 % if not given.",
    )
    sling_bending_ratio: _Factor | None = Field(
        None, description="Least diameter of the shackle where a sling bends, over that of the sling."
    )
    sheave_bending_ratio: _Factor | None = Field(
        None, description="Least diameter of sheaves and drums over that of their rope."
    )
    smallest_sling_tension_when_clear: Annotated[float, Quantity("force", "not_negative")] | None = Field(
        None, description="Least tension of any sling once the load is clear."
    )
    tension_spread_when_clear: _Share | None = Field(
        None, description="(max - min)/mean of slings once clear."
    )
    equalised_below: Annotated[float, Quantity("ratio", "positive")] | None = Field(
        None,
        description="Tension spread below which an equalizer counts as equalised, for its time to equalise; "
        "5 % if not given. It is not checked.",
    )
    skew_load_factor: _Factor | None = Field(
        None, description="Static force of a sling over its force with perfect lengths."
    )
    equalizer_travel_used: _Share | None = Field(
        None, description="Travel used, of the stroke; 100 % if not given."
    )
    equalizer_travel_at_any_time: _Share | None = Field(
        None, description="The same over the whole lift, also before the load is clear of its supports."
    )
    equalizer_load_of_rated_capacity: _Share | None = Field(
        None,
        description="Static load of all slings of an equalizer, of its rated capacity; 100 % if not given.",
    )
    pin_force_of_capacity: _Share | None = Field(
        None, description="Force on a locking pin of its capacity; 100 % if not given."
    )
    hinge_force_of_rated_capacity: _Share | None = Field(
        None, description="Force between load and hinge, of its rated capacity; 100 % if not given."
    )
    chain_hoist_load_of_rated_capacity: _Share | None = Field(
        None,
        description="Force of a sling, of the rated capacity of the chain hoist in it; 100 % if not given.",
    )
    drum_load_of_rated_capacity: _Share | None = Field(
        None,
        description="Force of a rope on a drum of 'mechanics', of the rated capacity of that winch or strand "
        "jack; 100 % if not given.",
    )
    spreader_load_of_rated_capacity: _Share | None = Field(
        None,
        description="Static load of all slings under a spreader, of its rated capacity; 100 % if not given.",
    )
    spreader_thrust: PositiveForce | None = Field(
        None, description="Force that pushes a spreader together along its longest side."
    )
    compensator_load_of_rated_capacity: _Share | None = Field(
        None,
        description="Static load of all slings under a compensator, of its rated capacity; 100 % if not "
        "given.",
    )
    compensator_peak_of_rated_capacity: _Share | None = Field(
        None, description="Dynamic load of all slings under a compensator, of its rated capacity."
    )
    compensator_stroke_margin: _Share | None = Field(
        None,
        description="Least way of the rod of a compensator from either stop, of its stroke, while the load "
        "is clear; on a stop is a warning if not given.",
    )
    hook_dynamic_factor: _Factor | None = Field(None, description="Dynamic over static hook load.")
    sling_dynamic_factor: _Factor | None = Field(
        None, description="Peak over static tension of the same sling."
    )
    static_hook_load: PositiveForce | None = Field(
        None, description="Static hook load with the design weight, of every hook."
    )
    dynamic_hook_load: PositiveForce | None = Field(
        None, description="Larger of static hook load times the rule's factor, and simulated peak."
    )
    hoist_load_of_rated_capacity: _Share | None = Field(
        None,
        description="Hoist load of rated capacity, of hooks and of 'hook_groups'; 100 % if not given.",
    )
    hoist_load_of_drive_capacity: _Share | None = Field(
        None,
        description="Static hoist load of what motor and brake of a hoist hold, 67 % for instance; 100 % if "
        "not given.",
    )
    falls_out_of_plumb: PositiveAngle | None = Field(
        None,
        description="Angle of the falls from plumb, of hooks of Goliath cranes and at booms; of fixed hooks "
        "the angle at which falls would hang.",
    )
    off_lead: PositiveAngle | None = Field(
        None, description="Angle of the falls from plumb in the plane of the boom, of hooks at booms."
    )
    side_lead: PositiveAngle | None = Field(
        None, description="Angle of the falls from plumb across the boom, of hooks at booms."
    )
    boom_angle_margin: NotNegativeAngle | None = Field(
        None, description="Least distance of a boom's angle from the ends of its range; 0 if not given."
    )
    hook_height_margin: NotNegativeLength | None = Field(
        None, description="Least distance of a hook below its highest position; 0 if not given."
    )
    hook_falls_margin: NotNegativeLength | None = Field(
        None,
        description="Least length of the falls beyond the diameter of their sheaves, that two-blocking stays "
        "away; 0 if not given.",
    )
    rope_torque_of_falls: _Share | None = Field(
        None,
        description="Torque of the hoist ropes about a hook block, of the largest that its falls give back "
        "before they twist round each other; 100 % if not given.",
    )
    hook_approach_margin: NotNegativeLength | None = Field(
        None, description="Least distance of a hook from a rail beyond that of the crane; 0 if not given."
    )
    hook_distance_margin: NotNegativeLength | None = Field(
        None, description="Least distance of hooks of two trolleys beyond that of the crane; 0 if not given."
    )
    hook_level_difference: LevelLimit | None = Field(
        None,
        description="How far of two hooks that bear the load one goes up more than the other once it is "
        "clear: a length, of any two; or of some alone '{between: [U1, U2], largest: 50 mm}'.",
    )
    hoist_load_of_rating: _Share | None = Field(
        None,
        description="Hoist load of the rated load of the chart where the hook is; 100 % if not given.",
    )
    attitude_of_rating: _Share | None = Field(
        None,
        description="Heel, trim, off-lead and side-lead of the largest for which the chart holds; 100 % if "
        "not given.",
    )
    moment_of_tipping_moment: _Share | None = Field(
        None,
        description="Moment of what hangs of that at which a crawler crane tips, 75 % for instance; 100 % if "
        "not given.",
    )
    ground_pressure_of_allowed: _Share | None = Field(
        None, description="Pressure on the ground of 'allowed_pressure' of the tracks; 100 % if not given."
    )
    corner_load: PositiveForce | None = Field(
        None, description="Load of a corner of a Goliath crane, by moments of weights and falls."
    )
    mooring_tension_of_breaking_force: _Share | None = Field(
        None,
        description="Tension of a mooring line of minimum breaking force of its rope; 100 % if not given.",
    )
    fender_force_of_capacity: _Share | None = Field(
        None, description="Force of a fender of its capacity; 100 % if not given."
    )
    guide_force_of_capacity: _Share | None = Field(
        None, description="Force of a landing guide of its capacity; 100 % if not given."
    )
    heel: PositiveAngle | None = Field(None, description="Heel of vessels to either side.")
    trim: PositiveAngle | None = Field(None, description="Trim of vessels by bow or stern.")
    freeboard: NotNegativeLength | None = Field(
        None, description="Least height of deck edge and openings of vessels above the water; 0 if not given."
    )
    metacentric_height: PositiveLength | None = Field(
        None,
        description="Least GM of vessels for heel, free surfaces and hanging loads in it, where a run begins "
        "at rest and where it ends.",
    )
    wind_of_limit: _Share | None = Field(
        None, description="Gusts of the lift of the wind limit of the crane; 100 % if not given."
    )
    lug_load_of_capacity: _Share | None = Field(
        None, description="Load of a lug of its capacity; 100 % if not given."
    )
    shackle_load_of_working_load_limit: _Share | None = Field(
        None,
        description="Static load of a shackle of its working load limit, reduced for side load; 100 % if "
        "not given.",
    )
    shackle_dynamic_load_of_strength: _Share | None = Field(
        None,
        description="Dynamic load of a shackle of the least of working load limit times dynamic "
        "amplification factor, minimum breaking force over its factor, and proof load; 100 % if not given.",
    )


class SideLoad(Element):
    """One row of a chart of side loads on shackles."""

    what: ClassVar[str] = "a row of shackle_side_load"

    up_to: PositiveAngle = Field(description="Largest side load angle of the row.")
    remains: Annotated[float, Quantity("ratio", "positive")] = Field(
        description="What remains of the working load limit."
    )


class Rules(Element):
    """Factors by which loads are raised and strengths lowered for the checks."""

    what: ClassVar[str] = "rules"

    preset: Annotated[str, Word(tuple(PRESETS))] | None = Field(
        None, description="Rule that gives what is said neither here nor under 'limits'."
    )
    dynamic_amplification_factor: _Factor | None = Field(
        None, description="On static hook and sling loads, beside the simulated peak, never upon it."
    )
    skew_load_factor: _Factor | None = Field(
        None,
        description="On the force with perfect lengths of slings whose lengths decide how they share: more "
        "than three at one hook, or an equalizer of which pins hold a sheave.",
    )
    load_factor: _Factor | None = Field(None, description="On rope forces.")
    consequence_factor: _Factor | None = Field(None, description="On rope forces.")
    material_factor: _Factor | None = Field(None, description="On rope forces.")
    wear_factor: _Factor | None = Field(None, description="On rope forces.")
    termination_factor: _Factor | None = Field(
        None,
        description="On rope forces for their end terminations, unless bending takes more; 0027/ND, "
        "7.7.1: steel ferrule 1.12, aluminium ferrule 2.0.",
    )
    least_safety_factor: _Factor | None = Field(
        None, description="Least product of load, consequence and material factor."
    )
    lug_consequence_factor: _Factor | None = Field(
        None, description="On lug loads, where a lug's capacity does not hold it already."
    )
    shackle_breaking_factor: _Factor | None = Field(
        None, description="Least factor of a shackle's minimum breaking force over its dynamic load."
    )
    several_cranes: (
        Annotated[str, Word(tuple(SEVERAL_CRANES), ("a number as 'several_cranes_factor'",))] | None
    ) = Field(
        None,
        description="Rule that says what capacity cranes keep back, of their rating chart or without one of "
        "their rated capacity, where several lift one load.",
    )
    several_cranes_factor: _Factor | None = Field(
        None, description="The same as a factor of one's own, on the share of each of them."
    )
    shackle_side_load: list[SideLoad] | None = Field(
        None,
        description="What side load leaves of a shackle's working load limit, in place of Crosby's chart; "
        "beyond its last row no side load is allowed.",
        min_length=1,
    )

    @model_validator(mode="after")
    def _rows_in_order(self) -> Rules:
        rows = self.shackle_side_load or []
        for before, after in pairwise(rows):
            if after.up_to <= before.up_to or after.remains > before.remains:
                sentence = "its rows go from small angles to large ones, and what remains falls"
                raise refuse(f"the chart is not in order; {sentence}", "shackle_side_load")
        for row in rows:
            if row.remains > 1:
                sentence = f"{row.remains * 100:g} % is more than all of the working load limit"
                raise refuse(f"{sentence}; 100 % or less is right", "shackle_side_load")
        return self
