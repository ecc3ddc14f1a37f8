"""`gantline doctor`, and what is common to the help of all verbs."""

from __future__ import annotations

import json
import os
import re
import shlex
import shutil
from importlib import import_module
from pathlib import Path

import pytest
import typer
from typer.testing import CliRunner, Result

import gantline.cli.doctor as module
from gantline.cli.app import app
from gantline.cli.examples import EXAMPLES
from gantline.viewer.chromium import NAMES


def says(*words: object) -> Result:
    return CliRunner().invoke(app, [str(word) for word in words], env={"COLUMNS": "100"})


@pytest.fixture
def whole(monkeypatch: pytest.MonkeyPatch) -> None:
    """A core and a player that are in order, whether they are here or not."""
    monkeypatch.setattr(module, "_core", lambda: module.Finding("core", "ok", "x", ""))
    monkeypatch.setattr(module, "_player", lambda: module.Finding("player", "ok", "x", ""))


@pytest.mark.usefixtures("whole")
def test_parts_that_are_optional_are_no_fault(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "find_spec", lambda name: None)
    monkeypatch.setattr(shutil, "which", lambda name: None)
    result = says("doctor")
    assert result.exit_code == 0, result.output
    assert re.search(r"pyarrow +- +recordings as Parquet tables \(pip install pyarrow\)", result.stdout)
    assert result.stdout.endswith("In order.\n")


@pytest.mark.usefixtures("whole")
def test_as_json() -> None:
    result = says("doctor", "--json")
    document = json.loads(result.stdout)
    assert (result.exit_code, document["sound"]) == (0, True)
    states = {one["part"]: one["state"] for one in document["parts"]}
    assert (states["Python"], states["gantline"]) == ("ok", "ok")
    assert {"core", "player", "pyarrow", "xarray", "ffmpeg", "chromium"} <= set(states)
    assert set(states.values()) <= {"ok", "absent", "wrong"}


def browser_found(monkeypatch: pytest.MonkeyPatch, named: str | None, here: str) -> module.Finding:
    """What doctor says of a browser where the one program that can be found is `here`."""
    monkeypatch.delenv("GANTLINE_CHROMIUM", raising=False)
    if named is not None:
        monkeypatch.setenv("GANTLINE_CHROMIUM", named)
    places = {here: f"/bin/{here}", f"/bin/{here}": f"/bin/{here}", "/opt/my-chrome": "/opt/my-chrome"}
    monkeypatch.setattr(shutil, "which", places.get)
    return next(one for one in module.findings() if one.part == "chromium")


@pytest.mark.usefixtures("whole")
@pytest.mark.parametrize("name", NAMES)
def test_a_browser_of_any_name_is_found(monkeypatch: pytest.MonkeyPatch, name: str) -> None:
    found = browser_found(monkeypatch, None, name)
    assert (found.state, found.version) == ("ok", f"/bin/{name}")


@pytest.mark.usefixtures("whole")
def test_the_browser_is_the_one_that_the_variable_names(monkeypatch: pytest.MonkeyPatch) -> None:
    found = browser_found(monkeypatch, "/opt/my-chrome", "chromium")
    assert (found.state, found.version) == ("ok", "/opt/my-chrome")
    found = browser_found(monkeypatch, "/opt/no-chrome", "chromium")
    assert found.state == "absent"
    assert found.gives.endswith("(GANTLINE_CHROMIUM names '/opt/no-chrome', which is no program here)")


def test_a_missing_player_is_wrong(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(import_module("gantline.viewer.bundle"), "files", lambda name: tmp_path)
    result = says("doctor", "--json")
    assert result.exit_code == 1
    player = next(one for one in json.loads(result.stdout)["parts"] if one["part"] == "player")
    assert player["state"] == "wrong" and "'make setup' in the source folder builds it" in player["gives"]


def test_a_core_older_than_its_sources_is_wrong(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    from gantline import _core

    source = tmp_path / "crates" / "core" / "lib.rs"
    source.parent.mkdir(parents=True)
    source.write_text("")
    monkeypatch.setattr(module, "__file__", str(tmp_path / "python" / "gantline" / "cli" / "doctor.py"))
    built = Path(str(_core.__file__)).stat().st_mtime
    os.utime(source, (built - 10, built - 10))
    assert module._core().state == "ok"
    os.utime(source, (built + 10, built + 10))
    found = module._core()
    assert found.state == "wrong"
    assert found.gives.startswith("is older than 1 of its sources, such as crates/core/lib.rs")


def verbs() -> list[str]:
    group = typer.main.get_command(app)
    plain = [name for name in group.commands if name != "cad"]  # type: ignore[attr-defined]
    return [*plain, "cad file", "cad block"]


@pytest.mark.parametrize("verb", verbs())
def test_the_help_of_a_verb_ends_with_examples(verb: str) -> None:
    result = says(*verb.split(), "--help")
    assert result.exit_code == 0
    text = result.stdout.split("Examples:")[1]
    for line, what in EXAMPLES[verb]:
        assert f"\n    {line}\n        {what}" in text


@pytest.mark.parametrize("line", [line for lines in EXAMPLES.values() for line, _ in lines])
def test_examples_use_options_that_there_are(line: str) -> None:
    words = shlex.split(line.split(">")[0])
    assert words[0] == "gantline"
    group = typer.main.get_command(app)
    command = group.commands[words[1]]  # type: ignore[attr-defined]
    if hasattr(command, "commands"):
        command = command.commands[words[2]]
    known = {name for parameter in command.params for name in (*parameter.opts, *parameter.secondary_opts)}
    assert {word for word in words[2:] if word.startswith("-")} <= known


def test_nothing_is_coloured_in_a_pipe(tmp_path: Path) -> None:
    for result in (says("run", tmp_path / "none.yaml"), says("doctor"), says("check", "equalizer")):
        assert "\x1b" not in result.output
