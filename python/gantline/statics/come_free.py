"""What stands for mud or suction, in equilibria: it is gone where it would carry what it comes free at."""

from __future__ import annotations

import json
from collections.abc import Collection, Mapping
from typing import Any

from gantline.results.rig import Rig

__all__ = ["come_free", "without"]


def come_free(rig: Rig, tensions: Mapping[str, float]) -> set[str]:
    """Ropes that stand for mud or suction, and carry at rest what they come free at, or more.

    Args:
        rig: Who carries whom.
        tensions: What ropes carry at rest, by name [N].
    """
    return {
        rope.name
        for rope in rig.ropes
        if rope.comes_free and rope.breaks_at is not None and tensions.get(rope.name, 0.0) >= rope.breaks_at
    }


def without(document: Mapping[str, Any], gone: Collection[str]) -> str:
    """The document of a lift with some ropes cut as it begins, as JSON."""
    ropes = [{**rope, "cut_at": 0.0} if rope["name"] in gone else rope for rope in document["ropes"]]
    return json.dumps({**document, "ropes": ropes}, allow_nan=False)
