//! The top of a support: a flat, level rectangle of the world, and the flat sides of a body that may lie on it.
//!
//! A side that lies flat over the middle of the top carries there, wherever the body has been moved; one that is steeper
//! carries the nearer to the low rim of the top, for that is what it touches first. Where the edge of the
//! side has come past that place it carries at the place of the edge that is nearest, until that has left the top: there the
//! body leaves the support. Of several sides over a top the one that is lowest carries, so that a body that turns over an
//! edge stands on the edge. Always it is a point of the body against the plane of the top, so the force is upright,
//! however the body is tilted.

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
/// How far from the middle the rim is, in half sides of the top: a little inside, so that rounding does not leave it.
const RIM: f64 = 0.95;

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
        let mut lowest = (Spot::none(), f64::NEG_INFINITY);
        for (number, side) in (1..).zip(&self.sides) {
            let Some(point) = self.place(side, pose) else { continue };
            let depth = self.top.depth(pose.point(point));
            if depth > lowest.1 {
                let plane = self.top;
                let spot =
                    Spot { is_near: true, is_swapped: false, point, plane, crossing: None, feature: number };
                lowest = (spot, depth);
            }
        }
        lowest.0
    }

    /// The point [m] of a side of the body at `pose` that may lie on the top, in the frame of the body.
    fn place(&self, side: &Side, pose: &Pose) -> Option<DVec3> {
        let inwards = pose.rotation.transpose();
        let up = inwards * self.top.normal;
        let slope = side.face.normal.dot(up);
        if slope > -LEAST_SLOPE {
            return None;
        }
        let mut target = self.top.point;
        for (tangent, half) in self.top.tangents.into_iter().zip(self.half) {
            // How fast the side rises along a side of the top.
            let rise = -side.face.normal.dot(inwards * tangent) / slope;
            target -= tangent * (rise.signum() * RIM * half * eased(rise.abs()));
        }
        // The place of the side that is upright over that of the top.
        let target = inwards * (target - pose.position);
        let above = target + up * (side.face.depth(target) / slope);
        let nearest = clamped(&side.outline, side.face.along(above));
        let [first, second] = side.face.tangents;
        let point = side.face.point + first * nearest[0] + second * nearest[1];
        let place = pose.point(point);
        let [along, across] = self.top.along(place);
        let is_off = along.abs() > self.half[0] || across.abs() > self.half[1];
        let is_beside = self.top.depth(place) > DEEPEST * self.half[0].max(self.half[1]);
        (!is_off && !is_beside).then_some(point)
    }
}

/// From 0 to 1 between the two [`RISES`], with no kink at either.
fn eased(rise: f64) -> f64 {
    let share = ((rise - RISES[0]) / (RISES[1] - RISES[0])).clamp(0.0, 1.0);
    share * share * (3.0 - 2.0 * share)
}

/// A point itself where it lies in a convex outline, else the point of the outline's edge that is nearest to it.
fn clamped(outline: &[[f64; 2]], [x, y]: [f64; 2]) -> [f64; 2] {
    let (mut best, mut least) = ([x, y], f64::INFINITY);
    let (mut left, mut right) = (false, false);
    for (index, &[fx, fy]) in outline.iter().enumerate() {
        let [tx, ty] = outline[(index + 1) % outline.len()];
        let (dx, dy) = (tx - fx, ty - fy);
        let side = dx * (y - fy) - dy * (x - fx);
        left |= side > 0.0;
        right |= side < 0.0;
        let share = (((x - fx) * dx + (y - fy) * dy) / (dx * dx + dy * dy)).clamp(0.0, 1.0);
        let place = [fx + share * dx, fy + share * dy];
        let distance = (place[0] - x).hypot(place[1] - y);
        if distance < least {
            (best, least) = (place, distance);
        }
    }
    if left && right { best } else { [x, y] }
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
        // The rim is 0.285 m from the middle, along the side by 1/cos 30° of that.
        let along = 0.285 / 30.0_f64.to_radians().cos();
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

    #[test]
    fn a_side_that_stands_upright_lies_on_nothing() {
        // The end is 0.1 m from the middle of a top that reaches up to half of its height.
        let beside = Pose { rotation: DMat3::IDENTITY, position: DVec3::new(-2.1, 0.0, 0.0) };
        assert!(!pad().spot(&beside).is_near);
    }
}
