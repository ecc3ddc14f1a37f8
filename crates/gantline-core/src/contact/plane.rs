//! A half space of the world.

use glam::DVec3;

/// A plane with a free side.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plane {
    /// A point of it [m].
    pub point: DVec3,
    /// Unit normal towards the free side.
    pub normal: DVec3,
    /// Two unit tangents; (tangents, normal) are right-handed.
    pub tangents: [DVec3; 2],
}

impl Plane {
    /// The plane through `point` [m] with the unit vector `normal`.
    pub fn new(point: DVec3, normal: DVec3) -> Self {
        let (first, second) = normal.any_orthonormal_pair();
        Self { point, normal, tangents: [first, second] }
    }

    /// How deep a world point lies below the plane [m].
    pub fn depth(&self, point: DVec3) -> f64 {
        (self.point - point).dot(self.normal)
    }
}
