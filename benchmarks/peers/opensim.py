"""OpenSim (Simbody): ropes as forces with an expression, adaptive implicit integration by CPODES.

A sling is an ExpressionBasedPointToPointForce. The equalizing rope is an ExpressionBasedPathForce whose path
is a function of the sheaves' coordinates, since all its parts are vertical; this is faster than a path
through points. Both carry max(0, k e + k τ ė). A TableReporter records at the sampling interval, for which
Simbody interpolates. CPODES builds a dense Jacobian, so cost grows fast with the number of sheaves; explicit
methods (RungeKuttaMerson) are held to steps of about 1 ms and cost more.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from importlib import import_module
from typing import Any

import numpy as np

from benchmarks.contract import SAMPLE_INTERVAL, FloatArray, Setting, Unfit, sample_count
from benchmarks.lifts import RADIUS, Lift

INERTIA = 1e-3  # kg m², of a sheave
INTEGRATORS = ("CPodes", "RungeKuttaMerson", "RungeKutta3")
MANY_STEPS = 10**8


def build(lift: Lift, path_through_points: bool) -> tuple[Any, list[Any]]:
    """The model and the forces of its slings."""
    osim = import_module("opensim")
    zero = osim.Vec3(0)
    model = osim.Model()
    model.setGravity(osim.Vec3(0, 0, -lift.gravity))
    ground = model.getGround()
    frame = _body(model, "frame", lift.frame_mass, [lift.frame_inertia] * 3)
    hinge = osim.PinJoint("hinge", ground, osim.Vec3(0, 0, lift.axle_height), zero, frame, zero, zero)
    hinge.updCoordinate().setName("yaw")
    model.addJoint(hinge)
    damper = osim.SpringGeneralizedForce("yaw")
    damper.setName("yaw_damper")
    damper.setStiffness(0)
    damper.setViscosity(lift.yaw_damping)
    model.addForce(damper)
    load = _body(model, "load", lift.load_mass, lift.load_inertia)
    free = osim.FreeJoint("free", ground, load)
    model.addJoint(free)
    free.upd_coordinates(5).setDefaultValue(lift.load_height)
    sheaves, slings = [], []
    downwards = osim.Vec3(0, math.pi / 2, 0)  # a slider moves along the x of its joint frames
    for i, x in enumerate(lift.sheave_x):
        sheave = _body(model, f"sheave{i}", lift.sheave_mass, [INERTIA] * 3)
        place = osim.Vec3(x, 0, -lift.start_drop)
        slider = osim.SliderJoint(f"guide{i}", frame, place, downwards, sheave, zero, downwards)
        slider.updCoordinate().setName(f"drop{i}")
        model.addJoint(slider)
        sheaves.append(sheave)
        slings.append(_sling(lift, i))
        model.addForce(slings[-1])
    model.addForce(_equalizing_rope(lift, frame, sheaves, path_through_points))
    return model, slings


def _body(model: Any, name: str, mass: float, inertia: Sequence[float]) -> Any:
    osim = import_module("opensim")
    body = osim.Body(name, mass, osim.Vec3(0), osim.Inertia(*inertia))
    model.addBody(body)
    return body


def _law(stiffness: float, damping_time: float, stretch: str, rate: str) -> str:
    return f"max(0,{stiffness!r}*({stretch})+{stiffness * damping_time!r}*{rate})"


def _sling(lift: Lift, i: int) -> Any:
    osim = import_module("opensim")
    sling = osim.ExpressionBasedPointToPointForce()
    sling.setName(f"sling{i}")
    sling.set_body1(f"/bodyset/sheave{i}")
    sling.set_body2("/bodyset/load")
    sling.set_point1(osim.Vec3(0))
    sling.set_point2(osim.Vec3(*lift.lugs[i], lift.load_box[2] / 2))
    stretch = f"d-{lift.sling_lengths[i]!r}"
    sling.setExpression(_law(lift.sling_stiffness[i], lift.damping_time, stretch, "ddot"))
    return sling


def _equalizing_rope(lift: Lift, frame: Any, sheaves: list[Any], path_through_points: bool) -> Any:
    osim = import_module("opensim")
    rope = osim.ExpressionBasedPathForce()
    rope.setName("equalizing")
    rope.setClampStretch(False)
    rope.setExpression(_law(lift.equalizing_stiffness, lift.damping_time, "s", "ldot"))
    if not path_through_points:
        factors = osim.ArrayDouble(2.0, lift.sheaves + 1)
        factors.set(lift.sheaves, 0.0)
        names = osim.StdVectorString()
        for i in range(lift.sheaves):
            names.append(f"/jointset/guide{i}/drop{i}")
        path = osim.FunctionBasedPath()
        path.setCoordinatePaths(names)
        path.setLengthFunction(osim.LinearFunction(factors))
        rope.setRestingLength(0.0)
        rope.set_path(path)
        return rope
    rope.set_path(osim.GeometryPath())
    points = osim.GeometryPath.safeDownCast(rope.updPath())
    left, right = osim.Vec3(-RADIUS, 0, 0), osim.Vec3(RADIUS, 0, 0)
    for i, (x, sheave) in enumerate(zip(lift.sheave_x, sheaves, strict=True)):
        points.appendNewPathPoint(f"down{i}", frame, osim.Vec3(x - RADIUS, 0, 0))
        points.appendNewPathPoint(f"left{i}", sheave, left)
        points.appendNewPathPoint(f"right{i}", sheave, right)
        points.appendNewPathPoint(f"up{i}", frame, osim.Vec3(x + RADIUS, 0, 0))
    # The path crosses sheaves straight; what it leaves out is constant.
    crossings = 2 * RADIUS * (2 * lift.sheaves - 1)
    rope.setRestingLength(2 * lift.sheaves * lift.start_drop + crossings)
    return rope


def manager_of(model: Any, method: str, accuracy: float) -> Any:
    """A model ready to run by a method at an accuracy, nothing written."""
    osim = import_module("opensim")
    state = model.initSystem()
    manager = osim.Manager(model)
    manager.setWriteToStorage(False)
    manager.setPerformAnalyses(False)
    manager.setIntegratorMethod(getattr(osim.Manager, f"IntegratorMethod_{method}"))
    manager.setIntegratorAccuracy(accuracy)
    manager.setIntegratorInternalStepLimit(MANY_STEPS)
    manager.initialize(state)
    return manager


class OpenSimRun:
    """One integration."""

    def __init__(self, lift: Lift, setting: Setting, duration: float) -> None:
        osim = import_module("opensim")
        osim.Logger.setLevelString("Error")
        self._duration, self._sheaves = duration, lift.sheaves
        method, *path = setting.method.split(",")[0].split()
        self._model, slings = build(lift, "points" in path)
        self._reporter = osim.TableReporter()
        self._reporter.setName("tensions")
        self._reporter.set_report_time_interval(SAMPLE_INTERVAL)
        for sling in slings:
            self._reporter.addToReport(sling.getOutput("force_magnitude"), sling.getName())
        self._model.addComponent(self._reporter)
        self._manager = manager_of(self._model, method, setting.value)

    def integrate(self) -> None:
        """To the end."""
        try:
            self._manager.integrate(self._duration)
        except RuntimeError as error:
            raise Unfit(str(error).splitlines()[0]) from error

    def tensions(self) -> FloatArray:
        """Sling tensions (time, sling) [N]."""
        table = self._reporter.getTable()
        times = np.array(table.getIndependentColumn())
        values = table.getMatrix().to_numpy()
        samples = np.arange(sample_count(self._duration)) * SAMPLE_INTERVAL
        columns = [np.interp(samples, times, values[:, i]) for i in range(self._sheaves)]
        return np.stack(columns, axis=1)


class OpenSim:
    """The value of a setting is the accuracy that is asked of the integrator."""

    name = "OpenSim"

    def version(self) -> str:
        """As the code tells it, without the date of its build."""
        return str(import_module("opensim").GetVersion()).split("-")[0]

    def settings(self, lift: Lift) -> Sequence[Setting]:
        """CPODES over accuracies."""
        accuracies = (1e-5, 3e-5, 1e-4, 3e-4, 1e-3) if lift.sheaves < 400 else (1e-4, 1e-3)
        return [Setting("CPodes, accuracy", accuracy) for accuracy in accuracies]

    def candidates(self, lift: Lift) -> Sequence[Setting]:
        """Every integrator that controls its error, both kinds of path."""
        return [
            Setting(f"{method}{path}, accuracy", accuracy)
            for accuracy in (1e-5, 1e-4, 1e-3, 1e-2)
            for method in INTEGRATORS
            for path in ("", " points")
        ]

    def prepare(self, lift: Lift, setting: Setting, duration: float) -> OpenSimRun:
        """The model at its start."""
        return OpenSimRun(lift, setting, duration)
