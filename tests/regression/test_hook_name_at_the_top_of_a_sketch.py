"""The name of the topmost hook was cut off by the upper end of the first page's sketch.

A hook at the top of what is drawn stands 4 mm below the end of the paper. Where its slings lean across the
place beside it, its name went to 4 mm above it: half of the letters were off the paper.
"""

from __future__ import annotations

import numpy as np

from gantline.report.sketch_names import names_beside

RIGHT = 90.0
#: From the end of the paper to the middle of letters that are wholly on it [mm].
HALF_A_LINE = 1.7


def test_a_name_stays_below_the_upper_end() -> None:
    hook = np.array([45.0, 4.0])
    # Slings that leave the hook to both sides, level, so that no place beside it is free.
    slings = [(45.0 + x, 45.0 + x, 4.0) for x in range(-20, 21)]
    ((_, y, text, _),) = names_beside([hook], ["hook"], RIGHT, slings)
    assert text == "hook"
    assert y >= HALF_A_LINE
