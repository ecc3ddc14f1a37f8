"""The other codes find where a lift comes to rest, from just-taut slings, each by the way that suits it best.

- MuJoCo has no static solver: the lift is simulated with damping until it rests, with steps with which it
  follows the lift within about 1 %, rms or peak, in the race. Its recommended integrator, `implicitfast`, and
  `discrete`, which takes springs implicitly. Both bear longer steps, with which they no longer follow how the
  lift settles but find where: up to a second, when a step of `discrete` is nearly one of Newton's method.
- Exudyn has a static solver, Newton's method in load steps, with a term that stabilises what nothing holds.
- OpenSim has none for this (its equilibrium solvers are for muscles): simulated with damping by CPODES.

Damping is in proportion to the mass of the load and acts on all its motions. What it, the step, and the end
of the run are for a lift was searched for, the fastest that is right; that search is not timed.
"""

from __future__ import annotations

from collections.abc import Sequence
from importlib import import_module
from typing import Any, Protocol

import numpy as np

from benchmarks.contract import Code, FloatArray, Run, Setting, Unfit
from benchmarks.lifts import Lift
from benchmarks.peers import opensim
from benchmarks.peers.exudyn import Exudyn, Model, Reeving, Sum
from benchmarks.peers.mujoco import MuJoCo, build
from benchmarks.peers.opensim import OpenSim

ITERATIONS = 100
"""Newton's, at most, in a load step of Exudyn."""


def damping(lift: Lift, rate: float) -> list[float]:
    """Of the load's translations [N s/m] and rotations [N m s/rad] at a rate [1/s]."""
    return [rate * lift.load_mass] * 3 + [rate * inertia for inertia in lift.load_inertia]


def numbers(setting: Setting) -> list[float]:
    """What a method says behind its name."""
    return [float(word) for word in setting.method.split(",")[0].split()[1:]]


class MuJoCoToRest:
    """Steps without any recording."""

    def __init__(self, lift: Lift, integrator: str, nested: bool, setting: Setting) -> None:
        mujoco = import_module("mujoco")
        step, rate = numbers(setting)
        self._mujoco = mujoco
        self._model = build(lift, integrator, 1e-3 * step, nested)
        (free,) = np.flatnonzero(self._model.jnt_type == mujoco.mjtJoint.mjJNT_FREE)
        first = int(self._model.jnt_dofadr[free])
        self._model.dof_damping[first : first + 6] += damping(lift, rate)
        self._data = mujoco.MjData(self._model)
        self._steps = round(setting.value / (1e-3 * step))

    def integrate(self) -> None:
        """All steps."""
        self._mujoco.mj_step(self._model, self._data, nstep=self._steps)
        if any(warning.number for warning in self._data.warning):
            raise Unfit("the motion became unstable")

    def tensions(self) -> FloatArray:
        """Of all slings at the end, (1, sling) [N]."""
        return -np.array(self._data.sensordata)[None]


MUJOCO_WAYS: dict[tuple[str, bool, bool], tuple[tuple[float, float, tuple[float, ...]], ...]] = {
    ("implicitfast", False, True): ((1.6, 5, (10, 12, 14)), (1.6, 8, (10, 12))),
    ("implicitfast", True, True): ((10, 3, (10, 12, 14)), (10, 5, (10, 11, 12))),
    ("implicitfast", True, False): ((12.5, 3, (10, 12, 14)), (15, 3, (10, 12, 14))),
    ("discrete", False, True): ((2.5, 5, (10, 11, 12)), (2.5, 8, (9, 10, 11))),
    ("discrete", False, False): ((20, 5, (10, 11, 12)), (500, 2, (15, 20, 25)), (1000, 5, (20, 25, 30))),
}
"""Step [ms], damping [1/s] and ends [s] by integrator, nesting of sheaves and whether it follows the lift."""


class AtRest(Code, Protocol):
    """A way to the rest of a lift."""

    settles: bool
    """Whether it simulates how the lift settles, step by step; else it solves for where."""


class MuJoCoAtRest(MuJoCo):
    """The value of a setting is the end of the run [s]; the method has step [ms] and damping [1/s]."""

    def __init__(self, integrator: str, nested: bool = False, settles: bool = True) -> None:
        super().__init__(nested)
        self.name = f"{self.name}, {integrator}{'' if settles else ', long steps'}"
        self._integrator, self._is_nested, self.settles = integrator, nested, settles

    def settings(self, lift: Lift) -> Sequence[Setting]:
        """Steps and dampings about the best."""
        return [
            Setting(f"{self._integrator} {step} {rate}, until [s]", end)
            for step, rate, ends in MUJOCO_WAYS[self._integrator, self._is_nested, self.settles]
            for end in ends
        ]

    def prepare(self, lift: Lift, setting: Setting, duration: float) -> Run:  # type: ignore[override]
        """The model at its start."""
        return MuJoCoToRest(lift, self._integrator, self._is_nested, setting)


class ExudynToRest:
    """One call of the static solver."""

    def __init__(self, model: Model, setting: Setting) -> None:
        self._model = model
        model.system.Assemble()
        (stabilizer,) = numbers(setting)
        settings = model.exu.SimulationSettings()
        static = settings.staticSolver
        static.numberOfLoadSteps = round(setting.value)
        static.stabilizerODE2term = stabilizer
        static.verboseMode = 0
        static.newton.relativeTolerance = 1e-6
        static.newton.absoluteTolerance = 1e-4
        static.newton.maxIterations = ITERATIONS
        settings.linearSolver.solverType = model.exu.LinearSolverType.EigenSparse
        settings.parallel.numberOfThreads = 1
        settings.solution.file.write = False
        self._settings = settings

    def integrate(self) -> None:
        """Solve."""
        try:
            self._model.system.SolveStatic(self._settings, showHints=False)
        except Exception as error:
            raise Unfit(str(error).splitlines()[0] if str(error) else "the solver failed") from error

    def tensions(self) -> FloatArray:
        """Of all slings at the end, (1, sling) [N]."""
        read = self._model.system.GetSensorStoredData
        return np.array([[max(0.0, float(read(sensor)[-1, 1])) for sensor in self._model.sensors]])


class ExudynAtRest(Exudyn):
    """The value of a setting is the number of load steps; the method has the stabilising term."""

    settles = False

    def __init__(self, reeving: bool) -> None:
        super().__init__(reeving)
        self.name = f"{self.name}, static solver"
        self._kind: type[Model] = Reeving if reeving else Sum

    def settings(self, lift: Lift) -> Sequence[Setting]:
        """Few load steps, terms about the best."""
        return [
            Setting(f"SolveStatic {term}, load steps", steps)
            for steps in (2, 3, 5, 10)
            for term in (0.1, 1, 10)
        ]

    def prepare(self, lift: Lift, setting: Setting, duration: float) -> Run:  # type: ignore[override]
        """The assembled model."""
        return ExudynToRest(self._kind(lift), setting)


class OpenSimToRest:
    """One integration."""

    def __init__(self, lift: Lift, setting: Setting) -> None:
        osim = import_module("opensim")
        osim.Logger.setLevelString("Error")
        accuracy, rate = numbers(setting)
        self._model, slings = opensim.build(lift, path_through_points=False)
        joint = self._model.getJointSet().get("free")
        translations, rotations = damping(lift, rate)[:3], damping(lift, rate)[3:]
        for index, viscosity in enumerate([*rotations, *translations]):
            damper = osim.SpringGeneralizedForce(joint.get_coordinates(index).getName())
            damper.setName(f"damper{index}")
            damper.setStiffness(0)
            damper.setViscosity(viscosity)
            self._model.addForce(damper)
        self._end = setting.value
        self._reporter = osim.TableReporter()
        self._reporter.setName("tensions")
        self._reporter.set_report_time_interval(self._end)
        for sling in slings:
            self._reporter.addToReport(sling.getOutput("force_magnitude"), sling.getName())
        self._model.addComponent(self._reporter)
        self._manager = opensim.manager_of(self._model, "CPodes", accuracy)

    def integrate(self) -> None:
        """To the end."""
        try:
            self._manager.integrate(self._end)
        except RuntimeError as error:
            raise Unfit(str(error).splitlines()[0]) from error

    def tensions(self) -> FloatArray:
        """Of all slings at the end, (1, sling) [N]."""
        values: Any = self._reporter.getTable().getMatrix().to_numpy()
        return np.array(values[-1:], dtype=np.float64)


class OpenSimAtRest(OpenSim):
    """The value of a setting is the end of the run [s]; the method has accuracy and damping [1/s]."""

    name = "OpenSim, damped"
    settles = True

    def settings(self, lift: Lift) -> Sequence[Setting]:
        """Accuracies and dampings about the best."""
        return [
            Setting(f"CPodes {accuracy} {rate}, until [s]", end)
            for accuracy in (1e-2, 1e-4, 1e-6)
            for rate in (3, 5)
            for end in (10, 15, 20)
        ]

    def prepare(self, lift: Lift, setting: Setting, duration: float) -> Run:  # type: ignore[override]
        """The model at its start."""
        return OpenSimToRest(lift, setting)


AT_REST: tuple[AtRest, ...] = (
    MuJoCoAtRest("implicitfast"),
    MuJoCoAtRest("implicitfast", nested=True),
    MuJoCoAtRest("discrete"),
    MuJoCoAtRest("implicitfast", nested=True, settles=False),
    MuJoCoAtRest("discrete", settles=False),
    ExudynAtRest(reeving=True),
    ExudynAtRest(reeving=False),
    OpenSimAtRest(),
)
"""All ways to the rest of a lift."""
