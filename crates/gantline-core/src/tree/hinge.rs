//! Rotation about an axis that is fixed in the parent and in the body.

use glam::{DMat3, DVec3};

use super::joint::{Column, JointModel};
use super::pose::Pose;

/// A hinge; its coordinate is the angle [rad].
#[derive(Debug, Clone)]
pub struct Hinge {
    /// Unit axis in the joint frame.
    pub axis: DVec3,
}

impl JointModel for Hinge {
    const POSITIONS: usize = 1;
    const VELOCITIES: usize = 1;

    fn pose(&self, joint: &Pose, q: &[f64]) -> Pose {
        let turned = DMat3::from_axis_angle(self.axis, q[0]);
        Pose { rotation: joint.rotation * turned, position: joint.position }
    }

    fn columns(&self, joint: &DMat3, _body: &DMat3, columns: &mut [Column]) {
        columns[0] = Column { angular: *joint * self.axis, linear: DVec3::ZERO };
    }

    fn advance(&self, q: &mut [f64], increment: &[f64]) {
        q[0] += increment[0];
    }
}
