"""The command line. Verbs load what they need when they run, so `gantline --help` loads nothing else."""

from gantline.cli.app import main

__all__ = ["main"]
