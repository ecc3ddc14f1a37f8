"""What the final table says of one compensator."""

from __future__ import annotations

from gantline.cli.table import pairs
from gantline.results.cranes.compensators import in_words
from gantline.results.gear import Compensator
from gantline.results.recording import Recording


def compensator_table(recording: Recording, compensator: Compensator) -> list[str]:
    """Rod, stroke, gas, what hangs below it, pin and stops of a compensator."""
    return pairs(f"Compensator {compensator.name}", in_words(recording, compensator))
