//! Where a frame stands in another.

use glam::{DMat3, DQuat, DVec3};

/// Orientation and position of a frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pose {
    /// Orientation: columns are this frame's axes.
    pub rotation: DMat3,
    /// Origin [m].
    pub position: DVec3,
}

impl Pose {
    /// The world in itself.
    pub const IDENTITY: Self = Self { rotation: DMat3::IDENTITY, position: DVec3::ZERO };

    /// A frame at `position` [m] turned by the unit quaternion `orientation`.
    pub fn new(orientation: DQuat, position: DVec3) -> Self {
        Self { rotation: DMat3::from_quat(orientation), position }
    }

    /// `inner`, given in this frame, in the frame that this one is given in.
    pub fn compose(&self, inner: &Self) -> Self {
        Self { rotation: self.rotation * inner.rotation, position: self.point(inner.position) }
    }

    /// A frame at the point `local` [m] of this one, with the same axes.
    pub fn shifted(&self, local: DVec3) -> Self {
        Self { rotation: self.rotation, position: self.point(local) }
    }

    /// A point [m] of this frame.
    #[inline]
    pub fn point(&self, local: DVec3) -> DVec3 {
        self.position + self.rotation * local
    }
}
