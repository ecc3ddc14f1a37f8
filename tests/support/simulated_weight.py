"""A lift that other processes simulate. They find it here by its name, whatever else a session of tests has
put on the path; a test module they do not.
"""

from __future__ import annotations

import gantline
from gantline.results.recording import Recording
from lift_text import weight_on_a_rope


def simulated_weight(mass: str) -> Recording:
    """The run of a weight of this mass, as a lift file has it."""
    return gantline.simulate(gantline.parse_scenario(weight_on_a_rope(mass)))
