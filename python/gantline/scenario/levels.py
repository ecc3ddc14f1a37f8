"""The limit of how far hooks go up unlike: of all that bear the load, or of some of them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any, ClassVar

from pydantic import Discriminator, Field, Tag, model_validator

from gantline.scenario.base import Element
from gantline.scenario.cranes.hooks import full_name, full_names
from gantline.scenario.errors import nearest
from gantline.scenario.quantities import ListOf, NameText, PositiveLength, refuse

if TYPE_CHECKING:
    from gantline.scenario.findings import Findings

__all__ = ["HookLevels", "LevelLimit", "check_levels", "levelled_hooks"]

_Hooks = Annotated[tuple[str, ...], ListOf(NameText(), least=2, right="[U1, U2]")]


class HookLevels(Element):
    """How far of some hooks one may go up more than another."""

    what: ClassVar[str] = "hook_level_difference"

    between: _Hooks = Field(
        description="Hooks that are compared, every two of them; what others do says nothing."
    )
    largest: PositiveLength = Field(description="The largest difference.")

    @model_validator(mode="after")
    def _are_several(self) -> HookLevels:
        if len(set(self.between)) < len(self.between):
            raise refuse("names a hook twice; hooks are compared with each other", "between")
        return self


def _level_kind(value: Any) -> str:
    return "hooks" if isinstance(value, dict | HookLevels) else "a length"


#: A length, for all hooks that bear the load, or with the hooks that it is for.
LevelLimit = Annotated[
    Annotated[PositiveLength, Tag("a length")] | Annotated[HookLevels, Tag("hooks")],
    Discriminator(_level_kind),
]


def levelled_hooks(scenario: Any) -> list[str]:
    """Full names of the hooks whose levels are compared; none where that is all that bear the load."""
    limit = scenario.limits.hook_level_difference if scenario.limits is not None else None
    return full_names(limit.between, scenario.hooks) if isinstance(limit, HookLevels) else []


def check_levels(findings: Findings) -> None:
    """Note names of hooks that are none, and one hook under two names."""
    scenario = findings.scenario
    limit = scenario.limits.hook_level_difference if scenario.limits is not None else None
    if not isinstance(limit, HookLevels):
        return
    path = ("limits", "hook_level_difference", "between")
    found = levelled_hooks(scenario)
    for text in limit.between:
        if full_name(text, scenario.hooks) is None:
            findings.add(path, f"'{text}' is not a hook; {nearest(text, scenario.hooks)}")
    if len(set(found)) < len(found):
        findings.add(path, "names a hook twice; hooks are compared with each other")
