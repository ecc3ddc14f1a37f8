"""The command line without a simulation: help, version, schema, new, and what it loads."""

import json
import os
import shlex
import subprocess
import sys
from pathlib import Path

import pytest
from typer.testing import CliRunner

import gantline
from gantline.cli.app import app
from gantline.scenario import shipped
from program import program

HEAVY = (
    "numpy",
    "scipy",
    "h5py",
    "h5netcdf",
    "xarray",
    "pandas",
    "matplotlib",
    "pydantic",
    "ruamel",
    "rich",
    "gantline._core",
    "gantline.scenario",
    "gantline.simulation",
    "gantline.results",
)


def gantline_says(*words: str, columns: int = 100) -> tuple[int, str, str]:
    result = CliRunner().invoke(app, words, env={"COLUMNS": str(columns)})
    return result.exit_code, result.stdout, result.stderr


#: Each takes half a second or more, and neither a lift as it is read nor one ashore at rest needs them.
SLOW = ("scipy", "matplotlib", "xarray", "pandas")


@pytest.mark.parametrize(
    ("words", "needless"),
    [
        (["--help"], HEAVY),
        (["--version"], HEAVY),
        (["check", "equalizer"], SLOW),
        (["check", "floating_crane"], SLOW),
        (["statics", "equalizer"], SLOW),
        (["check", "crane_barge_in_swell"], ("matplotlib", "xarray", "pandas")),
    ],
)
def test_a_command_loads_only_what_it_needs(words: list[str], needless: tuple[str, ...]) -> None:
    code = f"""
import sys
sys.argv = ["gantline", *{words!r}]
from gantline.cli import main
try:
    main()
except SystemExit as end:
    assert not end.code, end.code
loaded = [name for name in {needless!r} if name in sys.modules]
sys.exit(", ".join(loaded) or 0)
"""
    result = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert (result.returncode, result.stderr) == (0, "")
    assert result.stdout


def test_every_verb_is_in_the_help() -> None:
    code, out, _ = gantline_says("--help")
    assert code == 0
    for verb in ("run", "compare", "check", "new", "schema"):
        assert f"\n  {verb} " in out
    assert "3 the simulation could" in out


def test_no_line_of_the_help_is_cut_short() -> None:
    _, out, _ = gantline_says("--help")
    lines = out.split("Commands:\n")[1].split("\n\n")[0].splitlines()
    assert len(lines) == 15
    for line in lines:
        assert line.endswith(".") and not line.endswith("..."), line


def completed(*words: str, folder: Path) -> list[str]:
    """What bash is offered for the last of these words."""
    asked = {
        "_GANTLINE_COMPLETE": "complete_bash",
        "COMP_WORDS": " ".join(["gantline", *words]),
        "COMP_CWORD": str(len(words)),
    }
    command = [sys.executable, "-c", "from gantline.cli import main; main()"]
    result = subprocess.run(
        command, capture_output=True, text=True, check=False, cwd=folder, env=os.environ | asked
    )
    assert result.stderr == ""
    return result.stdout.split()


def test_a_shell_completes_verbs_lifts_and_files(tmp_path: Path) -> None:
    (tmp_path / "equal.yaml").touch()
    (tmp_path / "equations").mkdir()
    (tmp_path / "equal.txt").touch()
    assert completed("sta", folder=tmp_path) == ["statics"]
    offered = completed("run", "equal", folder=tmp_path)
    assert offered == [name for name in shipped() if name.startswith("equal")] + ["equal.yaml"]
    assert completed("check", "equat", folder=tmp_path) == ["equations/"]


@pytest.mark.parametrize(
    "module", ["gantline.cli.app", "typer", "gantline.cli.statics", "gantline.simulation", "numpy"]
)
def test_ctrl_c_while_the_program_loads_ends_it_quietly(module: str) -> None:
    """The process sends itself the signal when it begins to load a module: of the program, or of a verb."""
    code = f"""
import os, signal, sys

class CtrlC:
    def find_spec(self, name, path=None, target=None):
        if name == {module!r}:
            os.kill(os.getpid(), signal.SIGINT)

signal.signal(signal.SIGINT, signal.default_int_handler)  # jobs in the background begin without
sys.meta_path.insert(0, CtrlC())
sys.argv = ["gantline", "check", "equalizer"]
from gantline.cli import main
main()
"""
    result = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert result.returncode == 130
    assert "Traceback" not in result.stderr and not result.stdout


def test_version_is_that_of_the_package() -> None:
    assert gantline_says("--version") == (0, f"gantline {gantline.__version__}\n", "")


def test_the_module_is_the_command() -> None:
    result = program("--version")
    assert (result.returncode, result.stdout) == (0, f"gantline {gantline.__version__}\n")


@pytest.mark.parametrize("words", [[], ["lift"], ["run"], ["run", "lift.yaml", "--speed", "2"]])
def test_a_wrong_command_is_bad_input(words: list[str]) -> None:
    code, _, err = gantline_says(*words)
    assert code == 2
    assert "Traceback" not in err


def test_schema_is_json_and_can_be_written(tmp_path: Path) -> None:
    code, out, _ = gantline_says("schema")
    assert code == 0
    assert "properties" in json.loads(out)
    path = tmp_path / "lift.schema.json"
    assert gantline_says("schema", "-o", str(path))[0] == 0
    assert json.loads(path.read_text()) == json.loads(out)


def test_schema_into_a_missing_folder(tmp_path: Path) -> None:
    code, _, err = gantline_says("schema", "-o", str(tmp_path / "none" / "lift.schema.json"))
    assert code == 2
    assert "cannot be written (no such file or directory)" in err


def test_a_new_lift_is_in_order(tmp_path: Path) -> None:
    folder = tmp_path / "my lift"
    code, out, _ = gantline_says("new", str(folder))
    assert code == 0
    assert sorted(path.name for path in folder.iterdir()) == ["lift.schema.json", "scenario.yaml"]
    assert shlex.split(out.splitlines()[-1]) == ["Next:", "gantline", "run", str(folder)]  # fit for a shell
    code, out, err = gantline_says("check", str(folder))
    assert (code, err) == (0, "")
    assert "in order" in out


def test_check_lists_what_follows_from_the_construction_of_a_rope(tmp_path: Path) -> None:
    assert gantline_says("new", str(tmp_path / "lift"))[0] == 0
    out = gantline_says("check", str(tmp_path / "lift"))[1]
    # 0.460 d² 100 kN/mm², 0.409 d²/100 kg/m, 0.356 d² 1960 N with d = 44 mm
    assert "sling_44 6x36 IWRC 89.06 MN 7.92 kg/m 1351 kN" in " ".join(out.split())


def test_check_lists_how_the_weight_of_each_rope_acts(tmp_path: Path) -> None:
    lift = tmp_path / "lift.yaml"
    lift.write_text(
        """\
format: 1
lift: {title: Two ropes}
duration: 1 s
ropes: {rope: {axial_stiffness: 100 MN, mass: 16 kg/m}}
mechanics:
  bodies:
    box: {at: [0 m, 0 m, -20 m], joint: {type: point}, mass: 1 t}
  ropes:
    one: {rope: rope, length: 20 m, route: [{type: end, body: world}, {type: end, body: box}]}
    two:
      rope: rope
      length: 21 m
      rope_weight: distributed
      rope_nodes: 9
      route: [{type: end, body: box}, {type: end, body: world}]
"""
    )
    out = " ".join(gantline_says("check", str(lift))[1].split())
    assert (
        "Rope weight mass on the world one lumped 320.0 kg 160.0 kg two distributed 336.0 kg 14.7 kg" in out
    )
    assert "(1 body, 2 ropes, 9 nodes of ropes; 1 s to simulate)" in out


def test_check_lists_an_inextensible_rope() -> None:
    assert "inextensible 0.00 kg/m -" in " ".join(gantline_says("check", "pulleys")[1].split())


@pytest.mark.parametrize("name", sorted(shipped()))
def test_a_new_lift_from_one_that_comes_with_gantline(name: str, tmp_path: Path) -> None:
    folder = tmp_path / "mine"
    assert gantline_says("new", str(folder), "--from", name)[0] == 0
    assert "$schema=lift.schema.json" in (folder / "scenario.yaml").read_text().splitlines()[0]
    assert gantline_says("check", str(folder))[0] == 0


@pytest.mark.parametrize(
    ("name", "file"), [("goliath", "block.3docx"), ("crane_barge_in_swell", "crane_barge.nc")]
)
def test_a_new_lift_has_the_files_that_it_names(name: str, file: str, tmp_path: Path) -> None:
    code, out, _ = gantline_says("new", str(tmp_path / "mine"), "--from", name)
    assert code == 0, out
    beside = sorted(path.name for path in (tmp_path / "mine").iterdir())
    assert beside == [file, "lift.schema.json", "scenario.yaml"]
    code, _, err = gantline_says("check", str(tmp_path / "mine"))
    assert code == 0, err


def test_the_help_of_new_names_every_lift_that_comes_with_gantline(tmp_path: Path) -> None:
    """It said `equalizer, ...`; the names are those of the files, and shells complete them."""
    code, out, _ = gantline_says("new", "--help")
    assert code == 0
    named = out.split("Lifts that come with gantline:\n")[1].split("\n\n")[0]
    assert " ".join(named.split()) == ", ".join(shipped())
    assert out.rstrip().splitlines()[-1].strip() == "a folder with a lift file to change"
    assert completed("new", "mine", "--from", "eq", folder=tmp_path) == [
        name for name in shipped() if name.startswith("eq")
    ]


def test_a_new_lift_from_an_unknown_name(tmp_path: Path) -> None:
    code, _, err = gantline_says("new", str(tmp_path / "mine"), "--from", "derrick")
    assert code == 2
    assert f"there are {', '.join(shipped())}" in err
    assert list(tmp_path.iterdir()) == []


def test_a_lift_that_comes_with_gantline_is_known_by_name(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert gantline_says("check", "equalizer")[0] == 0
    (tmp_path / "equalizer").write_text("format: 2")  # a file of that name goes first
    assert gantline_says("check", "equalizer")[0] == 2


def test_verbs_of_cad_have_lines_that_are_not_cut_short() -> None:
    code, out, _ = gantline_says("cad", "--help")
    assert code == 0 and not any(line.endswith("...") for line in out.splitlines()[1:])


def test_new_never_overwrites(tmp_path: Path) -> None:
    (tmp_path / "scenario.yaml").write_text("mine")
    code, _, err = gantline_says("new", str(tmp_path))
    assert code == 2
    assert "exists already; nothing was written" in err
    assert [path.name for path in tmp_path.iterdir()] == ["scenario.yaml"]
    assert (tmp_path / "scenario.yaml").read_text() == "mine"
    code, _, err = gantline_says("new", str(tmp_path / "scenario.yaml"))
    assert code == 2
    assert "is a file" in err


def test_check_names_what_is_wrong(tmp_path: Path) -> None:
    lift = tmp_path / "lift.yaml"
    lift.write_text("format: 1\nlift: {titel: wrong}\n")
    code, out, err = gantline_says("check", str(lift))
    assert (code, out) == (2, "")
    assert "lift.yaml:2" in err
    assert "title" in err
    assert "Traceback" not in err


def test_check_lists_sheaves_with_losses_and_drums(tmp_path: Path) -> None:
    lift = tmp_path / "lift.yaml"
    lift.write_text(
        """\
format: 1
lift: {title: A winch}
duration: 1 s
ropes: {rope: {axial_stiffness: 100 MN}}
mechanics:
  bodies:
    head: {joint: {type: fixed}}
    box: {at: [-1 m, 0 m, -20 m], joint: {type: slider, axis: [0, 0, 1]}, mass: 1 t}
  drums:
    winch: {diameter: 1 m, moment_of_inertia: 250 kg m^2, brake: 20 kN}
  ropes:
    fall:
      rope: rope
      length: as_routed
      route:
        - {type: end, body: box}
        - {type: half_turn, body: head, enter: [-1 m, 0 m, 0 m], leave: [1 m, 0 m, 0 m], bulge: [0, 0, 1],
           bearing: roller, sheave_mass: 150 kg}
        - {type: end, body: world, at: [1 m, 0 m, -20 m], drum: winch}
"""
    )
    out = " ".join(gantline_says("check", str(lift), columns=140)[1].split())
    # 1/0.98, and half of the mass of a disc
    assert "fall/sheave_1 fall 1.0204 75.0 kg half of its mass" in out
    assert "groove friction" not in out, "none has any"
    assert "(2 bodies, 1 rope, 1 drum; 1 s to simulate)" in out
    code, out, err = gantline_says("run", str(lift), "-o", str(tmp_path / "out"), "--integrator", "explicit")
    assert code == 2
    assert "the integrator explicit knows no friction of sheaves, drums and joints" in err


def test_sheaves_that_are_alike_have_one_row() -> None:
    """Falls of the Goliath crane have 2 x 8, 2 x 8 and 2 x 12 sheaves; its equalizers 3 x 9."""
    lines = [line.split() for line in gantline_says("check", "goliath", columns=160)[1].splitlines()]
    rows = [line for line in lines if "sheaves" in line]
    assert [int(row[row.index("sheaves") - 1]) for row in rows] == [8, 8, 8, 8, 12, 12, 9, 9, 9]
    assert rows[0][:3] == ["hoist.goliath.U1.1/sheave_1", "to", "sheave_8,"]
