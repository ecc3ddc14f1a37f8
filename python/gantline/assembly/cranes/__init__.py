"""Cranes, their hooks and hoists into mechanics."""
