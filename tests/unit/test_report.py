"""The report: what stands in it, that it needs nothing else, and that no text in it can act."""

from __future__ import annotations

import base64
import dataclasses
import hashlib
import json
import re
from html.parser import HTMLParser
from pathlib import Path

import numpy as np
import pytest

import gantline
import gantline.report.page
from gantline.checks import LIMITS, check_recording
from gantline.checks.measure import Missing
from gantline.report import render_report, write_report
from gantline.report.first_page import FirstPage, beyond, stop_if
from gantline.report.sketch import sketches
from gantline.report.sketch_paper import HEIGHT, PLATE, WIDTH
from gantline.report.steps import StepsContinued, first_steps
from gantline.report.subject import ABSENT, Subject, typeset
from gantline.report.tables import Energy, LiftFile
from gantline.results import Recording
from gantline.results.rig import Rig
from gantline.results.variable import Variable
from gantline.viewer import BundleMissing
from gantline.viewer.bundle import Bundle
from gantline.viewer.inline import json_for_script, script_is_safe
from hostile import EVIL, hostile_recording
from sample_lift import ringing_lift, sample_rig

SCRIPT = "console.log('player')"


class Page(HTMLParser):
    """Elements of a page in order, texts of those that matter, and all attributes."""

    def __init__(self, html: str) -> None:
        super().__init__(convert_charrefs=True)
        self.tags: list[str] = []
        self.attributes: list[tuple[str, str, str]] = []
        self.texts: dict[str, list[str]] = {}
        self._open: list[str] = []
        self.feed(html)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append(tag)
        self.attributes += [(tag, name, value or "") for name, value in attrs]
        if tag not in ("meta", "link", "img", "br"):
            self._open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        while self._open and self._open.pop() != tag:
            pass

    def handle_data(self, data: str) -> None:
        for tag in self._open[-1:]:
            self.texts.setdefault(tag, []).append(data)

    def policy(self) -> str:
        return next(
            v for tag, name, v in self.attributes if (tag, name) == ("meta", "content") and "src" in v
        )


@pytest.fixture(autouse=True)
def player(monkeypatch: pytest.MonkeyPatch) -> None:
    """A program in place of the player, which only browsers can try."""
    monkeypatch.setattr(gantline.report.page, "bundle", lambda: Bundle(SCRIPT, ".gl{}"))


def test_a_page_reads_nothing_from_elsewhere() -> None:
    page = Page(render_report(ringing_lift()))
    addresses = [
        value for _, name, value in page.attributes if name in ("src", "href", "action", "data", "style")
    ]
    assert addresses and all(value.startswith("#") for value in addresses)
    assert "default-src 'none'" in page.policy() and "connect-src 'none'" in page.policy()
    assert "unsafe" not in page.policy()


def test_the_policy_allows_the_page_own_program_and_style_alone() -> None:
    page = Page(render_report(ringing_lift()))
    digests = re.findall(r"'sha256-([^']+)'", page.policy())
    own = [SCRIPT, "".join(page.texts["style"])]
    assert digests == [base64.b64encode(hashlib.sha256(text.encode()).digest()).decode() for text in own]


def test_hostile_texts_are_texts() -> None:
    html = render_report(hostile_recording())
    page = Page(html)
    assert page.tags.count("script") == 3  # header, data, program
    assert "img" not in page.tags
    assert not [name for _, name, _ in page.attributes if name.startswith("on")]
    assert "".join(page.texts["h1"]) == f"Lift {EVIL}"
    assert "{{ 7*7 }}" in html and "49" not in "".join(page.texts["h1"])
    # The lift file is shown as it is, and the title too.
    assert "".join(page.texts["pre"]) == f"lift: {EVIL}"
    assert EVIL in "".join(page.texts["title"])


def test_json_cannot_end_its_script_element() -> None:
    escaped = json_for_script('{"a":"</script><!--&\u2028"}')
    assert not set("<>&\u2028") & set(escaped)
    assert json.loads(escaped) == {"a": "</script><!--&\u2028"}


def test_a_program_that_would_end_its_element_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    assert not script_is_safe("x = '</ScRipt>'") and not script_is_safe("<!--")
    monkeypatch.setattr(gantline.report.page, "bundle", lambda: Bundle("'</script>'", ""))
    with pytest.raises(ValueError, match="end of a script"):
        render_report(ringing_lift())


def content(recording: Recording) -> dict[str, object]:
    return FirstPage().content(Subject(recording))


def test_the_first_page_says_what_load_cells_read() -> None:
    # The slings carry nothing until 10 s, so 25, 50 and 75 % are passed within one sample; static are the
    # means of the slings, 3000 kN in all, the frame with its sheaves, 21.5 t, and the hook block, 50 kN.
    hooks = content(ringing_lift())["hooks"]
    assert isinstance(hooks, list)
    static = (3000e3 + 21.5e3 * 9.81 + 50e3) / 9.81 / 1e3
    assert hooks[0]["static"] == f"{static:.1f}"
    assert hooks[0]["readings"][3] == f"{static:.1f}"
    before, after = 21.5 + 50 / 9.81, (3000e3 + 21.5e3 * 9.81 + 50e3) / 9.81 / 1e3
    # At t = 10 s the ringing has no part, and transferred goes from 0 to 1 in this sample.
    assert float(hooks[0]["readings"][1]) == pytest.approx((before + after) / 2, abs=0.06)


def test_a_load_that_hangs_in_part_at_the_start_has_the_readings_to_come() -> None:
    """44 % have come over as it begins: half and three quarters are still to come, a quarter is not."""
    whole = ringing_lift()
    transferred = np.linspace(0.44, 1.0, len(whole.time))[:, None]
    one = whole["load_transferred"]
    part = Variable(one.dims, transferred, one.unit, one.description)
    variables = {**whole.variables, "load_transferred": part}
    hooks = content(Recording(variables, whole.coordinates, whole.attributes))["hooks"]
    assert isinstance(hooks, list)
    quarter, half, three_quarters, _ = hooks[0]["readings"]
    assert quarter == ABSENT
    assert ABSENT not in (half, three_quarters)


def test_the_first_page_counts_from_calculated_weight_to_hoist_load() -> None:
    weights = dict(content(ringing_lift())["weights"])  # type: ignore[call-overload]
    name = ringing_lift().rig.loads[0].name
    assert weights[f"{name}, calculated"] == "300.0 t"
    assert weights["× contingency 1.00 = design weight"] == "300.0 t"
    # Static hook load 3000 kN + 21.5 t x g, of which 300 t x g are the load.
    rigging = (3000e3 + 21.5e3 * 9.81) / 9.81 / 1e3 - 300.0
    assert weights["+ rigging below the hooks"] == f"{rigging:.1f} t"
    # The sample nearest to the ringing's peak is 0.01 s from it.
    ringing = 500e3 * np.cos(2 * np.pi * 0.01)
    peak = (3000e3 + ringing + 21.5e3 * 9.81 + 50e3) / 9.81 / 1e3
    assert weights["largest hoist load, simulated"] == f"{peak:.1f} t"


def test_weights_with_contingency_add_up_to_what_is_checked() -> None:
    rig = sample_rig()
    load = rig["loads"][0]
    load["contingency"], load["design_mass"], load["simulated_mass"] = 1.05, 315e3, 300e3
    recording = ringing_lift(rig=rig)
    weights = dict(content(recording)["weights"])  # type: ignore[call-overload]
    checked = {check.name: check.value for check in check_recording(recording)}["static_hook_load"]
    assert checked is not None
    assert weights["= static hook load"] == f"{checked / 9.81e3:.1f} t"
    # What slings carry, 3000 kN, is raised by 5 %, the frame with its sheaves is not. They lean: cos > 0.98.
    raised = (1.05 * 3000e3 + 21.5e3 * 9.81) / 9.81e3
    assert float(weights["= static hook load"].split()[0]) == pytest.approx(raised, abs=0.02 * 15.3)


def test_a_load_cell_is_read_when_the_load_has_come_clear_and_not_at_the_end() -> None:
    clear = ringing_lift()
    hoist = clear["hoist_load"]
    # From 25 s on, when the load has hung for 15 s, half of it is gone.
    halved = np.where(clear.time[:, None] < 25.0, hoist.values, 0.5 * hoist.values)
    variables = {**clear.variables, "hoist_load": dataclasses.replace(hoist, values=halved)}
    later = Recording(variables, clear.coordinates, clear.attributes)
    rows = [content(one)["hooks"] for one in (clear, later)]
    readings = [row[0]["readings"][3] for row in rows]  # type: ignore[index]
    assert readings[0] == readings[1]
    assert rows[1][0]["static"] != readings[1]  # type: ignore[index]


def test_verdicts_have_their_tone() -> None:
    def tone(**limits: float) -> str:
        verdict = content(ringing_lift(rig=sample_rig(**limits)))["verdict"]
        assert isinstance(verdict, dict)
        return str(verdict["tone"])

    assert tone(sling_angle_from_vertical=1.5) in ("good", "warn")
    assert tone(load_tilt=0.1, sling_angle_from_vertical=0.01) == "bad"


def test_a_run_that_ended_early_is_no_go() -> None:
    plain = ringing_lift()
    recording = Recording(plain.variables, plain.coordinates, {**plain.attributes, "status": "stopped"})
    verdict = content(recording)["verdict"]
    assert isinstance(verdict, dict)
    assert verdict["tone"] == "bad" and verdict["head"] in ("NO-GO", "NO VERDICT")
    ending = content(recording)["ending"]
    assert isinstance(ending, dict) and "stopped from outside" in str(ending["happened"])


def test_sketches_are_to_scale() -> None:
    side, plan = sketches(Subject(ringing_lift()))
    assert "side" in side.title and "plan" in plan.title
    load = next(mark for mark in plan.marks if "sk-load" in mark.style)
    x = [float(point.split(",")[0]) for point in load.points.split()]
    # The load is 10 m long.
    assert (max(x) - min(x)) * plan.scale == pytest.approx(10.0, abs=0.02)
    assert plan.bar_width * plan.scale == pytest.approx(plan.bar)
    for sketch in (side, plan):
        places = [tuple(map(float, p.split(","))) for mark in sketch.marks for p in mark.points.split()]
        assert all(0 <= x <= sketch.width and 0 <= y <= sketch.height for x, y in places)
        assert {mark.text for mark in sketch.marks if mark.style == "sk-number"} == {
            "S1",
            "S2",
            "S3",
            "S4",
            "S5",
        }


def test_title_and_scale_of_a_sketch_lie_on_one_plate() -> None:
    """Water and moorings end in one line above both; between two plates, and below, stumps were left."""
    drawn = re.findall(
        r'<rect class="sk-plate" x="0" y="([\d.]+)" width="([\d.]+)" height="([\d.]+)"',
        render_report(ringing_lift()),
    )
    assert [tuple(map(float, one)) for one in drawn] == [(HEIGHT - PLATE, WIDTH, PLATE + 1.0)] * 2


@pytest.mark.parametrize(("way", "right"), [((40.0, 0.0), "x to the right"), ((0.0, 40.0), "y to the right")])
def test_hooks_side_by_side_do_not_cover_each_other(way: tuple[float, float], right: str) -> None:
    plain = ringing_lift()
    rig = plain.attributes["rig"]
    (hook,) = rig["hooks"]
    place = plain["body_position"].values.copy()
    place[:, plain.coordinates["body"].index("block"), :2] += way
    variables = {
        **plain.variables,
        "body_position": dataclasses.replace(plain["body_position"], values=place),
    }
    two = {**rig, "hooks": [hook, {**hook, "name": "block"}]}
    side, _ = sketches(Subject(Recording(variables, plain.coordinates, {**plain.attributes, "rig": two})))
    assert side.title.endswith(right)


@pytest.mark.parametrize(
    ("names", "said"), [(["east"], "<dt>crane</dt>"), (["east", "west"], "<dt>cranes</dt>")]
)
def test_two_cranes_are_cranes(names: list[str], said: str) -> None:
    plain = ringing_lift()
    rig = plain.attributes["rig"]
    (hook,) = rig["hooks"]
    lift = {**rig, "hooks": [{**hook, "crane": name} for name in names]}
    page = render_report(Recording(plain.variables, plain.coordinates, {**plain.attributes, "rig": lift}))
    assert f"{said}<dd>{', '.join(names)}</dd>" in page


def test_what_a_run_counts_has_names_for_people() -> None:
    counters = {"steps": 12000, "cut": 8, "fill": 1318, "of a later version": 3}
    plain = ringing_lift()
    counted = Recording(plain.variables, plain.coordinates, {**plain.attributes, "counters": counters})
    content = Energy().content(Subject(counted))
    assert content["counters"] == [
        ("steps", "12\u2009000"),
        ("steps cut at a change of modes", "8"),
        ("entries of the factors", "1\u2009318"),
        ("of a later version", "3"),
    ]


def test_sections_that_a_lift_does_not_have_are_left_out() -> None:
    plain = ringing_lift()
    attributes = {**plain.attributes, "rig": {"title": "two"}, "scene": {"bodies": []}}
    variables = {name: plain[name] for name in ("time", "energy", "body_position", "body_orientation")}
    coordinates = {name: plain.coordinates[name] for name in ("energy_kind", "body")}
    html = render_report(Recording(variables, coordinates, attributes))
    page = Page(html)
    ids = [value for tag, name, value in page.attributes if (tag, name) == ("section", "id")]
    assert ids == ["lift", "energy", "input"]


def test_a_report_is_replaced_once_the_new_one_is_complete(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    target = tmp_path / "report.html"
    target.write_text("old")
    assert write_report(ringing_lift(), target) == target
    assert target.read_text(encoding="utf-8").startswith("<!doctype html>")

    def missing() -> Bundle:
        raise BundleMissing("not built")

    monkeypatch.setattr(gantline.report.page, "bundle", missing)
    before = target.read_bytes()
    with pytest.raises(BundleMissing):
        write_report(ringing_lift(), target)
    assert target.read_bytes() == before and list(tmp_path.iterdir()) == [target]


def test_the_same_recording_gives_the_same_bytes() -> None:
    assert render_report(ringing_lift()) == render_report(ringing_lift())


def test_a_lift_with_hundreds_of_slings_keeps_its_first_page() -> None:
    rig = sample_rig()
    sling = rig["slings"][0]
    rig["slings"] = [{**sling, "name": f"N{place}"} for place in range(100)]
    found = content(ringing_lift(rig=rig))
    assert len(found["slings"]) == 16  # type: ignore[arg-type]
    assert str(found["slings_left_out"]).startswith("84 are left out")
    assert np.isfinite(len(render_report(ringing_lift(rig=rig))))


BY_HAND = "wind exceeds the crane's limit (not in the lift file; from the crane's manual: ______ m/s)"


@pytest.mark.parametrize(
    ("limits", "expected"),
    [
        ({}, [BY_HAND.replace("the crane's limit", "the limit of what lifts").replace("the crane's", "its")]),
        ({"g1": None}, [BY_HAND]),
        ({"g1": 16.0}, ["wind is over 16 m/s, the limit of g1"]),
        (
            {"g1": 16.0, "g2": None},
            [
                "wind is over 16 m/s, the limit of g1",
                BY_HAND.replace("the crane's limit", "the limit of any other crane"),
            ],
        ),
    ],
)
def test_stop_if_names_wind_limits_or_says_that_there_is_none(
    limits: dict[str, float | None], expected: list[str]
) -> None:
    cranes = [{"name": name, "wind_limit": limit} for name, limit in limits.items()]
    rig = {"cranes": cranes, "hooks": [{"name": f"{name}.H", "crane": name} for name in limits]}
    subject = Subject(Recording({}, {}, {"rig": rig}))
    assert [one for one in stop_if(subject) if "wind" in one] == expected


def test_a_crane_without_a_wind_limit_is_not_checked_and_says_why() -> None:
    rig = {"cranes": [{"name": "g1", "wind": 5.0}], "hooks": [{"name": "g1.H", "crane": "g1"}]}
    recording = Recording({"time": Variable(("time",), np.arange(2.0), "s", "")}, {}, {"rig": rig})
    (found,) = LIMITS["wind_of_limit"].findings(recording, np.ones(2, dtype=np.bool_))
    assert found == Missing("g1", "wind limit not known")


@pytest.mark.parametrize(
    ("kinds", "require", "points"),
    [
        (("hold", "hold"), {}, [True, False]),
        (("hold", "hold"), {"load_tilt": {"below": 0.02}}, [True, True]),
        (("hold", "hoist"), {}, [True, False]),
    ],
)
def test_a_hold_point_is_one_that_something_waits_for(
    kinds: tuple[str, str], require: dict[str, dict[str, float]], points: list[bool]
) -> None:
    """Nothing comes after the last step; what it requires is still to be looked at."""
    rig = sample_rig()
    rig["plan"] = [
        {"step": "first", "kind": kinds[0]},
        {"step": "last", "kind": kinds[1], "require": require},
    ]
    content = FirstPage().content(Subject(ringing_lift(rig=rig)))
    assert [row["is_hold"] for row in content["steps"]["rows"]] == points


@pytest.mark.parametrize(
    ("count", "vessels", "told", "numbers"),
    [
        (16, (), "", []),
        (17, (), "Step 17", [17]),
        (20, (), "Steps 17 to 20", [17, 18, 19, 20]),
        (12, ({"name": "barge", "body": "barge"},), "Steps 11 and 12", [11, 12]),
    ],
)
def test_no_step_is_left_out_of_the_sheets(
    count: int,
    vessels: tuple[dict[str, str], ...],
    told: str,
    numbers: list[int],
) -> None:
    """Steps for which the first sheet has no room are in a table on the second, under their own numbers."""
    rig = sample_rig()
    rig["plan"] = [{"step": f"step {one}", "kind": "hoist"} for one in range(1, count + 1)]
    # Whoever signs looks for hold points above all.
    rig["plan"][-1] |= {"kind": "hold", "require": {"load_tilt": {"below": 0.02}}}
    plain = ringing_lift(rig=rig)
    attributes = {**plain.attributes, "rig": {**rig, "vessels": vessels}}
    subject = Subject(Recording(plain.variables, plain.coordinates, attributes))
    first, rest = first_steps(subject), StepsContinued().content(subject)
    assert first["elsewhere"] == told
    rows = [] if rest is None else rest["rows"]
    assert [row["name"] for row in [*first["rows"], *rows]] == [step["step"] for step in rig["plan"]]
    assert [row["name"] for row in rows] == [f"step {number}" for number in numbers]
    if rest is not None:
        assert rest["first"] == numbers[0]
        assert rows[-1]["is_hold"] and rows[-1]["require"] == "load tilt below 1.15 deg"


def test_the_page_has_the_steps_of_the_second_sheet_after_its_first() -> None:
    rig = sample_rig()
    rig["plan"] = [{"step": f"step {one}", "kind": "hoist"} for one in range(1, 21)]
    html = render_report(ringing_lift(rig=rig))
    assert '<strong>Steps 17 to 20: <span class="on-paper">see sheet 2</span>' in html
    assert "Steps, continued" in html
    ids = [value for tag, name, value in Page(html).attributes if (tag, name) == ("section", "id")]
    assert ids[:3] == ["lift", "steps", "player"]


TRACKS = {"name": "crawler", "allowed_pressure": 3e5}


@pytest.mark.parametrize(
    ("rig", "told"),
    [
        ({"hooks": [{"name": "h"}], "supports": [{"name": "s"}]}, "wind and UNDER supports and crane"),
        ({"hooks": [{"name": "h"}], "loads": [{"name": "l", "body": "l", "weight": 1.0, "contacts": ["c"]}]},
         "wind and UNDER load and crane"),
        ({"wind": {"speed": 10.0, "direction": 0.0}}, "wind on cranes and ropes"),
        (
            {"crawlers": [TRACKS], "hooks": [{"name": "h", "crane": "crawler"}], "supports": [{"name": "s"}]},
            "wind and UNDER supports; ground under the tracks only against the allowed pressure given",
        ),
        (
            {"crawlers": [TRACKS, {"name": "other"}], "hooks": [{"name": "h", "crane": "crawler"}]},
            "wind and UNDER tracks; "
            "ground under the tracks of crawler only against the allowed pressure given",
        ),
        (
            {
                "vessels": [{"name": "barge", "body": "barge"}],
                "booms": [{"name": "sheerleg"}],
                "hooks": [{"name": "h", "crane": "sheerleg"}],
            },
            "wind",
        ),
    ],
)  # fmt: skip
def test_what_is_never_looked_at_is_told_of_this_lift(rig: dict[str, object], told: str) -> None:
    """Where a page had a ground pressure of 71 % nobody had looked at the ground under the crane."""
    said = told.replace("UNDER", "bearing capacity of the ground under the")
    lugs = "local strength of the load at its lugs"
    joint = ", " if "UNDER" in told else " and "
    assert beyond(Rig.from_json(rig)) == f"{lugs}{joint}{said}"


def test_a_load_cell_is_held_against_its_reading() -> None:
    rig = {"hooks": [{"name": "h"}]}
    first, *_ = stop_if(Subject(Recording({}, {}, {"rig": rig})))
    assert first == "a load cell differs by more than 10 % from its reading in the table “Hooks”"


def test_settings_have_their_units() -> None:
    plain = ringing_lift()
    settings = {"integrator": {"type": "del", "step": 0.001}, "duration": 40.0, "sample_interval": 0.02}
    recording = Recording(plain.variables, plain.coordinates, {**plain.attributes, "settings": settings})
    about = dict(LiftFile().content(Subject(recording))["about"])
    assert about["duration"] == "40 s" and about["sample interval"] == "0.02 s"
    assert about["integrator"] == "del, step 0.001 s"


def test_a_recording_says_its_tolerances_and_its_start_as_they_were() -> None:
    """A run that took its tolerances by default could not be cited, and `settled` was said to be `as_given`.

    By default tensions are kept to a ten-thousandth of what a rope carries on the average: 321.5 t, the load
    and the equalizer with its sheaves, on five slings and one rope.
    """
    scenario = Path(__file__).resolve().parents[2] / "scenarios" / "equalizer"
    settings = gantline.simulate(scenario, duration=0.1).attributes["settings"]
    assert settings["start"] == "settled"
    share = 321.5e3 * 9.81 / 6
    assert settings["integrator"]["tension_tolerance"] == pytest.approx(1e-4 * share, rel=1e-12)
    assert settings["integrator"]["position_tolerance"] == 1e-4
    told = gantline.simulate(scenario, duration=0.1, tension_tolerance=50.0)
    assert told.attributes["settings"]["integrator"]["tension_tolerance"] == 50.0
    about = dict(LiftFile().content(Subject(told))["about"])
    assert about["integrator"] == "adaptive, tension tolerance 50 N, position tolerance 0.0001 m"
    assert about["start"] == "settled"
    fixed = gantline.simulate(scenario, duration=0.1, integrator="del", step=0.01)
    assert "tension_tolerance" not in fixed.attributes["settings"]["integrator"]


def test_a_minus_is_one_before_a_number_alone() -> None:
    """A dash between words, and one in a name, stay what they are."""
    went = "goliath.lower from 6.00 m to -2.86 m, at 6.8 m/min at most"
    assert typeset(went) == went.replace("-2", "−2")
    assert typeset("-0.3 deg") == "−0.3 deg"
    assert typeset("S-1 - lug A 0.34 m") == "S-1 - lug A 0.34 m"
