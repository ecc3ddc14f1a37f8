"""Which of tilt, drift and swing are worth a plot: reports had axes to 0.005 with nothing upon them."""

import dataclasses
import json
import math

import numpy as np
import pytest

from gantline.plot.traces import attitude as plot_attitude
from gantline.report.attitude import attitude
from gantline.report.plots import Attitude
from gantline.report.subject import Subject
from gantline.results import Recording
from gantline.results.loads.aside import (
    SMALLEST_TILT,
    SMALLEST_WAY,
    drift_of,
    not_worth_a_plot,
    swing_of,
    tilt_of,
)
from gantline.results.variable import Variable
from gantline.viewer.curves import curves
from sample_lift import ringing_lift

LOAD = "block"


def lift(tilt: float = 0.0, drift: float = 0.0, swing: float | None = None, **more: object) -> Recording:
    """A lift whose load is clear from 10 s on; from 20 s on it has this tilt [rad], drift and swing [m]."""
    plain = ringing_lift()
    later = np.where(plain.time >= 20.0, 1.0, 0.0)
    place = plain["body_position"].values.copy()
    place[:, plain.coordinates["body"].index(LOAD), 0] += drift * later
    variables = {
        **plain.variables,
        "body_position": dataclasses.replace(plain["body_position"], values=place),
        "load_tilt": dataclasses.replace(plain["load_tilt"], values=tilt * later[:, None]),
    }
    if swing is not None:
        variables["load_swing"] = Variable(("time", "load"), swing * later[:, None], "m", "")
    return Recording(variables, plain.coordinates, {**plain.attributes, **more})


def groups(recording: Recording) -> list[str]:
    content = Attitude().content(Subject(recording))
    assert content is not None
    return [json.loads(plot["spec"])["groups"][0] for plot in content["plots"]]


def labels(recording: Recording) -> list[str]:
    figure = plot_attitude(recording)
    assert figure is not None
    return [panel.get_ylabel() for panel in figure.axes if panel.get_ylabel()]


def test_a_load_that_hangs_still_has_a_line_in_place_of_plots() -> None:
    still = lift(tilt=0.99 * SMALLEST_TILT, drift=0.99 * SMALLEST_WAY)
    assert not_worth_a_plot(still) == "no tilt, no drift"
    content = Attitude().content(Subject(still))
    assert content is not None and content["missing"] == "no tilt, no drift"
    assert groups(still) == ["height"]
    assert not {"Tilt [deg]", "Drift [m]"} & set(labels(still))
    figure = plot_attitude(still)
    assert figure is not None
    assert "Time [s]\nno tilt, no drift" in [panel.get_xlabel() for panel in figure.axes]


def test_what_can_be_seen_is_drawn() -> None:
    seen = lift(tilt=1.01 * SMALLEST_TILT, drift=1.01 * SMALLEST_WAY)
    assert not_worth_a_plot(seen) == "" and list(tilt_of(seen)) == list(drift_of(seen)) == [LOAD]
    assert groups(seen) == ["tilt", "drift", "height"]
    assert {"Tilt [deg]", "Drift [m]"} <= set(labels(seen))


def test_a_load_that_is_turned_has_its_swing_in_place_of_its_drift() -> None:
    turned = lift(tilt=math.radians(80.0), drift=4.0, swing=0.02)
    assert groups(turned) == ["tilt", "swing", "height"] and not drift_of(turned)
    assert "Swing [m]" in labels(turned) and "Drift [m]" not in labels(turned)
    (swing,) = (curve for curve in curves(turned) if curve.group == "swing")
    assert swing.values.max() == pytest.approx(0.02)
    # Where nobody recorded how it swings its drift is all there is; a load that hangs level keeps its drift.
    assert groups(lift(tilt=math.radians(80.0), drift=4.0)) == ["tilt", "drift", "height"]
    level = lift(tilt=math.radians(2.0), drift=4.0, swing=0.02)
    assert groups(level) == ["tilt", "drift", "height"] and not swing_of(level)


@pytest.mark.parametrize("kind", ["traverse", "travel"])
def test_swing_is_told_after_the_last_way_of_its_kind(kind: str) -> None:
    plain = lift(swing=0.02)
    plan = [{**step, "kind": kind} for step in plain.attributes["rig"]["plan"] if step["step"] == "hoist"]
    gone = lift(swing=0.02, rig={**plain.attributes["rig"], "plan": plan})
    assert dict(attitude(Subject(gone)))[f"swing after the last {kind}"] == "0.020 m"


def test_a_lift_that_goes_on_keeps_room_for_what_may_come() -> None:
    assert groups(lift(status="ready")) == ["tilt", "drift", "height"]
    content = Attitude().content(Subject(lift(status="ready")))
    assert content is not None and content["missing"] == ""


def test_nothing_has_no_time() -> None:
    assert dict(attitude(Subject(lift())))["largest tilt"] == "0.00 deg"
    assert dict(attitude(Subject(lift(tilt=math.radians(0.5)))))["largest tilt"] == "0.50 deg at 20.0 s"
