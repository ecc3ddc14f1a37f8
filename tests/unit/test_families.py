"""Many ropes in few colours: families, and what plots say of each."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from matplotlib.figure import Figure

from gantline.plot import figures
from gantline.results.recording import Recording
from gantline.results.rig import Rig
from gantline.results.ropes.families import MOST, families
from gantline.viewer.curves import curves
from gantline.viewer.decimate import peaks
from sample_lift import ringing_lift, sample_rig


def rig_with(cranes: int, each: int) -> Rig:
    """So many cranes, each with an equalizer of two slings, and falls of so many ropes."""
    names = [f"h{place}" for place in range(cranes)]
    parts = [f"{rope}/{part}" for rope in range(each) for part in (0, 1)]
    return Rig.from_json(
        {
            "hooks": [{"name": name, "falls": [f"hoist.{name}.{part}" for part in parts]} for name in names],
            "equalizers": [
                {"name": f"e.{name}", "body": name, "slings": [f"sling.{name}"], "equalizing_rope": rope}
                for name, rope in ((name, f"eq.{name}") for name in names)
            ],
            "slings": [
                *({"name": name, "rope": f"sling.{name}"} for name in names),
                {"name": "alone", "rope": "sling.alone", "from": "h0"},
            ],
            "mooring_lines": [{"name": "bow", "rope": "mooring.bow"}],
        }
    )


def ropes_of(rig: Rig) -> list[str]:
    falls = {fall.rpartition("/")[0]: None for hook in rig.hooks for fall in hook.falls}
    return [one.rope for one in rig.slings] + list(falls) + ["eq.h0", "mooring.bow", "tag"]


def test_ropes_belong_to_what_they_hang_from() -> None:
    rig = rig_with(1, 2)
    assert families(rig, ropes_of(rig)) == {
        "sling.h0": "slings of e.h0",
        "sling.alone": "slings of h0",
        "hoist.h0.0": "hoist ropes of h0",
        "hoist.h0.1": "hoist ropes of h0",
        "eq.h0": "equalizing ropes",
        "mooring.bow": "mooring lines",
        "tag": "other ropes",
    }


@pytest.mark.parametrize(("cranes", "slings", "falls"), [(1, 2, 1), (3, 4, 1), (9, 1, 1)])
def test_families_are_no_more_than_colours(cranes: int, slings: int, falls: int) -> None:
    """Falls give way first, then slings."""
    rig = rig_with(cranes, 2)
    found = set(families(rig, ropes_of(rig)).values())
    assert len(found) <= MOST
    assert sum(one.startswith("slings") for one in found) == slings
    assert sum(one.startswith("hoist") for one in found) == falls


def many_slings() -> Recording:
    """The ringing lift whose rig has each of its five slings under twice as many names."""
    rig: dict[str, Any] = sample_rig()
    rig["slings"] += [{**sling, "name": f"{sling['name']} again"} for sling in rig["slings"]]
    return ringing_lift(rig=rig)


def sling_tension(recording: Recording) -> Figure:
    return dict(figures(recording))["sling_tension"]


def test_a_plot_of_many_ropes_says_which_is_highest_and_when() -> None:
    """S2 carries 1.01 of 700 kN at the top of its ringing, which a sample misses by 0.03 %."""
    figure = sling_tension(many_slings())
    legend = figure.axes[0].get_legend()
    assert legend is not None
    (entry,) = [text.get_text() for text in legend.get_texts()]
    assert entry.startswith("slings of e1, highest S2")
    assert "706.8 kN at " in entry
    lines = {str(line.get_label()): line for line in figure.axes[0].get_lines()}
    widths = [float(lines[name].get_linewidth()) for name in ("S2", "S1")]
    assert widths[0] > 2 * widths[1]


def test_few_ropes_have_colours_of_their_own() -> None:
    lines = sling_tension(ringing_lift()).axes[0].get_lines()
    named = {str(line.get_color()) for line in lines if str(line.get_label()).startswith("S")}
    assert len(named) == 5


def test_names_of_any_length_leave_room_for_the_curves() -> None:
    rig: dict[str, Any] = sample_rig()
    longer = " of a crane with a long name"
    rig["slings"] = [{**sling, "name": sling["name"] + longer} for sling in rig["slings"]]
    figure = sling_tension(ringing_lift(rig=rig))
    figure.draw_without_rendering()
    assert figure.axes[0].get_position().width > 0.7


def test_the_page_knows_families_and_peaks_of_all_steps_and_spread_only_while_clear() -> None:
    recording = ringing_lift()
    found = {(one.group, one.name): one for one in curves(recording)}
    assert found["tension", "sling.S2"].family == "slings of e1"
    assert found["tension", "sling.S2"].peak is not None
    assert found["travel", "e1.1"].family == "e1"
    spread = found["spread", "e1"].values
    assert np.isnan(spread[recording.time < 10.0]).all()
    assert np.isfinite(spread[recording.time > 10.0]).all()


def test_peaks_are_kept_beside_what_is_not_known() -> None:
    values = np.full(5000, np.nan)
    values[2501:] = 1.0
    values[2503] = 7.0
    values[2507] = -3.0
    assert {2503, 2507} <= set(peaks(values, 20).tolist())
