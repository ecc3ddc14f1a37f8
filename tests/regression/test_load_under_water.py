"""A load that was lowered through the surface as if there were no water.

Hulls of vessels and of bodies of `mechanics` displace water, a load has no hull: a module that would float
went down to the sea bed with all of its weight in the hook, without a word. Then it was told once its centre
of gravity was under, when water would have carried all of it, and only where a vessel was about.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.scenario import parse_scenario
from module_lift import BARGE, module_lift

ASHORE = "water: {density: 1000 kg/m^3}\n"


def told(around: str, lowered: float) -> list[str]:
    """Off a quay, with a vessel about or nothing but water."""
    text = module_lift(
        lowered,
        place=(60.0, 2.0),
        speed=12.0,
        duration=60.0,
        ground="ground: {level: -30 m}\n",
        around=around,
    )
    recording = gantline.simulate(parse_scenario(text))
    return [one for one in recording.attributes["warnings"] if "module goes into the water" in one]


@pytest.mark.parametrize(("around", "density"), [(BARGE, 1025.0), (ASHORE, 1000.0)], ids=["afloat", "ashore"])
@pytest.mark.parametrize(("lowered", "depth"), [(1.9, 0.0), (3.0, 1.0), (6.0, 4.0)])
def test_it_is_told_once_it_goes_under(around: str, density: float, lowered: float, depth: float) -> None:
    found = told(around, lowered)
    assert bool(found) is (depth > 0.0)
    if found:
        # From 2 m above the water, less what the sling stretches: 0.2 m/s, reached in 2 s, so 1 s later than
        # at once; told is the first sample 10 mm deep, 20 ms apart.
        stretched = 20e3 * 9.81 * 5.0 / 100e6
        exact = (2.0 + 0.01 - stretched) / 0.2 + 1.0
        when = float(found[0].split(" at ")[1].split(" s")[0])
        assert exact - 1e-6 <= when <= exact + 0.021
        deep, heavy = (float(found[0].split(words)[1].split(" ")[0]) for words in ("up to ", "carry up to "))
        assert deep == pytest.approx(depth + stretched, abs=6e-3)  # as printed
        # A box of 4 x 4 m, 3 m high.
        carried = density * 16.0 * min(depth + stretched, 3.0) / 1e3
        assert heavy == pytest.approx(carried, abs=0.05)  # as printed


def test_on_dry_land_there_is_nothing_to_go_into() -> None:
    assert told("", 6.0) == []
