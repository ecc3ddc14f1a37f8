"""What each lug carries, with its direction, against forces by hand; and as a table."""

from __future__ import annotations

import csv
import math
from pathlib import Path

import pytest

from gantline.checks import LugFigures, lug_figures
from gantline.export import TableError, write_lugs
from gantline.results.loads.spreaders import thrust
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.statics import Statics
from verbs import gantline

#: A bar below a hook by two slings at 45 deg, a load below the bar by two plumb ones; nothing else weighs.
LIFT = """\
format: 1
lift: {title: Below a bar}
duration: 10 s
ropes: {stiff: {axial_stiffness: 1000 MN, mass: none, damping_time: 10 ms}}
load:
  name: box
  shape: {box: [10 m, 4 m, 2 m]}
  weight: {calculated: 100 t, contingency: 1.1}
  centre_of_gravity: {at: [1 m, 0 m, 1 m]}
  position: [0 m, 0 m, 0 m]
  lugs:
    W: {at: [-3 m, 0 m, 2 m], main_plate: xz, capacity: 100 t}
    E: {at: [ 5 m, 0 m, 2 m], main_plate: yz}
spreaders:
  bar:
    mass: 0.1 kg
    size: [8 m, 0.1 m, 0.1 m]
    lugs:
      T1: {at: [-4 m, 0 m, 0 m], main_plate: xz, capacity: 100 t}
      T2: {at: [ 4 m, 0 m, 0 m], main_plate: xz, capacity: 100 t}
cranes:
  hook: {type: fixed_hook, at: [1 m, 0 m, 11 m], hoist: {speed: 1 m/min, acceleration: 0.1 m/s^2}}
slings:
  T1: {from: hook, to: bar.T1, length: 5.657 m, rope: stiff}
  T2: {from: hook, to: bar.T2, length: 5.657 m, rope: stiff}
  W: {from: bar.T1, to: box.W, length: 5.001 m, rope: stiff}
  E: {from: bar.T2, to: box.E, length: 5.001 m, rope: stiff}
rules: {dynamic_amplification_factor: 1.2, lug_consequence_factor: 1.3}
plan: [{step: hold, hold: until_end}]
"""
#: Half of the load at each end [N], with the factors of contingency, dynamics and consequence below.
HALF = 50e3 * 9.81
FACTORS = 1.1 * 1.2 * 1.3


@pytest.fixture(scope="module")
def rest() -> Recording:
    return Statics(parse_scenario(LIFT)).equilibrium().recording


@pytest.fixture(scope="module")
def lugs(rest: Recording) -> dict[str, LugFigures]:
    return {one.lug: one for one in lug_figures(rest)}


def test_a_lug_of_the_load_is_pulled_up(lugs: dict[str, LugFigures]) -> None:
    west = lugs["box.W"]
    assert west.slings == ("W",)
    assert west.at == pytest.approx((-4.0, 0.0, 1.0))  # from the centre of gravity
    assert west.static == pytest.approx(1.1 * HALF, rel=1e-3)
    assert west.force == pytest.approx(FACTORS * HALF, rel=1e-3)
    assert west.pull == pytest.approx((0.0, 0.0, FACTORS * HALF), rel=1e-3, abs=1e-3 * HALF)
    assert west.out_of_plane == pytest.approx(0.0, abs=1e-3)
    assert west.capacity == pytest.approx(100e3 * 9.81)
    assert west.used == pytest.approx(FACTORS * 0.5, rel=1e-3)
    assert west.time is None  # by the rule
    assert lugs["box.E"].used is None


def test_slings_above_and_below_pull_at_a_lug_of_the_bar_together(lugs: dict[str, LugFigures]) -> None:
    """The sizes add up, √2 + 1 halves; what they pull together is the thrust along the bar, one half."""
    size = FACTORS * HALF * (math.sqrt(2.0) + 1.0)
    for lug, inwards in (("bar.T1", 1.0), ("bar.T2", -1.0)):
        one = lugs[lug]
        assert one.slings == (lug[4:], "W" if inwards > 0.0 else "E")
        assert one.force == pytest.approx(size, rel=1e-3)
        assert one.pull == pytest.approx((inwards * size, 0.0, 0.0), rel=1e-3, abs=1e-3 * size)


@pytest.mark.parametrize(("inwards", "length"), [(0.0, 5.001), (1.0, 5.1)])
def test_slings_that_lean_inwards_below_a_bar_push_it_together_too(inwards: float, length: float) -> None:
    """tan 45° above and 1 m over 5 m below, each of half of the load."""
    text = LIFT.replace("at: [-3 m,", f"at: [{inwards - 3.0} m,").replace("[ 5 m,", f"[{5.0 - inwards} m,")
    text = text.replace("length: 5.001 m", f"length: {length} m")
    found = Statics(parse_scenario(text)).equilibrium().recording
    (bar,) = found.rig.spreaders
    assert thrust(found, bar)[-1] == pytest.approx((1.0 + inwards / 5.0) * HALF, rel=2e-3)


def test_the_table_has_kn_and_t(rest: Recording, tmp_path: Path) -> None:
    write_lugs(rest, tmp_path / "lugs.csv")
    with (tmp_path / "lugs.csv").open(encoding="utf-8", newline="") as file:
        rows = {row["lug"]: row for row in csv.DictReader(file)}
    west = rows["box.W"]
    assert float(west["static [t]"]) == pytest.approx(55.0, rel=1e-3)
    assert float(west["force [kN]"]) == pytest.approx(FACTORS * HALF / 1e3, rel=1e-3)
    assert float(west["force [t]"]) == pytest.approx(FACTORS * 50.0, rel=1e-3)
    assert float(west["force z [kN]"]) == pytest.approx(FACTORS * HALF / 1e3, rel=1e-3)
    assert west["capacity [t]"] == "100.000"
    assert west["how"].endswith("x 1.2 x 1.3")
    assert rows["box.E"]["capacity [kN]"] == rows["box.E"]["used [%]"] == ""


def test_the_verb(rest: Recording, tmp_path: Path) -> None:
    rest.save(tmp_path / "rest.nc")
    table = tmp_path / "lugs.csv"
    done = gantline("export", str(tmp_path / "rest.nc"), str(table), "--lugs")
    assert done.exit_code == 0, done.stderr
    assert table.read_text(encoding="utf-8").startswith("lug,slings,")
    for more, told in (
        (["lugs.png", "--lugs"], "--lugs: the table of lugs is a .csv, and lugs.png is none"),
        (["l.csv", "--lugs", "--variable", "hook_load"], "--lugs: the table of lugs has no --variable"),
    ):
        refused = gantline("export", str(tmp_path / "rest.nc"), *more)
        assert refused.exit_code == 2
        assert told in " ".join(refused.stderr.split())


def test_a_lift_without_lugs(tmp_path: Path) -> None:
    hung = "format: 1\nlift: {title: none}\nduration: 1 s\nropes: {r: {axial_stiffness: 1 MN}}\n"
    body = "{at: [0, 0, 0], joint: {type: slider, axis: [0, 0, 1]}, mass: 1 kg}"
    hung += f"mechanics:\n  bodies: {{w: {body}}}\n  ropes:\n    a: {{rope: r, length: 5 m, route: "
    hung += "[{type: end, body: world, at: [0, 0, 5 m]}, {type: end, body: w}]}\n"
    recording = Statics(parse_scenario(hung)).equilibrium().recording
    with pytest.raises(TableError, match="no sling or rope of this recording is made fast to a lug"):
        write_lugs(recording, tmp_path / "lugs.csv")
