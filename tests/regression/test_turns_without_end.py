"""A drum with any number of layers was counted layer by layer.

10¹² turns at the start, or what a step that is only tried let a drum wind, took hours in which nothing could
stop the program. No drum has more than a thousand layers: more is refused, and none beyond them are counted.
"""

from __future__ import annotations

import json

import pytest

from gantline._core import Simulation
from mechanics import Json, body, document, drum, end, flow, point, rope

SETTINGS = json.dumps({"integrator": {"type": "adaptive"}, "duration": 0.1, "sample_interval": 0.1})


def wound(turns: float, start: float) -> Json:
    """A mass that hangs from a drum with `start` turns on it, `turns` in a layer."""
    layers = {"radius": 0.3, "step": 0.02, "turns": turns, "start": start}
    top = drum(None, [0, 0, 10], "drum")
    top["drum"]["layers"] = layers
    ropes = [rope("fall", None, [top, end("mass")], 1e6, 0.01)]
    return document([body("mass", point([0, 0, 0]), 1000.0), flow("drum", 100.0, brake=1e5)], ropes=ropes)


def test_a_thousand_layers_are_the_most() -> None:
    with pytest.raises(
        ValueError, match=r"^fall: its drum has 1e12 turns|^fall: its drum has 1000000000000 turns"
    ) as caught:
        Simulation(json.dumps(wound(10.0, 1e12)), SETTINGS)
    assert str(caught.value).endswith("1000 layers of 10 turns are the most")


def test_some_layers_are_wound() -> None:
    assert Simulation(json.dumps(wound(10.0, 35.0)), SETTINGS).run()["status"] == "done"
