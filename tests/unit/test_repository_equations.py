"""A label such as (WI2) is one equation in all documents, and whoever names it finds it.

Letters are those of one page of `docs/concepts`, and the tables of its index say of which. Plain numbers
are the paper's.
"""

from __future__ import annotations

import io
import re
import tokenize
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
CONCEPTS = ROOT / "docs" / "concepts"

LABEL = r"[A-Z]{1,2}\d{1,2}"
TAG = re.compile(r"\\tag\{([^}]*)\}")
LETTERED = re.compile(rf"\\tag\{{({LABEL})\}}")
#: In a sentence: "(WI2)", or "equation WI2" and "winch.md, WI2" where somebody leaves out the parentheses.
NAMED = re.compile(rf"\(({LABEL})\)|\b(?:[Ee]quations?|eqs?\.|\.md,)\s+({LABEL})\b")
#: In a page: a link that says which equation it leads to.
LINK = re.compile(rf"\[[^\]]*?\(({LABEL})\)[^\]]*?\]\(([^)#]+)[^)]*\)")

Pages = dict[Path, str]


def pages() -> Pages:
    return {path: path.read_text(encoding="utf-8") for path in (ROOT / "docs").rglob("*.md")}


def defined(texts: Pages) -> set[str]:
    return {label for text in texts.values() for label in LETTERED.findall(text)}


def repeated(texts: Pages) -> list[str]:
    """Labels that stand at more than one equation; the paper's numbers count too."""
    found = Counter(label for text in texts.values() for label in TAG.findall(text))
    return sorted(label for label, times in found.items() if times > 1)


def letters(texts: Pages) -> dict[str, set[str]]:
    """The letters of each page that numbers equations of its own."""
    own = {path.name: LETTERED.findall(text) for path, text in texts.items() if LETTERED.search(text)}
    return {name: {label.rstrip("0123456789") for label in labels} for name, labels in own.items()}


def in_prose(path: Path, text: str) -> Iterator[str]:
    """What people read of a file: comments of Rust, comments and texts of Python, all of a document."""
    if path.suffix == ".rs":
        yield "\n".join(line.partition("//")[2] for line in text.splitlines())
    elif path.suffix in {".py", ".pyi"}:
        if not NAMED.search(text):
            return  # nor does any part of it; to take it apart takes long
        read = tokenize.generate_tokens(io.StringIO(text).readline)
        yield from (token.string for token in read if token.type in {tokenize.COMMENT, tokenize.STRING})
    else:
        yield text


def nowhere(path: Path, text: str, labels: set[str]) -> list[str]:
    """Labels that a file names and no page defines."""
    named = {one or other for prose in in_prose(path, text) for one, other in NAMED.findall(prose)}
    return [f"{path.name}: ({label})" for label in sorted(named - labels)]


def misled(texts: Pages) -> list[str]:
    """Labels that a page names without being theirs or leading to them, and links that lead elsewhere."""
    own = {path: set(LETTERED.findall(text)) for path, text in texts.items()}
    wrong = []
    for path, text in texts.items():
        led = [(label, (path.parent / to).resolve()) for label, to in LINK.findall(text)]
        wrong += [
            f"{path.name}: ({label}) is not on {to.name}" for label, to in led if label not in own.get(to, ())
        ]
        named = {one or other for one, other in NAMED.findall(LINK.sub("", text))}
        wrong += [f"{path.name}: ({label}) stands elsewhere" for label in sorted(named - own[path])]
    return wrong


def test_every_label_is_of_one_equation() -> None:
    texts = pages()
    assert len(defined(texts)) > 100, "pages number their equations as they did"
    assert repeated(texts) == []


def test_letters_are_of_one_page_and_the_index_says_of_which() -> None:
    texts = pages()
    told = re.findall(
        r"^\| \[.*?\]\((\w+\.md)\) \|.*\| ([A-Z]+) \|$", texts[CONCEPTS / "index.md"], flags=re.MULTILINE
    )
    assert {name: {its} for name, its in told} == letters(texts)
    assert len({its for _, its in told}) == len(told)


def test_the_equations_of_the_paper_have_their_places() -> None:
    """Those of its step, from the discrete action (4) on, on one page, and those of its ropes on another."""
    for name, numbers in (("del.md", [4, 6, *range(8, 16)]), ("rope.md", range(16, 23))):
        text = (CONCEPTS / name).read_text(encoding="utf-8")
        told = {int(number) for number in re.findall(r"(?:\\tag\{|\()(\d+)[})]", text)}
        assert [number for number in numbers if number not in told] == [], name


def test_every_equation_that_a_page_names_is_its_own_or_linked() -> None:
    assert misled(pages()) == []


def test_every_equation_that_a_file_names_exists() -> None:
    labels = defined(pages())
    kinds = {".rs", ".py", ".pyi", ".md", ".toml"}
    folders = ("docs", "crates", "python", "tests", "benchmarks", "tools", "scenarios")
    files = [path for folder in folders for path in (ROOT / folder).rglob("*") if path.suffix in kinds]
    files = [*ROOT.glob("*.md"), *(path for path in files if path != Path(__file__).resolve())]
    assert len(files) > 500, "the folders are where they were"
    texts = {path: path.read_text(encoding="utf-8") for path in files}
    naming = [path for path, text in texts.items() if path.suffix in {".rs", ".py"} and NAMED.search(text)]
    assert len(naming) > 10, "sources name equations as they did"
    assert [wrong for path, text in texts.items() for wrong in nowhere(path, text, labels)] == []


def test_mistakes_are_found() -> None:
    """Each of the ways in which a label can be wrong, made up."""
    one, two = CONCEPTS / "one.md", CONCEPTS / "two.md"
    texts = {one: r"$a \tag{15}$ $b \tag{XA1}$ (XA1), [(XB1)](two.md#there)", two: r"$c \tag{XB1}$"}
    assert (repeated(texts), misled(texts), letters(texts)) == ([], [], {"one.md": {"XA"}, "two.md": {"XB"}})
    assert repeated({**texts, two: r"\tag{XA1} \tag{15}"}) == ["15", "XA1"]
    assert misled({**texts, two: r"\tag{XB2}"}) == ["one.md: (XB1) is not on two.md"]
    assert misled({**texts, two: r"\tag{XB1} see (XA1)"}) == ["two.md: (XA1) stands elsewhere"]
    labels = {"XA1"}
    rust = "let x = f(U1); // (XA1), then\n/// equation XA2 and (XA3)\n//! (0, 1) (XA1)"
    assert nowhere(Path("a.rs"), rust, labels) == ["a.rs: (XA2)", "a.rs: (XA3)"]
    python = 'f(U1)  # (XA2)\ndef g() -> None:\n    """(XA1) of docs/concepts/one.md, XA3."""\n'
    assert nowhere(Path("a.py"), python, labels) == ["a.py: (XA2)", "a.py: (XA3)"]
