"""A barge that floods was ballasted to even keel, `all sound`, without a word of its hole.

Nothing runs through holes in equilibria, and a single `gantline statics` said so. Tables of steps, cases,
ballast and lost loads did not: contents for even keel that the run left with a heel of 0.88 degrees, since by
then 80 t had come in to starboard. They say now what they leave out, where they say it of waves.
"""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from ballasted import barge, pump, tank, text
from program import called

#: A room open to the sea.
GASH = {"gash": {"at": ["50 m", "-14 m", "1 m"], "area": "0.1 m^2"}}
SAID = "barge.sb as at the start: nothing runs through holes"


@pytest.fixture(scope="module", params=[True, False], ids=["holed", "whole"])
def lift(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, bool]:
    """A barge with three tanks, and whether that to starboard has a hole."""
    rooms = {
        name: tank((50, y, 0.5), 200.0, (20.0, 8.0, 6.0)) for name, y in (("ps", 10), ("mid", 0), ("sb", -10))
    }
    if request.param:
        rooms["sb"]["holes"] = GASH
    path = tmp_path_factory.mktemp("lift") / "lift.yaml"
    cases = {"lighter": {"set": {"vessels.barge.tanks.mid.content": "100 t"}}}
    plan = [pump("barge.ps", "barge.mid", "600 t/h", by="20 t")]
    path.write_text(text(barge(rooms), plan, cases=cases), encoding="utf-8")
    return path, request.param


@pytest.mark.parametrize(
    "words", [("statics", "--steps"), ("statics",), ("cases",), ("ballast",)], ids=" ".join
)
def test_tables_say_it(lift: tuple[Path, bool], words: tuple[str, ...]) -> None:
    path, is_holed = lift
    verb, *options = words
    said = called(verb, path, *options)
    assert said.returncode == 0, said.stderr
    assert (SAID in said.stdout.splitlines()) is is_holed


@pytest.mark.parametrize("words", [("statics", "--steps"), ("ballast",)], ids=" ".join)
def test_numbers_say_it(lift: tuple[Path, bool], words: tuple[str, ...]) -> None:
    path, is_holed = lift
    verb, *options = words
    document = json.loads(called(verb, path, *options, "--json").stdout)
    assert document["left_out"] == ([SAID] if is_holed else [])
