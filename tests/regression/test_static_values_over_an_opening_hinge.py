"""The static hook load of a load that a hinge lets go: the mean of before and after, half of what hangs.

No quiet window went on where a rope parts or a locking pin is pulled, and events of the pins of a hinge were
those; since they are told as one, `hinge_opened`, it did. A mast of 981 kN that its hinge had borne for 20 s,
and its sling for 20 s more, had a static hook load of 491 kN, which limits and capacities were held against,
and a dynamic factor of the drop of twice what it is. Forces in the hinge were static for those after it, too.
"""

from __future__ import annotations

import pytest

from gantline.results import series
from gantline.results.loads.hinges import shut_as_at
from gantline.results.loads.hung_so import has_hung_so
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from hinged_mast import WEIGHT, mast
from of_recording import checks_of

PLAN = "  - {step: in its hinge, hold: 20 s}\n  - {step: let go, hold: 20 s, open_hinges: foot}\n"


def dropped(plan: str = PLAN, ground: str = "") -> Recording:
    """A mast in a hinge at its centre of gravity, below a sling that just reaches its lug, 1 m over that."""
    text = mast(plan, hook=(-2.0, 0.0, 60.0), more="simulation: {sample_interval: 10 ms}")
    text = text.replace("at: [19 m, 0 m, 1 m]", "at: [-2 m, 0 m, 2 m]").replace("900 s", "40 s")
    text = text.replace("hinges: {foot: {at: [-20 m,", "hinges: {foot: {at: [-2 m,")
    start, end = text.index("slings:"), text.index("hinges:")
    sling = "slings: {A: {from: main, to: mast.A, length: 48 m, rope: steel}}\n"
    return simulate(parse_scenario(text[:start] + ground + sling + text[end:]))


def test_what_hung_before_is_none_of_what_hangs_after() -> None:
    """The hinge bears W, then the sling: means of either, and none of both."""
    recording = dropped()
    before, after = series.quiet_windows(recording)
    load = recording.column("hook_load", "main")
    assert series.static_value(recording, load, before) == pytest.approx(0.0, abs=1e-3 * WEIGHT)
    assert series.static_value(recording, load, after) == pytest.approx(WEIGHT, rel=1e-3)
    (static,) = checks_of(recording, "static_hook_load")
    assert static.value == pytest.approx(WEIGHT, rel=1e-3)
    (factor,) = checks_of(recording, "hook_dynamic_factor")
    assert factor.value == pytest.approx(load.max() / WEIGHT, rel=1e-3)


def test_what_hung_in_the_hinge_says_nothing_of_what_is_let_go() -> None:
    """Lowered to the ground as it is let go: it never hung still in its sling, which bore nothing before."""
    down = (
        "  - {step: in its hinge, hold: 20 s}\n"
        "  - {step: down, lower: main, speed: 6 m/min, by: 1 m, open_hinges: foot}\n"
        "  - {step: stand, hold: until_end}\n"
    )
    recording = dropped(down, "ground: {level: 9.5 m}\n")
    assert not series.is_clear(recording)[-1]
    assert has_hung_so(recording, 10.0) and not has_hung_so(recording, 20.1)
    assert has_hung_so(dropped(), 20.1)


def test_only_times_with_the_hinge_as_then_count() -> None:
    recording = dropped()
    time = recording.time
    (hinge,) = recording.rig.hinges
    assert hinge.opened_in == ["let go"]
    assert (shut_as_at(recording, 20.0) == (time <= 20.0)).all()
    assert (shut_as_at(recording, 20.001) == (time > 20.0)).all()
