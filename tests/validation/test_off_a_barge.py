"""What two vessels do to slings that are just taut between them, as `off_a_barge` and its guide tell it."""

from __future__ import annotations

import pytest

import gantline
from shown import unsaid


def test_pages_say_how_slings_snatch_that_wait_taut() -> None:
    """The hook waits 0.8 m higher, nothing is hoisted: the worst peak over what that sling has at rest."""
    lift = gantline.load_scenario("off_a_barge")
    rest = gantline.Statics(lift).equilibrium(time=200.0).recording  # the load hangs
    waiting = gantline.simulate(lift.changed({"sheerleg.H1.height": "23 m"}), duration=40.0)
    ropes = waiting.coordinates["rope"]
    peaks = dict(zip(ropes, waiting["rope_peak_tension"].values, strict=True))
    times = dict(zip(ropes, waiting["rope_peak_time"].values, strict=True))
    slings = [name for name in ropes if name.startswith("sling.")]
    shares = {name: peaks[name] / rest.column("rope_tension", name)[-1] for name in slings}
    worst = max(shares, key=lambda name: shares[name])
    assert worst == "sling.A"
    assert times[worst] == pytest.approx(28, abs=0.5)
    share = f"{100 * shares[worst]:.0f} %"
    assert unsaid("docs/guides/afloat.md", f"snatch at each other in every wave, here to {share} of") == []
    told = f"Change `height: 22.2 m` to `23 m` and see sling A with {shares[worst]:.2f} of that"
    assert unsaid("scenarios/off_a_barge/README.md", told) == []
