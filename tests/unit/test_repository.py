"""The repository holds what its documents promise: paths, sizes, locks, versions, licences."""

from __future__ import annotations

import json
import re
import subprocess
import tomllib
from importlib import metadata
from pathlib import Path
from typing import Any

import pytest
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

ROOT = Path(__file__).resolve().parents[2]
SKIPPED_FOLDERS = {"target", "build", "node_modules", "static", "__pycache__"}
SOURCE_SUFFIXES = {".rs", ".py", ".pyi", ".ts", ".js", ".sh"}
HARD_LIMIT = 600  # lines of one source file, and of the whole border
DOCUMENTS = [
    "README.md",
    "ARCHITECTURE.md",
    "CONVENTIONS.md",
    "CONTRIBUTING.md",
    "CHANGELOG.md",
    "CHANGES_ON_MAIN.md",
]

# Where paths of this repository start when a document names one.
PATH_ROOTS = (
    "crates",
    "python",
    "tests",
    "docs",
    "scenarios",
    "schema",
    "tools",
    "requirements",
    "benchmarks",
    ".ci",
)
FILE_NAME = re.compile(r"[\w.-]+\.(md|toml|lock|txt|rs|py|sh|yaml|json)|Makefile|LICENSE")


def repository_files(root: Path = ROOT) -> list[Path]:
    """All files that belong to the repository, without what tools and builds leave behind."""
    return sorted(
        path
        for path in root.rglob("*")
        if path.is_file()
        and not SKIPPED_FOLDERS.intersection(path.relative_to(root).parts)
        and (not path.relative_to(root).parts[0].startswith(".") or path.relative_to(root).parts[0] == ".ci")
    )


def source_files() -> list[Path]:
    return [path for path in repository_files() if path.suffix in SOURCE_SUFFIXES]


def toml(path: str) -> dict[str, Any]:
    return tomllib.loads((ROOT / path).read_text(encoding="utf-8"))


# --- paths that documents name ------------------------------------------------------------------


def named_paths(text: str, *, all_slashes: bool) -> set[str]:
    """Paths in backticks; with `all_slashes` all that has a slash or looks like a file."""
    found = set()
    for span in re.findall(r"`([^`\n]+)`", text):
        if not re.fullmatch(r"[\w.*/-]+", span):
            continue
        starts_here = span.split("/")[0] in PATH_ROOTS and "/" in span
        if starts_here or (all_slashes and ("/" in span or FILE_NAME.fullmatch(span))):
            found.add(span)
    return found


def exists(path: str) -> bool:
    """A file, or a folder with a file in it: git keeps no empty folders."""
    found = ROOT.glob(path.rstrip("/"))
    return any(place.is_file() or any(inside.is_file() for inside in place.rglob("*")) for place in found)


def missing_paths(paths: set[str]) -> list[str]:
    return sorted(path for path in paths if not exists(path))


def test_every_path_that_the_architecture_names_exists() -> None:
    paths = named_paths((ROOT / "ARCHITECTURE.md").read_text(encoding="utf-8"), all_slashes=True)
    assert len(paths) > 20, "the architecture names the places of the code"
    assert missing_paths(paths) == []


@pytest.mark.parametrize("document", [*DOCUMENTS, "docs/**/*.md", "scenarios/*/README.md", "benchmarks/*.md"])
def test_every_path_that_other_documents_name_exists(document: str) -> None:
    found = list(ROOT.glob(document))
    assert found
    for path in found:
        assert missing_paths(named_paths(path.read_text(encoding="utf-8"), all_slashes=False)) == [], path


def test_a_path_that_is_missing_is_found() -> None:
    text = (
        "see `crates/gantline-core/src/no_such_part.rs`, `nowhere/at/all` and `NOTHING.md`; `a + b` is none"
    )
    paths = named_paths(text, all_slashes=True)
    assert missing_paths(paths) == [
        "NOTHING.md",
        "crates/gantline-core/src/no_such_part.rs",
        "nowhere/at/all",
    ]


def test_links_between_documents_lead_somewhere() -> None:
    dead = []
    for path in repository_files():
        if path.suffix != ".md":
            continue
        text = path.read_text(encoding="utf-8")
        targets = re.findall(r"\]\(([^)#\s]+)(?:#[^)]*)?\)", text) + re.findall(r'<img src="([^"]+)"', text)
        for target in targets:
            if "://" not in target and not (path.parent / target).exists():
                dead.append(f"{path.relative_to(ROOT)}: {target}")
    assert dead == []


# --- sizes ---------------------------------------------------------------------------------------


def lines_of(path: Path) -> int:
    return len(path.read_text(encoding="utf-8").splitlines())


def test_no_source_file_is_longer_than_the_hard_limit() -> None:
    files = source_files()
    assert {path.suffix for path in files} >= {".rs", ".py"}
    long = {str(path.relative_to(ROOT)): lines_of(path) for path in files if lines_of(path) > HARD_LIMIT}
    assert long == {}


def test_the_border_stays_small() -> None:
    border = sorted((ROOT / "crates/gantline-py").rglob("*.rs"))
    assert border
    assert sum(lines_of(path) for path in border) < HARD_LIMIT


def test_every_file_of_tests_of_the_core_is_in_its_program() -> None:
    """Cargo looks for none by itself, where one program has them all."""
    tests = ROOT / "crates/gantline-core/tests"
    files = {path.stem for path in tests.glob("*.rs")} - {"all"}
    folders = {path.parent.name for path in tests.glob("*/mod.rs")}
    assert "mechanics" in files
    assert set(re.findall(r"^mod (\w+);", (tests / "all.rs").read_text(), flags=re.M)) == files | folders


def test_the_core_knows_no_python_no_files_and_no_terminal() -> None:
    foreign = re.compile(r"\b(pyo3|std::fs|std::io|std::process|println!|eprintln!|print!|dbg!)")
    core = sorted((ROOT / "crates/gantline-core/src").rglob("*.rs"))
    assert core
    found = [
        f"{path.relative_to(ROOT)}:{number}: {line.strip()}"
        for path in core
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1)
        if foreign.search(line)
    ]
    assert found == []
    assert "#![forbid(unsafe_code)]" in (ROOT / "crates/gantline-core/src/lib.rs").read_text(encoding="utf-8")


# --- locks ---------------------------------------------------------------------------------------


def locked_versions() -> dict[str, str]:
    text = "".join(
        (ROOT / "requirements" / name).read_text(encoding="utf-8") for name in ("dev.txt", "bench.txt")
    )
    pairs = re.findall(r"^([A-Za-z0-9._-]+)==([^\s;\\]+)", text, flags=re.MULTILINE)
    return {canonicalize_name(name): version for name, version in pairs}


def test_python_locks_have_hashes_and_no_addresses() -> None:
    locks = sorted((ROOT / "requirements").glob("*.txt"))
    assert [lock.name for lock in locks] == ["bench.txt", "dev.txt", "uv.txt"]
    for lock in locks:
        text = lock.read_text(encoding="utf-8")
        assert "http" not in text and "://" not in text and "index-url" not in text, lock
        entries = re.split(r"\n(?=\S)", text)
        assert all("--hash=sha256:" in entry for entry in entries if "==" in entry.splitlines()[0]), lock


def test_the_rust_lock_names_the_public_registry_only() -> None:
    # Cargo writes this identifier for crates.io whatever mirror the packages came from.
    sources = {package.get("source") for package in toml("Cargo.lock")["package"]}
    assert sources <= {None, "registry+https://github.com/rust-lang/crates.io-index"}


def test_node_locks_have_no_addresses() -> None:
    for lock in (path for path in repository_files() if path.name == "package-lock.json"):
        assert '"resolved"' not in lock.read_text(encoding="utf-8"), lock


def test_no_settings_of_one_machine_are_kept() -> None:
    unwanted = {".npmrc", "pip.conf", "uv.toml", "uv.lock", ".cargo", "rust-toolchain", "rust-toolchain.toml"}
    listed = subprocess.run(
        ["git", "ls-files", "--cached", "--others", "--exclude-standard"],
        cwd=ROOT, capture_output=True, text=True, check=False,
    )  # fmt: skip
    names = listed.stdout.splitlines() or [str(path.relative_to(ROOT)) for path in repository_files()]
    assert "pyproject.toml" in names
    assert [name for name in names if unwanted.intersection(Path(name).parts)] == []


def test_the_lock_satisfies_the_project_file() -> None:
    project = toml("pyproject.toml")
    asked = project["project"]["dependencies"] + project["build-system"]["requires"]
    asked += [item for group in project["dependency-groups"].values() for item in group]
    locked = locked_versions()
    for item in map(Requirement, asked):
        version = locked.get(canonicalize_name(item.name))
        assert version is not None, f"{item.name} is not locked: run `make lock`"
        assert item.specifier.contains(version, prereleases=True), f"{item} is locked at {version}"


def test_every_dependency_has_a_line_in_the_architecture() -> None:
    """By its own name, a scoped package of npm by the last part of it; stubs of types need none."""
    project = toml("pyproject.toml")
    asked = project["project"]["dependencies"] + project["project"]["optional-dependencies"]["cad"]
    asked += [item for group in project["dependency-groups"].values() for item in group]
    player = json.loads((ROOT / "viewer" / "package.json").read_text(encoding="utf-8"))
    names = [*(Requirement(item).name for item in asked), *player["dependencies"], *player["devDependencies"]]
    for manifest in ROOT.glob("crates/*/Cargo.toml"):
        crate = tomllib.loads(manifest.read_text(encoding="utf-8"))
        names += [*crate["dependencies"], *crate.get("dev-dependencies", {})]
    text = (ROOT / "ARCHITECTURE.md").read_text(encoding="utf-8").split("## Dependencies")[1]
    told = set(
        re.findall(r"[\w.-]+", "".join(line.split("|")[1] for line in re.findall(r"^\|.*", text, re.M)))
    )
    of_others = [name for name in names if not name.startswith(("types-", "@types/", "gantline-"))]
    assert {name.rpartition("/")[2] for name in of_others} - told == set()


# --- lifts in the wheel --------------------------------------------------------------------------


def test_every_scenario_comes_with_the_package() -> None:
    links = {path.name: path for path in (ROOT / "python/gantline/scenarios").iterdir()}
    lifts = {f"{path.parent.name}.yaml": path for path in (ROOT / "scenarios").glob("*/scenario.yaml")}
    files = [
        path.resolve() for kind in ("3docx", "nc", "obj") for path in (ROOT / "scenarios").glob(f"*/*.{kind}")
    ]
    named = {path.name: path for path in files}
    assert links.keys() == (lifts | named).keys()
    for name, link in links.items():
        assert link.is_symlink() and link.resolve() == (lifts | named)[name], "one copy, and links to it"


# --- versions, change log ------------------------------------------------------------------------


def test_rust_and_python_have_one_version() -> None:
    version = toml("Cargo.toml")["workspace"]["package"]["version"]
    assert metadata.version("gantline") == version
    for manifest in sorted(ROOT.glob("crates/*/Cargo.toml")):
        assert tomllib.loads(manifest.read_text(encoding="utf-8"))["package"]["version"] == {
            "workspace": True
        }, manifest


def test_the_package_tells_its_version() -> None:
    import gantline

    assert gantline.__version__ == metadata.version("gantline")


def test_the_change_log_has_the_present_version() -> None:
    version = toml("Cargo.toml")["workspace"]["package"]["version"]
    headings = re.findall(
        r"^## \[([^\]]+)\]", (ROOT / "CHANGELOG.md").read_text(encoding="utf-8"), flags=re.MULTILINE
    )
    assert headings and headings[0] in {"Unreleased", version}
