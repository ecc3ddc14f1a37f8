"""MuJoCo: ropes as tendons, each with an actuator whose force is limited to pulling.

An actuator with affine bias gives b₀ + b₁ l + b₂ l̇ on its tendon's length l; with b₀ = k L, b₁ = -k, b₂ = -k
τ and a force range that ends at zero this is the law of the lifts, -max(0, k (e + τ ė)). A sling is a spatial
tendon between two sites. The equalizing rope is a fixed tendon, a weighted sum of joint positions, because
all its parts are vertical.

Two models of the same mechanics:

- *siblings*: every moving sheave slides in the frame. As the documentation suggests, and sparse. The
  integrator `implicitfast` treats damping implicitly within the pattern of the mass matrix, so the coupling
  of sheaves by the equalizing rope stays explicit and limits the step to about 1 ms from 20 sheaves on.
- *nested*: every sheave slides relative to its neighbour. The mass matrix is dense, which costs n², but its
  pattern holds the equalizing rope's damping, and steps of 10 ms are stable.

Contacts and constraints are switched off: there are none. Tensions are actuator-force sensors of a rollout,
which loops in C. They are those at the beginning of a step; between steps they are interpolated linearly.
"""

from __future__ import annotations

from collections.abc import Sequence
from importlib import import_module, metadata
from typing import Any

import numpy as np

from benchmarks.contract import SAMPLE_INTERVAL, FloatArray, Setting, Unfit, sample_count
from benchmarks.lifts import Lift

INERTIA = 1e-3  # kg m², of a sheave: MuJoCo asks for some; the frame has a million times more
LARGE_FORCE = 1e12  # N, more than any tension
INTEGRATORS = {
    "implicitfast": "mjINT_IMPLICITFAST",
    "implicit": "mjINT_IMPLICIT",
    "Euler": "mjINT_EULER",
    "discrete": "mjINT_DISCRETE",
    "RK4": "mjINT_RK4",
}


def build(lift: Lift, integrator: str, step: float, nested: bool) -> Any:
    """The compiled model."""
    mujoco = import_module("mujoco")
    spec = mujoco.MjSpec()
    spec.option.timestep = step
    spec.option.integrator = getattr(mujoco.mjtIntegrator, INTEGRATORS[integrator])
    spec.option.gravity = [0, 0, -lift.gravity]
    spec.option.jacobian = mujoco.mjtJacobian.mjJAC_SPARSE
    off = mujoco.mjtDisableBit
    spec.option.disableflags = int(off.mjDSBL_CONTACT | off.mjDSBL_CONSTRAINT)
    frame = _body(
        spec.worldbody, "frame", [0, 0, lift.axle_height], lift.frame_mass, [lift.frame_inertia] * 3
    )
    frame.add_joint(
        name="yaw", type=mujoco.mjtJoint.mjJNT_HINGE, axis=[0, 0, 1], damping=[lift.yaw_damping, 0, 0]
    )
    load = _body(spec.worldbody, "load", [0, 0, lift.load_height], lift.load_mass, list(lift.load_inertia))
    load.add_freejoint()
    equalizing = spec.add_tendon(name="equalizing")
    carrier, carrier_x, carrier_z = frame, 0.0, 0.0
    for i, x in enumerate(lift.sheave_x):
        place = [x - carrier_x, 0, -lift.start_drop - carrier_z]
        sheave = _body(carrier, f"sheave{i}", place, lift.sheave_mass, [INERTIA] * 3)
        sheave.add_joint(name=f"drop{i}", type=mujoco.mjtJoint.mjJNT_SLIDE, axis=[0, 0, -1])
        # A nested sheave takes all that come after it along.
        equalizing.wrap_joint(f"drop{i}", 2.0 * (lift.sheaves - i if nested else 1))
        if nested:
            carrier, carrier_x, carrier_z = sheave, x, -lift.start_drop
        sheave.add_site(name=f"sheave{i}")
        load.add_site(name=f"lug{i}", pos=[*lift.lugs[i], lift.load_box[2] / 2])
        sling = spec.add_tendon(name=f"sling{i}")
        sling.wrap_site(f"sheave{i}")
        sling.wrap_site(f"lug{i}")
        _pull(spec, f"sling{i}", lift.sling_lengths[i], lift.sling_stiffness[i], lift.damping_time)
        spec.add_sensor(
            type=mujoco.mjtSensor.mjSENS_ACTUATORFRC,
            objtype=mujoco.mjtObj.mjOBJ_ACTUATOR,
            objname=f"sling{i}",
        )
    _pull(spec, "equalizing", 0.0, lift.equalizing_stiffness, lift.damping_time)
    return spec.compile()


def _body(parent: Any, name: str, position: list[float], mass: float, inertia: list[float]) -> Any:
    """A body whose centre of gravity is its origin: without `ipos` it would not be."""
    return parent.add_body(
        name=name, pos=position, mass=mass, inertia=inertia, explicitinertial=True, ipos=[0, 0, 0]
    )


def _pull(spec: Any, tendon: str, length: float, stiffness: float, damping_time: float) -> None:
    mujoco = import_module("mujoco")
    actuator = spec.add_actuator(
        name=tendon,
        trntype=mujoco.mjtTrn.mjTRN_TENDON,
        target=tendon,
        gaintype=mujoco.mjtGain.mjGAIN_FIXED,
        biastype=mujoco.mjtBias.mjBIAS_AFFINE,
        forcelimited=True,
        forcerange=[-LARGE_FORCE, 0],
        ctrllimited=False,
    )
    actuator.gainprm = [0] * 10
    actuator.biasprm = [stiffness * length, -stiffness, -stiffness * damping_time] + [0] * 7


class MuJoCoRun:
    """One rollout."""

    def __init__(self, lift: Lift, integrator: str, step: float, nested: bool, duration: float) -> None:
        self._mujoco, self._rollout = import_module("mujoco"), import_module("mujoco.rollout")
        self._model = build(lift, integrator, step, nested)
        self._data = self._mujoco.MjData(self._model)
        self._step, self._duration = step, duration
        whole = self._mujoco.mjtState.mjSTATE_FULLPHYSICS
        self._start = np.empty(self._mujoco.mj_stateSize(self._model, whole))
        self._mujoco.mj_getState(self._model, self._data, self._start, whole)
        self._forces: FloatArray = np.empty((0, 0))

    def integrate(self) -> None:
        """All steps, and one or two more for the interpolation of the last sample."""
        steps = int(np.ceil(self._duration / self._step - 1e-9)) + 2
        _, sensors = self._rollout.rollout(
            self._model, self._data, initial_state=self._start[None], nstep=steps
        )
        self._forces = np.asarray(sensors[0], dtype=np.float64)
        if any(warning.number for warning in self._data.warning) or not np.isfinite(self._forces).all():
            raise Unfit("the motion became unstable")

    def tensions(self) -> FloatArray:
        """Sling tensions (time, sling) [N]."""
        place = np.arange(sample_count(self._duration)) * SAMPLE_INTERVAL / self._step
        before = np.floor(place + 1e-9).astype(int)
        share = np.clip(place - before, 0, 1)[:, None]
        between: FloatArray = self._forces[before] * (1 - share) + self._forces[before + 1] * share
        return -between


class MuJoCo:
    """The value of a setting is the step [ms]."""

    def __init__(self, nested: bool) -> None:
        self.name = "MuJoCo, nested sheaves" if nested else "MuJoCo"
        self._nested = nested

    def version(self) -> str:
        """As installed."""
        import_module("mujoco")
        return metadata.version("mujoco-core")

    def settings(self, lift: Lift) -> Sequence[Setting]:
        """Down from the largest stable steps."""
        n = lift.sheaves
        steps: Sequence[float]
        if self._nested:
            if n > 100:
                return []  # a dense mass matrix costs more here than small steps
            few = (0.625, 10 / 12, 1.0, 10 / 7, 2.5, 10 / 3, 5.0, 10.0, 12.5)
            steps = few if n < 100 else (2.0, 5.0, 10.0)
        elif n <= 5:
            steps = (0.4, 0.5, 0.625, 10 / 12, 1.0, 1.25, 10 / 7, 1.6, 1.7)
        elif n < 400:
            steps = (0.4, 0.5, 0.625, 10 / 12, 1.0, 1.1, 1.2)
        else:
            steps = (0.3, 0.5, 0.625, 10 / 12, 1.0, 1.1)
        return [Setting("implicitfast, h [ms]", step) for step in steps]

    def candidates(self, lift: Lift) -> Sequence[Setting]:
        """Every integrator over its range of steps."""
        steps = {
            "implicitfast": (0.5, 0.8, 1.0, 1.25, 1.6, 2.0, 5.0, 10.0),
            "implicit": (0.5, 1.0, 1.6, 5.0, 10.0),
            "Euler": (0.25, 0.5, 1.0),
            "discrete": (0.1, 0.25, 0.5, 1.0, 2.5, 5.0),
            "RK4": (1.0, 1.25, 1.4),
        }
        return [Setting(f"{name}, h [ms]", step) for name, all_steps in steps.items() for step in all_steps]

    def prepare(self, lift: Lift, setting: Setting, duration: float) -> MuJoCoRun:
        """The model at its start."""
        integrator = setting.method.split(",")[0]
        return MuJoCoRun(lift, integrator, setting.value * 1e-3, self._nested, duration)
