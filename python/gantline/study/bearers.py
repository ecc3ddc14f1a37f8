"""What bears hooks and may stand elsewhere: fixed hooks, trolleys, cranes on rails or on tracks."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from gantline.scenario import Scenario
from gantline.scenario.cranes.boom import boom_name
from gantline.scenario.cranes.crane import FixedHook
from gantline.scenario.cranes.crawler import Crawler, along_body
from gantline.scenario.cranes.goliath import Goliath
from gantline.scenario.cranes.hooks import Hook, trolley_name
from gantline.scenario.cranes.slewing import turned_body

__all__ = ["Bearer", "bearers_of", "why_not"]


@dataclass(frozen=True)
class Bearer:
    """A body with a place of its own in the lift file, along one axis of the world.

    Attributes:
        name: Its name, for people.
        body: The body.
        axis: Which axis, 0 or 1.
        hooks: Hooks in use that it takes along.
        path: Dotted path of its place.
        given: That place [m].
        is_whole: Whether it moves only if all its hooks may: a crane, and no trolley.
        turning: Bodies by whose turning its hooks go elsewhere.
        counts_from_it: Whether the plan counts its way `to` a place from there: a crawler crane.
    """

    name: str
    body: str
    axis: int
    hooks: tuple[str, ...]
    path: str
    given: float
    is_whole: bool = False
    turning: tuple[str, ...] = ()
    counts_from_it: bool = False

    def may_move(self, chosen: Sequence[str]) -> bool:
        """Whether it may, if these hooks may."""
        are = [hook in chosen for hook in self.hooks]
        return all(are) if self.is_whole else any(are)


def bearers_of(scenario: Scenario, used: Sequence[str]) -> list[Bearer]:
    """All that bear one of the hooks in use; vessels have no such place."""
    return [one for name in scenario.cranes or {} for one in _of_crane(scenario, name, used) if one.hooks]


def _of_crane(scenario: Scenario, name: str, used: Sequence[str]) -> Iterator[Bearer]:
    crane = (scenario.cranes or {})[name]
    own = tuple(hook for hook in used if scenario.hooks[hook].crane == name)
    if isinstance(crane, FixedHook):
        for axis, letter in enumerate("xy"):
            yield Bearer(name, name, axis, own, f"cranes.{name}.at.{letter}", crane.at[axis])
    elif isinstance(crane, Goliath):
        for trolley, given in crane.trolleys.items():
            those = tuple(f"{name}.{hook}" for hook in given.hooks if f"{name}.{hook}" in used)
            path = f"cranes.{name}.trolleys.{trolley}.position"
            full = trolley_name(name, trolley)
            yield Bearer(full, full, 0, those, path, given.position)
        yield Bearer(name, name, 1, own, f"cranes.{name}.position", crane.position, is_whole=True)
    elif isinstance(crane, Crawler):
        turning = (turned_body(name), boom_name(name))
        for axis, place in enumerate(crane.position):
            path = f"cranes.{name}.position.{axis + 1}"
            yield Bearer(
                name,
                along_body(name),
                axis,
                own,
                path,
                place,
                is_whole=True,
                turning=turning,
                counts_from_it=True,
            )


def why_not(hook: Hook) -> str:
    """Why a hook at a boom that floats cannot be moved, and how else its falls come to hang plumb."""
    return (
        f"the hook '{hook.name}' has no place of its own in the lift file that could be moved, it goes where "
        "its vessel floats. 'keep_plumb' in a step of the plan lets its boom follow the load, and a sweep of "
        f"'cranes.{hook.crane}.boom.angle' shows how it hangs elsewhere"
    )
