"""The documentation says what the program does: verbs, options, exit codes, metrics, variables."""

from __future__ import annotations

import ast
import re
from importlib import import_module
from pathlib import Path

import pytest
import typer.main

from gantline.cli import messages
from gantline.cli.app import app
from gantline.results import metrics
from gantline.results.file.saved import FILES_BESIDE

ROOT = Path(__file__).resolve().parents[2]


def page(path: str) -> str:
    return (ROOT / "docs" / path).read_text(encoding="utf-8")


def pages_left_out(folder: Path) -> list[str]:
    """Pages [path without suffix] that no list of contents leads to, which a reader would not find."""
    listed: set[Path] = set()
    for path in folder.rglob("*.md"):
        for listed_pages in re.findall(
            r"```\{toctree\}\n(.*?)```", path.read_text(encoding="utf-8"), re.DOTALL
        ):
            entries = [
                line.strip()
                for line in listed_pages.splitlines()
                if line.strip() and not line.startswith(":")
            ]
            listed |= {(path.parent / entry.split("<")[-1].rstrip(">")).resolve() for entry in entries}
    pages = {path.resolve().with_suffix("") for path in folder.rglob("*.md")}
    return sorted(
        str(path.relative_to(folder.resolve())) for path in pages - listed - {folder.resolve() / "index"}
    )


def test_every_page_is_in_a_list_of_contents(tmp_path: Path) -> None:
    assert pages_left_out(ROOT / "docs") == []
    (tmp_path / "index.md").write_text(
        "# All\n\n```{toctree}\n:maxdepth: 1\n\nfound\n```\n", encoding="utf-8"
    )
    for name in ("found", "forgotten"):
        (tmp_path / f"{name}.md").write_text(f"# {name}\n", encoding="utf-8")
    assert pages_left_out(tmp_path) == ["forgotten"]


def test_every_verb_and_option_is_documented() -> None:
    text = page("reference/command_line.md")
    group = typer.main.get_command(app)
    verbs = getattr(group, "commands", {})
    assert set(verbs) >= {"run", "compare", "check", "schema", "new"}
    words = [f"gantline {verb}" for verb in verbs]
    for command in verbs.values():
        for parameter in command.params:
            names = [*parameter.opts, *parameter.secondary_opts]
            words += [name for name in names if name.startswith("-") and name not in {"-h", "--help"}]
    assert "--step" in words and "-o" in words
    assert [word for word in words if f"`{word}" not in text] == []


def test_the_tables_of_keys_say_how_quantities_are_written(monkeypatch: pytest.MonkeyPatch) -> None:
    """A zero without a unit and numbers in quotes are left out of them; words and names stay."""
    pytest.importorskip("sphinx")
    monkeypatch.syspath_prepend(ROOT / "docs" / "extensions")
    tables = import_module("gantline_docs")
    text = "\n".join(tables.sections(tables.whole_schema()))
    written = {tuple(line.split(" | ")[0:3:2]) for line in text.splitlines() if line.startswith("| `")}
    assert ("| `duration`", "`40 s`") in written
    assert ("| `position`", "`[23 m, 23 m, 23 m]`") in written
    assert ("| `turbulence`", "`5 %` or a number") in written
    assert ("| `corners`", "a text or name or a list") in written
    assert ("| `seed`", "a number") in written


def test_verbs_that_show_a_recording_name_all_that_is_shown_beside_it() -> None:
    text = page("reference/command_line.md")
    for verb in ("report", "view"):
        section = text.split(f"\n## `gantline {verb} ")[1].split("\n## ")[0]
        assert [name for name in FILES_BESIDE if f"`{name}`" not in section] == [], verb


def test_every_exit_code_is_documented() -> None:
    text = page("reference/command_line.md")
    codes = [value for name, value in vars(messages).items() if name.isupper() and isinstance(value, int)]
    assert len(codes) >= 4
    assert [code for code in codes if f"| {code} |" not in text] == []


def variables_made(tree: ast.AST) -> set[str]:
    """Names under which a module of the results puts its variables."""

    def is_variable(value: ast.expr) -> bool:
        return isinstance(value, ast.Call) and getattr(value.func, "id", "") == "Variable"

    keys: list[ast.expr | None] = []
    for node in ast.walk(tree):
        if isinstance(node, ast.Dict):
            keys += [key for key, value in zip(node.keys, node.values, strict=True) if is_variable(value)]
        elif isinstance(node, ast.Assign) and is_variable(node.value):
            keys += [target.slice for target in node.targets if isinstance(target, ast.Subscript)]
    return {str(key.value) for key in keys if isinstance(key, ast.Constant)}


def test_every_variable_of_a_recording_is_documented() -> None:
    import sample_lift

    text = page("reference/recording.md")
    made = set(sample_lift.ringing_lift())
    for module in (ROOT / "python/gantline/results").rglob("*.py"):
        made |= variables_made(ast.parse(module.read_text(encoding="utf-8")))
    assert made >= {"rope_tension", "hook_height", "boom_angle", "ground_pressure", "groove_slip"}
    assert sorted(name for name in made if f"`{name}`" not in text) == []


def test_every_kind_of_event_is_documented() -> None:
    """Those of the core, and those that results add where a limit of a crane is passed."""
    text = page("reference/recording.md")
    core = (ROOT / "crates/gantline-core/src/event/mod.rs").read_text(encoding="utf-8")
    kinds = set(re.findall(r'Self::\w+ => "(\w+)"', core))
    for module in (ROOT / "python/gantline/results").rglob("*.py"):
        for node in ast.walk(ast.parse(module.read_text(encoding="utf-8"))):
            if isinstance(node, ast.FunctionDef) and re.search("events|overloads", node.name):
                triples = [one.elts for one in ast.walk(node) if isinstance(one, ast.Tuple)]
                named = [parts[1] for parts in triples if len(parts) == 3]
                kinds |= {str(kind.value) for kind in named if isinstance(kind, ast.Constant)}
    assert kinds >= {"taut", "capsized", "overload", "hook_too_high", "tipping"}
    assert sorted(kind for kind in kinds if f"`{kind}`" not in text) == []


def test_every_metric_is_documented_where_it_is_made() -> None:
    import sample_lift

    table = metrics.__doc__ or ""
    names = {name.split(".")[0] for name in sample_lift.ringing_lift().metrics()}
    assert [name for name in sorted(names) if f"`{name}" not in table] == []


def test_names_in_documents_are_those_of_the_sources() -> None:
    """What stands as `snake_case` in a document is a name of the sources: none has been left behind."""
    places = ("crates/**/*.rs", "crates/**/*.toml", "python/**/*.py", "viewer/src/**/*.ts", "schema/*.json")
    lifts = [*ROOT.glob("scenarios/*/scenario.yaml")]
    sources = [*lifts, *(path for place in places for path in ROOT.glob(place))]
    assert len(sources) > 400, "the folders are where they were"
    known = {word for path in sources for word in re.findall(r"\w+", path.read_text(encoding="utf-8"))}
    known |= {path.parent.name for path in lifts}
    documents = [
        *ROOT.glob("*.md"),
        *(ROOT / "docs").rglob("*.md"),
        *(ROOT / "scenarios").glob("*/README.md"),
    ]
    unknown = [
        f"{path.relative_to(ROOT)}: {name}"
        for path in documents
        if path.name not in {"CHANGELOG.md", "CHANGES_ON_MAIN.md"}
        for name in re.findall(r"(?<!`)`([a-z0-9]+(?:_[a-z0-9]+)+)`(?!`)", path.read_text(encoding="utf-8"))
        if name not in known
    ]
    assert unknown == []


def test_every_verification_says_what_it_compares_with() -> None:
    """The page of cases shows the docstrings of these tests."""
    silent = []
    for folder in ("verification", "validation"):
        for module in sorted((ROOT / "tests" / folder).glob("test_*.py")):
            tree = ast.parse(module.read_text(encoding="utf-8"))
            tests = [node for node in tree.body if isinstance(node, ast.FunctionDef)]
            named = [node for node in tests if node.name.startswith("test_")]
            assert named, module
            silent += [f"{module.name}: {node.name}" for node in named if not ast.get_docstring(node)]
    assert silent == []
