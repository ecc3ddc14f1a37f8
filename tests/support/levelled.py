"""A rigid load on slings of which some hold a chain hoist, as a lift file and as equations of its own.

Each sling hangs from a hook of its own that stays where it is, straight, with the tension EA (ℓ − L)/L, ℓ the
distance of its ends and L its unstretched length. A chain hoist takes rope along as it is, stretched:
dL = ds/(1 + ε), s what it has paid out.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from scipy.spatial.transform import Rotation

Floats = npt.NDArray[np.float64]

G = 9.81
EA = 60e6


@dataclass(frozen=True)
class Leg:
    """A sling: its hook [m], its lug from the middle of the load's bottom [m], L at the start [m], whether it
    holds a chain hoist."""

    hook: tuple[float, float, float]
    lug: tuple[float, float, float]
    length: float
    hoist: bool = False


@dataclass(frozen=True)
class Levelled:
    """A load of a mass [kg] with its centre of gravity from the middle of its bottom [m], and its slings."""

    mass: float
    centre: tuple[float, float, float]
    legs: Mapping[str, Leg]

    def text(self, plan: str, *, duration: float, more: str = "", hoist: str = "") -> str:
        """The lift file; `hoist` is what each chain hoist says beside its speed."""
        cranes = "\n".join(
            f"  h{name}: {{type: fixed_hook, at: [{_metres(leg.hook)}], "
            "hoist: {speed: 3 m/min, acceleration: 0.05 m/s^2}}"
            for name, leg in self.legs.items()
        )
        lugs = "\n".join(f"    {name}: {{at: [{_metres(leg.lug)}]}}" for name, leg in self.legs.items())
        chain = f", chain_hoist: {{speed: 2 m/min{hoist}}}"
        slings = "\n".join(
            f"  {name}: {{from: h{name}, to: module.{name}, length: {leg.length!r} m{chain * leg.hoist}}}"
            for name, leg in self.legs.items()
        )
        return f"""\
format: 1
lift: {{title: A module on chain hoists}}
duration: {duration!r} s
{more}ropes:
  sling_60: {{axial_stiffness: {EA / 1e6!r} MN, damping_time: 0.2 s, mass: none}}
cranes:
{cranes}
load:
  name: module
  shape: {{box: [12 m, 10 m, 4 m]}}
  weight: {{calculated: {self.mass!r} kg}}
  centre_of_gravity: {{at: [{_metres(self.centre)}]}}
  lugs:
{lugs}
  position: [0 m, 0 m, 0 m]
sling_defaults: {{rope: sling_60}}
slings:
{slings}
plan:
{plan}
"""

    def at_rest(
        self, lengths: Mapping[str, float] | None = None, stiffer: Mapping[str, float] | None = None
    ) -> tuple[dict[str, float], Floats]:
        """Tensions [N] by six equations of balance, and how far the load has gone and turned [m, rad].

        Args:
            lengths: L of slings that are not as at the start [m].
            stiffer: How many times EA slings have that are stiffer [1].
        """
        length = np.array([(lengths or {}).get(name, leg.length) for name, leg in self.legs.items()])
        stiff = EA * np.array([(stiffer or {}).get(name, 1.0) for name in self.legs])
        hooks = np.array([leg.hook for leg in self.legs.values()])
        levers = np.array([leg.lug for leg in self.legs.values()]) - np.array(self.centre)
        weight, size = self.mass * G, 3.0

        def pulls(place: Floats) -> tuple[Floats, Floats, Floats]:
            turned = Rotation.from_rotvec(place[3:]).apply(levers)
            way = hooks - (np.array(self.centre) + place[:3] + turned)
            span = np.linalg.norm(way, axis=1)
            tension = stiff * np.maximum(span / length - 1.0, 0.0)
            return tension, way / span[:, None], turned

        def unbalanced(place: Floats) -> Floats:
            """Force and moment over the weight [1]."""
            tension, up, turned = pulls(place)
            force = (tension[:, None] * up).sum(axis=0) - [0.0, 0.0, weight]
            moment = np.cross(turned, tension[:, None] * up).sum(axis=0)
            return np.concatenate([force, moment / size]) / weight

        first = np.zeros(6)
        # As if its slings were plumb, and pulled alike.
        up = [leg.hook[2] - leg.lug[2] - leg.length for leg in self.legs.values()]
        first[2] = np.mean(up) - weight / len(length) / EA * np.mean(length)
        place = first
        for _ in range(50):
            wrong = unbalanced(place)
            slope = np.array([unbalanced(place + one) - wrong for one in 1e-7 * np.eye(6)]).T / 1e-7
            # By least squares: a bar on two slings turns about itself with nothing against it.
            place = place - np.linalg.lstsq(slope, wrong, rcond=1e-9)[0]
            if np.abs(wrong).max() < 1e-13:
                break
        assert np.abs(unbalanced(place)).max() < 1e-12
        return dict(zip(self.legs, pulls(place)[0], strict=True)), place

    def hauled(self, ways: Mapping[str, float], parts: int = 40) -> dict[str, float]:
        """L of slings after their chain hoists have paid out so much side by side [m], by Runge and Kutta."""

        def rate(now: Mapping[str, float]) -> dict[str, float]:
            tensions, _ = self.at_rest(now)
            return {name: way / (1.0 + tensions[name] / EA) for name, way in ways.items()}

        now = {name: self.legs[name].length for name in ways}
        for _ in range(parts):
            step = 1.0 / parts
            one = rate(now)
            two = rate({name: now[name] + 0.5 * step * one[name] for name in ways})
            three = rate({name: now[name] + 0.5 * step * two[name] for name in ways})
            four = rate({name: now[name] + step * three[name] for name in ways})
            now = {
                name: now[name] + step / 6 * (one[name] + 2 * two[name] + 2 * three[name] + four[name])
                for name in ways
            }
        return now


def _metres(place: tuple[float, float, float]) -> str:
    return ", ".join(f"{part!r} m" for part in place)


#: 90 t on two plumb slings 8 m apart, its centre of gravity 1 m off; one holds a chain hoist.
TWO = Levelled(
    90e3,
    (1.0, 0.0, 2.0),
    {
        "A": Leg((-4.0, 0.0, 14.0), (-4.0, 0.0, 4.0), 9.98),
        "B": Leg((4.0, 0.0, 14.0), (4.0, 0.0, 4.0), 9.98, True),
    },
)
#: 180 t on four plumb slings at the corners of a square of 6 m; one holds a chain hoist.
FOUR = Levelled(
    180e3,
    (0.0, 0.0, 2.0),
    {
        name: Leg((x, y, 14.0), (x, y, 4.0), 9.97, name == "C")
        for name, x, y in (("A", -3.0, -3.0), ("B", 3.0, -3.0), ("C", 3.0, 3.0), ("D", -3.0, 3.0))
    },
)
#: 180 t on four slings of one hook's height, aslant, its centre of gravity 1.2 m off; two hold chain hoists.
ASLANT = Levelled(
    180e3,
    (1.2, 0.3, 2.0),
    {
        name: Leg((0.4 * x, 0.4 * y, 11.5), (x, y, 4.0), 7.8, x > 0)
        for name, x, y in (("A", -3.0, -2.0), ("B", 3.0, -2.0), ("C", 3.0, 2.0), ("D", -3.0, 2.0))
    },
)
