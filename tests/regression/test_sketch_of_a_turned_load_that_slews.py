"""The side view of a column that was upended looked along it, since the column had yawed once it stood.

The view looks across the turning of a load, and took that from where the load leaned most: at 90.0 degrees, a
quarter of a turn about plumb after it had come upright. The column lay end on, and both slings of its head in
one place.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from gantline.report.sketch import sketches
from gantline.report.subject import Subject
from gantline.results.recording import Recording
from sample_lift import ringing_lift


def _turned(yaw: float) -> Recording:
    """A load that comes clear at 10 s, tilts about y until 30 s, by 89.8 deg, and yaws from then on."""
    plain = ringing_lift()
    time = plain.time
    tilt = np.interp(time, [10.0, 30.0, 40.0], [0.0, 89.8, 90.0])
    about_plumb = np.interp(time, [30.0, 40.0], [0.0, yaw])
    # About axes of the world first y, then z.
    turns = Rotation.from_euler("yz", np.column_stack([tilt, about_plumb]), degrees=True)
    orientation = plain["body_orientation"].values.copy()
    of_load = plain.coordinates["body"].index("block")
    orientation[:, of_load] = turns.as_quat(scalar_first=True)
    variables = {
        **plain.variables,
        "body_orientation": replace(plain["body_orientation"], values=orientation),
        "load_tilt": replace(plain["load_tilt"], values=np.radians(tilt)[:, None]),
    }
    return Recording(variables, plain.coordinates, plain.attributes)


@pytest.mark.parametrize("yaw", [0.0, 90.0, -120.0])
def test_the_side_view_looks_across_the_turning(yaw: float) -> None:
    """About y, whatever the load does once it stands: x is to the right."""
    side, _ = sketches(Subject(_turned(yaw)))
    assert side.title == "side view at 10.0 s, x to the right"
