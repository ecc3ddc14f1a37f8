//! The point that parry adds to those where corners and edges of two convex parts meet: the nearest one that it found first,
//! which is anywhere along what lies on one another. Where corners and edges around it press as much, it would bear a
//! share of its own at a place of no meaning, and another in the next step.

use parry3d_f64::math::Vector;
use parry3d_f64::query::{ContactManifold, TrackedContact};
use parry3d_f64::shape::PackedFeatureId;

use super::shape::SAME;

/// How much deeper than all others it may be [m]: what parry takes for the same.
pub const ROUNDING: f64 = 1e-5;

/// True of such a point that is no deeper than the deepest corner or edge, and on a line or in a triangle between some of
/// them. One beyond them stays: of a face that keeps [some of its corners](super::polygon) it may lie outside.
pub fn is_spare(manifold: &ContactManifold<(), ()>, point: &TrackedContact<()>) -> bool {
    if !is_added(point) {
        return false;
    }
    let normal = manifold.local_n1;
    let others = || manifold.points.iter().filter(|other| !is_added(other));
    if others().all(|other| other.dist > point.dist + ROUNDING) {
        return false;
    }
    let ways = || {
        others().map(|other| {
            let way = other.local_p1 - point.local_p1;
            way - normal * way.dot(normal)
        })
    };
    ways().enumerate().any(|(index, one)| {
        ways().take(index + 1).enumerate().any(|(last, other)| {
            is_between(one, other) || ways().take(last).any(|third| is_around([one, other, third], normal))
        })
    })
}

/// True of the point that parry adds.
pub fn is_added(point: &TrackedContact<()>) -> bool {
    point.fid1 == PackedFeatureId::UNKNOWN
}

/// True where the line between two places passes the origin as near as places that are one.
fn is_between(one: Vector, other: Vector) -> bool {
    let along = other - one;
    let share = (-one.dot(along) / along.length_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
    (one + along * share).length() <= SAME
}

/// True where a triangle across a normal has the origin in it.
fn is_around([one, other, third]: [Vector; 3], normal: Vector) -> bool {
    let sides = [one.cross(other), other.cross(third), third.cross(one)].map(|side| side.dot(normal));
    sides.iter().all(|side| *side > 0.0) || sides.iter().all(|side| *side < 0.0)
}
