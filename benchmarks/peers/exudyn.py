"""Exudyn: ropes as connectors, implicit integration by the generalized-α method.

Two models of the same mechanics:

- *reeving*: every rope is a ReevingSystemSprings, the code's own object for ropes over sheaves, with its
  force law limited to pulling (`regularizationForce`). With 5 sheaves the frame and its sheaves are one
  kinematic tree, with more they are rigid bodies and joints, which is faster there.
- *sum*: the equalizing rope's stretch is a massless coordinate, tied by constraints to the sum of the
  sheaves' drops, and the rope's law acts on that coordinate; slings are spring-dampers between points with
  the law as a symbolic function; sheaves are point masses that the frame guides. So every Jacobian stays
  sparse: sums go over groups, since the constraint that adds coordinates costs the square of their number.

The load turns by Tait-Bryan angles about x, y, z, which are regular for all motions of these lifts. Modified
Newton with a Jacobian that is renewed only when convergence asks for it, sparse linear solver, compiled
without range checks. Sensors record at every step; samples between steps are interpolated linearly.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from importlib import import_module, metadata
from typing import Any

import numpy as np

from benchmarks.contract import SAMPLE_INTERVAL, FloatArray, Setting, Unfit, sample_count
from benchmarks.lifts import RADIUS, Lift

REGULARIZATION = 1.0  # N, the largest push of a rope; slings carry a million times more
INERTIA = 1e-3  # kg m², of a sheave that is a rigid body
GROUP = 8  # sheaves whose drops one constraint adds
LEVEL = [0.0, 0.0, 0.0]


def _exudyn() -> tuple[Any, Any]:
    sys.exudynFast = True  # type: ignore[attr-defined]
    return import_module("exudyn"), import_module("exudyn.itemInterface")


class Model:
    """What both models have: load, lugs, sensors, shorthand for Exudyn's items."""

    def __init__(self, lift: Lift) -> None:
        self.exu, self.items = _exudyn()
        self.lift = lift
        self.container = self.exu.SystemContainer()
        self.system = self.container.AddSystem()
        self.sensors: list[Any] = []
        self.still = self.marker(
            "MarkerNodeCoordinate", nodeNumber=self.node("NodePointGround"), coordinate=0
        )
        self.load = self.rigid([0, 0, lift.load_height], lift.load_mass, lift.load_inertia)[1]
        self.lugs = [
            self.marker("MarkerBodyRigid", bodyNumber=self.load, localPosition=[*lug, lift.load_box[2] / 2])
            for lug in lift.lugs
        ]

    def node(self, kind: str, **values: Any) -> Any:
        return self.system.AddNode(getattr(self.items, kind)(**values))

    def object(self, kind: str, **values: Any) -> Any:
        return self.system.AddObject(getattr(self.items, kind)(**values))

    def marker(self, kind: str, **values: Any) -> Any:
        return self.system.AddMarker(getattr(self.items, kind)(**values))

    def weigh(self, body: Any) -> None:
        marker = self.marker("MarkerBodyMass", bodyNumber=body)
        gravity = [0, 0, -self.lift.gravity]
        self.system.AddLoad(self.items.LoadMassProportional(markerNumber=marker, loadVector=gravity))

    def rigid(self, position: Sequence[float], mass: float, inertia: Sequence[float]) -> tuple[Any, Any]:
        node = self.node("NodeRigidBodyRxyz", referenceCoordinates=[*position, 0, 0, 0])
        body = self.object("ObjectRigidBody", nodeNumber=node, mass=mass, inertia=[*inertia, 0, 0, 0])
        self.weigh(body)
        return node, body

    def watch(self, rope: Any) -> None:
        force = self.exu.OutputVariableType.ForceLocal
        sensor = self.items.SensorObject(
            objectNumber=rope, storeInternal=True, writeToFile=False, outputVariableType=force
        )
        self.sensors.append(self.system.AddSensor(sensor))

    def coordinate(self, node: Any, index: int) -> Any:
        return self.marker("MarkerNodeCoordinate", nodeNumber=node, coordinate=index)

    def damp_yaw(self, coordinate: Any) -> None:
        markers = [self.still, coordinate]
        damping = self.lift.yaw_damping
        self.object("ObjectConnectorCoordinateSpringDamper", markerNumbers=markers, damping=damping)


class Reeving(Model):
    """Ropes as the code's own reeving systems."""

    def __init__(self, lift: Lift) -> None:
        super().__init__(lift)
        on_frame, sheaves = self._tree() if lift.sheaves <= 5 else self._bodies()
        xs = lift.sheave_x
        guides, axes, radii = [on_frame([xs[0] - RADIUS, 0, 0])], [[0, 1, 0]], [0.0]
        for i, x in enumerate(xs):
            guides.append(sheaves[i])
            axes.append([0, -1, 0])
            if i + 1 < lift.sheaves:
                guides.append(on_frame([(x + xs[i + 1]) / 2, 0, 0]))
                axes.append([0, 1, 0])
        guides.append(on_frame([xs[-1] + RADIUS, 0, 0]))
        radii += [RADIUS] * (len(guides) - 2) + [0.0]
        self._rope(guides, [*axes, [0, 1, 0]], radii, lift.equalizing_length)
        for sheave, lug, length in zip(sheaves, self.lugs, lift.sling_lengths, strict=True):
            self.watch(self._rope([sheave, lug], [[0, 1, 0]] * 2, [0.0, 0.0], length))

    def _rope(self, guides: list[Any], axes: list[list[int]], radii: list[float], length: float) -> Any:
        return self.object(
            "ObjectConnectorReevingSystemSprings",
            markerNumbers=guides,
            stiffnessPerLength=self.lift.axial_stiffness,
            dampingPerLength=self.lift.axial_stiffness * self.lift.damping_time,
            referenceLength=length,
            regularizationForce=REGULARIZATION,
            sheavesAxes=self.exu.Vector3DList(axes),
            sheavesRadii=radii,
        )

    def _tree(self) -> tuple[Callable[[list[float]], Any], list[Any]]:
        lift, n = self.lift, self.lift.sheaves
        zeros = [0.0] * (n + 1)
        node = self.node(
            "NodeGenericODE2",
            referenceCoordinates=zeros,
            initialCoordinates=zeros,
            initialCoordinates_t=zeros,
            numberOfODE2Coordinates=n + 1,
        )
        joints = self.exu.JointType
        unit = np.eye(3)
        tree = self.object(
            "ObjectKinematicTree",
            nodeNumber=node,
            gravity=[0, 0, -lift.gravity],
            baseOffset=[0, 0, lift.axle_height],
            jointTypes=[joints.RevoluteZ] + [joints.PrismaticZ] * n,
            linkParents=[-1] + [0] * n,
            jointTransformations=self.exu.Matrix3DList([unit] * (n + 1)),
            jointOffsets=self.exu.Vector3DList([LEVEL] + [[x, 0, -lift.start_drop] for x in lift.sheave_x]),
            linkInertiasCOM=self.exu.Matrix3DList([unit * lift.frame_inertia] + [0 * unit] * n),
            linkCOMs=self.exu.Vector3DList([LEVEL] * (n + 1)),
            linkMasses=[lift.frame_mass] + [lift.sheave_mass] * n,
        )
        self.damp_yaw(self.coordinate(node, 0))

        def on_link(link: int, point: list[float]) -> Any:
            place = {"objectNumber": tree, "linkNumber": link, "localPosition": point}
            return self.marker("MarkerKinematicTreeRigid", **place)

        return lambda point: on_link(0, point), [on_link(1 + i, LEVEL) for i in range(n)]

    def _bodies(self) -> tuple[Callable[[list[float]], Any], list[Any]]:
        lift = self.lift
        node, frame = self.rigid([0, 0, lift.axle_height], lift.frame_mass, [lift.frame_inertia] * 3)
        for index in range(5):
            markers = [self.still, self.coordinate(node, index)]
            self.object("ObjectConnectorCoordinate", markerNumbers=markers)
        self.damp_yaw(self.coordinate(node, 5))

        def on_frame(point: list[float]) -> Any:
            return self.marker("MarkerBodyRigid", bodyNumber=frame, localPosition=point)

        sheaves = []
        for x in lift.sheave_x:
            _, body = self.rigid([x, 0, lift.sheave_height], lift.sheave_mass, [INERTIA] * 3)
            sheaves.append(self.marker("MarkerBodyRigid", bodyNumber=body, localPosition=LEVEL))
            guide = [on_frame([x, 0, -lift.start_drop]), sheaves[-1]]
            self.object("ObjectJointGeneric", markerNumbers=guide, constrainedAxes=[1, 1, 0, 1, 1, 1])
        return on_frame, sheaves


class Sum(Model):
    """The equalizing rope's stretch as a coordinate."""

    def __init__(self, lift: Lift) -> None:
        super().__init__(lift)
        node = self.node("NodeRigidBody2D", referenceCoordinates=LEVEL)
        frame = self.object(
            "ObjectRigidBody2D", nodeNumber=node, mass=lift.frame_mass, inertia=lift.frame_inertia
        )
        for index in range(2):
            markers = [self.still, self.coordinate(node, index)]
            self.object("ObjectConnectorCoordinate", markerNumbers=markers)
        self.damp_yaw(self.coordinate(node, 2))
        sheaves = []
        for i, x in enumerate(lift.sheave_x):
            sheaves.append(self.node("NodePoint", referenceCoordinates=[x, 0, lift.sheave_height]))
            self.weigh(self.object("ObjectMassPoint", nodeNumber=sheaves[i], mass=lift.sheave_mass))
            centre = self.marker("MarkerNodePosition", nodeNumber=sheaves[i])
            on_frame = self.marker("MarkerBodyPosition", bodyNumber=frame, localPosition=[x, 0, 0])
            self.object("ObjectJointSpherical", markerNumbers=[on_frame, centre], constrainedAxes=[1, 1, 0])
            self.watch(self._sling(centre, i))
        self._pull("ObjectConnectorCoordinateSpringDamper", [self.still, self._stretch(sheaves)],
                   lift.equalizing_stiffness)  # fmt: skip

    def _sling(self, centre: Any, i: int) -> Any:
        ends = [centre, self.lugs[i]]
        length, stiffness = self.lift.sling_lengths[i], self.lift.sling_stiffness[i]
        return self._pull("ObjectConnectorSpringDamper", ends, stiffness, referenceLength=length)

    def _pull(self, kind: str, markers: list[Any], stiffness: float, **values: Any) -> Any:
        """A spring-damper with the law as a function that Exudyn evaluates by itself."""
        largest = self.exu.symbolic.max
        create = import_module("exudyn.utilities").CreateSymbolicUserFunction

        def law(mbs: Any, t: Any, item: Any, u: Any, v: Any, k: Any, d: Any, last: Any) -> Any:
            return largest(0.0, k * u + d * v)

        values |= {"stiffness": stiffness, "damping": stiffness * self.lift.damping_time}
        rope = self.object(kind, markerNumbers=markers, springForceUserFunction=law, **values)
        name = "springForceUserFunction"
        self.system.SetObjectParameter(rope, name, create(self.system, law, name, rope))
        return rope

    def _stretch(self, sheaves: list[Any]) -> Any:
        """The massless coordinate Σ 2 drop, a sum of sums over groups."""
        height = self.lift.sheave_height
        groups = [sheaves[i : i + GROUP] for i in range(0, len(sheaves), GROUP)]
        parts = [self._total(group, [0.0, 0.0, -2.0], 2 * height) for group in groups]
        whole = parts[0] if len(parts) == 1 else self._total(parts, [1.0], 0.0)
        return self.coordinate(whole, 0)

    def _total(self, nodes: list[Any], row: list[float], offset: float) -> Any:
        """A node whose coordinate is the sum of `row` times the coordinates of each node, plus `offset`."""
        total = self.node("Node1D", referenceCoordinates=[0.0])
        self.object("ObjectMass1D", nodeNumber=total, mass=0.0)
        together = self.object("ObjectGenericODE2", nodeNumbers=nodes, massMatrix=[])
        self.object(
            "ObjectConnectorCoordinateVector",
            markerNumbers=[
                self.marker("MarkerObjectODE2Coordinates", objectNumber=together),
                self.marker("MarkerNodeCoordinates", nodeNumber=total),
            ],
            scalingMarker0=np.array([row * len(nodes)]),
            scalingMarker1=np.array([[1.0]]),
            offset=np.array([offset * len(nodes)]),
        )
        return total


class ExudynRun:
    """One call of the dynamic solver."""

    def __init__(self, model: Model, setting: Setting, duration: float) -> None:
        self._model, self._duration = model, duration
        model.system.Assemble()
        name, *options = setting.method.split(",")[0].split()
        settings = model.exu.SimulationSettings()
        time = settings.timeIntegration
        time.endTime = duration
        time.numberOfSteps = round(duration / (setting.value * 1e-3))
        time.verboseMode = 0
        time.generalizedAlpha.spectralRadius = 0.8
        time.generalizedAlpha.computeInitialAccelerations = True
        time.explicit.computeEndOfStepAccelerations = False
        time.newton.useModifiedNewton = "full" not in options
        time.newton.modifiedNewtonJacUpdatePerStep = "each-step" in options
        tolerance = float(next((option for option in options if option[0].isdigit()), "1e-3"))
        time.newton.relativeTolerance = tolerance
        time.newton.absoluteTolerance = 100 * tolerance
        settings.linearSolver.solverType = model.exu.LinearSolverType.EigenSparse
        settings.parallel.numberOfThreads = 1
        settings.solution.file.write = False
        settings.solution.sensors.writePeriod = SAMPLE_INTERVAL * (1 - 1e-6)
        self._settings, self._solver = settings, getattr(model.exu.DynamicSolverType, name)

    def integrate(self) -> None:
        """To the end."""
        try:
            self._model.system.SolveDynamic(self._settings, solverType=self._solver, showHints=False)
        except Exception as error:
            raise Unfit(str(error).splitlines()[0] if str(error) else "the solver failed") from error

    def tensions(self) -> FloatArray:
        """Sling tensions (time, sling) [N]."""
        read = self._model.system.GetSensorStoredData
        data = [read(sensor) for sensor in self._model.sensors]
        samples = np.arange(sample_count(self._duration)) * SAMPLE_INTERVAL
        columns = [np.interp(samples, column[:, 0], np.maximum(column[:, 1], 0)) for column in data]
        return np.stack(columns, axis=1)


class Exudyn:
    """The value of a setting is the step [ms]; the method's number is Newton's relative tolerance."""

    def __init__(self, reeving: bool) -> None:
        self.name = "Exudyn, reeving" if reeving else "Exudyn"
        self._model: type[Model] = Reeving if reeving else Sum

    def version(self) -> str:
        """As installed."""
        _exudyn()
        return metadata.version("exudyn")

    def settings(self, lift: Lift) -> Sequence[Setting]:
        """Steps that fall on the samples where they are shorter; Newton's tolerance follows the step."""
        n = lift.sheaves
        steps: Sequence[float]
        if self._model is Reeving:
            steps = (5, 10, 20, 30) if n <= 100 else (10, 20, 30)
        else:
            steps = (2.5, 10 / 3, 5, 10, 15, 20, 25, 30, 40) if n <= 20 else (10 / 3, 5, 10, 15, 20, 25)
        return [Setting(f"GeneralizedAlpha {self._tolerance(n, step)}, h [ms]", step) for step in steps]

    def _tolerance(self, n: int, step: float) -> str:
        if self._model is Sum and n <= 5:
            return "1e-3" if step >= 5 else "1e-4"
        return "1e-3" if step >= 15 else "1e-4" if step >= 10 else "1e-5"

    def candidates(self, lift: Lift) -> Sequence[Setting]:
        """Methods, Newton variants and tolerances at two steps, explicit methods at their stability."""
        implicit = [
            Setting(f"{method} {option}, h [ms]", step)
            for step in (10.0, 25.0)
            for method in ("GeneralizedAlpha", "TrapezoidalIndex2")
            for option in ("1e-2", "1e-3", "1e-4", "1e-6", "1e-3 each-step", "1e-3 full")
        ]
        explicit = [Setting("RK44, h [ms]", 1.25)] if self._model is Reeving and lift.sheaves <= 5 else []
        return implicit + explicit

    def prepare(self, lift: Lift, setting: Setting, duration: float) -> ExudynRun:
        """The assembled model."""
        return ExudynRun(self._model(lift), setting, duration)
