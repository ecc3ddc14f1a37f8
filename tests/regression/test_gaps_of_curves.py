"""Players drew a line, and told values, where a curve has none.

The spread of tensions is known only while the load is clear. Of a load that was set down for a moment, as in
`equalizer_sling_cut`, players led a straight line over that moment, and the legend read values from it.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from gantline.results import Recording, Variable
from gantline.viewer import pack
from gantline.viewer.decimate import with_gaps
from packed_arrays import unpacked
from sample_lift import WEIGHT, ringing_lift

Array = npt.NDArray[np.float64]


def spread(known: npt.NDArray[np.bool_]) -> tuple[Array, Array]:
    """Samples and values [%] of the spread in the player of a lift that is clear where it is said."""
    contact = np.repeat(np.where(known, 0.0, WEIGHT / 4)[:, None], 4, axis=1)
    packed = pack(ringing_lift(contact=contact))
    curve = next(one for one in packed.header["curves"] if one["group"] == "spread")
    part = slice(curve["first"], curve["first"] + curve["count"])
    return unpacked(packed, "curve_sample")[part], unpacked(packed, "curve_value")[part]


def test_a_load_that_stands_for_a_moment_has_no_spread_there() -> None:
    """Clear from 10 s to 20 s and from 22 s to 30 s, at samples of 20 ms; (606 - 594)/600 = 2 %."""
    time = np.linspace(0.0, 40.0, 2001)
    known = ((time >= 10.0) & (time <= 20.0)) | ((time >= 22.0) & (time <= 30.0))
    samples, values = spread(known)
    assert samples[np.isnan(values)].tolist() == [1001, 1501]
    # Known up to the gap and right after it.
    assert {500, 1000, 1100, 1500} <= set(samples[~np.isnan(values)].astype(int).tolist())
    np.testing.assert_allclose(values[~np.isnan(values)], 2.0, rtol=1e-6)


def test_a_distance_ends_with_the_ropes_that_it_is_about() -> None:
    """Without end in the recording from 25 s on; a page has no number there, and none that has no end."""
    time = np.linspace(0.0, 40.0, 2001)
    lift = ringing_lift()
    distance = np.where(time < 25.0, 2.0, np.inf)[:, None]
    variables = {
        **lift.variables,
        "clearance": Variable(("time", "pair"), distance, "m", "smallest distance"),
    }
    lift = Recording(variables, {**lift.coordinates, "pair": ("slings - skid",)}, lift.attributes)
    packed = pack(lift)
    curve = next(one for one in packed.header["curves"] if one["group"] == "clearance")
    part = slice(curve["first"], curve["first"] + curve["count"])
    samples, values = unpacked(packed, "curve_sample")[part], unpacked(packed, "curve_value")[part]
    np.testing.assert_array_equal(samples[-2:], [1249, 1250])
    np.testing.assert_array_equal(values[-2:], [2.0, np.nan])
    assert not np.isinf(values).any()


def test_a_gap_between_two_parts_of_a_curve_is_one() -> None:
    """Of a lift that runs: what comes first of the next part says that there is no value any more."""
    nothing, kept = np.nan, np.array([2, 3])
    values = np.array([nothing, nothing, 1.0, 2.0, nothing])
    assert with_gaps(values, kept).tolist() == [2, 3, 4]
    assert with_gaps(values, kept, goes_on=True).tolist() == [0, 2, 3, 4]


def test_a_curve_without_a_gap_stays_as_it_is() -> None:
    kept = np.array([0, 3])
    assert with_gaps(np.arange(4.0), kept, goes_on=True).tolist() == [0, 3]
    assert with_gaps(np.full(4, np.nan), kept[:0]).tolist() == []
