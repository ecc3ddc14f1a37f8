//! Where a frame stands in another.

use glam::{DMat3, DQuat, DVec3};

/// Orientation and position of a frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pose {
    /// Unit quaternion.
    pub orientation: DQuat,
    /// The same orientation as a matrix.
    pub rotation: DMat3,
    /// Origin [m].
    pub position: DVec3,
}

impl Pose {
    /// The world in itself.
    pub const IDENTITY: Self =
        Self { orientation: DQuat::IDENTITY, rotation: DMat3::IDENTITY, position: DVec3::ZERO };

    /// A frame at `position` [m] turned by `orientation`.
    pub fn new(orientation: DQuat, position: DVec3) -> Self {
        Self { orientation, rotation: DMat3::from_quat(orientation), position }
    }

    /// `inner`, given in this frame, in the frame that this one is given in.
    pub fn compose(&self, inner: &Self) -> Self {
        Self::new(self.orientation * inner.orientation, self.point(inner.position))
    }

    /// A point [m] of this frame.
    pub fn point(&self, local: DVec3) -> DVec3 {
        self.position + self.rotation * local
    }
}
