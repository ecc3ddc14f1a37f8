"""Loads on many supports, against springs that only push and closed forms."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import gantline
from gantline.assembly import assemble
from gantline.scenario import ScenarioError, load_scenario
from hull_lift import HULL, G, lift, shares_of_springs, simulated, text
from mechanics import adaptive

WEIGHT = 350e3 * G
#: Centre of gravity from the middle of the hull, and the supports of its grid along y first [m].
CENTRE = np.array([-2.0, 0.0])
PLACES = np.array([(x, y) for x in (-18, -6, 6, 18) for y in (-9, -3, 3, 9)], dtype=float)


def supports(**changes: Any) -> dict[str, Any]:
    return {"keel_blocks": {**HULL["supports"]["keel_blocks"], **changes}}


def forces(recording: gantline.Recording) -> np.ndarray:
    """Force of every support (time, support) [N]."""
    names = [support.name for support in recording.rig.supports]
    return np.stack([recording.column("contact_force", name) for name in names], axis=1)


@pytest.mark.parametrize("integrator", ["adaptive", "del"])
def test_sixteen_supports_share_the_weight_by_their_stiffness(tmp_path: Path, integrator: str) -> None:
    """A rigid load on equal springs: N = W/n (1 + e x/<x²>), here <x²> = (18² + 6²)/2 = 180 m², e = −2 m.

    It turns about its centre of gravity as it settles, which so stays where it is over the supports; what is
    left are squares of a tilt of 16 µrad.
    """
    found = forces(simulated(tmp_path, lift(), integrator=integrator))
    expected = WEIGHT / 16 * (1 + CENTRE[0] * PLACES[:, 0] / 180)
    assert found[0] == pytest.approx(expected, rel=1e-8)
    assert found[0].sum() == pytest.approx(WEIGHT, rel=1e-9)
    # It stays so: stable though far more supports carry than are needed.
    assert np.abs(found - found[0]).max() < 1e-6 * WEIGHT
    assert found[-1].sum() == pytest.approx(WEIGHT, rel=1e-9)


def test_supports_of_different_height_and_stiffness_solve_their_complementarity(tmp_path: Path) -> None:
    """Each with its own height and stiffness: low ones do not carry, the others as under a rigid plate.

    Heights differ by up to 20 mm, stiffnesses by a factor of 4. Tilts are below 1 mrad: 5 m · 1 mrad = 5 mm
    moves the centre of gravity by a few thousandths of the distances between supports, so forces agree to
    1 % of the mean with the linear problem of small tilts.
    """
    rng = np.random.default_rng(7)
    heights = 1.5 + 1e-3 * rng.integers(-20, 1, 16)
    heights[5] = 1.5
    stiffness = rng.choice([50e6, 100e6, 200e6], 16)
    each = {
        f"{place // 4 + 1}.{place % 4 + 1}": {
            "height": f"{heights[place]:.3f} m",
            "stiffness": f"{stiffness[place] / 1e6:g} MN/m",
        }
        for place in range(16)
    }
    found = forces(simulated(tmp_path, lift(supports=supports(each=each))))
    expected = shares_of_springs(PLACES, stiffness, heights.max() - heights, WEIGHT, CENTRE)
    assert 3 <= np.count_nonzero(expected) < 16  # some do not carry, or this shows nothing
    assert found[0].sum() == pytest.approx(WEIGHT, rel=1e-9)
    assert found[0] == pytest.approx(expected, abs=0.01 * WEIGHT / 16)
    assert np.array_equal(found[0] > 0, expected > 0)


def test_a_load_on_supports_neither_sinks_nor_drifts_within_an_hour(tmp_path: Path) -> None:
    """It stays where it starts, to 1e-9 m: a rounding of 1e-16 of 35 m a step would come to less."""
    recording = simulated(tmp_path, lift(duration="3600 s"), sample_interval=60.0)
    place = recording.variables["body_position"].values[:, 1]
    assert recording.coordinates["body"][1] == "hull"
    assert np.abs(place - place[0]).max() < 1e-9
    assert recording.attributes["energy_remainder"] < 1e-9


@pytest.mark.parametrize("integrator", ["adaptive", "del"])
def test_a_support_that_is_taken_away_leaves_its_force_to_the_others(tmp_path: Path, integrator: str) -> None:
    """Afterwards the other fifteen share by the same law; what happens, and its peaks, are told."""
    each = {"1.1": {"removed_at": "1 s"}}
    given = lift(supports=supports(each=each), duration="20 s")
    recording = simulated(tmp_path, given, integrator=integrator)
    assert (1.0, "support_removed", "support.keel_blocks.1.1") in recording.events()
    found = forces(recording)
    left = np.ones(16, dtype=bool)
    left[0] = False
    stiffness, level = np.full(16, 100e6), np.zeros(16)
    expected = shares_of_springs(PLACES[left], stiffness[left], level[left], WEIGHT, CENTRE)
    assert found[-1, 0] == 0.0
    # The tilt is of 20 µrad: what it moves is below 1e-4 of the forces. Friction under the load holds the
    # tangential springs a little away from zero.
    assert found[-1, left] == pytest.approx(expected, rel=2e-3)
    assert found[-1].sum() == pytest.approx(WEIGHT, rel=1e-6)
    assert recording.attributes["energy_remainder"] < (1e-5 if integrator == "adaptive" else 1e-3)
    assert any("taken away at 1.00 s under 258 kN" in one for one in recording.attributes["warnings"])
    peaks = recording.metrics()
    # Set free at once, the load swings about where it then rests: no support carries more than it had and
    # twice the change.
    most = np.maximum(found[0, left], 2 * expected - found[0, left]).max()
    assert found[0].max() < peaks["peak_support_force"] <= 1.05 * most


def test_a_load_that_hangs_lifts_off_and_is_set_down_again(tmp_path: Path) -> None:
    """Supports take part in conditions, load transferred and events as the ground does."""
    plan = [
        {"step": "take up", "hoist": "hook", "speed": "1 m/min", "until": {"load_transferred": "50 %"}},
        {"step": "look", "hold": "2 s", "remove_supports": "keel_blocks.1.1"},
        {"step": "lift off", "hoist": "hook", "speed": "1 m/min", "until": {"supports": "clear"}},
        {"step": "clear", "hoist": "hook", "speed": "1 m/min", "by": "0.2 m"},
        {"step": "down", "lower": "hook", "speed": "1 m/min", "by": "1 m"},
        {"step": "stand", "hold": "until_end"},
    ]
    recording = simulated(tmp_path, lift(plan=plan, duration="190 s"))
    kinds = [kind for _, kind, name in recording.events() if name == "hull"]
    assert kinds[0] == "lift_off" and kinds[-1] == "set_down"
    transferred = recording.column("load_transferred", "hull")
    look = next(time for time, kind, name in recording.events("step_begin") if name == "look")
    at = int(np.searchsorted(recording.time, look))
    assert transferred[at] == pytest.approx(0.5, abs=0.05)
    assert transferred.max() == 1.0
    # Taken away with half of the weight still on the supports; the lift goes on.
    assert recording.events("support_removed") == [(look, "support_removed", "support.keel_blocks.1.1")]
    assert recording.column("contact_force", "support.keel_blocks.1.1")[at + 1 :].max() == 0.0
    # In the end it stands with slack slings, all of its weight on the supports.
    assert transferred[-1] == pytest.approx(0.0, abs=1e-6)
    assert recording.attributes["energy_remainder"] < 1e-5


def test_a_load_leaves_a_support_at_its_edge(tmp_path: Path) -> None:
    """Sliding at 1 m/s without friction it loses each support where the end of its underside has passed the
    edge of the top, 0.3 m beyond the middle: at (21.5 − 18 + 0.3)/1 s after the start."""
    document = document_of(
        tmp_path, lift(supports=supports(friction=0), ground=None, start="as_given", slings=None)
    )
    hull = next(body for body in document["bodies"] if body["name"] == "hull")
    hull["joint"]["velocity"] = [1.0, 0.0, 0.0]
    done = adaptive(document, 4.5)
    left = done.events("off_support")
    assert [name for _, name in left] == [f"support.keel_blocks.1.{row}" for row in (1, 2, 3, 4)]
    # Seen within 1 mm of the edge, at 1 m/s.
    assert [time for time, _ in left] == pytest.approx([3.8] * 4, abs=0.0011)


def document_of(folder: Path, given: dict[str, Any]) -> dict[str, Any]:
    """The document of a lift file."""
    path = folder / "scenario.yaml"
    path.write_text(text(given))
    return assemble(load_scenario(path)).document


@pytest.mark.parametrize(
    ("changes", "line"),
    [
        ({"supports": supports(under="blok")}, "'blok' is not the load; right is 'hull'"),
        ({"supports": supports(height=None)}, "the height of 'keel_blocks.1.1' is not known"),
        ({"supports": supports(each={"5.1": {"height": "1 m"}})}, "'5.1' is not a support of the grid"),
        ({"supports": supports(grid={"x": ["30 m"], "y": ["0 m"]})}, "is not under the load"),
        (
            {"load": {**HULL["load"], "stands_on": "keel"}},
            "'keel' is not a group of 'supports' and not 'ground'",
        ),
        ({"load": {**HULL["load"], "position": ["-35 m", "0 m", "2 m"]}}, "0.5 m above the highest of them"),
        (
            {"supports": supports(grid={"x": ["6 m", "18 m"], "y": ["-3 m", "3 m"]})},
            "the load would tip over",
        ),
        (
            {"plan": [{"step": "go", "hold": "until_end", "remove_supports": "keel"}]},
            "'keel' is not a support",
        ),
        ({"start": "settled"}, "'settled' is for a load on the ground"),
    ],
)
def test_supports_that_cannot_be_are_refused(tmp_path: Path, changes: dict[str, Any], line: str) -> None:
    """Each mistake has its own sentence."""
    given = lift(**changes)
    given["supports"] = {
        name: {key: value for key, value in group.items() if value is not None}
        for name, group in given["supports"].items()
    }
    with pytest.raises(ScenarioError) as refused:
        simulated(tmp_path, given)
    assert line in str(refused.value)
