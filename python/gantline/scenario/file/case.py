"""Cases: what may be otherwise than planned. Each is the lift with one change, and has its own statics."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any, ClassVar, Final, Literal

from pydantic import Field, model_validator
from pydantic.json_schema import JsonSchemaValue

from gantline.scenario.base import Element
from gantline.scenario.errors import nearest
from gantline.scenario.file.tree import ListNode, MapNode, Node, TextNode
from gantline.scenario.quantities import Names, Reader, Text, Time, found, refuse

__all__ = ["ENVELOPE", "TOLERANCE", "Case", "Pattern"]

#: What a case may vary by margins that the lift file names.
ENVELOPE: Final = "load.centre_of_gravity.envelope"
TOLERANCE: Final = "slings.tolerance"

Pattern = Literal["each", "worst", "worst_pair"]


@dataclass(frozen=True)
class ChangesReader(Reader):
    """Reads a mapping of dotted paths to what shall stand there."""

    def read(self, value: object) -> dict[str, Node]:
        """What shall stand at each path, as written."""
        if not isinstance(value, MapNode) or not value:
            right = "{load.weight.simulate: design}"
            raise refuse(f"found {found(value)}; a mapping of paths to values is needed, such as {right}")
        return dict(value)

    def shown(self) -> JsonSchemaValue:
        """A mapping of anything."""
        return {"type": "object", "minProperties": 1}


@dataclass(frozen=True)
class VariedReader(Reader):
    """Reads what is varied: margins by their name, or a mapping of dotted paths to lists of offsets."""

    def read(self, value: object) -> str | dict[str, tuple[str, ...]]:
        """The margins, or the offsets of each path as written."""
        if isinstance(value, TextNode):
            if value not in (ENVELOPE, TOLERANCE):
                right = "a mapping such as {cranes.hook.at.z: [-0.2 m, 0.2 m]}"
                sentence = f"{found(value)} has no margins; offsets of a quantity are {right}"
                raise refuse(f"{sentence}; {nearest(value, (ENVELOPE, TOLERANCE))}")
            return str(value)
        if not isinstance(value, MapNode) or not value:
            raise refuse(
                f"found {found(value)}; '{ENVELOPE}', '{TOLERANCE}' or a mapping of offsets is needed"
            )
        return {path: _offsets(path, given) for path, given in value.items()}

    def shown(self) -> JsonSchemaValue:
        """The two words, or a mapping of lists."""
        offset: JsonSchemaValue = {"type": ["string", "number"]}
        offsets = {"type": "array", "items": offset, "minItems": 1}
        mapping = {"type": "object", "minProperties": 1, "additionalProperties": offsets}
        return {"anyOf": [{"enum": [ENVELOPE, TOLERANCE]}, mapping]}


def _offsets(path: str, given: object) -> tuple[str, ...]:
    if not isinstance(given, ListNode) or not given or not all(isinstance(one, TextNode) for one in given):
        raise refuse(f"found {found(given)}; a list of offsets is needed, such as [-0.2 m, 0.2 m]", path)
    return tuple(str(one) for one in given)


class Case(Element):
    """The lift with one change: something set, something varied, or ropes cut."""

    what: ClassVar[str] = "a case"

    changes: Annotated[dict[str, Any] | None, ChangesReader()] = Field(
        None, alias="set", description="What shall stand at dotted paths of this file."
    )
    vary: Annotated[str | dict[str, tuple[str, ...]] | None, VariedReader()] = Field(
        None,
        description=f"What is varied: '{ENVELOPE}' with 'corners', '{TOLERANCE}' with 'pattern', or offsets "
        "to quantities by dotted path, such as {cranes.hook.at.z: [-0.2 m, 0.2 m]}; of several paths all "
        "combinations.",
    )
    corners: Literal["all"] | None = Field(
        None, description="'all': the centre of gravity in each corner of its envelope."
    )
    pattern: Pattern | None = Field(
        None,
        description="Which slings are long and short: 'each' by itself, 'worst' for each sling, or the "
        "'worst_pair'.",
    )
    cut: Names = Field((), description="Sling or slings, or ropes of 'mechanics', that are cut.")
    at: Time | None = Field(None, description="cut: when.")
    at_step: Text | None = Field(None, description="cut: as this step of the plan begins.")
    after: Time | None = Field(None, description="cut: how long after 'at_step'.")
    remark: Text | None = Field(None, description="A remark for people.")

    @model_validator(mode="after")
    def _is_one_change(self) -> Case:
        given = [key for key in ("set", "vary", "cut") if _is_given(self, key)]
        if len(given) != 1:
            listed = " and ".join(f"'{key}'" for key in given) or "none of them"
            raise refuse(f"a case has one of 'set', 'vary' and 'cut'; found {listed}")
        for key, right in (("corners", ENVELOPE), ("pattern", TOLERANCE)):
            stands = getattr(self, key) is not None
            if stands and self.vary != right:
                own = {ENVELOPE: "'corners'", TOLERANCE: "'pattern'"}
                meant = own.get(self.vary) if isinstance(self.vary, str) else None
                here = "" if meant is None else f"; beside 'vary: {self.vary}' stands {meant}"
                raise refuse(f"'{key}' belongs to 'vary: {right}'{here}", key)
            if not stands and self.vary == right:
                words = "'all'" if key == "corners" else "'each', 'worst' or 'worst_pair'"
                raise refuse(f"'{key}' is missing; beside 'vary: {right}' it says {words}", "vary")
        for key in ("at", "at_step", "after"):
            if getattr(self, key) is not None and not self.cut:
                raise refuse(f"'{key}' belongs to 'cut'", key)
        if self.after is not None and self.at_step is None:
            raise refuse(
                "'after' stands without 'at_step', the step of the plan from which it counts", "after"
            )
        if self.at is not None and self.at_step is not None:
            raise refuse("'at' and 'at_step' stand together; a cut has one time", "at")
        return self


def _is_given(case: Case, key: str) -> bool:
    return bool(case.changes if key == "set" else getattr(case, key))
