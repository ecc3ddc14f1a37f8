"""What tables say of slings: of each one what it carries, how it leans, and what it uses of its gear."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from gantline.checks.run import values_of
from gantline.results import series
from gantline.results.gear import Sling
from gantline.results.recording import Recording
from gantline.results.ropes import upper_end

__all__ = ["SlingFigures", "sling_figures"]


@dataclass(frozen=True)
class SlingFigures:
    """What a sling carries, and of what.

    Attributes:
        sling: The sling.
        static: Its static tension, where that is largest [N]; None if the loads never hung still.
        static_angle: Its mean angle from the vertical then [rad]; None as above.
        peak: Largest tension over all steps [N].
        peak_time: When that was [s].
        least_clear: Smallest tension while the loads are clear and it is on [N]; None if that never is.
        largest_angle: Largest angle from the vertical while it carries [rad]; None if it never does.
        of_breaking_force: Peak at its upper end over its minimum breaking force [1]; None if not known.
        of_working_load_limit: Of its shackles, the largest [1]; None of none.
        of_lug_capacity: Of the lugs that it is made fast to, the largest [1]; None if not known.
        out_of_plane: Largest angle to the main plate of one of them [rad]; None if not known.
    """

    sling: Sling
    static: float | None
    static_angle: float | None
    peak: float
    peak_time: float
    least_clear: float | None
    largest_angle: float | None
    of_breaking_force: float | None
    of_working_load_limit: float | None
    of_lug_capacity: float | None
    out_of_plane: float | None


def sling_figures(recording: Recording, slings: Iterable[Sling]) -> list[SlingFigures]:
    """Figures of slings of a recording, in their order; of a lift at rest those of its last sample."""
    shackles = values_of(recording, "shackle_load_of_working_load_limit")
    lugs = values_of(recording, "lug_load_of_capacity")
    aside = values_of(recording, "lug_out_of_plane_angle")
    every = series.everywhere(recording)
    clear = series.is_clear(recording) & every
    found = []
    for sling in slings:
        tension, angle = series.sling_tension(recording, sling), series.sling_angle(recording, sling)
        static, window = series.greatest_static(recording, tension)
        peak, time = series.rope_peak(recording, sling.rope)
        carrying = series.is_carrying(tension) & every
        counts = clear & series.is_on(recording, sling.rope)
        at_lugs = [f"{of}.{lug}" for _, of, lug in sling.at_lugs()]
        found.append(
            SlingFigures(
                sling=sling,
                static=static,
                static_angle=series.static_value(recording, angle, window),
                peak=peak,
                peak_time=time,
                least_clear=float(tension[counts].min()) if counts.any() else None,
                largest_angle=float(angle[carrying].max()) if carrying.any() else None,
                of_breaking_force=upper_end.utilisation(recording, sling.rope),
                of_working_load_limit=_most(shackles, (f"{sling.name} {end}" for end in sling.shackles)),
                of_lug_capacity=_most(lugs, at_lugs),
                out_of_plane=_most(aside, at_lugs),
            )
        )
    return found


def _most(values: Mapping[str, float], names: Iterable[str]) -> float | None:
    return max((values[name] for name in names if name in values), default=None)
