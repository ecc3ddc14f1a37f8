"""What bears the hooks of a lift and may stand elsewhere: fixed hooks, trolleys, Goliath cranes."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from gantline.scenario import Scenario
from gantline.scenario.crane import FixedHook
from gantline.scenario.errors import join_path
from gantline.scenario.goliath import Goliath
from gantline.scenario.hooks import Hook, trolley_name

__all__ = ["Bearer", "bearers_of", "why_not"]


@dataclass(frozen=True)
class Bearer:
    """A body with a place of its own in the lift file, along one axis of the world.

    Attributes:
        body: Its name, and that of the body.
        axis: Which axis, 0 or 1.
        hooks: Hooks in use that it takes along.
        path: Dotted path of its place.
        given: That place [m].
        is_whole: Whether it moves only if all its hooks may: a crane, and no trolley.
    """

    body: str
    axis: int
    hooks: tuple[str, ...]
    path: str
    given: float
    is_whole: bool = False

    def may_move(self, chosen: Sequence[str]) -> bool:
        """Whether it may, if these hooks may."""
        are = [hook in chosen for hook in self.hooks]
        return all(are) if self.is_whole else any(are)


def bearers_of(scenario: Scenario, used: Sequence[str]) -> list[Bearer]:
    """All that bear one of the hooks in use; booms and what bears them have no place along an axis."""
    return [one for name in scenario.cranes or {} for one in _of_crane(scenario, name, used) if one.hooks]


def _of_crane(scenario: Scenario, name: str, used: Sequence[str]) -> Iterator[Bearer]:
    crane = (scenario.cranes or {})[name]
    if isinstance(crane, FixedHook):
        hooks = (name,) if name in used else ()
        for axis, letter in enumerate("xy"):
            yield Bearer(name, axis, hooks, f"cranes.{name}.at.{letter}", crane.at[axis])
    elif isinstance(crane, Goliath):
        for trolley, given in crane.trolleys.items():
            those = tuple(f"{name}.{hook}" for hook in given.hooks if f"{name}.{hook}" in used)
            path = join_path(("cranes", name, "trolleys", trolley, "position"))
            yield Bearer(trolley_name(name, trolley), 0, those, path, given.position)
        own = tuple(hook for hook in used if scenario.hooks[hook].crane == name)
        yield Bearer(name, 1, own, join_path(("cranes", name, "position")), crane.position, is_whole=True)


def why_not(hook: Hook) -> str:
    """Why a hook at a boom cannot be moved, and how else its falls come to hang plumb."""
    path = join_path((*hook.paths[""][:-2], "boom.angle"))
    return (
        f"the hook '{hook.name}' has no place of its own in the lift file that could be moved; fixed hooks "
        "have, by 'at', trolleys and Goliath cranes, by 'position'. 'keep_plumb' in a step of the plan lets "
        f"its boom follow the load, and a sweep of '{path}' shows how it hangs elsewhere"
    )
