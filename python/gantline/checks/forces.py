"""Static and dynamic forces as rules want them.

*Static* is the mean over the quiet window, raised from the weight that was simulated to the design weight.
*By the rule* is static times the rule's dynamic amplification factor. A simulated peak already holds the
dynamics: it is never multiplied by that factor, both are shown, and the larger one is checked.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace

import numpy as np

from gantline.checks.measure import Caution, Finding, Found, Missing
from gantline.results import series
from gantline.results.recording import Recording
from gantline.results.rig import Load
from gantline.results.skew import skew_loads
from gantline.results.variable import BoolArray, FloatArray
from gantline.units import format_quantity

DYNAMIC = "dynamic_amplification_factor"
NO_STATIC = "no static force: the load did not end clear of its supports"
NO_DYNAMIC = f"an equilibrium has no peak, and the rules no {DYNAMIC}"


@dataclass(frozen=True)
class Force:
    """A force of one element.

    Attributes:
        static: With the design weight [N]; None if the lift has no quiet window.
        static_text: The same in words.
        rule: Static force times the rule's factors [N]; None if there is none of both.
        rule_text: The same in words.
        peak: Largest simulated force [N]; None for an equilibrium.
        time: When that was [s].
    """

    static: float | None
    static_text: str
    rule: float | None = None
    rule_text: str = ""
    peak: float | None = None
    time: float | None = None

    @property
    def dynamic(self) -> float | None:
        """The larger of rule and simulated peak [N]; None if there is neither."""
        return max((force for force in (self.rule, self.peak) if force is not None), default=None)

    @property
    def governing(self) -> float | None:
        """The dynamic force, or the static one where there is none [N]; None if there is neither."""
        return self.static if self.dynamic is None else self.dynamic

    @property
    def moment(self) -> float | None:
        """When the governing force acts [s]; None if it is static, or by the rule."""
        return self.time if self.peak is not None and self.peak == self.dynamic else None

    @property
    def text(self) -> str:
        """How the governing force comes about."""
        parts = [self.rule_text] if self.rule is not None else []
        if self.peak is not None:
            parts.append(f"peak {kilonewton(self.peak)}")
        if not parts:
            return self.static_text
        return parts[0] if len(parts) == 1 else f"max({', '.join(parts)})"

    @property
    def lacks_dynamics(self) -> bool:
        """Whether the governing force is static for want of anything else."""
        return self.static is not None and self.dynamic is None


def kilonewton(force: float) -> str:
    """A force as people read it."""
    return format_quantity(force, "kN", 1)


def factor(recording: Recording, name: str) -> float | None:
    """A factor of the rule [1]; None if the rule has none."""
    found = recording.rig.factors.get(name)
    return None if found is None else found.value


def design_ratio(recording: Recording, load: Load | None) -> float:
    """Design weight of a load over the simulated one, at least 1.

    Recordings that do not tell the weight of the load alone have that with its slings and shackles.
    """
    if load is None or load.design_mass is None:
        return 1.0
    simulated = load.simulated_mass or load.weight / recording.rig.gravity
    return max(1.0, load.design_mass / simulated) if simulated > 0.0 else 1.0


def sling_forces(recording: Recording, during: BoolArray) -> dict[str, Force]:
    """Static and dynamic force of every sling, by name.

    The rule's skew load factor raises the static force where lengths decide how slings share.
    """
    window = series.quiet_window(recording)
    by_length = {one.sling for one in skew_loads(recording) if one.lengths_decide}
    forces = {}
    for sling in recording.rig.slings:
        static = series.static_value(recording, series.sling_tension(recording, sling), window)
        ratio = design_ratio(recording, recording.rig.load(sling.to_load))
        skew = (factor(recording, "skew_load_factor") or 1.0) if sling.name in by_length else 1.0
        force = _force(recording, static, ratio, skew)
        forces[sling.name] = _with_peak(recording, force, sling.rope, during)
    return forces


def rope_force(recording: Recording, rope: str, during: BoolArray) -> Force:
    """Static and dynamic force of a rope that is no sling."""
    static = series.static_value(recording, recording.column("rope_tension", rope))
    ratios = [design_ratio(recording, load) for load in recording.rig.loads]
    return _with_peak(recording, _force(recording, static, max(ratios, default=1.0), 1.0), rope, during)


def hook_force(recording: Recording, hooks: Iterable[str], variable: str, during: BoolArray) -> Force:
    """Static and dynamic hook load or hoist load of one or more hooks together.

    Only what hangs in the hook is raised by the rule's factor, not hook block and falls.

    Args:
        recording: The recording.
        hooks: Names of the hooks.
        variable: `hook_load` or `hoist_load`.
        during: Samples whose peak counts.
    """
    names = list(hooks)
    rig = recording.rig
    hook_load = np.sum([recording.column("hook_load", name) for name in names], axis=0)
    total = np.sum([recording.column(variable, name) for name in names], axis=0)
    window = series.quiet_window(recording)
    more = 0.0
    for sling in (one for one in rig.slings if rig.hook_of(one) in names):
        up = series.sling_tension(recording, sling) * series.sling_direction(recording, sling)[:, 2]
        share = series.static_value(recording, up, window) or 0.0
        more += (design_ratio(recording, rig.load(sling.to_load)) - 1.0) * share
    static = series.static_value(recording, hook_load, window)
    falls = series.static_value(recording, total - hook_load, window) or 0.0
    force = _hook_force(recording, static, more, falls)
    return _with_peak_of(recording, force, total, during)


def sum_force(recording: Recording, values: FloatArray, load: Load | None, during: BoolArray) -> Force:
    """Static and dynamic force of a series that goes with the weight of a load, shape (time,) [N]."""
    force = _force(recording, series.static_value(recording, values), design_ratio(recording, load), 1.0)
    return _with_peak_of(recording, force, values, during)


def _hook_force(recording: Recording, static: float | None, more: float, falls: float) -> Force:
    if static is None:
        return Force(None, "")
    hanging = f"static {kilonewton(static)}"
    if more > 0.0:
        hanging = f"({hanging} + {kilonewton(more)} to the design weight)"
    of_falls = f" + hook block and falls {kilonewton(falls)}" if falls else ""
    force = Force(static + more + falls, hanging + of_falls)
    dynamic = factor(recording, DYNAMIC)
    if dynamic is None:
        return force
    rule = (static + more) * dynamic + falls
    return replace(force, rule=rule, rule_text=f"{hanging} x {dynamic:.4g}{of_falls}")


def _force(recording: Recording, static: float | None, ratio: float, skew: float) -> Force:
    if static is None:
        return Force(None, "")
    text = f"static {kilonewton(static)}"
    for more in (ratio, skew):
        text += f" x {more:.4g}" if more > 1.0 else ""
    design = static * ratio * skew
    dynamic = factor(recording, DYNAMIC)
    if dynamic is None:
        return Force(design, text)
    return Force(design, text, design * dynamic, f"{text} x {dynamic:.4g}")


def _with_peak(recording: Recording, force: Force, rope: str, during: BoolArray) -> Force:
    """With the peak of a rope: over all steps if all samples count, else over these."""
    values = recording.column("rope_tension", rope)
    force = _with_peak_of(recording, force, values, during)
    if force.peak is None or not during.all():
        return force
    highest = max(series.rope_peak(recording, rope), (force.peak, force.time or 0.0))
    return replace(force, peak=highest[0], time=highest[1])


def _with_peak_of(recording: Recording, force: Force, values: FloatArray, during: BoolArray) -> Force:
    highest = None if series.is_equilibrium(recording) else series.peak(recording, values, during)
    return force if highest is None else replace(force, peak=highest[0], time=highest[1])


def over(force: Force, strength: float, element: str, *, factor: float = 1.0) -> Iterator[Finding]:
    """A force, times a factor, over what bears it; with a caution where only its static value is known.

    Args:
        force: The force.
        strength: What bears it [N].
        element: What it belongs to.
        factor: Factor of the rule on the force [1].
    """
    if force.governing is None:
        yield Missing(element, NO_STATIC)
        return
    if force.lacks_dynamics:
        yield Caution(f"static only: {NO_DYNAMIC}")
    more = f" x {factor:.4g}" if factor != 1.0 else ""
    formula = f"{force.text}{more} / {kilonewton(strength)}"
    yield Found(factor * force.governing / strength, element, force.moment, formula)
