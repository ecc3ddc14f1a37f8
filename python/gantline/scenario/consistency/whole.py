"""What has to hold between the parts of a lift file, beyond each value being right for itself."""

from __future__ import annotations

from collections.abc import Iterator

from gantline.scenario.afloat.mooring import check_moorings
from gantline.scenario.consistency.booms import check_booms
from gantline.scenario.consistency.crawlers import check_crawlers
from gantline.scenario.consistency.cut_lines import check_cut_lines
from gantline.scenario.consistency.equalizer import check_equalizer
from gantline.scenario.consistency.goliath import check_goliaths
from gantline.scenario.consistency.guides import check_guides
from gantline.scenario.consistency.hinges import check_hinges
from gantline.scenario.consistency.in_water import check_in_water
from gantline.scenario.consistency.load import check_load
from gantline.scenario.consistency.mechanics import check_mechanics
from gantline.scenario.consistency.plan import check_plan
from gantline.scenario.consistency.plumb import check_kept_plumb
from gantline.scenario.consistency.reeving import check_reeving
from gantline.scenario.consistency.spreaders import check_compensators, check_spreaders
from gantline.scenario.consistency.supports import check_supports
from gantline.scenario.consistency.tag_lines import check_tag_lines
from gantline.scenario.consistency.tanks import check_holes, check_tank_names, check_turned_holes
from gantline.scenario.consistency.vessels import check_vessels
from gantline.scenario.consistency.watch import check_watches
from gantline.scenario.consistency.wind import check_wind
from gantline.scenario.cranes.chain_hoist import check_chain_hoists
from gantline.scenario.cranes.compensator import rod_of
from gantline.scenario.cranes.crane_parts import crane_parts
from gantline.scenario.cranes.luffing import luffing_drum
from gantline.scenario.cranes.reeving import hoist_drum
from gantline.scenario.errors import ScenarioError, nearest
from gantline.scenario.findings import Findings, Path
from gantline.scenario.ground import INTEGRATOR_KEYS
from gantline.scenario.levels import check_levels
from gantline.scenario.loads.guide import guide_body, guide_stand
from gantline.scenario.mechanics import HalfTurn, HingeJoint, Mechanics, Slider
from gantline.scenario.model import Scenario
from gantline.scenario.plan.parting import check_partings
from gantline.scenario.plan.pins import check_pins, pins_of
from gantline.scenario.plan.slinging import check_put_on, check_waits
from gantline.scenario.plan.times import wrong_times
from gantline.scenario.rigging import SHEAVES, resolve, sheave_levels
from gantline.scenario.sheave import taken_together

__all__ = ["check"]


def check(scenario: Scenario) -> None:
    """Check a scenario as a whole.

    Raises:
        ScenarioError: with every problem found.
    """
    findings = Findings(scenario)
    check_goliaths(findings)
    check_booms(findings)
    check_crawlers(findings)
    findings.raise_any()  # nothing can be said of what hangs from hooks that are not whole
    _check_names(findings)
    try:
        rigging = resolve(scenario)
        for name, equalizer in rigging.equalizers.items():
            slings = [sling for sling in rigging.slings.values() if sling.equalizer == name]
            check_equalizer(findings, equalizer, slings)
        check_spreaders(findings, rigging)
        check_compensators(findings, rigging)
        check_pins(findings, rigging)
        check_put_on(findings, rigging)
        check_chain_hoists(findings, rigging)
        check_waits(findings, rigging)
        check_kept_plumb(findings, rigging)
        if pins_of(scenario, rigging).at_start:
            findings.refuse_explicit("pins")
    except ScenarioError as error:
        findings.problems.extend(error.problems)
    for hook in scenario.hooks.values():
        check_reeving(findings, hook)
    if scenario.load is not None:
        check_load(findings, scenario.load)
        check_in_water(findings)
    elif scenario.mechanics is None and scenario.vessels is None:
        findings.add((), "there is nothing to lift; a lift file has a 'load', 'vessels' or 'mechanics'")
    if scenario.start == "settled" and (scenario.load is None or scenario.load.stands_on is None):
        sentence = "'settled' needs a load that stands on the ground"
        findings.add(("start",), f"{sentence}; write 'stands_on: ground' or 'start: as_given'")
    if scenario.mechanics is not None:
        check_mechanics(findings, scenario.mechanics)
    check_vessels(findings)
    check_tank_names(findings)
    check_holes(findings)
    check_turned_holes(findings)
    check_wind(findings)
    check_moorings(findings)
    check_tag_lines(findings)
    check_guides(findings)
    check_hinges(findings)
    check_levels(findings)
    _check_hook_groups(findings)
    check_plan(findings)
    check_partings(findings)
    check_cut_lines(findings)
    check_watches(findings)
    check_supports(findings)
    _check_simulation(findings)
    findings.raise_any()


def _check_names(findings: Findings) -> None:
    """Note names of `_named` that stand for two things, or for what a name cannot stand for."""
    equalizers, taken = findings.scenario.equalizers or {}, dict[str, str]()
    for name, what, path in _named(findings.scenario):
        if name == "ground":
            findings.add(path, f"'ground' means the ground; {what} needs another name")
        if name == "world":
            findings.add(path, f"'world' means what stands still; {what} needs another name")
        if name in taken:
            findings.add(path, f"'{name}' is already the name of {taken[name]}; {what} needs another name")
        taken.setdefault(name, what)
        for equalizer in equalizers:
            if name.startswith(f"{equalizer}.") and name[len(equalizer) + 1 :].isdecimal():
                sentence = (
                    f"'{name}' would be a moving sheave of '{equalizer}' too; {what} needs another name"
                )
                findings.add(path, sentence)


def _named(scenario: Scenario) -> list[tuple[str, str, Path]]:
    """Vessels, cranes, equalizers, sheaves that move, load, plain bodies, drums: they share one set of names.

    Each with what it is, in words, and where the lift file has it.
    """
    named: list[tuple[str, str, Path]] = []
    named += [(name, "a vessel", ("vessels", name)) for name in scenario.vessels or {}]
    named += [(name, "a crane", ("cranes", name)) for name in scenario.cranes or {}]
    named += crane_parts(scenario.cranes or {})
    named += [
        (hoist_drum(name), "the drum of a hook", hook.paths["drum"])
        for name, hook in scenario.hooks.items()
        if hook.reeving is not None
    ]
    named += [
        (luffing_drum(placed.name), "the drum of luffing tackles", (*placed.path, "luffing", "tackles"))
        for placed in scenario.booms.values()
        if placed.tackles is not None
    ]
    named += [(name, "an equalizer", ("equalizers", name)) for name in scenario.equalizers or {}]
    named += [
        (name, "an extension sheave", ("extension_sheaves", name))
        for name in scenario.extension_sheaves or {}
    ]
    named += [(name, "a spreader", ("spreaders", name)) for name in scenario.spreaders or {}]
    for name in scenario.compensators or {}:
        path: Path = ("compensators", name)
        named += [(name, "a compensator", path), (rod_of(name), "the rod of a compensator", path)]
    if scenario.load is not None:
        named.append((scenario.load.name, "the load", ("load", "name")))
    named += [(name, "a hinge", ("hinges", name)) for name in scenario.hinges or {}]
    named += [
        (guide_body(name), "what of a guide is on the load", ("guides", name))
        for name in scenario.guides or {}
    ]
    named += [
        (guide_stand(name), "what of a guide stands on a body", ("guides", name))
        for name, guide in (scenario.guides or {}).items()
        if guide.holder is not None
    ]
    named += [(name, "a group of supports", ("supports", name)) for name in scenario.supports or {}]
    named += [(name, "a structure", ("structures", name)) for name in scenario.structures or {}]
    if scenario.mechanics is not None:
        named += [(name, "a body", ("mechanics", "bodies", name)) for name in scenario.mechanics.bodies]
        drums = scenario.mechanics.drums or {}
        named += [(name, "a drum", ("mechanics", "drums", name)) for name in drums]
    return named


def _check_hook_groups(findings: Findings) -> None:
    hooks = findings.scenario.hooks
    for name, group in (findings.scenario.hook_groups or {}).items():
        path = ("hook_groups", name, "hooks")
        for place, hook in enumerate(group.hooks):
            if hook not in hooks:
                findings.add(path, f"'{hook}' is not a hook; {nearest(hook, hooks)}")
            elif hook in group.hooks[:place]:
                findings.add(path, f"'{hook}' is named twice; each hook counts once")


def _check_simulation(findings: Findings) -> None:
    settings, duration = findings.scenario.simulation, findings.scenario.duration
    owners: dict[str, list[str]] = {}
    for kind, keys in INTEGRATOR_KEYS.items():
        for key in keys:
            owners.setdefault(key, []).append(f"'integrator: {kind}'")
    for key, kinds in owners.items():
        if key in settings.model_fields_set and key not in INTEGRATOR_KEYS[settings.integrator]:
            sentence = f"'{key}' belongs to {' and '.join(kinds)}, this lift has '{settings.integrator}'"
            findings.add(("simulation", key), f"{sentence}; leave it out or name the other integrator")
    if _has_friction(findings.scenario):
        findings.refuse_explicit("friction of sheaves and joints and no brakes")
    if (met := _what_meets(findings.scenario)) is not None:
        findings.refuse_explicit(met)
    step = None if settings.integrator == "adaptive" else settings.step
    for key, sentence in wrong_times(duration, step, findings.scenario.sample_interval):
        findings.add(("simulation", key), sentence)


def _what_meets(scenario: Scenario) -> str | None:
    """What of a lift touches other than by corners on the ground; None for nothing."""
    if scenario.load is not None and scenario.supports:
        return "supports"
    is_round = scenario.load is not None and scenario.load.shape.cylinder is not None
    return "round loads on the ground" if is_round and scenario.ground is not None else None


def _has_friction(scenario: Scenario) -> bool:
    """Whether a sheave has losses, a drum a brake, or a joint friction."""
    return any(_frictions_of_yard(scenario)) or any(_frictions_of_mechanics(scenario.mechanics))


def _frictions_of_yard(scenario: Scenario) -> Iterator[bool]:
    """Of each part of the yard, `mechanics` aside, whether it has some."""
    for line in (scenario.mooring_lines or {}).values():
        yield line.winch is not None and line.winch.capacity is not None
    for tag in (scenario.tag_lines or {}).values():
        yield bool(tag.pull or (tag.winch and tag.winch.capacity))
    for compensator in (scenario.compensators or {}).values():
        yield compensator.seal_friction > 0.0
    for name, given in (scenario.equalizers or {}).items():
        for key in SHEAVES:
            words = [said for _, said in sheave_levels(scenario, name, key)]
            yield taken_together(words).bearing_efficiency < 1
        kind = (scenario.equalizer_types or {}).get(given.type or "")
        hinge = given.hinge or (kind and kind.hinge)
        yield bool(hinge and (hinge.friction or hinge.tilt_friction))
    for hook in scenario.hooks.values():
        yield hook.reeving is not None and hook.reeving.words.bearing_efficiency < 1
        yield hook.hoist.capacity is not None


def _frictions_of_mechanics(mechanics: Mechanics | None) -> Iterator[bool]:
    """The same of guides, drums and joints of `mechanics`."""
    if mechanics is None:
        return
    for rope in (mechanics.ropes or {}).values():
        yield from (isinstance(guide, HalfTurn) and guide.bearing_efficiency < 1 for guide in rope.route)
    for drum in (mechanics.drums or {}).values():
        yield bool(drum.brake or (drum.drive and drum.drive.capacity))
    for body in mechanics.bodies.values():
        yield isinstance(body.joint, HingeJoint | Slider) and body.joint.friction > 0.0
