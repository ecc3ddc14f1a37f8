"""The simulator in Rust: a document in, columns out, a few verbs."""

from collections.abc import Callable, Sequence
from typing import Any, Self

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
        self,
        on_progress: Callable[[float], bool] | None = None,
        until: float | None = None,
        exact: bool = False,
    ) -> dict[str, Any]:
        """Go on to `until` [s] or to the end; the answer holds status, time, element, cause and message.

        The last step ends at `until` if `exact`, where the method can choose its steps.
        """

    def command(self, document: str) -> None:
        """Let drives do from now on what a JSON text asks for; ValueError where they cannot."""

    def drive(self, name: str) -> tuple[float, float]:
        """Position and velocity of what a drive moves now [m or rad, and per s]."""

    def present(self) -> dict[str, npt.NDArray[np.float64]]:
        """Columns of the present alone, by name."""

    def columns(self, of_pulls: bool = False) -> dict[str, npt.NDArray[np.float64]]:
        """What was recorded so far, by name.

        Of pulls it is one moment for each group of ropes in `pulls` of the document, that at which they
        pulled most together over all steps; fewer before the first step.
        """

    def rope_tension(self) -> npt.NDArray[np.float64]:
        """Tensions of all ropes [N], shape (samples, ropes), without working out the other columns."""

    def names(self) -> dict[str, list[str]]:
        """Names along the dimensions of the columns."""

    def tolerances(self) -> dict[str, float]:
        """What the error of a step may be, `tension` [N] and `position` [m]; empty where steps are fixed."""

    def measure(self) -> None:
        """Measure from now on where the time goes; costs a few per cent."""

    def stages(self) -> dict[str, float]:
        """Time of every stage of what was measured [s], by name; empty where nothing was."""

    def time(self) -> float:
        """Simulated time [s]."""

    def ended(self) -> bool:
        """True at its end, within rounding."""

    def current_step(self) -> str | None:
        """Name of the step of the plan that is under way."""

    def current_tension(self) -> list[float]:
        """Tensions of all ropes now [N], in the order of their names."""

    def energy_remainder(self) -> float:
        """Largest energy remainder over the largest of kinetic + elastic + |drive work| + |fluid work|."""

    def save(self, alone: bool = False) -> bytes:
        """The state, exactly; `alone`, without what was recorded before it, for statics."""

    def waypoints(self, first: int) -> list[tuple[str | None, float | None, float, bytes]]:
        """Where steps ended and tanks passed marks, from the `first` on, as `statics.righted.Waypoint`."""

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
        self,
        time: float = 0.0,
        increment: list[float] | None = None,
        losses: str = "none",
        slide: list[float] | None = None,
        goes_on: Callable[[], bool] | None = None,
    ) -> dict[str, Any]:
        """Find the equilibrium at a time [s]; RuntimeError(element, cause) where there is none.

        Or where `goes_on`, which is asked before every part of the way, says no.
        """

    def when(
        self, step: str, ends: bool, time: float, goes_on: Callable[[], bool] | None = None
    ) -> float | None:
        """When a step begins or ends [s], followed no farther; for errors see `settle`."""

    def settle_saved(self, saved: bytes, losses: str) -> dict[str, Any]:
        """The same of where a simulation of the document has got to; ValueError if it is not of it."""

    def step_off(self, losses: str = "none") -> dict[str, Any] | None:
        """Move off the unstable equilibrium found last to a stable one; None where it is not unstable."""

    def lose(self, body: str, losses: str) -> dict[str, Any]:
        """Lose a body at the equilibrium found last: that of everything else; for errors see `settle`."""

    def heavier(self, more: list[tuple[str, float]], losses: str) -> Self:
        """The lift with bodies so much heavier [kg], at rest downhill; for errors see `settle`."""

    def time(self) -> float:
        """Time of the equilibrium looked for last [s]."""

    def modes(
        self, count: int | None = None, found: Sequence[tuple[float, npt.NDArray[np.float64]]] | None = None
    ) -> dict[str, npt.NDArray[np.float64]]:
        """Natural motions about the equilibrium found last, slowest first, or `found`; NaN: no ratio."""

    def linear(self, frequency: float | None = None) -> dict[str, Any]:
        """The lift linearised about the equilibrium found last, by kind of matrix.

        `mass`, `damping`, `stiffness`, shape (n, n), `held` (m, n), `rope_tension` and `rope_tension_rate`
        (ropes, n), `body_motion` (n, bodies, 6); `coordinates`, n names. Water that remembers as at a
        circular frequency [rad/s].
        """

    def times_of(self, step: str) -> tuple[float | None, float | None]:
        """When a step of the plan began and ended on the way to the equilibrium found last [s]."""

    def swing(self, mode: int, amplitude: float, frames: int) -> None:
        """Let the equilibrium swing in a mode, so that `columns` has one period of it."""

    def sensitivities(
        self, parameters: list[tuple[str, str]], stands: bool = False
    ) -> dict[str, npt.NDArray[np.float64]]:
        """Derivatives over pairs of a kind and a name, by kind of answer.

        `rope_tension`, shape (parameters, ropes), and `body_motion`, of centre of gravity and rotation vector
        in world axes, shape (parameters, bodies, 6); `held`, shape (parameters,), 0 where the parameter sets
        something going that nothing holds, else 1.
        """

    def columns(self) -> dict[str, npt.NDArray[np.float64]]:
        """The equilibrium or motion found last, by name."""

    def names(self) -> dict[str, list[str]]:
        """Names along the dimensions of the columns."""

class Hull:
    """A hull that can be cut by planes.

    Args:
        vertices: positions (n, 3) [m].
        triangles: three vertices each (m, 3), counter-clockwise seen from outside.
        weld: vertices closer than this [m] are made one.

    Raises:
        ValueError: If a coordinate is not finite or a vertex does not exist.
    """

    def __init__(
        self, vertices: npt.NDArray[np.float64], triangles: npt.NDArray[np.int64], weld: float
    ) -> None: ...
    def mesh(self) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]]:
        """Vertices (n, 3) [m] and triangles (m, 3) after welding."""

    def closure(self) -> dict[str, Any]:
        """How far it is closed.

        Keys: boundary_edges, boundary_length, lowest_boundary, turned_edges, crowded_edges,
        unbalanced_area, volume.
        """

    def below(self, normal: list[float], height: float) -> dict[str, Any]:
        """What lies below normal . x + height = 0.

        Keys: volume, moment, depth_moment [m^4], and of the section area, area_moment, area_second, all
        about the origin.
        """

    def surface(self, normal: list[float], height: float) -> dict[str, Any]:
        """The skin below that plane.

        Keys: wetted_area, thrust (int h N dS), thrust_moment, waterline_gap, waterline_length,
        waterline_low and waterline_high.
        """
