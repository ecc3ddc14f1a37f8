"""MoorDyn: a rope as a chain of masses, half of a segment's at either end, by RK4 in steps of one size.

Segments pull T = EA ε where they are stretched; BA ε' of their damper is added, slack or not, where in
gantline the sum is never less than nothing. Water acts on the load alone: the rope is next to no thickness.
Before a run the system comes to rest in water that drags at the rope, and its state is taken over.
"""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.contract import FloatArray
from benchmarks.heaved_lines import DENSITY, GRAVITY, SAMPLE_INTERVAL, TOP, HeavedLine

DIAMETER = 1e-4  # m
DRAGS = 3e5  # coefficient over that diameter: 15 kN s²/m² over 1 m
DRAG_AREA = 500.0  # m², of a load while it comes to rest
RESTS = 200.0  # s
STEP_TO_REST = 2e-4  # s


def document(line: HeavedLine, step: float, *, rests: bool) -> str:
    """The input file; while it rests, with drag on all and no less than 10 ms of damping."""
    top = f"1 Coupled 0 0 {TOP} 0 0 0 0"
    if line.load is None:
        points = f"{top}\n2 Fixed {-line.span} 0 {TOP} 0 0 0 0"
    else:
        volume, added, area = 0.0, 0.0, 0.0
        if line.water is not None:
            volume, area = line.water.volume, line.water.drag_area
            added = line.water.added_mass / (DENSITY * volume)
        area += DRAG_AREA if rests else 0.0
        points = f"{top}\n2 Free 0 0 {TOP - line.drop!r} {line.load} {volume} {area} {added}"
    damping = line.stiffness * line.damping_time
    drag = DRAGS if rests else 0.0
    return f"""\
--------------------- MoorDyn ---------------------------------------------------
{line.name}
----------------------- LINE TYPES ----------------------------------------------
TypeName Diam Mass/m EA BA/-zeta EI Cd Ca CdAx CaAx
(name) (m) (kg/m) (N) (N-s/-) (N-m^2) (-) (-) (-) (-)
rope {DIAMETER} {line.mass} {line.stiffness} {damping} 0 {drag} 0 {drag / 10} 0
----------------------- POINTS --------------------------------------------------
ID Type X Y Z M V CdA CA
(#) (-) (m) (m) (m) (kg) (m^3) (m^2) (-)
{points}
----------------------- LINES ---------------------------------------------------
ID LineType AttachA AttachB UnstrLen NumSegs LineOutputs
(#) (-) (-) (-) (m) (-) (-)
1 rope 1 2 {line.length} {line.segments} -
----------------------- OPTIONS -------------------------------------------------
0 writeLog
1 disableOutput
1 disableOutTime
{step} dtM
RK4 tScheme
{GRAVITY} gravity
{DENSITY} WtrDnsty
1000 WtrDpth
0 TmaxIC
----------------------- OUTPUTS -------------------------------------------------
--------------------- need this line --------------------------------------------
"""


class MoorDyn:
    """A line in MoorDyn, which comes to rest once."""

    def __init__(self, line: HeavedLine) -> None:
        """Comes to rest, and keeps its state."""
        self.line = line
        self.code = import_module("moordyn")
        system = self._system(STEP_TO_REST, rests=True)
        for number in range(round(RESTS)):
            self.code.Step(system, [0.0, 0.0, TOP], [0.0, 0.0, 0.0], float(number), 1.0)
        self.rest = self.code.Serialize(system)
        self.code.Close(system)

    def _system(self, step: float, *, rests: bool) -> Any:
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "line.txt"
            path.write_text(document(self.line, step, rests=rests), encoding="utf-8")
            system = self.code.Create(str(path))
        self.code.SetVerbosity(system, self.code.LEVEL_NONE)
        self.code.Init(system, [0.0, 0.0, TOP], [0.0, 0.0, 0.0])
        return system

    def run(self, step: float) -> FloatArray:
        """Tensions of the first and the last segment (samples, 2) [N] in steps of this size [s].

        Raises:
            RuntimeError: the step is not stable.
        """
        line, code = self.line, self.code
        system = self._system(step, rests=False)
        code.Deserialize(system, self.rest)
        # A call for each step: the end that moves is wrong by the first order of a call, and with calls of
        # 1 ms a peak of the rope that sags by 0.14 %.
        calls = round(line.duration / step)
        every = round(SAMPLE_INTERVAL / step)
        # Simpson's rule within a call, whose velocity is the mean that brings the end to its place.
        velocity = line.velocity(np.arange(2 * calls + 1) * step / 2)
        means = (velocity[:-2:2] + 4 * velocity[1:-1:2] + velocity[2::2]) / 6
        places = np.concatenate([[0.0], np.cumsum(means) * step])
        along = np.array(line.axis, dtype=float)
        start = np.array([0.0, 0.0, TOP])
        rope = code.GetLine(system, 1)
        found = [self._tensions(rope)]
        for number in range(calls):
            here, speed = start + along * places[number], along * means[number]
            code.Step(system, here.tolist(), speed.tolist(), RESTS + number * step, step)
            if (number + 1) % every == 0:
                found.append(self._tensions(rope))
        code.Close(system)
        return np.array(found)

    def _tensions(self, rope: Any) -> Sequence[float]:
        ends = (0, self.line.segments)
        return [float(np.linalg.norm(self.code.GetLineNodeTen(rope, node))) for node in ends]
