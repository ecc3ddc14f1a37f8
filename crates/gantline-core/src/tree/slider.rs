//! Translation along an axis that is fixed in the parent.

use glam::{DMat3, DVec3};

use super::joint::{Column, JointModel};
use super::pose::Pose;

/// A slider; its coordinate is the distance along the axis [m].
#[derive(Debug, Clone)]
pub struct Slider {
    /// Unit axis in the joint frame.
    pub axis: DVec3,
}

impl JointModel for Slider {
    const POSITIONS: usize = 1;
    const VELOCITIES: usize = 1;

    fn pose(&self, joint: &Pose, q: &[f64]) -> Pose {
        joint.shifted(self.axis * q[0])
    }

    fn columns(&self, joint: &DMat3, _body: &DMat3, columns: &mut [Column]) {
        columns[0] = Column { angular: DVec3::ZERO, linear: *joint * self.axis };
    }

    fn advance(&self, q: &mut [f64], increment: &[f64]) {
        q[0] += increment[0];
    }
}
