"""Many answers about one lift: cases, seas, how it hangs over a quantity, hanging as wanted, a finer run."""

from gantline.study.afloat import VesselAttitude
from gantline.study.ballast import BallastAnswer, solve_ballast
from gantline.study.case_runs import CaseRun, CaseRuns, simulate_cases
from gantline.study.cases import CasesResult, run_cases
from gantline.study.extremes import Extreme, Gumbel
from gantline.study.kept_runs import KeptRunsError, RunsInUseError
from gantline.study.lengths import LengthAnswer, adjust_lengths
from gantline.study.lost_load import LostLoad, Swing, lose_load
from gantline.study.newton import AdjustError, CannotBeError
from gantline.study.plumb import HookAnswer, plumb_hooks
from gantline.study.refinement import finer_simulation, refined
from gantline.study.sea import NoSeaError, Sea, SeaRecord
from gantline.study.seas import SeasResult, run_seas
from gantline.study.state import State, Worst, values_of, worst_of
from gantline.study.steps import StepAtRest, run_steps
from gantline.study.sweep import SweepPoint, run_sweep
from gantline.study.tilting import Margin, TiltAxis, Tilting, margins_of, tilting_of

__all__ = [
    "AdjustError",
    "BallastAnswer",
    "CannotBeError",
    "CaseRun",
    "CaseRuns",
    "CasesResult",
    "Extreme",
    "Gumbel",
    "HookAnswer",
    "KeptRunsError",
    "LengthAnswer",
    "LostLoad",
    "Margin",
    "NoSeaError",
    "RunsInUseError",
    "Sea",
    "SeaRecord",
    "SeasResult",
    "State",
    "StepAtRest",
    "SweepPoint",
    "Swing",
    "TiltAxis",
    "Tilting",
    "VesselAttitude",
    "Worst",
    "adjust_lengths",
    "finer_simulation",
    "lose_load",
    "margins_of",
    "plumb_hooks",
    "refined",
    "run_cases",
    "run_seas",
    "run_steps",
    "run_sweep",
    "simulate_cases",
    "solve_ballast",
    "tilting_of",
    "values_of",
    "worst_of",
]
