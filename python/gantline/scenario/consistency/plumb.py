"""Whether steps can keep the falls plumb that they name."""

from __future__ import annotations

from gantline.scenario.cranes.hooks import full_name
from gantline.scenario.cranes.kept_plumb import hooks_beside, is_moved_by, slings_under
from gantline.scenario.errors import nearest
from gantline.scenario.findings import Findings, Path
from gantline.scenario.plan.movers import Mover, mover
from gantline.scenario.plan.slinging import slings_on
from gantline.scenario.plan.steps import AlongStep, HoldStep
from gantline.scenario.rigging import Rigging

__all__ = ["check_kept_plumb"]

#: What is right where no other hook has slings on the load; a foot or a hinge holds falls askew too.
_ALONE = (
    "falls of one hook alone come plumb by themselves, and while something else holds the load, a foot that "
    "stands or ropes of 'mechanics', nothing is followed: 'to' or 'by' gives the way"
)


def check_kept_plumb(findings: Findings, rigging: Rigging) -> None:
    """Note hooks that a step cannot keep plumb: the load hangs in falls between them and others."""
    scenario = findings.scenario
    hooks = scenario.hooks
    beside: dict[str, Mover] = {}  # what keeps falls plumb side by side, by crane
    for place, (step, on) in enumerate(zip(scenario.plan, slings_on(scenario), strict=True)):
        if isinstance(step, HoldStep) or step.starts != "with_previous":
            beside = {}
        if not isinstance(step, AlongStep) or not step.keep_plumb:
            continue
        one = mover(scenario, step.kind, step.moved[0])
        if one is None:
            continue  # `check_plan` says so
        path: Path = ("plan", place, "keep_plumb")
        own = [full_name(text, scenario.hooks) for text in step.keep_plumb]
        if len(set(own)) < len(own):
            findings.add(path, "names a hook twice; each hook stands once")
        for text in step.keep_plumb:
            _check_hook(findings, rigging, path, one, text, on)
        others = hooks_beside(scenario, rigging, one)
        if not others:
            sentence = f"no load hangs between hooks of '{one.name}' and others"
            findings.add(path, f"{sentence}; {_ALONE}")
        elif not any(sling.name in on for hook in others for sling in slings_under(rigging, hook)):
            names = " and ".join(f"'{hook}'" for hook in others)
            sentence = f"no sling of {names} is on in this step, so that nothing leads the load there"
            findings.add(path, f"{sentence}; follow while the load hangs between hooks")
        for crane in {hooks[name].crane for name in hooks if is_moved_by(one, hooks[name])}:
            _check_beside(findings, ("plan", place, step.verb), beside.setdefault(crane, one), one)


def _check_beside(findings: Findings, path: Path, first: Mover, one: Mover) -> None:
    """A crane may travel along the way of its boom, so that each would make good what the other does too."""
    kinds = {first.kind, one.kind}
    if "crane" in kinds and kinds & {"boom", "upper"}:
        sentence = f"'{first.name}' keeps falls of the same crane plumb beside it"
        findings.add(path, f"{sentence}, maybe along the same way; a crane travels, or it luffs and slews")


def _check_hook(
    findings: Findings, rigging: Rigging, path: Path, one: Mover, text: str, on: frozenset[str]
) -> None:
    hooks = findings.scenario.hooks
    own = [name for name, hook in hooks.items() if is_moved_by(one, hook)]
    name = full_name(text, dict.fromkeys(own))
    if name is None:
        findings.add(path, f"'{text}' is not a hook that '{one.name}' takes along; {nearest(text, own)}")
    elif not slings_under(rigging, name):
        sentence = f"no sling hangs from '{name}', so that it does not lead the load"
        findings.add(path, f"{sentence}; a hook with slings is right")
    elif not any(sling.name in on for sling in slings_under(rigging, name)):
        sentence = f"no sling of '{name}' is on in this step, so that it does not lead the load"
        findings.add(path, f"{sentence}; follow while it does")
