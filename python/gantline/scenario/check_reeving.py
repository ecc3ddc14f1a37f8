"""Whether the reeving of hooks can be built and simulated."""

from __future__ import annotations

from gantline.scenario.errors import nearest
from gantline.scenario.findings import Findings, Path
from gantline.scenario.hooks import Hook
from gantline.scenario.reeving import Reeving
from gantline.scenario.rope_weight import check_rope_weight
from gantline.scenario.sheave import check_losses

__all__ = ["check_reeving"]


def check_reeving(findings: Findings, hook: Hook) -> None:
    """Note everything that is wrong with the reeving of a hook."""
    reeving = hook.reeving
    if reeving is None:
        return
    path: Path = hook.paths["reeving"]
    ropes = findings.scenario.ropes or {}
    kind = ropes.get(reeving.rope)
    if kind is None:
        sentence = f"'{reeving.rope}' is not a name of 'ropes'; {nearest(reeving.rope, ropes)}"
        findings.add((*path, "rope"), sentence)
        return
    if kind.inextensible:
        sentence = f"rope '{reeving.rope}' is inextensible, and a rope on a drum has to stretch"
        findings.add((*path, "rope"), f"{sentence}; give it an axial stiffness")
        return
    if reeving.sheave_diameter is None and kind.diameter is None:
        sentence = f"the diameter of rope '{reeving.rope}' is not known, of which this is the ratio"
        findings.add((*path, "sheave_diameter_ratio"), f"{sentence}; give 'sheave_diameter' instead")
        return

    def add(word: str, sentence: str) -> None:
        said = reeving.sheaves is not None and word and getattr(reeving.sheaves, word) is not None
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
    sheaves = hook.at[2] + hook.hook_block.height
    if reeving.upper_sheaves_at < sheaves + diameter:
        sentence = f"the sheaves of the hook block start at {sheaves:g} m, and the upper ones at "
        sentence += f"{reeving.upper_sheaves_at:g} m, not a sheave's diameter above"
        findings.add(
            (*hook.paths["reeving"], "upper_sheaves_at"),
            f"{sentence}; {sheaves + 2 * diameter:g} m or more is right",
        )
