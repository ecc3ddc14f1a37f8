"""From a scenario in yard words to a system in words of mechanics."""

from gantline.assembly.assemble import Assembly, assemble, integrator_settings

__all__ = ["Assembly", "assemble", "integrator_settings"]
