"""The arrows between the packages hold (ARCHITECTURE.md, layers)."""

from __future__ import annotations

import ast
import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PACKAGE = ROOT / "python" / "gantline"

# The compiled core is no Python source, so import-linter cannot see it.
USERS_OF_THE_CORE = {"gantline.simulation", "gantline.statics", "gantline.hydro"}


def lint_imports(config: Path, python_path: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [Path(sys.executable).with_name("lint-imports"), "--no-cache", "--config", config],
        cwd=config.parent, env={**os.environ, "PYTHONPATH": str(python_path), "PYTHONDONTWRITEBYTECODE": "1"},
        capture_output=True, text=True, check=False,
    )  # fmt: skip


def test_the_import_contracts_hold() -> None:
    result = lint_imports(ROOT / "pyproject.toml", ROOT / "python")
    assert result.returncode == 0, result.stdout + result.stderr
    assert "4 kept, 0 broken" in result.stdout


def test_an_arrow_that_points_backwards_is_found(tmp_path: Path) -> None:
    layers = ["cli", "simulation", "overrides", "assembly", "scenario", "rope_data", "rule_data", "units"]
    layers += ["cad", "checks", "export", "plot", "report", "results", "statics", "study", "viewer"]
    for module in layers:
        (tmp_path / "gantline").mkdir(exist_ok=True)
        (tmp_path / "gantline" / f"{module}.py").write_text("")
    (tmp_path / "gantline" / "__init__.py").write_text("")
    (tmp_path / "gantline" / "results.py").write_text("def late() -> None:\n    import gantline.assembly\n")
    (tmp_path / "gantline" / "units.py").write_text("import gantline.scenario\n")
    config = tmp_path / "pyproject.toml"
    config.write_bytes((ROOT / "pyproject.toml").read_bytes())
    result = lint_imports(config, tmp_path)
    assert result.returncode != 0
    assert "2 kept, 2 broken" in result.stdout, result.stdout + result.stderr


Import = ast.Import | ast.ImportFrom


def imports_of(path: Path) -> list[Import]:
    """All imports of a module, inside functions too."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    return [node for node in ast.walk(tree) if isinstance(node, (ast.Import, ast.ImportFrom))]


def names_of(imports: list[Import]) -> set[str]:
    """Dotted names of all that absolute imports bring."""
    names: set[str] = set()
    for node in imports:
        if isinstance(node, ast.Import):
            names.update(alias.name for alias in node.names)
        elif node.level == 0 and node.module:
            names.add(node.module)
            names.update(f"{node.module}.{alias.name}" for alias in node.names)
    return names


@pytest.fixture(scope="module")
def imports() -> dict[Path, list[Import]]:
    """Imports of all modules of the package."""
    return {path: imports_of(path) for path in PACKAGE.rglob("*.py")}


def test_only_the_simulation_uses_the_compiled_core(imports: dict[Path, list[Import]]) -> None:
    users = set()
    for path, of_module in imports.items():
        if any(name.split(".")[:2] == ["gantline", "_core"] for name in names_of(of_module)):
            users.add(".".join(path.relative_to(ROOT / "python").with_suffix("").parts))
    assert users and {".".join(user.split(".")[:2]) for user in users} <= USERS_OF_THE_CORE


def test_imports_are_absolute(imports: dict[Path, list[Import]]) -> None:
    """Relative imports would hide a module from the reader of a contract."""
    relative = [
        str(path.relative_to(ROOT))
        for path, of_module in imports.items()
        for node in of_module
        if isinstance(node, ast.ImportFrom) and node.level > 0
    ]
    assert relative == []


@pytest.mark.parametrize(
    "source", ["import gantline._core", "from gantline import _core", "from gantline._core import X"]
)
def test_a_use_of_the_core_is_found(source: str, tmp_path: Path) -> None:
    path = tmp_path / "module.py"
    path.write_text(source)
    assert "gantline._core" in names_of(imports_of(path))
