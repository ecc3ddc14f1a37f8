"""Contacts whose damping is such that they push long before they are touched."""

from __future__ import annotations

from collections.abc import Iterator

from gantline.scenario import Scenario
from gantline.scenario.errors import Doubt
from gantline.scenario.findings import Path
from gantline.scenario.loads.supports import supports_of
from gantline.units import format_quantity

__all__ = ["doubtful_contacts"]

#: By its law a contact pushes up to damping over stiffness before it is touched [s].
_LONGEST = 0.2
#: A speed at which loads come down in waves [m/s]; the way by which that is too soon is told.
_COMES = 0.5


def doubtful_contacts(scenario: Scenario) -> Iterator[Doubt]:
    """Each ground, group of supports and contact that brakes what has not come to it yet.

    Soft ones do, where their stiffness alone is said and their damping is that of hard ones.
    """
    for path, what, stiffness, damping in _contacts(scenario):
        if damping <= _LONGEST * stiffness:
            continue
        early = format_quantity(_COMES * damping / stiffness, "m", 2)
        given = f"{format_quantity(damping, 'MN s/m', 3)} over {format_quantity(stiffness, 'MN/m', 3)}"
        over = f"{what} has a damping of {given}, {damping / stiffness:.2g} s"
        pushes = f"it pushes what comes down at {format_quantity(_COMES, 'm/s', 1)} from {early} above it on"
        yield Doubt(path, f"{over}: {pushes}; 10 ms to 50 ms is usual, so write its 'damping'")


def _contacts(scenario: Scenario) -> Iterator[tuple[Path, str, float, float]]:
    """Path, name, stiffness [N/m] and damping [N s/m] of all that a load may stand on."""
    if (ground := scenario.ground) is not None:
        yield ("ground",), "the ground", ground.stiffness, ground.damping
    for name, group in (scenario.supports or {}).items():
        slowest = max(supports_of(name, group), key=lambda one: one.damping / one.stiffness)
        yield ("supports", name), f"support {slowest.name}", slowest.stiffness, slowest.damping
    mechanics = scenario.mechanics
    for kind in ("contacts", "body_contacts"):
        for name, contact in (getattr(mechanics, kind, None) or {}).items():
            yield ("mechanics", kind, name), f"contact {name}", contact.stiffness, contact.damping
