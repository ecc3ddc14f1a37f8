"""A box of 10 t on one sling below a fixed hook: what lifts of several tests have in common."""

from __future__ import annotations


def hung_box(at: str, hook: str, hoist: str, *, size: str = "2 m, 2 m, 2 m", rope: str = "soft") -> str:
    """Sections `load`, `cranes` and `slings` of a lift file; the sling `S` of 5 m leads to the lug `top`.

    Args:
        at: Where the box is, its bottom.
        hook: Where the bearing of the hook is.
        hoist: Its speed and acceleration.
        size: Of the box, 2 m high.
        rope: Of the sling.
    """
    return f"""\
load:
  name: box
  shape: {{box: [{size}]}}
  position: [{at}]
  weight: {{calculated: 10 t}}
  centre_of_gravity: {{at: [0 m, 0 m, 1 m]}}
  lugs: {{top: {{at: [0 m, 0 m, 2 m]}}}}
cranes:
  hook: {{type: fixed_hook, at: [{hook}], hoist: {{{hoist}}}}}
slings: {{S: {{from: hook, to: box.top, length: 5 m, rope: {rope}}}}}
"""
