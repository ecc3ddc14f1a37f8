"""How a lift hangs at the end of every step of its plan."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from gantline.arguments import needed
from gantline.scenario.plan.steps import PumpStep
from gantline.statics import Losses, Statics
from gantline.statics.inclining import MetacentricHeights, metacentric_heights
from gantline.study.standing import AsHeld, least_heights
from gantline.study.state import State, settled

__all__ = ["END", "START", "StepAtRest", "run_steps"]

#: What the moments are called at which no step ends.
START, END = "start", "end of the lift"
#: Keys of a step by which something is otherwise from its beginning on, but for drives.
_AS_IT_BEGINS = ("cut", "detach", "attach", "remove_supports", "pull_pins", "put_in_pins", "open_hinges")
#: How much earlier a step is looked at that ends at a given time, as another one begins, which must not have
#: begun [s]. Where one waited for something the other has not begun at that very moment.
_EARLIER = 1e-9
#: Shares of a step that pumps at which it is asked what rights vessels: a surface comes, is half way up or as
#: high as it gets.
_SHARES = (0.02, 0.5, 0.98)
#: What is told of a vessel: variables less their first word.
_OF_VESSELS = ("displacement", "draft_aft", "draft_forward", "heel", "trim", "freeboard")


@dataclass(frozen=True)
class StepAtRest:
    """A lift at rest at a moment of its plan.

    Attributes:
        steps: The steps that end then; none at the start, at the end of a lift that ends in between, and
            within a step.
        name: These steps in one word, or what the moment is called.
        state: How the lift hangs then.
        heights: What rights its vessels then, by their names; empty without equilibrium.
        held: The same with what stands on them held by friction, where it was found without; else empty.
    """

    steps: tuple[str, ...]
    name: str
    state: State
    heights: dict[str, MetacentricHeights]
    held: dict[str, MetacentricHeights] = field(default_factory=dict)

    @property
    def gm(self) -> dict[str, tuple[float, float]]:
        """GM of its vessels for heel and trim, the least with friction and without [m]."""
        return least_heights(self.heights, self.held)

    def to_json(self) -> dict[str, Any]:
        """All of it as a JSON object, SI units; a metacentric height that is infinite is null."""
        rest = self.state.rest
        vessels = {
            name: {
                **{key: float(rest.recording.column(f"vessel_{key}", name)[-1]) for key in _OF_VESSELS},
                "gm_transverse": _finite(transverse),
                "gm_longitudinal": _finite(longitudinal),
            }
            for name, (transverse, longitudinal) in self.gm.items()
            if rest is not None
        }
        return {"steps": list(self.steps), **self.state.to_json(), "vessels": vessels}


def run_steps(question: Statics, losses: Losses = "none", *, pumping: bool = False) -> Iterator[StepAtRest]:
    """Statics of a lift at its start, where each step of its plan ends, and at its end.

    What a step requires is among the checks where it ends. GM may be less while a step pumps than where it
    begins and ends, its tank being slack in between.

    Args:
        question: The lift. When steps end that wait for something is found from rest to rest.
        losses: What friction does, see `Statics.equilibrium`.
        pumping: Whether moments are among them at which a step pumps, and GM of a vessel is less than at the
            moments before and after.

    Yields:
        The lift at each of these moments, in order, as soon as it is found; of one that has no equilibrium
        at its end, those of the steps that have ended before.

    Raises:
        TypeError: If it is asked of a lift file; `Statics` is made of one.
    """
    needed(question, Statics, "a lift to ask for equilibria", "gantline.Statics(lift) is one")
    asked = State("", "", losses, 0.0)
    settled(question, None, asked)
    duration = question.scenario.duration
    ended: dict[float, list[str]] = {}
    changing: dict[float, list[str]] = {}
    within: dict[float, str] = {}
    for step in question.scenario.plan:
        begin, end = question.times_of(step.step)
        if end is not None:
            ended.setdefault(end, []).append(step.step)
        if begin is not None and any(getattr(step, key) for key in _AS_IT_BEGINS):
            changing.setdefault(begin, []).append(step.step)
        if pumping and isinstance(step, PumpStep) and begin is not None and end is not None:
            for share in _SHARES:
                within[begin + share * (end - begin)] = f"{step.step} at {100.0 * share:.0f} %"
    as_held = AsHeld(question)
    kept: list[StepAtRest] = []
    last: StepAtRest | None = None
    for moment in sorted({0.0, duration, *ended} | within.keys()):
        steps = tuple(ended.get(moment, ()))
        is_within = moment in within and not steps
        state = _ended(question, moment, asked, steps, changing.get(moment, ()))
        rest = state.rest
        heights = {} if rest is None else metacentric_heights(question, rest, at_level=is_within)
        name = within[moment] if is_within else ", ".join(steps) or (END if moment > 0.0 else START)
        held = {} if rest is None else as_held.heights(rest, moment, steps, at_level=is_within)
        one = StepAtRest(steps, name, state, heights, held)
        if is_within:
            kept.append(one)
            continue
        yield from (between for between in kept if last is None or _is_less(between, last, one))
        yield one
        kept, last = [], one


def _is_less(between: StepAtRest, *others: StepAtRest) -> bool:
    """Whether GM of a vessel for heel is less than at other moments, or nothing rests there."""
    known = [one.gm for one in others if one.heights]
    return between.state.rest is None or any(
        transverse < min((one[name][0] for one in known), default=math.inf)
        for name, (transverse, _) in between.gm.items()
    )


def _ended(
    question: Statics, moment: float, asked: State, steps: Sequence[str], changing: Sequence[str]
) -> State:
    """A lift as steps end, without what others, `changing`, do to it as they begin at that moment [s]."""
    state = settled(question, moment, asked, steps)
    if steps and any(question.times_of(name)[0] is not None for name in changing):
        return replace(settled(question, moment - _EARLIER, asked, steps), time=moment)
    return state


def _finite(number: float) -> float | None:
    return number if math.isfinite(number) else None
