"""Packages hold what an installation needs: the player, all sources, the licences of what is compiled in."""

from __future__ import annotations

import ast
import subprocess
import sys
import tarfile
import tomllib
import zipfile
from importlib import import_module, metadata
from pathlib import Path
from typing import Any

import pytest
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

import gantline.cli.doctor as doctor

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture
def packages(monkeypatch: pytest.MonkeyPatch) -> Any:
    monkeypatch.syspath_prepend(ROOT / "tools")
    return import_module("packages")


@pytest.fixture(scope="module")
def sdist(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Made as it is for a release: a list of files, nothing is compiled."""
    folder = tmp_path_factory.mktemp("sdist")
    made = subprocess.run(
        [sys.executable, "-m", "maturin", "sdist", "--out", str(folder)],
        cwd=ROOT, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert made.returncode == 0, made.stderr
    (archive,) = folder.iterdir()
    return archive


def test_the_sdist_holds_all_that_an_installation_needs(sdist: Path, packages: Any) -> None:
    assert packages.lacking(sdist) == [], "'make setup' builds the player"
    held = packages.names(sdist)
    assert not [name for name in held if name.endswith((".so", ".pyc")) or "node_modules" in name]


def test_an_sdist_without_player_or_source_is_not_whole(
    sdist: Path, packages: Any, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    left_out = ("python/gantline/viewer/static/player.js", "crates/gantline-core/src/lib.rs")
    poorer = tmp_path / sdist.name
    with tarfile.open(sdist) as whole, tarfile.open(poorer, "w:gz") as made:
        for member in whole:
            if not member.name.endswith(left_out):
                made.addfile(member, whole.extractfile(member))
    assert packages.main([str(poorer)]) == 1
    assert capsys.readouterr().out.endswith(f"lacks {left_out[1]}, {left_out[0]}\n")


def test_a_wheel_is_looked_at_too(packages: Any, tmp_path: Path) -> None:
    wheel = tmp_path / "gantline-0.1.0-cp311-abi3-linux_x86_64.whl"
    held = packages.package_files() - {packages.PLAYER[0]}
    with zipfile.ZipFile(wheel, "w") as made:
        for name in held:
            made.writestr(name, "")
    licences = [f"gantline-0.1.0.dist-info/licenses/{name}" for name in packages.LICENCES]
    assert packages.lacking(wheel) == sorted([packages.CORE, packages.PLAYER[0], *licences])


def test_the_player_says_what_its_parts_are_licensed_under(packages: Any) -> None:
    """Reports carry it without the package, and the licences of its parts ask for their texts."""
    player = (ROOT / "python" / packages.PLAYER[0]).read_text(encoding="utf-8")
    for text in ("viewer/node_modules/three/LICENSE", "viewer/licences/earcut.txt"):
        assert (ROOT / text).read_text(encoding="utf-8").strip() in player, text
    assert "@license" in player, "what the sources say of themselves is kept"


# --- what it asks to be installed beside it -------------------------------------------------------


def imported(source: str) -> set[str]:
    """First names of all that a module imports from elsewhere, wherever in it."""
    found = set()
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Import):
            found |= {name.name.partition(".")[0] for name in node.names}
        elif isinstance(node, ast.ImportFrom) and node.level == 0:
            found.add((node.module or "").partition(".")[0])
    return found - sys.stdlib_module_names - {"gantline"}


def undeclared(names: set[str]) -> set[str]:
    """Imports whose package neither the project asks for nor `gantline doctor` names as optional."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    asked = [project["dependencies"], *project["optional-dependencies"].values()]
    declared = {canonicalize_name(Requirement(item).name) for items in asked for item in items}
    optional = {module for module, *_ in doctor._PACKAGES}
    known = metadata.packages_distributions()
    return {
        name
        for name in names - optional
        if not declared & {canonicalize_name(one) for one in known.get(name, [])}
    }


def test_the_package_asks_for_all_that_it_imports() -> None:
    """What comes along with another package may stay away with its next version."""
    modules = sorted((ROOT / "python" / "gantline").rglob("*.py"))
    names = set().union(*(imported(path.read_text(encoding="utf-8")) for path in modules))
    assert {"PIL", "markupsafe", "numpy", "pydantic_core"} <= names
    assert undeclared(names) == set()


def test_an_import_that_nothing_asks_for_is_found() -> None:
    source = "import json, numpy.linalg\nfrom . import x\ndef late():\n    from pandas.core import frame\n"
    assert imported(source) == {"numpy", "pandas"}
    assert undeclared(imported(source)) == {"pandas"}
