"""Statics of a lift: how it hangs at a time of its plan, how it swings about that, how errors change it."""

from gantline.statics.answers import ContactForce, Equilibrium, Losses, Mode, NoEquilibriumError, Sensitivity
from gantline.statics.lift import Statics
from gantline.statics.linear import LinearModel

__all__ = [
    "ContactForce",
    "Equilibrium",
    "LinearModel",
    "Losses",
    "Mode",
    "NoEquilibriumError",
    "Sensitivity",
    "Statics",
]
