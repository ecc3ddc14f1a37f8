"""Sections of what was asked of the lift at rest: its equilibrium, its natural motions, its cases."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

from gantline.report.section import Section
from gantline.report.subject import ABSENT, Subject, number, show
from gantline.results import series
from gantline.results.file.saved import QUANTITIES, WORST_OF_LOSSES, SavedWorst
from gantline.results.leading_away import stability
from gantline.results.recording import Recording

#: What the first page says of cases, in its order.
_FIRST = {
    "sling_tension": "most in sling",
    "smallest_sling_tension": "least in sling",
    "hoist_load": "most hoist load at",
    "load_tilt": "tilt of",
    "sheave_travel": "travel of",
    "rod_out": "rod out of",
    "hinge_force": "most force in hinge",
}
#: Cases that are not sound, of which the first page names so many.
_MOST_TROUBLED = 3
#: Quantities that are readings of hooks: in reports they are in t.
_OF_HOOKS = ("hook_load", "hoist_load")
_NAMES = {
    "sling_tension": "largest tension",
    "smallest_sling_tension": "smallest tension",
    "rope_tension": "tension",
    "hook_load": "hook load",
    "hoist_load": "hoist load",
    "load_tilt": "tilt",
    "sheave_travel": "travel, down positive",
    "rod_out": "rod out",
    "hinge_force": "force",
}


class Rest(Section):
    """The lift at rest, as `gantline statics` found it."""

    anchor = "statics"
    title = "At rest"
    template = "rest.html"

    def content(self, subject: Subject) -> dict[str, Any] | None:
        """What the template is given."""
        rest = subject.beside.equilibrium
        if rest is None:
            return None
        said = rest.attributes["statics"]
        return {
            "facts": list(_facts(said, rest)),
            "slings": _slings(rest),
            "hooks": [
                (
                    hook.name,
                    *(number(_last(rest, name, hook.name) / rest.rig.gravity, "t", 1) for name in _OF_HOOKS),
                )
                for hook in rest.rig.hooks
            ],
            "loads": [
                (load.name, number(_last(rest, "load_tilt", load.name), "deg", 3)) for load in rest.rig.loads
            ],
            "sheaves": [
                (sheave, number(_last(rest, "sheave_travel", sheave), "m", 3))
                for equalizer in rest.rig.equalizers
                for sheave in equalizer.moving_sheaves
            ],
            "hinges": [
                (
                    hinge.name,
                    number(_last(rest, "hinge_force", hinge.name), "kN", 1),
                    number(_last(rest, "hinge_moment", hinge.name), "kN m", 1),
                )
                for hinge in rest.rig.hinges
            ],
            "compensators": [
                (
                    one.name,
                    number(_last(rest, "rod_out", one.name), "m", 3),
                    number(one.stroke, "m", 3),
                    number(_last(rest, "rope_tension", one.gas), "kN", 1),
                )
                for one in rest.rig.compensators
            ],
        }


def _facts(said: Mapping[str, Any], rest: Recording) -> list[tuple[str, str]]:
    unstable, swinging = (int(said.get(f"{kind}_motions") or 0) for kind in ("unstable", "swinging"))
    neutral = said.get("neutral_motions")
    lossy = said.get("lossy_sheaves")
    rows = [
        ("time of the plan", show(_finite(said.get("time")), "s", 2)),
        (
            "equilibrium",
            "stable" if said.get("stable") is True else f"UNSTABLE: {stability(unstable, swinging)}",
        ),
        ("motions that nothing holds", str(neutral)),
        ("largest imbalance of forces", _imbalance(_finite(said.get("residual")))),
    ]
    slides = said.get("slides")
    for one in slides if isinstance(slides, list) else []:
        rows.append((f"friction found no balance, {one['name']} slid", show(_finite(one["time"]), "s", 2)))
    if said.get("losses") == "held":
        rows.append(("friction", "of contacts and sheaves holds what it can"))
        return rows
    left_out = [f"losses of {len(lossy)} sheaves left out"] if isinstance(lossy, list) and lossy else []
    left_out += ["contacts without friction"] if rest.rig.loads else []
    return [*rows, ("friction", "; ".join(left_out))] if left_out else rows


def _imbalance(residual: float | None) -> str:
    if residual is None:
        return ABSENT
    return f"{residual:.1e} of those that meet there" if residual > 0.0 else "within rounding"


def _slings(rest: Recording) -> list[tuple[str, ...]]:
    shares = series.of_the_mean(rest)
    rows: list[tuple[str, ...]] = [
        (
            sling.name,
            number(_last(rest, "rope_tension", sling.rope), "kN", 1),
            ABSENT if (share := shares[sling.name]) is None else f"{share:.3f}",
            number(float(series.sling_angle(rest, sling)[-1]), "deg", 2),
        )
        for sling in series.slings_on(rest)
    ]
    return rows + [(sling.name, "parted", ABSENT, ABSENT) for sling in series.slings_parted(rest)]


def _last(rest: Recording, name: str, label: str) -> float:
    return float(rest.column(name, label)[-1])


def _finite(value: Any) -> float | None:
    is_number = isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value)
    return float(value) if is_number else None


class Modes(Section):
    """Natural motions about that equilibrium."""

    anchor = "modes"
    title = "Natural motions"
    template = "modes.html"

    def content(self, subject: Subject) -> dict[str, Any] | None:
        """What the template is given."""
        rest = subject.beside.equilibrium
        rows = [] if rest is None else [_mode(mode) for mode in rest.attributes["modes"]]
        return {"rows": rows} if rows else None


def _mode(mode: Mapping[str, Any]) -> dict[str, str]:
    period, growth = _finite(mode.get("period")), _finite(mode.get("growth_time"))
    course = show(period, "s", 3) if period is not None else "nothing holds it"
    if growth is not None:
        course = f"LEADS AWAY, e-fold in {show(growth, 's', 2)}"
    return {
        "number": str(mode.get("number", "")),
        "course": course,
        "damping": show(_finite(mode.get("damping_ratio")), "%", 2),
        "motion": str(mode.get("motion", "")),
    }


class Cases(Section):
    """Cases of the lift at rest, and the worst of them for each element."""

    anchor = "cases"
    title = "What if"
    template = "cases.html"

    def content(self, subject: Subject) -> dict[str, Any] | None:
        """What the template is given."""
        cases = subject.beside.cases
        if cases is None:
            return None
        return {
            "sound": cases.is_sound,
            "losses": WORST_OF_LOSSES if any(one.has_losses for one in cases.cases) else "",
            "cases": [
                {
                    "name": one.name or "as given",
                    "states": one.states,
                    "sound": not one.troubles,
                    "said": "; ".join((*one.troubles, *one.remarks)),
                }
                for one in cases.cases
            ],
            "worst": [
                {"quantity": _NAMES[one.quantity], "element": one.element, **_numbers(subject, one)}
                for one in cases.worst
            ],
        }


def _numbers(subject: Subject, one: SavedWorst) -> dict[str, str]:
    unit, digits = QUANTITIES[one.quantity]
    is_force = unit == "kN"
    per_shown = 1.0
    if one.quantity in _OF_HOOKS:
        unit, digits, per_shown = "t", 1, subject.rig.gravity
    given = show(None if one.given is None else one.given / per_shown, unit, digits)
    value = show(one.value / per_shown, unit, digits)
    # Forces have a share of one another; a tilt or a travel that was next to nothing tells nothing by it.
    # As in the table of `gantline cases`: what nobody can tell from the lift as it is given has no case.
    cause = ("as given",) if value == given else (one.case or "as given", one.label)
    return {
        "given": given,
        "value": value,
        "ratio": f"{one.value / one.given:.3f}" if one.given and is_force else ABSENT,
        "case": ", ".join(part for part in cause if part),
    }


def _briefly(troubles: Sequence[str]) -> str:
    more = f" and {len(troubles) - 1} more" if len(troubles) > 1 else ""
    return f"{troubles[0].replace('_', ' ')}{more}"


def unsound_cases(subject: Subject) -> str:
    """Which cases are not sound, for the verdict; empty where all are, or nobody has asked."""
    cases = subject.beside.cases
    names = [one.name or "as given" for one in cases.cases if one.troubles] if cases is not None else []
    more = f" and {len(names) - _MOST_TROUBLED} more" if len(names) > _MOST_TROUBLED else ""
    return ", ".join(names[:_MOST_TROUBLED]) + more


def what_if(subject: Subject) -> dict[str, Any] | None:
    """What the first page says of cases; None where nobody has asked for them."""
    cases = subject.beside.cases
    if cases is None:
        return None
    found = [(words, cases.worst_of(quantity)) for quantity, words in _FIRST.items()]
    rows = []
    for words, one in found:
        if one is not None:
            numbers = _numbers(subject, one)
            case = "as given" if numbers["value"] == numbers["given"] else one.case or "as given"
            rows.append((f"{words} {one.element}", f"{numbers['value']}, {case}"))
    troubled = [one for one in cases.cases if one.troubles]
    return {
        "rows": rows,
        "standing": " and ".join(cases.cases[0].partly_stands) if cases.cases else "",
        "sliding": " and ".join(dict.fromkeys(load for one in cases.cases for load in one.slides)),
        "sound": cases.is_sound,
        "troubled": [(one.name or "as given", _briefly(one.troubles)) for one in troubled[:_MOST_TROUBLED]],
        "more": max(0, len(troubled) - _MOST_TROUBLED),
    }
