"""Types of cranes, vessels, lines and their like: what several things have in common, said once."""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st

from ballasted import barge, tank
from ballasted import text as text_of_lift
from gantline.scenario import Scenario, ScenarioError, json_schema, load_scenario, parse_scenario
from gantline.scenario.cranes.crawler import Crawler
from gantline.scenario.file.types import TYPED
from gantline.scenario.file.variants import variants_of
from gantline.simulation import Simulation
from gantline.study import solve_ballast

ROOT = Path(__file__).resolve().parents[2] / "scenarios"
#: Things of shipped lifts that may have types, of every section.
THINGS = {
    "cranes": ("goliath", "revolving_crane", "upending", "reeved_hoist"),
    "vessels": ("crane_barge_in_swell", "off_a_barge"),
    "mooring_lines": ("crane_barge_in_swell", "floating_crane"),
    "fenders": ("off_a_barge",),
    "spreaders": ("spreader_bar",),
    "guides": ("onto_a_platform",),
}
BARGE = barge({})
PAIR = "floating_crane_and_crawlers"


@cache
def written(name: str) -> str:
    """A shipped lift as JSON, every scalar as its text."""
    return json.dumps(load_scenario(ROOT / name).changed({}).tree_as_written)


@cache
def validator() -> jsonschema.Draft7Validator:
    return jsonschema.Draft7Validator(json_schema())


def split(whole: dict[str, Any], draw: st.DrawFn) -> tuple[dict[str, Any], dict[str, Any]]:
    """A mapping in two, whose parts together are it: what the type says, and what the thing says itself.

    Some of it both say, and what the thing says counts.
    """
    of_type: dict[str, Any] = {}
    own: dict[str, Any] = {}
    for key, value in whole.items():
        ways = ("type", "own", "both", "within") if isinstance(value, dict) else ("type", "own", "both")
        match draw(st.sampled_from(ways)):
            case "type":
                of_type[key] = value
            case "own":
                own[key] = value
            case "both":
                of_type[key] = own[key] = value
            case _:
                parts = split(value, draw)
                of_type |= {key: parts[0]} if parts[0] else {}
                own |= {key: parts[1]} if parts[1] else {}
    return of_type, own


@st.composite
def typed_lifts(draw: st.DrawFn) -> tuple[str, str, dict[str, Any]]:
    """A shipped lift, the section in which its things have types of their own, and its text with them."""
    section = draw(st.sampled_from(sorted(THINGS)))
    name = draw(st.sampled_from(THINGS[section]))
    lift = json.loads(written(name))
    types = {}
    of = next(one for one in TYPED if one.section == section)
    for thing in list(lift[section]):
        whole = lift[section][thing]
        kind = {key: whole.pop(key) for key in ("type",) if key in whole}
        of_type, own = split(whole, draw)
        types[f"of_{thing}"] = {**kind, **of_type}
        lift[section][thing] = {"type": f"of_{thing}", **own}
    lift[of.types] = types
    return name, section, lift


@settings(max_examples=60, suppress_health_check=[HealthCheck.too_slow], deadline=None)
@given(typed_lifts())
def test_a_lift_with_types_is_the_same_as_one_that_is_written_out(
    given_lift: tuple[str, str, dict[str, Any]],
) -> None:
    """However what things have is divided among them and their types, mapping by mapping."""
    name, section, lift = given_lift
    of = next(one for one in TYPED if one.section == section)
    assume(all(lift[of.types].values()))  # a type that says nothing is refused
    plain = load_scenario(ROOT / name).changed({})
    typed = parse_scenario(lift, str(ROOT / name / "scenario.yaml"))
    for field in Scenario.model_fields:
        if field == section:
            for thing, one in (getattr(plain, section) or {}).items():
                other = getattr(typed, section)[thing]
                differ = [key for key in type(one).model_fields if getattr(one, key) != getattr(other, key)]
                assert differ in ([], ["type"]), thing
        elif field != of.types:
            assert getattr(plain, field) == getattr(typed, field), field
    assert [error.message for error in validator().iter_errors(lift)] == []


def refused(text: str) -> list[str]:
    with pytest.raises(ScenarioError) as error:
        parse_scenario(text, str(ROOT / PAIR / "scenario.yaml"))
    return [one.message for one in error.value.problems]


def replaced(old: str, new: str) -> str:
    text = (ROOT / PAIR / "scenario.yaml").read_text(encoding="utf-8")
    assert old in text
    return text.replace(old, new)


def crawler(lift: Scenario, name: str) -> Crawler:
    crane = (lift.cranes or {})[name]
    assert isinstance(crane, Crawler)
    return crane


KINDS = "'fixed_hook', 'goliath', 'floating_crane' or 'crawler'"
NO_TYPE = f"cranes.c1: 'type' is missing; a crane is one of {KINDS.replace(' or', ',')}"


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        (
            "base_mass: 190 t",
            "base_mass: 190 kN",
            ["crane_types.crawler_400.base_mass: '190 kN' is a force; needed is a mass"],
        ),
        (
            "base_mass: 190 t",
            "base_mas: 190 t",
            ["crane_types.crawler_400.base_mas: 'base_mas' is not a key of a crawler crane; did you mean"],
        ),
        (
            "    base_mass: 190 t\n",
            "",
            ["cranes.c1: 'base_mass' is missing; a crawler", "cranes.c2: 'base_mass' is missing; a crawler"],
        ),
        ("mass: 60 t, ", "", ["crane_types.crawler_400.boom: 'mass' is missing; a boom needs it"]),
        (
            "c1: {type: crawler_400",
            "c1: {type: crawler_40",
            ["cranes.c1.type: 'crawler_40' is not a name of 'crane_types'; did you mean 'crawler_400'?"],
        ),
        (
            "c1: {type: crawler_400",
            "c1: {type: CC2800",
            ["cranes.c1.type: 'CC2800' is not a type of crane; known here: 'fixed_hook', 'goliath', "],
        ),
        ("c1: {type: crawler_400", "c1: {type: sheerleg", ["cranes.c1.type: a 'sheerleg' is written as"]),
        ("c1: {type: crawler_400, ", "c1: {", [NO_TYPE]),
        (
            "c1: {type: crawler_400, ",
            "c1: {like: crawler_400, ",
            [f"{NO_TYPE} (is 'like' meant for 'type'?)"],
        ),
        (
            "    type: crawler\n",
            "",
            [f"crane_types.crawler_400: 'type' is missing; a type of crane says its kind, {KINDS}"],
        ),
        (
            "    type: crawler\n",
            "    type: crawler_400\n",
            [f"crane_types.crawler_400.type: 'crawler_400' is a type, too; a type says its kind, {KINDS}"],
        ),
        (
            "radius: 16 m,",
            "radius: 500 m,",
            ["crane_types.crawler_400.boom.radius: the head of this boom does not come to a radius of 500 m"],
        ),
        (
            "slew: -90 deg",
            "slew: -90 deg, boom: {radius: 500 m}",
            ["cranes.c1.boom.radius: the head of this boom does not come to a radius of 500 m"],
        ),
        (
            "H: {type: hook_200",
            "H: {type: hook_2000",
            ["crane_types.crawler_400.hooks.H.type: 'hook_2000' is not a name of 'hook_types'; did you mean"],
        ),
        (
            "crane_types:\n",
            "crane_types:\n  spare: {type: crawler, base_mass: 3 kN, boom: {mas: 3 t, length: 3}}\n",
            [
                "crane_types.spare.base_mass: '3 kN' is a force",
                "crane_types.spare.boom.length: '3' has no unit",
                "crane_types.spare.boom.mas: 'mas' is not a key of a boom; did you mean 'mass'?",
            ],
        ),
        (
            "crane_types:\n",
            "crane_types:\n  spare: crawler\n",
            ["crane_types.spare: found 'crawler'; a mapping of what things of this type have is needed"],
        ),
        (
            "crane_types:\n",
            "crane_types:\n  goliath: {type: goliath, span: 90 m}\n",
            ["crane_types.goliath: 'goliath' is a kind of crane; another name for a type of yours is right"],
        ),
        (
            "crane_types:\n",
            "vessel_types: {b: {type: c, draft: 3 m}}\ncrane_types:\n",
            ["vessel_types.b.type: a type of vessel has no type itself; leave it out"],
        ),
        (
            "vessels:\n  barge:\n",
            "vessels:\n  barge:\n    type: pontoon\n",
            ["vessels.barge.type: 'pontoon' is not a name of 'vessel_types'; there is none"],
        ),
    ],
)
def test_a_message_names_the_place_where_what_is_wrong_stands(old: str, new: str, says: list[str]) -> None:
    """Once, however many things have it: that of the type where the type says it."""
    told = refused(replaced(old, new))
    assert len(told) == len(says)
    for one, beginning in zip(sorted(told), sorted(says), strict=True):
        assert one.startswith(beginning)


def test_a_small_file_does_not_become_a_huge_one() -> None:
    """1000 vessels of a type with 300 tanks: 7 values of each tank, 2100, and a draft."""
    box = {"box": ["1 m"] * 3, "bottom": ["1 m"] * 3, "content": "1 t"}
    flat = {"draft": "4 m", "tanks": {f"t{place}": box for place in range(300)}}
    many = {f"v{place}": {"type": "flat"} for place in range(1000)}
    with pytest.raises(ScenarioError) as error:
        parse_scenario(text_of_lift({}, vessel_types={"flat": flat}, vessels=many))
    told = "1000 things have this type, with 2101 values each; types give at most 200000 in all"
    assert [one.message for one in error.value.problems] == [f"vessel_types.flat: {told}"]


def test_what_a_thing_says_itself_counts() -> None:
    """Mapping by mapping, key by key; lists are said whole."""
    text = replaced(
        "slew: -90 deg}", "slew: -90 deg, base_mass: 200 t, boom: {radius: 18 m}, hooks: {H: {height: 30 m}}}"
    )
    lift = parse_scenario(text, str(ROOT / PAIR / "scenario.yaml"))
    c1, c2 = crawler(lift, "c1"), crawler(lift, "c2")
    assert (c1.base_mass, c2.base_mass) == (200e3, 190e3)
    assert (c1.boom.radius, c2.boom.radius) == (18.0, 16.0)
    assert c1.boom.length == c2.boom.length == 63.0
    assert (lift.hooks["c1.H"].height, lift.hooks["c2.H"].height) == (30.0, 28.6)
    assert c1.hooks["H"].type == c2.hooks["H"].type == "hook_200"


def test_other_values_in_a_type_and_in_one_of_its_things() -> None:
    """What is set in a type all have that do not say it, also once one of them says something else."""
    lift = load_scenario(ROOT / PAIR).changed(
        {
            "c1.boom.radius": "18 m",
            "crane_types.crawler_400.base_mass": "200 t",
            "cranes.c2.rating.rated.2": "280 t",
            "c2.H.height": "29 m",
        }
    )
    again = lift.changed(
        {"crane_types.crawler_400.boom.radius": "17 m", "crane_types.crawler_400.base_mass": "210 t"}
    )
    c1, c2 = crawler(again, "c1"), crawler(again, "c2")
    assert (c1.base_mass, c2.base_mass) == (210e3, 210e3)
    assert (c1.boom.radius, c2.boom.radius) == (18.0, 17.0)
    assert c1.rating is not None and c2.rating is not None
    assert (c1.rating.rated[1], c2.rating.rated[1]) == (283e3, 280e3)
    assert (again.hooks["c1.H"].height, again.hooks["c2.H"].height) == (28.6, 29.0)


def test_cases_set_and_vary_what_a_type_gives() -> None:
    """For one thing where it is named there, for all where the type is."""
    more = """cases:
  heavier: {set: {crane_types.crawler_400.base_mass: 200 t}}
  farther: {vary: {c1.boom.radius: [-1 m, 1 m]}}
"""
    text = (ROOT / PAIR / "scenario.yaml").read_text(encoding="utf-8")
    text = text[: text.index("cases:  ")] + more + text[text.index("\nrules:") :]
    lift = parse_scenario(text, str(ROOT / PAIR / "scenario.yaml"))
    (heavier,) = variants_of(lift, "heavier")
    assert [crawler(heavier.scenario, name).base_mass for name in ("c1", "c2")] == [200e3, 200e3]
    radii = [
        [crawler(one.scenario, name).boom.radius for name in ("c1", "c2")]
        for one in variants_of(lift, "farther")
    ]
    assert radii == [[15.0, 16.0], [17.0, 16.0]]


def test_a_doubt_about_a_type_is_told_once() -> None:
    """Both crawlers have the slip; it stands in one line of the file."""
    lift = load_scenario(ROOT / PAIR).changed({"crane_types.crawler_400.heading": "94.2477796 rad"})
    doubts = [one.message for one in Simulation(lift).assembly.doubts if "turns" in one.sentence]
    assert doubts == [
        "crane_types.crawler_400.heading: 94.2477796 rad are 15 turns; '94.2477796 deg' may be meant"
    ]


def typed_barges(**own: Any) -> str:
    """Two barges of one type, with contents of tanks in it."""
    box = (20.0, 10.0, 6.0)
    side = {**BARGE, "tanks": {"ps": tank((50, 8, 1), 300.0, box), "sb": tank((50, -8, 1), 200.0, box)}}
    barges = {
        "one": {"type": "flat", "position": ["0 m", "0 m"], **own},
        "two": {"type": "flat", "position": ["0 m", "60 m"]},
    }
    return text_of_lift({}, vessel_types={"flat": side}, vessels=barges)


def test_contents_of_tanks_are_written_where_they_stand() -> None:
    """In the type of one vessel alone; what several have is not changed for one of them."""
    both = solve_ballast(parse_scenario(typed_barges()), vessel="one", draft=4.1)
    with pytest.raises(ScenarioError) as error:
        print(both.text)
    told = "is the content of other vessels of this type, too; give 'one' its own, for '--write' to change"
    assert error.value.problems[0].message == f"vessel_types.flat.tanks.ps.content: {told}"
    own = {"tanks": {"ps": {"content": "300 t"}, "sb": {"content": "200 t"}}}
    answer = solve_ballast(parse_scenario(typed_barges(**own)), vessel="one", draft=4.1)
    again = parse_scenario(answer.text).vessels
    assert again is not None and again["one"].tanks is not None and again["two"].tanks is not None
    found = {name: one.content for name, one in again["one"].tanks.items()}
    assert found == pytest.approx(dict(answer.contents), abs=1.0)
    assert [one.content for one in again["two"].tanks.values()] == [300e3, 200e3]


def test_lines_have_the_kind_of_their_type() -> None:
    """A catenary where neither says a kind; `type` of a line then is its kind, of a fender its type."""
    ship = load_scenario(ROOT / "heavy_lift_ship")
    assert {line.type for line in (ship.mooring_lines or {}).values()} == {"spring"}
    assert {fender.type for fender in (ship.fenders or {}).values()} == {"soft"}
    wrong = (ROOT / "heavy_lift_ship" / "scenario.yaml").read_text(encoding="utf-8")
    wrong = wrong.replace("head:        {type: to_the_quay", "head:        {type: to_the_key")
    with pytest.raises(ScenarioError, match=r"'to_the_key' is not a name of 'mooring_line_types'; did you"):
        parse_scenario(wrong)
