"""Many answers about one lift: its cases, how it hangs over a quantity, what makes it hang as wanted."""

from gantline.study.cases import CasesResult, run_cases
from gantline.study.inverse import CannotBeError, HookAnswer, LengthAnswer, adjust_lengths, plumb_hooks
from gantline.study.state import State, Worst, values_of, worst_of
from gantline.study.sweep import SweepPoint, run_sweep

__all__ = [
    "CannotBeError",
    "CasesResult",
    "HookAnswer",
    "LengthAnswer",
    "State",
    "SweepPoint",
    "Worst",
    "adjust_lengths",
    "plumb_hooks",
    "run_cases",
    "run_sweep",
    "values_of",
    "worst_of",
]
