"""Loads from CAD: parts with mass, centre of gravity and inertia."""
