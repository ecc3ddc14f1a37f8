"""A force of one element, static, by the rule and as simulated, and how it is held against what bears it.

`gantline.checks.forces` finds the forces of a recording.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field, replace

from gantline.checks.measure import Caution, Finding, Found, Missing
from gantline.results.variable import BoolArray
from gantline.units import format_quantity

DYNAMIC = "dynamic_amplification_factor"
SKEW = "skew_load_factor"
OWN_WEIGHT = "own weight"
NO_STATIC = "no static force: the load never hung still, clear of its supports"
UNRAISED = "peak of the simulated weight alone: the load never hung still"
UNRAISED_UNDER_PINS = (
    "peak of the simulated weight alone: the load never hung still with sheaves pinned as they were then, so "
    "that nothing tells what of it is static; a hold there does"
)
UNRAISED_IN_WATER = (
    "peak of the simulated weight alone: more of the load is left to bear then, by the water or with what is "
    "in its tanks, than whenever it hung still, so that nothing tells what of it is static; a hold there does"
)
OF_LESS = (
    "static force of a time with less to bear: more of the load is left to bear at the peak, by the water or "
    "with what is in its tanks, than whenever it hung still; a hold there tells"
)
NO_DYNAMIC = f"an equilibrium has no peak, and the rules no {DYNAMIC}"


def hung_otherwise_sentence(parts: Iterable[str]) -> str:
    """Why nothing tells what of a peak is static, by what differs from whenever the loads hung still."""
    unlike = f"whenever the load hung still, {' and '.join(parts)} than at the peak"
    return f"{unlike}, of which nothing tells what is static; a hold there does"


@dataclass(frozen=True)
class OnTheWay:
    """A force at a time as which the loads never hung still, which is static but for a little.

    Attributes:
        peak: As simulated [N].
        time: When that was [s].
        ratio: By what it is raised to the design weight [1].
    """

    peak: float
    time: float
    ratio: float

    @property
    def raised(self) -> float:
        """With the design weight [N]."""
        return self.peak * self.ratio

    @property
    def text(self) -> str:
        """The same in words."""
        return f"peak {kilonewton(self.peak)}{to_design(self.ratio)}"


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
        own_weight: What of it is the rope's own weight, over its recorded tension [N].
        factors: Names of the rule's factors in it.
        counts_static: Whether the quiet window, from which `static` is, lies within the samples that count.
        window: The quiet window from which `static` is, shape (time,); None if there is none.
        lacks_static: Whether contingency or a factor of the rule had to be left out, for want of `static`.
        is_under_other_pins: Whether `static` is of other sheaves pinned than the peak, which governs, and
            nothing is of those, so that contingency and factors are left out of it.
        is_of_less: Whether more is left to bear of the loads at the peak, by water or with what is in tanks,
            than in any time that they hung still, and than in `window`.
        is_heavier: The same where contingency or factors raise static forces: the peak is without these then.
        peak_ratio: By what the peak is raised to the design weight [1]; 1 but of a time as which the loads
            never hung still, so that no static value has what it is of.
        on_the_way: The largest force of such a time, where it is more than `static`: for what is rated for
            static forces alone.
        crest: What a peak of samples may have come to between two of them [N]; None where nothing says so.
        contingency: By what the peak is more with the design weight [1], which is for a warning alone.
    """

    static: float | None
    static_text: str
    rule: float | None = None
    rule_text: str = ""
    peak: float | None = None
    time: float | None = None
    own_weight: float = 0.0
    factors: tuple[str, ...] = ()
    counts_static: bool = True
    window: BoolArray | None = field(default=None, compare=False, repr=False)
    lacks_static: bool = False
    is_under_other_pins: bool = False
    is_of_less: bool = False
    is_heavier: bool = False
    peak_ratio: float = 1.0
    on_the_way: OnTheWay | None = None
    crest: float | None = None
    contingency: float = 1.0

    @property
    def caution(self) -> str:
        """What is left out of the force, in a sentence; empty where nothing is."""
        if self.lacks_static:
            return UNRAISED
        if self.is_heavier:
            return UNRAISED_IN_WATER
        return UNRAISED_UNDER_PINS if self.is_under_other_pins else ""

    @property
    def static_caution(self) -> str:
        """What the static force by itself leaves out, in a sentence; empty where nothing is."""
        return OF_LESS if self.is_of_less else ""

    @property
    def raised_peak(self) -> float | None:
        """The simulated peak, raised where no static value has it [N]; None of an equilibrium."""
        return None if self.peak is None else self.peak * self.peak_ratio

    @property
    def peak_at_design(self) -> float:
        """What the peak comes to with the design weight, the own weight as it is [N]; 0 without one."""
        if self.peak is None:
            return 0.0
        return (self.peak - self.own_weight) * max(self.contingency, self.peak_ratio) + self.own_weight

    @property
    def dynamic(self) -> float | None:
        """The largest of rule, simulated peak and static force [N]; None if there is no rule and no peak."""
        known = [force for force in (self.rule, self.raised_peak) if force is not None]
        if known and self.static is not None and self.counts_static:
            known.append(self.static)
        return max(known, default=None)

    @property
    def governing(self) -> float | None:
        """The dynamic force, or the static one where there is none [N]; None if there is neither."""
        return self.static if self.dynamic is None else self.dynamic

    @property
    def moment(self) -> float | None:
        """When the governing force acts [s]; None if it is static, or by the rule."""
        return self.time if self.peak is not None and self.raised_peak == self.dynamic else None

    @property
    def text(self) -> str:
        """How the governing force comes about."""
        parts = [self.rule_text] if self.rule is not None else []
        if self.rule is None and self.static is not None and self.static == self.dynamic != self.raised_peak:
            parts = [self.static_text]
        if self.peak is not None:
            highest = f"peak {kilonewton(self.peak - self.own_weight)}"
            if self.own_weight > 0.0:
                highest += f" + {OWN_WEIGHT} {kilonewton(self.own_weight)}"
                highest = f"({highest})" if self.peak_ratio > 1.0 else highest
            parts.append(f"{highest}{to_design(self.peak_ratio)}")
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


def to_design(ratio: float) -> str:
    """In words, how a force of the simulated weight is raised; nothing where that is the design weight."""
    return f" x {ratio:.4g} to the design weight" if ratio > 1.0 else ""


def as_it_is(force: Force, element: str) -> Iterator[Finding]:
    """A dynamic force that limits hold as a force, over no strength."""
    if force.dynamic is None:
        yield Missing(element, NO_DYNAMIC)
        return
    yield _told(force, force.dynamic, 1.0, Found(0.0, element, force.moment, force.text, force.factors))
    if force.caution:
        yield Caution(force.caution)


@dataclass(frozen=True)
class Raised:
    """Factors of the rule on a force.

    Attributes:
        factor: Their product [1].
        text: How it comes about.
        names: Their names.
    """

    factor: float = 1.0
    text: str = ""
    names: tuple[str, ...] = ()


def over(force: Force, strength: float, element: str, raised: Raised | None = None) -> Iterator[Finding]:
    """A force, times factors, over what bears it; with a caution where only its static value is known.

    Args:
        force: The force.
        strength: What bears it [N].
        element: What it belongs to.
        raised: Factors of the rule on the force.
    """
    raised = raised or Raised()
    if force.governing is None:
        yield Missing(element, NO_STATIC)
        return
    if force.lacks_dynamics:
        yield Caution(f"static only: {NO_DYNAMIC}")
    if force.caution:
        yield Caution(force.caution)
    formula = f"{force.text}{raised.text} / {kilonewton(strength)}"
    found = Found(0.0, element, force.moment, formula, (*force.factors, *raised.names))
    yield _told(force, force.governing, raised.factor / strength, found)


def _told(force: Force, governing: float, share: float, found: Found) -> Found:
    """A share of what governs, and of the peak with the design weight, or between samples, that is more."""
    more = force.peak_at_design
    at_design = share * more if more > governing else None
    between = None if force.crest is None or force.crest <= governing else share * force.crest
    return replace(found, value=share * governing, at_design=at_design, between=between)
