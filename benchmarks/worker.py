"""Every code in a process of its own: one thread, quiet, and no harm to the race when it fails or hangs."""

from __future__ import annotations

import contextlib
import gc
import multiprocessing
import os
import time
from collections.abc import Iterator
from dataclasses import dataclass
from multiprocessing.connection import Connection
from typing import Any

from benchmarks.contract import Code, FloatArray, Setting, Unfit
from benchmarks.gantline_code import Gantline
from benchmarks.lifts import Lift
from benchmarks.peers.exudyn import Exudyn
from benchmarks.peers.mujoco import MuJoCo
from benchmarks.peers.opensim import OpenSim
from benchmarks.yardstick import Yardstick

ONE_THREAD = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "RAYON_NUM_THREADS")
PATIENCE = 900.0  # s, for one run

CODES: tuple[Code, ...] = (
    Gantline(),
    Yardstick(vectorised=False),
    Yardstick(vectorised=True),
    MuJoCo(nested=False),
    MuJoCo(nested=True),
    Exudyn(reeving=True),
    Exudyn(reeving=False),
    OpenSim(),
)


@dataclass(frozen=True)
class Outcome:
    """Of one run: time and sling tensions, or a failure."""

    seconds: float = 0.0
    tension: FloatArray | None = None
    failure: str = ""


class Worker:
    """A code in its process."""

    def __init__(self, code: Code) -> None:
        self.code = code
        self._process: Any = None
        self._connection: Connection | None = None

    def version(self) -> str | None:
        """Of the code, or None if it is not installed."""
        answer = self._ask("version", None)
        return None if isinstance(answer, Outcome) else str(answer)

    def run(self, lift: Lift, setting: Setting, duration: float) -> Outcome:
        """Build, run and time once."""
        answer = self._ask("run", (lift, setting, duration))
        assert isinstance(answer, Outcome)
        return answer

    def stop(self) -> None:
        """End the process, if there is one."""
        if self._process is not None and self._connection is not None:
            self._connection.close()
            self._process.kill()
            self._process.join()
        self._process = self._connection = None

    def _ask(self, verb: str, arguments: Any) -> Any:
        if self._connection is None:
            context = multiprocessing.get_context("spawn")
            self._connection, theirs = context.Pipe()
            self._process = context.Process(target=_serve, args=(self.code, theirs), daemon=True)
            with _environment(dict.fromkeys(ONE_THREAD, "1")):
                self._process.start()
            theirs.close()
        try:
            self._connection.send((verb, arguments))
            if self._connection.poll(PATIENCE):
                return self._connection.recv()
            failure = f"no end after {PATIENCE:.0f} s"
        except (EOFError, OSError):
            failure = "the code ended its process"
        self.stop()
        return Outcome(failure=failure)


@contextlib.contextmanager
def _environment(values: dict[str, str]) -> Iterator[None]:
    before = {name: os.environ.get(name) for name in values}
    os.environ.update(values)
    try:
        yield
    finally:
        for name, value in before.items():
            if value is None:
                os.environ.pop(name)
            else:
                os.environ[name] = value


def _serve(code: Code, connection: Connection) -> None:
    quiet = os.open(os.devnull, os.O_WRONLY)
    os.dup2(quiet, 1)
    os.dup2(quiet, 2)
    while True:
        try:
            verb, arguments = connection.recv()
        except EOFError:
            return
        connection.send(_version(code) if verb == "version" else _run(code, *arguments))


def _version(code: Code) -> str | Outcome:
    try:
        return code.version()
    except (ImportError, OSError) as error:
        return Outcome(failure=str(error))


def _run(code: Code, lift: Lift, setting: Setting, duration: float) -> Outcome:
    try:
        run = code.prepare(lift, setting, duration)
        gc.collect()
        gc.disable()
        start = time.perf_counter()
        run.integrate()
        seconds = time.perf_counter() - start
        return Outcome(seconds, run.tensions())
    except Unfit as unfit:
        return Outcome(failure=str(unfit))
    except Exception as error:
        return Outcome(failure=f"{type(error).__name__}: {error}")
    finally:
        gc.enable()
