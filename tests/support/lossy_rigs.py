"""Weights, drums and tackles over sheaves with losses, as the core's documents."""

from __future__ import annotations

import math
from dataclasses import dataclass

from mechanics import Json, body, document, drum, end, flow, half_turn, rope, slider

#: [N]; a rope under 10 kN then has a strain of 1e-6, and the ratio of tensions at a sheave is ρ to 1e-7.
STIFF = 1e10
#: [s]; stretch of the stiff ropes dies out with this time, so that 100 times as long leaves nothing of it.
DAMPING_TIME = 0.01


def atwood(light: float, heavy: float, inertia: float, *, ratio: float = 1.0, ea: float = 1e9) -> Json:
    """Two weights [kg] over a held sheave of I/r² = `inertia` [kg]."""
    bodies = [
        body("light", slider(), light, position=(-0.5, 0, 5)),
        body("heavy", slider(), heavy, position=(0.5, 0, 5)),
        flow("sheave", inertia),
    ]
    over = half_turn(None, (0, 0, 10), 0.5, over=True, flow="sheave", ratio=ratio)
    return document(bodies, ropes=[rope("r", None, [end("light"), over, end("heavy")], ea, DAMPING_TIME)])


MU = 0.1
CAPSTAN = math.exp(MU * math.pi)


def hauled(ratio: float, ea: float, damping_time: float, ramp: Json, inertia: float = 10.0) -> Json:
    """1 t on a rope over one held sheave to a drum, which pays out as `ramp` says."""
    bodies = [
        body("weight", slider(), 1000.0, position=(-0.5, 0, 0)),
        flow("sheave", inertia),
        flow("winch", 10.0, drive="winch"),
    ]
    over = half_turn(None, (0, 0, 10), 0.5, over=True, flow="sheave", ratio=ratio)
    line = rope("r", None, [end("weight"), over, drum(None, (0.5, 0, 0), "winch")], ea, damping_time)
    return document(bodies, ropes=[line], drives=[{"name": "winch", "ramps": [ramp]}])


@dataclass(frozen=True)
class Reeving:
    """A guided load under plumb parts of one rope: dead end, `sheaves` in turn on load and world, drum."""

    name: str
    sheaves: int
    mass: float
    ratio: float
    first_on_load: bool
    inertia: float = 10.0

    @property
    def crossings(self) -> list[str]:
        return [f"{self.name}.{place}" for place in range(self.sheaves)]

    def parts(self, speed: float) -> tuple[list[Json], Json, Json]:
        """Bodies, rope and drive; the drum hauls in with `speed` [m/s], or pays out if that is negative."""
        radius, height = 0.2, 10.0
        winch = f"{self.name}.winch"
        bodies = [body(self.name, slider(), self.mass), flow(winch, 100.0, drive=winch)]
        on_load = self.first_on_load
        route = [end(None, (0, 0, height)) if on_load else end(self.name)]
        for place, name in enumerate(self.crossings):
            centre = (radius * (2 * place + 1), 0.0, 0.0 if on_load else height)
            body_name = self.name if on_load else None
            guide = half_turn(body_name, centre, radius, not on_load, flow=name, ratio=self.ratio)
            route.append(guide)
            bodies.append(flow(name, self.inertia))
            on_load = not on_load
        drum_height = height if on_load is False else 0.0
        route.append(drum(None, (2 * radius * self.sheaves, 0, drum_height), winch))
        ramp = {"at": 0.0, "duration": 0.3, "velocity": -speed, "shape": "smooth"}
        return bodies, rope(self.name, None, route, STIFF, DAMPING_TIME), {"name": winch, "ramps": [ramp]}


LARGE, SMALL = 0.30, 0.28
WINDLASS = (LARGE - SMALL) / (2 * LARGE)


RAMP = {"at": 0.0, "duration": 0.5, "velocity": -0.3, "shape": "smooth"}


def windlass(**shaft: float | str) -> Json:
    """A load in the bight of a rope between two drums of one shaft; the flow counts at the large one."""
    bodies = [body("load", slider(), 3000.0, position=(0, 0, 0)), flow("shaft", 50.0, **shaft)]
    route = [
        drum(None, (-0.29, 0, 10), "shaft", 1.0),
        half_turn("load", (0, 0, 0), 0.29, over=False),
        drum(None, (0.29, 0, 10), "shaft", -SMALL / LARGE),
    ]
    drives = [{"name": shaft["drive"], "ramps": [RAMP]}] if "drive" in shaft else []
    return document(bodies, ropes=[rope("r", None, route, STIFF, DAMPING_TIME)], drives=drives)


#: Of a sheave with a groove that slips [kg]: rope on it, and I/r² of what turns.
ON_SHEAVE, SPINNING = 3.0, 400.0


def spun(masses: tuple[float, float], speed: float, friction: float, ratio: float = 1.0) -> Json:
    """Two weights over a heavy sheave at rest, the rope moving towards the second at `speed` [m/s]."""
    light, heavy = masses
    bodies = [
        body("light", slider(velocity=speed), light, position=(-0.5, 0, 3)),
        body("heavy", slider(velocity=-speed), heavy, position=(0.5, 0, 3)),
        flow("over", ON_SHEAVE, velocity=speed),
        flow("spin", SPINNING),
    ]
    groove = {"friction": friction, "spin": "spin"}
    over = half_turn(None, (0, 0, 10), 0.5, over=True, flow="over", ratio=ratio, groove=groove)
    return document(bodies, ropes=[rope("r", None, [end("light"), over, end("heavy")], 1e9, DAMPING_TIME)])
