"""Licences: gantline's own everywhere, permissive ones of all that it needs, and texts that are passed on."""

from __future__ import annotations

import json
import re
import tomllib
from collections.abc import Iterator
from importlib import import_module, metadata
from pathlib import Path
from typing import Any

import pytest
from packaging.licenses import InvalidLicenseExpression
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

ROOT = Path(__file__).resolve().parents[2]

# What packages say that have no SPDX expression; several of them are read as all of them.
CLASSIFIERS = {
    "Apache Software License": "Apache-2.0",
    "BSD License": "BSD-3-Clause",
    "ISC License (ISCL)": "ISC",
    "MIT License": "MIT",
    "Python Software Foundation License": "PSF-2.0",
}


@pytest.fixture
def licences(monkeypatch: pytest.MonkeyPatch) -> Any:
    monkeypatch.syspath_prepend(ROOT / "tools")
    return import_module("licences")


def toml(path: Path) -> dict[str, Any]:
    return tomllib.loads(path.read_text(encoding="utf-8"))


def test_the_licence_is_apache_2_everywhere() -> None:
    assert "Apache License\n                           Version 2.0, January 2004" in (
        ROOT / "LICENSE"
    ).read_text(encoding="utf-8")
    assert toml(ROOT / "pyproject.toml")["project"]["license"] == "Apache-2.0"
    assert toml(ROOT / "Cargo.toml")["workspace"]["package"]["license"] == "Apache-2.0"
    for manifest in sorted(ROOT.glob("crates/*/Cargo.toml")):
        assert toml(manifest)["package"]["license"] == {"workspace": True}, manifest
    assert json.loads((ROOT / "viewer/package.json").read_text(encoding="utf-8"))["license"] == "Apache-2.0"


# --- what an expression allows -------------------------------------------------------------------


@pytest.mark.parametrize(
    ("expression", "right"),
    [
        ("MIT", True),
        ("MIT/Apache-2.0", True),
        ("(MIT OR Apache-2.0) AND Unicode-3.0", True),
        ("MIT OR Apache-2.0 OR LGPL-2.1-or-later", True),
        ("Apache-2.0 WITH LLVM-exception", True),
        ("GPL-3.0-only AND MIT", False),
        ("MIT AND (GPL-3.0-only OR ISC AND AGPL-3.0-only)", False),
        ("GPL-3.0-only WITH Classpath-exception-2.0", False),
        ("SSPL-1.0", False),
    ],
)
def test_an_expression_is_right_if_one_choice_is_allowed_whole(
    licences: Any, expression: str, right: bool
) -> None:
    assert licences.permissive(expression) is right


def test_choices_of_an_expression(licences: Any) -> None:
    choices = licences.alternatives("(MIT OR Apache-2.0) AND (Zlib OR ISC AND 0BSD)")
    expected = [
        {"MIT", "Zlib"},
        {"MIT", "ISC", "0BSD"},
        {"Apache-2.0", "Zlib"},
        {"Apache-2.0", "ISC", "0BSD"},
    ]
    assert choices == expected


@pytest.mark.parametrize("text", ["LIMITED", "DISCLAIMER", "see LICENSE", ""])
def test_what_is_no_expression_is_refused(licences: Any, text: str) -> None:
    with pytest.raises(InvalidLicenseExpression):
        licences.permissive(text)


# --- what is needed ------------------------------------------------------------------------------


def test_rust_dependencies_have_permissive_licences(licences: Any) -> None:
    packages = licences.cargo_metadata()["packages"]
    assert len(packages) > 50
    assert [one["name"] for one in packages if not licences.permissive(one["license"])] == []


def test_packages_of_the_player_have_permissive_licences(licences: Any) -> None:
    parts = list(licences.bundled_packages())
    assert [one.name.split()[0] for one in parts] == ["three", "earcut"]
    assert [one.name for one in parts if not licences.permissive(one.licence)] == []


def licence_of(name: str) -> str:
    """SPDX expression of an installed package."""
    data = metadata.metadata(name)
    if "License-Expression" in data:
        return str(data["License-Expression"])
    said = [line.split(" :: ")[-1] for line in data.get_all("Classifier") or [] if line.startswith("License")]
    if said:
        return " AND ".join(CLASSIFIERS.get(line, f"'{line}'") for line in said)
    return str(data["License"]) if "License" in data else "None"


def needed(names: list[str]) -> Iterator[str]:
    """Packages of these names that are installed, and what they need in turn."""
    waiting, seen = list(names), set()
    while waiting:
        name = canonicalize_name(waiting.pop())
        if name in seen:
            continue
        seen.add(name)
        yield name
        for item in map(Requirement, metadata.requires(name) or []):
            if item.marker is None or item.marker.evaluate({"extra": ""}):
                waiting.append(item.name)


def test_python_dependencies_have_permissive_licences(licences: Any) -> None:
    """Those that are declared, also as an extra, and those that come with them."""
    project = toml(ROOT / "pyproject.toml")["project"]
    asked = [*project["dependencies"], *project["optional-dependencies"]["cad"]]
    found = {name: licence_of(name) for name in needed([Requirement(item).name for item in asked])}
    assert {"numpy", "pandas", "trimesh"} <= set(found)
    wrong = {}
    for name, licence in found.items():
        try:
            if not licences.permissive(licence):
                wrong[name] = licence
        except InvalidLicenseExpression:
            wrong[name] = licence
    assert wrong == {}


# --- what is passed on ---------------------------------------------------------------------------


def test_the_licences_that_are_passed_on_are_those_of_the_locks(licences: Any) -> None:
    assert licences.RESULT.read_text(encoding="utf-8") == licences.document(), (
        "run 'python tools/licences.py'"
    )


def test_what_is_passed_on_names_what_is_compiled_in(licences: Any) -> None:
    """Versions of both locks, without what only tests, builds and macros need."""
    text = licences.RESULT.read_text(encoding="utf-8")
    listed = dict(re.findall(r"^  (\S+) ([\d.]\S*)(?=[:,])", text, flags=re.MULTILINE))
    crates = {(one["name"], one["version"]) for one in toml(ROOT / "Cargo.lock")["package"]}
    lock = json.loads((ROOT / "viewer/package-lock.json").read_text(encoding="utf-8"))["packages"]
    assert listed.pop("three") == lock["node_modules/three"]["version"]
    assert listed.pop("earcut") and set(listed.items()) <= crates
    assert {"parry3d-f64", "glam", "pyo3", "numpy", "serde_json"} <= set(listed)
    assert not {"proptest", "gantline-core", "syn", "serde_derive", "vite"} & set(listed)
    assert "Copyright © 2010-2026 three.js authors" in text and "Copyright (c) 2024, Mapbox" in text


def test_a_licence_without_its_text_and_one_that_is_not_allowed_are_refused(licences: Any) -> None:
    with pytest.raises(ValueError, match=r"bare 1\.0: came without the text of MIT"):
        licences.texts_to_pass_on(licences.Part("bare 1.0", "MIT", ()))
    with pytest.raises(ValueError, match=r"left 1\.0: 'GPL-3\.0-only AND MIT' is not allowed"):
        licences.texts_to_pass_on(licences.Part("left 1.0", "GPL-3.0-only AND MIT", ()))
    own = licences.Part("own 1.0", "MIT OR Apache-2.0", ())
    assert (own.taken, licences.texts_to_pass_on(own)) == ("Apache-2.0", [])
