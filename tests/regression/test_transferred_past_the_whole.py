"""More than the whole load had come over: `load_transferred` said 658.6 % of a mast that its hinge held down.

A hook that is hoisted on with its load upright in a hinge pulls against that. What a hinge bears upwards is
not over yet, and what it pulls down was counted as negative: the figure was the pull of the hook over the
weight. Whoever waits for all of the load to hang reads that it does; how hard the hinge holds it down was
told nowhere, since its force has no sign.
"""

from __future__ import annotations

import pytest

from gantline.results.loads.hinge_peaks import in_words
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from gantline.units import format_quantity
from hinged_mast import RAISE, WEIGHT, mast


def test_the_whole_is_the_most_that_comes_over() -> None:
    recording = simulate(parse_scenario(mast(RAISE)))
    transferred = recording.column("load_transferred", "mast")
    assert transferred.max() == 1.0 == recording.metrics()["final_load_transferred"]
    # On its way up the hinge bears the rest, plumb or not.
    push = recording.column("hinge_push", "foot")[:, 2]
    lifted = push < 0.0
    assert transferred[lifted] == pytest.approx(1.0 + push[lifted] / WEIGHT, abs=1e-9)
    (hinge,) = recording.rig.hinges
    words = dict(in_words(recording, hinge))
    assert words["holds mast down"].startswith(
        f"with {format_quantity(float(push.max()), 'kN', 1)} at most, at "
    )


def test_a_hinge_that_holds_nothing_down_does_not_say_so() -> None:
    lies = mast("  - {step: hold, hold: 5 s}\n", hook=(19.0, 0.0, 60.0)).replace("900 s", "5 s")
    recording = simulate(parse_scenario(lies))
    (hinge,) = recording.rig.hinges
    assert "holds mast down" not in dict(in_words(recording, hinge))
