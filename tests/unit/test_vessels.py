"""Parts of vessels by themselves: edges of decks, masses aboard, damping that is refused, drafts."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from afloat import KG, MASS, barge, lift_of, sheerleg, written
from gantline.assembly import assemble
from gantline.assembly.afloat.deck import deck_edge
from gantline.assembly.afloat.hulls import HullMesh
from gantline.hydro import box_hull, raked_barge
from gantline.results.afloat.vessels import Vessel, vessel_state
from gantline.scenario import ScenarioError, load_scenario


def edge_of(vertices: np.ndarray, triangles: np.ndarray) -> set[tuple[float, float, float]]:
    return {(x, y, z) for x, y, z in deck_edge(HullMesh(np.round(vertices, 9), triangles))}


def test_the_deck_of_a_box_ends_at_its_four_upper_corners() -> None:
    corners = {(x, y, 6.0) for x in (0.0, 60.0) for y in (-10.0, 10.0)}
    vertices, triangles = box_hull((60.0, 20.0, 6.0)).mesh
    assert edge_of(vertices, triangles) == corners
    # Without its lid it ends there too: at edges of one triangle.
    is_lid = (vertices[triangles][:, :, 2] == 6.0).all(axis=1)
    assert edge_of(vertices, triangles[~is_lid]) == corners


def test_sloping_bottoms_are_no_deck() -> None:
    vertices, triangles = raked_barge((60.0, 20.0, 6.0), 8.0, 2.0).mesh
    assert edge_of(vertices, triangles) == {(x, y, 6.0) for x in (0.0, 60.0) for y in (-10.0, 10.0)}


def test_what_stands_on_a_vessel_is_damped_along(tmp_path: Path) -> None:
    """The damping is about the centre of gravity of vessel, tanks, boom and head gear, by hand 10.8 m above
    the keel.
    """
    scenario = load_scenario(written(tmp_path, sheerleg(water_damping={"critical": {"heave": "20 %"}})))
    forces = {force["name"]: force for force in assemble(scenario).document["forces"]}
    at = forces["crane.critical_damping"]["at"]
    assert at[1] == pytest.approx(0, abs=1e-12)
    assert at[2] == pytest.approx(10.8, abs=0.05)


def test_a_share_of_what_does_not_right_itself_is_refused(tmp_path: Path) -> None:
    masses = {"hull": {"mass": f"{MASS} kg", "at": ["50 m", "0 m", "22 m"]}}
    given = lift_of(barge(masses=masses, water_damping={"critical": {"roll": "6 %"}}))
    with pytest.raises(ScenarioError) as raised:
        assemble(load_scenario(written(tmp_path, given)))
    said = str(raised.value)
    assert "vessels.barge.water_damping.critical.roll: nothing restores roll upright at this draft" in said
    assert said.endswith("GM is -1.25 m; give 'roll' itself, such as '100 MN m s'")


def test_drafts_stay_numbers_on_the_beam_ends() -> None:
    """At 90° of heel no draft has a meaning; it is large, not infinite."""
    turned = np.array([[[np.sqrt(0.5), np.sqrt(0.5), 0.0, 0.0]]])
    columns = {
        "body_orientation": turned,
        "body_position": np.array([[[0.0, 0.0, 1.0]]]),
        "displaced_volume": np.array([[10.0]]),
    }
    vessel = Vessel("v", "v", ends=(0.0, 10.0), hull="v.hull", marks={"deck_edge": [[0.0, 3.0, 2.0]]})
    found, _ = vessel_state(columns, {"body": ["v"], "hull": ["v.hull"]}, [vessel])
    assert all(np.isfinite(variable.values).all() for variable in found.values())
    assert found["vessel_heel"].values[0, 0] == pytest.approx(np.pi / 2)
    # Port points up: that point is 1 + 3 m above the water.
    assert found["vessel_freeboard"].values[0, 0] == pytest.approx(4.0)


def test_a_vessel_starts_at_rest_by_itself(tmp_path: Path) -> None:
    assert load_scenario(written(tmp_path, lift_of(barge()))).starts_at_rest
    assert barge()["masses"]["hull"]["at"][2] == f"{KG} m"


def test_pictures_and_report_show_how_a_vessel_lies(tmp_path: Path) -> None:
    from gantline.plot.pictures import PICTURES
    from gantline.report import write_report
    from gantline.simulation import simulate
    from gantline.viewer.pack import pack

    run = simulate(written(tmp_path, lift_of(barge(heel="5 deg"), start="as_given")))
    figure = PICTURES["vessels"](run)
    assert figure is not None
    drawn = [np.asarray(line.get_ydata()) for panel in figure.axes for line in panel.lines]
    assert any(
        np.allclose(one, np.degrees(run.column("vessel_heel", "barge"))) for one in drawn if len(one) > 2
    )
    header = pack(run).header
    assert {"draft", "trim", "heel", "freeboard"} <= {curve["group"] for curve in header["curves"]}
    # The player draws the surface of the water at its level.
    assert header["water"] == pytest.approx(0.0)
    page = tmp_path / "report.html"
    write_report(run, page)
    assert 'id="vessels"' in page.read_text(encoding="utf-8")
