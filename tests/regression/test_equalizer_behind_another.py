"""The close-up of an equalizer showed the one behind it too.

Two hooks of a Goliath crane stand side by side across its girder, and seen across the frame of one equalizer
the other hangs behind it, 12 m away. Its sheaves, rope and slings were drawn as well: after a swing each
sheave stood there twice, a hand's breadth apart, and slings of one stood over the numbers of the other.
"""

from __future__ import annotations

import pytest
from matplotlib.collections import PolyCollection

import gantline
from gantline.plot.views import equalizer
from gantline.results.recording import Recording


@pytest.fixture(scope="module")
def goliath() -> Recording:
    """Its first second: three equalizers hang at rest."""
    return gantline.simulate("goliath", duration=1.0)


@pytest.mark.parametrize("index", [0, 1, 2])
def test_a_close_up_shows_its_own_sheaves(goliath: Recording, index: int) -> None:
    """Five moving sheaves and four fixed ones, none of them twice: E1 hangs before E2, E3 beside both."""
    figure = equalizer(goliath, goliath.rig.equalizers[index])
    assert figure is not None
    panel = figure.axes[0]
    sheaves = [one for one in panel.collections if isinstance(one, PolyCollection) and one.zorder == 3.5]
    assert [len(one.get_paths()) for one in sheaves] == [9]
