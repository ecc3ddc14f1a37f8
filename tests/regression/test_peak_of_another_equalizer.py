"""The picture of an equalizer had its `peak tension` while its own slings carried less than at its end.

A load of 300 t was turned by three hooks. The slings of the third, which hang from no equalizer, had the
peak of the lift, 860 kN at 91.8 s; those of equalizer E1 carried 141 kN then and 229 kN at the end, with
232 kN at 1110.7 s. The close-up of E1 had the moment of the whole lift, and so had `slings taut`.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from gantline.plot.moments import moments
from gantline.plot.views import equalizer, system
from gantline.results.recording import Recording
from sample_lift import ringing_lift


def _lift() -> Recording:
    """Two slings carry 200 kN from 5 s on, at 30 s 300 kN; three 600 kN from 10 s on, at 12 s 900 kN."""
    time = np.linspace(0.0, 40.0, 2001)
    own = np.where(time < 5.0, 0.0, 200e3)
    others = np.where(time < 10.0, 0.0, 600e3)
    own[np.argmin(np.abs(time - 30.0))] = 300e3
    others[np.argmin(np.abs(time - 12.0))] = 900e3
    return ringing_lift(tension=np.column_stack([own, own, others, others, others]))


def test_a_close_up_has_the_peak_of_its_own_slings() -> None:
    """And the moment at which these came taut."""
    recording = _lift()
    which = recording.rig.equalizers[0]
    figure = equalizer(recording, replace(which, slings=which.slings[:2]))
    assert figure is not None
    titles = [panel.get_title() for panel in figure.axes]
    assert "peak tension\n30.00 s" in titles
    assert "slings taut\n5.00 s" in titles


def test_the_whole_system_has_that_of_all_slings() -> None:
    """As it had: the largest of any sling is at 12 s, the last came taut at 10 s, as the load lifts off."""
    recording = _lift()
    picture = system(recording)
    assert picture is not None
    assert "peak tension\n12.00 s" in [panel.get_title() for panel in picture.axes]
    times = {one.name: one.time for one in moments(recording)}
    assert (times["slings taut"], times["peak tension"]) == pytest.approx((10.0, 12.0))
