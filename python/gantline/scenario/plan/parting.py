"""Ropes that part: broken at a tension, or cut at a time."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Final, Literal

from gantline.scenario.cranes.compensator import gas_rope
from gantline.scenario.cranes.reeving import hoist_ropes
from gantline.scenario.plan.slinging import check_slinging
from gantline.scenario.quantities import Quantity, WordOr

if TYPE_CHECKING:
    from gantline.scenario.findings import Findings, Path
    from gantline.scenario.gear import RopeMaterial
    from gantline.scenario.model import Scenario

__all__ = [
    "BREAKS_SHOWN",
    "CUT_SHOWN",
    "BreaksAt",
    "Parting",
    "breaking_force",
    "check_partings",
    "partings",
    "rigging_ropes",
]

BreaksAt = Annotated[
    float | Literal["minimum_breaking_force", "never"],
    WordOr(("minimum_breaking_force", "never"), Quantity("force", "positive")),
]

BREAKS_SHOWN: Final = "Tension at which it breaks: a force, 'minimum_breaking_force', or 'never'."
CUT_SHOWN: Final = "Time at which it is cut."


@dataclass(frozen=True)
class Parting:
    """How a rope may part.

    Attributes:
        breaks_at: tension at which it breaks [N]; None never.
        cut_at: time at which it is cut [s]; None never.
    """

    breaks_at: float | None
    cut_at: float | None


def breaking_force(kind: RopeMaterial, own: BreaksAt | None) -> float | None:
    """Tension at which a rope of a kind breaks [N]; `own` is what the rope says for itself."""
    said = kind.breaks_at if own is None else own
    if said == "minimum_breaking_force":
        return kind.breaking_force
    return said if isinstance(said, float) else None


def partings(scenario: Scenario) -> dict[str, Parting]:
    """How every rope may part, by its name in recordings; of a scenario that has been checked."""
    kinds = scenario.ropes or {}
    found: dict[str, Parting] = {}
    for name, equalizer in (scenario.equalizers or {}).items():
        kind = (scenario.equalizer_types or {}).get(equalizer.type or "")
        rope = equalizer.rope or (kind.rope if kind is not None else None)
        found[f"{name}.equalizing"] = Parting(breaking_force(kinds[str(rope)], None), None)
    defaults = scenario.sling_defaults
    for name, sling in (scenario.slings or {}).items():
        rope = sling.rope or (defaults.rope if defaults is not None else None)
        own = sling.breaks_at or (defaults.breaks_at if defaults is not None else None)
        found[f"sling.{name}"] = Parting(breaking_force(kinds[str(rope)], own), sling.cut_at)
    for name, hook in scenario.hooks.items():
        if hook.reeving is not None:
            of_kind = Parting(breaking_force(kinds[hook.reeving.rope], None), None)
            found |= dict.fromkeys(hoist_ropes(name, hook.reeving), of_kind)
    for placed in scenario.booms.values():
        if placed.tackles is not None:
            of_kind = Parting(breaking_force(kinds[placed.tackles.rope], None), None)
            found |= dict.fromkeys(placed.ropes, of_kind)
    found |= {gas_rope(name): Parting(None, None) for name in scenario.compensators or {}}
    for name, line in (scenario.mooring_lines or {}).items():
        found[f"mooring.{name}"] = Parting(breaking_force(kinds[line.rope], line.breaks_at), line.cut_at)
    for name, tag in (scenario.tag_lines or {}).items():
        found[f"tag.{name}"] = Parting(breaking_force(kinds[tag.rope], tag.breaks_at), tag.cut_at)
    mechanics = scenario.mechanics.ropes if scenario.mechanics is not None else None
    for name, plain in (mechanics or {}).items():
        found[name] = Parting(breaking_force(kinds[plain.rope], plain.breaks_at), plain.cut_at)
    return found


def rigging_ropes(scenario: Scenario) -> list[str]:
    """Names of equalizing ropes, of ropes of hoists and booms, and of slings."""
    found = [f"{name}.equalizing" for name in scenario.equalizers or {} if scenario.moves_sheaves(name)]
    for name, hook in scenario.hooks.items():
        found += hoist_ropes(name, hook.reeving) if hook.reeving is not None else []
    found += [rope for placed in scenario.booms.values() for rope in placed.ropes]
    return found + [f"sling.{name}" for name in scenario.slings or {}]


def steps_that_cut(scenario: Scenario, rope: str) -> list[str]:
    """Names of the steps of the plan that cut a rope as they begin."""
    return [step.step for step in scenario.plan if rope in step.cut]


def check_partings(findings: Findings) -> None:
    """Note breaking forces that are not known, cuts after the end, cuts through ropes that are not there."""
    scenario = findings.scenario
    defaults = scenario.sling_defaults
    if defaults is not None:
        _check_force(findings, ("sling_defaults",), defaults.rope, defaults.breaks_at)
    for name, sling in (scenario.slings or {}).items():
        rope = sling.rope or (defaults.rope if defaults is not None else None)
        _check_force(findings, ("slings", name), rope, sling.breaks_at)
        _check_time(findings, ("slings", name, "cut_at"), sling.cut_at)
    mechanics = (scenario.mechanics.ropes if scenario.mechanics is not None else None) or {}
    for name, plain in mechanics.items():
        _check_force(findings, ("mechanics", "ropes", name), plain.rope, plain.breaks_at)
        _check_time(findings, ("mechanics", "ropes", name, "cut_at"), plain.cut_at)
    for section, lines in (("mooring_lines", scenario.mooring_lines), ("tag_lines", scenario.tag_lines)):
        for name, line in (lines or {}).items():
            _check_force(findings, (section, name), line.rope, line.breaks_at)
            _check_time(findings, (section, name, "cut_at"), line.cut_at)
    known = [
        *rigging_ropes(scenario),
        *(f"mooring.{name}" for name in scenario.mooring_lines or {}),
        *(f"tag.{name}" for name in scenario.tag_lines or {}),
        *mechanics,
    ]
    loose = [name for name in known if name.startswith("sling.") or name in mechanics]
    check_slinging(findings, known, loose)


def _check_force(findings: Findings, path: Path, rope: str | None, said: BreaksAt | None) -> None:
    kind = (findings.scenario.ropes or {}).get(rope or "")
    if said == "minimum_breaking_force" and kind is not None and kind.breaking_force is None:
        sentence = f"the minimum breaking force of '{rope}' is not known"
        findings.add((*path, "breaks_at"), f"{sentence}; give it there, or a force here, such as '600 kN'")


def _check_time(findings: Findings, path: Path, time: float | None) -> None:
    duration = findings.scenario.duration
    if time is not None and time > duration:
        sentence = f"{time:g} s is after the end of the lift at {duration:g} s"
        findings.add(path, f"{sentence}; make 'duration' longer or this time earlier")
