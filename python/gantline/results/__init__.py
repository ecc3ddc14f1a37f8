"""Recordings of lifts: their variables, files, metrics."""

from gantline.results.recording import Recording, open_recording
from gantline.results.variable import Variable

__all__ = ["Recording", "Variable", "open_recording"]
