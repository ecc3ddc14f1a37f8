"""Places of hooks that cannot be, told as sensitivities that are missing.

A load that two hooks turn hangs with its tailing hook so far below the other that no place of them makes
both plumb: its lugs are 6.02 m apart, and plumb slings would put one 6.7 m above the other. A step of the
search on which the tailing slings were slack ended it at once: `the lift has no sensitivities to these
quantities (nothing holds what place_x of tail sets going)`, which says nothing of the slings. A shorter
step is tried now, and what is slack is named.
"""

from __future__ import annotations

import math

import pytest

from gantline.scenario import parse_scenario
from gantline.study import CannotBeError, plumb_hooks
from hooked_lift import turned_by_two_hooks

#: How far below its hook each pair of lugs, 4.4 m apart, is in a plane along x through the hook [m].
DEPTHS = math.sqrt(10.3**2 - 2.2**2), math.sqrt(10.5**2 - 2.2**2)


def test_it_says_that_it_cannot_be() -> None:
    # Where the plan leaves their bearings: 13 + 4 + 1.5 m and 11 + 4 - 3 m.
    higher = (18.5 - DEPTHS[0]) - (12.0 - DEPTHS[1])
    assert higher > math.hypot(5.6, 2.2)  # 6.7 m > 6.02 m
    with pytest.raises(CannotBeError) as found:
        plumb_hooks(parse_scenario(turned_by_two_hooks()))
    assert str(found.value).startswith("slack on the way: C, D; ")
