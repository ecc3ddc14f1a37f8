"""What `gantline check` says of supports under a load from CAD."""

from __future__ import annotations

from pathlib import Path

import pytest

from cad_loads import cad_lift, prism
from hull_lift import lift, text
from program import called

GRID = {"x": ["-6 m", "6 m"], "y": ["-2 m", "2 m"]}
#: The underside rises by 30° from y = -1 m on: 27° and more is at the rim that is low.
CHINE = prism([(-3.0, 0.0), (-1.0, 0.0), (3.0, 4.0 / 3**0.5), (3.0, 4.0), (-3.0, 4.0)], 16.0)


def test_heights_are_listed_as_a_yard_cuts_them(tmp_path: Path) -> None:
    """At y = 2 − 0.3 m the underside is 2.7 m tan 30° = 1.5588 m above its lowest."""
    path = tmp_path / "scenario.yaml"
    path.write_text(text(cad_lift(tmp_path, CHINE, {"grid": GRID, "height": "to_load"})))
    done = called("check", path)
    assert done.returncode == 0
    rows = [line.split() for line in done.stdout.splitlines() if line.startswith("  keel_blocks.")]
    assert [row[5:] for row in rows] == [
        ["1.500", "m", "0", "mm", "0.0", "deg"],
        ["3.059", "m", "0", "mm", "30.0", "deg"],
    ] * 2
    assert (
        "rises by more than friction holds over 'keel_blocks.1.2' 30°, 'keel_blocks.2.2' 30°" in done.stderr
    )


def test_nothing_is_listed_under_a_level_load_that_touches_all(tmp_path: Path) -> None:
    path = tmp_path / "scenario.yaml"
    path.write_text(text(lift()))
    done = called("check", path)
    assert done.returncode == 0 and "below the load" not in done.stdout


def test_a_box_tells_how_far_a_low_support_is_below_it(tmp_path: Path) -> None:
    """20 mm below, where all yield by 2 mm."""
    given = lift()
    given["supports"] = {
        "keel_blocks": {**given["supports"]["keel_blocks"], "each": {"2.3": {"height": "1.48 m"}}}
    }
    path = tmp_path / "scenario.yaml"
    path.write_text(text(given))
    done = called("check", path)
    assert "1 of 16 supports of keel_blocks bear nothing as the load stands at the start" in done.stderr
    assert "lower than its underside over them are 'keel_blocks.2.3' 20 mm; 'height: to_load'" in done.stderr
    assert [line for line in done.stdout.splitlines() if "keel_blocks.2.3" in line and "20 mm" in line]


@pytest.mark.parametrize(
    ("height", "position", "message"),
    [
        ("to load", "1.5 m", "or 'to_load'"),
        (
            "to_load",
            "-0.5 m",
            "the load is 0.5 m below the foot of 'keel_blocks.1.1', whose height is up to it",
        ),
    ],
)
def test_heights_that_cannot_be(tmp_path: Path, height: str, position: str, message: str) -> None:
    given = cad_lift(tmp_path, CHINE, {"grid": GRID, "height": height}, position=["0 m", "0 m", position])
    path = tmp_path / "scenario.yaml"
    path.write_text(text(given))
    done = called("check", path)
    assert done.returncode == 2 and message in done.stderr and "keel_blocks" in done.stderr
