"""A second Ctrl-C while the core was at work ended `gantline check --simulate` in a traceback, and with 1.

That is the code of a check that failed. The first array that the core handed out had it look up numpy's
functions, which runs a line of Python, and what runs Python first meets the KeyboardInterrupt that
waits. In there it was a panic, `Failed to access NumPy array API capsule`. The core now looks them up
while it is loaded; an array that is handed out runs no Python, so that a Ctrl-C is met after it, as
anywhere else.
"""

from __future__ import annotations

import json
import subprocess
import sys

import pytest

# In a process of its own, since the first array of all counts. `hand_out` may run no Python.
PROGRAM = """
import json, sys
import numpy as np
{prepare}
called = []
def note(frame, event, argument):
    if event == "call":
        called.append(frame.f_code.co_filename + ":" + frame.f_code.co_name)
sys.setprofile(note)
{hand_out}
sys.setprofile(None)
print(json.dumps(called))
"""
SIMULATION = """
from gantline.simulation import Simulation
core = Simulation("pulleys")._core
core.run()
"""
HULL = """
from gantline import _core
tetrahedron = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
faces = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]], dtype=np.int64)
"""


@pytest.mark.parametrize(
    ("prepare", "hand_out"),
    [(SIMULATION, "core.columns()"), (HULL, "_core.Hull(tetrahedron, faces, 1e-9)")],
    ids=["out", "in"],
)
def test_arrays_across_the_border_run_no_python(prepare: str, hand_out: str) -> None:
    words = [sys.executable, "-c", PROGRAM.format(prepare=prepare, hand_out=hand_out)]
    done = subprocess.run(words, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout) == []
