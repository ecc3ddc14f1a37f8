"""The strict reader of YAML: text in, a tree of mappings, lists and texts with line numbers out.

Every scalar stays the text that was written, so ``L.1``, ``1`` and ``on`` are names and never numbers or
truth values. The tree is built from the parser's events, one after the other: aliases are refused when they
are met, before anything could be multiplied, and nesting is bounded without recursion.
"""

from __future__ import annotations

import re
import stat
from collections.abc import Callable, Collection, Iterator, Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Any, Final

import yaml
from ruamel.yaml import YAML, events
from ruamel.yaml.error import MarkedYAMLError, YAMLError
from ruamel.yaml.reader import ReaderError

from gantline.opened import note_opened
from gantline.scenario.errors import PathPart, Problem, ScenarioError, join_path, shorten
from gantline.scenario.file.not_yaml import problem_of

__all__ = [
    "LARGEST_FILE",
    "ListNode",
    "MapNode",
    "Node",
    "TextNode",
    "like",
    "line_of",
    "parse_text",
    "problem_at",
    "read_text",
    "texts",
    "written_at",
]

#: Largest lift file that is read [byte].
LARGEST_FILE: Final = 5_000_000
_DEEPEST: Final = 32
#: A key and its value, such as `to block.L1` or `length 12 m`, and no words of a text.
_KEY_AND_VALUE: Final = re.compile(r"[a-z_]+ (?:\S+|[-+]?[0-9.]+ \S+)$")
#: How the rest of a number begins behind a comma between thousands.
_THOUSANDS: Final = re.compile(r"[0-9]{3}(?![0-9])")
#: What stands before such a comma, or a decimal one.
_WHOLE: Final = re.compile(r"[+-]?[0-9]+")
#: A text before a comma that is no number, and whose comma is therefore no decimal one.
_IN_WORDS: Final = re.compile(r"[^\W\d_]{2}")
#: A comment that YAML sees where a number may be meant: `Lift #3`.
_NUMBERED: Final = re.compile(r"[ \t]+#[0-9]\w*")
#: What the reader refuses as it stands comes by an escape of quoted text; no file can be written with it.
_NO_TEXT: Final = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\x7f\ud800-\udfff\ufffe\uffff]")
#: With what a text of two bytes for each letter begins, of either order.
_UTF_16: Final = (b"\xff\xfe", b"\xfe\xff")
#: How files that people write lifts into begin, and are no text.
_OTHER_KINDS: Final = {
    b"PK\x03\x04": "a zip file, as spreadsheets and documents are",
    b"\xd0\xcf\x11\xe0": "an older spreadsheet or document",
    b"%PDF": "a PDF",
    b"\x1f\x8b": "a gzip file",
}
#: Bytes that no text holds, in whatever code.
_IN_NO_TEXT: Final = bytes({*range(32)} - set(b"\t\n\f\r\x1b"))
#: With what a recording begins.
_HDF5: Final = b"\x89HDF"
#: What libyaml, which is of YAML 1.1, takes otherwise than ruamel.yaml: tabs, keys with a '?', ends of lines.
_SELDOM: Final = re.compile("[?\t\x85\u2028\u2029\ufeff]")
#: Parts of a text, as either parser calls them.
_DOCUMENT: Final = (events.DocumentStartEvent, yaml.DocumentStartEvent)
_DOCUMENT_ENDS: Final = (events.DocumentEndEvent, yaml.DocumentEndEvent)
_ALIAS: Final = (events.AliasEvent, yaml.AliasEvent)
_SCALAR: Final = (events.ScalarEvent, yaml.ScalarEvent)
_MAPPING: Final = (events.MappingStartEvent, yaml.MappingStartEvent)
_LIST: Final = (events.SequenceStartEvent, yaml.SequenceStartEvent)
_ENDS: Final = (
    *(events.MappingEndEvent, events.SequenceEndEvent),
    *(yaml.MappingEndEvent, yaml.SequenceEndEvent),
)
_YAML_TAG: Final = "tag:yaml.org,2002:"
_TYPES: Final = " (crane_types, sling_defaults and their like say once what many share)"


class TextNode(str):
    """A scalar as written, with its line."""

    line: int


class ListNode(list[Any]):
    """A list with its line."""

    line: int


class MapNode(dict[str, Any]):
    """A mapping with its line and the line of each key.

    Attributes:
        line: line of the mapping's start, from 1.
        key_lines: line of each key.
        allowed: keys that the model which read this mapping knows; set while it is validated.
        explained: what such a key says, in words; set alike.
        what: what that model is called in messages.
        elsewhere: where in the file that stands which a type gave to this mapping, by key.
        file: the library in which it stands; none of what stands in the lift file.
        beside: of a whole lift file what its libraries say, as comments.
    """

    line: int
    key_lines: dict[str, int]
    elsewhere: Mapping[str, tuple[PathPart, ...]] = MappingProxyType({})
    file: str | None = None
    beside: str = ""
    allowed: tuple[str, ...] = ()
    explained: Callable[[str], str] | None = None
    what: str = ""


Node = TextNode | ListNode | MapNode


def read_text(path: Path, source: str) -> str:
    """Text of a lift file.

    Raises:
        ScenarioError: if there is no such file, or it is a folder, too large, not readable or not UTF-8.
    """
    note_opened(path)
    try:
        status = path.stat()
    except (OSError, ValueError) as error:
        says = error.strerror if isinstance(error, OSError) else None
        reason = says.lower() if says else "not a usable file name"
        raise _whole(source, f"cannot be read ({reason}); a lift file or its folder is needed") from None
    if not stat.S_ISREG(status.st_mode):
        raise _whole(source, "is not a file; a lift file or its folder is needed")
    try:
        with path.open("rb") as file:
            content = file.read(LARGEST_FILE + 1)
    except OSError as error:
        raise _whole(source, f"cannot be read ({(error.strerror or str(error)).lower()})") from None
    if content.startswith(_HDF5):
        takers = "'gantline check', 'report', 'view', 'export' and 'compare'"
        raise _whole(source, f"is no lift file but a recording; {takers} take recordings")
    if len(content) > LARGEST_FILE:
        size = status.st_size / 1e6
        raise _whole(source, f"has {size:.1f} MB; a lift file has at most {LARGEST_FILE / 1e6:.0f} MB")
    kind = next((what for begin, what in _OTHER_KINDS.items() if content.startswith(begin)), None)
    if kind is not None:
        raise _whole(source, f"is no lift file but {kind}; a lift file is plain text")
    if content.startswith(_UTF_16) or content[:2].count(0) == 1:
        raise _whole(source, "looks like UTF-16, two bytes for each letter; save the file as UTF-8")
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        if len(content.translate(None, _IN_NO_TEXT)) < len(content):
            raise _whole(source, "is no text but a binary file; a lift file is plain text") from None
        raise ScenarioError(source, [_not_utf_8(content, error.start)]) from None


def parse_text(text: str, source: str, sections: Collection[str] = ()) -> MapNode:
    """Tree of a YAML text.

    Args:
        text: the text.
        source: the file that messages name.
        sections: keys of the whole mapping, of which it is told where they stand too far in with nothing.

    Raises:
        ScenarioError: if it is not YAML, is not a mapping, or uses what lift files do not have: aliases,
            tags, several documents, duplicate keys.
    """
    found = _by_libyaml(text, source)
    return _in_python(text, source, sections) if found is None else found


def _by_libyaml(text: str, source: str) -> MapNode | None:
    """The tree of an ordinary text in a twentieth of the time; none where anything is wrong or seldom.

    Of an error it says less than ruamel.yaml, whose word counts.
    """
    loader = getattr(yaml, "CBaseLoader", None)  # PyYAML may come without libyaml
    if loader is None or _SELDOM.search(text):
        return None
    builder = _Builder(source, text)
    try:
        for event in yaml.parse(text, Loader=loader):
            builder.take(event)
        return builder.finish()
    except (yaml.YAMLError, ValueError):
        return None


def _in_python(text: str, source: str, sections: Collection[str]) -> MapNode:
    """The tree of whatever text, by ruamel.yaml, and what is wrong with it."""
    builder = _Builder(source, text, sections)
    try:
        for event in YAML(typ="safe", pure=True).parse(text):
            builder.take(event)
    except ReaderError as error:
        line = text.count("\n", 0, error.position) + 1
        raise ScenarioError(
            source, [Problem(line, "", "a character that YAML does not allow; save the file as plain text")]
        ) from None
    except MarkedYAMLError as error:
        raise ScenarioError(source, [problem_of(error, text)]) from None
    except (YAMLError, ValueError, OverflowError) as error:
        if isinstance(error, ScenarioError):
            raise
        raise _whole(source, f"not YAML: {shorten(str(error))}; check indentation and brackets") from None
    return builder.finish()


def line_of(tree: MapNode, path: tuple[PathPart, ...]) -> int:
    """Line of the thing at a path, or of the deepest part of the path that exists."""
    node: Any = tree
    line = tree.line
    for part in path:
        if isinstance(node, MapNode) and part in node:
            line = node.key_lines[str(part)]
            node = node[str(part)]
        elif isinstance(node, ListNode) and isinstance(part, int) and part < len(node):
            node = node[part]
            line = node.line
        else:
            break
    return line


def problem_at(tree: MapNode, path: tuple[PathPart, ...], sentence: str, line: int | None = None) -> Problem:
    """A problem at a path of a tree, in the line of what is there if no other is given."""
    step = ""
    match path:
        case "plan", int(place), *rest if rest != ["step"]:
            plan = tree.get("plan")
            given = plan[place] if isinstance(plan, ListNode) and place < len(plan) else None
            name = given.get("step") if isinstance(given, MapNode) else None
            step = str(name) if isinstance(name, TextNode) else ""
    written = written_at(tree, path)
    line = line_of(tree, path) if line is None else line
    return Problem(line, join_path(written), sentence, step, _file_of(tree, written))


def _file_of(tree: MapNode, path: tuple[PathPart, ...]) -> str | None:
    """The library in which a thing stands; none of what stands in the lift file."""
    section = tree.get(str(path[0])) if path else None
    thing = section.get(str(path[1])) if isinstance(section, MapNode) and len(path) > 1 else None
    return thing.file if isinstance(thing, MapNode) else None


def written_at(tree: MapNode, path: tuple[PathPart, ...]) -> tuple[PathPart, ...]:
    """Where in the file that stands which is at a path of the tree: in a type what a type has given."""
    node: Any = tree
    written: tuple[PathPart, ...] = ()
    for part in path:
        moved = node.elsewhere.get(str(part)) if isinstance(node, MapNode) else None
        written = (*written, part) if moved is None else moved
        is_there = (isinstance(node, MapNode) and part in node) or (
            isinstance(node, ListNode) and isinstance(part, int) and part < len(node)
        )
        node = node[part] if is_there else None
    return written


def like(node: MapNode, parts: Mapping[str, Any]) -> MapNode:
    """A mapping in the place of another one, with other parts; what a validation noted is left behind."""
    made = MapNode(parts)
    made.line, made.key_lines = node.line, {key: node.key_lines.get(key, node.line) for key in parts}
    made.file, made.beside = node.file, node.beside
    return made


def texts(node: Node) -> Iterator[str]:
    """Every text in a tree that is no key."""
    if isinstance(node, str):
        yield node
    else:
        for part in node.values() if isinstance(node, dict) else node:
            yield from texts(part)


def _not_utf_8(content: bytes, at: int) -> Problem:
    """What is wrong with a byte, and the letter that it is to Windows of Western Europe, if it is one."""
    line = content.count(b"\n", 0, at) + 1
    sentence, letters = f"byte {at + 1} is not UTF-8 text", content[at : at + 1].decode("cp1252", "ignore")
    if letters.isprintable() and letters:
        words = content.split(b"\n")[line - 1].decode("cp1252", "replace").split()
        word = next(word for word in words if letters in word)
        sentence += f"; it looks like Windows-1252, '{letters}' in '{shorten(word)}'"
    return Problem(line, "", f"{sentence}; save the file as UTF-8")


def _whole(source: str, sentence: str) -> ScenarioError:
    return ScenarioError(source, [Problem(None, "", sentence)])


class _Builder:
    """Builds the tree from events; keeps open collections on a stack of its own."""

    def __init__(self, source: str, text: str, sections: Collection[str] = ()) -> None:
        self.source = source
        self.text = text
        self.sections = sections
        self.root: Node | None = None
        self.stack: list[MapNode | ListNode] = []
        self.keys: list[TextNode | None] = []  # the key that waits for its value, for each open collection
        self.documents = 0
        self.problems: list[Problem] = []

    def take(self, event: Any) -> None:
        line = event.start_mark.line + 1
        if isinstance(event, _DOCUMENT):
            self.documents += 1
            if self.documents > 1:
                raise self._stop(line, "a second YAML document begins here; a lift file holds one")
        elif isinstance(event, _ALIAS):
            raise self._stop(
                line, f"the alias '*{shorten(event.anchor)}' is not allowed; write the value out{_TYPES}"
            )
        elif isinstance(event, _SCALAR + _MAPPING + _LIST):
            self._refuse_decoration(event, line)
            self._begin(event, line)
        elif isinstance(event, _ENDS):
            self.stack.pop()
            self.keys.pop()
            if self.keys:
                self.keys[-1] = None
        elif isinstance(event, _DOCUMENT_ENDS) and self.stack:  # pragma: no cover - parsers refuse this
            raise self._stop(line, "not YAML: the file ends too early")

    def finish(self) -> MapNode:
        if self.problems:
            raise ScenarioError(self.source, self.problems)
        if self.root is None or (isinstance(self.root, TextNode) and not self.root.strip()):
            raise _whole(self.source, "is empty; a lift file begins with 'format: 1'")
        if not isinstance(self.root, MapNode):
            kind = "a list" if isinstance(self.root, ListNode) else f"the text '{shorten(self.root)}'"
            raise self._stop(
                self.root.line, f"found {kind}; a lift file is a mapping that begins with 'format: 1'"
            )
        return self.root

    def _refuse_decoration(self, event: Any, line: int) -> None:
        if event.anchor is not None:
            raise self._stop(
                line, f"the anchor '&{shorten(event.anchor)}' is not allowed; write the value out{_TYPES}"
            )
        if event.tag is not None:
            tag = shorten(str(event.tag).replace(_YAML_TAG, "!!"))
            other = (
                "" if tag != "!include" else ", or 'library: FILE' for types, ropes and shackles of a file"
            )
            raise self._stop(line, f"the tag '{tag}' is not allowed; write the plain value{other}")

    def _begin(self, event: Any, line: int) -> None:
        if isinstance(event, _SCALAR):
            text = TextNode(event.value)
            text.line = line
            if found := _NO_TEXT.search(text):
                escaped = f"the escape of U+{ord(found[0]):04X}"
                sentence = f"{escaped} is not allowed, which is no character of a text; write the text itself"
                raise self._stop(line, sentence)
            if self.stack and isinstance(self.stack[-1], MapNode) and self.keys[-1] is None:
                self._key(text)
                return
            is_plain = not event.style and bool(self.stack)
            if text == "" and is_plain:
                self._empty(line)
            elif is_plain and (found := _NUMBERED.match(self.text, event.end_mark.index)):
                self._numbered(text, found[0].strip())
            self._place(text)
            return
        if self.stack and isinstance(self.stack[-1], MapNode) and self.keys[-1] is None:
            raise self._stop(line, "a list or mapping stands where a key is needed; a key is a plain name")
        if len(self.stack) >= _DEEPEST:
            raise self._stop(line, f"nested more than {_DEEPEST} deep; a lift file needs far less")
        node: MapNode | ListNode
        if isinstance(event, _MAPPING):
            node = MapNode()
            node.key_lines = {}
        else:
            node = ListNode()
        node.line = line
        self._place(node)
        self.stack.append(node)
        self.keys.append(None)

    def _key(self, key: TextNode) -> None:
        mapping = self.stack[-1]
        assert isinstance(mapping, MapNode)
        if key == "<<":
            raise self._stop(key.line, f"the merge key '<<' is not allowed; write the values out{_TYPES}")
        if key in mapping:
            first = mapping.key_lines[key]
            sentence = f"'{shorten(key)}' is given twice (first in line {first}); each name stands once"
            self._note(key.line, sentence)
        mapping.key_lines.setdefault(key, key.line)
        self.keys[-1] = key

    def _empty(self, line: int) -> None:
        key = self.keys[-1]
        if key is not None:
            sentence = "nothing is given here; write a value or leave the key out"
            if len(self.stack) == 2 and key in self.sections:
                sentence += f" (is '{key}' a section of the file? then it stands too far in)"
            elif ":" in key:
                sentence += " (a ':' needs a blank behind it)"
            elif _THOUSANDS.match(key):  # so is `{mass: 26,000 kg}`
                whole = self._before_the_comma(key)
                is_known = _WHOLE.fullmatch(whole) is not None
                right = f"{whole}{key}, or {whole}.{key}" if is_known else "26000 kg, or 26.5 m"
                sentence += f" (a comma within a number? write {shorten(right)})"
            elif key[:1].isdigit() and not _IN_WORDS.search(whole := self._before_the_comma(key)):
                # `{length: 26,0 m}` is two keys to YAML, and so is `{title: Model, 1 to 50}`.
                right = f"{whole}.{key}" if _WHOLE.fullmatch(whole) else "a point, such as 26.5 m"
                sentence += f" (a decimal comma? write {shorten(right)})"
            else:
                # `{title: one, two}` is two keys, too, and `{from hook}` is one.
                before = self._before_the_comma(key)
                hints = [
                    *(["several go into a list, [A, B]"] if before else []),
                    *(["a text with a comma in it stands in quotes"] if before else []),
                    *([f"is a ':' missing behind '{key.split()[0]}'?"] if _KEY_AND_VALUE.match(key) else []),
                ]
                sentence += f" ({'; '.join(hints)})" if hints else ""
            self._note(key.line, sentence, key)
        else:
            self._note(line, "an item of the list is empty; write a value or remove it")

    def _numbered(self, text: TextNode, comment: str) -> None:
        key = self.keys[-1]
        quoted = f'"{shorten(f"{text} {comment}")}"'
        sentence = (
            f"'{comment}' behind a blank is a comment to YAML, and no part of '{shorten(text)}'; "
            f"put the text into quotes, {quoted}, or a blank behind the '#' of a comment"
        )
        self._note(text.line, sentence, *([key] if key is not None else []))

    def _before_the_comma(self, key: TextNode) -> str:
        """The text of the key that stands before this one in its line; empty where none does."""
        mapping = self.stack[-1]
        if not isinstance(mapping, MapNode):
            return ""
        before = [other for other, line in mapping.key_lines.items() if line == key.line and other != key]
        value = mapping.get(before[-1]) if before else None
        return str(value) if isinstance(value, TextNode) else ""

    def _place(self, node: Node) -> None:
        if not self.stack:
            self.root = node
            return
        parent = self.stack[-1]
        if isinstance(parent, ListNode):
            parent.append(node)
            return
        key = self.keys[-1]
        assert key is not None
        parent.setdefault(str(key), node)
        if isinstance(node, TextNode):
            self.keys[-1] = None  # that of a collection stays until its end, for paths

    def _note(self, line: int, sentence: str, *last: str) -> None:
        """A problem of what is built, or of a part of it."""
        parts: list[PathPart] = []
        for node, key in zip(self.stack[:-1], self.keys[:-1], strict=True):
            parts.append(len(node) - 1 if isinstance(node, ListNode) else str(key))
        root = self.root if isinstance(self.root, MapNode) else MapNode()
        self.problems.append(problem_at(root, (*parts, *last), sentence, line))

    def _stop(self, line: int, sentence: str) -> ScenarioError:
        return ScenarioError(self.source, [*self.problems, Problem(line, "", sentence)])
