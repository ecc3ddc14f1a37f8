"""States of runs as files have them."""

from __future__ import annotations

import json
from typing import Any


def content(state: bytes) -> dict[str, Any]:
    """What a state holds beside its samples: after its first line and the length, 8 bytes, the JSON."""
    rest = state.split(b"\n", 1)[1]
    found: dict[str, Any] = json.loads(rest[8 : 8 + int.from_bytes(rest[:8], "little")])
    return found


def with_digest(state: bytes) -> bytes:
    """A state with the digest of what it has become: 64-bit FNV-1a of all before, in sixteen digits."""
    digest = 0xCBF29CE484222325
    for byte in state[:-16]:
        digest = (digest ^ byte) * 0x100000001B3 % 2**64
    return state[:-16] + f"{digest:016x}".encode()
