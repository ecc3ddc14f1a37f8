"""Whether the hooks that steps keep still against heave can be kept so."""

from __future__ import annotations

from gantline.scenario.cranes.boom import FloatingCrane
from gantline.scenario.cranes.hooks import Hook, full_name
from gantline.scenario.errors import nearest
from gantline.scenario.findings import Findings
from gantline.scenario.plan.plan import Step

__all__ = ["check_heave"]

_EXAMPLE = "'heave_compensation: {speed: 1 m/s, acceleration: 1 m/s^2}'"


def check_heave(findings: Findings, place: int, step: Step) -> None:
    """Note what is wrong with `compensate_heave` and `relative_to` of a step of the plan."""
    hooks = findings.scenario.hooks
    seen: list[Hook] = []
    for text in step.compensate_heave:
        name = full_name(text, hooks)
        if name is None:
            findings.add(
                ("plan", place, "compensate_heave"), f"'{text}' is not a hook; {nearest(text, hooks)}"
            )
            continue
        hook = hooks[name]
        if hook in seen:
            findings.add(("plan", place, "compensate_heave"), "names a hook twice; each hook stands once")
        seen.append(hook)
        crane = (findings.scenario.cranes or {}).get(hook.crane)
        if not (isinstance(crane, FloatingCrane) and crane.vessel is not None):
            sentence = f"'{text}' hangs from no crane on a vessel, and so nothing of it heaves"
            findings.add(("plan", place, "compensate_heave"), f"{sentence}; leave it out")
        elif hook.hoist.heave_compensation is None:
            sentence = f"the hoist of '{text}' does not compensate heave"
            findings.add(("plan", place, "compensate_heave"), f"{sentence}; give it some, such as {_EXAMPLE}")
    _check_deck(findings, place, step, seen)


def _check_deck(findings: Findings, place: int, step: Step, hooks: list[Hook]) -> None:
    """The deck against which hooks are kept still is that of another vessel."""
    deck = step.relative_to
    if deck is None:
        return
    vessels = findings.scenario.vessels or {}
    if deck not in vessels:
        hint = nearest(deck, vessels)
        if not hint.endswith("?"):
            hint = f"{hint}; without it that is the ground, and all that stands on it"
        findings.add(("plan", place, "relative_to"), f"'{deck}' is not a vessel; {hint}")
    for hook in hooks:
        crane = (findings.scenario.cranes or {}).get(hook.crane)
        if isinstance(crane, FloatingCrane) and crane.vessel == deck:
            sentence = f"'{deck}' bears '{hook.name}' itself, whose boom head does not heave against it"
            findings.add(("plan", place, "relative_to"), f"{sentence}; name another vessel, or none")
