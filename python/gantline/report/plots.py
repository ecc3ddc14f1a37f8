"""Sections of plots; the page's program draws them from the packed recording."""

from __future__ import annotations

import json
import math
from abc import abstractmethod
from typing import Any

from gantline.report.section import Section
from gantline.report.subject import Subject, show
from gantline.results.loads.aside import drift_of, not_worth_a_plot, swing_of, tilt_of
from gantline.results.loads.drift import is_taken_along
from gantline.results.status import OVER

Plot = dict[str, Any]

_SWING = "Swing of the load: how far its hooks hang aside of their upper sheaves"
_WAVES = "Undisturbed waves amidships, above still water"


class Player(Section):
    """The lift in three dimensions, with the plot of tensions below it."""

    anchor = "player"
    title = "The lift, played"
    template = "player.html"

    def content(self, subject: Subject) -> dict[str, Any] | None:
        """What the template is given."""
        if not len(subject.recording.time) or not (subject.recording.attributes.get("scene") or {}).get(
            "bodies"
        ):
            return None
        return {"in_still_water": subject.rig.moved_in_still_water}


class _Plots(Section):
    template = "plots.html"

    @abstractmethod
    def plots(self, subject: Subject) -> list[Plot]:
        """The plots that this recording has."""

    def content(self, subject: Subject) -> dict[str, Any] | None:
        """What the template is given."""
        found = self.plots(subject) if subject.has_motion else []
        if not found:
            return None
        plots = [{**plot, "spec": json.dumps(plot, allow_nan=False)} for plot in found]
        return {"plots": plots, "missing": self.missing(subject)}

    def missing(self, subject: Subject) -> str:
        """What there is too little of for a plot, in words."""
        return ""


def _plot(title: str, group: str, unit: str, **more: Any) -> Plot:
    return {"title": title, "groups": [group], "unit": unit, **more}


class Tensions(_Plots):
    """Tensions of ropes and what equalizers make of them."""

    anchor = "tensions"
    title = "Tensions and travel"

    def plots(self, subject: Subject) -> list[Plot]:
        """Tension, travel, rods, hinges, lengthening, chain hoists, spread, pins."""
        recording, rig = subject.recording, subject.rig
        found = []
        if recording.coordinates.get("rope"):
            found.append(
                _plot(
                    "Rope tension",
                    "tension",
                    "kN",
                    height=300,
                    smallest=1e-3,
                    peak=True,
                    note=_of_ropes(subject),
                )
            )
        if "sheave_travel" in recording:
            found.append(
                _plot(
                    "Travel of moving sheaves, down positive",
                    "travel",
                    "m",
                    inverted=True,
                    smallest=1e-3,
                    extreme="both",
                    limits=_strokes(subject),
                )
            )
        if "rod_out" in recording:
            stops = _stops(subject)
            title = "Rods of compensators out, 0 at the inner stop"
            found.append(_plot(title, "rods", "m", smallest=1e-3, extreme="both", limits=stops))
        if "hinge_force" in recording:
            found.append(_plot("Force between load and hinge", "hinges", "kN", height=180, smallest=1e-3))
        if "rope_lengthening" in recording:
            found.append(_plot("Lengthening of slings by adjusting", "lengthening", "m", smallest=1e-3))
        if "chain_paid_out" in recording:
            title = "Chain paid out by the hoists of slings, hauled in negative"
            found.append(_plot(title, "chain", "m", smallest=1e-3, extreme="both"))
        if any(equalizer.slings for equalizer in rig.equalizers) and subject.clear.any():
            title = "Tension spread of an equalizer's slings while the load is clear"
            found.append(_plot(title, "spread", "%", height=180, smallest=0.1, zero=True))
        if "pin_force" in recording:
            found.append(_plot("Force on locking pins", "pins", "kN", height=180, smallest=1e-3))
        return found


class HookLoads(_Plots):
    """What hooks carry and supports still bear."""

    anchor = "hooks"
    title = "Hook loads"

    def plots(self, subject: Subject) -> list[Plot]:
        """Hook load, what supports bear, load transferred."""
        found = []
        if subject.rig.hooks and "hook_load" in subject.recording:
            found.append(
                _plot(
                    "Hook load",
                    "hook_load",
                    "kN",
                    height=220,
                    smallest=1.0,
                    peak=True,
                    limits=_ratings(subject),
                )
            )
        if any(load.contacts for load in subject.rig.loads):
            found.append(_plot("What supports bear of a load", "support", "kN", height=180, smallest=1.0))
        if "heave_compensation" in subject.recording:
            title = "Heave compensation, hook raised positive"
            # The drum stays as the curve goes to 0.
            note = "0 once it has ended: the hook stays where it is then."
            found.append(_plot(title, "heave", "m", height=180, smallest=0.01, extreme="both", note=note))
        if "drum_wraps" in subject.recording:
            plot = _plot("Turns of rope on drums", "wraps", "", height=160, smallest=0.1, extreme="smallest")
            found.append(plot)
        return found


class Attitude(_Plots):
    """How loads hang: tilt, drift or swing, height, and the gusts that they hang in."""

    anchor = "attitude"
    title = "Attitude"

    def plots(self, subject: Subject) -> list[Plot]:
        """Tilt, drift or swing, height, gusts; what is less than could be seen has no plot."""
        if not subject.rig.loads or "load_tilt" not in subject.recording:
            return []
        tilt = subject.rig.limits.get("load_tilt")
        limits = [] if not tilt else [{"value": float(tilt) * 180.0 / math.pi, "label": "limit"}]
        drift = "Horizontal drift of the centre of gravity"
        if is_taken_along(subject.rig):
            drift += ", off the way of the plan"
        recording = subject.recording
        # While a lift runs, what is too little for a plot may still come.
        goes_on = not _is_over(subject)
        found = []
        if goes_on or tilt_of(recording):
            found.append(
                _plot("Tilt of the load", "tilt", "deg", height=180, smallest=0.05, zero=True, limits=limits)
            )
        if goes_on or drift_of(recording):
            found.append(_plot(drift, "drift", "m", height=180, smallest=0.01, zero=True))
        if not goes_on and swing_of(recording):
            found.append(_plot(_SWING, "swing", "m", height=180, smallest=0.01, zero=True))
        found.append(
            _plot("Height of the centre of gravity above its start", "height", "m", height=180, smallest=0.01)
        )
        if "wind_at_load" in subject.recording:
            wind = subject.rig.wind
            gusty = ", gusts included" if wind is not None and wind.gusts is not None else ""
            found.append(_plot(f"Wind at the load{gusty}", "wind", "m/s", height=180, smallest=0.1))
        return found

    def missing(self, subject: Subject) -> str:
        """Tilt, drift and swing, where there is none that could be seen."""
        return not_worth_a_plot(subject.recording) if _is_over(subject) else ""


class Vessels(_Plots):
    """How vessels lie: draft, trim, heel, freeboard; and the waves that they meet."""

    anchor = "vessels"
    title = "Vessels"

    def plots(self, subject: Subject) -> list[Plot]:
        """Draft, trim, heel, freeboard, waves."""
        if not subject.rig.vessels:
            return []
        found = [
            _plot("Draft at half length", "draft", "m", height=180, smallest=0.1),
            _plot("Trim, by the stern positive", "trim", "deg", height=180, smallest=0.1),
            _plot("Heel, to starboard positive", "heel", "deg", height=180, smallest=0.1),
            _plot(
                "Least freeboard of deck edge and openings",
                "freeboard",
                "m",
                height=180,
                smallest=0.1,
                extreme="smallest",
            ),
        ]
        if "vessel_wave_elevation" in subject.recording:
            found.append(_plot(_WAVES, "waves", "m", height=180, smallest=0.1))
        return found


class Tanks(_Plots):
    """What is in tanks of loads and vessels."""

    anchor = "tanks"
    title = "Tanks"

    def plots(self, subject: Subject) -> list[Plot]:
        """Contents of those that steps of the plan pump, or with holes."""
        changes = any(step.tanks for step in subject.rig.plan) or any(
            tank.holes for tank in subject.rig.tanks
        )
        if "tank_content" not in subject.recording or not changes:
            return []
        title = "Liquid in tanks of loads and vessels"
        return [_plot(title, "tanks", "t", smallest=0.1, extreme="both")]


class Clearances(_Plots):
    """How near watched pairs come to each other."""

    anchor = "clearance"
    title = "Clearances"

    def plots(self, subject: Subject) -> list[Plot]:
        """Smallest distances."""
        if "clearance" not in subject.recording:
            return []
        limits = [
            {"value": smallest, "label": f"at least {smallest:g} m"}
            for smallest in sorted({watch.smallest for watch in subject.rig.watches if watch.smallest > 0.0})
        ]
        return [
            _plot(
                "Smallest distances of watched pairs",
                "clearance",
                "m",
                height=240,
                smallest=0.1,
                extreme="smallest",
                limits=limits,
            )
        ]


def _is_over(subject: Subject) -> bool:
    return subject.recording.attributes.get("status", "done") in OVER


def _of_ropes(subject: Subject) -> str:
    """What the numbers of a rope are where its segments differ."""
    if not any(sheave.has_losses for sheave in subject.rig.sheaves):
        return ""
    return "Curves are means over the segments of a rope; largest values are those of any segment."


def _strokes(subject: Subject) -> list[dict[str, Any]]:
    """Ends of the strokes, where all equalizers have the same."""
    found = []
    for name, sign in (("travel_up", -1.0), ("travel_down", 1.0)):
        strokes = {getattr(equalizer, name) for equalizer in subject.rig.equalizers}
        if len(strokes) == 1 and (stroke := strokes.pop()) is not None:
            found.append(
                {"value": sign * stroke, "label": f"stroke {name.removeprefix('travel_')} {stroke:g} m"}
            )
    return found


def _stops(subject: Subject) -> list[dict[str, Any]]:
    """Outer stops of compensators, by their strokes."""
    strokes = sorted({one.stroke for one in subject.rig.compensators})
    return [{"value": stroke, "label": f"outer stop {stroke:g} m"} for stroke in strokes]


def _ratings(subject: Subject) -> list[dict[str, Any]]:
    """Rated capacity, of a lift with one hook whose rating leaves the hook block out."""
    hooks = subject.rig.hooks
    if len(hooks) != 1 or not hooks[0].rated_capacity or hooks[0].rating_includes_hook_block:
        return []
    rated = hooks[0].rated_capacity
    return [{"value": rated / 1e3, "label": f"rated capacity {show(rated, 'kN', 0)}"}]
