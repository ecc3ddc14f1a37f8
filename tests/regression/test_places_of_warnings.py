"""Warnings of a lift file, which had no file, line and path where errors have them.

"no sling leads to lug L3" was all that `gantline check` said; in a file of 800 lines whoever read it searched
for the lug. Places are those of errors; a recording names the file without its folder, which is that of one
machine, so that the same lift gives the same bytes wherever it lies.
"""

from __future__ import annotations

from pathlib import Path

import pytest

import gantline
from gantline.assembly import assemble
from gantline.scenario import load_scenario
from program import called

LIFT = Path(__file__).parents[2] / "scenarios" / "equalizer" / "scenario.yaml"
#: What stands in the lift, what in its place, and the path and beginning of the warning in the line of that.
DOUBTFUL = [
    (
        "weight: {calculated: 300 t",
        "weight: {calculated: 500 t",
        "load.weight",
        "the load weighs 500 t, and what",
    ),
    (
        "sling:      {axial_stiffness: 200 MN, damping_time: 2 ms",
        "sling:      {axial_stiffness: 200 MN, damping_time: 2 s",
        "ropes.sling",
        "rope sling has a damping time of 2 s: ",
    ),
    (
        "    L5: {at",
        "    L6: {at: [0 m, 1 m, 5 m]}\n    L5: {at",
        "load.lugs.L6",
        "no sling leads to lug L6",
    ),
    (
        "ground: {level: 0 m",
        "wind: {speed: 10 m/s, direction: 0 deg}\nground: {level: 0 m",
        "wind",
        "the wind of 10.0 m/s pushes nothing",
    ),
    (
        "heading: 0 deg                   # frame",
        "heading: 44 rad # frame",
        "equalizers.e1.heading",
        "44 rad are 7",
    ),
    (
        "brake_from: 25 s}",
        "brake_from: 25 s, cut: [sling.S1]}",
        "plan[1].cut",
        "sling.S1 has 'cut_at: 3 s', and",
    ),
]


def doubtful(folder: Path, *changes: tuple[str, str]) -> Path:
    """The lift with something else in place of each of its parts."""
    text = LIFT.read_text(encoding="utf-8")
    for old, new in changes:
        assert text.count(old) == 1, old
        text = text.replace(old, new)
    path = folder / "doubtful.yaml"
    path.write_text(text, encoding="utf-8")
    return path


def line_in(path: Path, words: str) -> int:
    """The line, from 1, in which words begin."""
    text = path.read_text(encoding="utf-8")
    return text[: text.index(words)].count("\n") + 1


@pytest.mark.parametrize(("old", "new", "path", "says"), DOUBTFUL, ids=[path for _, _, path, _ in DOUBTFUL])
def test_a_warning_has_the_place_that_an_error_has(
    tmp_path: Path, old: str, new: str, path: str, says: str
) -> None:
    cut = ("S1: {from: e1.1", "S1: {cut_at: 3 s, from: e1.1")
    file = doubtful(tmp_path, (old, new), *([cut] if "cut" in path else []))
    told = called("check", file)
    assert told.returncode == 0
    place = f"warning: {file}:{line_in(file, new)}: {path}: {says}"
    assert [line for line in told.stderr.splitlines() if line.startswith(place)], told.stderr


def test_a_lift_that_ends_before_its_plan(tmp_path: Path) -> None:
    """Hoisting brakes from 25 s on, and the step after holds for 20 s."""
    file = doubtful(tmp_path, ("hold: until_end", "hold: 20 s"))
    told = called("check", file).stderr
    line = line_in(file, "duration: 40 s")
    assert f"warning: {file}:{line}: duration: the plan takes 45 s at least; 40 s are simulated" in told


def test_recordings_name_the_file_without_its_folder(tmp_path: Path) -> None:
    old, new, path, says = DOUBTFUL[2]
    file = doubtful(tmp_path, (old, new))
    recording = gantline.simulate(file, duration=0.1)
    (warning,) = recording.attributes["warnings"]
    assert warning == f"doubtful.yaml:{line_in(file, new)}: {path}: {says}"


def test_sentences_alone(tmp_path: Path) -> None:
    """What asks for the sentences of a lift has them as before."""
    old, new, _, says = DOUBTFUL[2]
    assembly = assemble(load_scenario(doubtful(tmp_path, (old, new))))
    assert assembly.warnings == (says,)
