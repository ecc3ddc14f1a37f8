//! The top of a support: a flat, level rectangle of the world, and the flat underside of a body that may lie on it.
//!
//! A top that lies under the body all but for its edges carries in its middle, wherever the body has been moved. Where
//! the edge of the underside has come past the middle it carries at the place of the edge that is nearest to the middle,
//! until that place has left the top: there the body leaves the support. Either is a point of the body against the plane
//! of the top, so the force is upright, however the body is tilted.

use glam::DVec3;

use super::plane::Plane;
use super::spot::Spot;
use crate::tree::pose::Pose;

/// A body so far below the top of a support is beside it and not on it, in half sides of the top.
const DEEPEST: f64 = 1.0;
/// An underside that is steeper than this lies on nothing: cosine of its angle to the top.
const LEAST_SLOPE: f64 = 0.5;

/// A support's top and the underside of a body.
#[derive(Debug, Clone, PartialEq)]
pub struct Pad {
    /// The top, world axes: its middle, up, and the directions of its sides.
    pub top: Plane,
    /// Half of its two sides [m].
    pub half: [f64; 2],
    /// The underside, body frame; its normal leads out of the body.
    pub face: Plane,
    /// Corners of the underside along the tangents of `face` [m]: convex, in order.
    pub outline: Vec<[f64; 2]>,
}

impl Pad {
    /// Where the body at `pose` may lie on the top; the body is the first of the two, the world the second.
    pub fn spot(&self, pose: &Pose) -> Spot {
        let inwards = pose.rotation.transpose();
        let (middle, up) = (inwards * (self.top.point - pose.position), inwards * self.top.normal);
        // The place of the underside that is upright over the middle of the top.
        let slope = self.face.normal.dot(up);
        if slope > -LEAST_SLOPE {
            return Spot::none();
        }
        let above = middle + up * (self.face.depth(middle) / slope);
        let nearest = clamped(&self.outline, self.face.along(above));
        let [first, second] = self.face.tangents;
        let point = self.face.point + first * nearest[0] + second * nearest[1];
        let place = pose.point(point);
        let [along, across] = self.top.along(place);
        let is_off = along.abs() > self.half[0] || across.abs() > self.half[1];
        if is_off || self.top.depth(place) > DEEPEST * self.half[0].max(self.half[1]) {
            return Spot::none();
        }
        Spot { is_near: true, is_swapped: false, point, plane: self.top, crossing: None, feature: 1 }
    }
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

    /// A box 4 × 2 m with its underside 1 m below its origin over a top of 0.6 × 0.6 m at the origin.
    fn pad() -> Pad {
        Pad {
            top: top(DVec3::ZERO, DVec3::Z, DVec3::X).unwrap(),
            half: [0.3, 0.3],
            face: Plane {
                point: DVec3::new(0.0, 0.0, -1.0),
                normal: -DVec3::Z,
                tangents: [DVec3::X, -DVec3::Y],
            },
            outline: vec![[-2.0, -1.0], [2.0, -1.0], [2.0, 1.0], [-2.0, 1.0]],
        }
    }

    fn at(x: f64, y: f64) -> Spot {
        pad().spot(&Pose { rotation: DMat3::IDENTITY, position: DVec3::new(x, y, 0.9) })
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
}
