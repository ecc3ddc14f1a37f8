"""Strengths and rules that a lift is checked by, as a recording carries them; all numbers are SI."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from typing import Any, Self

from gantline.results.file.form import Range, Vector
from gantline.rule_data import SIDE_LOAD, SIDE_LOAD_SOURCE


class FromJson:
    """Dataclasses that are made from a JSON object and pass over keys that they do not know."""

    @classmethod
    def from_json(cls, document: Mapping[str, Any]) -> Self:
        """Make one from its JSON object."""
        known = {f.name for f in fields(cls)}  # type: ignore[arg-type]
        return cls(**{key: value for key, value in document.items() if key in known})


@dataclass(frozen=True)
class Rating(FromJson):
    """A rated capacity of a hook, or of a trolley or crane for all hooks that it bears.

    Attributes:
        name: Of hook, trolley or crane.
        level: `hook`, `trolley` or `crane`.
        hooks: The hooks.
        rated_capacity: For all of them together [N]; None if not said.
        includes_hook_block: Whether it is for the hoist load, else for the hook load.
    """

    name: str
    level: str
    hooks: Sequence[str] = ()
    rated_capacity: float | None = None
    includes_hook_block: bool = False


@dataclass(frozen=True)
class Lug(FromJson):
    """Where a sling is made fast on a load or a spreader.

    Attributes:
        at: Position from the centre of gravity, axes of the body [m].
        main_plate_normal: Unit vector across the main plate, body frame; None if not said.
        capacity: What it may carry [N]; None if not said.
        plate_is_assumed: Whether the lift file does not say how the main plate stands.
    """

    at: Vector
    main_plate_normal: Vector | None = None
    capacity: float | None = None
    plate_is_assumed: bool = False


@dataclass(frozen=True)
class HasLugs(FromJson):
    """What has `lugs` by name: a load, a spreader."""

    @classmethod
    def from_json(cls, document: Mapping[str, Any]) -> Self:
        """Make one from its JSON object."""
        lugs = {name: Lug.from_json(lug) for name, lug in document.get("lugs", {}).items()}
        return super().from_json({**document, "lugs": lugs})


@dataclass(frozen=True)
class Shackle(FromJson):
    """A shackle at one end of a sling.

    Attributes:
        name: Its kind.
        working_load_limit: In line [N]; None if not said.
        minimum_breaking_force: [N]; None if not said.
        proof_load: Documented proof load [N]; None if not said.
        bow_diameter: Of the bow where the eye of the sling lies [m]; None if not said.
        pin_diameter: Of the pin [m]; None if not said.
    """

    name: str
    working_load_limit: float | None = None
    minimum_breaking_force: float | None = None
    proof_load: float | None = None
    bow_diameter: float | None = None
    pin_diameter: float | None = None


@dataclass(frozen=True)
class Bend(FromJson):
    """The smallest sheave or drum that a rope runs over.

    Attributes:
        rope: The rope.
        element: Sheave or drum.
        diameter: Its pitch diameter [m].
    """

    rope: str
    element: str
    diameter: float


@dataclass(frozen=True)
class Factor(FromJson):
    """A factor of the rule that a lift is checked by.

    Attributes:
        value: [1].
        source: Where it comes from.
    """

    value: float
    source: str = ""


@dataclass(frozen=True)
class SideLoad(FromJson):
    """What side load leaves of a shackle's working load limit; Crosby's chart where nobody has another.

    Attributes:
        rows: Largest angle [rad] and what remains [1] of each row, small angles first.
        source: Where the chart comes from.
    """

    rows: Sequence[Range] = SIDE_LOAD
    source: str = SIDE_LOAD_SOURCE
