"""Loads that come down along landing guides: friction, side force, what centres, what misses, energy.

A load whose guide at p below the hook keeps its centre of gravity x aside presses there with W x/p: balance
of moments about the hook. Down a post it rubs with μN, which its hook does not carry.
"""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from guided_lift import HOOK, MASS, guided_lift
from mechanics import G

WEIGHT = MASS * G
CLEARANCE = 0.03


def guide(name: str, x: float, friction: float, sides: str = "[fore, aft, port, starboard]") -> str:
    """A guide at x of the load [m], whose post stands where that is for a load at the origin."""
    frame = f"at: [{x} m, 0 m, 0 m], sides: {sides}, clearance: {CLEARANCE} m, height: 0.6 m"
    flare = "flare: {length: 0.4 m, angle: 30 deg}"
    cone = "cone: {length: 0.5 m, tip_diameter: 0.2 m}"
    post = f"post: {{at: [{x} m, 0 m, 0 m], diameter: 0.4 m, height: 1 m, {cone}}}"
    return f"  {name}: {{{post}, frame: {{{frame}, {flare}}}, friction: {friction}, capacity: 60 kN}}\n"


def lowered(
    guides: str, at: tuple[float, float], by: float, speed: float = 3.0, more: str = "", rest: float = 5.0
) -> Recording:
    """The load goes down from 2 m over the ground."""
    lower = f"  - {{step: lower, lower: crane, speed: {speed} m/min, by: {by} m}}\n"
    plan = f"{lower}  - {{step: rest, hold: until_end}}\n"
    duration = by / speed * 60.0 + rest
    text = guided_lift(guides, at=at, height=2.0, plan=plan, duration=duration, more=more)
    return simulate(parse_scenario(text, "x.yaml"))


def leans(recording: Recording) -> np.ndarray:
    """How far the load is turned about y [rad]; it turns about no other axis."""
    w, _, y, _ = recording.column("body_orientation", "module").T
    turned: np.ndarray = 2.0 * np.arctan2(y, w)
    return turned


def energy(recording: Recording, kind: str) -> np.ndarray:
    """One kind of energy over time [J]."""
    return np.asarray(recording.column("energy", kind))


def test_friction_takes_what_the_hook_does_not_carry() -> None:
    """Down a post, pressed by its own weight: hook load W − μN, lost energy ∫ μN dz."""
    friction = 0.25
    # The hook is 0.3 m fore of the post's place: the fore side cannot be it, the aft one is.
    recording = lowered(
        guide("g", -3.5, friction, "[aft]"), (0.3, 0.0), 1.8, more="simulation: {sample_interval: 0.01 s}"
    )
    time, z = recording.time, recording.column("body_position", "module")[:, 2]
    force, lean = recording.column("guide_force", "g"), leans(recording)
    # The frame is down on the cylinder and its upright side lies on the shoulder, leaning as the load does.
    window = (time > 25.0) & (time < 33.0)
    assert force[window].min() > 4e3
    borne = force * (friction * np.cos(lean) + np.sin(lean))
    carried = recording.column("hook_load", "crane")
    np.testing.assert_allclose(carried[window], WEIGHT - borne[window], rtol=1e-5)
    # Where it rubs, beside the centre of gravity, the load goes down a little less as it leans more.
    height = (z + (3.5 - 0.2 - CLEARANCE) * np.sin(lean))[window]
    lost = energy(recording, "friction")[window]
    work = np.sum(0.5 * friction * (force[window][1:] + force[window][:-1]) * -np.diff(height))
    assert lost[-1] - lost[0] == pytest.approx(work, rel=1e-3)


def test_side_force_is_that_of_a_pendulum() -> None:
    """Held aside without friction by the top of its frame at p below the hook: N p_z = W c_x."""
    recording = lowered(
        guide("g", -3.5, 0.0, "[aft]"),
        (0.3, 0.0),
        1.8,
        rest=60.0,
        more="simulation: {sample_interval: 0.1 s}",
    )
    moved = 0.3 - recording.column("body_position", "module")[-1, 0]
    lean = leans(recording)[-1]
    top = (HOOK - 0.6) * np.cos(lean) - (3.5 + 0.2 + CLEARANCE) * np.sin(lean)
    force = recording.column("guide_force", "g")[-1]
    assert force == pytest.approx(WEIGHT * moved / top, rel=1e-5)
    # The hand figure, W/L times the way aside with L from the hook to the centre of gravity.
    assert force == pytest.approx(WEIGHT / (HOOK - 1.0) * moved, rel=0.03)


@pytest.mark.parametrize("method", ["adaptive", "del"])
def test_two_posts_bring_a_load_to_its_place(method: str) -> None:
    """Wherever it comes down within what two frames catch they end around their posts, by their clearance."""
    guides = guide("fore", 3.5, 0.2) + guide("aft", -3.5, 0.2)
    more = "simulation: {integrator: del, step: 2 ms}" if method == "del" else ""
    recording = lowered(guides, (0.12, 0.08), 1.7, more=more)
    forces = [recording.column("guide_force", name)[-1] for name in ("fore", "aft")]
    assert sum(forces) > 1e3
    place = recording.column("body_position", "module")[-1]
    turn = Rotation.from_quat(np.roll(recording.column("body_orientation", "module")[-1], -1))
    # Posts press frames in by N/k, of the 20 MN/m of each place.
    most = CLEARANCE + max(forces) / 20e6 + 1e-5
    for end in (3.5, -3.5):
        for height in (0.0, 0.6):
            off = (place + turn.apply([end, 0.0, height - 1.0]) - (end, 0.0, 0.0))[:2]
            assert np.abs(off).max() < most
    # The hook is 0.12 m and 0.08 m aside, and its pendulum presses the frames on their posts that way.
    assert place[0] > 0.0 and place[1] > 0.0
    assert recording.attributes["energy_remainder"] < 1e-6
    # In its one hook it may turn, and comes straight down here.
    [heading] = recording.attributes["warnings"]
    assert "nothing holds the heading of module" in heading


def test_methods_agree_on_what_presses() -> None:
    """Standing against two posts without friction both methods have the forces of one balance."""
    guides = guide("fore", 3.5, 0.0) + guide("aft", -3.5, 0.0)
    forces = []
    for more in ("", "simulation: {integrator: del, step: 2 ms}"):
        recording = lowered(guides, (0.12, 0.0), 1.7, more=more, rest=60.0)
        pressed = [recording.column("guide_force", name)[-1] for name in ("fore", "aft")]
        forces.append(sum(pressed))
    assert forces[0] == pytest.approx(forces[1], rel=1e-3)


def test_a_load_beside_its_guide_stands_on_it() -> None:
    """A lip that comes down on the tip bears the load, and a warning says so, before the run and after it."""
    # 0.2 m flare, 0.03 m clearance and 0.2 - 0.1 m of cone catch 0.33 m; the tip is 0.2 m thick.
    recording = lowered(guide("g", -3.5, 0.3), (0.43, 0.0), 0.8)
    said = " ".join(recording.attributes["warnings"])
    assert "the load misses guide g: its post is 0.43 m to aft of the middle of its frame" in said
    assert "which catches it up to 0.33 m" in said
    assert "would stand on the rim, the tip of the post" in said
    assert "the load misses guide g: the aft side of its frame stands on the rim of the post at" in said
    assert recording.column("guide_force", "g")[-1] > 0.1 * WEIGHT
