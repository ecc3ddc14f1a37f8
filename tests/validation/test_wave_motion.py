"""A crane barge by the table of its own answers to waves, against the same barge by its wave forces."""

from __future__ import annotations

from importlib.resources import files
from pathlib import Path

import numpy as np
import pytest

from compensated import BARGE, compensated_text
from gantline.hydro import DisplacementRaos, read_database, write_raos
from gantline.scenario import Scenario, parse_scenario
from gantline.simulation import simulate
from gantline.statics import Statics
from gantline.study.heave_demand import heave_demands

#: Where the database of the scenario counts from, vessel axes [m].
AT = np.array([45.0, 0.0, 3.0])
PLAN = "  - {step: hold, hold: until_end, compensate_heave: H1}\n"


def own_table(lift: Scenario, path: Path) -> None:
    """X of the point `AT` by (−ω²M − iωB + C)⁻¹ F of the lift at rest, with load, boom and moorings."""
    waves = read_database(str(files("gantline.scenarios") / "crane_barge.nc"))
    statics = Statics(lift)
    rest = statics.equilibrium(time=0.0).recording
    about = rest.column("body_position", "barge")[-1]
    arm = np.array([AT[0], AT[1], AT[2] - 3.0]) - about  # at 3 m of draft, heading 0, without trim
    assert waves.excitation is not None
    answers = []
    for omega, forces in zip(waves.frequencies, waves.excitation, strict=True):
        model = statics.linear_model(omega)
        motion = model.body_motion[model.bodies.index("barge")]
        dynamic = -(omega**2) * model.mass - 1j * omega * model.damping + model.stiffness
        wrench = np.concatenate([forces[:, :3], forces[:, 3:] + np.cross(arm, forces[:, :3])], axis=1)
        answer = (motion @ np.linalg.solve(dynamic, motion.T @ wrench.T)).T
        answers.append(np.concatenate([answer[:, :3] + np.cross(answer[:, 3:], arm), answer[:, 3:]], axis=1))
    write_raos(DisplacementRaos("own", waves.frequencies, waves.directions, np.array(answers)), path)


@pytest.fixture(scope="module")
def lifts(tmp_path_factory: pytest.TempPathFactory) -> tuple[Scenario, Scenario]:
    """The barge free in its waves, and carried by the table."""
    text = compensated_text(PLAN)
    free = parse_scenario(text, str(BARGE))
    folder = tmp_path_factory.mktemp("raos")
    own_table(free, folder / "own.csv")
    by_forces = text[text.index("    radiation:") : text.index("mooring_lines:")]
    by_table = "    wave_motion: {raos: own.csv, phases: lag, at: [45 m, 0 m, 3 m]}\n\n"
    return free, parse_scenario(text.replace(by_forces, by_table), str(folder / "lift.yaml"))


def test_heave_compensation_is_asked_for_as_much(lifts: tuple[Scenario, Scenario]) -> None:
    """Of the free barge by the linear model that the table was made with, where it rests: to 1 %."""
    (free,), (carried,) = (heave_demands(lift) for lift in lifts)
    for name in ("speed", "acceleration", "stroke", "deviation"):
        assert getattr(carried, name) == pytest.approx(getattr(free, name), rel=0.01)


def test_what_hangs_from_it_feels_the_same(lifts: tuple[Scenario, Scenario]) -> None:
    """Standard deviations over 100 s of one record: what the hook bears and trim to 1 %, as the free barge
    drifts meanwhile; heel to 5 %, since the load, 1.5 % of what the barge displaces, swings across it as it
    has begun with the waves, which the table does not know.
    """
    runs = [simulate(lift.changed({"plan.1": {"step": "hold", "hold": "until_end"}})) for lift in lifts]
    late = runs[0].time > 21.0  # when waves are whole
    compared = {
        ("hoist_load", "sheerleg.H1"): 0.01,
        ("vessel_trim", "barge"): 0.01,
        ("vessel_heel", "barge"): 0.05,
    }
    for (variable, column), tolerance in compared.items():
        one, other = (float(np.std(run.column(variable, column)[late])) for run in runs)
        assert other == pytest.approx(one, rel=tolerance), variable
