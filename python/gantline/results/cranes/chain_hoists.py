"""Chain hoists of slings in a recording: what they have paid out, and how long that makes their slings."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from gantline.results.file.form import Range
from gantline.results.strength import FromJson
from gantline.results.variable import Columns, Derived, FloatArray, Names, Variable

if TYPE_CHECKING:
    from gantline.results.gear import Sling
    from gantline.results.recording import Recording
    from gantline.results.rig import Rig

__all__ = ["ChainHoist", "chain_hoist_state", "sling_lengths"]


@dataclass(frozen=True)
class ChainHoist(FromJson):
    """A chain hoist, hydraulic cylinder or turnbuckle that is a part of a sling.

    Attributes:
        name: Name of its sling.
        joint: Its joint, which counts what it has paid out.
        rated_capacity: Along the sling [N]; None if not said.
        range: Least and largest change of the sling's length [m]; None where there is no limit.
        weight: Its own weight [N], at the upper end of the sling.
    """

    name: str
    joint: str = ""
    rated_capacity: float | None = None
    range: Range | None = None
    weight: float = 0.0


def chain_hoist_state(columns: Columns, names: Names, rig: Rig) -> Derived:
    """What chain hoists have paid out, with their names; nothing in a lift without.

    Args:
        columns: Columns of the core by name.
        names: Names along their dimensions.
        rig: The lift.
    """
    if not rig.chain_hoists:
        return {}, {}
    joints = list(names["joint"])
    own = [columns["joint_position"][:, joints.index(one.joint)] for one in rig.chain_hoists]
    text = "chain that the hoist of a sling has paid out, negative where it has hauled in"
    out = Variable(("time", "chain_hoist"), np.stack(own, axis=1), "m", text)
    return {"chain_paid_out": out}, {"chain_hoist": [one.name for one in rig.chain_hoists]}


def sling_lengths(recording: Recording, sling: Sling) -> FloatArray:
    """Length of a sling, bearing to bearing and unloaded [m], shape (time,).

    What its chain hoist pays out is counted with the stretch that it has there.
    """
    given: FloatArray = np.full(recording.time.shape, sling.length)
    if sling.name not in recording.coordinates.get("chain_hoist", ()):
        return given
    return given + recording.column("chain_paid_out", sling.name)
