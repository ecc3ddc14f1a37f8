"""A recording from a stranger: every name and text in it tries to run a script in the page that shows it."""

from __future__ import annotations

from typing import Any

import numpy as np

from gantline.results import Recording, Variable
from sample_lift import sample_recording

#: Ends a script element, begins an image that fails to load, ends an attribute, closes a comment.
EVIL = (
    "<img src=x onerror=globalThis.hacked=1>\"' --></script>"
    "<script>globalThis.hacked=1</script>\u2028{{ 7*7 }}"
)

_KEPT = ("xyz", "wxyz", "energy_kind", "side", "sheave_side", "rope_end")


def hostile_recording() -> Recording:
    """The sample lift with hostile names, title, remark, texts and warnings."""
    time = np.linspace(0.0, 10.0, 101)
    tension = np.linspace(0.0, 500e3, 101)[:, None] + np.zeros((101, 5))
    plain = sample_recording(
        time, tension=tension, events=[(0.0, "step_begin", "hoist"), (2.0, "taut", "sling.S1")]
    )
    names = {label for dim, labels in plain.coordinates.items() if dim not in _KEPT for label in labels}
    names |= {sling.name for sling in plain.rig.slings} | {"hoist", "hold", "L1"}

    def bad(value: Any) -> Any:
        if isinstance(value, str):
            return value + EVIL if value in names else value
        if isinstance(value, dict):
            return {bad(key): bad(one) for key, one in value.items()}
        return [bad(one) for one in value] if isinstance(value, list | tuple) else value

    variables = {
        name: Variable(one.dims, np.array([bad(str(text)) for text in one.values]), one.unit, one.description)
        if one.is_text and name != "event_kind"
        else one
        for name, one in plain.variables.items()
    }
    coordinates = {
        dim: labels if dim in _KEPT else [bad(one) for one in labels]
        for dim, labels in plain.coordinates.items()
    }
    attributes = dict(plain.attributes)
    attributes |= {key: bad(attributes[key]) for key in ("rig", "scene")}
    rig = {**attributes["rig"], "title": f"Lift {EVIL}", "number": EVIL, "revision": EVIL, "remark": EVIL}
    attributes |= {"title": EVIL, "rig": rig, "scenario": f"lift: {EVIL}", "warnings": [EVIL]}
    return Recording(variables, coordinates, attributes)
