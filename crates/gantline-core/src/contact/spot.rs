//! Where two bodies may touch: a point of one against a plane of the other.
//!
//! Within a step a spot stays as it is in the frames of its two bodies; between steps it is found anew from their
//! shapes ([`crate::stepper::spots`]).

use glam::DVec3;
use serde::{Deserialize, Serialize};

use super::plane::Plane;

/// A place at which two bodies may touch. Either of them may be the world.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Spot {
    /// False where nothing of the other body is near: there is no force.
    pub is_near: bool,
    /// True where the point belongs to the second body and the plane to the first.
    pub is_swapped: bool,
    /// The point [m], in the frame of its body.
    pub point: DVec3,
    /// The plane, in the frame of the other body; its free side is that of the point.
    pub plane: Plane,
    /// Which features of the two shapes meet: the same number later is the same place.
    pub feature: u64,
}

impl Spot {
    /// Nothing near.
    pub fn none() -> Self {
        let plane = Plane::new(DVec3::ZERO, DVec3::Z);
        Self { is_near: false, is_swapped: false, point: DVec3::ZERO, plane, feature: 0 }
    }
}
