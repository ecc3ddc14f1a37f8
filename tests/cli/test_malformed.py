"""Lift files that are wrong: a clear message with its line, exit code 2, nothing written, no traceback."""

from __future__ import annotations

from pathlib import Path

import pytest
import yaml
from typer.testing import CliRunner

from boom_lift import TACKLES, boom_lift
from crawler_lift import crawler_lift
from gantline.cli.app import app
from gantline.scenario import ScenarioError, load_scenario
from gantline.scenario.file.tree import LARGEST_FILE
from lift_text import AFLOAT, BASE, MECHANICS, MOORED, spoiled
from luffing_along import by_a_boom, luffed_along
from upending import between_trolleys, by_crawlers, upended

LUFF = "{step: luff out, luff: fc, speed: 20 deg/min, to: 50 deg}"
TAIL = """\
{step: upend, hoist: main.H, speed: 2 m/min, by: 10 m}
{step: follow, travel: tail, starts: with_previous, speed: 1 km/h, keep_plumb: tail.H}"""
SLEW = "{step: slew, slew: c1, speed: 0.2 rev/min, by: 30 deg}"
BASES = {
    "yard": BASE,
    "lossy": BASE.replace("pitch_diameter: 0.8 m, mass", "pitch_diameter: 0.8 m, bearing: roller, mass"),
    "unguided": BASE.replace("mass: 200 kg}", "mass: 200 kg, guided: none}"),
    "tilting": BASE.replace("hinge: {damping: 1 kN m s}", "hinge: {tilts: true, tilt_friction: 50 kN m}"),
    "mechanics": MECHANICS,
    "afloat": AFLOAT,
    "moored": MOORED,
    "boom": boom_lift(LUFF, duration=60.0),
    "tackles": boom_lift(LUFF, duration=60.0, luffing=TACKLES),
    "crawler": crawler_lift(150e3, SLEW, duration=60.0),
    "upending": between_trolleys(upended(), duration=60.0),
    "luffing": by_a_boom(luffed_along(17.0), inwards=True, angle=60.0, duration=60.0),
    "tail": by_crawlers(TAIL, duration=60.0),
}
CASES = yaml.load(Path(__file__).with_name("malformed.yaml").read_bytes(), yaml.CSafeLoader)
UTF_16 = ": looks like UTF-16, two bytes for each letter; save the file as UTF-8"
NEEDED = "a lift file or its folder is needed"


def refused(path: Path, *arguments: str) -> str:
    """What `gantline` says of a file that it has to refuse; fails if it writes or crashes."""
    before = sorted(path.parent.rglob("*"))
    result = CliRunner().invoke(app, [*arguments, str(path)])
    assert isinstance(result.exception, SystemExit), f"not a message but {result.exception!r}"
    assert result.exit_code == 2
    assert result.stdout == ""
    assert "Traceback" not in result.stderr
    assert sorted(path.parent.rglob("*")) == before
    assert result.stderr.startswith("error: ")
    return result.stderr.removeprefix("error: ").rstrip("\n")


def test_the_lifts_that_are_spoiled_are_right_before(tmp_path: Path) -> None:
    for name, text in BASES.items():
        path = tmp_path / f"{name}.yaml"
        path.write_text(text, encoding="utf-8")
        result = CliRunner().invoke(app, ["check", str(path)])
        assert result.exit_code == 0, result.stderr


@pytest.mark.parametrize("case", CASES, ids=lambda case: case["name"].replace(" ", "_"))
def test_a_spoiled_lift_is_refused_with_its_line(case: dict[str, str], tmp_path: Path) -> None:
    path = tmp_path / "lift.yaml"
    path.write_text(spoiled(case["old"], case["new"], BASES[case["base"]]), encoding="utf-8", newline="")
    expected = "\n".join(f"{path}:{line}" for line in case["says"].splitlines())
    assert refused(path, "check") == expected


def test_running_a_spoiled_lift_writes_nothing(tmp_path: Path) -> None:
    path = tmp_path / "lift.yaml"
    path.write_text(spoiled("calculated: 60 t", "calculated: 60"), encoding="utf-8")
    assert "'60' has no unit" in refused(path, "run", "--output", str(tmp_path / "out"))


def test_every_problem_is_named_in_the_order_of_the_file(tmp_path: Path) -> None:
    path = tmp_path / "lift.yaml"
    text = spoiled("duration: 20 s", "duration: 20").replace("capacity: 40 t", "capacity: 40 kN")
    path.write_text(text, encoding="utf-8")
    message = refused(path, "check")
    lines = [int(line.removeprefix(f"{path}:").split(":")[0]) for line in message.splitlines()]
    assert lines == [4, 20, 21, 22]


def test_of_many_problems_twenty_are_named(tmp_path: Path) -> None:
    path = tmp_path / "lift.yaml"
    lugs = "".join(f"    M{place}: {{at: [0 m, 0 m]}}\n" for place in range(27))
    path.write_text(spoiled("cranes:\n", lugs + "cranes:\n"), encoding="utf-8")
    message = refused(path, "check").splitlines()
    assert len(message) == 21
    assert message[-1] == f"{path}: and 7 more"


@pytest.mark.parametrize(
    ("content", "says"),
    [
        (b"", ": is empty; a lift file begins with 'format: 1'"),
        (b"# nothing but a comment\n", ": is empty; a lift file begins with 'format: 1'"),
        (
            b"hoist it\n",
            ":1: found the text 'hoist it'; a lift file is a mapping that begins with 'format: 1'",
        ),
        (b"- a\n- b\n", ":1: found a list; a lift file is a mapping that begins with 'format: 1'"),
        (
            b"format: 1\ntitle: Gr\xfc\xdfe\n",
            ":2: byte 20 is not UTF-8 text; it looks like Windows-1252, 'ü' in 'Grüße'; "
            "save the file as UTF-8",
        ),
        (b"format: 1\ntitle: \x81\n", ":2: byte 18 is not UTF-8 text; save the file as UTF-8"),
        ("format: 1\n".encode("utf-16-le"), UTF_16),
        (BASE.encode("utf-16"), UTF_16),
        (b"\x7fELF\x02\x01\x01\x00", ":1: a character that YAML does not allow; save the file as plain text"),
        (b"a: " + b"[" * 100_000, ":1: nested more than 32 deep; a lift file needs far less"),
        (b"a:\n" + b"".join(b" " * n + b"- \n" for n in range(40)), None),
        (b"&a [*a, *a]\n", None),
        (b"%YAML 3.0\n---\na: 1\n", None),
        (b"\xef\xbb\xbfformat: 2\n", None),
    ],
    ids=[
        "empty",
        "comment",
        "text",
        "list",
        "latin-1",
        "no-letter",
        "utf-16-no-mark",
        "utf-16",
        "binary",
        "deep",
        "blocks",
        "self",
        "yaml3",
        "bom",
    ],
)
def test_files_that_are_no_lift_files(content: bytes, says: str | None, tmp_path: Path) -> None:
    path = tmp_path / "lift.yaml"
    path.write_bytes(content)
    message = refused(path, "check")
    assert message.startswith(str(path))
    if says is not None:
        assert message == f"{path}{says}"


def test_an_alias_bomb_is_refused_at_its_first_anchor(tmp_path: Path) -> None:
    path = tmp_path / "bomb.yaml"
    rows = ["a0: &a0 [x, x, x, x, x, x, x, x, x]"]
    rows += [f"a{n}: &a{n} [{', '.join([f'*a{n - 1}'] * 9)}]" for n in range(1, 12)]
    path.write_text("\n".join(rows), encoding="utf-8")
    assert refused(path, "check").startswith(
        f"{path}:1: the anchor '&a0' is not allowed; write the value out"
    )


def test_a_file_of_100_mb_is_not_read(tmp_path: Path) -> None:
    path = tmp_path / "big.yaml"
    with path.open("wb") as file:
        file.truncate(100_000_000)
    assert refused(path, "check") == f"{path}: has 100.0 MB; a lift file has at most 5 MB"


def test_the_largest_file_is_still_looked_at(tmp_path: Path) -> None:
    path = tmp_path / "large.yaml"
    path.write_bytes(b"x" * LARGEST_FILE)
    with pytest.raises(ScenarioError, match="found the text 'xxx"):
        load_scenario(path)


def test_folders_and_missing_files(tmp_path: Path) -> None:
    missing = tmp_path / "nothing.yaml"
    assert refused(missing, "check") == f"{missing}: cannot be read (no such file or directory); {NEEDED}"
    folder = tmp_path / "lift"
    folder.mkdir()
    assert refused(folder, "check") == f"{folder}: is a folder without scenario.yaml; {NEEDED}"
    (folder / "scenario.yaml").mkdir()
    assert refused(folder, "check") == f"{folder}: is a folder without scenario.yaml; {NEEDED}"
    (folder / "scenario.yaml").rmdir()
    (folder / "scenario.yaml").write_text("format: 1\n", encoding="utf-8")
    assert refused(folder, "check").startswith(f"{folder / 'scenario.yaml'}:1: 'lift' is missing")


@pytest.mark.parametrize("name", ["a\0b", "x" * 5000])
def test_names_that_no_file_can_have(name: str) -> None:
    with pytest.raises(ScenarioError, match="cannot be read"):
        load_scenario(name)


def test_a_device_is_not_read() -> None:
    with pytest.raises(ScenarioError, match="is not a file"):
        load_scenario("/dev/zero")
