"""The simulator in Rust: a document in, columns out, a few verbs."""

from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt

class Simulation:
    """A system ready to run.

    Args:
        document: The system as JSON text.
        settings: Integrator, duration and sampling as JSON text.

    Raises:
        ValueError: If the document or the settings are not right.
    """

    def __init__(self, document: str, settings: str) -> None: ...
    def run(
        self, on_progress: Callable[[float], bool] | None = None, until: float | None = None
    ) -> dict[str, Any]:
        """Go on to `until` [s] or to the end; the answer holds status, time, element, cause and message."""

    def columns(self) -> dict[str, npt.NDArray[np.float64]]:
        """What was recorded so far, by name."""

    def rope_tension(self) -> npt.NDArray[np.float64]:
        """Tensions of all ropes [N], shape (samples, ropes), without working out the other columns."""

    def names(self) -> dict[str, list[str]]:
        """Names along the dimensions of the columns."""

    def measure(self) -> None:
        """Measure from now on where the time goes; costs a few per cent."""

    def stages(self) -> dict[str, float]:
        """Time of every stage of what was measured [s], by name; empty where nothing was."""

    def time(self) -> float:
        """Simulated time [s]."""

    def current_step(self) -> str | None:
        """Name of the step of the plan that is under way."""

    def current_tension(self) -> list[float]:
        """Tensions of all ropes now [N], in the order of their names."""

    def energy_remainder(self) -> float:
        """Largest energy remainder over all steps so far, relative to kinetic + elastic + |drive work|."""

    def save(self) -> bytes:
        """The state, exactly."""

    def restore(self, state: bytes) -> None:
        """Go on from a state that `save` gave."""

    def counters(self) -> dict[str, int]:
        """Steps, factorisations and what else was counted."""

class Statics:
    """A system whose equilibria are asked for.

    Args:
        document: The system as JSON text.

    Raises:
        ValueError: If the document is not right, or has lengths that are adjusted.
    """

    def __init__(self, document: str) -> None: ...
    def degrees_of_freedom(self) -> int:
        """How many there are, of driven joints too."""

    def settle(
        self, time: float = 0.0, increment: list[float] | None = None, losses: str = "none"
    ) -> dict[str, Any]:
        """Find the equilibrium at a time [s]; RuntimeError(element, cause) where there is none."""

    def modes(self) -> dict[str, npt.NDArray[np.float64]]:
        """Natural motions about the equilibrium found last, slowest first; NaN: no damping ratio."""

    def swing(self, mode: int, amplitude: float, frames: int) -> None:
        """Let the equilibrium swing in a mode, so that `columns` has one period of it."""

    def sensitivities(self, parameters: list[tuple[str, str]]) -> npt.NDArray[np.float64]:
        """Derivatives of all tensions, shape (parameters, ropes), over pairs of a kind and a name."""

    def columns(self) -> dict[str, npt.NDArray[np.float64]]:
        """The equilibrium or motion found last, by name."""

    def names(self) -> dict[str, list[str]]:
        """Names along the dimensions of the columns."""
