"""What the README of a scenario tells of its run, in its own words and with the numbers of a recording."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from gantline.checks import values_of
from gantline.results.recording import Recording

__all__ = ["told_of"]

_G = 9.81  # m/s²


def told_of(scenario: str, recording: Recording) -> list[str]:
    """Sentences that its README has to have; none of a scenario of which nothing is held here."""
    return _TOLD[scenario](recording) if scenario in _TOLD else []


def _end_of(recording: Recording, step: str) -> int:
    """The last sample of a step."""
    (end,) = (time for time, kind, name in recording.events() if (kind, name) == ("step_end", step))
    return int(np.searchsorted(recording.time, end, side="right")) - 1


def _during(recording: Recording, step: str) -> slice:
    (begin,) = (time for time, kind, name in recording.events() if (kind, name) == ("step_begin", step))
    return slice(int(np.searchsorted(recording.time, begin)), _end_of(recording, step) + 1)


def _degrees(recording: Recording, variable: str) -> float:
    """The largest of an angle to either side [deg]."""
    return float(np.degrees(np.abs(recording[variable].values).max()))


def _goliath(recording: Recording) -> list[str]:
    settled = _end_of(recording, "settle")

    def spread(slings: Sequence[str]) -> float:
        tensions = [recording.column("rope_tension", f"sling.{name}")[settled] for name in slings]
        return 100.0 * float(np.ptp(tensions) / np.mean(tensions))

    spreads = [spread([f"{hook}.{one}" for one in range(1, 6)]) for hook in ("U1", "U2", "L")]
    peak = recording.metrics()["peak_sling_tension"]
    plumb = np.degrees(max(values_of(recording, "falls_out_of_plumb").values()))
    corner = max(values_of(recording, "corner_load").values())
    girder = recording.column("body_position", "goliath.girder")[:, 2]
    return [
        f"After *settle* they differ by {spreads[0]:.1f}, {spreads[1]:.1f} and {spreads[2]:.1f} %.",
        f"up to {peak / 1e3:.1f} kN in its slings",
        f"Falls are {plumb:.2f}° out of plumb at most, while the trolleys speed up.",
        f"The girder bends by {1e3 * (girder[0] - girder[-1]):.0f} mm when the load comes off the ground.",
        f"Corners of the legs bear up to {corner / _G / 1e3:.0f} t each",
    ]


def _floating_crane(recording: Recording) -> list[str]:
    metrics = recording.metrics()
    hook, hoist = (metrics[f"static_{name}_load"] / _G / 1e3 for name in ("hook", "hoist"))
    lines = [recording.column("mooring_tension", name) / 1e3 for name in ("bow.ps", "bow.sb")]
    aft, forward = (recording[f"vessel_draft_{end}"].values[0, 0] for end in ("aft", "forward"))
    trim = _degrees(recording, "vessel_trim")
    return [
        f"The vessel waits trimmed by the stern: {trim:.2f}°, {aft:.2f} m aft and {forward:.2f} m forward.",
        f"Hook load {hook:.1f} t at each hook, hoist load {hoist:.1f} t",
        f"150 kN as the lift begins, then 125 to {np.max(lines):.0f} kN",
    ]


def _heavy_lift_ship(recording: Recording) -> list[str]:
    way = _during(recording, "over the deck")
    tilt = np.degrees(recording.column("load_tilt", "reactor")[way].max())
    falls = np.degrees(recording["falls_out_of_plumb"].values.max(axis=1))
    takes_slack = _during(recording, "take up slack")
    heel = np.degrees(recording["vessel_heel"].values[takes_slack].min())
    # In the last moment of that step, or the first of the hold after it.
    assert falls.argmax() <= _during(recording, "hold at 5 percent").start + 5
    return [
        f"Falls are {falls[way].max():.1f}° out of plumb at most on the way, "
        f"and the load tilts by {tilt:.2f}°.",
        f"The farthest that falls lean, {falls.max():.1f}°, is while the reactor still stands: "
        f"as the slack is taken up the ship heels by {-heel:.1f}° to port",
    ]


def _crane_barge_in_swell(recording: Recording) -> list[str]:
    metrics = recording.metrics()
    trim, heel = (np.degrees(metrics[f"peak_{name}"]) for name in ("trim", "heel"))
    raised = metrics["peak_hook_load"] / metrics["static_hook_load"]
    return [
        f"The barge pitches more than it rolls, by {trim:.2f}° to {heel:.2f}°",
        f"the hook load rises to {raised:.3f} of its static value",
        f"The crane works at {100 * metrics['rating_utilisation.sheerleg']:.0f} % of its chart.",
        f"the tightest line has {metrics['peak_mooring_tension.bow.sb'] / 1e3:.0f} kN at most",
        f"the water stays {metrics['least_freeboard']:.1f} m below the deck",
    ]


def _off_a_barge(recording: Recording) -> list[str]:
    metrics = recording.metrics()
    lines = [f"{name}.{side}" for name in ("breast", "cross") for side in ("ps", "sb")]
    between = max(metrics[f"peak_mooring_tension.{name}"] for name in lines)
    raised = metrics["peak_hook_load"] / metrics["static_hook_load"]
    taut = max(time for time, _, name in recording.events("taut") if name.startswith("sling."))
    return [
        f"and for good at {taut:.0f} s",
        f"it has lifted off at {metrics['lift_off_time']:.2f} s",
        f"The hook has {raised:.2f} of its static load at most",
        f"no line between them has more than {between / 1e3:.0f} kN of its 800 kN, no fender more than "
        f"{recording['fender_force'].values.max() / 1e3:.0f} kN",
    ]


def _revolving_crane(recording: Recording) -> list[str]:
    heel = np.degrees(recording.column("vessel_heel", "barge"))
    slews = _during(recording, "slew over the deck")
    minutes = np.ptp(recording.time[slews]) / 60.0
    tightest = recording["mooring_tension"].values.max()
    return [
        f"from {-heel[0]:.2f}° to port to {heel[_end_of(recording, 'hold clear')]:.2f}° to starboard",
        f"It slews a quarter turn in {minutes:.1f} minutes.",
        f"no mooring line has more than {tightest / 1e3:.0f} kN",
    ]


def _splash_zone(recording: Recording) -> list[str]:
    metrics = recording.metrics()
    load = recording.column("hook_load", "crane")
    lean = np.degrees(max(values_of(recording, "falls_out_of_plumb").values()))
    below = load[_during(recording, "hold below")]
    share = 100.0 * np.abs(below / below.mean() - 1.0).max() * below.mean() / metrics["static_hook_load"]
    return [
        f"The peak, {load.max() / 1e3:.1f} kN at {recording.time[load.argmax()]:.2f} s, is "
        f"{load.max() / metrics['static_hook_load']:.2f} times what hung still in the air.",
        f"the waves lift and drop it by {share:.0f} % of its weight at most, less and less with depth",
        f"No sling goes slack: the least has {metrics['least_sling_tension_when_clear'] / 1e3:.0f} kN.",
        f"falls lean by {lean:.1f}°, which is a warning here",
    ]


def _upending(recording: Recording) -> list[str]:
    shims = [f"support.foundation.{row}.{column}" for row in (1, 2) for column in (1, 2)]
    forces = [recording.column("contact_force", name)[-1] / 1e3 for name in shims]
    return [f"at the end they bear {min(forces):.0f} to {max(forces):.0f} kN"]


def _equalizer_sling_cut(recording: Recording) -> list[str]:
    metrics = recording.metrics()
    share = 100.0 * metrics["utilisation_of_minimum_breaking_force.sling.S5"]
    peak, time = metrics["peak_sling_tension"] / 1e3, metrics["peak_sling_tension_time"]
    return [
        f"Sling 1 carries {metrics['parting_tension.sling.S1'] / 1e3:.0f} kN when it is cut.",
        f"the hook peaks at {metrics['peak_hook_load'] / 1e6:.2f} MN",
        f"{peak:.0f} kN at {time:.2f} s, {share:.0f} % of its minimum breaking force",
    ]


def _equalizer_yard(recording: Recording) -> list[str]:
    hung = 100.0 * recording["load_transferred"].values[_during(recording, "hold point 1"), 0]
    turned = np.degrees(recording.metrics()["peak_load_yaw"])
    bent = max(values_of(recording, "rope_load_of_breaking_force").values())
    return [
        f"between {hung.min():.0f} and {hung.max():.0f} % at the first one",
        f"by {turned:.0f}° at the end.",
        f"slings use {100.0 * bent:.0f} % of their minimum breaking force",
    ]


def _floating_crane_and_crawlers(recording: Recording) -> list[str]:
    hooks = [recording.column("hook_load", name)[-1] / _G / 1e3 for name in ("fc.H2", "c1.H", "c2.H")]
    pressures = recording["ground_pressure"].values[-1] / 1e3
    return [
        f"{hooks[0]:.1f}, {hooks[1]:.1f} and {hooks[2]:.1f} t with rigging on the hooks",
        f"Each crawler presses {pressures.max():.0f} kPa under the mats of the track below its boom and "
        f"{pressures.min():.0f} kPa under the other",
    ]


def _wind_turbine(recording: Recording) -> list[str]:
    metrics, wind = recording.metrics(), recording.column("wind_at_load", "nacelle")
    (limit,) = values_of(recording, "wind_of_limit").values()
    waiting = _during(recording, "hang still")
    place = recording.column("body_position", "nacelle")[waiting]
    off = np.hypot(place[:, 0] - 40.0, place[:, 1])
    end = recording.column("body_position", "nacelle")[-1]
    # To 5 kN: a frame that swings answers to the last digit of its start by a twentieth.
    guide = max(metrics["peak_guide_force.left"], metrics["peak_guide_force.right"])
    return [
        f"in {wind[0]:.1f} m/s as it stands, and in up to {wind.max():.1f} m/s at 106 m",
        f"134 m up: {13.0 * limit:.1f} m/s, {100.0 * limit:.0f} %, where",
        f"hangs {metrics['peak_load_drift_when_clear']:.2f} m off plumb at most",
        f"and {off.max():.2f} m as it waits above the tower",
        f"bear up to some {5 * round(guide / 5e3)} kN, 3 % of its weight, until it stands "
        f"{np.hypot(end[0] - 40.0, end[1]):.2f} m off its place",
        f"pass each other at {metrics['smallest_clearance.nacelle - main.boom']:.2f} m",
    ]


_TOLD: dict[str, Callable[[Recording], list[str]]] = {
    "crane_barge_in_swell": _crane_barge_in_swell,
    "equalizer_sling_cut": _equalizer_sling_cut,
    "equalizer_yard": _equalizer_yard,
    "floating_crane": _floating_crane,
    "floating_crane_and_crawlers": _floating_crane_and_crawlers,
    "goliath": _goliath,
    "heavy_lift_ship": _heavy_lift_ship,
    "off_a_barge": _off_a_barge,
    "revolving_crane": _revolving_crane,
    "splash_zone": _splash_zone,
    "upending": _upending,
    "wind_turbine": _wind_turbine,
}
