"""Water that remembers: radiation of bodies from hydrodynamic databases into forces on them."""

from __future__ import annotations

from functools import lru_cache

from gantline.assembly.afloat.databases import from_database
from gantline.assembly.afloat.hulls import afloat_path
from gantline.assembly.parts import Json, Parts
from gantline.hydro.database import HydrodynamicDatabase
from gantline.hydro.memory import Memory, fit_memory
from gantline.scenario import Scenario
from gantline.scenario.afloat.water import Afloat, Water
from gantline.scenario.errors import Doubt

__all__ = ["add_radiation", "memory_of", "memory_terms"]


def memory_of(scenario: Scenario, name: str, body: Afloat) -> Memory | None:
    """What the water around a body remembers; None of a body without `radiation`.

    Raises:
        ScenarioError: if its database cannot be used.
    """
    given = body.radiation
    if given is None:
        return None
    density = (scenario.water or Water()).density
    path = (*afloat_path(scenario, name), "radiation")

    def fitted(database: HydrodynamicDatabase) -> Memory:
        return _fitted(_Same(database), density)

    return from_database(scenario, path, (given.database, given.body, given.heading_in_file), fitted)


class _Same:
    """A database by identity: `from_database` reads each file once."""

    def __init__(self, database: HydrodynamicDatabase) -> None:
        self.database = database

    def __hash__(self) -> int:
        return id(self.database)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Same) and other.database is self.database


@lru_cache(maxsize=8)
def _fitted(same: _Same, density: float) -> Memory:
    """A fit, made once for all cases of a lift."""
    return fit_memory(same.database, density)


def add_radiation(parts: Parts, scenario: Scenario, name: str, body: Afloat) -> None:
    """Add the added mass of infinite frequency and the memory of a body with `radiation`.

    Raises:
        ScenarioError: if its database cannot be used.
    """
    memory = memory_of(scenario, name, body)
    if memory is None:
        return
    assert body.radiation is not None
    path = (*afloat_path(scenario, name), "radiation")
    parts.doubts += [Doubt(path, f"radiation of {name}: {doubt}") for doubt in memory.doubts]
    place = {"body": name, "at": list(body.radiation.at)}
    added = {"type": "added_mass", "name": f"{name}.added_mass", **place}
    parts.forces.append({**added, "matrix": memory.infinite_added_mass.tolist()})
    remembered = {"type": "memory", "name": f"{name}.radiation", **place}
    parts.forces.append({**remembered, "terms": memory_terms(memory)})


def memory_terms(memory: Memory) -> list[Json]:
    """K of a document: a pole and a residue for each oscillator."""
    return [
        {
            "pole": [float(pole.real), float(pole.imag)],
            "real": residue.real.tolist(),
            "imaginary": residue.imag.tolist(),
        }
        for pole, residue in zip(memory.poles, memory.residues, strict=True)
    ]
