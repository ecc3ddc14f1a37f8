"""Pictures of a recording or of a comparison, by matplotlib's `Figure` (never pyplot)."""

from gantline.plot.comparison import comparison_figures
from gantline.plot.pictures import PICTURES, figures, save_comparison_pictures, save_pictures

__all__ = ["PICTURES", "comparison_figures", "figures", "save_comparison_pictures", "save_pictures"]
