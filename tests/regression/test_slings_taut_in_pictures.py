"""Pictures show when the last sling came taut by the log, and not when it carries a hundredth of its peak.

Stages of `goliath` had 'slings taut' at 130.60 s, forty seconds after the last sling had come taut at 90.50
s and the equalizers had equalised, since slings carried 2 kN of 249 kN while they settled;
`heavy_lift_ship` had 165.40 s for 156.10 s.
"""

from __future__ import annotations

import numpy as np

from gantline.plot.moments import Moment, moments
from sample_lift import ringing_lift

#: Of the peak of 700 kN: what slings carry while they settle.
LITTLE = 2e3  # N


def slings_taut(*log: tuple[float, str, str]) -> Moment:
    """When pictures have slings taut that carry a little from 5 s on, all from 10 s on; `log` has events."""
    recording = ringing_lift()
    tension = np.array(recording["rope_tension"].values[:, 1:])
    settling = (recording.time >= 5.0) & (recording.time < 10.0)
    tension[settling] = LITTLE
    events = [(9.99, "lift_off", "block"), *log]
    (found,) = (
        one for one in moments(ringing_lift(tension=tension, events=events)) if one.name == "slings taut"
    )
    return found


def test_slings_are_taut_that_carry_little() -> None:
    assert slings_taut().time == 5.0


def test_they_are_so_from_the_last_event_on() -> None:
    """Slings may go slack once more between two samples: 5.004 to 5.013 s here, and samples each 20 ms."""
    bounce = [(4.995, "taut"), (5.004, "slack"), (5.013, "taut")]
    found = slings_taut(*((time, kind, "sling.S3") for time, kind in bounce))
    assert (found.time, found.sample) == (5.013, 251)
