"""Recordings made ready for a browser: packed, decimated, and put into pages that need nothing else."""

from gantline.viewer.bundle import BundleMissing, bundle
from gantline.viewer.pack import Packed, pack

__all__ = ["BundleMissing", "Packed", "bundle", "pack"]
