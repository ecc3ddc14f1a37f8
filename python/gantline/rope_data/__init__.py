"""Rope classes of EN 12385-4: mass, metallic area, axial stiffness and minimum breaking force by diameter."""

from gantline.rope_data.classes import GRADES, RopeClass, rope_class, rope_classes

__all__ = ["GRADES", "RopeClass", "rope_class", "rope_classes"]
