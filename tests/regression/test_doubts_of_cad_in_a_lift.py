"""A lift whose centre of gravity comes from a CAD file in which parts could not be read: GO, no warnings.

`gantline cad` told of contours that are not read, areas and masses that differ from the declared ones; a
lift said nothing of all this. Nor was a centre of gravity from CAD and outfitting held against the load's
box: outfitting at 2000 m for 2000 mm was simulated.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from gantline.assembly import assemble
from gantline.scenario import ScenarioError, load_scenario
from lift_text import changed, spoiled
from ocx_files import Writer

W = Writer()
BOX = "shape: {box: [8 m, 6 m, 3 m]}"
FROM_CAD = ("at: [0 m, 0 m, 1.5 m]", "at: from_cad")
UNUSED = "no sling leads to lug L3"
FILE = "the CAD file of the load: "
#: Plates of 8 m by 6 m; bottom and top of a load 3 m high, 60 t together.
THICKNESS = 60e3 / (2 * 48 * 7850)


def plate(name: str, z: float, more: float = 0.0, contour: str = "") -> str:
    corners = [(-4.0, -3.0, z), (4.0, -3.0, z), (4.0, 3.0, z), (-4.0, 3.0, z)]
    return W.plate(name, contour or W.polygon(corners), THICKNESS, declared=30e3 + more, centre=(0.0, 0.0, z))


@pytest.fixture(autouse=True)
def own_cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))


def lift(folder: Path, parts: str, more: str = "", *replaced: tuple[str, str]) -> Path:
    (folder / "load.3docx").write_bytes(W.file(parts))
    text = spoiled(BOX, f"shape: {{cad: load.3docx}}\n  datum: bottom_centre{more}")
    path = folder / "lift.yaml"
    path.write_text(changed(text, *(replaced or (FROM_CAD,))), encoding="utf-8")
    return path


def warnings(path: Path) -> tuple[str, ...]:
    *found, unused = assemble(load_scenario(path)).warnings
    assert unused == UNUSED
    return tuple(found)


def test_a_file_in_order_has_no_warnings(tmp_path: Path) -> None:
    assert warnings(lift(tmp_path, plate("P1", 0.0) + plate("P2", 3.0))) == ()


def test_a_part_that_cannot_be_read_is_a_warning(tmp_path: Path) -> None:
    """Its declared weight stands in for it, so the sum of masses tells nothing."""
    broken = W.line((0.0, 0.0, 1.0), (1.0, 0.0, 1.0))
    found = warnings(
        lift(tmp_path, plate("P1", 0.0, -1.0) + plate("P2", 3.0) + plate("P3", 1.5, -29e3, broken))
    )
    assert f"{FILE}counted as point masses by their declared weight: P3" in found
    assert any(each.startswith(f"{FILE}P3: its geometry is not read") for each in found)


def test_masses_that_differ_from_the_declared_ones_are_a_warning(tmp_path: Path) -> None:
    """One part too heavy and one too light make the sum that the weight report has."""
    parts = plate("P1", 0.0, 5e3) + plate("P2", 3.0, -5e3)
    assert warnings(lift(tmp_path, parts)) == (
        f"{FILE}computed and declared mass differ by more than 1%: P1, P2",
    )


def test_of_very_many_doubts_the_first_are_told(tmp_path: Path) -> None:
    gaps = [[(-4, -3, z), (4, -3, z), (4, 3, z), (-4, 3 - 0.05 * z, z)] for z in range(1, 21)]
    parts = "".join(
        W.plate(f"Q{k}", "".join(W.line(one[i], one[i + 1]) for i in range(3)), 1e-3)
        for k, one in enumerate(gaps)
    )
    found = warnings(lift(tmp_path, plate("P1", 0.0) + plate("P2", 3.0) + parts))
    of_file = [each for each in found if each.startswith(FILE)]
    assert len(of_file) == 9
    assert of_file[-1] == f"{FILE}12 more doubts; 'gantline cad load.3docx' tells"


PUMP = "\n  outfitting:\n    - {{name: pump, mass: {mass}, at: [0 m, 0 m, {z}]}}"


def test_outfitting_far_off_is_refused(tmp_path: Path) -> None:
    more = PUMP.format(mass="1 kg", z="2000 m")
    path = lift(tmp_path, plate("P1", 0.0) + plate("P2", 3.0), more)
    with pytest.raises(
        ScenarioError, match=r"outfitting\[1\].*: this outfitting is 199\d.* m outside the load"
    ):
        assemble(load_scenario(path))


def test_outfitting_above_a_load_is_a_warning(tmp_path: Path) -> None:
    """A mast of 2 m may stand there; a slip may too."""
    more = PUMP.format(mass="1 kg", z="5 m")
    found = warnings(lift(tmp_path, plate("P1", 0.0) + plate("P2", 3.0), more))
    assert [each[:21] for each in found] == ["outfitting pump lies "]


def test_a_centre_outside_the_load_is_refused(tmp_path: Path) -> None:
    """A part that is not read, with a declared centre of gravity in millimetres."""
    lost = f'<ocx:Plate id="U" name="U">{W.declared(1e3, (2000.0, 0.0, 0.0))}</ocx:Plate>'
    path = lift(tmp_path, plate("P1", 0.0) + plate("P2", 3.0) + lost)
    with pytest.raises(
        ScenarioError, match=r"centre_of_gravity.*by CAD and outfitting, is outside the load's box"
    ):
        assemble(load_scenario(path))
