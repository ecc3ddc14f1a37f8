"""One name for one thing: words that CONVENTIONS.md replaces by others occur nowhere in what people read.

The rules look at every line of documents, lift files, and sources with their identifiers. `snake_case` and
`CamelCase` names are read as words. What a rule allows is taken out of the line before it looks; a part of a
document that must name forbidden words stands between `<!-- words: off -->` and `<!-- words: on -->`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache, cached_property
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
FOLDERS = ("crates", "python", "tests", "docs", "scenarios", "schema", "benchmarks", "tools")
SUFFIXES = {".md", ".rs", ".py", ".pyi", ".yaml", ".ts", ".toml", ".json"}
THIS_FILE = Path(__file__).resolve()


@dataclass(frozen=True)
class Rule:
    """Words that are not used, what is said instead, and where the word is right all the same."""

    forbidden: str
    instead: str
    allowed: str = r"(?!)"  # matches nothing
    places_allowed: str = r"(?!)"  # paths from the root that the rule leaves alone

    def breach(self, line: str) -> bool:
        # What is allowed takes far longer to find, and most lines have nothing that needs it.
        return self._found(line) and self._found(re.sub(self.allowed, " ", line, flags=re.IGNORECASE))

    def _found(self, text: str) -> bool:
        return re.search(self.forbidden, as_words(text), flags=re.IGNORECASE) is not None


def as_words(text: str) -> str:
    """`rope_tension` and `RopeTension` as separate words."""
    return re.sub(r"(?<=[a-z])(?=[A-Z])", " ", text).replace("_", " ")


NUMERICS = (
    r"crates/gantline-core/(src/(solver|tree|stepper|constraint|force|statics)|tests)/"  # blocks of a matrix
)
PAPER = r".*\b(paper|Ham)\b.*"  # a line that cites the paper may use its words


def anywhere(*patterns: str) -> str:
    """Matches one of the patterns as whole words, of identifiers too."""
    return "|".join(rf"(?<![a-z])({pattern})(?![a-z])" for pattern in patterns)


RULES = [
    # The scenario bears the name of the paper's section.
    Rule(
        r"\bpulleys?\b", "sheave", anywhere(r"(?<=[`'\"/_.])pulleys", r"pulleys(?=[`'\"/_.:(])") + "|" + PAPER
    ),
    Rule(r"\bwires?\b(?! ?frame)", "rope"),
    Rule(r"\bcables?\b", "rope"),
    Rule(
        r"\bblocks?\b",
        "load, or the kind of block: hook block, sheave block, keel block, ship block",
        anywhere(
            r"(hook|sheave|keel|ship|cad)[ _-]?blocks?|ShipBlock\w*|make_ship_block",
            r"(code|math|sub|diagonal|matrix|dense|sparse|text|yaml|comment)[ _-]?blocks?",
            r"block[ _](matri\w+|diagonal|principal|pivot\w*)",
            r"\d ?[x×] ?\d blocks?",
            r"sheaves? with (its )?block",
            r"np\.block",
            # The key of a hook block in a lift file, and the name of a load there or in code, not in prose.
            r"block: \{+mass: [^}]*\}",
            r"block\.\w+|(name|to|under|load): block|between: \[(slings, )?block\b",
            r"(?<=['\"`])blocks?(?=['\"`.])",
        )
        + r"|`[^`]*\bblock\b[^`]*`|"
        + PAPER,
        NUMERICS,
    ),
    Rule(
        r"\b(net|gross) (weights?|loads?|mass(es)?)\b",
        "calculated weight, design weight, hook load, hoist load",
    ),
    Rule(r"\bSWL\b|\bsafe working load", "rated capacity of a crane, working load limit of gear"),
    Rule(r"\bbreaking (load|strength)\b|\bMBL\b", "minimum breaking force"),
    Rule(r"\brigidity\b", "axial stiffness"),
    Rule(r"\belongations?\b", "stretch"),
    Rule(r"\b(anchor points?|rope anchors?|anchorages?)\b", "dead end (of a rope), lug (on a load)"),
    Rule(r"\bhawsers?\b", "mooring line", places_allowed=r"tests/"),  # names of lines there
    Rule(
        r"\bcent(er|re)s? of mass\b|\bcenters? of gravity\b|(?-i:\bC[oO]G\b)",
        "centre of gravity",
        r"CentreOfMass\(\)|CenterOfGravity",  # names of other people's
    ),
    Rule(r"\butilizations?\b", "utilisation"),
    Rule(r"\bequalisers?\b", "equalizer"),
    Rule(r"\bliftoff\b", "lift-off"),
    Rule(r"\bskew factor\b", "skew load factor"),
    Rule(r"\bdynamic (load|impact) factor\b", "dynamic amplification factor"),
]


@dataclass(frozen=True)
class Text:
    """A file that the rules look at: its path from the root, and its lines with their numbers."""

    path: str
    numbers: list[int]
    lines: list[str]

    @cached_property
    def whole(self) -> str:
        return "\n".join(self.lines)

    @cached_property
    def words(self) -> str:
        return as_words(self.whole)

    def breaches(self, rule: Rule) -> list[str]:
        """Lines that break a rule, as they are told."""
        found = re.finditer(rule.forbidden, self.words, flags=re.IGNORECASE)
        return [self.told(at) for at in lines_of(found) if rule.breach(self.lines[at])]

    def having(self, pattern: re.Pattern[str]) -> list[str]:
        """Lines with a pattern, as they are told."""
        return [self.told(at) for at in lines_of(pattern.finditer(self.whole))]

    def told(self, at: int) -> str:
        return f"{self.path}:{self.numbers[at]}: {self.lines[at].strip()}"


def lines_of(found: Iterator[re.Match[str]]) -> list[int]:
    """The lines, from 0, on which there is something of a text, where nothing goes from one to the next."""
    return sorted({match.string.count("\n", 0, match.start()) for match in found})


@cache
def texts() -> list[Text]:
    """What the rules look at: searched file by file, which is faster than line by line."""
    found = []
    files = [path for path in ROOT.iterdir() if path.suffix == ".md"]
    files += [path for folder in FOLDERS for path in (ROOT / folder).rglob("*")]
    for path in sorted(files):
        inside = path.is_file() and path.suffix in SUFFIXES and "node_modules" not in path.parts
        if not inside or path == THIS_FILE:
            continue
        looking = True
        kept = {}
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            if "<!-- words: off -->" in line:
                looking = False
            elif "<!-- words: on -->" in line:
                looking = True
            elif looking:
                kept[number] = line
        found.append(Text(str(path.relative_to(ROOT)), list(kept), list(kept.values())))
    return found


@pytest.mark.parametrize("rule", RULES, ids=lambda rule: rule.instead)
def test_words(rule: Rule) -> None:
    looked_at = (text for text in texts() if not re.search(rule.places_allowed, text.path))
    breaches = [told for text in looked_at for told in text.breaches(rule)]
    assert not breaches, f"say instead: {rule.instead}\n" + "\n".join(breaches)


@pytest.mark.parametrize(
    "line",
    [
        "the rope runs over a pulley",
        "struct PulleySpec {",
        "pulley_radius = 0.4",
        "a steel wire rope",
        "cable_length: f64",
        "the block lifts off",
        "weight of the blocks",
        "net weight of the load",
        "elongation of the rope",
        "center_of_gravity",
        "utilization of the lug",
        "minimum breaking load",
        "the hawser of a barge",
    ],
)
def test_a_forbidden_word_is_found(line: str) -> None:
    assert any(rule.breach(line) for rule in RULES)


@pytest.mark.parametrize(
    "line",
    [
        "scenarios/pulleys/scenario.yaml",
        'simulate("pulleys")',
        "def test_pulleys_has_the_exact_tension() -> None:",
        "the sheave (a pulley in the paper)",
        "hook block and hanging falls",
        "keel_blocks stand under the load",
        "rating_includes_hook_block: bool = False",
        "slings go to: block.L1",
        'load_transferred of "block" is 50 %',
        "6×6 as 3×3 blocks",
        "wireframe, cabled is no word of ours",
    ],
)
def test_a_right_word_is_left_alone(line: str) -> None:
    assert not any(rule.breach(line) for rule in RULES)


# --- the project speaks of itself alone ----------------------------------------------------------

PLACES = re.compile(r"(?<![\w.:/])/(work|root|home|tmp|Users)/|\bC:\\\\")


def test_no_place_of_one_machine_is_named() -> None:
    found = [told for text in texts() for told in text.having(PLACES)]
    assert not found, "\n".join(found)


def test_the_package_needs_nothing_beside_the_repository() -> None:
    beside = re.compile(r"\.\./(\.\./)*shared\b")
    looked_at = (text for text in texts() if not text.path.startswith("tests/"))
    found = [told for text in looked_at for told in text.having(beside)]
    assert not found, "\n".join(found)


def test_a_place_of_one_machine_is_found() -> None:
    assert PLACES.search("reads /home/someone/lift.yaml")
    assert not PLACES.search("https://example.org/work/page and build/work/x")
