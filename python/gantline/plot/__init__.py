"""Pictures of a recording, by matplotlib's `Figure` (never pyplot)."""

from gantline.plot.pictures import PICTURES, figures, save_pictures

__all__ = ["PICTURES", "figures", "save_pictures"]
