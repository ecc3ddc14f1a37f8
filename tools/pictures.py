"""Draws the pictures of README and documentation anew, from runs of lifts and a ship block."""

from __future__ import annotations

import io
import math
from collections.abc import Iterable, Mapping
from itertools import chain
from pathlib import Path

import matplotlib
from matplotlib.figure import Figure
from PIL import Image

import gantline
from gantline.cad.ship_block import ShipBlockSizes, ship_block
from gantline.cli.cad_picture import model_picture
from gantline.cli.lost_load import figures_of
from gantline.plot import comparison_figures, figures
from gantline.plot.seas import seas_picture
from gantline.plot.style import RC
from gantline.results.file.saved_seas import SavedSeas
from gantline.scenario import load_scenario
from gantline.study import lose_load, run_seas

ROOT = Path(__file__).resolve().parents[1]
#: Name of the picture in the documentation by the name of the plot.
PICTURES = {
    "sling_tension": "equalizer_tension",
    "system": "equalizer_views",
    "compare_sling_tension": "compare_tension",
    "structure": "cad_structure",
}
PICTURES_OF_LIFTS = {
    "goliath": {"stages": "goliath_stages"},
    "floating_crane": {"stages": "floating_crane_stages", "vessels": "floating_crane_vessels"},
    "floating_crane_and_crawlers": {"stages": "several_cranes_stages"},
    "revolving_crane": {"stages": "revolving_crane_stages"},
    "off_a_barge": {"hook_load": "off_a_barge"},
    "onto_a_platform": {"hook_load": "onto_a_platform"},
    "spreader_bar": {"system": "spreader_bar"},
    "upending": {"stages": "upending_stages"},
    "monopile": {"stages": "monopile_stages"},
    "heavy_lift_ship": {"stages": "heavy_lift_ship_stages"},
    "crane_barge_in_swell": {"vessels": "waves"},
    "splash_zone": {"hook_load": "splash_zone"},
    "wind_turbine": {"stages": "wind_turbine_stages", "attitude": "wind_grows"},
}
#: What puts a lift in gusts: its load has the areas of its box.
IN_GUSTS = {
    "wind": {"speed": "9 m/s", "direction": "20 deg", "gusts": {"speed": "13 m/s", "seed": 3}},
    "load.wind_areas": {
        "end": {"area": "14 m^2", "coefficient": 1.2, "along": "x", "at": ["0 m", "0 m", "1.75 m"]},
        "side": {"area": "38 m^2", "coefficient": 1.2, "along": "y", "at": ["0 m", "0 m", "1.75 m"]},
    },
}
DOTS_PER_INCH = 150


def main() -> None:
    """Simulate, draw, and keep the files small."""
    lift = ROOT / "scenarios" / "equalizer"
    recording = gantline.simulate(lift)
    comparison = gantline.compare(
        recording,
        gantline.simulate(lift, integrator="del", step=0.01),
        names=("equalizer", "equalizer, integrator=del, step=10 ms"),
    )
    structure = model_picture(ship_block(ShipBlockSizes(length=20, breadth=12, height=9, mass=120e3)).model)
    assert structure is not None
    folder = ROOT / "docs" / "images"
    folder.mkdir(exist_ok=True)
    drawn = chain(figures(recording), comparison_figures(comparison), [("structure", structure)])
    keep(drawn, PICTURES, folder)
    for name, pictures in PICTURES_OF_LIFTS.items():
        keep(figures(gantline.simulate(ROOT / "scenarios" / name)), pictures, folder)
    blown = load_scenario(ROOT / "scenarios" / "spreader_bar").changed(IN_GUSTS)
    keep(figures(gantline.simulate(blown)), {"attitude": "gusts"}, folder)
    keep(lost_load_figures(), {"barge": "lost_load"}, folder)
    keep([("seas", seas_figure())], {"seas": "seas"}, folder)


def lost_load_figures() -> list[tuple[str, Figure]]:
    """What becomes of the vessel of `floating_crane` whose load is lost."""
    question = gantline.Statics("floating_crane")
    return figures_of(lose_load(question, question.equilibrium(), "load"))


def seas_figure() -> Figure:
    """In which swell `crane_barge_in_swell` may be done: the table of `docs/concepts/seas.md`."""
    found = run_seas(
        "crane_barge_in_swell",
        heights=[0.4, 0.8, 1.2],
        periods=[8.0, 10.0],
        directions=[math.radians(angle) for angle in (180, 90)],
    )
    return seas_picture(SavedSeas.from_json(found.to_json()))


def keep(pictures: Iterable[tuple[str, Figure]], names: Mapping[str, str], folder: Path) -> None:
    """Write those of the pictures that have a name in the documentation."""
    for plot, figure in pictures:
        if plot not in names:
            continue
        drawn = io.BytesIO()
        with matplotlib.rc_context(RC):
            figure.savefig(drawn, format="png", dpi=DOTS_PER_INCH)
        path = folder / f"{names[plot]}.png"
        picture = Image.open(drawn).convert("RGB")
        if plot == "structure":  # shaded: few colours keep it small
            picture = picture.quantize(256, Image.Quantize.MAXCOVERAGE, dither=Image.Dither.NONE)
        picture.save(path, optimize=True)
        print(f"{path.relative_to(ROOT)}: {path.stat().st_size / 1e3:.0f} kB")


if __name__ == "__main__":
    main()
