"""Chunks of a recording that were compressed to other bytes now and then.

ISA-L made of the same numbers, in busy processes, another stream of the same content: 17 bytes of four
megabytes, once in dozens of runs of the test of two processes. What zlib makes depends on nothing else.
"""

from __future__ import annotations

import zlib

import numpy as np

from gantline.results.file.netcdf import _LEVEL, _filtered

ROWS, WIDTH = 300, 400


def test_a_chunk_is_what_zlib_makes_of_its_bytes() -> None:
    """First bytes of all numbers, then second bytes, and so on: the shuffle filter of HDF5."""
    time = np.arange(ROWS)[:, None] * 0.01
    chunk = np.round(np.sin(time * np.linspace(1.0, 3.0, WIDTH)) + np.arange(WIDTH), 7)
    plain = chunk.astype("<f8").tobytes()
    shuffled = b"".join(plain[place::8] for place in range(8))
    assert _filtered(chunk, ROWS) == zlib.compress(shuffled, _LEVEL)
