"""How vessels lie over time."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from gantline.plot.style import colour, few_ticks, label_ends, time_figure, widen
from gantline.results.recording import Recording


def vessels(recording: Recording) -> Figure | None:
    """Drafts aft and forward, trim, heel, freeboard and waves of every vessel; None without vessels."""
    names = recording.coordinates.get("vessel", ())
    if not names:
        return None
    rows = [
        ("Draft [m]", {"aft": "vessel_draft_aft", "forward": "vessel_draft_forward"}, 1.0, 0.1),
        ("Trim by the\nstern [deg]", {"": "vessel_trim"}, 180.0 / np.pi, 0.1),
        ("Heel to\nstarboard [deg]", {"": "vessel_heel"}, 180.0 / np.pi, 0.1),
        ("Freeboard [m]", {"": "vessel_freeboard"}, 1.0, 0.1),
    ]
    if "vessel_wave_elevation" in recording.variables:
        rows.append(("Waves at\nmidship [m]", {"": "vessel_wave_elevation"}, 1.0, 0.1))
    shares = [1.4, *[1.0] * (len(rows) - 1)]
    figure, panels = time_figure(recording, "Vessels", shares, 2.0 + sum(shares))
    for panel, (label, variables, factor, least_span) in zip(panels, rows, strict=True):
        found = {
            f"{name} {end}".strip(): factor * recording.column(variable, name)
            for name in names
            for end, variable in variables.items()
        }
        for index, curve in enumerate(found.values()):
            panel.plot(recording.time, curve, color=colour(index))
        panel.set_ylabel(label)
        widen(panel, least_span)
        few_ticks(panel)
        label_ends(panel, recording.time, found)
    figure.align_ylabels(panels)
    return figure
