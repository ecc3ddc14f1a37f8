"""Slings of each equalizer in a panel of its own, as Fig. 21 of the paper has them."""

from __future__ import annotations

from matplotlib.figure import Figure

from gantline.plot.style import KILO, curves, label_ends, time_figure
from gantline.results.recording import Recording


def slings(recording: Recording) -> Figure | None:
    """Tension of the slings of every equalizer, a panel for each; None with fewer than two equalizers."""
    rig = recording.rig
    equalizers = [equalizer for equalizer in rig.equalizers if equalizer.slings]
    if len(equalizers) < 2:
        return None
    names = {sling.rope: sling.name for sling in rig.slings}
    heights = [1.0] * len(equalizers)
    figure, panels = time_figure(recording, "Slings by equalizer", heights, 1.4 + 1.8 * len(equalizers))
    for equalizer, panel in zip(equalizers, panels, strict=True):
        tensions = {
            names.get(rope, rope): recording.column("rope_tension", rope) / KILO for rope in equalizer.slings
        }
        curves(panel, recording.time, tensions)
        highest = max(float(tension.max()) for tension in tensions.values())
        panel.set_ylim(0.0, 1.18 * highest if highest > 0.0 else 1.0)  # room for 'lift-off'
        panel.set_ylabel(f"{equalizer.name}:\ntension [kN]")
        label_ends(panel, recording.time, tensions)
    figure.align_ylabels(panels)
    return figure
