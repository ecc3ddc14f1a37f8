"""From a scenario to the system that the core simulates."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from operator import add
from typing import Any

from gantline.assembly.afloat.critical_damping import add_critical_damping
from gantline.assembly.afloat.long_waves import add_doubts_of_hulls
from gantline.assembly.afloat.moorings import add_moorings
from gantline.assembly.afloat.streams import add_streams
from gantline.assembly.afloat.vessels import add_vessels, watch_vessels
from gantline.assembly.afloat.water import add_load_tanks, add_water
from gantline.assembly.afloat.waves import add_waves
from gantline.assembly.cranes.boom import add_booms
from gantline.assembly.cranes.boom_at_rest import hang_in_tackles, rest_on_springs
from gantline.assembly.cranes.crawler import add_crawlers
from gantline.assembly.cranes.goliath import add_goliaths, rest_on_girders
from gantline.assembly.cranes.heave import add_compensation, compensators
from gantline.assembly.cranes.reeving import hang_in_ropes, reeved_hooks
from gantline.assembly.doubts.baskets import doubtful_baskets
from gantline.assembly.doubts.beside import doubtful_beside
from gantline.assembly.doubts.booms import doubtful_booms
from gantline.assembly.doubts.carried import doubtful_carried
from gantline.assembly.doubts.compensators import doubtful_compensators
from gantline.assembly.doubts.contacts import doubtful_contacts
from gantline.assembly.doubts.cranes import doubtful_cranes
from gantline.assembly.doubts.decks import doubtful_decks
from gantline.assembly.doubts.dragged import doubtful_dragging
from gantline.assembly.doubts.drums import doubtful_drums
from gantline.assembly.doubts.empty import doubtful_empty, doubtful_pins
from gantline.assembly.doubts.falls import doubtful_falls
from gantline.assembly.doubts.fenders import doubtful_fenders
from gantline.assembly.doubts.following import doubtful_following
from gantline.assembly.doubts.gear import doubtful_gear
from gantline.assembly.doubts.ground import doubtful_ground
from gantline.assembly.doubts.guides import GuideFit, doubtful_guides, guide_fits
from gantline.assembly.doubts.heading import doubtful_heading
from gantline.assembly.doubts.heights import doubtful_heights
from gantline.assembly.doubts.highest import doubtful_highest
from gantline.assembly.doubts.hinges import doubtful_hinges
from gantline.assembly.doubts.hook_blocks import doubtful_hook_blocks
from gantline.assembly.doubts.inside import doubtful_inside
from gantline.assembly.doubts.jerks import doubtful_accelerations
from gantline.assembly.doubts.lead import doubtful_lead
from gantline.assembly.doubts.lee import doubtful_lee
from gantline.assembly.doubts.levels import doubtful_levels
from gantline.assembly.doubts.masses import doubtful_masses
from gantline.assembly.doubts.of_types import said_once
from gantline.assembly.doubts.rails import doubtful_rails
from gantline.assembly.doubts.ratings import doubtful_ratings
from gantline.assembly.doubts.reach import doubtful_reach
from gantline.assembly.doubts.set_down import doubtful_set_down
from gantline.assembly.doubts.sheaves import doubtful_sheaves
from gantline.assembly.doubts.stops import doubtful_stops
from gantline.assembly.doubts.strength import doubtful_strength
from gantline.assembly.doubts.supports import check_under_load, doubtful_supports
from gantline.assembly.doubts.tanks import doubtful_tanks
from gantline.assembly.doubts.tilts import doubtful_tilt_limit, doubtful_tilts
from gantline.assembly.doubts.travelling import doubtful_travelling
from gantline.assembly.doubts.turned_frames import doubtful_frames
from gantline.assembly.doubts.turns import doubtful_turns
from gantline.assembly.doubts.vessels import doubtful_vessels
from gantline.assembly.doubts.waits import doubtful_waits
from gantline.assembly.doubts.ways import doubtful_ways
from gantline.assembly.doubts.weight import doubtful_density, doubtful_gravity, doubtful_weight
from gantline.assembly.loads.carried import settle_with_load
from gantline.assembly.loads.guides import add_guides
from gantline.assembly.loads.in_water import add_in_water
from gantline.assembly.loads.lifted import LiftedLoad, add_load, lifted_load
from gantline.assembly.loads.on_load import kept_on_load
from gantline.assembly.loads.supports import removals
from gantline.assembly.loads.under_load import UnderLoad, cut_to_load, under_load
from gantline.assembly.parts import Parts
from gantline.assembly.plain import add_mechanics
from gantline.assembly.plan.operations import emergency_stop, operations
from gantline.assembly.plan.parting import add_partings
from gantline.assembly.plan.slinging import warn_of_cuts
from gantline.assembly.rig import rig
from gantline.assembly.ropes.between import add_between
from gantline.assembly.ropes.pulls import add_pulls
from gantline.assembly.ropes.rope_rig import rope_kinds
from gantline.assembly.ropes.tag_lines import add_tag_lines
from gantline.assembly.scene import scene
from gantline.assembly.shapes import add_shapes, add_touching, add_watches
from gantline.assembly.yard import add_equalizers, add_hooks, add_slings
from gantline.scenario import Rigging, Scenario, StartError, resolve
from gantline.scenario.errors import Doubt, Problem
from gantline.scenario.ground import INTEGRATOR_KEYS, SimulationSettings
from gantline.scenario.loads.hinge import hinge_pins
from gantline.scenario.loads.load import Load
from gantline.scenario.plan.pins import Pins, pins_of

__all__ = ["Assembly", "assemble", "integrator_settings"]


@dataclass(frozen=True)
class Assembly:
    """A lift in words of mechanics.

    Attributes:
        document: bodies, ropes, contacts, drives and plan, as the core reads them (private, never saved).
        settings: method, duration and sampling.
        rig: who carries whom and what is allowed, for results and checks.
        scene: what is needed to draw.
        doubts: what does not agree in the lift file, or cannot well be meant, each with its place.
        under_load: all supports, and where the load is over them at the start.
        guide_fits: how each landing guide fits the load at the start, by its name.
    """

    document: dict[str, Any]
    settings: dict[str, Any]
    rig: dict[str, Any]
    scene: dict[str, Any]
    doubts: tuple[Problem, ...] = ()
    under_load: tuple[UnderLoad, ...] = ()
    guide_fits: Mapping[str, GuideFit] = field(default_factory=dict)

    @property
    def warnings(self) -> tuple[str, ...]:
        """The sentences of these doubts, without their places."""
        return tuple(doubt.sentence for doubt in self.doubts)

    def document_text(self) -> str:
        """The document as JSON, floats exact."""
        return self._document_text

    @cached_property
    def _document_text(self) -> str:
        return json.dumps(self.document, allow_nan=False)


def assemble(scenario: Scenario) -> Assembly:
    """Build the system of a scenario.

    Args:
        scenario: as `load_scenario` gives it.

    Returns:
        The system with all that is said about it.

    Raises:
        ScenarioError: if the lift cannot be built as written (a load that would tip, a sling too short, ...).
    """
    rigging = resolve(scenario)
    try:
        return _assembled(scenario, rigging)
    except StartError as error:
        # Slings are too short for a load that sinks in, where only its weight is wrong.
        heavy = [scenario.problem(*doubt) for doubt in doubtful_weight(scenario, rigging)]
        if not heavy:
            raise
        raise StartError(scenario.source, [*heavy, *error.problems]) from None


def _assembled(scenario: Scenario, rigging: Rigging) -> Assembly:
    parts = Parts()
    add_vessels(parts, scenario)
    add_goliaths(parts, scenario)
    add_crawlers(parts, scenario)
    add_booms(parts, scenario)
    add_hooks(parts, scenario, rigging)
    pins = pins_of(scenario, rigging)
    add_equalizers(parts, rigging, pins.at_start)
    lifted: LiftedLoad | None = None
    under: Sequence[UnderLoad] = ()
    if scenario.load is not None:
        scenario, lifted, under = _add_lifted(parts, scenario, scenario.load, rigging)
        add_between(parts, scenario, rigging, lifted.lugs, pins.at_start)
        _add_slings(parts, scenario, rigging, lifted)
    add_mechanics(parts, scenario)
    add_water(parts, scenario)
    if lifted is not None:
        add_load_tanks(parts, scenario, lifted.centre)
    add_doubts_of_hulls(parts, scenario)
    if scenario.load is not None and lifted is not None:
        add_in_water(parts, scenario, scenario.load, lifted)
    add_streams(parts, scenario, lifted)
    add_critical_damping(parts, scenario)
    add_waves(parts, scenario)
    add_moorings(parts, scenario)
    if lifted is not None:
        add_tag_lines(parts, scenario, lifted)
        add_guides(parts, scenario, lifted)
    watch_vessels(parts, scenario)
    for hook in reeved_hooks(scenario):
        hang_in_ropes(parts, scenario, hook)
    hang_in_tackles(parts, scenario)
    rest_on_springs(parts, scenario)
    rest_on_girders(parts, scenario)
    add_shapes(parts, scenario, rigging, lifted)
    if lifted is not None:
        settle_with_load(parts, scenario, lifted)
    add_touching(parts, scenario)
    kinds = rope_kinds(scenario, rigging)
    add_watches(parts, scenario, {name: kind.diameter for name, (kind, _) in kinds.items()})
    add_pulls(parts, scenario, rigging)
    parts.plan.extend(operations(scenario, rigging, parts))
    parts.compensators.extend(compensators(scenario))
    add_compensation(parts, scenario)
    _add_changes(parts, scenario, pins)
    parts.emergency_stop = emergency_stop(scenario)
    add_partings(parts, scenario)
    warn_of_cuts(parts, scenario)
    doubts = (
        *_doubts(parts, scenario, rigging, lifted, pins),
        *doubtful_levels(parts, scenario, under),
        *doubtful_decks(parts, scenario, rigging),
        *doubtful_heading(parts, scenario, rigging, lifted, under),
    )
    return Assembly(
        document=parts.document(scenario.simulation.gravity),
        settings=_settings(scenario),
        rig=rig(scenario, rigging, lifted, parts),
        scene=scene(scenario, rigging, lifted, parts),
        doubts=said_once(scenario, doubts),
        under_load=tuple(under),
        guide_fits=guide_fits(parts, scenario),
    )


def _add_lifted(
    parts: Parts, scenario: Scenario, load: Load, rigging: Rigging
) -> tuple[Scenario, LiftedLoad, Sequence[UnderLoad]]:
    """The load and what it stands on.

    Returns:
        The lift with mechanics and supports as the load has them, the load, and all supports under it.
    """
    lifted = lifted_load(scenario, load, rigging)
    scenario = cut_to_load(kept_on_load(scenario, lifted), load, lifted.body)
    under = under_load(scenario, load, lifted.body, lifted.centre)
    check_under_load(scenario, load, lifted.body, under)
    add_load(parts, scenario, load, rigging, lifted, under)
    parts.supports += [one.pad for one in under]
    parts.doubts += doubtful_supports(scenario, load, lifted.body, under)
    return scenario, lifted, under


def _add_slings(parts: Parts, scenario: Scenario, rigging: Rigging, lifted: LiftedLoad) -> None:
    """All slings; where they are too short for a hook that is beside its load only its place is wrong."""
    try:
        add_slings(parts, scenario, rigging, lifted.lugs)
    except StartError as error:
        beside = [scenario.problem(*doubt) for doubt in doubtful_beside(parts, scenario, rigging, lifted)]
        raise StartError(scenario.source, [*beside, *error.problems]) from None


def _add_changes(parts: Parts, scenario: Scenario, pins: Pins) -> None:
    """What steps of the plan pull, put in and remove."""
    pulled_pins = map(add, pins.pulled, hinge_pins(scenario))
    changes = zip(parts.plan, pulled_pins, pins.put_in, removals(scenario), strict=True)
    for step, pulled, put_in, removed in changes:
        said = (("pulls", pulled), ("pins", put_in), ("removes", removed))
        step |= {key: names for key, names in said if names}


def _doubts(
    parts: Parts, scenario: Scenario, rigging: Rigging, lifted: LiftedLoad | None, pins: Pins
) -> tuple[Doubt, ...]:
    """What is doubtful about a lift whose parts are made."""
    return (
        *(() if lifted is None else lifted.body.doubts),
        *parts.doubts,
        *doubtful_weight(scenario, rigging),
        *doubtful_density(scenario),
        *doubtful_gravity(scenario),
        *doubtful_masses(scenario),
        *doubtful_empty(scenario, rigging),
        *doubtful_pins(scenario, rigging, pins),
        *doubtful_turns(scenario),
        *doubtful_waits(parts, scenario),
        *doubtful_vessels(parts, scenario),
        *doubtful_tanks(scenario),
        *doubtful_fenders(parts, scenario),
        *doubtful_guides(parts, scenario, guide_fits(parts, scenario)),
        *doubtful_lee(parts, scenario),
        *doubtful_carried(parts, scenario),
        *doubtful_heights(scenario),
        *doubtful_hook_blocks(scenario),
        *doubtful_highest(parts, scenario),
        *doubtful_accelerations(scenario),
        *doubtful_ways(parts, scenario),
        *doubtful_tilts(scenario, rigging, lifted),
        *doubtful_tilt_limit(scenario),
        *doubtful_stops(scenario),
        *doubtful_lead(scenario, rigging),
        *doubtful_rails(scenario),
        *doubtful_falls(scenario),
        *doubtful_dragging(scenario, rigging),
        *doubtful_set_down(scenario, rigging),
        *doubtful_cranes(scenario),
        *doubtful_booms(scenario),
        *doubtful_ground(scenario),
        *doubtful_contacts(scenario),
        *doubtful_gear(scenario, rigging),
        *doubtful_baskets(parts, scenario, lifted),
        *doubtful_compensators(scenario, rigging, pins),
        *doubtful_sheaves(scenario, rigging),
        *doubtful_frames(parts, scenario, rigging),
        *doubtful_drums(scenario),
        *doubtful_strength(scenario, rigging),
        *doubtful_ratings(scenario, rigging),
        *doubtful_travelling(scenario, rigging),
        *doubtful_following(scenario, rigging, lifted),
        *doubtful_hinges(parts, scenario, rigging, lifted),
        *doubtful_inside(parts, scenario, lifted),
        *doubtful_beside(parts, scenario, rigging, lifted),
        *doubtful_reach(parts, scenario, rigging, lifted),
    )


def _settings(scenario: Scenario) -> dict[str, Any]:
    given = scenario.simulation
    return {
        "integrator": integrator_settings(given.integrator, given),
        "duration": scenario.duration,
        "sample_interval": scenario.sample_interval,
        "start": "rest" if scenario.starts_at_rest else "as_given",
    }


def integrator_settings(kind: str, given: SimulationSettings) -> dict[str, Any]:
    """Settings of one integrator as the core takes them, from those of the lift file.

    Args:
        kind: `adaptive`, `del` or `explicit`.
        given: What the lift file says; keys of other integrators are left out.

    Raises:
        KeyError: If there is no integrator of that kind.
    """
    return {"type": kind, **{name: getattr(given, name) for name in INTEGRATOR_KEYS[kind]}}
