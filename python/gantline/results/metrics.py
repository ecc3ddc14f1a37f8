"""The lift in key numbers: what each metric means.

All values are SI. A metric that does not exist for a lift (no load, no equalizer, never clear) is absent.
*Clear* and *static* (a mean over that time that the loads hung still at which it is largest) are defined in
`gantline.results.series`.

- `peak_sling_tension`, `peak_sling_tension_time` [N, s]: largest tension of any sling over all steps, and
  when; of a lift at rest there is no when
- `peak_equalizing_rope_tension` [N]: largest tension of any equalizing rope over all steps
- `peak_rope_tension.<rope>` [N]: largest tension of that rope over all steps
- `final_rope_tension.<rope>` [N]: its tension at the last sample
- `utilisation_of_minimum_breaking_force.<rope>` [1]: largest tension at the upper end of that rope over all
  steps, its own weight counted/its minimum breaking force, where that is known
- `peak_utilisation_of_minimum_breaking_force` [1]: the largest of them
- `parted_ropes` [1]: how many ropes were cut or broke; absent where none did, as the next two
- `parting_time.<rope>` [s]: when that rope parted
- `parting_tension.<rope>` [N]: what it carried then
- `attaching_time.<rope>` [s]: when a step put that sling on, the last time
- `detaching_tension.<rope>` [N]: what a rope still carried as a step took it off, the last time
- `static_sling_tension.<sling rope>` [N]: its static tension
- `skew_load_factor` [1]: largest static force of a sling over its force with perfect lengths, as
  `gantline.results.loads.skew` defines it
- `least_sling_tension_when_clear` [N]: smallest tension of any sling while the loads are clear
- `dynamic_amplification_factor` [1]: largest of peak/static tension of the same sling, of those whose peak is
  at a time with slings on on which the loads also hung still; absent of a lift at rest
- `least_factor_on_breaking_force` [1]: smallest of minimum breaking force/peak tension of the same sling at
  its upper end, its own weight counted
- `peak_tension_spread_when_clear` [1]: largest (max - min)/mean over one equalizer's slings while clear
- `final_tension_spread` [1]: the same at the last sample
- `time_to_equalise.<equalizer>` [s]: from when all its slings are taut and its pins out until its tension
  spread stays below `Rig.equalised_below`; absent where it never does and of a lift at rest, see
  `gantline.results.ropes.equalising`
- `peak_pin_force` [N]: largest magnitude of the force on any locking pin at any sample
- `peak_hinge_force.<hinge>` [N]: largest force between that hinge and its load, whichever way, over all
  steps
- `peak_hinge_radial_force.<hinge>`, `peak_hinge_axial_force.<hinge>` [N]: its largest part at right angles to
  the axis of the hinge, and the largest magnitude of that along it
- `peak_hinge_moment.<hinge>` [N m]: largest moment by which it keeps the load from turning askew
- `peak_sling_angle_from_vertical` [rad]: largest angle of a carrying sling from the vertical
- `peak_fleet_angle` [rad]: largest angle of a carrying rope to the plane of a sheave
- `lift_off_time` [s]: when the last contact force under the last load first became zero; absent where all
  hang clear from the start, and of a lift at rest
- `peak_support_force.<support>` [N]: largest force of that support over all steps
- `peak_support_force` [N]: the largest of them
- `smallest_clearance.<pair>` [m]: smallest distance of that watched pair at any sample of its steps; absent
  where its ropes are off, or have parted, at all of them
- `static_hook_load`, `peak_hook_load` [N]: hook load, the largest over the hooks
- `static_hoist_load`, `peak_hoist_load` [N]: hook load with hook block and hanging falls, the largest over
  the hooks
- `rating_utilisation.<crane>` [1]: largest of hoist load (or hook load) over rated load of the chart where
  the hooks were then, of the crane or of one hook by its share, at any sample; absent where a load hung
  outside of the chart
- `tipping_utilisation.<crane>` [1]: largest moment of what hangs over that of a crawler crane's own weight
- `peak_ground_pressure.<crane>` [Pa]: largest pressure on the ground under a crawler crane
- `final_load_transferred` [1]: 1 - forces of supports and hinges/weight at the last sample, 1 at most, the
  smallest over the loads
- `peak_load_tilt` [rad]: largest angle of a load's own z axis from plumb
- `peak_load_yaw` [rad]: largest change of a load's heading from its start, to either side
- `peak_equalizer_tilt` [rad]: largest angle from plumb of the frame of any equalizer that tilts
- `peak_load_drift_when_clear` [m]: largest horizontal distance of a load's centre of gravity, while clear,
  from its start and where the plan has taken it from there (`gantline.results.loads.drift`)
- `final_draft.<vessel>`, `final_draft_aft.<vessel>`, `final_draft_forward.<vessel>` [m],
  `final_heel.<vessel>`, `final_trim.<vessel>` [rad], `final_displacement.<vessel>` [kg]: of that vessel at
  the last sample; heel to starboard, trim by the stern positive
- `peak_heel`, `peak_trim` [rad]: largest magnitude of any vessel at any sample
- `peak_mooring_tension.<line>` [N]: largest tension of that mooring line over all steps
- `peak_mooring_tension_of_breaking_force` [1]: largest of them over the minimum breaking force of its rope,
  where that is known
- `final_mooring_tension.<line>` [N]: its tension at the last sample
- `peak_tag_line_tension.<line>` [N]: largest tension of that tag line over all steps
- `peak_fender_force.<fender>` [N]: largest force of that fender over all steps
- `peak_fender_force_of_capacity` [1]: largest of them over the capacity of its fender, where that is known
- `peak_guide_force.<guide>` [N]: largest force of that landing guide at any sample, or of one of its contacts
  over all steps
- `peak_guide_force_of_capacity` [1]: largest of them over the capacity of its guide, where that is known
- `least_freeboard` [m]: least height of the deck edge and openings of any vessel above the water
- `peak_sheave_tension_ratio`, `final_sheave_tension_ratio` [1]: largest ratio of the tensions on both sides
  of a sheave with losses, over the samples and at the last one; while the loads are clear, if they ever are
- `travel_used_up`, `travel_used_down` [1]: largest travel of a moving sheave above/below its start, of its
  stroke that way
- `travel_used_up_when_clear`, `travel_used_down_when_clear` [1]: the same while the loads are clear
- `final_sheave_travel.<sheave>` [m]: travel of that moving sheave at the last sample, down positive
- `least_rod_out.<compensator>`, `largest_rod_out.<compensator>` [m]: least and largest way of the rod out of
  its cylinder while the loads are clear and no pin holds it; absent where that never is
- `stroke_margin.<compensator>` [1]: the least way from either stop then, of the stroke
- `final_rod_out.<compensator>` [m]: its way out at the last sample
- `peak_compensator_load.<compensator>` [N]: largest vertical force of all slings that hang from it
- `largest_rope_lengthening`, `largest_rope_shortening` [m]: most that adjusting has added to the natural
  length of any rope, or taken from it, at any sample
- `final_rope_lengthening.<rope>` [m]: what it has added to that of this rope at the last sample
- `final_joint_travel.<joint>` [m or rad]: position of that hinge or slider at the last sample less that at
  the start; of a sheave with losses or inertia the rope that has passed it, of a drum how far it has turned
  on its own diameter, of the drum of a hook how far it has hoisted the hook in the first layer, of the
  chain hoist of a sling the chain that it has paid out
- `least_drum_wraps.<drum>` [1]: fewest turns of rope on that drum
- `energy_remainder` [1]: largest magnitude, over all steps, of the energy that the audit cannot place,
  relative to the largest of kinetic + elastic + |work of drives| + |work of wind, current and waves|
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from gantline.results import series
from gantline.results.alike import earliest_peak
from gantline.results.cranes.compensators import borne, range_of
from gantline.results.cranes.rating import chart_used
from gantline.results.loads.clearances import watched_during
from gantline.results.loads.contact_peaks import contact_peak, guide_peak
from gantline.results.loads.drift import load_drift
from gantline.results.loads.hinge_peaks import hinge_peak
from gantline.results.loads.hinges import axial_force, hinge_force, hinge_moment, radial_force
from gantline.results.loads.hook_peaks import hook_peak
from gantline.results.loads.hung_so import has_hung_so, tells_dynamics
from gantline.results.loads.lift_off import lift_off_time
from gantline.results.loads.skew import largest_skew
from gantline.results.recording import Recording
from gantline.results.ropes import upper_end
from gantline.results.ropes.equalising import equalising
from gantline.results.ropes.parting import ATTACHED, DETACHED, PLANNED, partings
from gantline.results.ropes.travel import most_used, ways

#: Energy remainder up to which the balance counts as closed, by integrator. A fixed step of first order
#: cannot do better than a thousandth; an error-controlled one does far better unless something is wrong.
ENERGY_BOUNDS = {"del": 1e-3, "adaptive": 1e-5, "explicit": 1e-3}

_Metric = tuple[str, float | None]


def energy_bound(settings: Mapping[str, Any]) -> float:
    """Energy remainder up to which the balance of a run with these settings counts as closed [1]."""
    return ENERGY_BOUNDS[settings["integrator"]["type"]]


def metrics_of(recording: Recording) -> dict[str, float]:
    """All metrics that exist for a recording, in a fixed order.

    Args:
        recording: Any recording.

    Returns:
        SI values by the names above.
    """
    if not len(recording.time):
        return {}
    counted = _at_rest_alone(recording)
    parts = (
        _ropes,
        _parted,
        _slings,
        _spread,
        _hinges,
        _sheaves,
        _loads,
        _supports,
        _vessels,
        _moorings,
        _guides,
        _tag_lines,
        _hooks,
        _charts,
        _crawlers,
        _travel,
        _compensators,
        _lengthening,
        _audit,
    )
    found = [*(one for part in parts for one in part(counted)), *_from_the_start(recording)]
    return {name: value for name, value in found if value is not None}


def _at_rest_alone(recording: Recording) -> Recording:
    """Of an equilibrium what counts, its last sample: the one before is where the lift starts."""
    if not recording.is_equilibrium or len(recording.time) == 1:
        return recording
    last = {
        name: replace(one, values=one.values[-1:]) if one.dims[:1] == ("time",) else one
        for name, one in recording.variables.items()
    }
    return Recording(last, recording.coordinates, recording.attributes)


def _ropes(recording: Recording) -> Iterator[_Metric]:
    if "rope_tension" not in recording:
        return
    equalizing = [e.equalizing_rope for e in recording.rig.equalizers if e.equalizing_rope]
    yield (
        "peak_equalizing_rope_tension",
        _largest(series.rope_peak(recording, rope)[0] for rope in equalizing),
    )
    for rope in recording.coordinates["rope"]:
        yield f"peak_rope_tension.{rope}", series.rope_peak(recording, rope)[0]
        yield f"final_rope_tension.{rope}", float(recording.column("rope_tension", rope)[-1])
    used = {rope: upper_end.utilisation(recording, rope) for rope in recording.coordinates["rope"]}
    known = {rope: share for rope, share in used.items() if share is not None}
    for rope, share in known.items():
        yield f"utilisation_of_minimum_breaking_force.{rope}", share
    yield "peak_utilisation_of_minimum_breaking_force", _largest(known.values())


def _parted(recording: Recording) -> Iterator[_Metric]:
    gone = partings(recording)
    parted = [one for one in gone if one.kind not in PLANNED]
    if parted:
        yield "parted_ropes", float(len(parted))
    for one in parted:
        yield f"parting_time.{one.rope}", one.time
        yield f"parting_tension.{one.rope}", one.tension
    for one in gone:
        if one.kind == DETACHED:
            yield f"detaching_tension.{one.rope}", one.tension
    for time, _, rope in recording.events(ATTACHED):
        yield f"attaching_time.{rope}", time


def _supports(recording: Recording) -> Iterator[_Metric]:
    rig = recording.rig
    peaks = {one.name: contact_peak(recording, one.name)[0] for one in rig.supports}
    for support in rig.supports:
        yield f"peak_support_force.{support.name}", peaks[support.name]
    yield "peak_support_force", _largest(peaks.values())
    for watch in rig.watches:
        distance = recording.column("clearance", watch.name)[watched_during(recording, watch)]
        least = float(distance.min(initial=np.inf))
        yield f"smallest_clearance.{watch.name}", None if least == np.inf else least


def _vessels(recording: Recording) -> Iterator[_Metric]:
    vessels = recording.rig.vessels
    if not vessels:
        return
    for vessel in vessels:
        for name in ("draft", "draft_aft", "draft_forward", "heel", "trim", "displacement"):
            last = recording.column(f"vessel_{name}", vessel.name)[-1]
            yield f"final_{name}.{vessel.name}", float(last)
    for name in ("heel", "trim"):
        yield f"peak_{name}", float(np.abs(recording[f"vessel_{name}"].values).max())
    yield "least_freeboard", float(recording["vessel_freeboard"].values.min())


def _slings(recording: Recording) -> Iterator[_Metric]:
    slings = recording.rig.slings
    if not slings:
        return
    clear = series.is_clear(recording)
    highest = earliest_peak(*(series.rope_peak(recording, sling.rope) for sling in slings))
    yield "peak_sling_tension", highest[0]
    yield "peak_sling_tension_time", None if recording.is_equilibrium else highest[1]
    amplification, factors, least, angles = [], [], [], []
    for sling in slings:
        tension = series.sling_tension(recording, sling)
        top, time = series.rope_peak(recording, sling.rope)
        static, _ = series.greatest_static(recording, tension)
        yield f"static_sling_tension.{sling.rope}", static
        moves = not recording.is_equilibrium and has_hung_so(recording, time, of_slings=True)
        if moves and static and tells_dynamics(static, top):
            amplification.append(top / static)
        used = upper_end.utilisation(recording, sling.rope)
        if used:
            factors.append(1.0 / used)
        if (counts := clear & series.is_on(recording, sling.rope)).any():
            least.append(float(tension[counts].min()))
        carrying = series.is_carrying(tension)
        if carrying.any():
            angles.append(float(series.sling_angle(recording, sling)[carrying].max()))
    yield "skew_load_factor", largest_skew(recording)
    yield "least_sling_tension_when_clear", _smallest(least)
    yield "dynamic_amplification_factor", _largest(amplification)
    yield "least_factor_on_breaking_force", _smallest(factors)
    yield "peak_sling_angle_from_vertical", _largest(angles)


def _spread(recording: Recording) -> Iterator[_Metric]:
    equalizers = [equalizer for equalizer in recording.rig.equalizers if equalizer.slings]
    if series.is_clear(recording).any():
        spreads = (series.spread_when_clear(recording, equalizer) for equalizer in equalizers)
        known = (spread for spread in spreads if spread is not None)
        yield "peak_tension_spread_when_clear", _largest(known)
    last = (float(series.tension_spread(recording, equalizer)[-1]) for equalizer in equalizers)
    yield "final_tension_spread", _largest(last)
    for equalizer in recording.rig.equalizers:
        found = equalising(recording, equalizer)
        yield f"time_to_equalise.{equalizer.name}", found.time if found is not None else None
    tilts = [series.frame_tilt(recording, e).max() for e in recording.rig.equalizers if e.tilts]
    yield "peak_equalizer_tilt", _largest(map(float, tilts))
    if "pin_force" in recording:
        yield "peak_pin_force", float(np.abs(recording["pin_force"].values).max())


def _hinges(recording: Recording) -> Iterator[_Metric]:
    for hinge in recording.rig.hinges:
        for part, series_of in (
            ("force", hinge_force),
            ("radial_force", radial_force),
            ("axial_force", axial_force),
            ("moment", hinge_moment),
        ):
            yield f"peak_hinge_{part}.{hinge.name}", hinge_peak(recording, hinge, series_of)[0]


def _sheaves(recording: Recording) -> Iterator[_Metric]:
    lossy = [sheave for sheave in recording.rig.sheaves if sheave.has_losses]
    ratios = [series.tension_ratio(recording, sheave) for sheave in lossy]
    yield "peak_sheave_tension_ratio", _largest(float(ratio.max()) for ratio in ratios)
    yield "final_sheave_tension_ratio", _largest(float(ratio[-1]) for ratio in ratios)
    angles = []
    for sheave in recording.rig.wrapped_sheaves:
        carrying = series.is_carrying(recording.column("rope_tension", sheave.rope))
        angles.append(float(series.fleet_angle(recording, sheave)[carrying].max(initial=0.0)))
    yield "peak_fleet_angle", _largest(angles)


def _loads(recording: Recording) -> Iterator[_Metric]:
    yield "lift_off_time", lift_off_time(recording)
    if not recording.rig.loads:
        return
    yield "final_load_transferred", float(recording["load_transferred"].values[-1].min())
    yield "peak_load_tilt", float(recording["load_tilt"].values.max())


def _from_the_start(recording: Recording) -> Iterator[_Metric]:
    """What is told against the first sample, of an equilibrium too."""
    for joint in recording.coordinates.get("joint", ()):
        position = recording.column("joint_position", joint)
        yield f"final_joint_travel.{joint}", float(position[-1] - position[0])
    yaws = (series.load_yaw(recording, load) for load in recording.rig.loads)
    yield "peak_load_yaw", _largest(float(np.abs(yaw).max()) for yaw in yaws if yaw is not None)
    drifts = []
    for load in recording.rig.loads:
        clear = series.load_is_clear(recording, load)
        if clear.any():
            drifts.append(float(load_drift(recording, load)[clear].max()))
    yield "peak_load_drift_when_clear", _largest(drifts)


def _tag_lines(recording: Recording) -> Iterator[_Metric]:
    for line in recording.rig.tag_lines:
        yield f"peak_tag_line_tension.{line.name}", series.rope_peak(recording, line.rope)[0]


def _moorings(recording: Recording) -> Iterator[_Metric]:
    lines, fenders = recording.rig.mooring_lines, recording.rig.fenders
    tension = {line.name: series.rope_peak(recording, line.rope)[0] for line in lines}
    for line in lines:
        yield f"peak_mooring_tension.{line.name}", tension[line.name]
        yield f"final_mooring_tension.{line.name}", float(recording.column("mooring_tension", line.name)[-1])
    known = [(line.name, line.minimum_breaking_force) for line in lines]
    used = [tension[name] / strength for name, strength in known if strength is not None]
    yield "peak_mooring_tension_of_breaking_force", _largest(used)
    force = {one.name: contact_peak(recording, one.contact)[0] for one in fenders}
    for name, peak in force.items():
        yield f"peak_fender_force.{name}", peak
    pressed = [share for one in fenders if (share := one.used_by(force[one.name])) is not None]
    yield "peak_fender_force_of_capacity", _largest(pressed)


def _guides(recording: Recording) -> Iterator[_Metric]:
    guides = recording.rig.guides
    force = {one.name: guide_peak(recording, one)[0] for one in guides}
    for name, peak in force.items():
        yield f"peak_guide_force.{name}", peak
    pressed = [share for one in guides if (share := one.used_by(force[one.name])) is not None]
    yield "peak_guide_force_of_capacity", _largest(pressed)


def _hooks(recording: Recording) -> Iterator[_Metric]:
    for name in ("hook_load", "hoist_load"):
        if name not in recording:
            continue
        forces = recording[name].values.T
        statics = (series.greatest_static(recording, force)[0] for force in forces)
        yield f"static_{name}", _largest(static for static in statics if static is not None)
        hooks = recording.coordinates["hook"]
        yield f"peak_{name}", _largest(hook_peak(recording, hook, name)[0] for hook in hooks)


def _charts(recording: Recording) -> Iterator[_Metric]:
    for chart in recording.rig.rating_charts:
        used = float(chart_used(recording, chart).max())
        yield f"rating_utilisation.{chart.crane}", used if np.isfinite(used) else None


def _crawlers(recording: Recording) -> Iterator[_Metric]:
    for crane in recording.rig.crawlers:
        tipping = recording.column("tipping_utilisation", crane.name)
        yield f"tipping_utilisation.{crane.name}", float(tipping.max())
        pressures = [recording.column("ground_pressure", corner) for corner in crane.corners]
        yield f"peak_ground_pressure.{crane.name}", float(np.max(pressures))


def _travel(recording: Recording) -> Iterator[_Metric]:
    clear = series.is_clear(recording)
    for word in ("up", "down"):
        own = [way for way in ways(recording) if way.word == word]
        if own:
            yield f"travel_used_{word}", most_used(own, series.everywhere(recording))
        if own and clear.any():
            yield f"travel_used_{word}_when_clear", most_used(own, clear)
    for sheave in recording.coordinates.get("moving_sheave", ()):
        yield f"final_sheave_travel.{sheave}", float(recording.column("sheave_travel", sheave)[-1])
    for drum in recording.coordinates.get("counted_drum", ()):
        yield f"least_drum_wraps.{drum}", float(recording.column("drum_wraps", drum).min())


def _lengthening(recording: Recording) -> Iterator[_Metric]:
    if "rope_lengthening" not in recording:
        return
    lengthening = recording["rope_lengthening"].values
    yield "largest_rope_lengthening", float(np.max(lengthening, initial=0.0))
    yield "largest_rope_shortening", float(np.max(-lengthening, initial=0.0))
    for rope in (rope for equalizer in recording.rig.equalizers for rope in equalizer.slings):
        yield f"final_rope_lengthening.{rope}", float(recording.column("rope_lengthening", rope)[-1])


def _compensators(recording: Recording) -> Iterator[_Metric]:
    for one in recording.rig.compensators:
        found = range_of(recording, one)
        if found is not None:
            yield f"least_rod_out.{one.name}", found.least
            yield f"largest_rod_out.{one.name}", found.most
            yield f"stroke_margin.{one.name}", min(found.least, one.stroke - found.most) / one.stroke
        yield f"final_rod_out.{one.name}", float(recording.column("rod_out", one.name)[-1])
        yield f"peak_compensator_load.{one.name}", float(borne(recording, one).max())


def _audit(recording: Recording) -> Iterator[_Metric]:
    remainder = recording.attributes.get("energy_remainder")
    yield "energy_remainder", None if remainder is None else float(remainder)


def _largest(values: Iterable[float]) -> float | None:
    return max(values, default=None)


def _smallest(values: Iterable[float]) -> float | None:
    return min(values, default=None)
