"""One as many: `STL; 1 parts` of a file, and "and 1 more cases that are not sound" of a report."""

from __future__ import annotations

import numpy as np
import pytest

from gantline.cad import CadModel, Part, PartKind
from gantline.cad.mass_properties import MassProperties
from gantline.cad.mesh import TriangleMesh
from gantline.cli.cad_table import cad_table
from gantline.report import render_report
from gantline.results.file.saved import Beside, SavedCase, SavedCases
from sample_lift import ringing_lift


@pytest.mark.parametrize(
    ("count", "said"), [(1, "STL; 1 part; lengths in m"), (2, "STL; 2 parts; lengths in m")]
)
def test_parts_of_a_file(count: int, said: str) -> None:
    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], dtype=float)
    mesh = TriangleMesh(corners, np.array([[0, 1, 2]]))
    plate = Part("plate", PartKind.SHELL, MassProperties.of_shell(mesh, 78.5, 0.01), None, mesh)
    assert cad_table(CadModel("a.stl", "STL", (plate,) * count, "m"), 100)[1] == said


@pytest.mark.parametrize(
    ("count", "said"), [(1, "1 more case that is not sound."), (2, "2 more cases that are not sound.")]
)
def test_cases_left_out_of_the_first_page(count: int, said: str) -> None:
    cases = [SavedCase(f"c{k}", 1, ("load_tilt failed",)) for k in range(3 + count)]
    page = render_report(ringing_lift(), beside=Beside(cases=SavedCases("", False, cases, ())))
    assert f"and {said}" in page
