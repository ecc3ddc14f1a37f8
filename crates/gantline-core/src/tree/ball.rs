//! Free rotation about a point. Velocity coordinates: angular velocity in body axes, in which the
//! inertia is constant.

use glam::{DMat3, DQuat, DVec3};

use super::joint::{Column, JointModel, Motion};
use super::pose::Pose;

/// A ball joint; q holds the unit quaternion of the body in the joint frame, w first.
#[derive(Debug, Clone)]
pub struct Ball;

/// Unit quaternion from four numbers, w first.
pub fn quaternion(q: &[f64]) -> DQuat {
    DQuat::from_xyzw(q[1], q[2], q[3], q[0])
}

/// Turns the quaternion in `q` by the rotation vector `increment` [rad], body axes (exponential map).
///
/// No increment leaves it as it is, to the last bit.
pub fn rotate(q: &mut [f64], increment: &[f64]) {
    if increment.iter().all(|&x| x == 0.0) {
        return;
    }
    let turned = quaternion(q) * DQuat::from_scaled_axis(DVec3::from_slice(increment));
    let unit = turned.normalize();
    q.copy_from_slice(&[unit.w, unit.x, unit.y, unit.z]);
}

impl JointModel for Ball {
    const POSITIONS: usize = 4;
    const MOTIONS: &'static [Motion] = &[Motion::Turn; 3];

    fn place(&self, pose: &mut Pose, q: &[f64], columns: &mut [Column]) {
        pose.rotation *= DMat3::from_quat(quaternion(q));
        for (k, column) in columns.iter_mut().enumerate() {
            *column = Column::turn(pose.rotation.col(k));
        }
    }

    fn advance(&self, q: &mut [f64], increment: &[f64]) {
        rotate(q, increment);
    }
}
