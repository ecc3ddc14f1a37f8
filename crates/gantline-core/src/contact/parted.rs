//! Convex parts that touch to rounding. Of those parry may miss the face they touch with and find another: one part
//! metres deep in the other, or none at all. They are found anew a hair apart, where it has no such doubts.

use parry3d_f64::math::{Pose as ParryPose, Vector};
use parry3d_f64::query::ClosestPoints;
use parry3d_f64::query::details::closest_points_support_map_support_map;
use parry3d_f64::shape::{SharedShape, SupportMap};

/// How far each part shrinks, at most [m].
const SHRINKS: f64 = 2.5e-4;
/// How far apart they are set [m].
const HAIR: f64 = 1e-5;

/// A convex part, a little smaller.
struct Shrunk<'a> {
    map: &'a dyn SupportMap,
    /// A place in it.
    middle: Vector,
    share: f64,
}

impl<'a> Shrunk<'a> {
    fn new(part: &'a SharedShape) -> Option<Self> {
        let map = part.as_support_map()?;
        // No point of it is farther than the diagonal from any other.
        let share = 1.0 - SHRINKS / (2.0 * part.compute_local_aabb().half_extents().length());
        let middle = part.as_convex_polyhedron().map_or(Vector::ZERO, |hull| {
            hull.points().iter().copied().sum::<Vector>() / hull.points().len() as f64
        });
        (share > 0.0).then_some(Self { map, middle, share })
    }
}

impl SupportMap for Shrunk<'_> {
    fn local_support_point(&self, direction: Vector) -> Vector {
        self.middle + (self.map.local_support_point(direction) - self.middle) * self.share
    }
}

/// How the second of two convex parts has to be shifted, in the frame of the first [m], for them to be just apart.
///
/// `None` where both, each a little smaller, still overlap: the parts themselves may then overlap by any depth. If they do
/// not, the parts overlap by no more than both shrink, half a millimetre. `None` too of what is not convex.
pub fn parted(between: &ParryPose, one: &SharedShape, other: &SharedShape) -> Option<Vector> {
    let (own, its) = (Shrunk::new(one)?, Shrunk::new(other)?);
    let found = closest_points_support_map_support_map(between, &own, &its, f64::MAX);
    let ClosestPoints::WithinMargin(first, second) = found else { return None };
    let normal = (between.transform_point(second) - first).try_normalize()?;
    let farthest = own.map.local_support_point(normal);
    let nearest = its.map.support_point(between, -normal);
    let overlap = (farthest - nearest).dot(normal);
    (overlap > -HAIR).then(|| normal * (overlap + HAIR))
}
