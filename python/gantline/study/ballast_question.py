"""What is asked for where contents of tanks are: the vessel, its tanks, the moment, a draft that can be.

What cannot be is a `QuestionError` with a sentence, that says which of the arguments it is about.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from gantline.arguments import number
from gantline.assembly.afloat.hulls import hull_mesh
from gantline.scenario import Scenario
from gantline.scenario.afloat.tanks import bodies_afloat
from gantline.scenario.cranes.hooks import full_name
from gantline.scenario.errors import nearest
from gantline.statics import Statics
from gantline.study.asked import names_of
from gantline.study.moment import end_of_step

__all__ = ["QuestionError", "moment_of", "refuse_draft", "tanks_that_may_change", "vessel_of"]


class QuestionError(ValueError):
    """What is asked for cannot be; the message is a plain sentence.

    Attributes:
        argument: Of `solve_ballast`, that has to be another.
    """

    def __init__(self, argument: str, sentence: str) -> None:
        super().__init__(sentence)
        self.argument = argument

    def __reduce__(self) -> tuple[Any, ...]:
        """For pickle: an error of a process that works for another one arrives there whole."""
        return type(self), (self.argument, str(self))


def vessel_of(scenario: Scenario, name: str | None) -> str:
    """The vessel of a name; without one that which alone has tanks.

    Raises:
        QuestionError: If there is no such vessel with tanks, or not one alone; it says which there are.
        ValueError: If no vessel has tanks.
    """
    afloat = bodies_afloat(scenario)
    fitting = [one for one, body in afloat.items() if body.floats_freely and body.tanks]
    moved = [one for one, body in afloat.items() if body.is_carried and name in (one, None)]
    if (moved and not fitting) or name in moved:
        sentence = "moves by its 'wave_motion', whatever its tanks hold"
        raise ValueError(f"{moved[0]} {sentence}; with 'masses' and 'tanks' in its place it floats")
    if name is not None:
        if name not in fitting:
            raise QuestionError(
                "vessel", f"'{name}' is not a vessel with tanks; {nearest(str(name), fitting)}"
            )
        return name
    if not fitting:
        raise ValueError("no vessel with tanks floats in this lift; give one 'tanks'")
    if len(fitting) > 1:
        raise QuestionError("vessel", f"{', '.join(fitting)} have tanks; say which of them is meant")
    return fitting[0]


def tanks_that_may_change(scenario: Scenario, vessel: str, tanks: Sequence[str] | None) -> list[str]:
    """Names of the tanks that may change, as the vessel has them.

    Raises:
        QuestionError: If one of them is no tank of the vessel, or none is left.
    """
    own = bodies_afloat(scenario)[vessel].tanks or {}
    closed = [name for name, tank in own.items() if not tank.holes]
    if tanks is None:
        if own and not closed:
            raise QuestionError("tanks", f"all tanks of {vessel} have holes, so that no content stays")
        return closed
    known = {f"{vessel}.{tank}": tank for tank in own}
    found = []
    for text in names_of("tanks", tanks):
        full = full_name(text, known)
        if full is None:
            raise QuestionError("tanks", f"'{text}' is not a tank of {vessel}; {nearest(text, own)}")
        if own[known[full]].holes:
            raise QuestionError("tanks", f"{full} has holes, so that its content does not stay; leave it out")
        found.append(known[full])
    if not found:
        raise QuestionError("tanks", "no tank may change; name one at least")
    return list(dict.fromkeys(found))


def refuse_draft(scenario: Scenario, vessel: str, draft: float) -> None:
    """Refuse a draft [m] with which the keel would be out of the water, or the deck under it.

    Raises:
        QuestionError: If it is one.
    """
    hull = hull_mesh(scenario, vessel, bodies_afloat(scenario)[vessel])
    assert hull is not None  # it floats
    keel, deck = hull.box[:, 2]
    if not keel < draft < deck:
        sentence = f"a draft of {draft:g} m is not between the keel of {vessel} at {keel:g} m and its deck"
        raise QuestionError("draft", f"{sentence} at {deck:g} m; it floats with its deck dry")


def moment_of(question: Statics, time: float | None, step: str | None) -> float:
    """The moment of a lift that is meant [s]: a time, the end of a step, or the end of the lift.

    Raises:
        QuestionError: If that is not in the lift, or both are given.
    """
    scenario = question.scenario
    if step is None:
        moment = scenario.duration if time is None else time
        if not 0.0 <= number(moment, "time", "seconds") <= scenario.duration:
            raise QuestionError(
                "time", f"{moment:g} s is not in the lift, which lasts {scenario.duration:g} s"
            )
        return moment
    if time is not None:
        raise QuestionError("step", "a time and a step are given; one of them says when")
    steps = [one.step for one in scenario.plan]
    if step not in steps:
        raise QuestionError("step", f"'{step}' is not a step of the plan; {nearest(step, steps)}")
    end = end_of_step(question, step)
    if end is None:
        raise QuestionError("step", f"'{step}' does not begin within the {scenario.duration:g} s of the lift")
    return end
