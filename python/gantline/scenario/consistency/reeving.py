"""Whether the reeving of hooks can be built and simulated."""

from __future__ import annotations

from gantline.scenario.cranes.hooks import Hook
from gantline.scenario.cranes.reeving import Reeving
from gantline.scenario.errors import nearest
from gantline.scenario.findings import Findings, Path
from gantline.scenario.rope_weight import check_rope_weight
from gantline.scenario.sheave import check_losses

__all__ = ["check_reeving", "check_upper_sheaves"]


def check_reeving(findings: Findings, hook: Hook) -> None:
    """Note everything that is wrong with the reeving of a hook."""
    reeving = hook.reeving
    if reeving is None:
        return
    path: Path = hook.paths["reeving"]
    ropes = findings.scenario.ropes or {}
    kind = ropes.get(reeving.rope)
    if not _check_place(findings, hook, reeving):
        return
    if kind is None:
        sentence = f"'{reeving.rope}' is not a name of 'ropes'; {nearest(reeving.rope, ropes)}"
        findings.add((*path, "rope"), sentence)
        return
    if kind.inextensible:
        sentence = f"rope '{reeving.rope}' is inextensible, and a rope on a drum has to stretch"
        findings.add((*path, "rope"), f"{sentence}; give it an axial stiffness")
        return
    if (bent := kind.bent(reeving.rope, "a rope on a drum")) is not None:
        findings.add((*path, "rope"), bent)
        return
    if reeving.sheave_diameter is None and kind.diameter is None:
        sentence = f"the diameter of rope '{reeving.rope}' is not known, of which this is the ratio"
        findings.add((*path, "sheave_diameter_ratio"), f"{sentence}; give 'sheave_diameter' instead")
        return

    def add(word: str, sentence: str) -> None:
        if not word:
            # What is missing belongs there, not beside 'sheave_efficiency'.
            findings.add((*path, "sheaves"), sentence)
            return
        said = reeving.sheaves is not None and getattr(reeving.sheaves, word) is not None
        findings.add((*path, "sheaves", word) if said else path, sentence)

    losses = reeving.losses(kind.diameter, kind.mass_per_length)
    check_losses(add, reeving.words, losses, reeving.rope, kind.inextensible)
    check_rope_weight(
        lambda key, sentence: findings.add((*path, key), sentence),
        reeving.rope,
        kind,
        reeving.rope_weight,
        over_sheaves="a hoist rope",
        gravity=findings.scenario.simulation.gravity,
    )
    assert hook.drum is not None  # the model has seen to that
    if hook.drum.layers > 1 and hook.drum.layer_step is None and kind.diameter is None:
        sentence = f"the diameter of rope '{reeving.rope}' is not known, which says how thick a layer is"
        findings.add(hook.paths["drum"], f"{sentence}; give 'layer_step', such as 'layer_step: 36 mm'")
    _check_room(findings, hook, reeving, reeving.diameter(kind.diameter))


def _check_room(findings: Findings, hook: Hook, reeving: Reeving, diameter: float) -> None:
    """The hook block has to start below the upper sheaves, and the hook has something to lift."""
    assert hook.hook_block is not None
    if reeving.upper_sheaves_at is None:  # at a boom: its head is known once everything has its place
        return
    sheaves = hook.height + hook.hook_block.height
    if reeving.upper_sheaves_at < sheaves + diameter:
        sentence = f"the sheaves of the hook block start at {sheaves:g} m, and the upper ones at "
        sentence += f"{reeving.upper_sheaves_at:g} m, not a sheave's diameter above"
        findings.add(
            (*hook.paths["reeving"], "upper_sheaves_at"),
            f"{sentence}; {sheaves + 2 * diameter:g} m or more is right",
        )


def check_upper_sheaves(findings: Findings, path: Path, reeving: Reeving, *, at_boom: bool) -> bool:
    """Note a reeving that says nothing of where its upper sheaves are, or that in words of another hook.

    Returns:
        Whether it is said and right.
    """
    needed, other = ("below_head", "upper_sheaves_at") if at_boom else ("upper_sheaves_at", "below_head")
    where = "at a boom" if at_boom else "that does not hang at a boom"
    right = "below_head: 1.3 m" if at_boom else "upper_sheaves_at: 88 m"
    if getattr(reeving, needed) is None:
        findings.add(
            path, f"'{needed}' is missing; the reeving of a hook {where} needs it, such as '{right}'"
        )
        return False
    for key in (other, *(() if at_boom else ("sheave_block_mass",))):
        if getattr(reeving, key) is not None:
            findings.add((*path, key), f"'{key}' has no meaning for a hook {where}; leave it out")
            return False
    return True


def _check_place(findings: Findings, hook: Hook, reeving: Reeving) -> bool:
    """The place of the upper sheaves: under a boom head, or at a height; true where it is said and right."""
    path = hook.paths["reeving"]
    at_boom = hook.carrier is not None and hook.carrier.kind == "boom"
    if not check_upper_sheaves(findings, path, reeving, at_boom=at_boom):
        return False
    kind = (findings.scenario.ropes or {}).get(reeving.rope)
    if at_boom and kind is not None and kind.diameter is None and reeving.sheave_block_mass is None:
        sentence = (
            f"the diameter of rope '{reeving.rope}' is not known, from which the mass of the sheave block"
        )
        findings.add(
            path, f"{sentence} at the boom head would follow; give 'sheave_block_mass', such as '8 t'"
        )
        return False
    return True
