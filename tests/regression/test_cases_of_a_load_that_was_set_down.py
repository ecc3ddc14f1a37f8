"""Cases of a lift that sets its load down were those of the end, when it stands: 49 kN in slings of 344 kN.

`set down, until: {load_transferred: 2 %}` leaves some percent of a pump skid in its slings, so that it was
not told that nothing hangs. The worst of all cases on the first page was a seventh of what slings had borne.
"""

from __future__ import annotations

from gantline.cli.cases_table import cases_table
from gantline.results.file.saved import SavedCases
from gantline.scenario import parse_scenario
from gantline.study.cases import CasesResult, run_cases

_LIFT = """\
format: 1
lift: {{title: A module is lifted in part}}
duration: 60 s
ground: {{level: 0 m, friction: 0.5}}
ropes: {{sling: {{axial_stiffness: 20 MN, damping_time: 10 ms, mass: none}}}}
load:
  name: module
  shape: {{box: [6 m, 4 m, 3 m]}}
  weight: {{calculated: 40 t, contingency: 1.05}}
  centre_of_gravity: {{at: [0 m, 0 m, 1.5 m]}}
  stands_on: ground
  lugs: {{A: {{at: [-2.5 m, 0 m, 3 m]}}, B: {{at: [2.5 m, 0 m, 3 m]}}}}
cranes:
  crane: {{type: fixed_hook, at: [0 m, 0 m, 11 m], hoist: {{speed: 3 m/min, acceleration: 0.05 m/s^2}}}}
slings:
  A: {{from: crane, to: module.A, length: 8.4 m, rope: sling}}
  B: {{from: crane, to: module.B, length: 8.4 m, rope: sling}}
plan:
  - {{step: lift, hoist: crane, speed: 0.3 m/min, until: {until}}}
  - {{step: hold, hold: until_end}}
cases: {{heavy: {{set: {{load.weight.simulate: design}}}}}}
"""


def _cases(until: str) -> CasesResult:
    return run_cases(parse_scenario(_LIFT.format(until=until)))


def _shown(result: CasesResult) -> str:
    return " ".join(" ".join(cases_table(result, width=100, variants=False)).split())


def test_a_load_that_stands_in_part_is_told_first() -> None:
    """Table, file and first page say so, with the share that hangs."""
    result = _cases("{load_transferred: 50 %}")
    (stands,) = result.given.partly_stands
    assert result.given.rest is not None
    share = float(result.given.rest.recording.column("load_transferred", "module")[-1])
    assert 0.5 <= share < 0.9
    assert stands == f"module stands, with {100 * share:.0f} % of its weight in its slings"
    assert f"at 60.0 s {stands}: slings and hooks carry more where it hangs" in _shown(result)
    assert list(SavedCases.from_json(result.to_json()).cases[0].partly_stands) == [stands]


def test_one_that_hangs_is_not() -> None:
    """Lifted off, all of it hangs."""
    result = _cases("{supports: clear}")
    assert result.given.partly_stands == ()
    assert "module stands" not in _shown(result)
