"""Cranes, booms, hooks and hoists in a lift file."""
