"""Which of slings that carry the same governs, and when, was said by rounding.

The slings S2 and S4 of `equalizer_yard` are each other's mirror images. On a processor with fused
multiplications the run named S2 for tension, shackle and lug, on one without S4: their values differ by
2e-15 of themselves, those of slings and hooks of `floating_crane` by 1e-13. So did the time of what stays as
it is, and the sign of the way in which a load moves, where its parts are alike.
"""

from __future__ import annotations

import numpy as np
import pytest

from gantline.checks import Check, foremost, governing
from gantline.checks.check import Verdict
from gantline.results import series
from gantline.results.comparison import peak_sling
from gantline.results.loads.tilting import LooseTilt
from gantline.results.recording import Recording
from gantline.statics.motion import in_words
from of_recording import checks_of
from sample_lift import WEIGHT, Array, sample_recording, sample_rig

TIME = np.linspace(0.0, 1.0, 11)
#: One body upright, for motions in words.
BODIES = {"load": {"mass": 1.0, "inertia": [1.0, 1.0, 1.0, 0.0, 0.0, 0.0]}}
UPRIGHT = np.array([[1.0, 0.0, 0.0, 0.0]])
SHARES = np.array([0.18, 0.23, 0.18, 0.23, 0.18])
#: What is added to the slings S2 and S4, a share: nothing, and rounding either way.
ROUNDINGS = [(0.0, 0.0), (0.0, 2e-13), (2e-13, 0.0)]

roundings = pytest.mark.parametrize("rounding", ROUNDINGS, ids=["alike", "S4 by rounding", "S2 by rounding"])


def lift(rounding: tuple[float, float], later: float = 0.0) -> Recording:
    """The sample lift at rest; `later`: what is added to all tensions from 0.5 s on, a share."""
    more: Array = np.array([0.0, rounding[0], 0.0, rounding[1], 0.0])
    tension = WEIGHT * SHARES * (1.0 + more) * (1.0 + later * (TIME[:, None] >= 0.5))
    return sample_recording(TIME, tension=tension, rig=sample_rig(sling_tension=1e9))


def of(recording: Recording, name: str) -> Check:
    """The check of one name."""
    (check,) = checks_of(recording, name)
    return check


@roundings
@pytest.mark.parametrize(("name", "element"), [("sling_tension", "S2"), ("lug_load_of_capacity", "block.L2")])
def test_the_first_of_those_alike_governs(rounding: tuple[float, float], name: str, element: str) -> None:
    """Largest values of two slings alike but for rounding."""
    assert of(lift(rounding), name).element == element


@roundings
def test_a_comparison_looks_at_the_first_of_those_alike(rounding: tuple[float, float]) -> None:
    """The sling whose tension a comparison shows."""
    assert peak_sling(lift(rounding)) == "S2"


@pytest.mark.parametrize("later", [0.0, 2e-13, -2e-13])
def test_the_first_time_counts(later: float) -> None:
    """What stays the same but for rounding governs from when on it does."""
    assert of(lift((0.0, 0.0), later), "sling_tension").time == 0.0


def test_what_differs_by_more_than_rounding_is_no_tie() -> None:
    """A millionth more, of a sling and of a time."""
    check = of(lift((0.0, 1e-6), 1e-6), "sling_tension")
    assert (check.element, check.time) == ("S4", 0.5)


def test_a_value_is_the_worst_whoever_is_named() -> None:
    """The largest value to the last bit beside the name of the first, so that no verdict depends on it."""
    recording = lift((0.0, 2e-13))
    assert of(recording, "sling_tension").value == recording.column("rope_tension", "sling.S4").max()


@pytest.mark.parametrize("more", [0.0, 1e-13, -1e-13])
def test_the_first_of_checks_alike_governs(more: float) -> None:
    """Two checks that use the same of their limits."""
    checks = [
        Check(name, Verdict.OK, "", value=value, limit=1.0)
        for name, value in (("one", 0.8), ("other", 0.8 * (1.0 + more)), ("least", 0.1))
    ]
    assert [one.name for one in foremost(checks)] == ["one", "other", "least"]
    chosen = governing(checks)
    assert chosen is not None and chosen.name == "one"
    assert governing([*checks, Check("failed", Verdict.FAILED, "")]) is not chosen


@roundings
def test_a_notebook_shows_the_first_of_those_alike(rounding: tuple[float, float]) -> None:
    """The largest sling tension among what is shown of a recording."""
    assert "(sling.S2)" in lift(rounding)._repr_html_()


def test_a_peak_is_when_a_series_first_comes_to_it() -> None:
    """The time beside the tilt of a load that hangs plumb, 4e-16 rad, was one at random."""
    found = series.peak(
        lift((0.0, 0.0)), np.array([0.0, 1e-16, 0.0, 4e-16, 1e-16, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0])
    )
    assert found == (4e-16, 0.0)


def test_what_is_left_of_rounding_has_no_sign() -> None:
    """The line about which slings let a load tilt was (-0.00, 1.00, 0) of `floating_crane`."""
    told = str(LooseTilt("load", ("e1",), (-1e-17, 1.0), 6.0))
    assert "no tilt stiffness about (0.00, 1.00, 0.00)" in told


@pytest.mark.parametrize("more", [0.0, 1e-15, -1e-15])
def test_a_motion_has_its_first_part_positive_of_parts_alike(more: float) -> None:
    """Along (1, -1, 0): it was (-0.71, 0.71, 0.00) where the second part was larger by its last bit."""
    motion = np.array([[-1.0, 1.0 + more, 0.0, 0.0, 0.0, 0.0]])
    assert in_words(motion, ["load"], BODIES, UPRIGHT) == "load moves along (0.71, -0.71, 0.00)"


@pytest.mark.parametrize("more", [0.0, 1e-15, -1e-15])
def test_a_motion_names_the_first_of_bodies_alike(more: float) -> None:
    """Four hooks that move alike have a quarter of the energy each, from which on a body is named."""
    motion = np.array([[0.0, 0.0, factor, 0.0, 0.0, 0.0] for factor in (1.0, 1.0, 1.0 + more, 1.0)])
    told = in_words(
        motion, list("ABCD"), dict.fromkeys("ABCD", BODIES["load"]), np.repeat(UPRIGHT, 4, axis=0)
    )
    assert told == "A moves along z, B moves along z"
