"""Loads whose shape, inertia and centre of gravity come from a CAD file."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from matplotlib.collections import PolyCollection
from typer.testing import CliRunner

import gantline
from gantline.assembly import Assembly, assemble
from gantline.cad.mass_properties import MassProperties
from gantline.cad.ocx_writer import write_ocx
from gantline.cad.ship_block import ShipBlockSizes, ship_block
from gantline.cli.app import app
from gantline.plot.scene import snapshot
from gantline.plot.views import system
from gantline.scenario import ScenarioError, load_scenario
from lift_text import changed, spoiled

SIZES = ShipBlockSizes(8, 6, 3, 40e3, double_bottom=0.9, frame_spacing=2.0)
BOX = "shape: {box: [8 m, 6 m, 3 m]}"


@cache
def ocx() -> bytes:
    return write_ocx(ship_block(SIZES))


@cache
def steel() -> MassProperties:
    return ship_block(SIZES).model.properties


@pytest.fixture(scope="module")
def folder_of_cache(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("cache")


@pytest.fixture(autouse=True)
def own_cache(folder_of_cache: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(folder_of_cache))


def lift(folder: Path, more: str = "", shape: str = "cad: load.3docx") -> Path:
    """The sample lift of 60 t with a shape from CAD."""
    (folder / "load.3docx").write_bytes(ocx())
    text = spoiled(BOX, f"shape: {{{shape}}}\n  datum: bottom_centre{more}")
    path = folder / "lift.yaml"
    path.write_text(text, encoding="utf-8")
    return path


def assembled(path: Path, *replaced: tuple[str, str]) -> Assembly:
    path.write_text(changed(path.read_text(encoding="utf-8"), *replaced), encoding="utf-8")
    return assemble(load_scenario(path))


def load_of(assembly: Assembly) -> dict[str, Any]:
    return next(body for body in assembly.document["bodies"] if body["name"] == "block")


def inertia_of(assembly: Assembly) -> np.ndarray:
    xx, yy, zz, xy, xz, yz = load_of(assembly)["inertia"]
    return np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])


FROM_CAD = ("at: [0 m, 0 m, 1.5 m]", "at: from_cad")


def test_inertia_and_centre_from_cad_are_scaled_to_the_weight(tmp_path: Path) -> None:
    """40 t of steel in the file, 60 t to be lifted: inertia times 60/40, the centre where the file has it."""
    assembly = assembled(lift(tmp_path), FROM_CAD)
    assert load_of(assembly)["mass"] == pytest.approx(60e3)
    expected = steel().inertia * 1.5
    assert inertia_of(assembly) == pytest.approx(expected, abs=1e-6 * float(expected.max()))
    low = ship_block(SIZES).model.box[0, 2]
    centre = assembly.rig["loads"][0]["centre_of_gravity_from_datum"]
    assert centre == pytest.approx(steel().centre - [0, 0, low], abs=1e-9)
    warning, unused = assembly.warnings
    assert unused == "no sling leads to lug L3"
    assert warning == (
        "the CAD file of the load weighs 40 t, its calculated weight is 60 t (-33.3 %): "
        "masses are scaled to the weight"
    )


def test_design_weight_scales_everything(tmp_path: Path) -> None:
    simulate = ("contingency: 1.05}", "contingency: 1.05, simulate: design}")
    assembly = assembled(lift(tmp_path), FROM_CAD, simulate)
    assert load_of(assembly)["mass"] == pytest.approx(63e3)
    expected = steel().inertia * 63 / 40
    assert inertia_of(assembly) == pytest.approx(expected, abs=1e-6 * float(expected.max()))


OUTFITTING = """
  outfitting:
    - {name: pump unit, mass: 15 t, at: [-2 m, 1 m, 1 m]}
    - {name: pipe module, mass: 5 t, at: [1 m, -1 m, 2 m]}"""


def test_outfitting_is_added_as_point_masses(tmp_path: Path) -> None:
    """40 t of steel and 20 t of outfitting are the 60 t: no warning, and mass properties by parallel axes."""
    assembly = assembled(lift(tmp_path, OUTFITTING), FROM_CAD)
    low = ship_block(SIZES).model.box[0, 2]
    points = [MassProperties.of_point(15e3, (-2, 1, 1)), MassProperties.of_point(5e3, (1, -1, 2))]
    whole = MassProperties.combined([steel().moved(np.eye(3), (0, 0, -low)), *points])
    of_lug, of_hook = assembly.warnings
    assert of_lug == "no sling leads to lug L3"
    # Outfitting takes the centre of gravity from below the hook, which stands above the datum.
    assert of_hook.startswith("hook stands 0.45 m beside the centre of gravity of ")
    assert load_of(assembly)["mass"] == pytest.approx(60e3)
    assert assembly.rig["loads"][0]["centre_of_gravity_from_datum"] == pytest.approx(whole.centre, abs=1e-9)
    assert inertia_of(assembly) == pytest.approx(whole.inertia, abs=1e-6 * float(whole.inertia.max()))


def test_a_stated_centre_is_held_against_the_one_from_cad(tmp_path: Path) -> None:
    """Stated 1.5 m high; the file has it elsewhere: the stated one is simulated and the distance said."""
    assembly = assembled(lift(tmp_path, OUTFITTING))
    centre = assembly.rig["loads"][0]["centre_of_gravity_from_datum"]
    assert centre == pytest.approx([0, 0, 1.5])
    warning, _ = assembly.warnings
    assert warning.startswith(
        "the centre of gravity of the load is stated at (0, 0, 1.5) m; CAD and outfitting"
    )
    assert warning.endswith("m away: the stated one is simulated")
    # Along x, with the steel at 0: (15 (−2) + 5 · 1)/60 = −0.417 m; along y (15 − 5)/60 = 0.167 m.
    assert "give (-0.417, 0.167, " in warning


def test_the_check_of_a_lift_file_warns_of_it_too(tmp_path: Path) -> None:
    path = lift(tmp_path, OUTFITTING)
    result = CliRunner().invoke(app, ["check", str(path)])
    assert result.exit_code == 0, result.output
    (line,) = (one for one in result.output.splitlines() if "CAD and outfitting give" in one)
    assert line.startswith(f"warning: {path}:")
    told = "load.centre_of_gravity.at: the centre of gravity of the load is stated at (0, 0, 1.5) m"
    assert f": {told}; CAD and outfitting give" in line


def test_a_stated_inertia_goes_before_the_one_from_cad(tmp_path: Path) -> None:
    stated = "\n  inertia: {xx: 300 t m^2, yy: 500 t m^2, zz: 600 t m^2}"
    assembly = assembled(lift(tmp_path, stated), FROM_CAD)
    assert load_of(assembly)["inertia"] == pytest.approx([300e3, 500e3, 600e3, 0, 0, 0])


def test_the_datum_is_the_origin_of_the_file_unless_named(tmp_path: Path) -> None:
    """The bottom plate's lower side is half its thickness below the file's origin: there stands the load."""
    low = float(ship_block(SIZES).model.box[0, 2])
    path = lift(tmp_path)
    raised = ("position: [0 m, 0 m, 0 m]", f"position: [0 m, 0 m, {-low!r} m]")
    assembly = assembled(path, FROM_CAD, ("\n  datum: bottom_centre", ""), raised)
    assert assembly.rig["loads"][0]["centre_of_gravity_from_datum"] == pytest.approx(steel().centre, abs=1e-9)
    lowest = min(contact["at"][2] for contact in assembly.document["contacts"])
    assert lowest == pytest.approx(low - steel().centre[2], abs=1e-9)


def test_units_are_those_of_the_file(tmp_path: Path) -> None:
    assembled(lift(tmp_path, shape="cad: load.3docx, units: m"), FROM_CAD)
    with pytest.raises(ScenarioError, match=r"its lengths are in m, as it says itself, not in mm"):
        assembled(lift(tmp_path, shape="cad: load.3docx, units: mm"), FROM_CAD)


@pytest.mark.parametrize(
    ("replaced", "says"),
    [
        (
            ("at: [0 m, 0 m, 1.5 m]", "at: [0 m, 0 m, 3.2 m]"),
            "load.centre_of_gravity.at: (0, 0, 3.2) m is outside",
        ),
        (
            ("L3: {at: [ 0 m, 0 m, 3 m]", "L3: {at: [ 20 m, 0 m, 3 m]"),
            "load.lugs.L3.at: this lug is 16 m outside",
        ),
        (
            ("position: [0 m, 0 m, 0 m]", "position: [0 m, 0 m, 1 m]"),
            "its underside is 1 m above it; right is z = 0 m",
        ),
        (("cad: load.3docx", "cad: lift.yaml"), "load.shape.cad: lift.yaml: is no CAD file that can be read"),
        (
            ("cad: load.3docx", "cad: load.3docx, thickness: 20 m"),
            "a plate thickness of 20 m is not possible",
        ),
    ],
)
def test_what_does_not_fit_the_file_has_a_line(tmp_path: Path, replaced: tuple[str, str], says: str) -> None:
    with pytest.raises(ScenarioError) as caught:
        assembled(lift(tmp_path), replaced)
    assert says in str(caught.value)
    assert str(caught.value).startswith(f"{tmp_path / 'lift.yaml'}:")


def test_the_underside_of_a_file_with_its_own_origin(tmp_path: Path) -> None:
    with pytest.raises(ScenarioError, match=r"its underside is 0\.011\d+ m below it"):
        assembled(lift(tmp_path), FROM_CAD, ("\n  datum: bottom_centre", ""))


def test_a_file_without_weight_is_refused(tmp_path: Path) -> None:
    path = lift(tmp_path, shape="cad: sheet.obj")
    (tmp_path / "sheet.obj").write_text("v 0 0 0\nv 8 0 0\nv 0 6 0\nv 0 0 3\nf 1 2 3\nf 1 2 4\n")
    with pytest.raises(ScenarioError, match=r"load\.shape\.cad: sheet\.obj: no part has a mass"):
        assembled(path, FROM_CAD)


def test_the_load_is_lifted_and_drawn(tmp_path: Path) -> None:
    """A short run: the recording holds the mesh, the hull and the warnings, and pictures draw the mesh."""
    path = lift(tmp_path, OUTFITTING)
    text = path.read_text(encoding="utf-8").replace("duration: 20 s", "duration: 1 s")
    path.write_text(text.replace("brake_from: 10 s", "brake_from: 0.5 s"), encoding="utf-8")
    recording = gantline.simulate(path)
    assert any("CAD and outfitting give" in warning for warning in recording.attributes["warnings"])
    shape = next(b for b in recording.attributes["scene"]["bodies"] if b["name"] == "block")["shape"]
    assert shape["type"] == "mesh" and 100 < len(shape["triangles"]) <= 4000
    assert len(shape["hull"]) >= 8
    box = next(box for box in snapshot(recording, 0).boxes if box.name == "block")
    assert box.triangles is not None
    assert np.ptp(box.faces.reshape(-1, 3), axis=0) == pytest.approx([8, 6, 3], abs=0.05)
    # It stands on the ground, in the world.
    assert box.triangles[:, :, 2].min() == pytest.approx(0, abs=0.01)
    figure = system(recording)
    assert figure is not None
    drawn = [
        [len(c.get_paths()) for c in panel.collections if isinstance(c, PolyCollection)]
        for panel in figure.axes
    ]
    views = [counts for counts in drawn if counts]
    assert views and all(max(counts) > 50 for counts in views)  # of the mesh; there are fewer sheaves
    figure.savefig(tmp_path / "system.png", dpi=60)
    # Nothing but the recording is needed to draw it again.
    recording.save(tmp_path / "lift.nc")
    again = gantline.open_recording(tmp_path / "lift.nc")
    assert np.array_equal(snapshot(again, 0).boxes[-1].faces, snapshot(recording, 0).boxes[-1].faces)


def test_the_check_of_a_lift_file_says_where_cad_has_the_centre(tmp_path: Path) -> None:
    path = lift(tmp_path, OUTFITTING)
    path.write_text(path.read_text(encoding="utf-8").replace(*FROM_CAD), encoding="utf-8")
    result = CliRunner().invoke(app, ["check", str(path)])
    assert result.exit_code == 0, result.output
    assert "by CAD and outfitting: [-0.417 m, 0.167 m, " in result.output


def test_what_hangs_on_the_lugs_is_not_of_the_centre_that_is_told(tmp_path: Path) -> None:
    """A shackle of 3 t at one lug moved what `check` told by 0.14 m; written out it counted twice."""
    path = lift(tmp_path)
    heavy = ("wb40: {working_load_limit: 40 t, mass: 0 kg}", "wb40: {working_load_limit: 40 t, mass: 3 t}")
    text = changed(path.read_text(encoding="utf-8"), FROM_CAD, heavy)
    path.write_text(text, encoding="utf-8")
    result = CliRunner().invoke(app, ["check", str(path)])
    assert result.exit_code == 0, result.output
    x, y, z = steel().centre - [0, 0, ship_block(SIZES).model.box[0, 2]]
    assert f"by CAD and outfitting: [{x:z.3f} m, {y:z.3f} m, {z:.3f} m] from its datum" in result.output


def test_corners_of_an_envelope_need_a_stated_centre(tmp_path: Path) -> None:
    path = lift(tmp_path, OUTFITTING)
    text = path.read_text(encoding="utf-8").replace(
        "at: [0 m, 0 m, 1.5 m]", "at: from_cad, envelope: [0.1 m, 0 m, 0 m]"
    )
    case = "cases: {corners: {vary: load.centre_of_gravity.envelope, corners: all}}\n"
    path.write_text(text + case, encoding="utf-8")
    result = CliRunner().invoke(app, ["check", str(path)])
    assert result.exit_code == 2
    assert "cases.corners.vary: the centre of gravity is that of the CAD file; state it in" in result.output
