"""Compensators that give nothing: rods on their stops, waves too slow, gas beyond what they may carry."""

from __future__ import annotations

from collections.abc import Iterator

from gantline.assembly.cranes.compensator_stages import Stage, stages
from gantline.scenario import Rigging, Scenario
from gantline.scenario.cranes.compensator import rod_of
from gantline.scenario.errors import Doubt
from gantline.scenario.plan.pins import Pins
from gantline.units import format_quantity

__all__ = ["doubtful_compensators"]

#: A load on its gas moves so many times as far as its hook at most, damping aside: more is at its own period.
_MANY = 10.0


def doubtful_compensators(scenario: Scenario, rigging: Rigging, pins: Pins) -> Iterator[Doubt]:
    """Each compensator whose rod stays on a stop, that waves are too slow for, or that is overcharged.

    Nothing of the first two where a pin holds the rod all along.
    """
    compensators = scenario.compensators or {}
    pulled = {name for names in pins.pulled for name in names}
    every = list(stages(scenario, rigging))
    for name, given in compensators.items():
        capacity = given.rated_capacity
        most = given.law.pull(given.stroke)
        if capacity is not None and most > capacity * scenario.simulation.gravity:
            may = _force(capacity * scenario.simulation.gravity)
            pulls = f"the gas of {name} pulls with {_force(most)} at the end of the stroke"
            sentence = f"{pulls}, and it may carry {may}: past that the stroke is of no use"
            yield Doubt(("compensators", name, "rated_capacity"), sentence)
        if pins.at_start.get(rod_of(name), False) and rod_of(name) not in pulled:
            continue
        for stage in (one for one in every if one.name == name):
            yield from _on_stop(scenario, stage)
            yield from _slow_waves(scenario, stage)


def _on_stop(scenario: Scenario, stage: Stage) -> Iterator[Doubt]:
    """A rod that the load leaves on a stop, seals counted."""
    given = (scenario.compensators or {})[stage.name]
    law, seals = given.law, given.seal_friction
    least, most = law.rod_in + seals, law.pull(given.stroke)
    hangs = f"{stage.where} {_force(stage.pull)} hang on the gas of {stage.name}, its rod counted"
    snatches = "and gives nothing but for snatches past that"
    if stage.pull <= least:
        holds = f"{_force(least)} with the rod in" + (", seals counted" if seals else "")
        stays = f"no more than it holds, {holds}: the rod stays in, {snatches}"
    elif stage.pull >= most:
        stays = f"no less than it pulls with at the end of the stroke, {_force(most)}: "
        keeps = f"only its seals, {_force(seals)}, may keep the rod off its outer stop"
        stays += f"the rod stays out, {snatches}" if stage.pull >= most + seals else keeps
    else:
        return
    yield Doubt(("compensators", stage.name), f"{hangs}, {stays}")


def _slow_waves(scenario: Scenario, stage: Stage) -> Iterator[Doubt]:
    """Waves that a load on its gas answers by no less than its hook does: (PC6)."""
    if stage.period is None or not scenario.vessels:
        return
    for name, train in (scenario.waves or {}).items():
        ratio = (stage.period / train.main_period) ** 2
        if ratio >= 2.0:
            continue
        times = 1.0 / abs(1.0 - ratio) if ratio != 1.0 else _MANY
        much = f"{times:.2g} times" if times < _MANY else f"more than {_MANY:g} times"
        periods = (stage.period, train.main_period, stage.period / 2.0**0.5)
        period, waves, least = (format_quantity(one, "s", 1) for one in periods)
        own = f"{stage.name} with the load {stage.where} has a period of {period} of its own"
        sentence = f"{own}, and {name} one of {waves}"
        moves = f"the load goes {much} as far as its hook, damping aside; below {least} it goes less"
        yield Doubt(("compensators", stage.name), f"{sentence}: {moves}")


def _force(value: float) -> str:
    return format_quantity(value, "kN", 0)
