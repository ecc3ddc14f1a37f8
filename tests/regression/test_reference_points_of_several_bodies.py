"""Reference points and volumes of the bodies of a file of Capytaine 3 were not found.

Up to version 2 they run over `body_name`, from 3 on over `body`. A file of two had none then: phases of waves
on both counted from its origin, so that one of two barges 40 m apart felt crests 40 m from where they were.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import two_hulls
from gantline.hydro import read_database


@pytest.mark.parametrize("over", ["body", "body_name"])
def test_each_body_has_its_own(tmp_path: Path, over: str) -> None:
    tables = {"disp_volume": ((over,), [700.0, 800.0])}
    given = {
        over: list(two_hulls.BODIES),
        "rotation_center": ((over, "space_coordinate"), two_hulls.REFERENCES),
    }
    path = two_hulls.database(
        tmp_path / "two.nc", tables=tables, coordinates=given, without=["body"] if over != "body" else []
    )
    for body, reference, volume in zip(two_hulls.BODIES, two_hulls.REFERENCES, (700.0, 800.0), strict=True):
        found = read_database(path, body)
        assert found.reference is not None
        assert found.reference == pytest.approx(reference, abs=0.0)
        assert found.displacement == volume


def test_phases_need_them(tmp_path: Path) -> None:
    from gantline.assembly import assemble
    from gantline.scenario import ScenarioError, load_scenario

    two_hulls.database(tmp_path / "two.nc", without=["rotation_center"])
    swell = {"height": "1 m", "period": "8 s", "direction": "90 deg"}
    path = two_hulls.in_waves(tmp_path, swell)
    with pytest.raises(ScenarioError) as caught:
        assemble(load_scenario(path))
    said = str(caught.value)
    assert (
        "vessels.left.wave_forces.database: two.nc (Capytaine): does not say where the reference point"
        in said
    )
    assert "('rotation_center'); of several bodies each counts phases from one origin" in said
    assert np.isfinite(read_database(tmp_path / "two.nc", "left").added_mass).all()
