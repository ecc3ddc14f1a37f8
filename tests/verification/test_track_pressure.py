"""Pressure under two tracks: closed forms, and many springs of which none pulls."""

from __future__ import annotations

import numpy as np
import pytest

from gantline.assembly.loads.resting import rest_on_ground
from gantline.results.cranes.track_pressure import line_pressures, tipping_utilisation

LENGTH, GAUGE, WIDTH, MATS = 9.0, 8.4, 1.5, 6.0
G = 9.81


def under_one(force: float, eccentricity: float) -> list[float]:
    """Forces under the ends of both tracks, each with a force at a distance ahead of its middle."""
    front = force * (0.5 + eccentricity / LENGTH)
    return [front, force - front] * 2


def test_a_force_in_the_middle_of_a_track_presses_evenly() -> None:
    """lifts of 150 t at 16 m over the side: 523 t on one track, 380 kPa, 95 kPa under mats of 6 m."""
    track = 523e3 * G
    found = line_pressures(np.array([[track / 2, track / 2, 0.0, 0.0]]), LENGTH)[0]
    # The figures are rounded to three digits.
    assert found[:2] / WIDTH == pytest.approx(380e3, rel=1e-3)
    assert found[:2] / MATS == pytest.approx(95e3, rel=1e-3)
    assert found[2:] == pytest.approx(0.0)


@pytest.mark.parametrize("eccentricity", [0.3, 1.0, LENGTH / 6, -1.0])
def test_within_the_middle_third_the_pressure_is_a_trapezium(eccentricity: float) -> None:
    """F/L (1 ± 6 e/L): no end is clear of the ground."""
    found = line_pressures(np.array([under_one(900.0, eccentricity)]), LENGTH)[0]
    ends = [900.0 / LENGTH * (1 + sign * 6 * eccentricity / LENGTH) for sign in (1, -1)]
    # Bisection leaves the last digits; 1e-12 of the mean pressure of 100 is 1e-10.
    assert found == pytest.approx([*ends, *ends], abs=1e-10)


@pytest.mark.parametrize("eccentricity", [2.0, 3.5, 4.3, -3.5])
def test_beyond_it_the_pressure_is_a_triangle(eccentricity: float) -> None:
    """Over 3 (L/2 - e), its largest 2 F / (3 (L/2 - e)); the other end is clear."""
    found = line_pressures(np.array([under_one(900.0, eccentricity)]), LENGTH)[0]
    largest = 2 * 900.0 / (3 * (LENGTH / 2 - abs(eccentricity)))
    ends = [largest, 0.0] if eccentricity > 0 else [0.0, largest]
    assert found == pytest.approx([*ends, *ends], rel=1e-12)


@pytest.mark.parametrize("place", [(1.0, 0.5), (2.2, 2.0), (3.0, 3.0), (-2.6, 1.0)])
def test_tracks_of_one_crane_share_the_moment_as_many_springs_do(place: tuple[float, float]) -> None:
    """Two rows of 3000 springs under a rigid body whose weight stands at a place aside of its middle."""
    count, weight, stiffness = 3000, 7.3e6, 1e6
    along = (np.arange(count) + 0.5) / count * LENGTH - LENGTH / 2
    springs = np.array([(x, side * GAUGE / 2, 0.0) for side in (1, -1) for x in along])
    away = springs - np.array([place[0], place[1], 0.0])
    forces = rest_on_ground(away, weight, stiffness).forces.reshape(2, count)
    sums, moments = forces.sum(axis=1), forces @ along
    # What four corners would carry of it: any split of the moment between the tracks will do.
    carried = [sums[0] / weight, sums[1] / weight]
    corners = []
    for track in range(2):
        eccentricity = moments.sum() * carried[track] / sums[track]
        corners += [sums[track] * (0.5 + eccentricity / LENGTH), sums[track] * (0.5 - eccentricity / LENGTH)]
    found = line_pressures(np.array([corners]), LENGTH)[0].reshape(2, 2)
    per_length = forces[:, [-1, 0]] / (LENGTH / count)
    # The last spring stands half a part inside of the end, 1/6000 of the length, where the pressure of a
    # triangle of a third of it is less by 1/1000; the turn of the body, 1e-3, changes levers by its square.
    assert found == pytest.approx(per_length, abs=2e-3 * found.max())


@pytest.mark.parametrize("place", [(0.3, 0.5), (2.2, 2.0), (-1.0, 1.0), (0.0, 0.0)])
@pytest.mark.parametrize("rises", [(0.010, -0.005), (-0.03, 0.02), (0.0, 0.08)])
def test_tracks_on_uneven_ground_share_as_many_springs_do(
    place: tuple[float, float], rises: tuple[float, float]
) -> None:
    """Two rows of 3000 springs of which the ground rises from back to front by `rises` [m], not alike."""
    count, weight, corner = 3000, 7.3e6, 150e6
    along = (np.arange(count) + 0.5) / count * LENGTH - LENGTH / 2
    # What both tracks rise by the body leans by: it begins with that.
    ground = np.concatenate([(rise - np.mean(rises)) * along / LENGTH for rise in rises])
    springs = np.array([(x, side * GAUGE / 2, 0.0) for side in (1, -1) for x in along])
    # Ground that is lower is a spring that is shorter; together they rock as the two ends of each track do.
    away = springs - np.array([place[0], place[1], 0.0]) - np.outer(ground, (0.0, 0.0, 1.0))
    forces = rest_on_ground(away, weight, 6 * corner / count).forces.reshape(2, count)
    sums, moment = forces.sum(axis=1), (forces @ along).sum()
    corners = [sums[0] / 2 + moment / LENGTH, sums[0] / 2 - moment / LENGTH, sums[1] / 2, sums[1] / 2]
    uneven = 6 * corner * np.array([rises]) / LENGTH**2
    found = line_pressures(np.array([corners]), LENGTH, uneven)[0].reshape(2, 2)
    per_length = forces[:, [-1, 0]] / (LENGTH / count)
    # As above, of triangles down to an eighth of the length: the last spring is half a part inside, 1/750.
    assert found == pytest.approx(per_length, abs=2e-3 * found.max())


def test_all_under_one_end_has_a_pressure_all_the_same() -> None:
    """Where no strip could carry it: a hundredth of the length at the end carries it."""
    found = line_pressures(np.array([[500.0, 0.0, 500.0, 0.0], [0.0] * 4]), LENGTH)
    assert found[0] == pytest.approx([2 * 500.0 / (LENGTH / 100), 0.0] * 2, rel=1e-9)
    assert found[1] == pytest.approx(0.0)


#: Radius [m] and tipping load over the side [t] of the hand figures, from moments about the track.
TIPPING = ((12, 480), (14, 377), (16, 308), (18, 260), (20, 223), (24, 173), (28, 139))


@pytest.mark.parametrize(("radius", "tonnes"), TIPPING)
def test_a_load_at_rest_counts_against_the_load_that_tips(radius: float, tonnes: float) -> None:
    """The moment that is used is the load over the tipping load, for any load."""
    base, weight, boom = 190 + 95, 250, 60
    boom_at = 1.6 + 0.45 * (radius - 1.6)
    own, aside = base + weight + boom, (boom * boom_at - weight * 6.5) / (base + weight + boom)
    limit = own * (GAUGE / 2 - aside) / (radius - GAUGE / 2)
    assert limit == pytest.approx(tonnes, abs=0.5)  # the figures are whole tonnes
    for share in (0.0, 0.4, 0.99, 1.0):
        load = share * limit
        across = (own * aside + load * radius) / (own + load)
        left = (own + load) * (0.5 + across / GAUGE)
        right = (own + load) - left
        corners = np.array([[left / 2, left / 2, right / 2, right / 2]])
        found = tipping_utilisation(corners, np.array([own]), np.array([[0.0, aside]]), LENGTH, GAUGE)
        assert found[0] == pytest.approx(share, abs=1e-12)


@pytest.mark.parametrize("share", [0.3, 0.9])
def test_a_load_holds_a_crane_whose_own_weight_lies_beyond_a_track(share: float) -> None:
    """Without a load it would go over its right track, with W e; Q at r to the left holds Q (r + b/2)."""
    own, beyond, radius = 500.0, 0.5, 8.0
    load = own * beyond / share / (radius + GAUGE / 2)
    left = (load * (radius + GAUGE / 2) - own * beyond) / GAUGE
    right = own + load - left
    corners = np.array([[left / 2, left / 2, right / 2, right / 2]])
    centre = np.array([[0.0, -GAUGE / 2 - beyond]])
    found = tipping_utilisation(corners, np.array([own]), centre, LENGTH, GAUGE)
    assert found[0] == pytest.approx(share, abs=1e-12)
