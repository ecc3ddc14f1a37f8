"""Many answers about one lift: its cases, and how it hangs over the values of one quantity."""

from gantline.study.cases import CasesResult, run_cases
from gantline.study.state import State, Worst, values_of, worst_of
from gantline.study.sweep import SweepPoint, run_sweep

__all__ = [
    "CasesResult",
    "State",
    "SweepPoint",
    "Worst",
    "run_cases",
    "run_sweep",
    "values_of",
    "worst_of",
]
