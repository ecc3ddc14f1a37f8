"""A load that waits low beside its guides was told to be on the wrong side of a post before it came down.

Any load whose frame was lower than the tip of the post, in line with it and farther than its radius, was
warned of at 0 s: so one that stands on a quay or a trailer before it is brought to its guides. And a frame
whose sides begin at the rim of the tip, pressed into it from aside by rounding, was told to stand on it.
One that had passed over its post, or begun higher, and was set down far away in line with it, was on the
wrong side too.
"""

from __future__ import annotations

import pytest

from gantline.assembly import assemble
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from guided_lift import guided_lift
from led_pair import led_text


def guide(x: float, flare: str = ", flare: {length: 0.4 m, angle: 30 deg}") -> str:
    """A guide at 3.5 m of the load [m], whose post stands at x and is 1 m high."""
    post = f"post: {{at: [{x} m, 0 m, 0 m], diameter: 0.4 m, height: 1 m}}"
    frame = f"frame: {{at: [3.5 m, 0 m, 0 m], clearance: 0 mm, height: 0.6 m{flare}}}"
    return f"  g: {{{post}, {frame}, friction: 0.2}}\n"


def misses(recording: Recording) -> list[str]:
    """What is told after the run of guides that are missed."""
    return [one for one in recording.attributes["warnings"] if one.startswith("the load misses guide")]


def hoisted(way: str, height: float, post: float = 20.0) -> Recording:
    """A load aft of its post, 16.5 m if not said otherwise, that goes up, or down."""
    text = guided_lift(guide(post), height=height, plan=way, duration=40.0)
    return simulate(parse_scenario(text, "x.yaml"))


def test_a_load_that_waits_below_the_tip_has_not_missed_its_guide() -> None:
    """0.1 m over the ground, 0.9 m below the tip, and hoisted past it."""
    up = "  - {step: up, hoist: crane, speed: 6 m/min, by: 2 m}\n  - {step: rest, hold: until_end}\n"
    assert misses(hoisted(up, 0.1)) == []


_DOWN = "  - {step: down, lower: crane, speed: 6 m/min, by: 1 m}\n  - {step: rest, hold: until_end}\n"


def test_a_load_that_comes_down_there_has() -> None:
    """1.5 m aft, from 1.6 m, its lip 0.25 m over the tip; it passes that on its way down."""
    [warning] = misses(hoisted(_DOWN, 1.6, post=5.0))
    assert "the fore side of its frame is on the wrong side of the post at" in warning


def test_a_load_that_is_set_down_far_from_its_guide_has_not() -> None:
    assert misses(hoisted(_DOWN, 1.6)) == []


def test_a_frame_that_is_just_over_its_post_does_not_stand_on_it() -> None:
    """Upright sides at the rim of a post without a cone, no clearance: it runs down all of the post."""
    plan = "  - {step: down, lower: crane, speed: 3 m/min, by: 0.9 m}\n  - {step: rest, hold: until_end}\n"
    recording = simulate(
        parse_scenario(guided_lift(guide(3.5, flare=""), plan=plan, duration=22.0), "x.yaml")
    )
    assert misses(recording) == []
    assert recording.column("body_position", "module")[-1, 2] == pytest.approx(0.1 + 1.0, abs=1e-3)


def test_a_lead_takes_a_load_along() -> None:
    """As steps that travel or slew do: where the load comes down only the run knows."""
    more = "guides:\n" + guide(60.0).replace("at: [3.5 m", "at: [0 m")
    warnings = assemble(parse_scenario(led_text() + more)).warnings
    assert not any("misses guide" in one for one in warnings)
