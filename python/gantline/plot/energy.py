"""Where the energy of a lift went, and whether its balance closes."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from gantline.plot.style import colour, few_ticks, label_ends, limit_line, time_figure
from gantline.results.metrics import energy_bound
from gantline.results.recording import Recording

_SHOWN_FROM = 1e-4  # of the largest energy; smaller kinds are left out


def energy(recording: Recording) -> Figure | None:
    """Energy by kind over time, and the remainder relative to its bound; None if it was not recorded."""
    if "energy" not in recording:
        return None
    kinds = {kind: recording.column("energy", kind) for kind in recording.coordinates["energy_kind"]}
    remainder = kinds.pop("remainder")
    largest = max(float(np.abs(values).max()) for values in kinds.values())
    scale, unit = _scale(largest)
    shown = {
        kind.replace("_", " "): values / scale
        for kind, values in kinds.items()
        if float(np.abs(values).max()) > _SHOWN_FROM * largest
    }
    figure, panels = time_figure(recording, "Energy", [3.0, 1.0], 4.8)
    for index, values in enumerate(shown.values()):
        panels[0].plot(recording.time, values, color=colour(index))
    panels[0].set_ylabel(f"Energy [{unit}]")
    label_ends(panels[0], recording.time, shown)
    reference = float(np.max(kinds["kinetic"] + kinds["elastic"] + np.abs(kinds["drive_work"])))
    relative = remainder / reference * 100.0 if reference > 0.0 else remainder
    panels[1].plot(recording.time, relative, color="#4D4D4D")
    bound = energy_bound(recording.attributes["settings"]) * 100.0
    reach = 1.5 * max(bound, float(np.abs(relative).max()))
    panels[1].set_ylim(-reach, reach)
    limit_line(panels[1], bound, f"bound {bound:g} %")
    limit_line(panels[1], -bound, "")
    panels[1].set_ylabel("Remainder\n[% of largest]")
    few_ticks(panels[1], 3)
    figure.align_ylabels(panels)
    return figure


def _scale(largest: float) -> tuple[float, str]:
    for scale, unit in ((1e9, "GJ"), (1e6, "MJ"), (1e3, "kJ")):
        if largest >= scale:
            return scale, unit
    return 1.0, "J"
