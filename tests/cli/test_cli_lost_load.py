"""`gantline statics --lost`: what it prints, draws and refuses."""

from __future__ import annotations

import errno
import json
import math
import os
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from matplotlib.figure import Figure
from PIL import Image
from typer.testing import CliRunner

from gantline.cli import lost_load
from gantline.cli.app import app
from gantline.statics import Statics
from gantline.study.lost_load import LostLoad

#: When the load has just come clear: there the lift has to be run for less than half of its time.
CLEAR = ("--time", "1110 s")
CRANE = Path(__file__).parents[2] / "python/gantline/scenarios/floating_crane.yaml"


def lost(*arguments: str | Path) -> tuple[int, str, str]:
    result = CliRunner().invoke(app, ["statics", *map(str, arguments)])
    return result.exit_code, result.stdout, result.stderr


def with_opening(folder: Path, at: str) -> Path:
    """The floating crane with a hatch at the stern that is not weathertight."""
    text = CRANE.read_text(encoding="utf-8")
    assert text.count("    draft: ") == 1
    path = folder / "lift.yaml"
    path.write_text(
        text.replace("    draft: ", f"    openings: {{hatch: {at}}}\n    draft: "), encoding="utf-8"
    )
    return path


@pytest.fixture(scope="module", autouse=True)
def _found_once() -> Iterator[None]:
    """What becomes of a load is found once for each question, in however many ways it is shown."""
    find, known = lost_load._found, dict[tuple[Any, ...], LostLoad]()

    def found(question: Statics, load: str, moment: float | None, *, held: bool) -> LostLoad:
        asked = (question.scenario.source, question.scenario.text, load, moment, held)
        if asked not in known:
            known[asked] = find(question, load, moment, held=held)
        return known[asked]

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(lost_load, "_found", found)
        yield


@pytest.fixture(scope="module")
def at_its_end(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, tuple[int, str, str]]:
    """The load lost at the end of the lift: the folder that was written, and what was said."""
    folder = tmp_path_factory.mktemp("lost")
    return folder, lost("floating_crane", "--lost", "load", "--output", folder)


def test_tables_and_picture(at_its_end: tuple[Path, tuple[int, str, str]]) -> None:
    folder, (code, said, _) = at_its_end
    assert code == 0
    assert "'load' lost at 2750 s; at rest without it: stable" in said
    assert re.search(r"barge +stern +-0\.01 deg +1\.3\d deg +2\.6\d deg +0\.8\d m +3\.57 deg", said)
    assert "barge has no 'openings' in the lift file" in said
    with Image.open(folder / "lost_load_barge.png") as picture:
        assert picture.width > 1000
        assert len(picture.convert("RGB").resize((200, 100)).getcolors(20_000) or []) > 50


def test_numbers_in_si_units(at_its_end: tuple[Path, tuple[int, str, str]]) -> None:
    found = json.loads((at_its_end[0] / "lost_load.json").read_text(encoding="utf-8"))
    (swing,) = found["swings"]
    assert found["load"] == "load" and found["sound"] is True
    assert swing["vessel"] == "barge" and abs(swing["away"]) == pytest.approx(math.pi)
    assert swing["towards"] == "stern"
    assert swing["before"] < swing["after"] < swing["farthest"] < swing["under"]["deck_edge"]
    assert swing["ratio"] == pytest.approx(swing["taken"] / swing["left"])
    assert len(swing["angle"]) == len(swing["arm"]) > 20
    # Half the trim's square by GM is what it has left: the righting moment is straight so far.
    heel, gm = swing["after"] - swing["before"], found["metacentric_heights"]["barge"][1]
    assert swing["left"] == pytest.approx(gm * heel**2 / 2, rel=2e-3)


def test_a_vessel_that_does_not_come_back(tmp_path: Path) -> None:
    """A hatch low at the stern goes under before the vessel has used up what the load leaves."""
    code, said, _ = lost(with_opening(tmp_path, "[0 m, 10 m, 6.2 m]"), "--lost", "load", *CLEAR)
    assert code == 1
    assert "WARNING: barge does not swing back before water comes in or its arms vanish" in said
    assert "has no 'openings'" not in said


def test_an_opening_under_water_before_the_load_is_lost(tmp_path: Path) -> None:
    """A hatch at the bow, 4 m over the keel, is under with the load and dry without: it ended with 0."""
    code, said, _ = lost(with_opening(tmp_path, "[100 m, 0 m, 4 m]"), "--lost", "load", *CLEAR)
    assert code == 1
    comes = "water comes in, which arms and areas do not know of"
    assert f"\n  WARNING: barge has hatch under water already with 'load' on: {comes}\n" in said
    code, said, _ = lost(with_opening(tmp_path, "[100 m, 0 m, 4 m]"), "--lost", "load", *CLEAR, "--json")
    found = json.loads(said)
    assert (code, found["sound"]) == (1, False)
    assert found["swings"][0]["ratio"] > 1.0
    assert found["under_with_load"] == {"barge": ["hatch"]} and found["flooded"] == ["barge.hatch"]


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ("equalizer --lost load", "--lost: no vessel of this lift floats"),
        ("floating_crane --lost modul --time '0 s'", "--lost: the lift has no load 'modul'; its loads: load"),
        ("floating_crane --lost load --time '1 h'", "--time: 3600 s is after the end of the lift"),
    ],
)
def test_what_cannot_be_lost_is_said(words: str, said: str) -> None:
    result = CliRunner().invoke(app, f"statics {words}")
    assert result.exit_code == 2
    assert said in result.stderr


def test_a_load_that_stands_is_not_lost() -> None:
    """At the start it stands on the quay: that the vessel stays as it is ended with 0, as if it came back."""
    code, said, _ = lost("floating_crane", "--lost", "load", "--time", "0 s")
    assert code == 4
    assert "\nIt turns no vessel: 'load' stands then; --time says when in the plan it is lost\n" in said
    code, said, _ = lost("floating_crane", "--lost", "load", "--time", "0 s", "--json")
    found = json.loads(said)
    assert (code, found["swings"], found["stands"]) == (4, [], True)


def test_a_picture_that_cannot_be_written_leaves_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A disk that is full halfway leaves no half of a picture, and code 2."""

    def full(self: Figure, path: Path, **_: object) -> None:
        path.write_bytes(b"half")
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), str(path))

    monkeypatch.setattr(Figure, "savefig", full)
    code, _, said = lost("floating_crane", "--lost", "load", "--output", tmp_path)
    assert (code, list(tmp_path.iterdir())) == (2, [])
    assert "cannot be written (no space left on device)" in said
