"""Cases: paths in a lift file, what changes, what is refused where it is not a matter of one key."""

from __future__ import annotations

import json

import pytest

from gantline.scenario import ScenarioError, StartError, load_scenario, parse_scenario
from gantline.scenario.file.tree import MapNode, parse_text
from gantline.scenario.file.tree_path import PathError, node_at, put, text_node
from gantline.scenario.file.variants import variants_of, without_cases
from gantline.scenario.tolerance import Tolerance
from gantline.statics import Statics
from gantline.study import run_cases, run_sweep, values_of
from gantline.study.moment import begin_of_step
from gantline.study.state import State, worst_of
from gantline.units import UnitError, common_dimension, quantity, si_text
from lift_text import BASE
from plumb_lift import INEXTENSIBLE, TRIANGLE, WEIGHT, plumb_lift

NAMES = "a: {b: {c: one}, b.c: {d: two}, list: [x1, y1, z1], long: [p, q, r, s]}\n"


def tree() -> MapNode:
    return parse_text(NAMES, "lift.yaml")


@pytest.mark.parametrize(
    ("path", "found"),
    [("a.b.c.d", "two"), ("a.list.y", "y1"), ("a.list.2", "y1"), ("a.long.4", "s"), ("a.b.e", None)],
)
def test_a_path_is_found_longest_match_first(path: str, found: str | None) -> None:
    assert node_at(tree(), path) == found


@pytest.mark.parametrize(
    ("path", "says"),
    [
        ("a.bb.c", "there is no 'bb' in 'a' of this file; did you mean 'b'?"),
        ("u.v", "there is no 'u' of this file; known here: 'a'"),
        ("b.c.d", "there is no 'b' of this file; did you mean 'a.b.c.d'?"),
        ("a.b.c.d.e", "'a.b.c.d' is a single value; it has no 'e'"),
        ("a.list.w", "'w' is no part of the list 'a.list'; 'x', 'y', 'z' or a place from 1 to 3 is right"),
        ("a.list.0", "'0' is no part of the list 'a.list'; 'x', 'y', 'z' or a place from 1 to 3 is right"),
        ("a.long.x", "'x' is no part of the list 'a.long'; a place from 1 to 4 is right"),
        ("a..c", "there is no '' in 'a' of this file; known here: 'b', 'b.c', 'list', 'long'"),
    ],
)
def test_a_path_that_leads_nowhere(path: str, says: str) -> None:
    with pytest.raises(PathError) as caught:
        node_at(tree(), path)
    assert str(caught.value) == says


CRANES = """
cranes:
  hook: {at: {z: z1}}
  goliath:
    travel: {speed: t}
    trolleys: {upper: {mass: m, hooks: {U1: {height: h1}}}}
  fc: {boom: {angle: b}, hooks: {H1: {height: h2}, H1.aux: {height: h3}}}
"""


@pytest.mark.parametrize(
    ("path", "found"),
    [
        ("goliath.U1.height", "h1"),
        ("goliath.upper.mass", "m"),
        ("goliath.travel.speed", "t"),
        ("hook.at.z", "z1"),
        ("fc.boom.angle", "b"),
        ("fc.H1.height", "h2"),
        ("fc.H1.aux.height", "h3"),
        ("cranes.fc.hooks.H1.height", "h2"),
        ("goliath.U1.across", None),
    ],
)
def test_cranes_trolleys_and_hooks_go_by_the_names_that_plans_have(path: str, found: str | None) -> None:
    """Wherever they stand in the file, the longest name first."""
    cranes = parse_text(CRANES, "lift.yaml")
    assert node_at(cranes, path) == found
    if found is not None:
        assert node_at(put(cranes, path, text_node("new", 1)), path) == "new"
        assert node_at(cranes, path) == found


def test_keys_of_the_file_come_before_names_of_cranes() -> None:
    file = parse_text("load: {weight: w}\ncranes: {load: {weight: c}}\n", "lift.yaml")
    assert node_at(file, "load.weight") == "w"


@pytest.mark.parametrize(
    ("path", "says"),
    [
        (
            "goliath.L.height",
            "there is no 'L' in 'cranes.goliath' of this file; known here: 'travel', 'trolleys'",
        ),
        (
            "U1.height",
            "there is no 'U1' of this file; did you mean 'cranes.goliath.trolleys.upper.hooks.U1.height'?",
        ),
    ],
)
def test_a_hook_that_no_crane_has_leads_nowhere(path: str, says: str) -> None:
    with pytest.raises(PathError) as caught:
        node_at(parse_text(CRANES, "lift.yaml"), path)
    assert str(caught.value) == says


def test_a_case_varies_a_hook_by_the_name_that_plans_have() -> None:
    """The same equilibrium as by the whole path."""
    short, long = (
        run_cases(parse_scenario(plumb_lift(f"one: {{vary: {{{path}: [0.1 m]}}}}")))
        for path in ("A.at.z", "cranes.A.at.z")
    )
    (by_name,), (by_path,) = short.of("one"), long.of("one")
    assert values_of(by_name)["sling_tension"] == values_of(by_path)["sling_tension"]


def test_an_entry_of_a_list_that_is_named_has_its_place_said() -> None:
    """The plan is a list, and people know its steps by name."""
    plan = parse_text("plan: [{step: lift off, speed: v}, {step: hold}, {step: hold}]\n", "lift.yaml")
    with pytest.raises(PathError, match=r"no part of the list 'plan' by name; it is 'plan\.1'$"):
        node_at(plan, "plan.lift off.speed")
    with pytest.raises(PathError, match=r"no part of the list 'plan'; a place from 1 to 3 is right$"):
        node_at(plan, "plan.hold.speed")


def test_what_is_put_into_a_tree_leaves_the_tree_as_it_was() -> None:
    before = tree()
    after = put(before, "a.list.z", text_node("new", 7))
    assert after["a"]["list"] == ["x1", "y1", "new"]
    assert put(before, "a.b.new", text_node("more", 7))["a"]["b"] == {"c": "one", "new": "more"}
    assert before == tree()


@pytest.mark.parametrize(
    ("texts", "dimension"),
    [
        (("1 m", "20 mm"), "length"),
        (("0", "2 deg"), "angle"),
        (("0.98", "1 %"), "ratio"),
        (("0", "0"), "ratio"),
    ],
)
def test_dimensions_in_common(texts: tuple[str, ...], dimension: str) -> None:
    assert common_dimension(*texts) == dimension


@pytest.mark.parametrize("texts", [("1 m", "2 t"), ("1", "2 m"), ("one", "2 m"), ("1 m", "nan")])
def test_quantities_without_a_common_dimension(texts: tuple[str, ...]) -> None:
    with pytest.raises(UnitError):
        common_dimension(*texts)


def test_a_value_in_si_reads_back_to_the_last_digit() -> None:
    for value, dimension in [(0.1 + 0.2, "length"), (1e-17, "angle"), (-1 / 3, "ratio"), (1e9 / 7, "stress")]:
        assert quantity(si_text(value, dimension), dimension) == value


def with_cases(*lines: str) -> str:
    return BASE + "cases:\n" + "".join(f"  {line}\n" for line in lines)


def test_what_a_case_changes() -> None:
    lines = (
        "heavy: {set: {load.weight.simulate: design, sling_defaults: {tolerance: 1 %}}}",
        "high: {vary: {cranes.hook.at.z: [0 m, 100 mm], load.heading: [5 deg]}}",
    )
    text = with_cases(*lines).replace(
        "position: [0 m, 0 m, 0 m]", "position: [0 m, 0 m, 0 m]\n  heading: 0 deg"
    )
    scenario = parse_scenario(text)
    (heavy,) = variants_of(scenario, "heavy")
    assert heavy.scenario.load is not None and heavy.scenario.load.weight.simulated == 63e3
    assert heavy.scenario.sling_defaults is not None
    assert heavy.scenario.sling_defaults.tolerance == Tolerance(0.01, "ratio")
    high = variants_of(scenario, "high")
    assert [one.scenario.hooks["hook"].height for one in high] == [20.0, 20.1]
    assert high[0].label == "cranes.hook.at.z +0 m, load.heading +5 deg"
    assert without_cases(scenario).cases is None
    assert scenario.load is not None and scenario.load.weight.simulated == 60e3


def test_too_many_combinations() -> None:
    offsets = ", ".join(f"{place} mm" for place in range(17))
    paths = ", ".join(f"cranes.hook.at.{axis}: [{offsets}]" for axis in "xz")
    with pytest.raises(ScenarioError, match="these are 289 combinations; at most 256 are allowed"):
        parse_scenario(with_cases(f"many: {{vary: {{{paths}}}}}"))


def test_all_that_is_cut_lets_the_load_fall_and_that_is_a_result() -> None:
    result = run_cases(parse_scenario(plumb_lift("gone: {cut: [SA, SB, SC, SD]}")))
    (state,) = result.of("gone")
    assert state.rest is None and state.cause == "nothing holds it, it falls without end (girder)"
    assert values_of(state)["sling_tension"] == {}
    assert not result.has_equilibria and not result.is_sound
    assert {one.state.case for one in result.worst} == {""}
    assert (
        json.loads(json.dumps(result.to_json(), allow_nan=False))["cases"][1]["states"][0]["stable"] is None
    )


def test_an_unstable_case_is_a_result() -> None:
    """The centre of gravity above a row of two lugs: the load would turn over."""
    lugs = {"A": (2.0, 0.0), "B": (-2.0, 0.0)}
    text = plumb_lift("high: {set: {load.centre_of_gravity.at.z: 3 m}}", lugs=lugs, rope=INEXTENSIBLE)
    result = run_cases(parse_scenario(text.replace("2.5 m], envelope", "2 m], envelope")))
    assert result.given.is_sound
    (state,) = result.of("high")
    assert state.rest is not None and state.rest.unstable == 1
    assert result.has_equilibria and not result.is_sound


def test_checks_of_a_case_know_nothing_of_what_it_cuts() -> None:
    """A cut sling is not slack, and has no factor; the others have to keep the limits."""
    limits = "limits: {rule: example, smallest_sling_tension_when_clear: 10 kN, load_tilt: 80 deg}\n"
    result = run_cases(parse_scenario(plumb_lift("one: {cut: SB}", more=limits)))
    (state,) = result.of("one")
    smallest = next(one for one in state.checks if one.name == "smallest_sling_tension_when_clear")
    assert smallest.value is not None and smallest.element != "SB"
    assert "SB" not in {one.element for one in state.checks}
    assert set(values_of(state)["sling_tension"]) == {"SA", "SC", "SD"}


def test_the_worst_of_each_element() -> None:
    text = plumb_lift(
        "light: {set: {load.weight.calculated: 200 t}}\nheavy: {set: {load.weight.simulate: design}}"
    )
    result = run_cases(parse_scenario(text))
    worst = {(one.quantity, one.element): one for one in result.worst}
    high, low = worst["sling_tension", "SA"], worst["smallest_sling_tension", "SA"]
    assert (high.state.case, low.state.case) == ("heavy", "light")
    assert high.given == pytest.approx(WEIGHT / 4, rel=1e-9)
    assert high.value == pytest.approx(1.1 * WEIGHT / 4, rel=1e-9)
    assert low.value == pytest.approx(WEIGHT / 6, rel=1e-9)
    # What no case changes is worst as given.
    assert worst["hook_load", "A"].state.case == "heavy"


@pytest.mark.parametrize(
    ("quantity", "given", "other", "is_worse"),
    [
        ("load_tilt", 1e-17, 9e-17, False),
        ("load_tilt", 0.0, 2e-9, True),
        ("smallest_sling_tension", 3e-8, 2e-8, False),
        ("smallest_sling_tension", 3.0, 2.0, True),
        ("sling_tension", 6e5, 6e5 * (1.0 + 5e-10), False),
        ("sling_tension", 6e5, 6e5 * (1.0 + 2e-9), True),
        ("sheave_travel", 1e-12, -2e-12, False),
        ("sheave_travel", 1.0, -1.1, True),
    ],
)
def test_of_values_that_differ_by_rounding_the_first_is_worst(
    monkeypatch: pytest.MonkeyPatch, quantity: str, given: float, other: float, is_worse: bool
) -> None:
    values = {"": given, "case": other}
    monkeypatch.setattr(
        "gantline.study.state.values_of", lambda state: {quantity: {"one": values[state.case]}}
    )
    states = [State(name, "", "none", 0.0) for name in values]
    (worst,) = worst_of(states)
    assert worst.state.case == ("case" if is_worse else "")


def test_slack_slings_answer_to_no_length() -> None:
    text = with_cases("off: {vary: slings.tolerance, pattern: worst}")
    (state,) = run_cases(parse_scenario(text)).of("off")
    assert state.variant == "lengths change no tension" and state.rest is not None


def test_a_length_with_which_nothing_can_start_is_a_result() -> None:
    """Slings that do not stretch and are too short for where the load starts."""
    text = plumb_lift(
        "off: {vary: {slings.SA.length: [-1 m, 0 m]}}", lugs=TRIANGLE, rope=INEXTENSIBLE
    ).replace("SA: {from", "SA: {length: 10 m, from")  # fmt: skip
    result = run_cases(parse_scenario(text), 5.0)
    short, right = result.of("off")
    assert not short.starts and short.rest is None and short.time == 5.0
    assert short.cause.startswith("slings.SA: the sling is 9 m, but from 'A' to 'girder.A' it is 10.000 m")
    assert "2 %" not in short.cause, "what does not stretch has no share by which it may"
    assert right.is_sound
    assert result.has_equilibria and not result.is_sound
    states = result.to_json()["cases"][1]["states"]
    assert [(one["starts"], one["equilibrium"]) for one in states] == [(False, False), (True, True)]


def test_slings_may_be_stretched_by_a_fiftieth_at_the_start() -> None:
    """10 m to go: 9.8040 m are 1.9992 % too short, and 9.8038 m 2.0013 %."""
    lengths = "near: {set: {slings.SA.length: 9.8040 m}}\nfar: {set: {slings.SA.length: 9.8038 m}}"
    result = run_cases(parse_scenario(plumb_lift(lengths)))
    assert result.of("near")[0].starts
    assert "stretched by 2.0013 %, and a start allows 2 %; lower the hook" in result.of("far")[0].cause


def test_a_change_that_is_wrong_as_such_is_no_case_that_cannot_start() -> None:
    """An offset of more than the weight itself leaves no load."""
    text = plumb_lift("off: {vary: {load.weight.calculated: [-400 t]}}")
    with pytest.raises(
        ScenarioError, match=r"cases\.off\.vary: load\.weight\.calculated: .* is negative"
    ) as caught:
        run_cases(parse_scenario(text))
    assert not isinstance(caught.value, StartError)


def test_when_steps_begin() -> None:
    question = Statics(parse_scenario(BASE))
    assert begin_of_step(question, "hoist") == 0.0
    # 10 s, and 0.5 s to brake 0.05 m/s at 0.1 m/s².
    assert begin_of_step(question, "hold") == pytest.approx(10.5, abs=1e-9)
    late = BASE.replace("brake_from: 10 s", "by: 10 m")
    assert begin_of_step(Statics(parse_scenario(late)), "hold") is None
    text = late + "cases: {cut: {cut: S1, at_step: hold}}\n"
    with pytest.raises(ScenarioError, match=r"cases\.cut\.at_step: 'hold' does not begin within the 20 s"):
        run_cases(parse_scenario(text))
    text = with_cases("cut: {cut: S1, at_step: hold, after: 10 s}")
    with pytest.raises(ScenarioError, match=r"cases\.cut\.after: that is at 20\.5 s, after the end"):
        run_cases(parse_scenario(text))


def test_a_cut_has_a_time_of_its_own_or_that_of_all() -> None:
    scenario = parse_scenario(plumb_lift("own: {cut: SA, at: 3 s}\nall: {cut: SA}"))
    result = run_cases(scenario, 5.0)
    assert result.given.time == 5.0
    assert [result.of(name)[0].time for name in ("own", "all")] == pytest.approx([3.0, 5.0], abs=1e-12)


def test_a_sweep_goes_from_the_first_value_to_the_last() -> None:
    scenario = load_scenario("equalizer")
    points = list(run_sweep(scenario, "load.weight.calculated", "280 t", "300000 kg", 3))
    assert [point.value for point in points] == [280e3, 290e3, 300e3]
    loads = [values_of(point.state)["sling_tension"]["S3"] for point in points]
    assert loads[0] == pytest.approx(280 / 300 * loads[2], rel=1e-6)
    with pytest.raises(PathError, match="has several values"):
        list(run_sweep(scenario, "cranes.test_hook.at", "1 m", "2 m", 2))


def test_slings_without_sensitivities_are_off_one_by_one(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where the tangent answers nothing each pattern is solved all the same; the worst is not known."""

    def nothing(*_: object) -> None:
        raise RuntimeError("nothing answers smoothly")

    monkeypatch.setattr("gantline.study.cases.changes_of_tension", nothing)
    text = plumb_lift("off: {vary: slings.tolerance, pattern: each}", tolerance="0.01 %")
    states = run_cases(parse_scenario(text)).of("off")
    assert len(states) == 8 and not any(state.first_order for state in states)
    assert values_of(states[0])["sling_tension"]["SA"] < values_of(states[1])["sling_tension"]["SA"]
    with pytest.raises(
        ScenarioError, match=r"cases\.off\.vary: tensions have no .* 'pattern: each' needs none"
    ):
        run_cases(parse_scenario(text.replace("pattern: each", "pattern: worst")))
