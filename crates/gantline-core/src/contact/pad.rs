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
//! jumps as the body turns and slides, from side to side by the edge between them too. It is always a point of the body against the plane
//! of the top, so the force is upright, however the body is tilted.

use glam::DVec3;

use super::plane::Plane;
use super::spot::Spot;
use crate::tree::pose::Pose;

/// A body so far below the top of a support is beside it and not on it, in half sides of the top.
const DEEPEST: f64 = 1.0;
/// A side that is steeper than this lies on nothing: cosine of its angle to the top.
const LEAST_SLOPE: f64 = 0.5;
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
}

impl Pad {
    /// Where the body at `pose` may lie on the top; the body is the first of the two, the world the second.
    pub fn spot(&self, pose: &Pose) -> Spot {
        let (mut found, mut least) = (Spot::none(), f64::INFINITY);
        for (number, side) in (1..).zip(&self.sides) {
            let Some((point, value)) = self.place(side, pose) else { continue };
            if value < least {
                least = value;
                let plane = self.top;
                found =
                    Spot { is_near: true, is_swapped: false, point, plane, crossing: None, feature: number };
            }
        }
        found
    }

    /// The point [m] of a side of the body at `pose` that may lie on the top, in the frame of the body, and f there [m].
    fn place(&self, side: &Side, pose: &Pose) -> Option<(DVec3, f64)> {
        let inwards = pose.rotation.transpose();
        let up = inwards * self.top.normal;
        let slope = side.face.normal.dot(up);
        if slope > -LEAST_SLOPE {
            return None;
        }
        // How high its plane is over the middle of the top, and how fast it rises along the sides of the top.
        let height = side.face.depth(inwards * (self.top.point - pose.position)) / slope;
        let rises = self.top.tangents.map(|tangent| -side.face.normal.dot(inwards * tangent) / slope);
        let ([x, y], value) = self.least(rises, side, pose)?;
        let above = height + rises[0] * x + rises[1] * y;
        let is_beside = -above > DEEPEST * self.half[0].max(self.half[1]);
        let [first, second] = self.top.tangents;
        let place = self.top.point + first * x + second * y + self.top.normal * above;
        (!is_beside).then(|| (inwards * (place - pose.position), height + value))
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
        let underside = Side {
            face: Plane {
                point: DVec3::new(0.0, 0.0, -1.0),
                normal: -DVec3::Z,
                tangents: [DVec3::X, -DVec3::Y],
            },
            outline: vec![[-2.0, -1.0], [2.0, -1.0], [2.0, 1.0], [-2.0, 1.0]],
        };
        let end = Side {
            face: Plane {
                point: DVec3::new(2.0, 0.0, 0.0),
                normal: DVec3::X,
                tangents: [DVec3::Y, DVec3::Z],
            },
            outline: vec![[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]],
        };
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
}
