"""What a load that hangs looks like to whoever levels it, with its derivatives over what can be changed."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
import numpy.typing as npt

from gantline.results import series
from gantline.results.gear import Sling
from gantline.results.rig import Load
from gantline.results.rotation import axes
from gantline.statics import Equilibrium, Sensitivity, Statics

__all__ = ["Hanging", "Row"]

Floats = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Row:
    """A quantity and its derivatives.

    Attributes:
        value: What it is.
        change: Its derivative over each parameter, shape (parameter,).
        name: What it is, in words.
    """

    value: float
    change: Floats
    name: str

    def minus(self, wanted: float) -> Row:
        """By how much it is more than wanted."""
        return replace(self, value=self.value - wanted)


class Hanging:
    """A load at rest that hangs clear, its slings and hooks.

    Args:
        question: The lift, of which `rest` is the equilibrium found last.
        rest: The equilibrium.
        parameters: What can be changed: kinds and names, see `Sensitivity`.

    Raises:
        RuntimeError: If there are no sensitivities to these parameters.
        ValueError: The same, or a sling has nodes: it does not pull straight from end to end.
    """

    def __init__(
        self, question: Statics, rest: Equilibrium, parameters: Sequence[tuple[str, str]] = ()
    ) -> None:
        self.rest = rest
        self.rig = question.rig
        self.load: Load = self.rig.loads[0]
        routes = {rope["name"]: rope["route"] for rope in question.assembly.document["ropes"]}
        nodes = [sling.name for sling in self.slings if sling.rope not in routes]
        if parameters and nodes:
            raise ValueError(f"{', '.join(nodes)} with distributed weight")
        self._answers: list[Sensitivity] = question.sensitivities(parameters) if parameters else []
        for one in self._answers:
            if not one.is_held:
                raise RuntimeError(f"nothing holds what {one.kind} of {one.name} sets going")
        self._ends = {
            sling.rope: (routes[sling.rope][0]["body"], routes[sling.rope][-1]["body"])
            for sling in self.slings
            if sling.rope in routes
        }

    @cached_property
    def slings(self) -> list[Sling]:
        """Slings that are on and go from one upper end to one lower end."""
        return [sling for sling in series.slings_on(self.rest.recording) if sling.over is None]

    def slopes(self) -> tuple[Row, Row]:
        """By what angle the load's own x axis rises, and its y axis [rad]."""
        return self._slope(0), self._slope(1)

    def heading(self) -> Row:
        """Angle of the load's own x axis from world x, seen from above [rad]."""
        ahead = self._axes[:, 0]
        level = ahead[0] ** 2 + ahead[1] ** 2
        moved = [np.cross(one.of_body(self.load.body)[3:], ahead) for one in self._answers]
        change = [(ahead[0] * way[1] - ahead[1] * way[0]) / level for way in moved]
        return Row(math.atan2(ahead[1], ahead[0]), np.array(change), "heading [rad]")

    def place(self, axis: int) -> Row:
        """Where the load's centre of gravity is along an axis of the world [m]."""
        at = self.rest.recording.column("body_position", self.load.body)[-1]
        change = [one.of_body(self.load.body)[axis] for one in self._answers]
        return Row(float(at[axis]), np.array(change), f"the place along {'xyz'[axis]}")

    def share(self, name: str) -> Row:
        """Vertical force of a sling over that of all that carry the same as it does [1].

        A sling that ends on the load has its share of all that do, one above spreaders or extension
        sheaves of all that hangs in hooks.

        Raises:
            ValueError: If it has none, with the reason.
        """
        sling = next((one for one in self.slings if one.name == name), None)
        if sling is None:
            raise ValueError(f"{name} has no share: it is off then, or runs over an extension sheave")
        pulls = [self._pull(one) for one in self._beside(sling)]
        all_of_them = sum(value[2] for value, _ in pulls)
        all_changes = sum((change[:, 2] for _, change in pulls), start=np.zeros(len(self._answers)))
        value, change = self._pull(sling)
        share = float(value[2] / all_of_them)
        return Row(share, (change[:, 2] - share * all_changes) / all_of_them, f"the share of {name}")

    def _beside(self, sling: Sling) -> list[Sling]:
        """Slings that together carry what one of them carries its share of."""
        if sling.to_load is not None:
            on = series.slings_on(self.rest.recording)
            over = [one.name for one in on if one.over is not None and self.load.name in one.lugs_of]
            if over:
                sentence = f"{', '.join(over)} over extension sheaves bear {self.load.name} too"
                raise ValueError(f"{sling.name} has no share: {sentence}")
            return [one for one in self.slings if one.to_load is not None]
        if self.rig.hook_of(sling) not in self.hooks():
            raise ValueError(f"{sling.name} has no share: it hangs in no hook and ends on no load")
        return [one for one in self.slings if self.rig.hook_of(one) in self.hooks()]

    def side_pull(self, bearer: str, hooks: Sequence[str], axis: int) -> Row:
        """Horizontal over vertical force of what hangs in hooks on their bearer [1], along world x or y.

        Where all slings in them are slack it is none, and nothing acts on it.
        """
        pulls = [self._pull(one) for one in self.slings if self.rig.hook_of(one) in hooks]
        value = sum((value for value, _ in pulls), start=np.zeros(3))
        change = sum((change for _, change in pulls), start=np.zeros((len(self._answers), 3)))
        name = f"the side pull on {bearer} along {'xy'[axis]}"
        if not value.any():
            return Row(0.0, np.zeros(len(self._answers)), name)
        # From the slings on the hook: against the way that a sling goes up.
        return Row(
            -float(value[axis] / value[2]),
            -(change[:, axis] - value[axis] / value[2] * change[:, 2]) / value[2],
            name,
        )

    def pull_on(self, hook: str) -> Floats:
        """Force of what hangs in a hook on it, without its own weight [N], shape (3,)."""
        pulls = [self._pull(one)[0] for one in self.slings if self.rig.hook_of(one) == hook]
        total: Floats = -np.sum(pulls, axis=0)
        return total

    def slack(self) -> list[str]:
        """Slings that are on and carry nothing."""
        on = series.slings_on(self.rest.recording)
        return [sling.name for sling in on if self.rest.tension(sling.rope) <= 0.0]

    def beyond_travel(self) -> str | None:
        """The moving sheave that is farthest beyond its travel, in words; None where none is."""
        worst, sentence = 0.0, None
        for equalizer in self.rig.equalizers:
            for sheave in equalizer.moving_sheaves:
                travel = float(self.rest.recording.column("sheave_travel", sheave)[-1])
                most, way = (equalizer.travel_down, "down") if travel > 0.0 else (equalizer.travel_up, "up")
                # Stops give a little: at the stop is beyond.
                if most is not None and abs(travel) - most > worst - 1e-9:
                    worst = abs(travel) - most
                    sentence = f"{sheave} would travel {abs(travel):.3f} m {way}, and has {most:g} m"
        return sentence

    def hooks(self) -> list[str]:
        """Hooks in which a sling hangs, in the order of the lift."""
        used = {self.rig.hook_of(sling) for sling in self.slings}
        return [hook.name for hook in self.rig.hooks if hook.name in used]

    @cached_property
    def _axes(self) -> Floats:
        found: Floats = axes(self.rest.recording.column("body_orientation", self.load.body)[-1])
        return found

    def _slope(self, axis: int) -> Row:
        own = self._axes[:, axis]
        cosine = math.sqrt(max(1.0 - own[2] ** 2, np.finfo(float).tiny))
        turned = [np.cross(one.of_body(self.load.body)[3:], own)[2] / cosine for one in self._answers]
        return Row(
            math.asin(min(max(own[2], -1.0), 1.0)), np.array(turned), f"the slope along {'xy'[axis]} [rad]"
        )

    def _pull(self, sling: Sling) -> tuple[Floats, Floats]:
        """Force of a sling on its lower end [N], shape (3,), and its derivatives, shape (parameter, 3)."""
        recording = self.rest.recording
        first, last = (one[-1] for one in series.rope_ends(recording, sling.rope))
        length = float(np.linalg.norm(first - last))
        along = (first - last) / length
        tension = self.rest.tension(sling.rope)
        changes = np.zeros((len(self._answers), 3))
        top, bottom = self._ends[sling.rope]
        for row, one in enumerate(self._answers):
            moved = self._velocity(one, top, first) - self._velocity(one, bottom, last)
            across = moved - along * float(along @ moved)
            changes[row] = one.of(sling.rope) * along + tension / length * across
        return tension * along, changes

    def _velocity(self, one: Sensitivity, body: str | None, point: Floats) -> Floats:
        """How a point of a body moves."""
        if body is None:
            return np.zeros(3)
        motion = one.of_body(body)
        arm = point - self.rest.recording.column("body_position", body)[-1]
        moved: Floats = motion[:3] + np.cross(motion[3:], arm)
        return moved
