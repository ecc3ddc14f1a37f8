//! A half space of the world or of a body.

use glam::DVec3;
use serde::{Deserialize, Serialize};

/// A plane with a free side.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
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

    /// How far a point of the plane's frame is from its own point along the two tangents [m].
    pub fn along(&self, point: DVec3) -> [f64; 2] {
        self.tangents.map(|tangent| tangent.dot(point - self.point))
    }

    /// How deep a point of the plane's frame lies below the plane [m].
    pub fn depth(&self, point: DVec3) -> f64 {
        (self.point - point).dot(self.normal)
    }
}
