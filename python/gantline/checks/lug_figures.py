"""What the structure at each lug is designed for: force, its direction, and the capacity that it uses."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from gantline.checks.force import NO_DYNAMIC, NO_STATIC
from gantline.checks.lugs import LugForce, consequence_of, lug_forces, pull_at_lug
from gantline.results import series
from gantline.results.file.form import Vector
from gantline.results.loads.pulls import pull_at_end
from gantline.results.recording import Recording, recorded
from gantline.results.rotation import axes
from gantline.results.variable import FloatArray

__all__ = ["LugFigures", "lug_figures"]


@dataclass(frozen=True)
class LugFigures:
    """The force of what is made fast to one lug, as the check `lug_load_of_capacity` has it.

    Attributes:
        lug: `<load or spreader>.<lug>`.
        slings: Names of the slings that are made fast to it, and of the ropes of `mechanics`.
        at: Place of the lug, from the centre of gravity of its body, along the axes of that [m].
        static: Static force with the design weight, and the rule's skew load factor where it applies [N];
            None if the load never hung still.
        force: The larger of static force times the rule's factors, and simulated peak [N]; None if there is
            neither.
        pull: That force along the axes of the body, from the lug towards what pulls [N], zero without it.
        out_of_plane: Angle of the pull from the main plate [rad]; None if that is not known.
        capacity: Of the lug, in the plane of its plate [N]; None if not said.
        time: When the force acts [s]; None if it is static, or by the rule.
        text: How the force comes about.
        remark: What is to be known of it; empty if nothing is.
    """

    lug: str
    slings: tuple[str, ...]
    at: Vector
    static: float | None
    force: float | None
    pull: Vector
    out_of_plane: float | None
    capacity: float | None
    time: float | None
    text: str
    remark: str

    @property
    def used(self) -> float | None:
        """Share of the capacity that the force uses [1]; None where one of them is not known."""
        return None if self.force is None or not self.capacity else self.force / self.capacity


def lug_figures(recording: Recording) -> list[LugFigures]:
    """Figures of all lugs of loads and spreaders at which slings or ropes of `mechanics` pull.

    Several slings on one side of a lug are added up as vectors of one time, what pulls from above and what
    pulls from below as sizes; their pull has the direction of what they all pull together. Where the force is
    a simulated peak the direction is that of the sample nearest to it, else the mean over the time that the
    load hung still.

    Args:
        recording: Of a run, or of an equilibrium, of which the last sample counts.
    """
    return [_figures(recording, one) for one in lug_forces(recorded(recording), series.everywhere(recording))]


def _figures(recording: Recording, one: LugForce) -> LugFigures:
    rig, force = recording.rig, one.force
    holder = rig.with_lugs(one.of)
    lug = None if holder is None else holder.lugs.get(one.name)
    raised = consequence_of(recording)
    size = None if force.governing is None else raised.factor * force.governing
    direction = np.zeros(3) if holder is None else _direction(recording, one, holder.body)
    normal = None if lug is None else lug.main_plate_normal
    remarks = [force.caution, f"static only: {NO_DYNAMIC}" if force.lacks_dynamics else ""]
    remarks += ["" if size is not None else NO_STATIC]
    remarks += ["main plate assumed to stand in xz" if lug is not None and lug.plate_is_assumed else ""]
    return LugFigures(
        lug=one.element,
        slings=(*(sling.name for sling, _ in one.ends), *dict.fromkeys(rope for rope, _ in one.ropes)),
        at=(math.nan, math.nan, math.nan) if lug is None else lug.at,
        static=force.static,
        force=size,
        pull=_vector((size or 0.0) * direction),
        out_of_plane=None if normal is None else abs(math.asin(np.clip(direction @ normal, -1.0, 1.0))),
        capacity=None if lug is None else lug.capacity or None,
        time=force.moment,
        text="" if size is None else f"{force.text}{raised.text}",
        remark="; ".join(filter(None, remarks)),
    )


def _direction(recording: Recording, one: LugForce, body: str) -> FloatArray:
    """Unit vector from a lug along what pulls there, all together, axes of its body; zero if nothing does."""
    pull = np.zeros((len(recording.time), 3))
    for sling, end in one.ends:
        pull += pull_at_lug(recording, sling, end, (one.of, one.name))
    for rope, which in one.ropes:
        pull += pull_at_end(recording, rope, which)
    own = np.einsum("tij,ti->tj", axes(recording.column("body_orientation", body)), pull)
    if one.force.moment is not None:
        mean = own[int(np.argmin(np.abs(recording.time - one.force.moment)))]
    else:
        window = one.force.window
        is_known = window is not None and window.any()
        mean = own[window if is_known else series.everywhere(recording)].mean(axis=0)
    size = float(np.linalg.norm(mean))
    unit: FloatArray = mean / size if size > 0.0 else np.zeros(3)
    return unit


def _vector(values: FloatArray) -> Vector:
    x, y, z = (float(value) for value in values)
    return x, y, z
