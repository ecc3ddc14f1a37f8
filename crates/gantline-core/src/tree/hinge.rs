//! Rotation about an axis that is fixed in the parent and in the body.

use glam::{DMat3, DVec3};

use super::joint::{Column, JointModel, Motion};
use super::pose::Pose;

/// A hinge; its coordinate is the angle [rad].
#[derive(Debug, Clone)]
pub struct Hinge {
    /// Unit axis in the joint frame.
    pub axis: DVec3,
}

impl JointModel for Hinge {
    const POSITIONS: usize = 1;
    const MOTIONS: &'static [Motion] = &[Motion::Turn];

    fn place(&self, pose: &mut Pose, q: &[f64], columns: &mut [Column]) {
        columns[0] = Column::turn(pose.rotation * self.axis);
        pose.rotation *= DMat3::from_axis_angle(self.axis, q[0]);
    }

    fn advance(&self, q: &mut [f64], increment: &[f64]) {
        q[0] += increment[0];
    }
}
