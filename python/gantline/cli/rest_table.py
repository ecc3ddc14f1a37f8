"""What `gantline statics` says of an equilibrium: tables for people, JSON for programs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass, field
from typing import Any

from gantline.checks import Check, outcome_of, verdict_of
from gantline.cli.check_table import check_table, width_of_terminal
from gantline.cli.friction import fails_as_it_slides, slid_loads, stands_loosely
from gantline.cli.summary import heading, weights
from gantline.cli.table import ABSENT, show, table, wrapped
from gantline.results import series
from gantline.results.file.saved import LOSSES
from gantline.statics import Equilibrium, Losses, Mode, NoEquilibriumError, Sensitivity, Statics
from gantline.study.state import State, free_to_slide, rest_json
from gantline.study.tilting import Margin


@dataclass
class Answer:
    """What was found of a lift at rest.

    Attributes:
        rest: The equilibrium.
        bounds: With all sheaves slipping one way and the other, as far as there is an equilibrium.
        nowhere: Why there is none, by the way that they slip.
        ranges: Lines on what friction may hold.
        found: The slowest natural motions, of which the first are shown.
        shown: Those that are shown.
        checks: What was checked.
        of_bounds: The same of each bound.
        margins: How far the centre of gravity may be elsewhere; nothing where that was not asked for.
    """

    rest: Equilibrium
    bounds: list[Equilibrium]
    nowhere: dict[Losses, NoEquilibriumError]
    ranges: list[str]
    found: list[Mode]
    shown: list[Mode]
    checks: Sequence[Check]
    of_bounds: Sequence[Sequence[Check]]
    margins: list[Margin] = field(default_factory=list)


def heading_of(
    question: Statics, rest: Equilibrium, modes: list[Mode], checks: Sequence[Check] = ()
) -> list[str]:
    """The lift, whether it is stable, what is left out, and what that may have to do with failed checks."""
    lines = [*heading(question.rig), *weights(question.rig), *question.scenario.left_out_at_rest]
    stability = rest.stability if rest.is_stable else f"UNSTABLE: {rest.stability}"
    lines.append(f"Equilibrium at {rest.time:g} s: {stability}")
    free = [mode.motion for mode in modes if mode.period is None and mode.growth_time is None]
    lines += [f"  nothing holds: {motion}; nearest to the start" for motion in free]
    lines += [
        f"  at {moment:.2f} s friction of {name} found no balance: it slid to where nothing drives it"
        for moment, name in rest.slides
    ]
    bounds = "; bounds: all slip along the rope, all against"
    state = _state(question, rest, checks)
    loose = slid_loads(question, rest) or stands_loosely([rest]) or fails_as_it_slides([state])
    return [*lines, *friction_of(rest, bounds=bounds), *loose]


def _state(question: Statics, rest: Equilibrium, checks: Sequence[Check]) -> State:
    """What cases look at in an equilibrium."""
    slides = free_to_slide(question, rest)
    return State("", "", rest.losses, rest.time, rest, checks=checks, slides=slides)


def friction_of(rest: Equilibrium, *, bounds: str = "") -> list[str]:
    """What friction does in an equilibrium.

    Args:
        rest: The equilibrium.
        bounds: What stands beside it where losses of sheaves are left out.
    """
    if rest.losses == "held":
        return ["  friction of contacts and sheaves holds what it can, from where the lift was"]
    lossy = [f"  losses of {len(rest.lossy)} sheaves left out{bounds}"] if rest.lossy else []
    return [*lossy, *(["  contacts without friction"] if rest.recording.rig.loads else [])]


def slings_of(rest: Equilibrium, bounds: list[Equilibrium]) -> list[str]:
    """What each sling carries, and what it would with all sheaves slipping one way and the other."""
    shares = series.of_the_mean(rest.recording)
    rows = [
        (
            sling.name,
            show(rest.tension(sling.rope), "kN", 3),
            ABSENT if (share := shares[sling.name]) is None else f"{share:.4f}",
            show(float(series.sling_angle(rest.recording, sling)[-1]), "deg", 2),
            "slack" if rest.tension(sling.rope) <= 0.0 else "",
            *(show(bound.tension(sling.rope), "kN", 1) for bound in bounds),
        )
        for sling in series.slings_on(rest.recording)
    ]
    rows += [
        (sling.name, ABSENT, ABSENT, ABSENT, "parted", *(ABSENT for _ in bounds))
        for sling in series.slings_parted(rest.recording)
    ]
    head = (
        "Sling",
        "tension",
        "of the mean",
        "angle",
        "",
        *(LOSSES[bound.losses] for bound in bounds),
    )
    return table(head, rows, "lrrrl" + "r" * len(bounds)) if rows else []


def ropes(rest: Equilibrium, bounds: Sequence[Equilibrium] = ()) -> list[str]:
    """What all other ropes carry, and the tightest part of each with all sheaves slipping either way."""
    slings = {sling.rope for sling in rest.recording.rig.slings}
    others = slings | {one.gas for one in rest.recording.rig.compensators}
    names = [name for name in rest.recording.coordinates.get("rope", ()) if name not in others]
    tensions = {name: rest.tension(name) for name in names}
    unit = "kN" if max(tensions.values(), default=0.0) >= 1e3 else "N"
    rows = [
        (
            name,
            show(tension, unit, 3),
            *(show(float(series.tightest_tension(bound.recording, name)[-1]), unit, 1) for bound in bounds),
        )
        for name, tension in tensions.items()
    ]
    head = ("Rope", "tension", *(LOSSES[bound.losses] for bound in bounds))
    return table(head, rows, "lr" + "r" * len(bounds)) if rows else []


def fenders(rest: Equilibrium) -> list[str]:
    """What vessels press on fenders with."""
    rows = []
    for fender in rest.recording.rig.fenders:
        force = float(rest.recording.column("fender_force", fender.name)[-1])
        rows.append((fender.name, show(force, "kN", 3), show(fender.used_by(force), "%", 1)))
    return table(("Fender", "force", "of capacity"), rows, "lrr") if rows else []


def hooks(rest: Equilibrium) -> list[str]:
    """What hooks and hoists bear."""
    rows = [
        (hook.name, *(show(float(rest.recording.column(name, hook.name)[-1]), "kN", 1) for name in loads))
        for loads in [("hook_load", "hoist_load")]
        for hook in rest.recording.rig.hooks
    ]
    return table(("Hook", "hook load", "hoist load"), rows, "lrr") if rows else []


def loads(rest: Equilibrium) -> list[str]:
    """How loads hang."""
    rows = [
        (
            load.name,
            show(float(rest.recording.column("load_tilt", load.name)[-1]), "deg", 3),
            # Rounding of a load that stands is no negative share.
            show(max(0.0, float(rest.recording.column("load_transferred", load.name)[-1])), "%", 1),
        )
        for load in rest.recording.rig.loads
    ]
    return table(("Load", "tilt", "load transferred"), rows, "lrr") if rows else []


def moving_sheaves(rest: Equilibrium) -> list[str]:
    """How far moving sheaves have travelled."""
    rows = [
        (sheave, show(float(rest.recording.column("sheave_travel", sheave)[-1]), "m", 3))
        for equalizer in rest.recording.rig.equalizers
        for sheave in equalizer.moving_sheaves
    ]
    return table(("Moving sheave", "travel, down positive"), rows, "lr") if rows else []


def compensators(rest: Equilibrium) -> list[str]:
    """How far rods are out, of the stroke, and what their gas pulls with."""
    recording = rest.recording
    rows = []
    for one in recording.rig.compensators:
        out = float(recording.column("rod_out", one.name)[-1])
        held = float(recording.column("rope_tension", one.gas)[-1])
        used = show(out / one.stroke, "%", 1)
        rows.append((one.name, show(out, "m", 3), show(one.stroke, "m", 3), used, show(held, "kN", 1)))
    return table(("Compensator", "rod out", "stroke", "of it", "gas"), rows, "lrrrr") if rows else []


def motions(modes: list[Mode]) -> list[str]:
    """Natural motions, the slowest first."""

    def course(mode: Mode) -> str:
        if mode.growth_time is not None:
            return f"leads away, e-fold in {show(mode.growth_time, 's', 2)}"
        return show(mode.period, "s", 3) if mode.period is not None else "nothing holds it"

    rows = [
        (str(mode.number + 1), course(mode), show(mode.damping_ratio, "%", 2), mode.motion) for mode in modes
    ]
    return table(("Motion", "period", "damping ratio", "what moves"), rows, "lrrl") if rows else []


#: What one error of each kind is, for the table: its size, and in words.
_ERRORS = {
    "length": (0.01, "10 mm longer"),
    "stiffness": (0.0, "1 % stiffer"),
    "mass": (1000.0, "1 t heavier"),
    "centre_x": (0.1, "centre of gravity 100 mm along x"),
    "centre_y": (0.1, "centre of gravity 100 mm along y"),
    "centre_z": (0.1, "centre of gravity 100 mm along z"),
}


def changes(rest: Equilibrium, all_of_them: list[Sensitivity]) -> list[list[str]]:
    """Changes of the slings' tensions and of the loads' attitudes, first order."""
    rig = rest.recording.rig
    stiffness = rest.recording.attributes["axial_stiffness"]
    pulls, turns = [], []
    for one in all_of_them:
        size, words = _ERRORS[one.kind]
        if one.kind == "stiffness":
            size = 0.01 * stiffness.get(one.name, 0.0)
        name = f"{one.name} {words}"
        if not one.is_held:
            name += " sets going what nothing holds"
            pulls.append((name, *(ABSENT for _ in rig.slings)))
            turns.append((name, *(ABSENT for _ in rig.loads for _ in "xyz")))
            continue
        pulls.append((name, *(show(one.of(sling.rope) * size, "kN", 3) for sling in rig.slings)))
        angles = (size * angle for load in rig.loads for angle in one.of_body(load.body)[3:])
        turns.append((name, *(show(angle, "deg", 3) for angle in angles)))
    tensions = ("Change of tension", *(sling.name for sling in rig.slings))
    axes = (f"{load.name} about {axis}" for load in rig.loads for axis in "xyz")
    tables = ((tensions, pulls), (("Change of attitude", *axes), turns))
    if not (rig.slings or rig.loads):
        return [["--sensitivities is about slings and loads, and there are none."]]
    return [table(head, rows, "l" + "r" * (len(head) - 1)) for head, rows in tables if len(head) > 1]


def checks_at_rest(rest: Equilibrium, checks: Sequence[Check]) -> list[str]:
    """What has a limit, and the verdict on it."""
    rule = str(rest.recording.rig.limits.get("rule") or "")
    return check_table(checks, rule, width=width_of_terminal(), full=False, with_unlimited=False)


#: How sheaves slip in a bound, in words.
_SLIPPING = {"forward": "along the rope", "backward": "against the rope"}


def bounds_at_rest(answer: Answer) -> list[str]:
    """The verdict with all sheaves slipping one way, and the other: losses may hold as much."""
    lines = []
    for bound, checks in zip(answer.bounds, answer.of_bounds, strict=True):
        said = f"With all sheaves slipping {_SLIPPING[bound.losses]}: {verdict_of(checks)}"
        lines += wrapped(said, width_of_terminal())
        still = _standing(answer.rest, bound)
        if still:
            stand = "stands" if len(still) == 1 else "stand"
            said = f"  {', '.join(still)} still {stand} in that, at {bound.time:g} s: its plan waits"
            said += " longer, and it is no bound of what slings carry once clear"
            lines += wrapped(said, width_of_terminal())
    for way, problem in answer.nowhere.items():
        said = f"With all sheaves slipping {_SLIPPING[way]} {problem}"
        lines += wrapped(said, width_of_terminal())
    return lines


def _standing(rest: Equilibrium, bound: Equilibrium) -> list[str]:
    """Loads that something supports in a bound, and nothing in the equilibrium that it is a bound of.

    A plan that waits for conditions is followed with the losses of the bound, and may be behind there.
    """
    return [
        load.name
        for load in rest.recording.rig.loads
        if series.load_is_clear(rest.recording, load)[-1]
        and not series.load_is_clear(bound.recording, load)[-1]
    ]


def statics_json(question: Statics, answer: Answer, sensitivities: list[Sensitivity]) -> dict[str, Any]:
    """An equilibrium as a JSON object, SI units, with sentences on what it leaves out of the lift."""
    rest, checks = answer.rest, answer.checks
    return {
        **rest_json(rest),
        "bounds": [
            {
                **rest_json(one),
                "verdict": verdict_of(checks_of_one),
                "still_standing": _standing(rest, one),
            }
            for one, checks_of_one in zip(answer.bounds, answer.of_bounds, strict=True)
        ],
        "bounds_without_equilibrium": [
            {"losses": way, "element": problem.element, "cause": problem.cause}
            for way, problem in answer.nowhere.items()
        ],
        "contacts": [
            {"name": one.contact, "support": one.support, "friction": list(one.friction), "bound": one.bound}
            for one in rest.contacts
        ],
        "modes": [mode.to_json() for mode in answer.shown],
        "sensitivities": [
            {
                "kind": one.kind,
                "of": one.name,
                "is_held": one.is_held,
                "rope_tension": dict(zip(one.ropes, map(float, one.tension), strict=True)),
            }
            for one in sensitivities
        ],
        "margins": [asdict(one) for one in answer.margins],
        "outcome": outcome_of(checks).value,
        "verdict": verdict_of(checks),
        "checks": [check.to_json() for check in checks],
        "left_out": list(question.scenario.left_out_at_rest),
        "fails_as_it_slides": list(_state(question, rest, checks).fails_as_it_slides),
    }
