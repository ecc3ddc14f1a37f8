"""The undisturbed surface of the water over time, from the regular waves that it is made of."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from gantline.results.rotation import axes, heading
from gantline.results.strength import FromJson
from gantline.results.variable import FloatArray

__all__ = ["Sea", "out_of_place"]

#: Turn of a vessel from which the forces of its first heading are doubtful [rad].
_TURNED = math.radians(10.0)
#: Phase by which waves come sooner or later to a vessel that has drifted, from which it counts.
_DRIFTED = math.pi / 2


@dataclass(frozen=True)
class Sea(FromJson):
    """Waves on the water: η = g(t) Σ a cos(k·x − ωt + ε), g growing from 0 to 1 with two derivatives.

    Attributes:
        components: regular waves: `frequency` ω [rad/s], `wave_number` k, world x and y [rad/m],
            `amplitude` a [m], `phase` ε [rad].
        rise_time: in which they grow [s].
        trains: what the lift file says of them: `name`, `height` from crest to trough or significant [m],
            `period` or that of the peak [s], `direction` [rad], `seed`, None where all are alike.
    """

    components: Sequence[Mapping[str, Any]] = ()
    rise_time: float = 1.0
    trains: Sequence[Mapping[str, Any]] = ()

    def words(self) -> list[str]:
        """Height, period and direction of all waves, a phrase each."""
        found = []
        for train in self.trains:
            height, period = (f"{train[key]:.3g} {unit}" for key, unit in (("height", "m"), ("period", "s")))
            towards = f"towards {math.degrees(train['direction']):.3g} deg"
            if train["seed"] is None:
                found.append(f"{train['name']} {height} every {period} {towards}")
            else:
                found.append(
                    f"{train['name']} {height} significant, peak {period}, {towards}, record {train['seed']}"
                )
        return found

    def elevation(self, time: FloatArray, place: FloatArray) -> FloatArray:
        """η above still water [m].

        Args:
            time: (samples,) [s].
            place: world x and y (samples, ..., 2) [m].

        Returns:
            (samples, ...).
        """
        beside = (slice(None), *[None] * (place.ndim - 2))
        found = np.zeros(place.shape[:-1])
        for wave in self.components:
            x, y = wave["wave_number"]
            along = x * place[..., 0] + y * place[..., 1]
            found += wave["amplitude"] * np.cos(along - wave["frequency"] * time[beside] + wave["phase"])
        share = np.clip(time / self.rise_time, 0.0, 1.0)
        growth: FloatArray = share**3 * (10.0 - share * (15.0 - 6.0 * share))
        return found * growth[beside]


def out_of_place(
    document: Mapping[str, Any], columns: Mapping[str, FloatArray], names: Mapping[str, Sequence[str]]
) -> list[str]:
    """A sentence for each vessel that has turned or drifted away from where its wave forces are for.

    They keep amount, direction and phase of where the lift file has the vessel. On one that turns by and by
    the moment that pitched it rolls it, which can heel it far more than any such sea does.

    Args:
        document: What has been assembled of the lift.
        columns: What was recorded: `time`, `body_position`, `body_orientation`.
        names: Names along their dimensions.
    """
    sentences = []
    for force in (one for one in document.get("forces", ()) if one["type"] == "wave"):
        body = next(one for one in document["bodies"] if one["name"] == force["body"])
        at = list(names["body"]).index(force["body"])
        joint, centre = body["joint"], np.array(body.get("centre_of_gravity", (0.0, 0.0, 0.0)))
        first = np.array(joint["orientation"])
        turns = np.unwrap(heading(columns["body_orientation"][:, at])) - heading(first)
        turned = np.abs(turns - 2 * math.pi * np.round(turns[:1] / (2 * math.pi)))
        arm = np.array(force["at"])
        given = np.array(joint["position"]) + axes(first) @ arm
        found = columns["body_position"][:, at] + axes(columns["body_orientation"][:, at]) @ (arm - centre)
        along = np.array([wave["wave_number"] for wave in document["sea"]["components"]])
        energy = np.array([wave["amplitude"] ** 2 for wave in document["sea"]["components"]])
        phase = np.abs((found - given)[:, :2] @ along.T) @ energy / energy.sum()
        for doubtful, what in (
            (turned > _TURNED, f"turns by up to {math.degrees(turned.max()):.3g} deg"),
            (phase > _DRIFTED, f"drifts by up to {np.hypot(*(found - given)[:, :2].T).max():.3g} m"),
        ):
            if doubtful.any():
                since = float(columns["time"][int(np.argmax(doubtful))])
                sentences.append(
                    f"wave forces of {force['body']} are for its place and heading in the lift file; "
                    f"it {what} and from {since:.0f} s on feels those of other waves; mooring lines hold it"
                )
    return sentences
