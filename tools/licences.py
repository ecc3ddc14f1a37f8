"""Writes THIRD_PARTY_LICENSES: what is compiled into packages of gantline, with licences to be passed on.

The packages are those of the locks, the texts those that came with them: `make setup` has both here. Where
one may choose, a package is taken under Apache-2.0, gantline's own, whose text is LICENSE.
"""

from __future__ import annotations

import json
import re
import subprocess
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import product
from pathlib import Path
from typing import Any

from packaging.licenses import canonicalize_license_expression

ROOT = Path(__file__).resolve().parents[1]
RESULT = ROOT / "THIRD_PARTY_LICENSES"
VIEWER = ROOT / "viewer"
OWN = "Apache-2.0"
PREFERRED = (OWN, "MIT")

#: What gantline may be built with: licences that ask for notices and no more.
ALLOWED = {
    "0BSD", "Apache-2.0", "Apache-2.0 WITH LLVM-exception", "BSD-2-Clause", "BSD-3-Clause", "BSL-1.0",
    "CC0-1.0", "HPND", "ISC", "MIT", "MIT-CMU", "PSF-2.0", "Unicode-3.0", "Unlicense", "Zlib",
}  # fmt: skip

TEXT_FILES = re.compile(r"(LICEN[CS]E|COPYING|UNLICENSE|NOTICE)\b.*", re.IGNORECASE)
NOTICE_FILES = re.compile(r"NOTICE\b.*", re.IGNORECASE)

HEAD = """\
Third-party licences

gantline is licensed under Apache-2.0, see LICENSE. What others wrote and is compiled into its packages is
listed here, with the licence under which it is taken where there is a choice, and with the texts of licences
that ask for them to be passed on. Python packages that gantline needs are installed beside it and bring their
own.
"""


@dataclass(frozen=True)
class Part:
    """Something that others wrote.

    Attributes:
        name: With its version.
        licence: SPDX expression.
        texts: Files of its licences, as they came with it.
    """

    name: str
    licence: str
    texts: tuple[Path, ...]

    @property
    def taken(self) -> str:
        """The licence it is taken under: one that is preferred if that is offered, else the first allowed."""
        choices = [" AND ".join(sorted(one)) for one in alternatives(self.licence) if one <= ALLOWED]
        if not choices:
            raise ValueError(f"{self.name}: '{self.licence}' is not allowed")
        return next((one for one in PREFERRED if one in choices), choices[0])


def alternatives(expression: str) -> list[frozenset[str]]:
    """The sets of licences that an SPDX expression lets one choose from; each set holds together.

    Raises:
        packaging.licenses.InvalidLicenseExpression: If it is none; `MIT/Apache-2.0`, Cargo's old way, is one.
    """
    text = str(canonicalize_license_expression(expression.replace("/", " OR ")))
    words = re.findall(r"[()]|[^\s()]+", text)

    def either() -> list[frozenset[str]]:
        found = both()
        while words and words[0] == "OR":
            words.pop(0)
            found += both()
        return found

    def both() -> list[frozenset[str]]:
        found = one()
        while words and words[0] == "AND":
            words.pop(0)
            found = [left | right for left, right in product(found, one())]
        return found

    def one() -> list[frozenset[str]]:
        word = words.pop(0)
        if word == "(":
            found = either()
            words.pop(0)
            return found
        if words and words[0] == "WITH":
            word = f"{word} WITH {words[1]}"
            del words[:2]
        return [frozenset([word])]

    return either()


def permissive(expression: str) -> bool:
    """Whether one may choose licences that are all allowed."""
    return any(choice <= ALLOWED for choice in alternatives(expression))


def cargo_metadata() -> dict[str, Any]:
    """Packages of Cargo.lock and what needs what, for all platforms."""
    out = subprocess.run(
        ["cargo", "metadata", "--format-version=1", "--locked", "--offline"],
        cwd=ROOT, capture_output=True, text=True, check=True,
    ).stdout  # fmt: skip
    found: dict[str, Any] = json.loads(out)
    return found


def compiled_crates() -> list[Part]:
    """Crates that end in the library: needed by it to run, not to test or build it, and no macros."""
    metadata = cargo_metadata()
    packages = {package["id"]: package for package in metadata["packages"]}
    needs = {node["id"]: node["deps"] for node in metadata["resolve"]["nodes"]}
    waiting = [key for key, package in packages.items() if package["name"] == "gantline-py"]
    seen: set[str] = set()
    while waiting:
        key = waiting.pop()
        macro = any("proc-macro" in target["kind"] for target in packages[key]["targets"])
        if key not in seen and not macro:
            seen.add(key)
            waiting += [
                need["pkg"] for need in needs[key] if any(kind["kind"] is None for kind in need["dep_kinds"])
            ]
    foreign = [packages[key] for key in seen if packages[key]["source"] is not None]
    return [
        part(f"{crate['name']} {crate['version']}", crate["license"], Path(crate["manifest_path"]).parent)
        for crate in foreign
    ]


def bundled_packages() -> Iterator[Part]:
    """Packages of npm that end in the player, and what they hold copies of.

    Raises:
        ValueError: If what is installed is not what the lock says, or holds copies that nothing here knows.
    """
    lock = json.loads((VIEWER / "package-lock.json").read_text(encoding="utf-8"))
    for place, locked in lock["packages"].items():
        if not place or locked.get("dev"):
            continue
        folder = VIEWER / place
        installed = json.loads((folder / "package.json").read_text(encoding="utf-8"))
        if installed["version"] != locked["version"]:
            raise ValueError(
                f"{place} is installed as {installed['version']}: 'make setup' installs the lock's"
            )
        yield part(f"{installed['name']} {installed['version']}", installed["license"], folder)
    copies = VIEWER / "node_modules" / "three" / "src" / "extras" / "lib"
    if [copy.name for copy in copies.iterdir()] != ["earcut.js"]:
        raise ValueError(
            f"{copies}: holds other copies than earcut, whose licences belong to viewer/licences"
        )
    version = re.search(
        r"copy of mapbox/earcut version (\S+)", (copies / "earcut.js").read_text(encoding="utf-8")
    )
    if version is None:
        raise ValueError(f"{copies / 'earcut.js'}: does not say its version")
    texts = (VIEWER / "licences" / "earcut.txt",)
    yield Part(f"earcut {version[1]}, of which three holds a copy", "ISC", texts)


def part(name: str, licence: str | None, folder: Path) -> Part:
    """What a package says of itself, with the files of its licences."""
    if licence is None:
        raise ValueError(f"{name}: names no licence")
    texts = tuple(sorted(path for path in folder.iterdir() if TEXT_FILES.fullmatch(path.name)))
    return Part(name, licence, texts)


def texts_to_pass_on(one: Part) -> list[str]:
    """Texts that its licences ask for, beside LICENSE.

    Raises:
        ValueError: If there should be one and is none.
    """
    if one.taken == OWN:
        wanted = [path for path in one.texts if NOTICE_FILES.fullmatch(path.name)]
    else:
        named = [path for path in one.texts if path.stem.upper().endswith(f"-{one.taken.upper()}")]
        wanted = named or list(one.texts)
        if not wanted:
            raise ValueError(f"{one.name}: came without the text of {one.taken}")
    return [
        "\n".join(line.rstrip() for line in path.read_text(encoding="utf-8").strip("\ufeff\r\n").splitlines())
        for path in wanted
    ]


def document() -> str:
    """The whole file."""
    player = sorted(bundled_packages(), key=lambda one: one.name)
    core = sorted(compiled_crates(), key=lambda one: one.name)
    core.append(Part("Rust's standard library", "MIT OR Apache-2.0", ()))
    by_text: dict[str, list[str]] = {}
    for one in [*player, *core]:
        for text in texts_to_pass_on(one):
            by_text.setdefault(text, []).append(one.name)
    lists = [
        f"{title}\n\n" + "\n".join(f"  {one.name}: {one.taken}" for one in parts) + "\n"
        for title, parts in (("In the player of reports", player), ("In the compiled core", core))
    ]
    ruler = "-" * 80
    texts = [f"{ruler}\n{'; '.join(names)}\n{ruler}\n\n{text}\n" for text, names in by_text.items()]
    return "\n".join([HEAD, *lists, *texts])


if __name__ == "__main__":
    RESULT.write_text(document(), encoding="utf-8")
