"""Supports under a load at the start: how far each may be off before that is refused or told."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from cad_loads import LEVEL, cad_lift
from gantline.assembly.doubts.supports import (
    bears_nothing,
    check_under_load,
    doubtful_supports,
    shown_gap,
    too_low,
)
from gantline.assembly.loads.load_body import LoadBody, load_body
from gantline.assembly.loads.under_load import UnderLoad, under_load
from gantline.scenario import Scenario, ScenarioError, load_scenario
from gantline.scenario.loads.load import Load
from hull_lift import text
from solids import box

#: A little less and a little more than what something may be.
LESS, MORE = 1.0 - 1e-6, 1.0 + 1e-6
#: One group under a box of 16 m by 10 m by 4 m, whose underside is at `LEVEL`, and one that bears nothing.
OWN, OTHER = "keel_blocks", "pillars"
GROUP = {"under": "hull", "stiffness": "100 MN/m", "damping": "1 MN s/m", "friction": 0.4, "height": "1.5 m"}


@dataclass(frozen=True)
class Case:
    """A lift, its load, and supports under that where it starts."""

    scenario: Scenario
    load: Load
    body: LoadBody
    under: Sequence[UnderLoad]

    def with_gaps(self, group: str, *gaps: float | None, **more: Any) -> list[UnderLoad]:
        """The supports, those of a group so far below the load [m], None not under it; others touch it."""
        left = list(gaps)
        return [
            self.at(one, left.pop(0), **more) if one.support.group == group and left else self.at(one, 0.0)
            for one in self.under
        ]

    def at(self, one: UnderLoad, gap: float | None, **more: Any) -> UnderLoad:
        if gap is None:
            return replace(one, place=None, own=None, **more)
        x, y, top = one.pad["at"]
        return replace(one, place=np.array([x, y, top + gap]), **more)

    def check(self, under: Sequence[UnderLoad]) -> str:
        """What is refused of them; empty where nothing is."""
        try:
            check_under_load(self.scenario, self.load, self.body, under)
        except ScenarioError as error:
            return str(error)
        return ""

    def doubts(self, under: Sequence[UnderLoad]) -> list[str]:
        found = doubtful_supports(self.scenario, self.load, self.body, under)
        return [f"{'.'.join(map(str, doubt.path))}: {doubt.sentence}" for doubt in found]


def case(folder: Path, pillars: dict[str, Any] | None = None, **load: Any) -> Case:
    places = {
        f"{name}": {"at": [f"{x} m", "0 m"]} for name, x in zip("abcdefg", range(-6, 8, 2), strict=True)
    }
    given = cad_lift(folder, box((16.0, 10.0, 4.0), (0.0, 0.0, 2.0)), {**GROUP, "places": places}, **load)
    given["supports"][OTHER] = {**GROUP, "places": {"p": {"at": ["0 m", "3 m"]}}, **(pillars or {})}
    (folder / "scenario.yaml").write_text(text(given))
    scenario = load_scenario(folder / "scenario.yaml")
    assert scenario.load is not None
    body = load_body(scenario, scenario.load)
    return Case(
        scenario, scenario.load, body, under_load(scenario, scenario.load, body, np.array([0.0, 0.0, 2.0]))
    )


@pytest.fixture(scope="module")
def plain(tmp_path_factory: pytest.TempPathFactory) -> Case:
    return case(tmp_path_factory.mktemp("plain"))


def test_all_is_well_where_all_touch(plain: Case) -> None:
    assert [one.gap for one in plain.under] == pytest.approx([0.0] * 8, abs=1e-9)
    assert [one.own for one in plain.under] == pytest.approx([LEVEL] * 8)
    assert plain.check(plain.under) == "" and plain.doubts(plain.under) == []


@pytest.mark.parametrize(("sign", "where"), [(1.0, "above"), (-1.0, "below")])
def test_a_load_at_rest_is_within_a_millimetre_of_the_nearest(plain: Case, sign: float, where: str) -> None:
    """The fourth of seven is the nearest; right is where it touches."""
    gaps = [0.5, 0.5, 0.5, sign * 1e-3 * MORE, 0.5, 0.5, 0.5]
    said = f"its underside is 0.001 m {where} 'keel_blocks.d', the nearest of them"
    found = plain.check(plain.with_gaps(OWN, *gaps))
    assert said in found and f"right is z = {LEVEL - sign * 1e-3:.6g} m" in found
    gaps[3] = sign * 1e-3 * LESS
    assert plain.check(plain.with_gaps(OWN, *gaps)) == ""


def test_of_those_that_are_alike_the_first_is_named(plain: Case) -> None:
    """Apart by rounding, a ten-billionth of a metre; one that is not under the load is none of them."""
    gaps = [None, 0.2 + 1e-10, 0.2, 0.2, 0.2, 0.2, 0.2]
    assert "0.2 m above 'keel_blocks.b'" in plain.check(plain.with_gaps(OWN, *gaps))


def test_a_load_under_which_none_of_its_supports_is(plain: Case) -> None:
    found = plain.check(plain.with_gaps(OWN, *[None] * 7))
    assert "no support of 'keel_blocks' is under the load" in found


def test_a_load_that_is_given_as_it_is_may_be_anywhere(tmp_path: Path, plain: Case) -> None:
    """Where it does not begin at rest, and where it stands on the ground."""
    given = replace(plain, scenario=plain.scenario.model_copy(update={"start": "as_given"}))
    assert given.check(given.with_gaps(OWN, *[0.2] * 7)) == ""
    grounded = replace(plain, load=plain.load.model_copy(update={"stands_on": "ground"}))
    assert grounded.check(grounded.with_gaps(OWN, *[0.2] * 7)) == ""


def test_a_top_may_be_a_tenth_of_a_metre_inside_the_load(plain: Case) -> None:
    found = plain.check(plain.with_gaps(OTHER, -0.1 * MORE))
    assert "'pillars.p' stands inside the load at the start: its top is at 1.5 m" in found
    assert "the underside of the load there at 1.4 m; move it" in found
    assert plain.check(plain.with_gaps(OTHER, -0.1 * LESS)) == ""
    hollow = plain.check(plain.with_gaps(OTHER, -0.2, own=1.5 + 1e-6))
    assert "at 1.3 m, that of its convex hull, which closes a hollow; move it" in hollow
    assert "convex hull" in plain.check(plain.with_gaps(OTHER, -0.2, own=None))
    assert "convex hull" not in plain.check(plain.with_gaps(OTHER, -0.2, own=1.5))


@pytest.mark.parametrize(("foot", "is_told"), [(5.5, False), (5.49, True)])
def test_what_stands_above_the_load_is_not_inside_it(tmp_path: Path, foot: float, is_told: bool) -> None:
    """The top of the load is at 1.5 m + 4 m."""
    found = case(tmp_path, {"foot": f"{foot} m", "height": "1 m"})
    assert ("stands inside the load" in found.check(found.under)) == is_told


def test_a_support_measured_from_the_load_is_under_it(tmp_path: Path, plain: Case) -> None:
    """One that is measured from the world may wait for a load that comes down there."""
    assert "'pillars.p': nothing of the load" in plain.check(plain.with_gaps(OTHER, None))
    found = case(tmp_path, {"measured_from": "world"})
    assert found.check(found.with_gaps(OTHER, None)) == ""


def test_boxes_are_checked_where_the_lift_file_is(plain: Case) -> None:
    as_box = replace(plain, body=replace(plain.body, surface=None))
    assert as_box.check(as_box.with_gaps(OTHER, None)) == ""
    assert as_box.check(as_box.with_gaps(OTHER, -0.2)) == ""


def test_which_are_too_low_to_bear_anything(plain: Case) -> None:
    """More than a millimetre below, and bearing nothing; of six the first five are named."""
    under = plain.with_gaps(OWN, 1e-3 * LESS, 1e-3 * MORE, None, 0.2, 1.5)[:7]
    low = "lower than its underside over them are 'keel_blocks.b' 1 mm, 'keel_blocks.d' 200 mm"
    assert too_low(under) == f"{low}, 'keel_blocks.e' 1.50 m"
    assert too_low(under[:1]) == ""
    (doubt,) = bears_nothing(OWN, under, [True, False, True, False, True, True, True])
    assert doubt.sentence == (
        f"2 of 7 supports of keel_blocks bear nothing as the load stands at the start: {low}; "
        "'height: to_load' is up to it"
    )
    assert bears_nothing(OWN, under, [False, True, False, True, True, True, True]) == []
    for count, last in ((5, "'keel_blocks.e' 200 mm"), (6, "'keel_blocks.e' 200 mm and 1 more")):
        assert too_low(plain.with_gaps(OWN, *[0.2] * count)[:7]).endswith(last)


def test_supports_with_nothing_over_them_are_told(plain: Case) -> None:
    (found,) = plain.doubts(plain.with_gaps(OWN, None, 0.0, None))
    said = (
        "supports.keel_blocks: nothing of the load is over 2 of 7 supports: 'keel_blocks.a', 'keel_blocks.c'"
    )
    assert found == said
    assert plain.doubts(plain.with_gaps(OTHER, None)) == []  # the load does not stand on these


def test_hollows_of_more_than_half_a_decimetre_are_told(plain: Case) -> None:
    """Over supports that are less than 0.1 m below the load's hull."""
    said = (
        "supports.pillars: the load stands on its convex hull, which closes a hollow of its CAD geometry here"
    )
    for gap, higher, is_told in (
        (0.0, 0.05 * MORE, True),
        (0.0, 0.05 * LESS, False),
        (0.1 * LESS, 0.06, True),
        (0.1 * MORE, 0.06, False),
    ):
        found = plain.doubts(plain.with_gaps(OTHER, gap, own=LEVEL + gap + higher))
        wanted = f"{said}; how much higher that begins: 'pillars.p' {1e3 * higher:.0f} mm"
        assert found == ([wanted] if is_told else [])
    bare = plain.doubts(plain.with_gaps(OTHER, 0.0, own=None))
    assert bare == [f"{said}; how much higher that begins: 'pillars.p' nothing at all"]


def test_sides_that_rise_by_more_than_friction_holds_are_told(plain: Case) -> None:
    """Friction of 0.4 and 0.05 more: atan 0.45 = 24°."""
    assert plain.doubts(plain.with_gaps(OTHER, 0.0, rise=0.45 * LESS)) == []
    (found,) = plain.doubts(plain.with_gaps(OTHER, 0.0, rise=0.45 * MORE))
    assert "rises by more than friction holds over 'pillars.p' 24°; its push" in found
    assert plain.doubts(plain.with_gaps(OTHER, 0.1 * MORE, rise=0.6)) == []
    as_box = replace(plain, body=replace(plain.body, surface=None))
    assert as_box.doubts(as_box.with_gaps(OTHER, 0.0, rise=0.6, own=None)) == []


def test_sides_that_miss_the_hull_by_two_millimetres_are_told(plain: Case) -> None:
    def coarse(error: float) -> Case:
        return replace(plain, body=replace(plain.body, sides_error=error))

    assert coarse(2e-3 * LESS).doubts(plain.under) == []
    (found,) = coarse(2e-3 * MORE).doubts(plain.under)
    assert "so many corners that what lies on supports is up to 2 mm within it" in found
    (found,) = coarse(0.0312).doubts(plain.under)
    assert "up to 31 mm within it, and heights off by that" in found


def test_corners_of_a_box_a_decimetre_off_its_hull_are_told(plain: Case) -> None:
    """On the ground; two of the lower corners of the hull moved inwards along x."""
    load = plain.load.model_copy(update={"stands_on": "ground"})

    def clipped(off: float) -> list[str]:
        hull = plain.body.hull.copy()
        hull[(hull[:, 0] > 0.0) & (hull[:, 2] < 1.0), 0] -= off
        found = replace(plain, load=load, body=replace(plain.body, hull=hull))
        return [one for one in found.doubts(plain.under) if "corners of its box" in one]

    assert clipped(0.1 * LESS) == []
    (found,) = clipped(0.1 * MORE)
    assert "of which 2 are up to 100 mm off any corner of its shape; supports carry" in found


@pytest.mark.parametrize(
    ("gap", "shown"),
    [(None, "-"), (0.0123, "12 mm"), (-0.9994, "-999 mm"), (1.0, "1.00 m"), (-2.345, "-2.35 m")],
)
def test_gaps_as_people_read_them(gap: float | None, shown: str) -> None:
    assert shown_gap(gap) == shown
