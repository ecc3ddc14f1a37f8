"""Lift files from Python values; JSON is YAML."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from gantline.cad.mesh import TriangleMesh

__all__ = ["plain_lift", "vessel", "write_obj"]


def plain_lift(folder: Path, bodies: dict[str, Any] | None = None, **given: Any) -> Path:
    """The path of a lift file with plain bodies, if there are any, and other sections."""
    if bodies is not None:
        given = {"mechanics": {"bodies": bodies, **given.pop("mechanics", {})}, **given}
    whole = {"format": 1, "lift": {"title": "A lift"}, "duration": "1 s", **given}
    path = folder / "lift.yaml"
    path.write_text(json.dumps(whole), encoding="utf-8")
    return path


def vessel(mass: float, at: tuple[float, float, float], draft: float, **given: Any) -> dict[str, Any]:
    """A vessel of one mass [kg] at a place [m]."""
    place = [f"{part!r} m" for part in at]
    return {
        "draft": f"{draft!r} m",
        "masses": {"all": {"mass": f"{mass!r} kg", "at": place}},
        "radii_of_gyration": ["15 m", "30 m", "30 m"],
        **given,
    }


def write_obj(path: Path, mesh: TriangleMesh) -> Path:
    """Three vertices of its own for each triangle, as files with seams have them."""
    corners = mesh.corners.reshape(-1, 3)
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in corners.tolist()]
    lines += [f"f {k} {k + 1} {k + 2}" for k in range(1, len(corners), 3)]
    path.write_text("\n".join(lines), encoding="utf-8")
    return path
