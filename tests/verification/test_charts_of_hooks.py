"""A main and an auxiliary hook with a rating chart each, against moments and geometry by hand.

The cranes are those of `test_hooks_on_jibs.py`. Shares of both charts add up, equation (RA2).
"""

from __future__ import annotations

import math

import pytest

from boom_lift import BOW, HEEL, LENGTH, boom_lift, head, simulated
from crawler_lift import AHEAD, GAUGE, HOOK_BLOCK, crawler_lift, own_mass, own_moment
from crawler_lift import LENGTH as CRAWLER_LENGTH
from gantline.checks import values_of
from gantline.results.metrics import metrics_of
from gantline.results.recording import Recording
from of_recording import check_of

#: Place of the auxiliary hook from the head of each boom, along it and above it [m].
ALONG, ABOVE = 12.0, -5.0
CRAWLER_ALONG, CRAWLER_ABOVE = 4.0, -1.5
#: Outreach of the auxiliary hook of the floating crane at 60 deg, (BM6) from the bow [m].
OUT = HEEL[0] + (LENGTH + ALONG) * math.cos(math.radians(60)) - ABOVE * math.sin(math.radians(60)) - BOW
#: The chart of the auxiliary hook: 250 t at 40 m, 100 t at 80 m.
AUX = "{outreach: [40 m, 80 m], rated: [250 t, 100 t]}"
#: The chart of the crane: 900 t at 20 m, 300 t at 80 m.
MAIN = "    rating: {outreach: [20 m, 80 m], rated: [900 t, 300 t], trim: 3 deg, off_lead: 2 deg}\n"
HUNG = """\
L1: {parent: fc.H1, joint: {type: fixed}, mass: 300 t}
L2: {parent: fc.H2, joint: {type: fixed}, mass: 70 t}"""


def _lift(aux: str = AUX, main: str = MAIN, bodies: str = HUNG, **rest: float) -> str:
    hooks = (
        f"H1: {{type: H, height: 40 m}}\n"
        f"H2: {{type: H, along: {ALONG} m, above: {ABOVE} m, height: 60 m, rating: {aux}}}"
    )
    text = boom_lift(duration=2.0, hooks=hooks, bodies=bodies, **rest)  # type: ignore[arg-type]
    return text.replace("    luffing:", main + "    luffing:")


def _main(outreach: float) -> float:
    """What the chart of the crane rates [t]."""
    return 900.0 - (900.0 - 300.0) * (outreach - 20.0) / 60.0


def _aux(outreach: float) -> float:
    """What the chart of the auxiliary hook rates [t]."""
    return 250.0 - (250.0 - 100.0) * (outreach - 40.0) / 40.0


def _used(recording: Recording, crane: str = "fc") -> float:
    value = metrics_of(recording)[f"rating_utilisation.{crane}"]
    assert isinstance(value, float)
    return value


def test_each_hook_uses_up_a_share_of_its_own_chart() -> None:
    """350 t on the main hook and 120 t on the auxiliary, hook blocks of 50 t included: P1/R1 + P2/R2."""
    recording = simulated(_lift())
    main = 350.0 / _main(head(math.radians(60))[0] - BOW)
    aux = 120.0 / _aux(OUT)
    # Hook loads stay as they are to the 1e-5 by which falls stretch and ring.
    assert _used(recording) == pytest.approx(main + aux, rel=1e-4)
    found = check_of(recording, "hoist_load_of_rating")
    assert found.element == "crane fc"
    assert found.value == pytest.approx(main + aux, rel=1e-4)
    # Alone, each may use all of its own row.
    values = values_of(recording, "hoist_load_of_rating")
    assert values["fc.H1"] == pytest.approx(main, rel=1e-4)
    assert values["fc.H2"] == pytest.approx(aux, rel=1e-4)


def test_an_empty_auxiliary_hook_counts_its_own_weight_by_its_own_chart() -> None:
    """50 t of hook block at the row of its chart; where the chart is for hook loads it counts nothing."""
    bodies = HUNG.splitlines()[0]
    main = _main(head(math.radians(60))[0] - BOW)
    assert _used(simulated(_lift(bodies=bodies))) == pytest.approx(350.0 / main + 50.0 / _aux(OUT), rel=1e-4)
    text = _lift(bodies=bodies).replace("includes_hook_block: true", "includes_hook_block: false")
    assert _used(simulated(text)) == pytest.approx(300.0 / main, rel=1e-4)


def test_a_load_outside_of_the_chart_of_its_own_hook_is_no_lift() -> None:
    """The auxiliary hook is at 57.7 m, its chart ends at 55 m: empty it counts there, and loaded it fails."""
    short = "{outreach: [40 m, 55 m], rated: [250 t, 200 t]}"
    main = _main(head(math.radians(60))[0] - BOW)
    empty = simulated(_lift(short, bodies=HUNG.splitlines()[0]))
    assert _used(empty) == pytest.approx(350.0 / main + 50.0 / 200.0, rel=1e-4)
    found = check_of(simulated(_lift(short)), "hoist_load_of_rating")
    assert found.verdict.value == "failed"
    assert f"outreach of {OUT:.2f} m at 0.00 s is outside of the chart of fc.H2, 40.00 m to 55.00 m" in (
        found.remark
    )


def test_charts_may_be_over_different_places() -> None:
    """The crane's over the outreach, the auxiliary's over the angle of the boom, at 60 deg 150 t."""
    recording = simulated(_lift("{angle: [50 deg, 70 deg], rated: [100 t, 200 t]}"))
    main = 350.0 / _main(head(math.radians(60))[0] - BOW)
    assert _used(recording) == pytest.approx(main + 120.0 / 150.0, rel=1e-4)
    assert "and 60.00 deg" in check_of(recording, "hoist_load_of_rating").formula


def test_attitudes_of_a_hooks_chart_are_its_own_or_those_of_the_crane() -> None:
    """Its `trim: 1 deg` is its own; off-lead, which it does not say, holds as the crane has it."""
    recording = simulated(_lift("{outreach: [40 m, 80 m], rated: [250 t, 100 t], trim: 1 deg}"))
    chart = recording.rig.rating_charts[0]
    assert math.degrees(chart.trim or 0.0) == pytest.approx(3.0)
    assert math.degrees(chart.of("fc.H2").trim or 0.0) == pytest.approx(1.0)
    values = values_of(recording, "attitude_of_rating")
    assert {"trim fc", "trim fc.H2", "off_lead fc.H1", "off_lead fc.H2"} == set(values)


def test_shares_of_charts_made_of_moments_are_the_tipping_moment() -> None:
    """Charts that rate three quarters of what tips the crane at each radius: shares come to u/0.75.

    P1 (r1 - g/2) + P2 (r2 - g/2) over 0.75 of the own moment about the tipping line, (CR4). On ground of
    200 GN/m radii are those of geometry to 1 mm of 12 m of levers.
    """
    radius, main, aux = 16.0, 100e3, 40e3
    angle = math.acos((radius - AHEAD) / CRAWLER_LENGTH)
    out = AHEAD + (CRAWLER_LENGTH + CRAWLER_ALONG) * math.cos(angle) - CRAWLER_ABOVE * math.sin(angle)
    # Each sheave block weighs 1 kg.
    own = own_mass() * GAUGE / 2 - own_moment(radius)

    def chart(at: float) -> str:
        rows = [(one, 0.75 * own / (one - GAUGE / 2) / 1e3) for one in (at - 0.1, at, at + 0.1)]
        places = ", ".join(f"{one!r} m" for one, _ in rows)
        return f"{{radius: [{places}], rated: [{', '.join(f'{mass!r} t' for _, mass in rows)}]}}"

    hooks = f"""    hooks:
      H: {{type: H, height: 30 m, rating: {chart(radius)}}}
      A: {{type: H, along: {CRAWLER_ALONG} m, above: {CRAWLER_ABOVE} m, height: 40 m, rating: {chart(out)}}}
"""
    text = crawler_lift(main, slew=90.0, ground=2e11)
    begin, end = text.index("    rating: {radius"), text.index("mechanics:")
    text = text[:begin] + hooks + text[end:]
    text = text.replace(
        "plan:\n",
        f"    more: {{parent: c1.A, joint: {{type: fixed}}, mass: {aux - HOOK_BLOCK!r} kg}}\nplan:\n",
    )
    recording = simulated(text)
    tipping = (main * (radius - GAUGE / 2) + aux * (out - GAUGE / 2)) / own
    assert _used(recording, "c1") == pytest.approx(tipping / 0.75, rel=2e-4)
    simulated_tipping = float(recording.column("tipping_utilisation", "c1")[-1])
    assert simulated_tipping == pytest.approx(tipping, rel=2e-3)


def test_a_hook_that_passes_its_own_chart_is_an_overload_of_hook_and_crane() -> None:
    """120 t where its own chart has 90 t at 57.7 m, and the crane's has 626 t for 350 t."""
    recording = simulated(_lift("{outreach: [40 m, 80 m], rated: [90 t, 90 t]}"))
    assert {name for _, kind, name in recording.events() if kind == "overload"} == {"fc", "fc.H2"}
    assert values_of(recording, "hoist_load_of_rating")["fc.H2"] == pytest.approx(120.0 / 90.0, rel=1e-4)
