"""What tables say of hinges and grippers in which loads turn."""

from __future__ import annotations

from gantline.checks import values_of
from gantline.cli.table import pairs, show, table
from gantline.results.loads.hinge_peaks import in_words
from gantline.results.loads.hinges import HINGE_WAYS, Hinge, hinge_force, hinge_moment, is_shut
from gantline.results.recording import Recording


def hinge_table(recording: Recording, hinge: Hinge) -> list[str]:
    """What a hinge bears over a run, and when it opens."""
    used = values_of(recording, "hinge_force_of_rated_capacity").get(hinge.name)
    return pairs(f"Hinge {hinge.name}", in_words(recording, hinge, used))


def hinges_at_rest(recording: Recording) -> list[str]:
    """What loads do at rest to the hinges that hold them, along the axes of these."""
    rows = [
        (
            hinge.name,
            show(float(hinge_force(recording, hinge)[-1]), "kN", 1),
            *(show(float(part), "kN", 1) for part in recording.column("hinge_push", hinge.name)[-1]),
            show(float(hinge_moment(recording, hinge)[-1]), "kN m", 1),
        )
        for hinge in recording.rig.hinges
        if is_shut(recording, hinge)[-1]
    ]
    return table(("Hinge", "force", *HINGE_WAYS, "moment"), rows, "lrrrrr") if rows else []
