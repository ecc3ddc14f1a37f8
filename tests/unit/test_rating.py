"""Rating charts on recordings of given numbers, and how lift files say them."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from pydantic import ValidationError

from gantline.assembly import assemble
from gantline.checks.check import Check, Verdict
from gantline.checks.force import UNRAISED
from gantline.checks.ratings import kept_back
from gantline.checks.run import check_recording, values_of
from gantline.results.cranes.rating import chart_used, overloads
from gantline.results.cranes.rating_chart import RatingChart
from gantline.results.recording import Recording
from gantline.results.variable import Variable
from gantline.rule_data import several_cranes
from gantline.scenario import parse_scenario
from gantline.scenario.cranes.rating import Rating
from gantline.scenario.file.tree import ListNode, MapNode, TextNode
from of_recording import check_of, checks_of
from rated_lift import RADII, RATED, T, recording

FLOATING_CRANE = Path(__file__).resolve().parents[2] / "scenarios" / "floating_crane" / "scenario.yaml"


def node(text: str | list[str]) -> Any:
    return ListNode([TextNode(one) for one in text]) if isinstance(text, list) else TextNode(text)


def rating(**given: str | list[str]) -> Rating:
    return Rating.model_validate(MapNode({key: node(text) for key, text in given.items()}))


def check(of: Recording, key: str = "hoist_load_of_rating") -> Check:
    return check_of(of, key)


def hung_clear(of: Recording) -> Recording:
    """The same with an upright load that nothing supports, of the design weight."""
    load = {"name": "load", "body": "load", "weight": 1.0, "contacts": []}
    rig = {**of.attributes["rig"], "loads": [load]}
    upright = np.tile([1.0, 0.0, 0.0, 0.0], (len(of.time), 1, 1))
    turned = Variable(("time", "body", "quaternion"), upright, "1", "orientation of a body")
    variables = {**of.variables, "body_orientation": turned}
    return Recording(variables, {**of.coordinates, "body": ("load",)}, {**of.attributes, "rig": rig})


def rated(of: Recording) -> dict[str, float]:
    """What cranes and hooks use of their charts."""
    return values_of(of, "hoist_load_of_rating")


def test_the_worst_moment_is_where_load_and_radius_make_it() -> None:
    """150 t at 13 m (321.5 t), 150 t at 17 m (213 t), 160 t at 16 m (231 t): the second governs."""
    found = check(recording([[13.0], [17.0], [16.0]], [[150.0], [150.0], [160.0]]))
    assert found.value == pytest.approx(150 / 213)
    assert (found.verdict, found.element, found.time) == (Verdict.OK, "crane c1", 1.0)
    assert "17.00 m" in found.formula


def test_more_than_is_rated_fails() -> None:
    found = check(recording([[18.0], [18.0]], [[100.0], [196.0]]))
    assert found.verdict is Verdict.FAILED
    assert found.value == pytest.approx(196 / 195)


@pytest.mark.parametrize(("radius", "words"), [(18.5, "18.50 m at 1.00 s"), (11.0, "11.00 m at 1.00 s")])
def test_outside_of_the_chart_nothing_may_hang(radius: float, words: str) -> None:
    found = check(recording([[14.0], [radius]], [[10.0], [10.0]]))
    assert found.verdict is Verdict.FAILED
    assert words in found.remark
    assert found.remark.endswith("12.00 m to 18.00 m: no lift: crane c1") and found.value is None


def test_no_number_says_what_is_used_outside_of_the_chart() -> None:
    """10 t at 14 m use 10/283; at 18.5 m, past the last row, whatever hangs is too much."""
    of = recording([[14.0], [18.5]], [[10.0], [10.0]])
    (chart,) = of.rig.rating_charts
    assert chart_used(of, chart) == pytest.approx([10 / 283, math.inf])


def test_one_hook_of_several_outside_of_the_chart_is_enough() -> None:
    """Both hang at 14 m, then the second at 18.5 m: neither may any more."""
    found = check(recording([[14.0, 14.0], [14.0, 18.5]], [[50.0, 50.0]] * 2))
    assert (found.verdict, found.value) == (Verdict.FAILED, None)
    said = "radius of 18.50 m at 1.00 s is outside of the chart, 12.00 m to 18.00 m: no lift"
    assert found.remark == f"{said}: crane c1, H1"


def test_where_a_row_has_nothing_nothing_may_hang() -> None:
    """0 t at 16 m: of 283 t at 14 m a twentieth is left at 15.9 m. An empty hook, of 9 t, may be there."""
    rated = (360 * T, 283 * T, 0.0, 0.0)
    found = check(recording([[15.9], [14.0]], [[10.0], [100.0]], rated=rated))
    assert found.value == pytest.approx(10 / 14.15) and found.verdict is Verdict.OK
    found = check(recording([[14.0], [16.0], [17.0]], [[10.0], [10.0], [10.0]], rated=rated))
    assert found.verdict is Verdict.FAILED
    assert found.remark == "nothing may hang at 16.00 m, at 1.00 s: crane c1" and found.value is None
    found = check(recording([[14.0], [16.0], [14.0]], [[10.0], [9.0], [10.0]], rated=rated))
    assert found.value == pytest.approx(10 / 283) and found.verdict is Verdict.OK


def test_how_it_comes_to_what_it_says() -> None:
    """150 t are 1471.5 kN, 231 t 2266.1 kN; of 283 t, 2776.2 kN, a hook has 40 %."""
    alone = check(recording([[16.0]] * 2, [[150.0]] * 2))
    assert alone.formula == "1471.5 kN / 2266.1 kN at 16.00 m"
    of_row = recording([[14.0, 14.0]] * 2, [[120.0, 60.0]] * 2, shares={"H0": 0.4, "H1": 0.4})
    assert check(of_row).formula == "1177.2 kN / 40 % of 2776.2 kN at 14.00 m"
    factors = {"several_cranes_factor": {"value": 1.25, "source": "our rule"}}
    of = recording([[16.0] * 2] * 2, [[150.0] * 2] * 2, cranes=("c1", "c2"), factors=factors)
    together = check(of)
    assert together.formula == "1471.5 kN x 1.25 / 2266.1 kN at 16.00 m"
    assert "our rule" in together.source and "our rule" not in alone.source


def test_one_crane_of_several_lifts_alone() -> None:
    """The second has no hook from which a sling hangs, so that the first keeps nothing back."""
    factors = {"several_cranes_factor": {"value": 1.25, "source": "our rule"}}
    of = recording([[16.0] * 2] * 2, [[150.0, 9.0]] * 2, cranes=("c1", "c2"), factors=factors)
    rig = {**of.attributes["rig"], "slings": of.attributes["rig"]["slings"][:1]}
    found = check(Recording(of.variables, of.coordinates, {**of.attributes, "rig": rig}))
    assert found.value == pytest.approx(150 / 231)


def test_a_rule_that_cannot_raise_what_never_hung_still_is_told() -> None:
    """Samples of 2 s are no hold: the peak stands for itself, and the factor is left out."""
    factors = {"dynamic_amplification_factor": {"value": 1.2, "source": "our rule"}}
    still, plain = (check(recording([[16.0]] * 2, [[150.0]] * 2, factors=one)) for one in (factors, None))
    assert still.value == plain.value == pytest.approx(150 / 231)
    assert (still.verdict, plain.verdict) == (Verdict.WARNING, Verdict.OK)
    assert UNRAISED in still.remark and not plain.remark


def test_a_crane_beside_two_that_lift_together() -> None:
    """Nothing is slung in its hook: what it bears is no share of theirs."""
    factors = {"several_cranes_factor": {"value": 1.25, "source": "our rule"}}
    three = ("c1", "c2", "c3")
    of = recording([[16.0] * 3] * 2, [[150.0] * 3] * 2, cranes=three, factors=factors)
    rig = {**of.attributes["rig"], "slings": of.attributes["rig"]["slings"][:2]}
    two = Recording(of.variables, of.coordinates, {**of.attributes, "rig": rig})
    assert [kept_back(two, crane) for crane in three] == [(1.25, []), (1.25, []), (1.0, [])]


def test_an_empty_hook_may_be_anywhere() -> None:
    found = check(recording([[14.0], [30.0]], [[100.0], [9.0]]))
    assert found.verdict is Verdict.OK
    assert found.value == pytest.approx(100 / 283)


def test_a_hook_has_its_share_of_the_row() -> None:
    """Two hooks at 14 m: 120 and 60 t of 283 t together, and of 40 % of it alone."""
    of = recording([[14.0, 14.0]] * 2, [[120.0, 60.0]] * 2, shares={"H0": 0.4, "H1": 0.4})
    found = check(of)
    assert found.element == "H0"
    assert found.value == pytest.approx(120 / (0.4 * 283))
    assert found.verdict is Verdict.FAILED


def test_the_hook_that_reaches_farthest_decides_for_the_crane() -> None:
    of = recording([[14.0, 18.0]] * 2, [[100.0, 80.0]] * 2)
    assert check(of).value == pytest.approx(180 / 195)


def test_cranes_that_lift_together_keep_capacity_back() -> None:
    """Three cranes, 150 t each: 150 x 1.33 of 231 t at 16 m passes, of 195 t at 18 m it does not."""
    three = ("c1", "c2", "c3")
    factor = several_cranes("queensland", 3)
    assert factor is not None
    factors = {"several_cranes_factor": {"value": factor.value, "source": factor.source}}
    near = check(recording([[16.0] * 3] * 2, [[150.0] * 3] * 2, cranes=three, factors=factors))
    assert near.value == pytest.approx(150 * 1.33 / 231)
    assert near.verdict is Verdict.OK
    assert "14.3.2: 3 cranes" in near.source
    far = check(recording([[18.0] * 3] * 2, [[150.0] * 3] * 2, cranes=three, factors=factors))
    assert far.value == pytest.approx(150 * 1.33 / 195)
    assert far.verdict is Verdict.FAILED


def test_what_is_kept_back_is_on_the_weight_by_the_rule_too() -> None:
    """Two cranes hold 141 t still, each below a hook block of 9 t: (141 x 1.2 + 9) x 1.25 of 231 t."""
    factors = {
        "several_cranes_factor": {"value": 1.25, "source": "our rule"},
        "dynamic_amplification_factor": {"value": 1.2, "source": "our rule"},
    }
    of = recording([[16.0] * 2] * 8, [[150.0] * 2] * 8, cranes=("c1", "c2"), factors=factors)
    used = (141 * 1.2 + 9) * 1.25 / 231
    assert rated(hung_clear(of)) == pytest.approx({"crane c1": used, "crane c2": used})


def test_the_weight_by_the_rule_counts_where_least_may_hang() -> None:
    """91 t hang in a hook block of 9 t at 14 to 18 m and back: 91 x 1.2 + 9 of the 195 t at 18 m."""
    factors = {"dynamic_amplification_factor": {"value": 1.2, "source": "our rule"}}
    radii = [14.0, 15.0, 16.0, 17.0, 18.0, 17.0, 16.0, 15.0]
    of = recording([[radius] for radius in radii], [[100.0]] * 8, factors=factors)
    assert rated(hung_clear(of)) == pytest.approx({"crane c1": (91 * 1.2 + 9) / 195})


def test_without_a_rule_for_several_cranes_there_is_a_warning() -> None:
    found = check(recording([[16.0] * 2] * 2, [[150.0] * 2] * 2, cranes=("c1", "c2")))
    assert found.verdict is Verdict.WARNING
    assert "2 cranes lift together" in found.remark
    assert found.value == pytest.approx(150 / 231)


def test_factors_of_the_rule_by_number_of_cranes() -> None:
    """Mobile crane code of practice 2006, Queensland, 14.3.2: 20, 33 and 50 % over the share."""
    found = {count: several_cranes("queensland", count) for count in (1, 2, 3, 4, 6)}
    assert found[1] is None
    assert [one.value for one in found.values() if one] == [1.20, 1.33, 1.50, 1.50]


@pytest.mark.parametrize(("lead", "verdict"), [(0.9, Verdict.OK), (1.1, Verdict.FAILED)])
def test_a_chart_holds_for_falls_that_are_plumb(lead: float, verdict: Verdict) -> None:
    of = recording([[14.0]] * 2, [[100.0]] * 2, lead=math.radians(lead))
    found = check(of, "attitude_of_rating")
    assert found.verdict is verdict
    assert found.value == pytest.approx(lead)
    assert found.element == "off_lead H0"


@pytest.mark.parametrize("key", ["heel", "trim"])
def test_a_chart_holds_for_a_crane_that_stands_level(key: str) -> None:
    """1.2 deg to the other side, of 1 deg, while it bears 100 t; 3 deg of the empty hook do not count."""
    of = recording([[14.0]] * 3, [[100.0], [100.0], [9.0]])
    rig = of.attributes["rig"]
    charts = [{**one, "heel": math.radians(1.0), "trim": math.radians(1.0)} for one in rig["rating_charts"]]
    leans = Variable(("time", "crane"), np.radians([[0.4], [-1.2], [3.0]]), "rad", "")
    attributes = {**of.attributes, "rig": {**rig, "rating_charts": charts}}
    leant = Recording({**of.variables, f"crane_{key}": leans}, of.coordinates, attributes)
    found = check(leant, "attitude_of_rating")
    assert (found.verdict, found.element, found.time) == (Verdict.FAILED, f"{key} c1", 1.0)
    assert found.value == pytest.approx(1.2)


def in_waves(*trains: dict[str, Any]) -> Recording:
    """A crane whose chart holds up to 1 m bears 100 t in waves."""
    of = recording([[14.0]] * 2, [[100.0]] * 2)
    rig = of.attributes["rig"]
    charts = [{**one, "significant_height": 1.0} for one in rig["rating_charts"]]
    waves = [{"name": str(at), "direction": 0.0, "period": 7.0, **one} for at, one in enumerate(trains)]
    sea = {"sea": {"trains": waves}} if trains else {}
    return Recording(
        of.variables, of.coordinates, {**of.attributes, "rig": {**rig, "rating_charts": charts, **sea}}
    )


@pytest.mark.parametrize(
    ("trains", "height"),
    [
        # A sea of 4 standard deviations; two of them, 0.6 m and 0.7 m, whose variances add up.
        ([{"height": 1.1}], 1.1),
        ([{"height": 0.9}], 0.9),
        ([{"height": 0.6}, {"height": 0.7}], math.hypot(0.6, 0.7)),
        # The variance of a wave of the amplitude 0.4 m is 0.4²/2, and 4 of its roots 1.13 m.
        ([{"height": 0.8, "is_regular": True}], 4.0 * 0.4 / math.sqrt(2.0)),
    ],
)
def test_a_chart_holds_up_to_waves(trains: list[dict[str, Any]], height: float) -> None:
    found = check(in_waves(*trains), "attitude_of_rating")
    assert found.element == "significant_height c1"
    assert found.value == pytest.approx(height)
    assert found.verdict is (Verdict.OK if height <= 1.0 else Verdict.FAILED)


def test_in_still_water_a_chart_for_waves_holds() -> None:
    assert not any(
        one.element.startswith("significant") for one in checks_of(in_waves(), "attitude_of_rating")
    )


def test_a_lift_file_says_up_to_which_waves_a_chart_holds() -> None:
    """The swell of the scenario has 0.8 m, and its chart none that it would end at."""
    text = (FLOATING_CRANE.parents[1] / "crane_barge_in_swell" / "scenario.yaml").read_text()
    of_height = text.replace("    rating:\n", "    rating:\n      significant_height: 0.5 m\n")
    scenario = parse_scenario(of_height, source=str(FLOATING_CRANE.parents[1] / "crane_barge_in_swell" / "x"))
    (chart,) = assemble(scenario).rig["rating_charts"]
    assert chart["significant_height"] == 0.5


def test_an_empty_hook_beside_the_load_may_swing() -> None:
    """Of two hooks at one boom, of 9 t each, the second bears 91 t; both hang 1.1 deg out of plumb."""
    of = recording([[14.0, 14.0]] * 2, [[9.0, 100.0]] * 2, lead=math.radians(1.1))
    found = check(of, "attitude_of_rating")
    assert (found.verdict, found.element) == (Verdict.FAILED, "off_lead H1")
    empty = recording([[14.0, 14.0]] * 2, [[9.0, 9.0]] * 2, lead=math.radians(1.1))
    assert not any(one.name == "attitude_of_rating" and one.value for one in check_recording(empty))


def test_a_chart_over_angles_is_read_by_the_angle() -> None:
    chart = RatingChart("fc", "angle", (math.radians(45), math.radians(75)), (1500 * T, 3600 * T))
    between = chart.rated_at(np.radians([45.0, 60.0, 75.0, 44.9, 75.1]))
    assert between == pytest.approx([1500 * T, 2550 * T, 3600 * T, 0.0, 0.0])


def test_between_rows_the_lower_of_both_if_the_chart_says_so() -> None:
    """12 to 18 m in steps of 2 m: at a row that row, to rounding, between two that which is rated for less;
    of a chart over angles, which rises, as well.
    """
    chart = RatingChart("c1", "radius", RADII, RATED, between="lower")
    places = np.array([[12.0, 12.0 + 1e-12, 12.1, 14.0 - 1e-12], [14.0, 15.0, 18.0, 18.1]])
    assert (chart.rated_at(places) / T).tolist() == [[360.0, 360.0, 283.0, 283.0], [283.0, 231.0, 195.0, 0.0]]
    over = RatingChart("fc", "angle", (1.0, 1.2, 1.4), (1.0, 3.0, 2.0), between="lower")
    assert over.rated_at(np.array([1.0, 1.1, 1.2, 1.3, 1.4])).tolist() == [1.0, 1.0, 3.0, 2.0, 2.0]


def test_a_lift_file_says_what_holds_between_rows() -> None:
    """A chart without a word is interpolated, as it was."""
    text = FLOATING_CRANE.read_text(encoding="utf-8")
    found = []
    for words in ("", "between: lower"):
        scenario = parse_scenario(
            text.replace("rating:\n", f"rating:\n      {words}\n", 1), str(FLOATING_CRANE)
        )
        found.append(assemble(scenario).rig["rating_charts"][0]["between"])
    assert found == ["lines", "lower"]


def test_moments_at_which_a_chart_is_passed() -> None:
    """250 t carried out from 13 to 17 m in 4 s: 250 t are rated between 14 and 16 m, at 15.269 m."""
    chart = RatingChart("c1", "radius", RADII, RATED)
    time = np.arange(5.0)
    out = 13.0 + time
    # Between samples on a line of the load less what is rated: -7 t at 15 m, 19 t at 16 m.
    rated = chart.rated_at(out)
    assert overloads(time, np.full(5, 250 * T), rated) == pytest.approx([2.0 + 7 / 26])
    assert overloads(time, np.full(5, 190 * T), rated) == []
    outside = chart.rated_at(out + 2.0)  # at 19 m
    assert overloads(time, np.full(5, 10 * T), outside) == pytest.approx([3 + 185 / 195])
    assert overloads(time, np.zeros(5), chart.rated_at(out + 20.0)) == []


def test_a_table_may_rise_or_fall() -> None:
    chart = rating(angle=["75 deg", "60 deg", "45 deg"], rated=["3600 t", "3000 t", "1500 t"])
    assert chart.over == "angle"
    assert [round(math.degrees(at)) for at, _ in chart.rows] == [45, 60, 75]
    assert [mass for _, mass in chart.rows] == [1.5e6, 3e6, 3.6e6]


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"rated": ["1 t", "2 t"]}, "found none of them"),
        (
            {"radius": ["1 m", "2 m"], "angle": ["1 deg", "2 deg"], "rated": ["1 t", "2 t"]},
            "found 'radius' and 'angle'",
        ),
        ({"radius": ["1 m", "2 m"], "rated": ["1 t", "2 t", "3 t"]}, "3 loads stand beside 2 places"),
        ({"radius": ["1 m", "3 m", "2 m"], "rated": ["3 t", "2 t", "1 t"]}, "'radius' is not in order"),
        ({"radius": ["1 m", "1 m"], "rated": ["3 t", "2 t"]}, "'radius' is not in order"),
        ({"radius": ["1 m", "2 m"], "rated": ["0 t", "0 t"]}, "nothing may hang anywhere"),
        ({"radius": ["1 m"], "rated": ["1 t"]}, "at least 2 are needed"),
        ({"radius": ["1 m", "2 m"], "rated": ["2 t", "1 t"], "hooks_share": "130 %"}, "130 % is more than"),
        ({"radius": ["1 t", "2 m"], "rated": ["2 t", "1 t"]}, "needed is a length"),
    ],
)
def test_what_is_no_table_is_refused(given: dict[str, Any], words: str) -> None:
    with pytest.raises(ValidationError) as refused:
        rating(**given)
    assert words in str(refused.value)


@pytest.mark.parametrize(
    ("at_50", "warnings"),
    [
        ("1900 t", []),
        (
            "2500 t",
            [
                "the rating chart of fc has 2500.0 t at 50.0 deg and only 2400.0 t at 55.0 deg, nearer by; "
                "charts fall outwards"
            ],
        ),
    ],
)
def test_a_chart_that_rises_outwards_is_told(at_50: str, warnings: list[str]) -> None:
    text = FLOATING_CRANE.read_text(encoding="utf-8").replace("1900 t", at_50)
    assert [one for one in assemble(parse_scenario(text)).warnings if "chart" in one] == warnings
