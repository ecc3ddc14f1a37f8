//! The top of a support: a flat, level rectangle of the world, and the flat sides of a body that may lie on it.
//!
//! A side that lies flat over the middle of the top carries there, wherever the body has been moved; one that is steeper
//! carries at the rim, for the low rim of the top is what it touches first. Where the edge of the side has come past that
//! place it carries on its edge, until that has left the top: there the body leaves the support. All of that is the least of one
//! convex function over what of the body is upright over the top,
//!
//! ```text
//! f = z + φ(x) + φ(y),  φ(x) = 0.2 |x| + 0.15 x²/h     z height of the body over the top, h half of its side
//! ```
//!
//! as if the top were a little domed, with slopes of 0.2 beside its middle and of 0.5 at its rim. Its least is one place, and moves without
//! jumps as the body turns and slides, from side to side by the edge between them too: the underside of a convex body is a convex function,
//! however many sides it has and at whichever angles they meet. It is always a point of the body against the plane
//! of the top, so the force is upright, however the body is tilted.

use glam::DVec3;

use super::plane::Plane;
use super::spot::Spot;
use crate::tree::pose::Pose;

/// A body so far below the top of a support is beside it and not on it, in half sides of the top.
const DEEPEST: f64 = 1.0;
/// A side that is steeper than this lies on nothing: cosine of its angle to the top.
const LEAST_SLOPE: f64 = 0.5;
/// Steeper sides count where they meet in an edge or a corner that is lower than all else over the top: by so much, for one
/// that flatter sides share is theirs [m], and so far within the top, for at its rim they lie on nothing [1].
const LOWER: f64 = 1e-9;
/// Sides of a body are so near to those of a convex one [m].
const ROUGH: f64 = 1e-3;
/// A side so little turned downwards stands upright: cosine of its angle to the top.
const UPRIGHT: f64 = 1e-6;
/// A side that rises by less than the first of its length along the top carries in the middle of it, by more than the
/// second at its rim: 11° and 27°.
const RISES: [f64; 2] = [0.2, 0.5];

/// A support's top and the sides of a body.
#[derive(Debug, Clone, PartialEq)]
pub struct Pad {
    /// The top, world axes: its middle, up, and the directions of its sides.
    pub top: Plane,
    /// Half of its two sides [m].
    pub half: [f64; 2],
    /// What may lie on it.
    pub sides: Vec<Side>,
}

/// A flat side of a body.
#[derive(Debug, Clone, PartialEq)]
pub struct Side {
    /// Its plane, body frame; the normal leads out of the body.
    pub face: Plane,
    /// Its corners along the tangents of `face` [m]: convex, in order.
    pub outline: Vec<[f64; 2]>,
    /// A ball around them: its middle, body frame, and its radius [m].
    pub ball: (DVec3, f64),
}

/// Where a body is nearest to the top.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Nearest {
    /// The place, body frame [m].
    point: DVec3,
    /// How high it is over the top [m]; negative below.
    above: f64,
    /// Number of its side, from 1.
    side: u64,
    /// f there [m].
    value: f64,
}

/// The top in the frame of a body: up, the directions of its sides, its middle [m].
struct Seen {
    up: DVec3,
    tangents: [DVec3; 2],
    middle: DVec3,
}

/// How the plane of a side lies over the top: its height over the middle [m], how fast it rises along the sides of the top,
/// and whether it is too steep to lie on it.
struct Tilt {
    height: f64,
    rises: [f64; 2],
    is_steep: bool,
}

impl Side {
    /// A side in a plane with its corners along the tangents of that [m].
    pub fn new(face: Plane, outline: Vec<[f64; 2]>) -> Self {
        let place = |[along, across]: [f64; 2]| face.tangents[0] * along + face.tangents[1] * across;
        let middle = outline.iter().copied().map(place).sum::<DVec3>() / outline.len() as f64;
        let radius = outline.iter().map(|corner| (place(*corner) - middle).length()).fold(0.0, f64::max);
        Self { face, outline, ball: (face.point + middle, radius) }
    }
}

impl Pad {
    /// Where the body at `pose` may lie on the top; the body is the first of the two, the world the second.
    pub fn spot(&self, pose: &Pose) -> Spot {
        let is_on = |found: &Nearest| -found.above <= DEEPEST * self.half[0].max(self.half[1]);
        self.nearest(pose).filter(is_on).map_or_else(Spot::none, |found| Spot {
            is_near: true,
            is_swapped: false,
            point: found.point,
            plane: self.top,
            crossing: None,
            feature: found.side,
        })
    }

    /// Where f of the body at `pose` is least over the top; nothing where nothing that could lie there is over it.
    fn nearest(&self, pose: &Pose) -> Option<Nearest> {
        let inwards = pose.rotation.transpose();
        let seen = Seen {
            up: inwards * self.top.normal,
            tangents: self.top.tangents.map(|tangent| inwards * tangent),
            middle: inwards * (self.top.point - pose.position),
        };
        let heights = self.sides.iter().filter_map(|side| self.tilt(side, &seen));
        let highest = heights.max_by(|one, other| one.height.total_cmp(&other.height))?;
        let (mut flat, mut steep) = (None, None);
        for (number, side) in (1..).zip(&self.sides) {
            let Some(tilt) = self.tilt(side, &seen).filter(|tilt| !self.is_below(tilt, &highest)) else {
                continue;
            };
            let Some(place) = self.place(&tilt, (number, side), pose) else { continue };
            let least: &mut Option<Nearest> = if tilt.is_steep { &mut steep } else { &mut flat };
            if least.is_none_or(|least| place.value < least.value) {
                *least = Some(place);
            }
        }
        let is_within = |place: &Nearest| {
            let along = self.top.along(pose.point(place.point));
            along.iter().zip(self.half).all(|(at, half)| at.abs() < half * (1.0 - LOWER))
        };
        let is_lower = |steep: &Nearest| flat.is_none_or(|flat| steep.value < flat.value - LOWER);
        steep.filter(|steep| is_lower(steep) && is_within(steep)).or(flat)
    }

    /// How the plane of a side lies over the top; nothing where the side looks upwards or is beside the top.
    fn tilt(&self, side: &Side, seen: &Seen) -> Option<Tilt> {
        let slope = side.face.normal.dot(seen.up);
        if slope > -UPRIGHT {
            return None;
        }
        let (centre, radius) = side.ball;
        let apart = centre - seen.middle;
        let reach = radius + self.half[0].hypot(self.half[1]);
        if (apart - seen.up * apart.dot(seen.up)).length_squared() > reach * reach * (1.0 + LOWER) {
            return None;
        }
        Some(Tilt {
            height: side.face.depth(seen.middle) / slope,
            rises: seen.tangents.map(|tangent| -side.face.normal.dot(tangent) / slope),
            is_steep: slope > -LEAST_SLOPE,
        })
    }

    /// True where the plane of a side is lower than that of another all over the top: a convex body is above every plane of its
    /// sides, so no part of this side is over the top.
    fn is_below(&self, tilt: &Tilt, other: &Tilt) -> bool {
        let [x, y] = [0, 1].map(|axis| (tilt.rises[axis] - other.rises[axis]).abs() * self.half[axis]);
        tilt.height - other.height + x + y < -ROUGH
    }

    /// Where f of one side with its number is least.
    fn place(&self, tilt: &Tilt, (number, side): (u64, &Side), pose: &Pose) -> Option<Nearest> {
        let Tilt { height, rises, .. } = *tilt;
        let ([x, y], value) = self.least(rises, side, pose)?;
        let above = height + rises[0] * x + rises[1] * y;
        let [first, second] = self.top.tangents;
        let place = self.top.point + first * x + second * y + self.top.normal * above;
        let point = pose.rotation.transpose() * (place - pose.position);
        Some(Nearest { point, above, side: number, value: height + value })
    }

    /// Where along the top [m] the side carries, and f there less its height over the middle [m].
    fn least(&self, rises: [f64; 2], side: &Side, pose: &Pose) -> Option<([f64; 2], f64)> {
        let corner = |index: usize| {
            let [along, across] = side.outline[index % side.outline.len()];
            let [first, second] = side.face.tangents;
            self.top.along(pose.point(side.face.point + first * along + second * across))
        };
        let free = [0, 1].map(|axis| {
            let share = (rises[axis].abs() - RISES[0]) / (RISES[1] - RISES[0]);
            -rises[axis].signum() * self.half[axis] * share.clamp(0.0, 1.0)
        });
        let mut found: Option<([f64; 2], f64)> = None;
        let (mut left, mut right) = (false, false);
        for index in 0..side.outline.len() {
            let (from, to) = (corner(index), corner(index + 1));
            let turns = (to[0] - from[0]) * (free[1] - from[1]) - (to[1] - from[1]) * (free[0] - from[0]);
            left |= turns > 0.0;
            right |= turns < 0.0;
            if let Some(on_edge) = self.least_along(rises, from, to)
                && found.is_none_or(|(_, least)| on_edge.1 < least)
            {
                found = Some(on_edge);
            }
        }
        if left && right { found } else { Some((free, self.value(rises, free))) }
    }

    /// The same on what is over the top of an edge from one corner to another, nothing where none of it is.
    fn least_along(&self, rises: [f64; 2], from: [f64; 2], to: [f64; 2]) -> Option<([f64; 2], f64)> {
        let way = [to[0] - from[0], to[1] - from[1]];
        let at = |share: f64| [from[0] + share * way[0], from[1] + share * way[1]];
        let mut ends = [0.0, 1.0];
        // Where it comes past the middle of a side of the top, from which on f is another parabola.
        let mut bends = [0.0, 0.0];
        for axis in 0..2 {
            if way[axis] == 0.0 {
                if from[axis].abs() > self.half[axis] {
                    return None;
                }
                continue;
            }
            let [one, other] = [-1.0, 1.0].map(|sign| (sign * self.half[axis] - from[axis]) / way[axis]);
            ends = [f64::max(ends[0], one.min(other)), f64::min(ends[1], one.max(other))];
            bends[axis] = -from[axis] / way[axis];
        }
        let [start, end] = ends;
        if start > end {
            return None;
        }
        let bends = bends.map(|bend| bend.clamp(start, end));
        let knots = [start, bends[0].min(bends[1]), bends[0].max(bends[1]), end];
        let mut found = (at(start), self.value(rises, at(start)));
        for piece in knots.windows(2) {
            let middle = 0.5 * (piece[0] + piece[1]);
            let (mut slope, mut bend) = (0.0, 0.0);
            for axis in 0..2 {
                let curved = (RISES[1] - RISES[0]) / self.half[axis];
                let place = at(middle)[axis];
                slope += way[axis] * (rises[axis] + RISES[0] * place.signum() + curved * place);
                bend += way[axis] * way[axis] * curved;
            }
            let lowest = at((middle - slope / bend).clamp(piece[0], piece[1]));
            let value = self.value(rises, lowest);
            if value < found.1 {
                found = (lowest, value);
            }
        }
        Some(found)
    }

    /// f less the height over the middle [m].
    fn value(&self, rises: [f64; 2], place: [f64; 2]) -> f64 {
        let parts = [0, 1].map(|axis| {
            let (at, curved) = (place[axis], (RISES[1] - RISES[0]) / self.half[axis]);
            rises[axis] * at + RISES[0] * at.abs() + 0.5 * curved * at * at
        });
        parts[0] + parts[1]
    }
}

/// Directions of the sides of a top: `along` [world axes] made square to `normal`.
pub fn top(middle: DVec3, normal: DVec3, along: DVec3) -> Option<Plane> {
    let first = (along - normal * normal.dot(along)).try_normalize()?;
    Some(Plane { point: middle, normal, tangents: [first, normal.cross(first)] })
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DMat3;

    /// A box 4 × 2 m with its underside 1 m below its origin and an end over a top of 0.6 × 0.6 m at the origin.
    fn pad() -> Pad {
        let face = |point, normal, tangents| Plane { point, normal, tangents };
        let underside = Side::new(
            face(DVec3::new(0.0, 0.0, -1.0), -DVec3::Z, [DVec3::X, -DVec3::Y]),
            vec![[-2.0, -1.0], [2.0, -1.0], [2.0, 1.0], [-2.0, 1.0]],
        );
        let end = Side::new(
            face(DVec3::new(2.0, 0.0, 0.0), DVec3::X, [DVec3::Y, DVec3::Z]),
            vec![[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]],
        );
        let top = top(DVec3::ZERO, DVec3::Z, DVec3::X).unwrap();
        Pad { top, half: [0.3, 0.3], sides: vec![underside, end] }
    }

    fn at(x: f64, y: f64) -> Spot {
        pad().spot(&Pose { rotation: DMat3::IDENTITY, position: DVec3::new(x, y, 0.9) })
    }

    /// The box turned by an angle about y, its end downwards, so that a point of it comes to a place.
    fn turned(angle: f64, point: DVec3, place: DVec3) -> Pose {
        let rotation = DMat3::from_rotation_y(angle);
        Pose { rotation, position: place - rotation * point }
    }

    #[test]
    fn carries_in_its_middle_then_at_the_edge_then_not_at_all() {
        let middle = at(1.5, -0.5);
        assert!(middle.is_near && !middle.is_swapped);
        assert!((middle.point - DVec3::new(-1.5, 0.5, -1.0)).length() < 1e-12);
        // The middle of the top is 0.2 m beyond the body's end: the end lies on the top, which is 0.3 m to either side.
        let edge = at(2.2, 0.0);
        assert!(edge.is_near && !edge.is_swapped);
        assert!((edge.point - DVec3::new(-2.0, 0.0, -1.0)).length() < 1e-12);
        assert!(!at(2.31, 0.0).is_near);
        assert!(!at(0.0, 1.31).is_near);
        assert!(at(0.0, 1.29).is_near);
    }

    #[test]
    fn a_body_far_below_the_top_is_beside_it() {
        let pose = |z: f64| Pose { rotation: DMat3::IDENTITY, position: DVec3::new(0.0, 0.0, z) };
        assert!(pad().spot(&pose(0.71)).is_near);
        assert!(!pad().spot(&pose(0.69)).is_near);
    }

    #[test]
    fn a_tilted_side_lies_on_the_low_rim_of_the_top() {
        // Turned by 30° its end is low; a point of the underside well inside of the edge is upright over the middle.
        let point = DVec3::new(0.5, 0.0, -1.0);
        let spot = pad().spot(&turned(30.0_f64.to_radians(), point, DVec3::ZERO));
        // The rim is 0.3 m from the middle, along the side by 1/cos 30° of that.
        let along = 0.3 / 30.0_f64.to_radians().cos();
        assert!(spot.is_near && (spot.point - point - DVec3::new(along, 0.0, 0.0)).length() < 1e-12);
        // Turned by 11° it is flat enough to lie in the middle.
        let spot = pad().spot(&turned(11.0_f64.to_radians(), point, DVec3::ZERO));
        assert!(spot.is_near && (spot.point - point).length() < 1e-12);
    }

    #[test]
    fn a_body_that_turns_over_an_edge_stands_on_it_from_side_to_side() {
        let edge = DVec3::new(2.0, 0.0, -1.0);
        for degrees in 27..=63 {
            let spot = pad().spot(&turned(f64::from(degrees).to_radians(), edge, DVec3::new(0.1, 0.0, 0.0)));
            assert!(spot.is_near && (spot.point - edge).length() < 1e-12, "{degrees}°: {spot:?}");
        }
        // On its end, 0.4 m from the edge over the middle.
        let point = DVec3::new(2.0, 0.0, -0.6);
        let spot = pad().spot(&turned(std::f64::consts::FRAC_PI_2, point, DVec3::ZERO));
        assert!(spot.is_near && spot.feature == 2 && (spot.point - point).length() < 1e-12);
    }

    /// The underside at 45° as its edge slides over the rim, however the top is turned: the place follows the edge to the
    /// last of it over the top, then stays where that was.
    #[test]
    fn nothing_jumps_as_an_edge_leaves_a_top_that_is_turned() {
        let edge = DVec3::new(2.0, 0.0, -1.0);
        for degrees in [0.0_f64, 5.0, 11.0, 20.0, 30.0, 45.0] {
            let along = DVec3::new(degrees.to_radians().cos(), degrees.to_radians().sin(), 0.0);
            let pad = Pad { top: top(DVec3::ZERO, DVec3::Z, along).unwrap(), ..pad() };
            let place = |x: f64| {
                let pose = turned(std::f64::consts::FRAC_PI_4, edge, DVec3::new(x, 0.0, 0.0));
                let spot = pad.spot(&pose);
                assert!(spot.is_near, "{degrees}°, {x} m");
                pose.point(spot.point)
            };
            let mut before = place(-0.2);
            for step in 1..8000 {
                let after = place(-0.2 + 1e-4 * f64::from(step));
                if after.z > 0.3 {
                    break;
                }
                // Along the edge the place goes by cot of the angle as fast as the edge over a rim.
                assert!((after.z - before.z).abs() < 2e-4, "{degrees}°: {before} to {after}");
                assert!((after - before).length() < 3e-3, "{degrees}°: {before} to {after}");
                before = after;
            }
        }
    }

    #[test]
    fn a_side_that_stands_upright_lies_on_nothing() {
        // The end is 0.1 m from the middle of a top that reaches up to half of its height.
        let beside = Pose { rotation: DMat3::IDENTITY, position: DVec3::new(-2.1, 0.0, 0.0) };
        assert!(!pad().spot(&beside).is_near);
    }

    /// A side with these corners, anticlockwise from outside.
    fn side(corners: &[DVec3]) -> Side {
        let normal = (corners[1] - corners[0]).cross(corners[2] - corners[1]).normalize();
        let face = Plane::new(corners[0], normal);
        Side::new(face, corners.iter().map(|corner| face.along(*corner)).collect())
    }

    /// Strips 4 m long along y between places in x, z, from left to right below a body.
    fn strips(places: &[[f64; 2]]) -> Pad {
        let strip = |pair: &[[f64; 2]]| {
            let corner = |place: usize, y: f64| DVec3::new(pair[place][0], y, pair[place][1]);
            side(&[corner(0, -2.0), corner(0, 2.0), corner(1, 2.0), corner(1, -2.0)])
        };
        Pad {
            top: top(DVec3::ZERO, DVec3::Z, DVec3::X).unwrap(),
            half: [0.3, 0.3],
            sides: places.windows(2).map(strip).collect(),
        }
    }

    #[test]
    fn a_body_stands_on_a_sharp_edge_between_steep_sides() {
        // Both sides rise by 65°: each by itself lies on nothing, their edge does as long as it is over the top.
        let wedge =
            strips(&[[-1.0, 65.0_f64.to_radians().tan()], [0.0, 0.0], [1.0, 65.0_f64.to_radians().tan()]]);
        let at =
            |x: f64| wedge.nearest(&Pose { rotation: DMat3::IDENTITY, position: DVec3::new(x, 0.0, 0.01) });
        for x in [-0.29, 0.0, 0.2] {
            let found = at(x).unwrap();
            assert!(found.point.length() < 1e-12 && (found.above - 0.01).abs() < 1e-12, "{x} m: {found:?}");
        }
        assert!(at(0.31).is_none() && at(-0.31).is_none());
    }

    #[test]
    fn a_steep_side_at_the_rim_lies_on_nothing_where_it_meets_the_next() {
        // Over the top from 0.3 m on it rises by 63°, then, from the middle on, by 72°.
        let bilge = strips(&[[-1.0, 0.0], [0.5, 0.0], [1.5, 2.0], [2.5, 5.0]]);
        assert!(
            bilge
                .nearest(&Pose { rotation: DMat3::IDENTITY, position: DVec3::new(-1.5, 0.0, 0.0) })
                .is_none()
        );
    }

    /// The underside of a cylinder of 5 m, in strips of 0.5°, as it goes over the top: f is that of the cylinder but for
    /// how far the strips are from it, and the place goes along without jumps.
    #[test]
    fn the_place_follows_a_curved_underside() {
        let radius = 5.0;
        let places: Vec<[f64; 2]> = (-140..=140)
            .map(|step| 0.5 * f64::from(step))
            .map(|degrees: f64| [radius * degrees.to_radians().sin(), -radius * degrees.to_radians().cos()])
            .collect();
        let pad = strips(&places);
        let found = |offset: f64| {
            pad.nearest(&Pose { rotation: DMat3::IDENTITY, position: DVec3::new(offset, 0.0, radius) })
                .unwrap()
        };
        let mut before = found(-4.0);
        for step in -3999..=4000 {
            let offset = 1e-3 * f64::from(step);
            let now = found(offset);
            // By a search over the rim and what is between.
            let height = |x: f64| radius - (radius * radius - (x - offset).powi(2)).sqrt();
            let f = |x: f64| height(x) + 0.2 * x.abs() + 0.5 * x * x;
            let least = (-300..=300).map(|step| f(1e-3 * f64::from(step))).fold(f64::INFINITY, f64::min);
            // Strips are inside the cylinder by R (1 − cos 0.25°) = 48 µm at most, by 1/cos of the slope upright.
            assert!((now.value - least).abs() < 2e-4, "{offset} m: {} for {least}", now.value);
            // Strips meet at 0.5°: the place goes on by that over 1/R + 0.3/h at most, and by 1 mm with the body.
            assert!((now.point - before.point).length() < 5e-3, "{offset} m: {before:?} to {now:?}");
            before = now;
        }
    }
}
