"""The load, what it stands on and what guides it into mechanics."""
